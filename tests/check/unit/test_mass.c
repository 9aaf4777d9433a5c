// Mass properties of shapes. Polytopes against exact integers from another decomposition, others against quadrature.
#include <math.h>

#include "exact/integer.h"
#include "gjk/mass.h"
#include "hull_points.h"

static hull_points p;
static hull_output out;

// Sums over simplices as gjk_moments.h has them, but from the frame's origin: any int32_t, and negative weights.
typedef struct sums {
  exact_int weight, first[3], second[3][3];
  int k;  // vertices of a simplex
} sums;

static int64_t component(const gjk_vec3 *v, int i) {
  return i == 0 ? v->x : i == 1 ? v->y : v->z;
}

// Six times the volume of the tetrahedron a, b, c, d.
static exact_int determinant(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, const gjk_vec3 *d) {
  int64_t e[3][3];
  const gjk_vec3 *const other[3] = {b, c, d};
  exact_int sum = exact_from(0);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      e[i][j] = component(other[i], j) - component(a, j);
    }
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    exact_int one = exact_product(e[1][j], e[2][k]);
    const exact_int two = exact_product(e[1][k], e[2][j]), edge = exact_from(e[0][i]);
    one = exact_sub(&one, &two);
    exact_add_to(&sum, exact_mul(&edge, &one));
  }
  return sum;
}

static void add_simplex(sums *s, exact_int weight, const gjk_vec3 *const *v) {
  exact_add_to(&s->weight, weight);
  for (int i = 0; i < 3; i++) {
    int64_t of_i = 0;
    for (int n = 0; n < s->k; n++) {
      of_i += component(v[n], i);
    }
    const exact_int sum_i = exact_from(of_i);
    exact_add_to(&s->first[i], exact_mul(&weight, &sum_i));
    for (int j = 0; j < 3; j++) {
      int64_t of_j = 0;
      exact_int second = exact_from(0);
      for (int n = 0; n < s->k; n++) {
        of_j += component(v[n], j);
        exact_add_to(&second, exact_product(component(v[n], i), component(v[n], j)));
      }
      exact_add_to(&second, exact_product(of_i, of_j));
      exact_add_to(&s->second[i][j], exact_mul(&weight, &second));
    }
  }
}

static void sums_start(sums *s, int k) {
  s->k = k;
  s->weight = exact_from(0);
  for (int i = 0; i < 3; i++) {
    s->first[i] = exact_from(0);
    for (int j = 0; j < 3; j++) {
      s->second[i][j] = exact_from(0);
    }
  }
}

// C_ij k^3 (k + 1) S^2 for a mass of 1.
static exact_int second_about_centre(const sums *s, int i, int j) {
  const exact_int square = exact_from(s->k * s->k), other = exact_from(s->k * (s->k + 1));
  exact_int one = exact_mul(&s->weight, &s->second[i][j]), two = exact_mul(&s->first[i], &s->first[j]);
  one = exact_mul(&one, &square);
  two = exact_mul(&two, &other);
  return exact_sub(&one, &two);
}

static int64_t centre_in_q16(const gjk_mass *m, int i) {
  return component(&m->centre, i) * 65536 + m->fraction[i];
}

