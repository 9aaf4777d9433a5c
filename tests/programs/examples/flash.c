// Shapes as constants take no RAM: a hull with its faces, a rounded one, and a capsule. Only the colliders are in RAM.
#include <stdio.h>

#include "gjk/gjk.h"

// A wedge: a ramp of 2 x 1 x 1 units.
static const gjk_vec3 corners[] = {{0, 0, 0},
                                   {GJK_Q16(2.0), 0, 0},
                                   {0, 0, GJK_Q16(1.0)},
                                   {0, GJK_Q16(1.0), 0},
                                   {GJK_Q16(2.0), GJK_Q16(1.0), 0},
                                   {0, GJK_Q16(1.0), GJK_Q16(1.0)}};
static const uint16_t corner[] = {0, 1, 2, 3, 5, 4, 0, 3, 4, 1, 0, 2, 5, 3, 1, 4, 5, 2};
static const uint16_t end[] = {3, 6, 10, 14, 18};
static const gjk_hull_faces faces = {.corner = corner, .end = end, .count = 5};
static const gjk_shape shapes[] = {
    GJK_HULL_WITH_FACES(corners, 6, &faces),
    GJK_ROUNDED_HULL(corners, 6, GJK_Q16(0.1)),
    GJK_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.5)),
};

int main(void) {
  const gjk_pose origin = GJK_POSE_IDENTITY;
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider capsule = {0}, other = {0};
  gjk_hull_report report;

  pose.position.x = GJK_Q16(2.0);
  pose.position.y = GJK_Q16(0.5);
  pose.position.z = GJK_Q16(1.5);
  if (gjk_hull_check(corners, 6, &faces, &report) != GJK_OK || report.fault != GJK_HULL_SOUND ||
      gjk_collider_init(&capsule, &shapes[2], NULL, 0) != GJK_OK || gjk_collider_pose(&capsule, &pose) != GJK_OK) {
    return 1;
  }
  for (int i = 0; i < 2; i++) {
    gjk_distance_result gap;
    if (gjk_collider_init(&other, &shapes[i], NULL, 0) != GJK_OK || gjk_collider_pose(&other, &origin) != GJK_OK ||
        gjk_distance(&capsule, &other, NULL, &gap) != GJK_OK) {
      return 1;
    }
    printf("%s %ld", i == 0 ? "gap" : ", rounded", (long)gap.distance);
  }
  printf("\n");
  return 0;
}
// prints: gap 42233, rounded 35679
