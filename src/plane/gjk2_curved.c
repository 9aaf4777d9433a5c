// What the kinds without vertices share.
#include "gjk2_curved.h"

#include "gjk2_measure.h"
#include "gjk2_rotation.h"

void gjk2_curved_pose(gjk2_collider *c, const gjk2_vec *rotation) {
  c->frame[0] = *rotation;
}

gjk2_vec gjk2_curved_direction(const gjk2_collider *c, gjk2_vec d) {
  const unsigned zeros = gjk_clz32(gjk_magnitude32(d.x) | gjk_magnitude32(d.y)), k = zeros > 2 ? zeros - 2 : 0;
  const gjk2_vec scaled = {gjk_shl32(d.x, k), gjk_shl32(d.y, k)};
  return gjk2_rotate_back(&c->frame[0], scaled);
}

void gjk2_curved_support(const gjk2_collider *c, gjk2_vec point, gjk2_support *out) {
  const gjk2_vec unit = c->frame[0];
  const unsigned shift = 30 + GJK2_FINE_BITS;
  const int64_t half = INT64_C(1) << (shift - 1);
  // |point| <= 2^30, |unit| <= 2^30 + 1:  below 2^61
  out->offset.x = (int32_t)gjk_sar64(gjk_mac32(gjk_mul32(unit.x, point.x), -unit.y, point.y) + half, shift);
  out->offset.y = (int32_t)gjk_sar64(gjk_mac32(gjk_mul32(unit.y, point.x), unit.x, point.y) + half, shift);
  out->vertex = 0;
}

// size u in fine units, to the nearest. Pre: size at most 2^28, |u| <= 2^30 + 1.
static int32_t fine(gjk_q16 size, gjk_q30 u) {
  const unsigned shift = 30 - GJK2_FINE_BITS;
  return (int32_t)gjk_sar64(gjk_mul32(size, u) + (INT64_C(1) << (shift - 1)), shift);
}

gjk2_vec gjk2_fine_stretch(gjk2_vec size, int64_t x, int64_t y) {
  // Scale to the 30 leading bits.
  const unsigned zeros = gjk_clz64(gjk_magnitude64(x) | gjk_magnitude64(y));
  gjk2_vec d;
  if (zeros >= 34) {
    d.x = (int32_t)gjk_shl64(x, zeros - 34);
    d.y = (int32_t)gjk_shl64(y, zeros - 34);
  } else {
    d.x = (int32_t)gjk_sar64(x, 34 - zeros);
    d.y = (int32_t)gjk_sar64(y, 34 - zeros);
  }
  gjk2_length length;
  gjk2_unit u;
  gjk2_normal_set(&u, &length, &d);
  const gjk2_vec point = {fine(size.x, u.x), fine(size.y, u.y)};
  return point;
}