// Are the mass properties those of the sums, correctly rounded?
static void check_against(const sums *s, const gjk_mass *m, bool solid) {
  exact_int whole = exact_mul(&s->weight, &s->weight), all = exact_from(s->k);
  const exact_int factor = exact_from((int64_t)s->k * s->k * s->k * (s->k + 1));
  whole = exact_mul(&whole, &factor);
  all = exact_mul(&all, &s->weight);
  CHECK(all.sign > 0);
  if (solid) {
    const exact_int six = exact_from(6), two64 = exact_product(INT64_C(1) << 32, INT64_C(1) << 32),
                    low = exact_product((int64_t)(m->volume.low >> 1), 2),
                    bit = exact_from((int64_t)(m->volume.low & 1)), high = exact_from((int64_t)m->volume.high);
    exact_int volume = exact_mul(&high, &two64);  // 6 volume - 3 <= weight < 6 volume + 3
    exact_add_to(&volume, low);
    exact_add_to(&volume, bit);
    volume = exact_mul(&volume, &six);
    const exact_int rest = exact_sub(&s->weight, &volume), three = exact_from(3), minus = exact_from(-3);
    CHECK(exact_compare(&rest, &minus) >= 0 && exact_compare(&rest, &three) < 0);
  } else {
    CHECK(m->volume.high == 0 && m->volume.low == 0);
  }
  exact_int c[3][3];
  for (int i = 0; i < 3; i++) {
    CHECK(exact_is_rounded(centre_in_q16(m, i), s->first[i], all, 65536, 0));
    CHECK(exact_is_rounded(component(&m->centre, i), s->first[i], all, 1, 1));
    for (int j = 0; j < 3; j++) {
      c[i][j] = second_about_centre(s, i, j);
    }
  }
  CHECK(exact_is_rounded(m->inertia.xx, exact_add(&c[1][1], &c[2][2]), whole, 1, 1));
  CHECK(exact_is_rounded(m->inertia.yy, exact_add(&c[2][2], &c[0][0]), whole, 1, 1));
  CHECK(exact_is_rounded(m->inertia.zz, exact_add(&c[0][0], &c[1][1]), whole, 1, 1));
  CHECK(exact_is_rounded(m->inertia.yz, exact_negate(c[1][2]), whole, 1, 1));
  CHECK(exact_is_rounded(m->inertia.zx, exact_negate(c[2][0]), whole, 1, 1));
  CHECK(exact_is_rounded(m->inertia.xy, exact_negate(c[0][1]), whole, 1, 1));
  CHECK(m->mass == 0);
}

static bool same(const gjk_mass *a, const gjk_mass *b) {
  return a->volume.high == b->volume.high && a->volume.low == b->volume.low && a->mass == b->mass &&
         a->centre.x == b->centre.x && a->centre.y == b->centre.y && a->centre.z == b->centre.z &&
         a->fraction[0] == b->fraction[0] && a->fraction[1] == b->fraction[1] && a->fraction[2] == b->fraction[2] &&
         a->inertia.xx == b->inertia.xx && a->inertia.yy == b->inertia.yy && a->inertia.zz == b->inertia.zz &&
         a->inertia.yz == b->inertia.yz && a->inertia.zx == b->inertia.zx && a->inertia.xy == b->inertia.xy;
}

// The sums of a hull: tetrahedra from an apex anywhere. In a plane: triangles of the first facet, by their projection.
static void sums_of_output(sums *s, const gjk_vec3 *apex) {
  if (out.hull.dimension < 2) {
    const gjk_vec3 *const ends[2] = {&out.vertex[0], &out.vertex[out.hull.vertices - 1]};
    sums_start(s, 2);
    add_simplex(s, exact_from(1), ends);
    return;
  }
  sums_start(s, out.hull.dimension + 1);
  for (unsigned face = 0; face < out.faces.count; face++) {
    const unsigned first = face == 0 ? 0u : out.end[face - 1];
    for (unsigned i = first + 2; i < out.end[face]; i++) {  // from the last corner, not from the first
      const gjk_vec3 *const v[4] = {&out.vertex[out.corner[out.end[face] - 1]], &out.vertex[out.corner[i - 2]],
                                    &out.vertex[out.corner[i - 1]], apex};
      if (s->k == 4) {
        const gjk_vec3 *const order[4] = {apex, v[0], v[1], v[2]};
        add_simplex(s, determinant(apex, v[0], v[1], v[2]), order);
      } else {
        // Twice the area, projected across a vector that all areas have a part along.
        const gjk_vec3 *a = &out.vertex[out.corner[0]], *b = &out.vertex[out.corner[1]],
                       *c = &out.vertex[out.corner[2]];
        const gjk_vec3 e = {b->x - a->x, b->y - a->y, b->z - a->z}, f = {c->x - a->x, c->y - a->y, c->z - a->z};
        const double n[3] = {(double)e.y * f.z - (double)e.z * f.y, (double)e.z * f.x - (double)e.x * f.z,
                             (double)e.x * f.y - (double)e.y * f.x};
        const int axis = fabs(n[0]) >= fabs(n[1]) && fabs(n[0]) >= fabs(n[2]) ? 0 : fabs(n[1]) >= fabs(n[2]) ? 1 : 2;
        gjk_vec3 off = *v[0];
        off.x += axis == 0;
        off.y += axis == 1;
        off.z += axis == 2;
        exact_int weight = determinant(v[0], v[1], v[2], &off);
        weight.sign = weight.sign == 0 ? 0 : 1;
        add_simplex(s, weight, v);
      }
    }
  }
}

