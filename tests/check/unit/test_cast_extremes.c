// Casts and times of impact at the ends of their ranges: the largest margins and spheres, ranges axis by axis, far shapes
// whose gap is the margin, hulls of more vertices than can be swept, the least and the largest turns.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/cast.h"
#include "gjk/check.h"
#include "gjk/distance.h"
#include "gjk/impact.h"
#include "placed.h"
#include "random.h"

#define SEED 3310

static gjk_vec3 vec(int32_t x, int32_t y, int32_t z) {
  return (gjk_vec3){x, y, z};
}

// One component alone.
static gjk_vec3 along(int axis, int32_t x) {
  return vec(axis == 0 ? x : 0, axis == 1 ? x : 0, axis == 2 ? x : 0);
}

static gjk_status cast(const gjk_collider *a, const gjk_collider *b, gjk_vec3 to, gjk_q16 margin, gjk_cast_result *r) {
  const gjk_cast_path path = {NULL, &to, margin};
  memset(r, 0, sizeof *r);
  const gjk_status status = gjk_cast(a, b, &path, r);
  if (status == GJK_OK) {
    const gjk_status checked = gjk_check_cast(a, b, &path, r);
    CHECK(checked == GJK_OK || checked == GJK_ERROR_UNSUPPORTED);
  }
  return status;
}

// The sum of radii and margin does not fit int32, and everything in reach is inside.
static void test_largest(void) {
  const gjk_shape ball = GJK_SPHERE(GJK_RADIUS_MAX);
  static const int32_t apart[] = {0, 1, 1 << 20, 1 << 28, (1 << 29) + 5, 1 << 30, INT32_MAX};
  gjk_cast_result r;
  for (int axis = 0; axis < 3; axis++) {
    for (unsigned i = 0; i < sizeof apart / sizeof apart[0]; i++) {
      const gjk_collider a = placed(&ball, along(axis, 0)), b = placed(&ball, along(axis, apart[i]));
      CHECK(cast(&a, &b, along(axis, -5), INT32_MAX, &r) == GJK_OK && r.hit && r.inside && r.fraction == 0);
      CHECK(cast(&a, &b, along(axis, apart[i]), INT32_MAX, &r) == GJK_OK && r.hit && r.inside);
    }
    // As far apart as the world allows, towards each other: met at 2^32 - 1 - (2^31 - 1 + both radii).
    const gjk_collider a = placed(&ball, along(axis, INT32_MIN)), b = placed(&ball, along(axis, INT32_MAX));
    CHECK(cast(&a, &b, along(axis, INT32_MIN), INT32_MAX, &r) == GJK_OK && r.hit && !r.inside);
    const double expected = (2147483648.0 - 2.0 * GJK_RADIUS_MAX) / 4294967295.0 * GJK_Q30_ONE;
    CHECK_MSG((double)r.fraction <= expected + 1 && (double)r.fraction >= expected - 300, "%ld of %f", (long)r.fraction,
              expected);
  }
}

// The way of one against the other is 2^32 LSB along one axis; the centre leaves int32 along one.
static void test_ranges(void) {
  const gjk_shape ball = GJK_SPHERE(100);
  static const gjk_vec3 corners[3] = {{1000, 1000, 1000}, {2000, 1500, 1300}, {1100, 2400, 2000}};
  const gjk_shape off = GJK_TRIANGLE(corners);
  for (int axis = 0; axis < 3; axis++) {
    const gjk_vec3 low = along(axis, INT32_MIN), high = along(axis, INT32_MAX);
    const gjk_collider a = placed(&ball, high), b = placed(&ball, low), t = placed(&off, along(axis, 0));
    const gjk_cast_path apart = {&low, &high, 0};
    gjk_cast_result r;
    CHECK(gjk_cast(&a, &b, &apart, &r) == GJK_ERROR_RANGE && gjk_check_cast(&a, &b, &apart, &r) == GJK_ERROR_RANGE);
    const gjk_cast_path out = {NULL, &high, 0};
    CHECK(gjk_cast(&b, &t, &out, &r) == GJK_ERROR_RANGE);
    // Of an impact the centre may leave int32 whatever the rotation, at either end.
    const gjk_impact_setup setup = {0, 100000, 0};
    gjk_motion still = {0}, away;
    gjk_impact_result impact;
    still.from.rotation.w = still.to.rotation.w = GJK_Q30_ONE;
    away = still;
    for (int end = 0; end < 4; end++) {
      gjk_pose *pose = end < 2 ? &away.from : &away.to;
      pose->position = along(axis, end % 2 == 0 ? INT32_MAX - 900 : INT32_MIN + 900);
      CHECK(gjk_time_of_impact(&a, &still, &t, &away, &setup, &impact) == GJK_ERROR_RANGE);
      CHECK(gjk_time_of_impact(&t, &away, &a, &still, &setup, &impact) == GJK_ERROR_RANGE);
      pose->position = along(axis, 0);
    }
  }
}

