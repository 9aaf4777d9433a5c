// Families of random casts.
//
// A cast is aimed at a point of A - B: B passes through the displacement that makes the shapes share such a point there.
#include "cast.h"

#include <math.h>
#include <string.h>

#include "contact.h"
#include "exact/cast.h"
#include "place.h"
#include "polytope.h"

// A pair while it is aimed: B stands at the origin.
typedef struct aim {
  random_state *random;
  case_pair *pair;
  case_collider a, b;
  unsigned count_a, count_b;
} aim;

static gjk_q16 clamp(int64_t x) {
  return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (gjk_q16)x;
}

static gjk_vec3 to_vec3(const exact_point *p) {
  const gjk_vec3 v = {clamp(p->x[0]), clamp(p->x[1]), clamp(p->x[2])};
  return v;
}

static exact_point to_point(gjk_vec3 v) {
  const exact_point p = {{v.x, v.y, v.z}};
  return p;
}

static exact_point add(const exact_point *p, int64_t factor, const exact_point *q) {
  const exact_point sum = {{p->x[0] + factor * q->x[0], p->x[1] + factor * q->x[1], p->x[2] + factor * q->x[2]}};
  return sum;
}

// Shapes.

static void make_hull(random_state *random, gjk_q16 reach, unsigned count, case_shape *shape) {
  shape->kind = CASE_HULL;
  case_shape_set_count(shape, count);
  for (unsigned i = 0; i < count; i++) {
    gjk_vec3 *v = &shape->vertices[i];
    v->x = random_range(random, -reach, reach);
    v->y = random_range(random, -reach, reach);
    v->z = random_range(random, -reach, reach);
  }
}

static void make_box(random_state *random, gjk_q16 reach, case_shape *shape) {
  shape->kind = CASE_BOX;
  shape->size.x = random_range(random, 1, reach);
  shape->size.y = random_range(random, 1, reach);
  shape->size.z = random_range(random, 1, reach);
}

static void make_shape(random_state *random, gjk_q16 reach, case_shape *shape) {
  switch (random_below(random, 8)) {
    case 0:
    case 1:
    case 2: make_box(random, reach, shape); break;
    case 3: make_hull(random, reach, 1 + random_below(random, 3), shape); break;
    default: make_hull(random, reach, 4 + random_below(random, 5), shape); break;
  }
}

static gjk_q16 any_reach(random_state *random) {
  return (gjk_q16)(4 << random_below(random, 21)) + random_range(random, 0, 3);
}

static void turn(random_state *random, case_pair *pair) {
  pair->a.pose.rotation = generate_rotation(random);
  pair->b.pose.rotation = generate_rotation(random);
}

// Two shapes of about a reach, of which one may be much smaller.
static void make_pair(random_state *random, gjk_q16 reach, case_pair *pair) {
  const gjk_q16 other = random_below(random, 4) == 0 ? 1 + reach / 16 : reach;
  make_shape(random, random_below(random, 2) == 0 ? reach : other, &pair->a);
  make_shape(random, other, &pair->b);
  if (random_below(random, 2) == 0) {
    turn(random, pair);
  }
}

// Aiming.

static void open(aim *t, random_state *random, case_pair *pair) {
  memset(t, 0, sizeof *t);
  t->random = random;
  t->pair = pair;
  case_collider_build(&t->a, &pair->a, false);
  case_collider_build(&t->b, &pair->b, false);
  t->count_a = exact_vertex_count(&t->a.collider);
  t->count_b = exact_vertex_count(&t->b.collider);
}

static void close(aim *t) {
  case_collider_free(&t->a);
  case_collider_free(&t->b);
}

// Puts B at 'from' and lets it move to 'to'; both are displacements.
static void set_way(aim *t, const exact_point *from, const exact_point *to) {
  const exact_point at = to_point(t->pair->b.pose.position), start = add(&at, 1, from), end = add(&at, 1, to);
  const gjk_vec3 last = to_vec3(&end);
  t->pair->b.pose.position = to_vec3(&start);
  case_shape_move_to(&t->pair->b, &last);
}

