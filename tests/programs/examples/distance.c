// How far apart are a crate and a ball, and where are they nearest?
#include <stdio.h>

#include "gjk/gjk.h"

static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.25));

int main(void) {
  const gjk_vec3 up = {0, 0, GJK_Q16_ONE};
  gjk_pose tilted = GJK_POSE_IDENTITY, beside = GJK_POSE_IDENTITY;
  gjk_collider a = {0}, b = {0};
  gjk_distance_result gap;

  gjk_quat_from_axis_angle(&up, GJK_ANGLE(0.7853982), &tilted.rotation);  // 45 degrees
  beside.position.x = GJK_Q16(1.5);
  if (gjk_collider_init(&a, &crate, NULL, 0) != GJK_OK || gjk_collider_pose(&a, &tilted) != GJK_OK ||
      gjk_collider_init(&b, &ball, NULL, 0) != GJK_OK || gjk_collider_pose(&b, &beside) != GJK_OK ||
      gjk_distance(&a, &b, NULL, &gap) != GJK_OK) {
    return 1;
  }
  printf("gap %ld, from x = %ld to x = %ld, in LSB of 2^-16\n", (long)gap.distance, (long)gap.point_a.x,
         (long)gap.point_b.x);
  return 0;
}
// prints: gap 35579, from x = 46341 to x = 81920, in LSB of 2^-16
