// The plane: hulls, the check of outlines, mass properties of shapes and of bodies of several parts.
#include <math.h>

#include "check.h"
#include "exact/integer.h"
#include "gjk2/hull.h"
#include "gjk2/mass.h"
#include "gjk2/polygon.h"
#include "gjk2/pose.h"
#include "random.h"

typedef long double real;

#define MOST 64

static gjk2_vec point[MOST], corner[MOST];
static unsigned points;

static void print_points(const void *subject) {
  (void)subject;
  for (unsigned i = 0; i < points; i++) {
    printf("%ld %ld\n", (long)point[i].x, (long)point[i].y);
  }
}

// Triangles from the frame's origin, which may be far outside: any int32_t.
static void check_polygon(const gjk2_hull *hull) {
  const gjk2_shape shape = GJK2_POLYGON(corner, hull->vertices);
  gjk2_mass m;
  const gjk_status status = gjk2_mass_of_shape(&shape, &m);
  CHECK_MSG(status == GJK_OK || status == GJK_ERROR_SIZE, "status %d", status);
  if (status != GJK_OK || hull->dimension < 2) {
    CHECK(status != GJK_OK || m.area == 0);
    return;
  }
  exact_int s = exact_from(0), f[2] = {exact_from(0), exact_from(0)}, q = exact_from(0);
  for (unsigned i = 0; i < hull->vertices; i++) {
    const gjk2_vec a = corner[i], b = corner[(i + 1) % hull->vertices];
    exact_int w = exact_product(a.x, b.y), x = exact_from((int64_t)a.x + b.x), y = exact_from((int64_t)a.y + b.y),
              v = exact_mul(&x, &x);
    const exact_int minus = exact_product(a.y, b.x);
    w = exact_sub(&w, &minus);
    exact_add_to(&s, w);
    exact_add_to(&f[0], exact_mul(&w, &x));
    exact_add_to(&f[1], exact_mul(&w, &y));
    exact_add_to(&v, exact_mul(&y, &y));
    exact_add_to(&v, exact_product(a.x, a.x));
    exact_add_to(&v, exact_product(a.y, a.y));
    exact_add_to(&v, exact_product(b.x, b.x));
    exact_add_to(&v, exact_product(b.y, b.y));
    exact_add_to(&q, exact_mul(&w, &v));
  }
  const exact_int two = exact_from(2), three = exact_from(3), four = exact_from(4), n36 = exact_from(36);
  exact_int all = exact_mul(&s, &three), whole = exact_mul(&s, &s), inertia = exact_mul(&s, &q);
  whole = exact_mul(&whole, &n36);
  inertia = exact_mul(&inertia, &three);
  for (int i = 0; i < 2; i++) {
    exact_int square = exact_mul(&f[i], &f[i]);
    square = exact_mul(&square, &four);
    inertia = exact_sub(&inertia, &square);
  }
  const exact_int twice = exact_from((int64_t)hull->twice_area);
  CHECK(exact_compare(&s, &twice) == 0);
  CHECK(exact_is_rounded((int64_t)m.area, s, two, 1, 1));
  CHECK(exact_is_rounded(m.centre.x, f[0], all, 1, 1) && exact_is_rounded(m.centre.y, f[1], all, 1, 1));
  CHECK(exact_is_rounded(m.centre.x * INT64_C(65536) + m.fraction[0], f[0], all, 65536, 0));
  CHECK(exact_is_rounded(m.centre.y * INT64_C(65536) + m.fraction[1], f[1], all, 65536, 0));
  CHECK(exact_is_rounded(m.inertia, inertia, whole, 1, 1));
  CHECK(m.mass == 0);
}

// No point is to the right of an edge, each corner is one of the points, and the outline is sound.
static void check_build(const gjk2_hull *hull) {
  gjk2_hull_report report;
  CHECK(gjk2_hull_check(corner, hull->vertices, &report) == GJK_OK);
  CHECK(report.fault == (hull->dimension == 2 ? GJK2_HULL_SOUND : GJK2_HULL_FEW) && report.vertex == 0);
  CHECK(hull->dimension == (hull->vertices > 2 ? 2 : hull->vertices - 1) &&
        (hull->twice_area > 0) == (hull->dimension == 2));
  for (unsigned i = 0; i < hull->vertices; i++) {
    const gjk2_vec a = corner[i], b = corner[(i + 1) % hull->vertices];
    bool is_point = false;
    for (unsigned j = 0; j < points; j++) {
      const gjk2_vec p = point[j];
      CHECK(((int64_t)b.x - a.x) * ((int64_t)p.y - a.y) - ((int64_t)b.y - a.y) * ((int64_t)p.x - a.x) >= 0);
      is_point = is_point || (p.x == a.x && p.y == a.y);
    }
    CHECK(is_point);
  }
}

