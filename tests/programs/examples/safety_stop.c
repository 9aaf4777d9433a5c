// An arm has to stop before it comes within 0.2 units of a post. Each tick may spend so many iterations; a question
// that they leave open counts as "too near", which errs on the safe side.
#include <stdio.h>

#include "gjk/gjk.h"

#define BUDGET 1  // iterations a tick

static const gjk_shape arm = GJK_CAPSULE(GJK_Q16(0.1), GJK_Q16(0.5));  // along its z
static const gjk_shape post = GJK_CYLINDER(GJK_Q16(0.2), GJK_Q16(1.0));

int main(void) {
  const gjk_vec3 across = {0, GJK_Q16_ONE, 0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider moving = {0}, standing = {0};

  if (gjk_collider_init(&standing, &post, NULL, 0) != GJK_OK || gjk_collider_pose(&standing, &pose) != GJK_OK ||
      gjk_collider_init(&moving, &arm, NULL, 0) != GJK_OK) {
    return 1;
  }
  gjk_quat_from_axis_angle(&across, GJK_ANGLE(1.5707963), &pose.rotation);  // lying along x
  for (int tick = 0; tick < 100; tick++) {
    gjk_within_result near;
    pose.position.x = GJK_Q16(2.0) - tick * GJK_Q16(0.02);
    if (gjk_collider_pose(&moving, &pose) != GJK_OK ||
        gjk_within_until(&moving, &standing, GJK_Q16(0.2), BUDGET, NULL, &near) < GJK_OK) {
      return 1;
    }
    if (near.answer != GJK_ANSWER_NO) {
      printf("stop at tick %d, %s, after %d iterations\n", tick, near.answer == GJK_ANSWER_YES ? "too near" : "open",
             near.decision.iterations);
      return 0;
    }
  }
  return 1;
}
// prints: stop at tick 50, open, after 1 iterations