// Any vertex of A - B.
static exact_point any_vertex(const aim *t) {
  const exact_point p = exact_vertex(&t->a.collider, random_below(t->random, t->count_a));
  const exact_point q = exact_vertex(&t->b.collider, random_below(t->random, t->count_b));
  return exact_subtract(&p, &q);
}

static double dot(const double n[3], const exact_point *p) {
  return n[0] * (double)p->x[0] + n[1] * (double)p->x[1] + n[2] * (double)p->x[2];
}

// The vertex of A - B farthest along a direction, up to rounding.
static exact_point farthest(const aim *t, const double n[3]) {
  exact_point p = exact_vertex(&t->a.collider, 0), q = exact_vertex(&t->b.collider, 0);
  for (unsigned i = 1; i < t->count_a; i++) {
    const exact_point v = exact_vertex(&t->a.collider, i);
    p = dot(n, &v) > dot(n, &p) ? v : p;
  }
  for (unsigned i = 1; i < t->count_b; i++) {
    const exact_point v = exact_vertex(&t->b.collider, i);
    q = dot(n, &v) < dot(n, &q) ? v : q;
  }
  return exact_subtract(&p, &q);
}

static double symmetric(random_state *random) {
  return 2 * generate_unit(random) - 1;
}

// A vertex of the hull of A - B.
static exact_point outer_vertex(const aim *t) {
  const double n[3] = {symmetric(t->random), symmetric(t->random), symmetric(t->random)};
  return farthest(t, n);
}

static exact_point edge_of(const aim *t, const gjk_collider *c, unsigned count) {
  exact_point e = {{0, 0, 0}};
  for (int i = 0; i < 8 && (e.x[0] | e.x[1] | e.x[2]) == 0; i++) {
    const exact_point p = exact_vertex(c, random_below(t->random, count));
    const exact_point q = exact_vertex(c, random_below(t->random, count));
    e = exact_subtract(&p, &q);
  }
  return e;
}

static double reach_of(const aim *t) {
  return (double)t->a.collider.radius + t->b.collider.radius + 1;
}

// A direction of up to three times the shapes' size.
static exact_point any_direction(const aim *t) {
  const double length = reach_of(t) * 3 * generate_unit(t->random) + 1.5;
  return to_point(generate_vector(t->random, length));
}

// A point between two vertices of A - B; one in four is twice as far out.
static exact_point between(const aim *t) {
  const exact_point p = any_vertex(t), q = any_vertex(t), sum = add(&p, 1, &q);
  const int64_t part = random_below(t->random, 4) == 0 ? 1 : 2;
  const exact_point target = {{sum.x[0] / part, sum.x[1] / part, sum.x[2] / part}};
  return target;
}

// From -1 to 1 along one axis.
static exact_point one_lsb(random_state *random) {
  exact_point p = {{0, 0, 0}};
  p.x[random_below(random, 3)] = random_range(random, -1, 1);
  return p;
}

// B passes a displacement: so many directions before it the way begins, and so many after it ends.
static void pass(aim *t, const exact_point *target, const exact_point *direction, int before, int after) {
  const exact_point from = add(target, -before, direction), to = add(target, after, direction);
  set_way(t, &from, &to);
}

static int steps(const aim *t) {
  return 1 + (int)random_below(t->random, 3);
}

// Families.

// Through a point between any two vertices of A - B, or past them.
static void ordinary(random_state *random, case_pair *pair) {
  aim t;
  open(&t, random, pair);
  const exact_point middle = between(&t), off = any_direction(&t);
  const exact_point target = add(&middle, random_below(random, 4) == 0, &off), direction = any_direction(&t);
  pass(&t, &target, &direction, steps(&t), steps(&t));
  close(&t);
}

static void ordinary_boxes(random_state *random, case_pair *pair) {
  const gjk_q16 reach = any_reach(random);
  make_box(random, reach, &pair->a);
  make_box(random, reach, &pair->b);
  turn(random, pair);
  ordinary(random, pair);
}

