// Depths that a formula gives: spheres, parallel capsules, boxes along the axes, points in boxes. Also arguments that
// are refused.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "exact/depth.h"
#include "generate/polytope.h"
#include "gjk/gjk.h"

#define SEED 6607
#define ITERATIONS ((int)check_trials(20000))

typedef struct subject {
  case_pair pair;
  case_collider a, b;
  gjk_penetration_result r;
} subject;

static void reset(subject *s) {
  case_shape_reset(&s->pair.a);
  case_shape_reset(&s->pair.b);
  s->pair.a.pose.position.x = 123456;
  s->pair.b.pose.position.x = 123456;
}

// Checks that the answer has the depth, rounded up, along the direction; depth < 0: that the shapes are apart. None of
// these pairs needs a workspace.
static void expect(subject *s, double depth, const char *what) {
  char why[200] = "";
  const bool answered = case_collider_build(&s->a, &s->pair.a, false) == GJK_OK &&
                        case_collider_build(&s->b, &s->pair.b, false) == GJK_OK &&
                        gjk_penetration(&s->a.collider, &s->b.collider, NULL, NULL, &s->r) == GJK_OK;
  CHECK_MSG(answered, "%s", what);
  if (!answered) {
    return;
  }
  const bool right = s->r.intersecting == (depth >= 0) && (depth < 0 || s->r.depth == (gjk_q16)ceil(depth));
  CHECK_MSG(right, "%s: depth %ld, not %.3f", what, s->r.intersecting ? (long)s->r.depth : -1, depth);
  CHECK_MSG(exact_check_penetration(&s->a.collider, &s->b.collider, &s->r, why, sizeof why), "%s: %s", what, why);
  if (!right) {
    case_print(stdout, &s->pair);
  }
}

static double length(gjk_vec3 v) {
  return sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
}

static void add(gjk_vec3 *v, gjk_vec3 by) {
  v->x += by.x;
  v->y += by.y;
  v->z += by.z;
}

// The depth of spheres is the sum of the radii less the distance of the centres. A double tells it from an integer
// unless it is within 2^-20 of one.
static void test_spheres(random_state *random, subject *s) {
  for (int i = 0; i < ITERATIONS; i++) {
    reset(s);
    s->pair.a.convex_radius = generate_reach(random);
    s->pair.b.convex_radius = generate_reach(random);
    const double sum = (double)s->pair.a.convex_radius + s->pair.b.convex_radius;
    const gjk_vec3 by = generate_vector(random, 1.1 * sum * generate_unit(random));
    const double depth = sum - length(by);
    add(&s->pair.b.pose.position, by);
    if (fabs(depth - nearbyint(depth)) > 1e-6) {
      expect(s, depth, "spheres");
    }
  }
}

static void test_concentric_spheres(subject *s) {
  reset(s);
  s->pair.a.convex_radius = 100;
  s->pair.b.convex_radius = 33;
  expect(s, 133, "concentric spheres");
  s->pair.b.pose.position.x += 133;
  expect(s, 0, "touching spheres");
  s->pair.b.pose.position.x += 1;
  expect(s, -1, "spheres apart");
}

// Parallel capsules, shifted along each other by less than both lengths. Their depth is that of the circles in section.
static void test_parallel_capsules(random_state *random, subject *s) {
  for (int i = 0; i < ITERATIONS; i++) {
    reset(s);
    s->pair.a.kind = s->pair.b.kind = CASE_SEGMENT;
    s->pair.a.size.z = generate_reach(random);
    s->pair.b.size.z = generate_reach(random);
    s->pair.a.convex_radius = generate_reach(random);
    s->pair.b.convex_radius = generate_reach(random);
    const int64_t fits = GJK_RADIUS_MAX - 8;
    if ((int64_t)s->pair.a.size.z + s->pair.a.convex_radius > fits ||
        (int64_t)s->pair.b.size.z + s->pair.b.convex_radius > fits) {
      continue;
    }
    const double sum = (double)s->pair.a.convex_radius + s->pair.b.convex_radius;
    gjk_vec3 by = generate_vector(random, sum * generate_unit(random));
    by.z = 0;
    const double depth = sum - length(by);
    const int64_t ends = (int64_t)s->pair.a.size.z + s->pair.b.size.z;
    by.z = (gjk_q16)(ends * 9 / 10 * random_range(random, -1, 1));
    add(&s->pair.b.pose.position, by);
    if (fabs(depth - nearbyint(depth)) > 1e-6) {
      expect(s, depth, "parallel capsules");
    }
  }
}

