// Pairs of the plane whose deciding determinant is as small as the lattice allows.
//
// An edge e = (p, q) of A with p and q coprime, and a vertex v of B with e x v = k: v is the solution of p y - q x = k
// whose projection lies inside the edge. Its gap from the edge is k / |e|. For k = 1, 0, -1 the pair is apart by almost
// nothing, touches, overlaps by almost nothing. For a pair with radii k is next to radius |e|.
#include "smallest2.h"

#include <math.h>

#include "shape2.h"

__extension__ typedef __int128 wide;

// p y - q x = 1. Pre: p and q are coprime, not both 0.
static void solve(int64_t p, int64_t q, int64_t *x, int64_t *y) {
  // r = s p + t q in every row
  int64_t r0 = p, s0 = 1, t0 = 0, r1 = q, s1 = 0, t1 = 1;
  while (r1 != 0) {
    const int64_t n = r0 / r1, r = r0 - n * r1, s = s0 - n * s1, t = t0 - n * t1;
    r0 = r1;
    s0 = s1;
    t0 = t1;
    r1 = r;
    s1 = s;
    t1 = t;
  }
  *y = r0 * s0;  // r0 is 1 or -1
  *x = -r0 * t0;
}

static int64_t divisor(int64_t a, int64_t b) {
  while (b != 0) {
    const int64_t r = a % b;
    a = b;
    b = r;
  }
  return a < 0 ? -a : a;
}

// An edge of about so many bits, its components coprime.
static gjk2_vec choose_edge(random_state *random, unsigned bits) {
  gjk2_vec e;
  do {
    e = generate2_vector(random, ldexp(0.55 + 0.4 * generate2_unit(random), (int)bits));
  } while (divisor(e.x, e.y) != 1);
  return e;
}

// The vertex v with e x v = k whose projection lies in the middle half of the edge, if there is one.
static bool choose_vertex(gjk2_vec e, int64_t k, gjk2_vec *out) {
  int64_t x, y;
  solve(e.x, e.y, &x, &y);
  const wide square = (wide)e.x * e.x + (wide)e.y * e.y;
  const wide along = ((wide)x * e.x + (wide)y * e.y) * k;  // of k times the solution; |x|, |y| <= |e|
  const wide turns = (along - square / 2) / square;
  const wide vx = (wide)x * k - turns * e.x, vy = (wide)y * k - turns * e.y;
  const wide rest = vx * e.x + vy * e.y;
  out->x = (gjk_q16)vx;
  out->y = (gjk_q16)vy;
  return 8 * rest > square && 8 * rest < 7 * square && vx == out->x && vy == out->y;
}

static void append(case2_shape *shape, double x, double y) {
  case2_shape_set_count(shape, shape->count + 1);
  shape->vertices[shape->count - 1].x = (gjk_q16)lrint(x);
  shape->vertices[shape->count - 1].y = (gjk_q16)lrint(y);
}

// Adds points behind the contact on the side away from the other shape: side -1 below the edge, 1 above.
static void thicken(random_state *random, gjk2_vec e, double x, double y, int side, case2_shape *shape) {
  const double length = hypot(e.x, e.y), u = e.x / length, v = e.y / length;
  const unsigned points = 1 + random_below(random, 4);
  for (unsigned i = 0; i < points; i++) {
    const double depth = (8 + 0.4 * length * generate2_unit(random)) * side;
    const double along = 0.35 * fabs(depth) * (2 * generate2_unit(random) - 1);
    append(shape, x + along * u - depth * v, y + along * v + depth * u);
  }
}

// Turns a polygon around or mixes its points; both shapes stand at one place.
static void finish(random_state *random, case2_pair *pair) {
  const gjk2_vec at = generate2_vector(random, (double)generate2_reach(random));
  pair->a.pose.position = pair->b.pose.position = at;
  for (int side = 0; side < 2; side++) {
    case2_shape *shape = side == 0 ? &pair->a : &pair->b;
    if (random_below(random, 2) == 0) {
      generate2_order(shape);
    } else {
      generate2_disorder(random, shape);
    }
  }
  if (random_below(random, 2) == 0) {
    const case2_shape kept = pair->a;
    pair->a = pair->b;
    pair->b = kept;
  }
}

// Chooses an edge of about so many bits, and a vertex at the gap radius or next to it.
static void choose(random_state *random, unsigned bits, int64_t radius, gjk2_vec *e, gjk2_vec *v) {
  const int32_t multiple = radius == 0 && random_below(random, 3) == 0 ? random_range(random, 2, 7) : 1;
  bool found;
  do {
    *e = choose_edge(random, multiple == 1 ? bits : bits - 3);
    const int64_t level = (int64_t)floor(hypot(e->x, e->y) * (double)radius);
    const int64_t k = radius > 0 ? level + random_range(random, 0, 1) : 2 * random_range(random, 0, 1) - 1;
    found = multiple > 1 || choose_vertex(*e, k, v);
    if (multiple > 1) {  // a point of the edge itself
      const int32_t part = random_range(random, 1, multiple - 1);
      v->x = part * e->x;
      v->y = part * e->y;
      e->x *= multiple;
      e->y *= multiple;
    }
  } while (!found);
}

// across: B has an edge parallel to e.
static void make(random_state *random, unsigned bits, int64_t radius, bool across, case2_pair *pair) {
  gjk2_vec e, v;
  choose(random, bits, radius, &e, &v);
  case2_shape_reset(&pair->a);
  case2_shape_reset(&pair->b);
  pair->a.kind = pair->b.kind = CASE2_POLYGON;
  append(&pair->a, 0, 0);
  append(&pair->a, e.x, e.y);
  append(&pair->b, v.x, v.y);
  if (across) {
    append(&pair->b, (double)v.x + e.x, (double)v.y + e.y);
  }
  if (random_below(random, 8) != 0) {
    thicken(random, e, 0.5 * e.x, 0.5 * e.y, -1, &pair->a);
    thicken(random, e, v.x, v.y, 1, &pair->b);
  }
  finish(random, pair);
}

void generate2_smallest(random_state *random, case2_pair *pair) {
  generate2_smallest_bits(random, 14 + random_below(random, 14), pair);
}

void generate2_smallest_bits(random_state *random, unsigned bits, case2_pair *pair) {
  make(random, bits, 0, false, pair);
}

void generate2_smallest_edges(random_state *random, case2_pair *pair) {
  make(random, 14 + random_below(random, 13), 0, true, pair);
}

void generate2_smallest_rounded(random_state *random, case2_pair *pair) {
  const int64_t radius = 1 + random_below(random, 1u << random_below(random, 12));
  make(random, 14 + random_below(random, 13), radius, false, pair);
  pair->a.convex_radius = random_range(random, 0, (int32_t)radius);
  pair->b.convex_radius = (int32_t)radius - pair->a.convex_radius;
}