static void ordinary_hulls(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  ordinary(random, pair);
}

// The way lies in the plane of two edges, which passes through a vertex of A - B farthest along its normal; or 1 LSB
// beside it. of_a, of_b: which shape's edges.
static void graze(random_state *random, case_pair *pair, bool of_a, bool of_b) {
  aim t;
  open(&t, random, pair);
  const exact_point e = of_a ? edge_of(&t, &t.a.collider, t.count_a) : edge_of(&t, &t.b.collider, t.count_b);
  const exact_point f = of_b ? edge_of(&t, &t.b.collider, t.count_b) : edge_of(&t, &t.a.collider, t.count_a);
  const exact_vector n = exact_cross(&e, &f);
  const double sign = random_below(random, 2) == 0 ? 1 : -1;
  const double normal[3] = {sign * exact_to_double(&n.x[0]), sign * exact_to_double(&n.x[1]),
                            sign * exact_to_double(&n.x[2])};
  const exact_point vertex = farthest(&t, normal), off = one_lsb(random), zero = {{0, 0, 0}};
  const exact_point target = add(&vertex, 1, &off);
  const exact_point half = add(&zero, random_range(random, -2, 2), &e);
  const exact_point direction = add(&half, random_range(random, 0, 2), &f);
  pass(&t, &target, &direction, steps(&t), steps(&t));
  close(&t);
}

static void graze_face(random_state *random, case_pair *pair) {
  const gjk_q16 reach = any_reach(random);
  make_box(random, reach, &pair->a);
  make_box(random, reach, &pair->b);
  graze(random, pair, true, random_below(random, 2) == 0);
}

static void graze_slope(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  const exact_point vertex = outer_vertex(&t), off = one_lsb(random), target = add(&vertex, 1, &off);
  exact_point direction = any_direction(&t);
  direction.x[random_below(random, 3)] = random_range(random, -1, 1);
  pass(&t, &target, &direction, steps(&t), steps(&t));
  close(&t);
}

static void graze_hull(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  graze(random, pair, random_below(random, 2) == 0, random_below(random, 2) == 0);
}

static void edge_edge(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  graze(random, pair, true, true);
}

// B comes straight at A and stops at contact, 1 LSB before it, 1 LSB later, or much later.
static void come_at(random_state *random, case_pair *pair) {
  static const int64_t axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  aim t;
  open(&t, random, pair);
  exact_point axis;
  memcpy(axis.x, axes[random_below(random, 3)], sizeof axis.x);
  const double n[3] = {(double)axis.x[0], (double)axis.x[1], (double)axis.x[2]};
  const exact_point face = farthest(&t, n);
  const int64_t far = random_range(random, 0, 1 << random_below(random, 24));
  const int64_t beyond = random_below(random, 4) == 0 ? far : random_range(random, -1, 1);
  exact_point side = any_direction(&t);
  side.x[0] = axis.x[0] != 0 ? 0 : side.x[0] / 8;
  side.x[1] = axis.x[1] != 0 ? 0 : side.x[1] / 8;
  side.x[2] = axis.x[2] != 0 ? 0 : side.x[2] / 8;
  exact_point middle = add(&face, 0, &face);
  for (int i = 0; i < 3; i++) {
    middle.x[i] = axis.x[i] != 0 ? face.x[i] : side.x[i];
  }
  const exact_point from = add(&middle, far, &axis), to = add(&middle, -beyond, &axis);
  set_way(&t, &from, &to);
  close(&t);
}

static void parallel_faces(random_state *random, case_pair *pair) {
  const gjk_q16 reach = any_reach(random);
  make_box(random, reach, &pair->a);
  make_box(random, reach, &pair->b);
  come_at(random, pair);
}

