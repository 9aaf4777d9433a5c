// Hulls at the largest coordinates there are, proven by integers of 128 bits that share nothing with the library: no point is
// beyond a face, faces are plane, strictly convex and closed, and no two beside each other are in one plane. So vertices,
// facets and edges are those of the real hull. The same of few points on small lattices, most of which are coplanar, in a line
// or repeated. And simple hulls: that they hold all points, and how far they reach.
#include "hull_proof.h"

#include <math.h>

#include "src/hull/gjk_hull_excess.h"
#include "src/hull/gjk_hull_facets.h"

#define SIDE (2 * (int64_t)GJK_RADIUS_MAX)  // most between points along an axis, below 2^29
#ifndef TRIALS
#define TRIALS 1500
#endif
#define FAMILIES 12
#define LATTICES 500000
#define LATTICE_POINTS 12

static hull_points p, simple;
static hull_output out, again, full;
static unsigned long checked, joined, doubled, inner, simplified, refused;

// The distance of a point from a segment.
static long double from_edge(gjk_vec3 a, gjk_vec3 b, gjk_vec3 q) {
  const vec e = minus(b, a), w = minus(q, a), back = minus(q, b);
  if (dot(e, w) <= 0) {
    return sqrtl((long double)dot(w, w));
  }
  if (dot(e, back) >= 0) {
    return sqrtl((long double)dot(back, back));
  }
  const vec n = cross(e, w);
  return sqrtl(((long double)n.x * n.x + (long double)n.y * n.y + (long double)n.z * n.z) / (long double)dot(e, e));
}

// The distance of a point from a hull: 2^-30 LSB off at most. Sides are exact.
static long double from_hull(const hull_output *o, gjk_vec3 q) {
  long double least = 1e30L;
  bool outside = false;
  for (unsigned f = 0; f < o->faces.count; f++) {
    const face own = face_of(o, f);
    const wide height = dot(own.n, minus(q, own.at));
    if (height <= 0) {
      continue;
    }
    bool over = true;
    outside = true;
    for (unsigned i = 0; i < own.corners; i++) {
      const gjk_vec3 a = o->vertex[own.corner[i]], b = o->vertex[own.corner[(i + 1) % own.corners]];
      const vec e = minus(b, a), w = minus(q, a);
      // n x e . w, of which each product is below 2^120
      const wide side = (wide)own.n.y * (e.z * w.x - e.x * w.z) + (wide)own.n.z * (e.x * w.y - e.y * w.x) +
                        (wide)own.n.x * (e.y * w.z - e.z * w.y);
      over = over && side >= 0;
      least = fminl(least, from_edge(a, b, q));
    }
    if (over) {
      const long double n =
          sqrtl((long double)own.n.x * own.n.x + (long double)own.n.y * own.n.y + (long double)own.n.z * own.n.z);
      least = fminl(least, (long double)height / n);
    }
  }
  return outside ? least : 0;
}

// Simplifies, and checks that all points are held and the excess is not below the largest distance, nor 2 LSB above it.
static void check_simple(uint16_t most) {
  static uint32_t workspace[GJK_HULL_SIMPLIFY_WORKSPACE(HULL_POINTS) / 4];
  gjk_hull_simple result = {0, 0};
  const gjk_status status =
      gjk_hull_simplify(p.point, p.count, most, workspace, GJK_HULL_SIMPLIFY_WORKSPACE(p.count), simple.point, &result);
  if (status == GJK_ERROR_RANGE) {
    refused++;
    return;  // no room for a tetrahedron, or a box
  }
  CHECK(status == GJK_OK && result.vertices <= most);
  simple.count = result.vertices;
  hull_output_make(&simple, &again);
  CHECK(again.hull.dimension == 3 && again.hull.vertices == simple.count);
  joined += hull_certify(&simple, &again);
  unsigned beyond = 0;
  for (unsigned f = 0; f < again.faces.count; f++) {
    const face own = face_of(&again, f);
    for (unsigned i = 0; i < p.count; i++) {
      beyond += dot(own.n, minus(p.point[i], own.at)) > 0;
    }
  }
  CHECK_MSG(beyond == 0, "%u points beyond", beyond);
  long double excess = 0;
  for (unsigned i = 0; i < simple.count; i++) {
    excess = fmaxl(excess, from_hull(&full, simple.point[i]));
  }
  CHECK_MSG(excess <= result.excess + 1e-6L && (full.hull.vertices <= most || excess + 2 >= result.excess),
            "excess %.6Lf, stated %lu", excess, (unsigned long)result.excess);
  simplified += full.hull.vertices > most;
}

