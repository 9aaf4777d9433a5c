// Where is an arm after its joints have turned, and how far is its hand from a crate? In space, then in the plane.
#include <stdio.h>

#include "gjk/gjk.h"
#include "gjk2/gjk2.h"

static const gjk_shape crate = GJK_BOX(GJK_Q16(0.25), GJK_Q16(0.25), GJK_Q16(0.25));

int main(void) {
  // The shoulder turns about z; elbow and wrist are 1 and 0.75 units along z, and turn about y.
  const gjk_pose fixed[] = {GJK_POSE_IDENTITY,
                            {{0, 0, GJK_Q16(1.0)}, {0, 0, 0, GJK_Q30_ONE}},
                            {{0, 0, GJK_Q16(0.75)}, {0, 0, 0, GJK_Q30_ONE}}};
  const gjk_vec3 y = {0, 1, 0};
  const gjk_angle angles[] = {GJK_ANGLE(0.5), GJK_ANGLE(1.0), GJK_ANGLE(-0.25)};
  const gjk_pose base = GJK_POSE_IDENTITY, there = {{GJK_Q16(1.0), 0, GJK_Q16(1.25)}, {0, 0, 0, GJK_Q30_ONE}};
  gjk_joint joints[3];
  gjk_pose frames[3], along;
  if (gjk_joint_init(&joints[0], &fixed[0], NULL) != GJK_OK || gjk_joint_init(&joints[1], &fixed[1], &y) != GJK_OK ||
      gjk_joint_init(&joints[2], &fixed[2], &y) != GJK_OK ||
      gjk_joints_from_angles(joints, 3, &base, angles, frames) != GJK_OK) {
    return 1;
  }

  // The link from elbow to wrist as a capsule.
  gjk_q16 half;
  gjk_collider a = {0}, b = {0};
  gjk_distance_result gap;
  if (gjk_pose_between(&frames[1].position, &frames[2].position, &along, &half) != GJK_OK) {
    return 1;
  }
  const gjk_shape link = GJK_CAPSULE(GJK_Q16(0.1), half);
  if (gjk_collider_init(&a, &link, NULL, 0) != GJK_OK || gjk_collider_init(&b, &crate, NULL, 0) != GJK_OK ||
      gjk_collider_pose(&a, &along) != GJK_OK || gjk_collider_pose(&b, &there) != GJK_OK ||
      gjk_distance(&a, &b, NULL, &gap) != GJK_OK) {
    return 1;
  }
  const gjk_vec3 *wrist = &frames[2].position;
  printf("wrist at %ld %ld %ld, gap %ld\n", (long)wrist->x, (long)wrist->y, (long)wrist->z, (long)gap.distance);

  gjk2_joint joints2[2];
  gjk2_pose frames2[2];
  const gjk2_pose unit_on = {{GJK_Q16_ONE, 0}, {GJK_Q30_ONE, 0}}, base2 = GJK2_POSE_IDENTITY;
  if (gjk2_joint_init(&joints2[0], &unit_on) != GJK_OK || gjk2_joint_init(&joints2[1], &unit_on) != GJK_OK ||
      gjk2_joints_from_angles(joints2, 2, &base2, angles, frames2) != GJK_OK) {
    return 1;
  }
  printf("in the plane at %ld %ld\n", (long)frames2[1].position.x, (long)frames2[1].position.y);
  return 0;
}
// prints: wrist at 36297 19829 92093, gap 6755
// prints: in the plane at 123049 31420