// Far shapes whose gap is the margin, to an LSB: decided to within 2^-28 of the distance, and a fraction 0 otherwise.
static void test_far_starts(void) {
  random_state random = random_seed(check_seed(SEED));
  const gjk_shape ball = GJK_SPHERE(7), plate = GJK_BOX(100000000, 90000000, 3);
  const unsigned long trials = check_trials(4000);
  unsigned long inside = 0, later = 0, missed = 0;
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    const bool flat = random_below(&random, 2) == 0;
    const int32_t margin = random_range(&random, 1 << 29, INT32_MAX - 1000), radii = flat ? 7 + 3 : 14;
    const int32_t most = (int32_t)(1u << random_below(&random, 24));
    const int64_t gap =
        (int64_t)margin + random_range(&random, -20, 20) + (i % 4 == 0 ? random_range(&random, 0, most) : 0);
    const int64_t z = gap + radii, half = z / 2;
    const gjk_collider a = placed(flat ? &plate : &ball, vec(5, 7, (int32_t)(half - z))),
                       b = placed(&ball, vec(5, 7, (int32_t)half));
    gjk_cast_result r;
    const int32_t way = random_range(&random, 1, 1 << (3 + random_below(&random, 24)));
    CHECK(cast(&a, &b, vec(5, 7, (int32_t)half - way), margin, &r) == GJK_OK);
    const int64_t error = (z >> 28) + 1;
    CHECK(gap > margin - error || (r.hit && r.inside));
    CHECK(gap < margin + error || !r.hit || !r.inside);
    CHECK(gap - way > margin - error || r.hit);
    CHECK(gap - way < margin + error + 2 || !r.hit);
    inside += r.hit && r.inside;
    later += r.hit && !r.inside;
    missed += !r.hit;
    if (r.hit && !r.inside) {
      // No contact before, and 2^-24 of the margin at most too early.
      const double at = (double)gap - (double)r.fraction / GJK_Q30_ONE * way;
      CHECK_MSG(at >= (double)margin - (double)error && at <= (double)margin * (1 + 0x1p-24) + 3, "%f", at - margin);
    }
  }
  printf("far: %lu inside, %lu later, %lu missed\n", inside, later, missed);
  CHECK(trials < 500 || (inside > trials / 10 && later > trials / 10 && missed > trials / 100));
}

// A ball that ends beside another, about the largest margin away, from the other end of the world: met where Pythagoras tells,
// but for the 8 LSB of a far frame's steps.
static void test_beside(void) {
  const gjk_shape ball = GJK_SPHERE(7);
  const int32_t half = INT32_C(1) << 30, margin = INT32_MAX - 1000;
  for (int axis = 0; axis < 3; axis++) {
    for (int32_t less = 900; less <= 1100; less++) {  // than 2^31 LSB to the side
      gjk_vec3 at = along(axis, INT32_MAX), from = along(axis, INT32_MIN), to = along(axis, INT32_MAX);
      gjk_q16 *const side = axis == 0 ? &at.y : &at.x, *const of_b = axis == 0 ? &from.y : &from.x;
      *side = -half;
      *of_b = (axis == 0 ? &to.y : &to.x)[0] = half - less;
      const gjk_collider a = placed(&ball, at), b = placed(&ball, from);
      const double beside = 2147483648.0 - less, reach = margin + 14.0;
      gjk_cast_result r;
      CHECK(cast(&a, &b, to, margin, &r) == GJK_OK && (fabs(beside - reach) < 9 || r.hit == (beside <= reach)));
      const double before = 4294967295.0 * (1 - (double)r.fraction / GJK_Q30_ONE), gap = hypot(beside, before) - reach;
      CHECK_MSG(!r.hit || (gap >= -9 && gap <= margin * 0x1p-24 + 6), "%ld less: %f", (long)less, gap);
    }
  }
}

