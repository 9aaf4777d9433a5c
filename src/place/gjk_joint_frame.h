// The frame that a chain of joints has come to, and what a joint does to it: the steps of gjk_joint.c, for trees too.
#ifndef GJK_SRC_JOINT_FRAME_H
#define GJK_SRC_JOINT_FRAME_H

#include "../arith/gjk_rotation.h"
#include "gjk/joint.h"

typedef struct gjk_joint_frame {
  gjk_quat rotation;
  int64_t origin[3];  // Q30 of an LSB
} gjk_joint_frame;

// Sets the frame to the base. Pre: the base's rotation is a unit.
static inline void gjk_joint_start(gjk_joint_frame *frame, const gjk_pose *base) {
  (void)gjk_quat_normalize(&base->rotation, &frame->rotation);
  frame->origin[0] = gjk_shl64(base->position.x, 30);
  frame->origin[1] = gjk_shl64(base->position.y, 30);
  frame->origin[2] = gjk_shl64(base->position.z, 30);
}

// Q60 to the nearest Q30.
static inline int32_t gjk_joint_round(int64_t x) {
  return (int32_t)gjk_sar64(x + (INT64_C(1) << 29), 30);
}

// Step 1: a cosine + b sine, to the nearest.
static inline gjk_q30 gjk_joint_blend(gjk_q30 a, gjk_q30 b, gjk_q30 cosine, gjk_q30 sine) {
  return gjk_joint_round(gjk_mac32(gjk_mul32(a, cosine), b, sine));  // below 2^61
}

// Step 1: the joint's own rotation, from the sine and cosine of half its angle.
static inline gjk_quat gjk_joint_own(const gjk_joint *joint, gjk_q30 sine, gjk_q30 cosine) {
  const gjk_quat *still = &joint->still, *quarter = &joint->quarter;
  const gjk_quat own = {
      gjk_joint_blend(still->x, quarter->x, cosine, sine), gjk_joint_blend(still->y, quarter->y, cosine, sine),
      gjk_joint_blend(still->z, quarter->z, cosine, sine), gjk_joint_blend(still->w, quarter->w, cosine, sine)};
  return own;
}

// Step 2: the matrix of a frame's rotation, Q30, each entry to the nearest.
// |products| <= |q|^2 <= 2^60 (1 + 2^-16), and so is each entry.
static inline void gjk_joint_rows(const gjk_quat *q, gjk_vec3 rows[3]) {
  const int64_t xx = gjk_mul32(q->x, q->x), yy = gjk_mul32(q->y, q->y), zz = gjk_mul32(q->z, q->z);
  const int64_t ww = gjk_mul32(q->w, q->w), xy = gjk_mul32(q->x, q->y), xz = gjk_mul32(q->x, q->z);
  const int64_t yz = gjk_mul32(q->y, q->z), wx = gjk_mul32(q->w, q->x), wy = gjk_mul32(q->w, q->y);
  const int64_t wz = gjk_mul32(q->w, q->z);
  rows[0].x = gjk_joint_round(ww + xx - yy - zz);
  rows[0].y = gjk_joint_round(2 * (xy - wz));
  rows[0].z = gjk_joint_round(2 * (xz + wy));
  rows[1].x = gjk_joint_round(2 * (xy + wz));
  rows[1].y = gjk_joint_round(ww - xx + yy - zz);
  rows[1].z = gjk_joint_round(2 * (yz - wx));
  rows[2].x = gjk_joint_round(2 * (xz - wy));
  rows[2].y = gjk_joint_round(2 * (yz + wx));
  rows[2].z = gjk_joint_round(ww - xx - yy + zz);
}

// Step 2: moves the origin by v in a frame of these rows. Pre: the chain's reach was measured, so that the origin and each
// partial sum stay below 2^61.
static inline void gjk_joint_move(gjk_joint_frame *frame, const gjk_vec3 rows[3], const gjk_vec3 *v) {
  for (int i = 0; i < 3; i++) {
    frame->origin[i] =
        gjk_mac32(gjk_mac32(gjk_mac32(frame->origin[i], rows[i].x, v->x), rows[i].y, v->y), rows[i].z, v->z);
  }
}

// Step 3: turns the frame by a joint's own rotation.
static inline void gjk_joint_turn(gjk_joint_frame *frame, const gjk_quat *own) {
  int64_t product[4];
  gjk_quat_product(&frame->rotation, own, product);
  frame->rotation.x = gjk_joint_round(product[0]);
  frame->rotation.y = gjk_joint_round(product[1]);
  frame->rotation.z = gjk_joint_round(product[2]);
  frame->rotation.w = gjk_joint_round(product[3]);
}

// The frame's origin to the nearest LSB.
static inline void gjk_joint_place(const gjk_joint_frame *frame, gjk_vec3 *out) {
  out->x = gjk_joint_round(frame->origin[0]);
  out->y = gjk_joint_round(frame->origin[1]);
  out->z = gjk_joint_round(frame->origin[2]);
}

#endif
