// Poses along a chain of joints in the plane.
//
//   1. A joint's own rotation: still times cosine and sine.
//   2. The frame so far takes offset to the world. The sum of origins keeps 30 bits below the LSB.
//   3. The frame so far times the joint's rotation is the next frame. Its length is not corrected: 8 GJK2_JOINTS_MAX is
//      below GJK2_ROTATION_TOLERANCE.
//
// Errors of a joint, in units of 2^-30: still 0.71, cosine and sine 1.42, steps 1 and 3 0.71 each: together 3.6. The base
// adds 0.71.
#include "gjk2/joint.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_sine.h"
#include "gjk2_rotation.h"

gjk_status gjk2_joint_init(gjk2_joint *joint, const gjk2_pose *fixed) {
  if (joint == NULL || fixed == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t deviation;
  if (!gjk2_rotation_deviation(&fixed->rotation, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  const uint32_t x = gjk_magnitude32(fixed->position.x), y = gjk_magnitude32(fixed->position.y);
  const uint32_t length = gjk_isqrt64(gjk_umul32(x, x) + gjk_umul32(y, y));  // at most 2^63
  gjk2_copy(&joint->offset, &fixed->position);
  joint->reach = length + (length >> 16) + 2;  // rotations of the chain are off by less than 2^-16
  (void)gjk2_rotation_normalize(&fixed->rotation, &joint->still);
  return GJK_OK;
}

// a b to the nearest. Pre: both are units within the tolerance.
static void plane_joint_product(const gjk2_rotation *a, const gjk2_rotation *b, gjk2_rotation *out) {
  const int64_t c = gjk_mac32(gjk_mul32(a->c, b->c), -a->s, b->s), s = gjk_mac32(gjk_mul32(a->c, b->s), a->s, b->c);
  out->c = gjk2_to_q30(c);
  out->s = gjk2_to_q30(s);
}

gjk_status gjk2_joints_from_angles(const gjk2_joint *joints, unsigned count, const gjk2_pose *base,
                                   const gjk_angle *angles, gjk2_pose *out) {
  if (joints == NULL || base == NULL || angles == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk2_rotation rotation;
  int64_t deviation;
  if (!gjk2_rotation_deviation(&base->rotation, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  if (count > GJK2_JOINTS_MAX) {
    return GJK_ERROR_RANGE;
  }
  const uint32_t bx = gjk_magnitude32(base->position.x), by = gjk_magnitude32(base->position.y);
  uint64_t reach = bx > by ? bx : by;
  for (unsigned i = 0; i < count; i++) {
    reach += joints[i].reach;  // below 2^31 + 1000 2^32 at the end
  }
  if (reach > INT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  (void)gjk2_rotation_normalize(&base->rotation, &rotation);
  int64_t x = gjk_shl64(base->position.x, 30), y = gjk_shl64(base->position.y, 30);  // Q30 of an LSB, below 2^61
  for (unsigned i = 0; i < count; i++) {
    const gjk2_vec *v = &joints[i].offset;
    gjk2_rotation turn, own;
    x = gjk_mac32(gjk_mac32(x, rotation.c, v->x), -rotation.s, v->y);  // Step 2
    y = gjk_mac32(gjk_mac32(y, rotation.s, v->x), rotation.c, v->y);
    gjk_sine_cosine(angles[i], 2 * gjk_half_turns(gjk_magnitude32(angles[i])), &turn.s, &turn.c);
    plane_joint_product(&joints[i].still, &turn, &own);  // Step 1
    plane_joint_product(&rotation, &own, &rotation);     // Step 3
    out[i].position.x = gjk2_to_q30(x);
    out[i].position.y = gjk2_to_q30(y);
    out[i].rotation = rotation;
  }
  return GJK_OK;
}