// Are the points in one plane?
static bool are_flat(void) {
  for (unsigned i = 1; i < p.count; i++) {
    for (unsigned j = i + 1; j < p.count; j++) {
      const vec n = cross(minus(p.point[i], p.point[0]), minus(p.point[j], p.point[0]));
      for (unsigned k = j + 1; k < p.count; k++) {
        if (dot(n, minus(p.point[k], p.point[0])) != 0) {
          return false;
        }
      }
    }
  }
  return true;
}

static void check_points(random_state *random) {
  hull_output_make(&p, &out);
  if (out.hull.dimension < 3) {
    CHECK(p.count > LATTICE_POINTS || (are_flat() && out.volume.high == 0 && out.volume.low == 0));
    return;
  }
  checked++;
  doubled += out.hull.distinct < p.count;
  inner += out.hull.vertices < out.hull.distinct;
  joined += hull_certify(&p, &out);
  hull_points_shuffle(&p, random);
  hull_output_make(&p, &again);
  CHECK(hull_output_equal(&out, &again));
}

// Adds a point if it is near enough to the others. Coordinates from 0 to SIDE: places are moved to an end of int32 later.
static void add(int64_t x, int64_t y, int64_t z) {
  if (x >= 0 && y >= 0 && z >= 0 && x <= SIDE && y <= SIDE && z <= SIDE && p.count < HULL_POINTS) {
    hull_points_add(&p, (int32_t)x, (int32_t)y, (int32_t)z);
  }
}

static int64_t below(random_state *random, int64_t bound) {
  return (int64_t)random_below(random, (uint32_t)bound);
}

// A pyramid whose base has points within it and on its edges, and an apex an LSB above or far away. The base leans.
static void make_leaning(random_state *random, bool low) {
  const int64_t ux = 1 + below(random, 9), uy = below(random, 9), uz = below(random, 9), vx = below(random, 9),
                vy = 1 + below(random, 9), vz = below(random, 9), step = 1 + below(random, SIDE / 400);
  for (int i = 0; i < 60; i++) {
    const int64_t s = step * below(random, 21), t = step * (i < 20 ? 0 : i < 40 ? 20 : below(random, 21));
    add(ux * s + vx * t, uy * s + vy * t, uz * s + vz * t);
  }
  const int64_t s = step * 10 + below(random, 3) - 1, t = step * 10;
  add(ux * s + vx * t, uy * s + vy * t, uz * s + vz * t + (low ? 1 : below(random, SIDE)));
}

// Points around a plane, within some LSB, as wide as can be.
static void make_slab(random_state *random, int64_t thick) {
  const int64_t a = below(random, 5), b = below(random, 5);
  for (int i = 0; i < 120; i++) {
    const int64_t x = below(random, SIDE / 16), y = below(random, SIDE / 16);
    add(8 * x, 8 * y, a * x + b * y + below(random, thick));
  }
}

// A curve all of whose points are extreme: moments t, t^2, t^3, with gaps in proportion.
static void make_moments(random_state *random) {
  const int64_t n = 50 + below(random, 200);
  for (int64_t i = 0; i < n; i++) {
    add(SIDE * i / n, SIDE * i / n * i / n, SIDE * i / n * i / n * i / n);
  }
}

static void make_ball(random_state *random, int64_t radius, unsigned count) {
  while (p.count < count) {
    const double x = 2.0 * random_u32(random) / 4294967296.0 - 1, y = 2.0 * random_u32(random) / 4294967296.0 - 1,
                 z = 2.0 * random_u32(random) / 4294967296.0 - 1, n = sqrt(x * x + y * y + z * z);
    if (n > 0.1 && n <= 1) {
      const double r = (double)radius, up = (double)SIDE / 2;
      add((int64_t)(up + r * x / n), (int64_t)(up + r * y / n), (int64_t)(up + r * z / n));
    }
  }
}

