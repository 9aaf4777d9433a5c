// Rotations and poses: normalise, compose, invert, apply.
#include "gjk2/pose.h"

#include "../arith/gjk_root.h"
#include "gjk2_rotation.h"

// |p|^2 - 1, Q60, from 0 to 3 too small, for p in Q60. Pre: |p|^2 is within 2^-28 of 1.
static int64_t plane_excess_q60(uint64_t c, uint64_t s) {
  // p = 2^30 h + l, 0 <= l < 2^30, per component:  p^2 / 2^60 = h^2 + 2 h l / 2^30 + (less than 1)
  const uint32_t hc = (uint32_t)(c >> 30), lc = (uint32_t)(c & 0x3FFFFFFFu);
  const uint32_t hs = (uint32_t)(s >> 30), ls = (uint32_t)(s & 0x3FFFFFFFu);
  const uint64_t squares = gjk_umul32(hc, hc) + gjk_umul32(hs, hs);   // < 2^61
  const uint64_t products = gjk_umul32(hc, lc) + gjk_umul32(hs, ls);  // < 2^61
  const int64_t excess = gjk_int64(squares + (products >> 29) - (UINT64_C(1) << 60));
  //@ assert excess > -(INT64_C(1) << 32) && excess < INT64_C(1) << 32;
  return excess;
}

// size with the sign of like.
static gjk_q30 signed_like(int64_t size, int32_t excess, int32_t like) {
  const gjk_q30 rounded = gjk2_to_q30(gjk2_corrected(size, excess));
  return like < 0 ? -rounded : rounded;
}