// A hull of 32,768 vertices has no swept shape in 16 bits: what it hits is not proven by one.
static void test_many_vertices(void) {
  enum { MANY = 32768 };
  gjk_vec3 *vertices = malloc(MANY * sizeof *vertices);
  const gjk_shape hull = GJK_ROUNDED_HULL(vertices, MANY, 50), ball = GJK_SPHERE(40);
  gjk_cast_result r;
  CHECK(vertices != NULL);
  for (int32_t i = 0; i < MANY; i++) {
    vertices[i] = vec(i % 181 - 90, i / 181 - 90, (i & 1) != 0 ? 100 : -100);
  }
  const gjk_collider a = placed(&ball, vec(0, 0, 0)), b = placed(&hull, vec(1000, 0, 0)),
                     far = placed(&ball, vec(1000, 0, 0));
  const gjk_vec3 to = vec(-1000, 3, 0);
  const gjk_cast_path path = {NULL, &to, 0};
  CHECK(gjk_cast(&a, &b, &path, &r) == GJK_OK && r.hit && !r.inside);
  CHECK(gjk_check_cast(&a, &b, &path, &r) == GJK_ERROR_UNSUPPORTED);
  // As A it stands, and only B is swept.
  const gjk_collider stands = placed(&hull, vec(0, 0, 0));
  CHECK(gjk_cast(&stands, &far, &path, &r) == GJK_OK && r.hit && gjk_check_cast(&stands, &far, &path, &r) == GJK_OK);
  free(vertices);
}

// Ways that what B sweeps can be a shape of, and ways an LSB or few longer: 2^30 - 2^18 with twice both core radii.
static void test_longest_sweep(void) {
  const gjk_shape ball = GJK_SPHERE(100);
  const int32_t longest = (INT32_C(1) << 30) - (INT32_C(1) << 18);
  for (int32_t beside = 150; beside <= 250; beside += 100) {
    for (int32_t less = 0; less <= 64; less += 32) {
      const int32_t half = (longest - less) / 2;
      const gjk_collider a = placed(&ball, vec(0, 0, 0)), b = placed(&ball, vec(-half, beside, 0));
      const gjk_vec3 to = vec(half, beside, 0);
      const gjk_cast_path path = {NULL, &to, 0};
      gjk_cast_result r;
      CHECK(gjk_cast(&a, &b, &path, &r) == GJK_OK && r.hit == (beside < 200));
      const gjk_status checked = gjk_check_cast(&a, &b, &path, &r);
      CHECK_MSG(checked == (less == 0 && r.hit ? GJK_ERROR_UNSUPPORTED : GJK_OK), "%ld less: %s", (long)less,
                gjk_status_name(checked));
    }
  }
}

// The least arcs, and spins of INT32_MIN: poses are near the motion in real numbers, and impacts of balls do not mind.
static void test_turns(void) {
  for (int axis = 0; axis < 3; axis++) {
    for (int32_t sine = -5; sine <= 5; sine++) {
      gjk_motion m = {0};
      gjk_pose pose;
      m.from.rotation.w = m.to.rotation.w = GJK_Q30_ONE;
      (axis == 0 ? &m.to.rotation.x : axis == 1 ? &m.to.rotation.y : &m.to.rotation.z)[0] = sine;
      CHECK(gjk_motion_pose(&m, GJK_Q30_ONE / 2, &pose) == GJK_OK);
      const gjk_quat *q = &pose.rotation;
      CHECK(abs(q->x) + abs(q->y) + abs(q->z) <= abs(sine) / 2 + 8 && q->w >= GJK_Q30_ONE - 4);
    }
    const gjk_shape ball = GJK_SPHERE(65536);
    const gjk_collider a = placed(&ball, vec(0, 0, 0)), b = placed(&ball, vec(0, 0, 0));
    const gjk_impact_setup setup = {0, GJK_IMPACT_TOLERANCE_MIN, 0};
    gjk_motion still = {0}, spins;
    gjk_impact_result r;
    still.from.rotation.w = still.to.rotation.w = GJK_Q30_ONE;
    spins = still;
    spins.from.position = vec(4 * 65536, 0, 0);
    spins.to.position = vec(-4 * 65536, 0, 0);
    spins.spin = along(axis, INT32_MIN);
    CHECK(gjk_time_of_impact(&a, &still, &b, &spins, &setup, &r) == GJK_OK && r.hit && !r.overlap);
    CHECK(r.lower <= GJK_Q30_ONE / 4 && r.lower > GJK_Q30_ONE / 4 - 60000);
  }
}

int main(void) {
  test_largest();
  test_ranges();
  test_far_starts();
  test_beside();
  test_many_vertices();
  test_longest_sweep();
  test_turns();
  return check_done("cast_extremes");
}