// A grid under a rotation by integers, which keeps its planes: of the quaternion (a, b, c, d), times its squared length.
static void make_turned(random_state *random, int n) {
  const int64_t a = 1 + below(random, 20), b = below(random, 20), c = below(random, 20), d = below(random, 20);
  const int64_t m[3][3] = {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                           {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                           {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
  const int64_t step = 1 + below(random, SIDE / 2 / (2 * n * 3 * 1600));
  for (int i = 0; i < n * n * n; i++) {
    const int64_t x = step * (i % n), y = step * (i / n % n), z = step * (i / n / n);
    add(SIDE / 2 + m[0][0] * x + m[0][1] * y + m[0][2] * z, SIDE / 2 + m[1][0] * x + m[1][1] * y + m[1][2] * z,
        SIDE / 2 + m[2][0] * x + m[2][1] * y + m[2][2] * z);
  }
}

// A rounded cylinder as sums: of circles of points, rounded, with few points of a ball.
static void make_sum(random_state *random) {
  const int corners = 4 + (int)below(random, 28), ball = 6 + (int)below(random, 20);
  const double radius = (double)SIDE / 3, r = (double)(1 + below(random, SIDE / 8));
  for (int i = 0; i < 2 * corners; i++) {
    const int of = i / 2;
    const double angle = 6.283185307179586 * of / corners;
    for (int j = 0; j < ball; j++) {
      const double across = 6.283185307179586 * j / ball, up = j % 3 == 0 ? 0 : j % 3 == 1 ? 0.7 : -0.7;
      const double level = sqrt(1 - up * up);
      add((int64_t)((double)SIDE / 2 + radius * cos(angle) + r * level * cos(across)),
          (int64_t)((double)SIDE / 2 + radius * sin(angle) + r * level * sin(across)),
          (int64_t)((double)SIDE / 2 + (i % 2 == 0 ? -0.3 : 0.3) * (double)SIDE + r * up));
    }
  }
}

// A cell: the corners that three of some planes around the middle have in common, rounded. Most have three planes, so rounding
// bends all facets by less than an LSB.
static void make_cell(random_state *random) {
  vec n[24];
  const int planes = 8 + (int)below(random, 17);
  for (int i = 0; i < planes; i++) {
    do {
      n[i].x = random_range(random, -1000, 1000);
      n[i].y = random_range(random, -1000, 1000);
      n[i].z = random_range(random, -1000, 1000);
    } while (dot(n[i], n[i]) < 250000 || dot(n[i], n[i]) > 1000000);
  }
  for (int i = 0; i < planes; i++) {
    for (int j = 0; j < i; j++) {
      for (int k = 0; k < j; k++) {
        // n . x = |n| 10^8 for three
        const vec jk = cross(n[j], n[k]), ki = cross(n[k], n[i]), ij = cross(n[i], n[j]);
        const double det = (double)dot(n[i], jk), a = sqrt((double)dot(n[i], n[i])), b = sqrt((double)dot(n[j], n[j])),
                     c = sqrt((double)dot(n[k], n[k])), size = 1e8;
        const double x = size * (a * (double)jk.x + b * (double)ki.x + c * (double)ij.x) / det,
                     y = size * (a * (double)jk.y + b * (double)ki.y + c * (double)ij.y) / det,
                     z = size * (a * (double)jk.z + b * (double)ki.z + c * (double)ij.z) / det;
        bool within = fabs(x) < 2e8 && fabs(y) < 2e8 && fabs(z) < 2e8;
        for (int l = 0; l < planes && within; l++) {
          const double length = sqrt((double)dot(n[l], n[l]));
          within = (double)n[l].x * x + (double)n[l].y * y + (double)n[l].z * z <= length * (size + 0.5);
        }
        if (within) {
          add(SIDE / 2 + (int64_t)x, SIDE / 2 + (int64_t)y, SIDE / 2 + (int64_t)z);
        }
      }
    }
  }
}

// Tetrahedra of the least volume, 1/6, as long as can be, and points along their edges and in a heap at each corner.
static void make_least(random_state *random) {
  int64_t m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int round = 0; round < 60; round++) {
    const unsigned to = random_below(random, 3), from = (to + 1 + random_below(random, 2)) % 3;
    const int64_t factor = 1 + below(random, 3);
    for (int j = 0; j < 3; j++) {
      if (m[to][0] + m[to][1] + m[to][2] + factor * (m[from][0] + m[from][1] + m[from][2]) <= SIDE / 8) {
        for (int k = 0; k < 3; k++) {
          m[to][k] += factor * m[from][k];
        }
      }
    }
  }
  const int64_t wide_steps = 1 + below(random, 4);
  for (int i = 0; i < 60; i++) {
    const int64_t a = i % 4 == 1 ? wide_steps : below(random, 2), b = i % 4 == 2 ? 1 : 0, c = i % 4 == 3 ? 1 : 0;
    add(m[0][0] * a + m[0][1] * b + m[0][2] * c, m[1][0] * a + m[1][1] * b + m[1][2] * c,
        m[2][0] * a + m[2][1] * b + m[2][2] * c);
  }
}

// Points of the box of all, on its edges and within its facets, with masses at corners, but one corner cut off by an LSB.
static void make_box(random_state *random) {
  for (int i = 0; i < 150; i++) {
    int64_t at[3];
    const unsigned free = random_below(random, 3);
    for (unsigned k = 0; k < 3; k++) {
      const int64_t end = random_below(random, 2) == 0 ? 0 : SIDE;
      at[k] = k == free && i % 3 == 0 ? below(random, SIDE) : end;
    }
    if (at[0] == SIDE && at[1] == SIDE && at[2] == SIDE) {
      at[random_below(random, 3)]--;
    }
    add(at[0], at[1], at[2]);
  }
}

// Few points of a small lattice, of which most coincide, or lie in a line or a plane with others.
static void test_lattices(random_state *random) {
  const unsigned long before = checked, trials = check_trials(LATTICES);
  for (unsigned long trial = 0; trial < trials; trial++) {
    const int64_t side = 1 + below(random, 4), high = random_below(random, 4) == 0 ? 0 : side;
    check_trial(trial, hull_points_print, &p);
    p.count = 0;
    for (uint32_t count = 1 + random_below(random, LATTICE_POINTS); count > 0; count--) {
      add(below(random, side + 1), below(random, side + 1), below(random, high + 1));
    }
    check_points(random);
  }
  CHECK(checked - before > trials / 4 && checked - before < trials * 3 / 4);
}

static void make_family(random_state *random, unsigned family) {
  p.count = 0;
  switch (family) {
    case 0: make_leaning(random, true); break;
    case 1: make_leaning(random, false); break;
    case 2: make_slab(random, 2); break;
    case 3: make_slab(random, 1 + below(random, 100)); break;
    case 4: make_moments(random); break;
    case 5: make_ball(random, SIDE / 2, 20 + random_below(random, 150)); break;
    case 6: make_ball(random, 1 + below(random, 1000), 20 + random_below(random, 100)); break;
    case 7: make_turned(random, 2 + (int)random_below(random, 4)); break;
    case 8: make_sum(random); break;
    case 9: make_cell(random); break;
    case 10: make_least(random); break;
    default: make_box(random); break;
  }
  const uint32_t heap = random_below(random, 3) == 0 ? random_below(random, 40) : 0;
  for (uint32_t i = 0; i < heap && p.count > 0 && p.count < HULL_POINTS; i++) {  // again, some of them
    p.point[p.count] = p.point[random_below(random, p.count)];
    p.count++;
  }
  const bool upper = random_below(random, 2) == 0;
  const bool apart = random_below(random, 3) > 0;
  for (unsigned i = 0; i < p.count && apart; i++) {  // to an end of int32
    gjk_vec3 *v = &p.point[i];
    v->x = upper ? (int32_t)(v->x + (INT32_MAX - SIDE)) : v->x + INT32_MIN;
    v->y = upper ? v->y + INT32_MIN : (int32_t)(v->y + (INT32_MAX - SIDE));
    v->z = upper ? (int32_t)(v->z + (INT32_MAX - SIDE)) : v->z + INT32_MIN;
  }
}

// The bound of a point's distance from a hull is never below it, and less than 2 LSB above.
static bool check_distance(gjk_vec3 point) {
  gjk_hull_work w;
  uint32_t least;
  const long double distance = from_hull(&out, point);
  gjk_hull_work_of_hull(&out.hull, &w);
  const uint32_t bound = gjk_hull_excess(&w, &point, 1, &least);
  CHECK_MSG(distance <= bound + 1e-8L && bound < distance + 2 + 1e-8L, "distance %.6Lf, bound %lu", distance,
            (unsigned long)bound);
  return distance > 0;
}

// Points beyond tetrahedra as long as can be: beside an edge, the direction of which says most when it is rounded; near a
// triangle; anywhere.
static void test_distances(random_state *random) {
  // Edges and points beside them whose distance was up to 0.14 LSB larger than its bound by unit vectors of 30 bits.
  static const gjk_vec3 beside[][3] = {
      {{44549043, 521418759, 514597276}, {498048832, 78636086, 526376142}, {462703582, 93983310, 516696544}},
      {{3964908, 512891370, 531409375}, {530936592, 74314187, 494385138}, {470064328, 64116354, 463266943}},
      {{55284653, 474092023, 534700730}, {523203645, 77232420, 496887709}, {483807068, 60507040, 471207856}},
      {{6859701, 502563210, 492983897}, {515995446, 76398126, 475773057}, {493899887, 77719426, 466860807}}};
  unsigned long beyond = 0;
  check_trial(0, hull_points_print, &p);
  for (unsigned i = 0; i < sizeof beside / sizeof beside[0]; i++) {
    p.count = 0;
    hull_points_add(&p, beside[i][0].x, beside[i][0].y, beside[i][0].z);
    hull_points_add(&p, beside[i][1].x, beside[i][1].y, beside[i][1].z);
    add(SIDE, SIDE, SIDE);
    add(SIDE, SIDE - 1, SIDE);
    hull_output_make(&p, &out);
    CHECK(out.hull.dimension == 3 && check_distance(beside[i][2]));
  }
  const unsigned long trials = check_trials(20000);
  for (unsigned long trial = 0; trial < trials; trial++) {
    check_trial(trial, hull_points_print, &p);
    p.count = 0;
    while (p.count < 4) {
      add(below(random, SIDE + 1), below(random, SIDE + 1), below(random, SIDE + 1));
    }
    hull_output_make(&p, &out);
    const int64_t part = below(random, 1001), rest = trial % 2 == 0 ? 1000 - part : below(random, 1001 - part);
    const gjk_vec3 *v = p.point;
    const int32_t off = INT32_C(1) << random_below(random, 28);
    add((v[0].x * part + v[1].x * rest + v[2].x * (1000 - part - rest)) / 1000 + random_range(random, -off, off),
        (v[0].y * part + v[1].y * rest + v[2].y * (1000 - part - rest)) / 1000 + random_range(random, -off, off),
        (v[0].z * part + v[1].z * rest + v[2].z * (1000 - part - rest)) / 1000 + random_range(random, -off, off));
    beyond += p.count == 5 && out.hull.dimension == 3 && check_distance(p.point[4]);
  }
  CHECK_MSG(beyond > trials / 4, "%lu of %lu", beyond, trials);
}

int main(void) {
  random_state random = random_seed(check_seed(128));
  test_distances(&random);
  const unsigned long trials = check_trials_least(TRIALS, 2 * FAMILIES);
  unsigned long of_family[FAMILIES] = {0};
  for (unsigned long trial = 0; trial < trials; trial++) {
    const unsigned family = (unsigned)(trial % FAMILIES);
    make_family(&random, family);
    if (p.count == 0) {
      continue;
    }
    check_trial(trial, hull_points_print, &p);
    const unsigned long before = checked;
    check_points(&random);
    of_family[family] += checked - before;
    if (checked > before && trial / FAMILIES % 4 == 0) {
      full = out;
      check_simple((uint16_t)(4 + random_below(&random, 30)));
    }
  }
  for (unsigned family = 0; family < FAMILIES; family++) {
    CHECK_MSG(!check_is_full() || of_family[family] > trials / FAMILIES / 2, "family %u: %lu of %lu", family,
              of_family[family], trials / FAMILIES);
  }
  if (check_is_full()) {
    CHECK_MSG(simplified > checked / 16 && refused < simplified, "%lu simplified, %lu refused", simplified, refused);
  }
  CHECK(joined > checked / 4 && doubled > checked / 10 && inner > checked / 4);
  printf(
      "%lu hulls: %lu with facets of more than 3 corners, %lu of repeated points, %lu with points that are no "
      "vertices\n",
      checked, joined, doubled, inner);
  test_lattices(&random);
  return check_done("hull exact");
}