// Checks the hull of the points, by its faces and by the builder.
static void check_hull(random_state *random) {
  gjk_mass by_hull, by_faces;
  static uint32_t workspace[GJK_HULL_WORKSPACE(HULL_POINTS) / 4];
  gjk_hull hull;
  sums s;
  hull_output_make(&p, &out);
  CHECK(gjk_hull_build(p.point, p.count, workspace, sizeof workspace, &hull) == GJK_OK);
  CHECK(gjk_mass_of_hull(&hull, &by_hull) == GJK_OK);
  const gjk_vec3 apex = {(int32_t)random_u32(random) >> (random_u32(random) & 31), random_range(random, -9, 9),
                         (int32_t)random_u32(random)};
  sums_of_output(&s, &apex);
  if (out.hull.dimension == 3 && random_below(random, 2) == 0) {
    check_against(&s, &by_hull, true);
  } else {
    sums_of_output(&s, &out.vertex[0]);
    check_against(&s, &by_hull, out.hull.dimension == 3);
  }
  const gjk_shape shape = GJK_HULL_WITH_FACES(out.vertex, out.hull.vertices, out.faces.count > 0 ? &out.faces : NULL);
  const gjk_status status = gjk_mass_of_shape(&shape, &by_faces);
  CHECK_MSG(status == GJK_OK || status == GJK_ERROR_SIZE, "%d", status);
  CHECK(status != GJK_OK || same(&by_hull, &by_faces));
}

static void test_random_hulls(uint64_t seed) {
  random_state random = random_seed(seed);
  unsigned dimensions[4] = {0, 0, 0, 0}, large = 0;
  for (unsigned long trial = 0; trial < 1200; trial++) {
    const int32_t size = INT32_C(1) << random_below(&random, 28), thick = size >> random_below(&random, 29);
    const uint32_t kind = random_below(&random, 8);
    const gjk_vec3 at = {random_range(&random, INT32_MIN + size, INT32_MAX - size), random_range(&random, -5, 5),
                         random_range(&random, INT32_MIN + size, INT32_MAX - size)};
    check_trial(trial, hull_points_print, &p);
    p.count = 0;
    const uint32_t count = 1 + random_below(&random, trial % 10 == 0 ? 100 : 12);
    const int32_t slope = random_range(&random, -3, 3);
    for (uint32_t i = 0; i < count; i++) {
      const int32_t x = random_range(&random, -size, size), y = random_range(&random, -size / 4, size / 4);
      hull_points_add(&p, at.x + x,
                      at.y + (kind == 0   ? x / 2 * 0
                              : kind == 1 ? slope * (x / 4)
                                          : y),
                      at.z + (kind <= 2 ? slope * (x / 8) : random_range(&random, -thick, thick)));
    }
    check_hull(&random);
    dimensions[out.hull.dimension]++;
    large += size >= INT32_C(1) << 24;
  }
  CHECK_MSG(dimensions[0] > 20 && dimensions[1] > 20 && dimensions[2] > 60 && dimensions[3] > 300 && large > 50,
            "%u %u %u %u, %u", dimensions[0], dimensions[1], dimensions[2], dimensions[3], large);
}

// The largest body, at both ends of int32; the smallest; the nearly flat one.
static void test_extremes(void) {
  random_state random = {5};
  for (int corner = 0; corner < 2; corner++) {
    p.count = 0;
    for (unsigned i = 0; i < 8; i++) {
      const int32_t side = 2 * GJK_RADIUS_MAX, low = corner == 0 ? INT32_MIN : INT32_MAX - side;
      hull_points_add(&p, low + ((i & 1) != 0 ? side : 0), low + ((i & 2) != 0 ? side : 0),
                      low + ((i & 4) != 0 ? side : 0));
    }
    check_trial((unsigned long)corner, hull_points_print, &p);
    check_hull(&random);
  }
  p.count = 0;
  hull_points_add(&p, 0, 0, 0);
  hull_points_add(&p, 1, 0, 0);
  hull_points_add(&p, 0, 1, 0);
  hull_points_add(&p, 0, 0, 1);
  check_trial(2, hull_points_print, &p);
  check_hull(&random);  // a sixth of a cubic LSB, rounded to 0
  p.count = 0;
  hull_points_add(&p, 0, 0, 0);
  hull_points_add(&p, 100000000, 1, 0);
  hull_points_add(&p, 1, 100000001, 0);
  hull_points_add(&p, 33333333, 33333334, 1);
  check_trial(3, hull_points_print, &p);
  check_hull(&random);
}