// A hull and its mirror image: each face of one is parallel to one of the other, and A - B is twice A.
static void parallel_hulls(random_state *random, case_pair *pair) {
  make_hull(random, any_reach(random), 4 + random_below(random, 5), &pair->a);
  case_shape_copy(&pair->b, &pair->a);
  for (size_t i = 0; i < pair->b.count; i++) {
    gjk_vec3 *v = &pair->b.vertices[i];
    v->x = -v->x;
    v->y = -v->y;
    v->z = -v->z;
  }
  if (random_below(random, 3) == 0) {
    graze(random, pair, true, true);
    return;
  }
  aim t;
  open(&t, random, pair);
  const exact_point p = outer_vertex(&t), q = outer_vertex(&t), sum = add(&p, 1, &q);
  const exact_point target = {{sum.x[0] / 2, sum.x[1] / 2, sum.x[2] / 2}}, off = one_lsb(random);
  const exact_point beside = add(&target, 1, &off), direction = any_direction(&t);
  pass(&t, &beside, &direction, steps(&t), (int)random_below(random, 3));
  close(&t);
}

// B passes exactly the vertex of A - B where a vertex meets a vertex, into A - B or past it.
static void vertex_vertex(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  const exact_point vertex = outer_vertex(&t), inner = any_vertex(&t), direction = exact_subtract(&inner, &vertex);
  const exact_point off = one_lsb(random), target = add(&vertex, random_below(random, 3) == 0, &off);
  pass(&t, &target, &direction, steps(&t), (int)random_below(random, 3));
  close(&t);
}

static void vertex_sideways(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  const exact_point vertex = outer_vertex(&t), direction = any_direction(&t), off = one_lsb(random);
  const exact_point target = add(&vertex, random_below(random, 3) == 0, &off);
  pass(&t, &target, &direction, steps(&t), steps(&t));
  close(&t);
}

static void tiny(random_state *random, case_pair *pair) {
  make_pair(random, (gjk_q16)(1 + random_below(random, 3)), pair);
  ordinary(random, pair);
}

static void huge(random_state *random, case_pair *pair) {
  make_pair(random, 100000000 + random_range(random, 0, 50000000), pair);
  ordinary(random, pair);
}

static void thin_wall(random_state *random, case_pair *pair) {
  const gjk_q16 reach = any_reach(random) + 100;
  pair->a.kind = CASE_BOX;
  pair->a.size.x = random_range(random, 0, 1);
  pair->a.size.y = reach;
  pair->a.size.z = random_range(random, 1, reach);
  make_shape(random, 1 + reach / 64, &pair->b);
  if (random_below(random, 2) == 0) {
    turn(random, pair);
  }
  ordinary(random, pair);
}

static void bullet(random_state *random, case_pair *pair) {
  const gjk_q16 reach = any_reach(random);
  make_shape(random, reach, &pair->a);
  pair->b.kind = CASE_POINT;
  if (random_below(random, 2) == 0) {
    make_hull(random, 2, 4, &pair->b);
  }
  turn(random, pair);
  aim t;
  open(&t, random, pair);
  const exact_point target = between(&t), direction = any_direction(&t);
  pass(&t, &target, &direction, 1 + (int)random_below(random, 20), 1 + (int)random_below(random, 20));
  close(&t);
}

// The way begins where a vertex of A - B, or a point between two, is met; or 1 LSB beside it.
static void start_touch(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  const exact_point p = outer_vertex(&t), q = random_below(random, 2) == 0 ? p : outer_vertex(&t), sum = add(&p, 1, &q);
  const exact_point target = {{sum.x[0] / 2, sum.x[1] / 2, sum.x[2] / 2}}, off = one_lsb(random);
  const exact_point beside = add(&target, random_below(random, 2), &off), direction = any_direction(&t);
  pass(&t, &beside, &direction, 0, steps(&t));
  close(&t);
}

static void start_touch_box(random_state *random, case_pair *pair) {
  parallel_faces(random, pair);
  const gjk_vec3 start = pair->b.pose.position;
  pair->b.pose.position = pair->b.end.position;
  pair->b.end.position = start;  // it leaves
}

