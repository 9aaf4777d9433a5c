// A user's own support function: a box by its corners answers as the built-in box does.
#include <stdlib.h>
#include <string.h>

#include "case/case.h"
#include "check.h"
#include "gjk/gjk.h"
#include "random.h"

#define SEED 88
#define PAIRS ((int)check_trials(20000))
#define LIMIT 2

static void support_box(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  const gjk_vec3 *half = user;
  out->x = direction->x < 0 ? -half->x : half->x;
  out->y = direction->y < 0 ? -half->y : half->y;
  out->z = direction->z < 0 ? -half->z : half->z;
}

static gjk_pose random_pose(random_state *random, int32_t reach) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  CHECK(gjk_quat_normalize(&q, &pose.rotation) == GJK_OK);
  pose.position.x = random_range(random, -reach, reach);
  pose.position.y = random_range(random, -reach, reach);
  pose.position.z = random_range(random, -reach, reach);
  return pose;
}

static gjk_collider placed(const gjk_shape *shape, const gjk_pose *pose) {
  gjk_collider c;
  memset(&c, 0, sizeof c);
  CHECK(gjk_collider_init(&c, shape, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&c, pose) == GJK_OK);
  return c;
}

// Both boxes' own posed axes are rounded by up to 1.5 LSB a vertex, the supports of the user's by 1.
static void check_pair(random_state *random, unsigned long number, unsigned long *together) {
  const int32_t size = INT32_C(1) << (4 + random_below(random, 20));
  const gjk_vec3 half = {random_range(random, 1, size), random_range(random, 1, size), random_range(random, 1, size)};
  const gjk_shape other = GJK_CAPSULE(size / 3, size), box = GJK_BOX(half.x, half.y, half.z);
  const gjk_shape own = GJK_CUSTOM(support_box, &half, 2 * size);
  const gjk_pose pose_a = random_pose(random, 2 * size), pose_b = random_pose(random, 2 * size);
  const gjk_collider a = placed(&box, &pose_a), a_own = placed(&own, &pose_a), b = placed(&other, &pose_b);
  static case_posed posed;
  const case_posed now = {box, other, pose_a, pose_b};  // the box in place of the user's
  posed = now;
  check_trial(number, case_show_posed, &posed);
  gjk_distance_result expected, found;
  gjk_decision within;
  gjk_aabb box_a, box_own;
  CHECK(gjk_distance(&a, &b, NULL, &expected) == GJK_OK);
  CHECK(gjk_distance(&a_own, &b, NULL, &found) == GJK_OK);
  CHECK_MSG(labs((long)(found.distance - expected.distance)) <= 3 + LIMIT, "%ld, not %ld", (long)found.distance,
            (long)expected.distance);
  CHECK(gjk_within(&a_own, &b, expected.distance + 3 + LIMIT, NULL, &within) == GJK_OK);
  CHECK(within.yes);
  CHECK(gjk_collider_aabb(&a, &box_a) == GJK_OK);
  CHECK(gjk_collider_aabb(&a_own, &box_own) == GJK_OK);
  CHECK(labs((long)(box_a.upper.x - box_own.upper.x)) <= 4);
  CHECK(labs((long)(box_a.lower.z - box_own.lower.z)) <= 4);
  *together += expected.intersecting;
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  unsigned long together = 0;
  for (int i = 0; i < PAIRS; i++) {
    check_pair(&random, (unsigned long)i, &together);
  }
  printf("%lu together\n", together);
  CHECK(together > (unsigned long)PAIRS / 20);
  CHECK(together < (unsigned long)PAIRS * 19 / 20);
  return check_done("custom");
}
