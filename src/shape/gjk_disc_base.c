// The disc base that cylinder and cone share.
#include "gjk_disc_base.h"

#include "../arith/gjk_unit.h"

gjk_status gjk_disc_base_measure(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 *size = &shape->size;
  const gjk_vec3 origin = {0, 0, 0};
  if (size->x < 0 || size->z < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  out->centre = origin;
  // Each square <= 2^62:  squared <= 2^63
  out->squared = (uint64_t)gjk_mul32(size->x, size->x) + (uint64_t)gjk_mul32(size->z, size->z);
  return GJK_OK;
}

void gjk_rim(gjk_q16 radius, const gjk_vec3 *d, gjk_fine_point *point) {
  const gjk_vec3 level = {d->x, d->y, 0};
  point->x = 0;
  point->y = 0;
  if (d->x != 0 || d->y != 0) {
    const gjk_unit3 u = gjk_unit(&level);
    point->x = gjk_fine(radius, u.x);
    point->y = gjk_fine(radius, u.y);
  }
}