// An outline with one change is no longer sound, and the fault is named.
static void check_faults(random_state *random, const gjk2_hull *hull) {
  gjk2_vec v[MOST + 1];
  gjk2_hull_report report;
  const unsigned n = hull->vertices, at = random_below(random, n);
  for (unsigned i = 0; i < n; i++) {  // clockwise
    v[i] = corner[n - 1 - i];
  }
  CHECK(gjk2_hull_check(v, (uint16_t)n, &report) == GJK_OK && report.fault == GJK2_HULL_TURN && report.vertex == 0);
  for (unsigned i = 0; i < n; i++) {  // once more
    v[i + (i > at)] = corner[i];
  }
  v[at + 1] = corner[at];
  CHECK(gjk2_hull_check(v, (uint16_t)(n + 1), &report) == GJK_OK && report.fault == GJK2_HULL_REPEATED);
  CHECK(report.vertex == at + 1);
  const gjk2_vec a = corner[at], b = corner[(at + 1) % n];
  if (((int64_t)a.x + b.x) % 2 == 0 && ((int64_t)a.y + b.y) % 2 == 0) {
    v[at + 1].x = (int32_t)(((int64_t)a.x + b.x) / 2);
    v[at + 1].y = (int32_t)(((int64_t)a.y + b.y) / 2);
    CHECK(gjk2_hull_check(v, (uint16_t)(n + 1), &report) == GJK_OK && report.fault == GJK2_HULL_STRAIGHT);
    CHECK(report.vertex == at + 1);
  }
  const gjk2_shape shape = GJK2_POLYGON(v, (uint16_t)(n + 1));
  gjk2_mass m;
  const gjk_status status = gjk2_mass_of_shape(&shape, &m);
  CHECK(status == GJK_ERROR_UNSUPPORTED || status == GJK_ERROR_SIZE);
}

static void test_random(uint64_t seed) {
  random_state random = random_seed(seed);
  unsigned dimensions[3] = {0, 0, 0};
  for (unsigned long trial = 0; trial < 20000; trial++) {
    const int32_t size = INT32_C(1) << random_below(&random, 28), thick = size >> random_below(&random, 12);
    const int32_t at_x = random_range(&random, INT32_MIN + size, INT32_MAX - size),
                  at_y = random_range(&random, INT32_MIN + size + thick, INT32_MAX - size - thick),
                  slope = random_range(&random, -1, 1);
    points = 1 + random_below(&random, 20);
    check_trial(trial, print_points, NULL);
    for (unsigned i = 0; i < points; i++) {
      const int32_t x = random_range(&random, -size, size);
      point[i].x = at_x + x;
      point[i].y = at_y + slope * x + (trial % 4 == 0 ? 0 : random_range(&random, -thick, thick));
    }
    gjk2_hull hull;
    const gjk_status status = gjk2_hull_build(point, (uint16_t)points, corner, &hull);
    CHECK(status == GJK_OK);
    if (status == GJK_OK) {
      check_build(&hull);
      check_polygon(&hull);
      if (hull.dimension == 2) {
        check_faults(&random, &hull);
      }
      dimensions[hull.dimension]++;
    }
  }
  CHECK_MSG(dimensions[0] > 500 && dimensions[1] > 2000 && dimensions[2] > 10000, "%u %u %u", dimensions[0],
            dimensions[1], dimensions[2]);
}