// A box as a box and as a hull is the same; a capsule is a rounded segment, box and cylinder without extents.
static void test_agreement(void) {
  random_state random = {6};
  for (unsigned trial = 0; trial < 200; trial++) {
    const int32_t a = (int32_t)random_below(&random, 1u << (trial % 27)),
                  b = (int32_t)random_below(&random, 1u << (random_below(&random, 27))),
                  c = (int32_t)random_below(&random, 1u << (random_below(&random, 27))), r = 1 + a / 3;
    gjk_mass one, two, three;
    check_trial(trial, NULL, NULL);
    p.count = 0;
    for (unsigned i = 0; i < 8; i++) {
      hull_points_add(&p, (i & 1) != 0 ? a : -a, (i & 2) != 0 ? b : -b, (i & 4) != 0 ? c : -c);
    }
    hull_output_make(&p, &out);
    const gjk_shape box = GJK_BOX(a, b, c), capsule = GJK_CAPSULE(r, c), cylinder = GJK_ROUNDED_CYLINDER(0, c, r),
                    rounded = GJK_ROUNDED_BOX(0, 0, c, r), ball = GJK_SPHERE(r), ellipsoid = GJK_ELLIPSOID(r, r, r);
    const gjk_shape hull = GJK_HULL_WITH_FACES(out.vertex, out.hull.vertices, out.faces.count > 0 ? &out.faces : NULL);
    CHECK(gjk_mass_of_shape(&box, &one) == GJK_OK && gjk_mass_of_shape(&hull, &two) == GJK_OK && same(&one, &two));
    CHECK(gjk_mass_of_shape(&capsule, &one) == GJK_OK && gjk_mass_of_shape(&cylinder, &two) == GJK_OK);
    CHECK(gjk_mass_of_shape(&rounded, &three) == GJK_OK && same(&one, &two) && same(&one, &three));
    CHECK(gjk_mass_of_shape(&ball, &one) == GJK_OK && gjk_mass_of_shape(&ellipsoid, &two) == GJK_OK);
    CHECK(same(&one, &two));
  }
}

// Integrals by the midpoint rule, with r sin(t) for what lies in the rounding, which makes the integrands smooth.
typedef struct quadrature {
  long double volume, square[3];
} quadrature;

#define STEPS 600

static void add_slice(quadrature *q, long double weight, long double x, long double y, long double half_z) {
  q->volume += weight * 2 * half_z;
  q->square[0] += weight * 2 * half_z * x * x;
  q->square[1] += weight * 2 * half_z * y * y;
  q->square[2] += weight * 2 * half_z * half_z * half_z / 3;
}

// A midpoint of core + rounding: core [0, half], then r beyond it. Sets its weight, and how far beyond it is.
static long double place_at(int i, long double half, long double r, long double *beyond, long double *weight) {
  if (i < STEPS / 2) {
    *beyond = 0;
    *weight = half / (STEPS / 2);
    return (i + 0.5L) * half / (STEPS / 2);
  }
  const long double quarter = acosl(-1.0L) / 2, step = quarter / (STEPS / 2), t = (i - STEPS / 2 + 0.5L) * step;
  *beyond = r * sinl(t);
  *weight = r * cosl(t) * step;
  return half + *beyond;
}

static void integrate_box(quadrature *q, const long double half[3], long double r) {
  for (int i = 0; i < STEPS; i++) {
    for (int j = 0; j < STEPS; j++) {
      long double u, v, weight, other;
      const long double x = place_at(i, half[0], r, &u, &weight);
      const long double left = sqrtl(fmaxl(0, r * r - u * u)), y = place_at(j, half[1], left, &v, &other);
      add_slice(q, 4 * weight * other, x, y, half[2] + sqrtl(fmaxl(0, left * left - v * v)));
    }
  }
}

