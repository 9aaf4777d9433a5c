// What the kinds without vertices share.
#include "gjk_curved.h"

#include "../arith/gjk_rotation.h"
#include "../arith/gjk_unit.h"

void gjk_curved_pose(gjk_collider *c, const gjk_vec3 rows[3]) {
  for (int i = 0; i < 3; i++) {
    c->frame[i] = rows[i];
  }
}

gjk_vec3 gjk_curved_direction(const gjk_collider *c, const gjk_vec3 *d) {
  gjk_vec3 scaled = gjk_scale_direction(d);
  return gjk_rotate_back(c->frame, &scaled);
}

void gjk_curved_support(const gjk_collider *c, const gjk_fine_point *point, gjk_support *out) {
  const gjk_vec3 local = {point->x, point->y, point->z};
  int64_t world[3];
  gjk_rotate_wide(c->frame, &local, world);
  const int64_t half = 1 << (GJK_FINE_BITS - 1);
  out->offset.x = (int32_t)gjk_sar64(world[0] + half, GJK_FINE_BITS);
  out->offset.y = (int32_t)gjk_sar64(world[1] + half, GJK_FINE_BITS);
  out->offset.z = (int32_t)gjk_sar64(world[2] + half, GJK_FINE_BITS);
  out->vertex = 0;
}

gjk_fine_point gjk_fine_stretch(const gjk_vec3 *size, const gjk_long3 *d) {
  gjk_search_direction rounded;
  gjk_search_direction_of(d, &rounded);
  const gjk_unit3 u = gjk_unit(&rounded.d);
  const gjk_fine_point point = {gjk_fine(size->x, u.x), gjk_fine(size->y, u.y), gjk_fine(size->z, u.z)};
  return point;
}

int32_t gjk_fine(gjk_q16 size, gjk_q30 u) {
  const unsigned shift = 30 - GJK_FINE_BITS;
  return (int32_t)gjk_sar64(gjk_mul32(size, u) + (INT64_C(1) << (shift - 1)), shift);
}

bool gjk_curved_stalls(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late) {
  const gjk_vec3 step = gjk_sub(*to, *from);  // |d . step| < 2^62;  |d|_1 <= sqrt(3) |d| < 2^32, times 2^29 < 2^61
  return gjk_dot(d, &step) <= gjk_sar64(gjk_shl64(gjk_norm1(*d), shift > 0 ? (unsigned)shift : 0), late ? 1 : 3);
}