static void start_overlap(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  exact_point sum = {{0, 0, 0}};
  for (int i = 0; i < 4; i++) {
    const exact_point v = any_vertex(&t);
    sum = add(&sum, 1, &v);
  }
  const exact_point target = {{sum.x[0] / 4, sum.x[1] / 4, sum.x[2] / 4}}, direction = any_direction(&t);
  pass(&t, &target, &direction, 0, steps(&t));
  close(&t);
}

// Points, segments, triangles and what is flat or repeats itself; aimed at what they share.
static void degenerate(random_state *random, case_pair *pair) {
  const gjk_q16 reach = random_below(random, 2) == 0 ? 5 : any_reach(random);
  case_shape *const shape[2] = {&pair->a, &pair->b};
  for (int i = 0; i < 2; i++) {
    make_hull(random, reach, 1 + random_below(random, 6), shape[i]);
    const unsigned flat = random_below(random, 4);
    for (size_t k = 0; k < shape[i]->count; k++) {
      gjk_vec3 *v = &shape[i]->vertices[k];
      v->x = flat == 1 ? 0 : v->x;
      v->y = flat == 2 ? v->x : v->y;
      v->z = flat == 3 ? v->x - v->y : flat == 2 ? -v->x : v->z;
    }
  }
  aim t;
  open(&t, random, pair);
  const exact_point target = random_below(random, 2) == 0 ? any_vertex(&t) : between(&t);
  const exact_point direction = any_direction(&t);
  pass(&t, &target, &direction, (int)random_below(random, 3), (int)random_below(random, 3));
  close(&t);
}

// Two shapes and a way in one plane: z = 0, or z = x - y.
static void coplanar(random_state *random, case_pair *pair) {
  const gjk_q16 reach = random_below(random, 2) == 0 ? 5 : any_reach(random);
  const bool sheared = random_below(random, 2) == 0;
  case_shape *const shape[2] = {&pair->a, &pair->b};
  for (int i = 0; i < 2; i++) {
    make_hull(random, reach, 1 + random_below(random, 6), shape[i]);
    for (size_t k = 0; k < shape[i]->count; k++) {
      gjk_vec3 *v = &shape[i]->vertices[k];
      v->z = sheared ? v->x - v->y : 0;
    }
  }
  aim t;
  open(&t, random, pair);
  exact_point target = random_below(random, 2) == 0 ? any_vertex(&t) : between(&t), direction = any_direction(&t);
  target.x[2] = sheared ? target.x[0] - target.x[1] : 0;
  direction.x[2] = sheared ? direction.x[0] - direction.x[1] : 0;
  direction.x[2] += random_below(random, 4) == 0 ? random_range(random, -1, 1) : 0;
  pass(&t, &target, &direction, steps(&t), (int)random_below(random, 3));
  close(&t);
}

// The pairs of generate_tilted, past each other or straight at each other.
static void tilted(random_state *random, case_pair *pair) {
  const gjk_vec3 origin = {0, 0, 0};
  generate_tilted(random, pair);
  pair->b.pose.position = origin;
  pair->a.convex_radius = pair->b.convex_radius = 0;
  if (pair->b.kind == CASE_HULL && pair->b.count > 12) {
    make_box(random, any_reach(random), &pair->b);
  }
  if (random_below(random, 2) == 0) {
    come_at(random, pair);
  } else {
    graze(random, pair, random_below(random, 2) == 0, random_below(random, 2) == 0);
  }
}

static void no_motion(random_state *random, case_pair *pair) {
  start_touch(random, pair);
  pair->b.end.position = pair->b.pose.position;
  pair->b.moves = random_below(random, 2) == 0;
}

// The way ends where a vertex of A - B, or a point between two, is met; or 1 LSB beside it.
static void end_touch(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  const exact_point p = outer_vertex(&t), q = random_below(random, 2) == 0 ? p : outer_vertex(&t), sum = add(&p, 1, &q);
  const exact_point target = {{sum.x[0] / 2, sum.x[1] / 2, sum.x[2] / 2}}, off = one_lsb(random);
  const exact_point beside = add(&target, random_below(random, 2), &off), direction = any_direction(&t);
  pass(&t, &beside, &direction, steps(&t), 0);
  close(&t);
}