static void integrate_cylinder(quadrature *q, long double base, long double half, long double r) {
  for (int i = 0; i < STEPS; i++) {
    long double beyond, weight;
    const long double rho = place_at(i, base, r, &beyond, &weight), x = rho / sqrtl(2);
    add_slice(q, weight * 2 * acosl(-1.0L) * rho, x, x, half + sqrtl(fmaxl(0, r * r - beyond * beyond)));
  }
}

static void check_quadrature(const gjk_shape *shape, const quadrature *q, long double tolerance) {
  gjk_mass m;
  CHECK(gjk_mass_of_shape(shape, &m) == GJK_OK);
  const long double volume = ldexpl((long double)m.volume.high, 64) + (long double)m.volume.low;
  CHECK_MSG(fabsl(volume - q->volume) <= tolerance * q->volume + 0.51L, "volume %Lg, %Lg", volume, q->volume);
  const int64_t inertia[3] = {m.inertia.xx, m.inertia.yy, m.inertia.zz};
  for (int i = 0; i < 3; i++) {
    const long double own = (q->square[(i + 1) % 3] + q->square[(i + 2) % 3]) / q->volume;
    CHECK_MSG(fabsl((long double)inertia[i] - own) <= tolerance * own + 0.51L, "inertia %d: %lld, %Lg", i,
              (long long)inertia[i], own);
  }
  CHECK(m.inertia.yz == 0 && m.inertia.zx == 0 && m.inertia.xy == 0);
  CHECK(m.centre.x == 0 && m.centre.y == 0 && m.centre.z == 0);
}

static void test_quadrature(void) {
  static const int32_t boxes[][4] = {{100000, 50000, 30000, 20000},
                                     {7, 0, 9, 100000},
                                     {0, 0, 0, 65536},
                                     {100000000, 90000000, 30000000, 60000000},
                                     {5000, 100000, 0, 3000}};
  static const int32_t cylinders[][3] = {
      {65536, 100000, 3000}, {90000000, 40000000, 100000000}, {0, 5, 70000}, {100000, 0, 2000}, {100000, 0, 200000}};
  for (unsigned i = 0; i < sizeof boxes / sizeof boxes[0]; i++) {
    const int32_t *b = boxes[i];
    const long double half[3] = {b[0], b[1], b[2]};
    const gjk_shape shape = GJK_ROUNDED_BOX(b[0], b[1], b[2], b[3]);
    quadrature q = {0, {0, 0, 0}};
    check_trial(i, NULL, NULL);
    integrate_box(&q, half, b[3]);
    check_quadrature(&shape, &q, 1e-5L);
  }
  for (unsigned i = 0; i < sizeof cylinders / sizeof cylinders[0]; i++) {
    const int32_t *c = cylinders[i];
    const gjk_shape shape = GJK_ROUNDED_CYLINDER(c[0], c[1], c[2]);
    quadrature q = {0, {0, 0, 0}};
    check_trial(100 + i, NULL, NULL);
    integrate_cylinder(&q, c[0], c[1], c[2]);
    check_quadrature(&shape, &q, 1e-5L);
  }
}