// Capsules that cross at right angles. Their depth is the sum of the radii less the height of one over the other.
static void test_crossing_capsules(subject *s) {
  static const gjk_quat quarter = {759250125, 0, 0, 759250125};
  for (gjk_q16 height = -7; height <= 7; height++) {
    reset(s);
    s->pair.a.kind = s->pair.b.kind = CASE_SEGMENT;
    s->pair.a.size.z = s->pair.b.size.z = 65536;
    s->pair.a.convex_radius = 4;
    s->pair.b.convex_radius = 2;
    s->pair.b.pose.rotation = quarter;
    s->pair.b.pose.position.x += height;
    expect(s, 6 - abs(height), "crossing capsules");
    s->pair.a.convex_radius = s->pair.b.convex_radius = 0;
    expect(s, height == 0 ? 0 : -1, "crossing segments");
  }
}

static int32_t least(int32_t a, int32_t b) {
  return a < b ? a : b;
}

// The depth is the smallest overlap along an axis. Convex radii add to it as long as the cores overlap.
static void test_boxes(random_state *random, subject *s) {
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_q16 most = generate_reach(random) / 3 + 2;
    case_shape *a = &s->pair.a, *b = &s->pair.b;
    reset(s);
    a->kind = b->kind = CASE_BOX;
    a->size.x = random_range(random, 0, most);
    a->size.y = random_range(random, 0, most);
    a->size.z = random_range(random, 0, most);
    b->size.x = random_range(random, 0, most);
    b->size.y = random_range(random, 0, most);
    b->size.z = random_range(random, 0, most);
    const gjk_vec3 by = {random_range(random, -most, most), random_range(random, -most, most),
                         random_range(random, -most, most)};
    add(&b->pose.position, by);
    const int32_t x = a->size.x + b->size.x - abs(by.x), y = a->size.y + b->size.y - abs(by.y);
    const int32_t z = a->size.z + b->size.z - abs(by.z), depth = least(x, least(y, z));
    expect(s, depth < 0 ? -1 : depth, "boxes");
    if (depth >= 0) {
      a->convex_radius = random_range(random, 0, 1000);
      b->convex_radius = random_range(random, 0, 1000);
      expect(s, depth + a->convex_radius + b->convex_radius, "rounded boxes");
    }
  }
}

static void test_sphere_in_box(random_state *random, subject *s) {
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_q16 half = generate_reach(random) / 3 + 2;
    reset(s);
    s->pair.a.kind = CASE_BOX;
    s->pair.a.size.x = s->pair.a.size.y = s->pair.a.size.z = half;
    s->pair.b.convex_radius = random_range(random, 0, half);
    const gjk_vec3 by = {random_range(random, -half, half), random_range(random, -half, half),
                         random_range(random, -half, half)};
    add(&s->pair.b.pose.position, by);
    expect(s, half - fmax(abs(by.x), fmax(abs(by.y), abs(by.z))) + s->pair.b.convex_radius, "sphere in box");
  }
}

// Refusals leave the output as it was. gjk_workspace_bytes agrees with GJK_EPA_CELLS.
static void test_refusals(subject *s) {
  gjk_penetration_result r, before;
  gjk_distance_result d;
  gjk_collider none = {0};
  reset(s);
  expect(s, 0, "points that coincide");
  const gjk_collider *a = &s->a.collider;
  memset(&r, 0x5A, sizeof r);
  before = r;
  CHECK(gjk_penetration(NULL, a, NULL, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_penetration(a, NULL, NULL, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_penetration(a, a, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_penetration(a, &none, NULL, NULL, &r) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_penetration(&none, a, NULL, NULL, &r) == GJK_ERROR_UNINITIALISED);
  CHECK(memcmp(&r, &before, sizeof r) == 0);
  CHECK(gjk_signed_distance(NULL, a, NULL, NULL, &d) == GJK_ERROR_NULL);
  CHECK(gjk_signed_distance(a, a, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_signed_distance(a, &none, NULL, NULL, &d) == GJK_ERROR_UNINITIALISED);
  for (uint16_t vertices = 4; vertices < 16000; vertices = (uint16_t)(vertices + 37)) {
    CHECK(gjk_workspace_bytes(vertices) == sizeof(gjk_epa_cell) * GJK_EPA_CELLS((size_t)vertices));
  }
}

int main(void) {
  static subject s;
  random_state random = random_seed(check_seed(SEED));
  test_spheres(&random, &s);
  test_concentric_spheres(&s);
  test_parallel_capsules(&random, &s);
  test_crossing_capsules(&s);
  test_boxes(&random, &s);
  test_sphere_in_box(&random, &s);
  test_refusals(&s);
  case_pair_free(&s.pair);
  case_collider_free(&s.a);
  case_collider_free(&s.b);
  return check_done("penetration-analytic");
}