static void lattice(random_state *random, case_pair *pair) {
  make_hull(random, 2, 1 + random_below(random, 8), &pair->a);
  make_hull(random, 2, 1 + random_below(random, 8), &pair->b);
  const exact_point from = {{random_range(random, -5, 5), random_range(random, -5, 5), random_range(random, -5, 5)}};
  const exact_point to = {{random_range(random, -5, 5), random_range(random, -5, 5), random_range(random, -5, 5)}};
  aim t;
  open(&t, random, pair);
  set_way(&t, &from, &to);
  close(&t);
}

// Ways of up to 2^31 LSB and more, past small and large shapes.
static void long_scale(random_state *random, case_pair *pair) {
  make_pair(random, any_reach(random), pair);
  aim t;
  open(&t, random, pair);
  const exact_point target = between(&t), direction = to_point(generate_vector(random, 2000000000.0));
  const double share = generate_unit(random);
  exact_point from = target, to = target;
  for (int i = 0; i < 3; i++) {
    from.x[i] -= (int64_t)((double)direction.x[i] * share);
    to.x[i] += (int64_t)((double)direction.x[i] * (1 - share));
  }
  set_way(&t, &from, &to);
  close(&t);
}

// Both as near to an end of int32 as the way allows.
static void far_origin(random_state *random, case_pair *pair) {
  graze_hull(random, pair);
  if (random_below(random, 2) == 0) {
    gjk_vec3 *at[3] = {&pair->a.pose.position, &pair->b.pose.position, &pair->b.end.position};
    const int64_t sign = random_below(random, 2) == 0 ? 1 : -1;
    int64_t room = INT32_MAX;
    for (int i = 0; i < 3; i++) {
      const int64_t all[3] = {at[i]->x, at[i]->y, at[i]->z};
      for (int k = 0; k < 3; k++) {
        const int64_t left = INT32_MAX - sign * all[k];
        room = left < room ? left : room;
      }
    }
    // A hull's centre may lie so far from its position.
    room -= 60000000;
    for (int i = 0; i < 3; i++) {
      at[i]->x = clamp(at[i]->x + sign * room);
      at[i]->y = clamp(at[i]->y + sign * room);
      at[i]->z = clamp(at[i]->z + sign * room);
    }
    return;
  }
  pair->a.pose.position.x += 1900000000;
  pair->b.pose.position.x += 1900000000;
  pair->b.end.position.x += 1900000000;
}

// Hulls of up to 200 points on a sphere, in a box, or on a coarse lattice, where many lie in one plane.
static void make_many(random_state *random, gjk_q16 reach, case_shape *shape) {
  const unsigned style = random_below(random, 3);
  const gjk_q16 grid = style == 0 ? reach / 2 + 1 : 1;
  make_hull(random, reach, 10 + random_below(random, 190), shape);
  for (size_t i = 0; i < shape->count; i++) {
    gjk_vec3 *v = &shape->vertices[i];
    *v = style == 1 ? generate_vector(random, reach) : *v;
    v->x = v->x / grid * grid;
    v->y = v->y / grid * grid;
    v->z = v->z / grid * grid;
  }
}

static void make_many_pair(random_state *random, case_pair *pair) {
  const gjk_q16 reach = any_reach(random);
  make_many(random, reach, &pair->a);
  if (random_below(random, 2) == 0) {
    make_box(random, reach, &pair->b);
  } else {
    make_many(random, 1 + reach / (gjk_q16)(1 + random_below(random, 4)), &pair->b);
  }
  if (random_below(random, 2) == 0) {
    turn(random, pair);
  }
}

static void many_hulls(random_state *random, case_pair *pair) {
  make_many_pair(random, pair);
  ordinary(random, pair);
}