// The correctly rounded values of closed forms, in long double: within 0.51 where that resolves them.
static void test_closed_forms(void) {
  const long double pi = acosl(-1.0L);
  random_state random = {8};
  for (unsigned trial = 0; trial < 300; trial++) {
    const int32_t a = 1 + (int32_t)random_below(&random, 1u << 15), b = 1 + (int32_t)random_below(&random, 1u << 15),
                  c = 1 + (int32_t)random_below(&random, 1u << 15);
    gjk_mass m;
    check_trial(trial, NULL, NULL);
    const gjk_shape shape[3] = {GJK_CYLINDER(a, c), GJK_CONE(a, c), GJK_ELLIPSOID(a, b, c)};
    const long double volume[3] = {2 * pi * a * a * c, 2 * pi * a * a * c / 3, 4 * pi * a * b * c / 3};
    const long double x[3] = {(long double)a * a / 4, 3.0L * a * a / 20, (long double)a * a / 5};
    const long double y[3] = {x[0], x[1], (long double)b * b / 5};
    const long double z[3] = {(long double)c * c / 3, 3.0L * c * c / 20, (long double)c * c / 5};
    for (int i = 0; i < 3; i++) {
      CHECK(gjk_mass_of_shape(&shape[i], &m) == GJK_OK);
      CHECK(m.volume.high == 0 && fabsl((long double)m.volume.low - volume[i]) <= 0.51L);
      CHECK(fabsl((long double)m.inertia.xx - (y[i] + z[i])) <= 0.501L);
      CHECK(fabsl((long double)m.inertia.yy - (z[i] + x[i])) <= 0.501L);
      CHECK(fabsl((long double)m.inertia.zz - (x[i] + y[i])) <= 0.501L);
      CHECK(m.centre.x == 0 && m.centre.y == 0);
      CHECK(m.centre.z * INT64_C(65536) + m.fraction[2] == (i == 1 ? -c * INT64_C(32768) : 0));
    }
  }
  // The largest ball: its volume within 2^-60.
  const gjk_shape ball = GJK_SPHERE(GJK_RADIUS_MAX);
  gjk_mass m;
  CHECK(gjk_mass_of_shape(&ball, &m) == GJK_OK);
  const long double r = GJK_RADIUS_MAX, largest = ldexpl((long double)m.volume.high, 64) + (long double)m.volume.low;
  CHECK(fabsl(largest / (4 * pi / 3 * r * r * r) - 1) < 1e-18L);
  CHECK(fabsl((long double)m.inertia.zz - 2 * r * r / 5) <= 0.51L);
}

static void user_support(const void *user, const gjk_vec3 *direction, gjk_vec3 *point) {
  (void)user;
  (void)direction;
  (void)point;
}

static gjk_status status_of(const gjk_shape *shape) {
  gjk_mass m, kept;
  memset(&m, 0x5A, sizeof m);
  kept = m;
  const gjk_status status = gjk_mass_of_shape(shape, &m);
  CHECK(status == GJK_OK || memcmp(&m, &kept, sizeof m) == 0);
  return status;
}

static void test_statuses(void) {
  static const gjk_vec3 v[5] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}, {18, 0, 0}};
  static const uint16_t corner[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, end[4] = {3, 6, 9, 12};
  static const uint16_t inward[12] = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}, line[6] = {0, 1, 4, 0, 4, 1};
  const gjk_hull_faces faces = {corner, end, 4}, turned = {inward, end, 4}, in_line = {line, end, 2};
  gjk_mass m;
  gjk_shape shape = GJK_HULL_WITH_FACES(v, 4, &faces);
  CHECK(status_of(&shape) == GJK_OK);
  CHECK(gjk_mass_of_shape(NULL, &m) == GJK_ERROR_NULL && gjk_mass_of_shape(&shape, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_mass_of_hull(NULL, &m) == GJK_ERROR_NULL && gjk_mass_set_density(NULL, 1) == GJK_ERROR_NULL);
  shape.faces = &turned;
  CHECK(status_of(&shape) == GJK_ERROR_RANGE);
  shape.faces = &in_line;
  shape.count = 5;
  CHECK(status_of(&shape) == GJK_ERROR_RANGE);
  shape.faces = NULL;
  CHECK(status_of(&shape) == GJK_ERROR_UNSUPPORTED);
  shape.count = 3;
  CHECK(status_of(&shape) == GJK_OK);
  shape.convex_radius = 1;
  CHECK(status_of(&shape) == GJK_OK);
  shape.count = 5;
  CHECK(status_of(&shape) == GJK_ERROR_UNSUPPORTED);
  shape.count = 3;
  shape.convex_radius = -1;
  CHECK(status_of(&shape) == GJK_ERROR_NEGATIVE);
  shape.convex_radius = 0;
  shape.count = 0;
  CHECK(status_of(&shape) == GJK_ERROR_EMPTY);
  shape.type = NULL;
  CHECK(status_of(&shape) == GJK_ERROR_NULL);
  const gjk_shape unsupported[2] = {GJK_ROUNDED_ELLIPSOID(1, 2, 3, 1), GJK_CUSTOM(user_support, NULL, 5)};
  for (int i = 0; i < 2; i++) {
    CHECK(status_of(&unsupported[i]) == GJK_ERROR_UNSUPPORTED);
  }
  const gjk_shape large = GJK_ROUNDED_BOX(GJK_RADIUS_MAX, 0, 0, 1), ball = GJK_SPHERE(GJK_RADIUS_MAX);
  CHECK(status_of(&large) == GJK_ERROR_SIZE && status_of(&ball) == GJK_OK);
}