static void test_outlines(void) {
  static const gjk2_vec star[5] = {{0, 100}, {-59, -81}, {95, 31}, {-95, 31}, {59, -81}},
                        spike[3] = {{0, 0}, {9, 0}, {3, 0}}, dent[5] = {{0, 0}, {9, 0}, {9, 9}, {5, 4}, {0, 9}},
                        far[2] = {{0, 0}, {INT32_MAX, 0}};
  gjk2_hull_report report = {9, 9};
  gjk2_hull hull = {9, 9, 9};
  gjk2_vec out[5];
  CHECK(gjk2_hull_check(star, 5, &report) == GJK_OK && report.fault == GJK2_HULL_LAYERS && report.vertex == 0);
  CHECK(gjk2_hull_check(spike, 3, &report) == GJK_OK && report.fault == GJK2_HULL_STRAIGHT && report.vertex == 0);
  CHECK(gjk2_hull_check(dent, 5, &report) == GJK_OK && report.fault == GJK2_HULL_TURN && report.vertex == 3);
  CHECK(gjk2_hull_check(dent, 2, &report) == GJK_OK && report.fault == GJK2_HULL_FEW);
  CHECK(gjk2_hull_check(NULL, 5, &report) == GJK_ERROR_NULL && gjk2_hull_check(dent, 5, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_hull_check(dent, 0, &report) == GJK_ERROR_EMPTY && gjk2_hull_check(far, 2, &report) == GJK_ERROR_SIZE);
  CHECK(gjk2_hull_build(NULL, 5, out, &hull) == GJK_ERROR_NULL &&
        gjk2_hull_build(dent, 5, NULL, &hull) == GJK_ERROR_NULL);
  CHECK(gjk2_hull_build(dent, 5, out, NULL) == GJK_ERROR_NULL &&
        gjk2_hull_build(dent, 0, out, &hull) == GJK_ERROR_EMPTY);
  CHECK(gjk2_hull_build(far, 2, out, &hull) == GJK_ERROR_SIZE && hull.vertices == 9);
  CHECK(gjk2_hull_build(dent, 5, out, &hull) == GJK_OK && hull.vertices == 4 && hull.twice_area == 162);
}

// A rounded box by the midpoint rule, with r sin(t) for what lies in the rounding.
static void integrate(int32_t a, int32_t b, int32_t r, real *area, real *inertia) {
  const int steps = 20000;
  const real quarter = acosl(-1.0L) / 2;
  *area = *inertia = 0;
  for (int i = 0; i < 2 * steps; i++) {
    const real t = (i - steps + 0.5L) * quarter / steps, beyond = i < steps ? 0 : r * sinl(t);
    const real x = i < steps ? (i + 0.5L) * a / steps : a + beyond,
               weight = i < steps ? (real)a / steps : r * cosl(t) * quarter / steps,
               half = b + sqrtl(fmaxl(0, (real)r * r - beyond * beyond));
    *area += 4 * weight * half;
    *inertia += 4 * weight * (half * x * x + half * half * half / 3);
  }
}

static void test_closed_forms(void) {
  static const int32_t size[][3] = {
      {100000, 5000, 30000}, {0, 0, 65536}, {70000, 0, 100}, {100000000, 150000000, 9000000}, {0, 9, 70000}};
  const real pi = acosl(-1.0L);
  random_state random = {3};
  gjk2_mass m;
  for (unsigned i = 0; i < sizeof size / sizeof size[0]; i++) {
    const gjk2_shape box = GJK2_ROUNDED_BOX(size[i][0], size[i][1], size[i][2]);
    real area, inertia;
    check_trial(i, NULL, NULL);
    integrate(size[i][0], size[i][1], size[i][2], &area, &inertia);
    CHECK(gjk2_mass_of_shape(&box, &m) == GJK_OK);
    CHECK_MSG(fabsl((real)m.area - area) <= 1e-7L * area + 0.51L, "%llu, %Lf", (unsigned long long)m.area, area);
    CHECK_MSG(fabsl((real)m.inertia - inertia / area) <= 1e-7L * inertia / area + 0.51L, "%lld, %Lf",
              (long long)m.inertia, inertia / area);
  }
  for (unsigned long trial = 0; trial < 1000; trial++) {
    const int32_t a = (int32_t)random_below(&random, 1u << (trial % 28)),
                  b = (int32_t)random_below(&random, 1u << (trial / 2 % 28));
    const gjk2_shape box = GJK2_BOX(a, b), ellipse = GJK2_ELLIPSE(a, b), segment = GJK2_SEGMENT(a),
                     disc = GJK2_CIRCLE(a), point_shape = GJK2_POINT;
    const real rest = 0.501L, squares = (real)a * a + (real)b * b;
    check_trial(trial, NULL, NULL);
    CHECK(gjk2_mass_of_shape(&box, &m) == GJK_OK && m.area == 4 * (uint64_t)a * (uint64_t)b);
    CHECK(fabsl((real)m.inertia - squares / 3) <= rest && m.centre.x == 0 && m.fraction[1] == 0);
    CHECK(gjk2_mass_of_shape(&ellipse, &m) == GJK_OK && fabsl((real)m.area - pi * a * b) <= 0.51L);
    CHECK(fabsl((real)m.inertia - squares / 4) <= rest);
    CHECK(gjk2_mass_of_shape(&segment, &m) == GJK_OK && m.area == 0 &&
          fabsl((real)m.inertia - (real)a * a / 3) <= rest);
    CHECK(gjk2_mass_of_shape(&disc, &m) == GJK_OK && fabsl((real)m.area - pi * a * a) <= 0.51L);
    CHECK(fabsl((real)m.inertia - (real)a * a / 2) <= rest);
    CHECK(gjk2_mass_of_shape(&point_shape, &m) == GJK_OK && m.area == 0 && m.inertia == 0);
  }
}

static void user_support(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  (void)user;
  (void)direction;
  (void)out;
}

static void test_refusals(void) {
  static const gjk2_vec v[4] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, line[3] = {{3, 3}, {0, 0}, {9, 9}},
                        turned[3] = {{0, 0}, {0, 9}, {9, 0}}, bent[4] = {{0, 0}, {9, 9}, {9, 0}, {0, 9}};
  const gjk2_shape refused[4] = {GJK2_ROUNDED_POLYGON(bent, 4, 1), GJK2_ROUNDED_ELLIPSE(1, 2, 3),
                                 GJK2_CUSTOM(user_support, NULL, 3), GJK2_POLYGON(bent, 4)};
  const gjk2_shape square = GJK2_POLYGON(v, 4), rod = GJK2_TRIANGLE(line), other = GJK2_TRIANGLE(turned),
                   none = GJK2_POLYGON(v, 0), large = GJK2_ROUNDED_BOX(GJK2_RADIUS_MAX, 0, 1),
                   negative = GJK2_BOX(-1, 0), minus = GJK2_CIRCLE(-1);
  gjk2_mass m, body = {0};
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  for (int i = 0; i < 4; i++) {
    CHECK(gjk2_mass_of_shape(&refused[i], &m) == GJK_ERROR_UNSUPPORTED);
  }
  gjk2_shape untyped = square;
  untyped.type = NULL;
  CHECK(gjk2_mass_of_shape(&untyped, &m) == GJK_ERROR_NULL);
  CHECK(gjk2_mass_of_shape(NULL, &m) == GJK_ERROR_NULL && gjk2_mass_of_shape(&square, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_mass_of_shape(&none, &m) == GJK_ERROR_EMPTY && gjk2_mass_of_shape(&large, &m) == GJK_ERROR_SIZE);
  CHECK(gjk2_mass_of_shape(&negative, &m) == GJK_ERROR_NEGATIVE &&
        gjk2_mass_of_shape(&minus, &m) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_mass_of_shape(&rod, &m) == GJK_OK && m.area == 0 && m.centre.x == 5 && m.fraction[0] == -32768 &&
        m.inertia == 14);
  CHECK(gjk2_mass_of_shape(&other, &m) == GJK_OK && m.area == 41 && m.centre.y == 3 && m.inertia == 9);
  CHECK(gjk2_mass_of_shape(&square, &m) == GJK_OK && m.area == 81 && m.inertia == 14);
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_RANGE && gjk2_mass_add(&m, &m, &pose) == GJK_ERROR_OVERLAP);
  m.mass = UINT32_MAX;
  CHECK(gjk2_mass_add(NULL, &m, &pose) == GJK_ERROR_NULL && gjk2_mass_add(&body, NULL, &pose) == GJK_ERROR_NULL);
  CHECK(gjk2_mass_add(&body, &m, NULL) == GJK_ERROR_NULL && gjk2_mass_set_density(NULL, 1) == GJK_ERROR_NULL);
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_OK && body.mass == UINT32_MAX && body.inertia == m.inertia &&
        body.area == 81);
  m.mass = 1;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_RANGE);
  body.mass--;
  pose.rotation.c = 0;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_ROTATION);
  pose.rotation.c = GJK_Q30_ONE;
  pose.position.x = (INT32_C(1) << 30) + 6;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_RANGE);
  pose.position.x = INT32_MAX - 4;
  body.centre.x = INT32_MAX;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_RANGE);
  pose.position.x--;
  m.inertia = -1;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_RANGE);
  const gjk2_mass kept = body;
  body.mass = 1;
  body.centre.x -= GJK_Q16(1000);
  m.inertia = body.inertia = INT64_C(1) << 60;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_ERROR_RANGE);  // each fits, not both with what is between them
  body = kept;
  m.inertia = 0;
  CHECK(gjk2_mass_add(&body, &m, &pose) == GJK_OK && body.mass == UINT32_MAX);
  m.area = UINT64_C(1) << 32;
  CHECK(gjk2_mass_set_density(&m, UINT32_MAX) == GJK_OK && m.mass == UINT32_MAX);
  m.area++;
  CHECK(gjk2_mass_set_density(&m, UINT32_MAX) == GJK_ERROR_RANGE && m.mass == UINT32_MAX);
  m.area = UINT64_C(1) << 31;
  CHECK(gjk2_mass_set_density(&m, 1) == GJK_OK && m.mass == 1);
  m.area--;
  CHECK(gjk2_mass_set_density(&m, 1) == GJK_OK && m.mass == 0);
  m.area = UINT64_MAX;
  CHECK(gjk2_mass_set_density(&m, UINT32_MAX) == GJK_ERROR_RANGE);
}