static void many_graze(random_state *random, case_pair *pair) {
  make_many_pair(random, pair);
  graze(random, pair, random_below(random, 2) == 0, random_below(random, 2) == 0);
}

// A moves as well, by as much as it takes from B's way.
static void share_way(random_state *random, case_pair *pair) {
  gjk_vec3 *p = &pair->a.pose.position, *q = &pair->b.end.position;
  const gjk_vec3 by = generate_vector(random, (double)(1 << random_below(random, 26)));
  const gjk_vec3 to_a = {clamp((int64_t)p->x + by.x), clamp((int64_t)p->y + by.y), clamp((int64_t)p->z + by.z)};
  const gjk_vec3 to_b = {clamp((int64_t)q->x + to_a.x - p->x), clamp((int64_t)q->y + to_a.y - p->y),
                         clamp((int64_t)q->z + to_a.z - p->z)};
  case_shape_move_to(&pair->a, &to_a);
  case_shape_move_to(&pair->b, &to_b);
}

const generate_cast_family generate_cast_families[] = {
    {.name = "ordinary_boxes", .generate = ordinary_boxes, .least = 40, .most = 98},
    {.name = "ordinary_hulls", .generate = ordinary_hulls, .least = 30, .most = 98},
    {.name = "graze_face", .generate = graze_face, .least = 20, .most = 98},
    {.name = "graze_slope", .generate = graze_slope, .least = 20, .most = 80},
    {.name = "graze_hull", .generate = graze_hull, .least = 20, .most = 80},
    {.name = "edge_edge", .generate = edge_edge, .least = 20, .most = 80},
    {.name = "parallel_faces", .generate = parallel_faces, .least = 30, .most = 98},
    {.name = "parallel_hulls", .generate = parallel_hulls, .least = 20, .most = 98},
    {.name = "vertex_vertex", .generate = vertex_vertex, .least = 30, .most = 98},
    {.name = "vertex_sideways", .generate = vertex_sideways, .least = 30, .most = 98},
    {.name = "tiny", .generate = tiny, .least = 20, .most = 98},
    {.name = "huge", .generate = huge, .least = 20, .most = 98},
    {.name = "thin_wall", .generate = thin_wall, .least = 20, .most = 98},
    {.name = "bullet", .generate = bullet, .least = 20, .most = 98},
    {.name = "start_touch", .generate = start_touch, .least = 30, .most = 98, .inside = 20},
    {.name = "start_touch_box", .generate = start_touch_box, .least = 20, .most = 80, .inside = 20},
    {.name = "start_overlap", .generate = start_overlap, .least = 50, .most = 100, .inside = 50},
    {.name = "degenerate", .generate = degenerate, .least = 20, .most = 98, .inside = 10},
    {.name = "coplanar", .generate = coplanar, .least = 20, .most = 98},
    {.name = "tilted", .generate = tilted, .least = 20, .most = 98},
    {.name = "no_motion", .generate = no_motion, .least = 20, .most = 98, .inside = 20},
    {.name = "end_touch", .generate = end_touch, .least = 30, .most = 98},
    {.name = "lattice", .generate = lattice, .least = 10, .most = 80, .inside = 3},
    {.name = "long_scale", .generate = long_scale, .least = 30, .most = 98},
    {.name = "far_origin", .generate = far_origin, .least = 20, .most = 80},
    {.name = "many_hulls", .generate = many_hulls, .least = 40, .most = 98, .many = true},
    {.name = "many_graze", .generate = many_graze, .least = 20, .most = 90, .many = true},
};
const unsigned generate_cast_family_count = sizeof generate_cast_families / sizeof generate_cast_families[0];

void generate_cast(const generate_cast_family *family, uint64_t seed, case_pair *pair) {
  random_state random = random_seed(seed);
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  family->generate(&random, pair);
  if (random_below(&random, 8) == 0 && pair->b.moves) {
    share_way(&random, pair);
  }
  snprintf(pair->id, sizeof pair->id, "%s-%llu", family->name, (unsigned long long)seed);
}