// Points, rods, laminas: of three vertices in a line the two ends count.
static void test_flat(void) {
  static const gjk_vec3 line[3] = {{6, 6, 6}, {0, 0, 0}, {2, 2, 2}}, triangle[3] = {{0, 0, 7}, {12, 0, 7}, {0, 12, 7}};
  const gjk_shape point = GJK_POINT, rod = GJK_HULL(line, 3), pair = GJK_HULL(line, 2), one = GJK_HULL(line, 1),
                  lamina = GJK_TRIANGLE(triangle), disc = GJK_CYLINDER(20, 0);
  gjk_mass m, other;
  CHECK(gjk_mass_of_shape(&point, &m) == GJK_OK && m.volume.low == 0 && m.inertia.xx == 0 && m.inertia.xy == 0);
  CHECK(gjk_mass_of_shape(&rod, &m) == GJK_OK && m.centre.x == 3 && m.fraction[0] == 0 && m.inertia.xx == 6);
  CHECK(m.inertia.yz == -3 && m.volume.low == 0);
  CHECK(gjk_mass_of_shape(&pair, &other) == GJK_OK && same(&m, &other));
  CHECK(gjk_mass_of_shape(&one, &m) == GJK_OK && m.centre.z == 6 && m.inertia.xx == 0);
  CHECK(gjk_mass_of_shape(&lamina, &m) == GJK_OK && m.centre.x == 4 && m.centre.z == 7);
  CHECK(m.inertia.xx == 8 && m.inertia.yy == 8 && m.inertia.zz == 16 && m.inertia.xy == 4);
  CHECK(gjk_mass_of_shape(&disc, &m) == GJK_OK && m.inertia.xx == 100 && m.inertia.zz == 200 && m.volume.low == 0);
}

static void test_density(void) {
  const gjk_shape cube = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5)),
                  large = GJK_BOX(GJK_Q16(2000.0), GJK_Q16(2000.0), GJK_Q16(2000.0));
  gjk_mass m;
  CHECK(gjk_mass_of_shape(&cube, &m) == GJK_OK && m.volume.low == UINT64_C(1) << 48 && m.volume.high == 0);
  CHECK(gjk_mass_set_density(&m, GJK_Q16(700.0)) == GJK_OK && m.mass == GJK_Q16(700.0));
  CHECK(gjk_mass_set_density(&m, UINT32_MAX) == GJK_OK && m.mass == UINT32_MAX);
  m.volume.low++;
  CHECK(gjk_mass_set_density(&m, UINT32_MAX) == GJK_OK && m.mass == UINT32_MAX);
  m.volume.low = (UINT64_C(1) << 48) + (UINT64_C(1) << 15) - 1;  // half an LSB more, but for little
  CHECK(gjk_mass_set_density(&m, UINT32_MAX) == GJK_OK && m.mass == UINT32_MAX);
  m.volume.low += 2;
  CHECK(gjk_mass_set_density(&m, UINT32_MAX) == GJK_ERROR_RANGE && m.mass == UINT32_MAX);
  m.volume.low = UINT64_C(1) << 47;
  CHECK(gjk_mass_set_density(&m, 1) == GJK_OK && m.mass == 1);
  m.volume.low--;
  CHECK(gjk_mass_set_density(&m, 1) == GJK_OK && m.mass == 0);
  CHECK(gjk_mass_of_shape(&large, &m) == GJK_OK && gjk_mass_set_density(&m, 1) == GJK_ERROR_RANGE);
  m.volume.high = UINT64_MAX;
  CHECK(gjk_mass_set_density(&m, UINT32_MAX) == GJK_ERROR_RANGE);
}

int main(void) {
  const uint64_t seed = check_seed(4711);
  test_random_hulls(seed);
  test_extremes();
  test_agreement();
  test_quadrature();
  test_closed_forms();
  test_statuses();
  test_flat();
  test_density();
  return check_done("mass");
}