static void test_bodies(uint64_t seed) {
  random_state random = random_seed(seed + 5);
  for (unsigned long trial = 0; trial < 5000; trial++) {
    const int32_t reach = INT32_C(1) << random_below(&random, 29), size = INT32_C(1) << random_below(&random, 27);
    gjk2_mass body = {0};
    real mass = 0, first[2] = {0, 0}, second = 0, span = 2 * (real)reach + 4 * (real)size;
    int parts = 1 + (int)random_below(&random, 6);
    check_trial(trial, NULL, NULL);
    for (int i = 0; i < parts; i++) {
      const gjk2_vec v[3] = {
          {0, 0}, {1 + random_range(&random, 0, size), 0}, {size / 2, 1 + random_range(&random, 0, size)}};
      const gjk2_shape shape = GJK2_TRIANGLE(v);
      gjk2_mass part;
      gjk2_pose pose = GJK2_POSE_IDENTITY;
      CHECK(gjk2_mass_of_shape(&shape, &part) == GJK_OK);
      CHECK(gjk2_rotation_from_angle(random_range(&random, -300000, 300000), &pose.rotation) == GJK_OK);
      pose.position.x = random_range(&random, -reach, reach);
      pose.position.y = random_range(&random, -reach, reach);
      part.mass = 1 + random_below(&random, UINT32_C(1) << (1 + random_below(&random, 28)));
      CHECK(gjk2_mass_add(&body, &part, &pose) == GJK_OK);
      const real n = hypotl(pose.rotation.c, pose.rotation.s), c = pose.rotation.c / n, s = pose.rotation.s / n,
                 x = part.centre.x + part.fraction[0] / 65536.0L, y = part.centre.y + part.fraction[1] / 65536.0L,
                 at_x = c * x - s * y + pose.position.x, at_y = s * x + c * y + pose.position.y;
      mass += part.mass;
      first[0] += part.mass * at_x;
      first[1] += part.mass * at_y;
      second += part.mass * ((real)part.inertia + at_x * at_x + at_y * at_y);
    }
    const real x = first[0] / mass, y = first[1] / mass, inertia = second / mass - x * x - y * y;
    CHECK(fabsl(body.centre.x + body.fraction[0] / 65536.0L - x) <= parts * 0x1p-8L);
    CHECK(fabsl(body.centre.y + body.fraction[1] / 65536.0L - y) <= parts * 0x1p-8L);
    CHECK_MSG(fabsl((real)body.inertia - inertia) <= parts * (1 + 0x1p-7L * span), "%lld, %Lf", (long long)body.inertia,
              inertia);
    CHECK((real)body.mass == mass);
  }
}

int main(void) {
  const uint64_t seed = check_seed(99);
  test_random(seed);
  test_outlines();
  test_closed_forms();
  test_refusals();
  test_bodies(seed);
  return check_done("plane mass");
}
