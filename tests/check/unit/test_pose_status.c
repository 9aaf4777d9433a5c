// Quaternions and poses at the limits of what is accepted, and beyond: statuses, and outputs that stay as they were.
#include "check.h"
#include "gjk/pose.h"
#include "same.h"

#define ONE GJK_Q30_ONE

// The tolerance is exact to the last unit.
static void test_tolerance(void) {
  // |q|^2 = 2^60 + 2^44, and with 255^2 + 22^2 + 5^2 + 1 = 65535: 2^60 - 2^44.
  const gjk_q30 u = INT32_C(1) << 22;
  const gjk_quat inside[4] = {
      {u, 0, 0, ONE}, {0, -u, 0, -ONE}, {255 * u, 22 * u, 5 * u, u}, {-u, 255 * u, 5 * u, 22 * u}};
  const gjk_quat outside[4] = {
      {u, 1, 0, ONE}, {0, -u - 1, 0, -ONE}, {255 * u, 22 * u, 5 * u, u - 1}, {1 - u, 255 * u, 5 * u, 22 * u}};
  for (int i = 0; i < 4; i++) {
    gjk_quat q;
    CHECK_MSG(gjk_quat_invert(&inside[i], &q) == GJK_OK, "%d", i);
    CHECK_MSG(gjk_quat_invert(&outside[i], &q) == GJK_ERROR_ROTATION, "%d", i);
  }
}

// Every call that takes a rotation refuses one that is no unit, and leaves its output as it was.
static void test_bad_rotations(void) {
  const gjk_quat good = {0, 0, 0, ONE};
  const gjk_quat bad[6] = {{0, 0, 0, 0},
                           {0, 0, 0, ONE - 16384},
                           {0, 0, 0, ONE + 16384},
                           {1, 2, 3, 4},
                           {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN},
                           {INT32_MAX, INT32_MIN, 0, INT32_MAX}};
  const gjk_vec3 v = {1, 2, 3};
  for (int i = 0; i < 6; i++) {
    const gjk_pose bad_pose = {{4, 5, 6}, bad[i]}, good_pose = {{4, 5, 6}, good};
    gjk_quat q = {7, 8, 9, 10};
    gjk_vec3 u = {7, 8, 9};
    gjk_pose p = {{7, 8, 9}, {10, 11, 12, 13}};
    const gjk_quat old_q = q;
    const gjk_vec3 old_u = u;
    const gjk_pose old_p = p;
    CHECK_MSG(gjk_quat_compose(&bad[i], &good, &q) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_quat_compose(&good, &bad[i], &q) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_quat_invert(&bad[i], &q) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_quat_apply(&bad[i], &v, &u) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_pose_compose(&bad_pose, &good_pose, &p) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_pose_compose(&good_pose, &bad_pose, &p) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_pose_invert(&bad_pose, &p) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(gjk_pose_apply(&bad_pose, &v, &u) == GJK_ERROR_ROTATION, "%d", i);
    CHECK_MSG(same_quat(&q, &old_q), "%d", i);
    CHECK_MSG(same_vec3(&u, &old_u), "%d", i);
    CHECK_MSG(same_pose(&p, &old_p), "%d", i);
  }
  gjk_quat q = {7, 8, 9, 10};
  const gjk_quat old_q = q, zero = {0, 0, 0, 0};
  const gjk_vec3 no_axis = {0, 0, 0};
  CHECK(gjk_quat_from_axis_angle(&no_axis, 1, &q) == GJK_ERROR_ROTATION);
  CHECK(gjk_quat_normalize(&zero, &q) == GJK_ERROR_ROTATION);
  CHECK(same_quat(&q, &old_q));
}

static void test_nulls(void) {
  gjk_quat q = {7, 8, 9, 10};
  gjk_vec3 v = {7, 8, 9};
  gjk_pose p = {{7, 8, 9}, {0, 0, 0, ONE}};
  const gjk_quat old_q = q;
  const gjk_vec3 old_v = v;
  const gjk_pose old_p = p;
  CHECK(gjk_quat_from_axis_angle(NULL, 1, &q) == GJK_ERROR_NULL);
  CHECK(gjk_quat_from_axis_angle(&v, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_quat_from_euler(1, 2, 3, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_quat_normalize(NULL, &q) == GJK_ERROR_NULL);
  CHECK(gjk_quat_normalize(&q, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_quat_compose(NULL, &old_q, &q) == GJK_ERROR_NULL);
  CHECK(gjk_quat_compose(&old_q, NULL, &q) == GJK_ERROR_NULL);
  CHECK(gjk_quat_compose(&q, &q, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_quat_invert(NULL, &q) == GJK_ERROR_NULL);
  CHECK(gjk_quat_invert(&q, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_quat_apply(NULL, &old_v, &v) == GJK_ERROR_NULL);
  CHECK(gjk_quat_apply(&q, NULL, &v) == GJK_ERROR_NULL);
  CHECK(gjk_quat_apply(&q, &v, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_pose_compose(NULL, &old_p, &p) == GJK_ERROR_NULL);
  CHECK(gjk_pose_compose(&old_p, NULL, &p) == GJK_ERROR_NULL);
  CHECK(gjk_pose_compose(&p, &p, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_pose_invert(NULL, &p) == GJK_ERROR_NULL);
  CHECK(gjk_pose_invert(&p, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_pose_apply(NULL, &old_v, &v) == GJK_ERROR_NULL);
  CHECK(gjk_pose_apply(&p, NULL, &v) == GJK_ERROR_NULL);
  CHECK(gjk_pose_apply(&p, &v, NULL) == GJK_ERROR_NULL);
  CHECK(same_quat(&q, &old_q));
  CHECK(same_vec3(&v, &old_v));
  CHECK(same_pose(&p, &old_p));
}

// Positions at the ends of int32.
static void test_range(void) {
  const gjk_pose low = {{INT32_MIN, 0, 0}, {0, 0, 0, ONE}}, turned = {{INT32_MIN, 0, 0}, {0, 0, ONE, 0}};
  const gjk_pose high = {{INT32_MAX, 0, 0}, {0, 0, 0, ONE}}, step = {{1, 0, 0}, {0, 0, 0, ONE}};
  const gjk_vec3 most = {INT32_MIN, 0, 0}, one = {-1, 0, 0}, none = {0, 0, 0};
  gjk_pose p = step;
  gjk_vec3 v = none;
  CHECK(gjk_pose_invert(&low, &p) == GJK_ERROR_RANGE);
  CHECK(same_pose(&p, &step));
  CHECK(gjk_pose_invert(&turned, &p) == GJK_OK);
  CHECK(p.position.x == INT32_MIN);
  p = step;
  CHECK(gjk_pose_compose(&high, &step, &p) == GJK_ERROR_RANGE);
  CHECK(same_pose(&p, &step));
  CHECK(gjk_pose_apply(&low, &one, &v) == GJK_ERROR_RANGE);
  CHECK(same_vec3(&v, &none));
  CHECK(gjk_quat_apply(&turned.rotation, &most, &v) == GJK_ERROR_RANGE);
  CHECK(same_vec3(&v, &none));
  CHECK(gjk_pose_apply(&high, &most, &v) == GJK_OK);
  CHECK(v.x == -1);
}

int main(void) {
  test_tolerance();
  test_bad_rotations();
  test_nulls();
  test_range();
  return check_done("pose_status");
}
