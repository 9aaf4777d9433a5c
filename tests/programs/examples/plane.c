// A level of the plane: a ball lies on a slope, and the contact says which way it is held.
#include <stdio.h>

#include "gjk2/gjk2.h"

static const gjk2_vec corners[] = {{0, 0}, {GJK_Q16(2.0), 0}, {0, GJK_Q16(2.0)}};
static const gjk2_shape slope = GJK2_POLYGON(corners, 3);
static const gjk2_shape ball = GJK2_CIRCLE(GJK_Q16(0.25));

int main(void) {
  gjk2_pose still = GJK2_POSE_IDENTITY, lying = GJK2_POSE_IDENTITY;
  gjk2_collider a = {0}, b = {0};
  gjk2_manifold manifold;

  lying.position.x = lying.position.y = GJK_Q16(1.17);
  if (gjk2_collider_init(&a, &slope, NULL, 0) != GJK_OK || gjk2_collider_pose(&a, &still) != GJK_OK ||
      gjk2_collider_init(&b, &ball, NULL, 0) != GJK_OK || gjk2_collider_pose(&b, &lying) != GJK_OK ||
      gjk2_contacts(&a, &b, 0, 2, NULL, &manifold) != GJK_OK) {
    return 1;
  }
  printf("%u contact, %ld LSB deep, held along (%ld, %ld) of 2^30\n", (unsigned)manifold.count,
         (long)-manifold.contact[0].distance, (long)manifold.normal.x, (long)manifold.normal.y);
  return 0;
}
// prints: 1 contact, 629 LSB deep, held along (759250125, 759250125) of 2^30
