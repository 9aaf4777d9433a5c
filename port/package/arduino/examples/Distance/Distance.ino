// How far apart are a crate and a ball that rolls towards it?
#include <gjk.h>

static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.25));
static gjk_collider a, b;

void setup() {
  const gjk_pose origin = GJK_POSE_IDENTITY;
  Serial.begin(115200);
  gjk_collider_init(&a, &crate, NULL, 0);
  gjk_collider_init(&b, &ball, NULL, 0);
  gjk_collider_pose(&a, &origin);
}

void loop() {
  static gjk_pose pose = GJK_POSE_IDENTITY;
  static gjk_q16 x = GJK_Q16(4.0);
  gjk_distance_result gap;
  pose.position.x = x;
  if (gjk_collider_pose(&b, &pose) == GJK_OK && gjk_distance(&a, &b, NULL, &gap) == GJK_OK) {
    Serial.println((long)gap.distance);  // LSB of 2^-16
  }
  x = x > 0 ? x - GJK_Q16(0.5) : GJK_Q16(4.0);
}