gjk_status gjk2_rotation_normalize(const gjk2_rotation *r, gjk2_rotation *out) {
  if (r == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const uint32_t bits = gjk_magnitude32(r->c) | gjk_magnitude32(r->s);
  if (bits == 0) {
    return GJK_ERROR_ROTATION;
  }
  const unsigned up = gjk_clz32(bits);
  // One component >= 2^31, both < 2^32:  2^61 <= half < 2^64
  const uint32_t c = gjk_magnitude32(r->c) << up, s = gjk_magnitude32(r->s) << up;
  const uint64_t half = (gjk_umul32(c, c) >> 1) + (gjk_umul32(s, s) >> 1);
  //@ assert half >= UINT64_C(1) << 61;
  const unsigned zeros = gjk_clz64(half) & ~1u;  // 0 or 2
  // root = 2^46 2^16 / sqrt(half 2^zeros) = 2^(62.5 - zeros / 2) / |r 2^up|; half a power of two is left, so divide it
  // out of the components: they are multiplied by sqrt(2) / 2 below, by the correction's first term.
  const uint32_t root = gjk_reciprocal_root((uint32_t)((half << zeros) >> 32));
  const unsigned down = 2 - zeros / 2;
  // c root = 2^62.5 2^(-zeros/2) c / |r|; times 1 / sqrt(2), Q32, it is 2^62 2^(-zeros / 2) c / |r|.
  const uint32_t half_root = UINT32_C(3037000500);  // 2^32 / sqrt(2)
  const uint64_t high_c = gjk_umul32(c, root), high_s = gjk_umul32(s, root);
  const uint64_t pc =
      (gjk_umul32((uint32_t)(high_c >> 32), half_root) + gjk_umulh32((uint32_t)(high_c & UINT32_MAX), half_root)) >>
      down;
  const uint64_t ps =
      (gjk_umul32((uint32_t)(high_s >> 32), half_root) + gjk_umulh32((uint32_t)(high_s & UINT32_MAX), half_root)) >>
      down;
  // (pc, ps) is a unit in Q60 but for the errors of root and diagonal, below 2^-29: |off| below 2^32.
  //@ assert pc <= (UINT64_C(1) << 60) + (UINT64_C(1) << 32);
  //@ assert ps <= (UINT64_C(1) << 60) + (UINT64_C(1) << 32);
  const int32_t excess = gjk2_excess(plane_excess_q60(pc, ps));
  out->c = signed_like((int64_t)pc, excess, r->c);
  out->s = signed_like((int64_t)ps, excess, r->s);
  return GJK_OK;
}

gjk_status gjk2_rotation_compose(const gjk2_rotation *a, const gjk2_rotation *b, gjk2_rotation *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t off_a, off_b;
  if (!gjk2_rotation_deviation(a, &off_a) || !gjk2_rotation_deviation(b, &off_b)) {
    return GJK_ERROR_ROTATION;
  }
  gjk2_rotation_product(a, off_a, b, off_b, out);
  return GJK_OK;
}

gjk_status gjk2_rotation_invert(const gjk2_rotation *r, gjk2_rotation *out) {
  if (r == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  int64_t deviation;
  if (!gjk2_rotation_deviation(r, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  const gjk2_rotation conjugate = {r->c, -r->s};  // no component of a unit is INT32_MIN
  *out = conjugate;
  return GJK_OK;
}

// *out = position + v rotated by r. GJK_ERROR_ROTATION or GJK_ERROR_RANGE: *out is not set.
static gjk_status plane_place_point(const gjk2_rotation *r, const gjk2_vec *v, const gjk2_vec *position,
                                    gjk2_vec *out) {
  gjk2_vec unit;
  int64_t p[2];
  if (!gjk2_rotation_with_point(r, v, &unit, p)) {
    return GJK_ERROR_ROTATION;
  }
  const int64_t half = INT64_C(1) << 29;
  const int64_t x = gjk_sar64(p[0] + half, 30) + position->x, y = gjk_sar64(p[1] + half, 30) + position->y;
  if (x < INT32_MIN || x > INT32_MAX || y < INT32_MIN || y > INT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  out->x = (gjk_q16)x;
  out->y = (gjk_q16)y;
  return GJK_OK;
}

gjk_status gjk2_rotation_apply(const gjk2_rotation *r, const gjk2_vec *v, gjk2_vec *out) {
  const gjk2_vec origin = {0, 0};
  if (r == NULL || v == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  return plane_place_point(r, v, &origin, out);
}

gjk_status gjk2_pose_apply(const gjk2_pose *p, const gjk2_vec *v, gjk2_vec *out) {
  if (p == NULL || v == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  return plane_place_point(&p->rotation, v, &p->position, out);
}

gjk_status gjk2_pose_compose(const gjk2_pose *a, const gjk2_pose *b, gjk2_pose *out) {
  if (a == NULL || b == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk2_rotation rotation;
  gjk_status status = gjk2_rotation_compose(&a->rotation, &b->rotation, &rotation);
  if (status == GJK_OK) {
    status = plane_place_point(&a->rotation, &b->position, &a->position, &out->position);
  }
  if (status == GJK_OK) {
    out->rotation = rotation;
  }
  return status;
}

gjk_status gjk2_pose_invert(const gjk2_pose *p, gjk2_pose *out) {
  if (p == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk2_rotation opposite;
  gjk2_vec unit;
  int64_t back[2];
  if (gjk2_rotation_invert(&p->rotation, &opposite) != GJK_OK ||
      // not reached: false, since the opposite is as long as what is inverted
      !gjk2_rotation_with_point(&opposite, &p->position, &unit, back)) {
    return GJK_ERROR_ROTATION;
  }
  const int64_t half = INT64_C(1) << 29;
  const int64_t x = -gjk_sar64(back[0] + half, 30), y = -gjk_sar64(back[1] + half, 30);
  if (x < INT32_MIN || x > INT32_MAX || y < INT32_MIN || y > INT32_MAX) {
    return GJK_ERROR_RANGE;
  }
  out->position.x = (gjk_q16)x;
  out->position.y = (gjk_q16)y;
  out->rotation = opposite;
  return GJK_OK;
}
