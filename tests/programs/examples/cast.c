// How far can a crate be pushed along x before it hits a leaning board, and where does it stay then?
#include <stdio.h>

#include "gjk/gjk.h"

static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape board = GJK_BOX(GJK_Q16(0.05), GJK_Q16(1.0), GJK_Q16(2.0));

int main(void) {
  const gjk_vec3 axis = {0, GJK_Q16_ONE, 0}, end = {GJK_Q16(10.0), 0, 0};
  const gjk_cast_path push = {.to_b = &end};
  gjk_pose leaning = GJK_POSE_IDENTITY, start = GJK_POSE_IDENTITY;
  gjk_collider a = {0}, b = {0};
  gjk_cast_result hit;
  gjk_decision touching;

  leaning.position.x = GJK_Q16(5.0);
  gjk_quat_from_axis_angle(&axis, GJK_ANGLE(0.3), &leaning.rotation);
  if (gjk_collider_init(&a, &board, NULL, 0) != GJK_OK || gjk_collider_pose(&a, &leaning) != GJK_OK ||
      gjk_collider_init(&b, &crate, NULL, 0) != GJK_OK || gjk_collider_pose(&b, &start) != GJK_OK ||
      gjk_cast(&a, &b, &push, &hit) != GJK_OK || !hit.hit) {
    return 1;
  }
  start.position = hit.rest_b;  // in whole LSB, where nothing overlaps
  start.position.x -= 1;        // and one LSB before it nothing touches
  if (gjk_collider_pose(&b, &start) != GJK_OK || gjk_intersect(&a, &b, NULL, &touching) != GJK_OK) {
    return 1;
  }
  printf("pushed to x = %ld, where they %s\n", (long)start.position.x, touching.yes ? "touch" : "do not touch");
  return 0;
}
// prints: pushed to x = 281344, where they do not touch
