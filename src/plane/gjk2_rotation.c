// Rotations near a unit: how far they are off, and what they do to a point.
#include "gjk2_rotation.h"

bool gjk2_rotation_deviation(const gjk2_rotation *r, int64_t *deviation) {
  // Each square <= 2^62:  the sum <= 2^63
  const uint64_t squared = (uint64_t)gjk_mul32(r->c, r->c) + (uint64_t)gjk_mul32(r->s, r->s);
  const int64_t off = gjk_int64(squared - (UINT64_C(1) << 60));
  if (gjk_magnitude64(off) > (uint64_t)GJK2_ROTATION_TOLERANCE << 30) {
    return false;
  }
  //@ assert off >= -(INT64_C(1) << 44) && off <= INT64_C(1) << 44;
  //@ assert r->c >= -GJK_Q30_ONE - GJK2_ROTATION_TOLERANCE && r->c <= GJK_Q30_ONE + GJK2_ROTATION_TOLERANCE;
  //@ assert r->s >= -GJK_Q30_ONE - GJK2_ROTATION_TOLERANCE && r->s <= GJK_Q30_ONE + GJK2_ROTATION_TOLERANCE;
  *deviation = off;
  return true;
}

// 1 - 1 / sqrt(1 + e) = e / 2 - 3/8 e^2 + 5/16 e^3 - ...
int32_t gjk2_excess(int64_t deviation) {
  const int32_t e = (int32_t)gjk_sar64(deviation, 15);     // Q45:  |e| <= 2^30
  return e - (int32_t)gjk_sar64(3 * gjk_mul32(e, e), 47);  // e / 2 is e in Q46; 3 e^2 < 2^62; 5/16 e^3 < 1
}

bool gjk2_rotation_with_point(const gjk2_rotation *r, const gjk2_vec *v, gjk2_vec *unit, int64_t rotated[2]) {
  int64_t deviation;
  if (!gjk2_rotation_deviation(r, &deviation)) {
    return false;
  }
  const int32_t excess = gjk2_excess(deviation);
  unit->x = gjk2_to_q30(gjk2_corrected(gjk_shl64(r->c, 30), excess));
  unit->y = gjk2_to_q30(gjk2_corrected(gjk_shl64(r->s, 30), excess));
  //@ assert unit->x >= -GJK_Q30_ONE && unit->x <= GJK_Q30_ONE;
  //@ assert unit->y >= -GJK_Q30_ONE && unit->y <= GJK_Q30_ONE;
  if (!GJK_SMALL && (v->x | v->y) == 0) {
    rotated[0] = 0;
    rotated[1] = 0;
    return true;
  }
  // |r| <= 2^30 (1 + 2^-17), |v| <= 2^31.5:  below 2^62
  rotated[0] = gjk2_corrected(gjk_mul32(r->c, v->x) - gjk_mul32(r->s, v->y), excess);
  rotated[1] = gjk2_corrected(gjk_mul32(r->s, v->x) + gjk_mul32(r->c, v->y), excess);
  return true;
}

void gjk2_rotation_product(const gjk2_rotation *a, int64_t off_a, const gjk2_rotation *b, int64_t off_b,
                           gjk2_rotation *out) {
  // |a|^2 |b|^2 - 1 in Q60:  |off| <= 2^44, the product of both / 2^60 <= 2^28
  const int64_t both = gjk_mul32((int32_t)gjk_sar64(off_a, 15), (int32_t)gjk_sar64(off_b, 15));
  const int32_t excess = gjk2_excess(off_a + off_b + gjk_sar64(both, 30));
  // |products|, |partial sums| <= |a| |b| <= 2^60 (1 + 2^-16)
  const int64_t c = gjk_mul32(a->c, b->c) - gjk_mul32(a->s, b->s);
  const int64_t s = gjk_mul32(a->c, b->s) + gjk_mul32(a->s, b->c);
  //@ assert c >= -(INT64_C(1) << 60) - (INT64_C(1) << 44) && c <= (INT64_C(1) << 60) + (INT64_C(1) << 44);
  //@ assert s >= -(INT64_C(1) << 60) - (INT64_C(1) << 44) && s <= (INT64_C(1) << 60) + (INT64_C(1) << 44);
  out->c = gjk2_to_q30(gjk2_corrected(c, excess));
  out->s = gjk2_to_q30(gjk2_corrected(s, excess));
}
