// Where does a box of the plane stand on the ground?
#include <gjk.h>

static const gjk2_shape ground = GJK2_BOX(GJK_Q16(10.0), GJK_Q16(0.5));
static const gjk2_shape box = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.5));
static gjk2_collider a, b;

void setup() {
  const gjk2_pose origin = GJK2_POSE_IDENTITY;
  Serial.begin(115200);
  gjk2_collider_init(&a, &ground, NULL, 0);
  gjk2_collider_init(&b, &box, NULL, 0);
  gjk2_collider_pose(&a, &origin);
}

void loop() {
  static gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk2_manifold manifold;
  pose.position.y = GJK_Q16(0.99);
  if (gjk2_collider_pose(&b, &pose) == GJK_OK && gjk2_contacts(&a, &b, 0, 2, NULL, &manifold) == GJK_OK) {
    for (uint8_t i = 0; i < manifold.count; i++) {
      Serial.println((long)manifold.contact[i].point_a.x);
    }
  }
}
