// gjk/joint.h on any fixed pose, axis, base, angles and rotations, null pointers too, and on any chain of up to 2 joints that
// gjk_joint_init may leave.
#include "gjk/joint.h"

#include "any.h"

#define JOINTS 2
#define UNIT (GJK_Q30_ONE + 1)  // of a component of a product of units

static gjk_quat any_unit_quat(void) {
  const gjk_quat q = {any_between(-UNIT, UNIT), any_between(-UNIT, UNIT), any_between(-UNIT, UNIT),
                      any_between(-UNIT, UNIT)};
  return q;
}

static void any_joint(gjk_joint *joint) {
  joint->offset = any_position();
  joint->reach = (uint32_t)any_int32();
  joint->still = any_unit_quat();
  joint->quarter = any_unit_quat();
}

static void check_quat(const gjk_quat *q) {
  //@ assert q->x >= -UNIT && q->x <= UNIT && q->y >= -UNIT && q->y <= UNIT;
  //@ assert q->z >= -UNIT && q->z <= UNIT && q->w >= -UNIT && q->w <= UNIT;
}

int main(void) {
  const gjk_pose fixed = any_pose(), base = any_pose();
  const gjk_vec3 axis = any_position();
  gjk_joint joints[JOINTS];
  gjk_angle angles[JOINTS];
  gjk_quat rotations[JOINTS];
  gjk_pose out[JOINTS];
  if (gjk_joint_init(any_bool() ? &joints[0] : NULL, any_bool() ? &fixed : NULL, any_bool() ? &axis : NULL) == GJK_OK) {
    check_quat(&joints[0].still);
    check_quat(&joints[0].quarter);
  }
  for (int i = 0; i < JOINTS; i++) {
    any_joint(&joints[i]);
    angles[i] = any_int32();
    rotations[i] = any_quat();
  }
  for (unsigned count = 0; count <= JOINTS; count++) {
    (void)gjk_joints_from_angles(any_bool() ? joints : NULL, count, any_bool() ? &base : NULL,
                                 any_bool() ? angles : NULL, any_bool() ? out : NULL);
    (void)gjk_joints_from_rotations(any_bool() ? joints : NULL, count, any_bool() ? &base : NULL,
                                    any_bool() ? rotations : NULL, any_bool() ? out : NULL);
  }
  return 0;
}
