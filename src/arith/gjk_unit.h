// Unit vectors and lengths along them, rounded: for what a query reports, never for what it decides.
#ifndef GJK_SRC_UNIT_H
#define GJK_SRC_UNIT_H

#include "gjk_vector.h"

// d / |d|, Q2.30, each component within 1 LSB for the given d; exact along an axis. Pre: d != 0, |d| < 2^31.
gjk_unit3 gjk_unit(const gjk_vec3 *d);

// u . a, Q30, for a unit vector u.
static inline int64_t gjk_along(const gjk_unit3 *u, const gjk_vec3 *a) {
  return gjk_mac32(gjk_mac32(gjk_mul32(u->x, a->x), u->y, a->y), u->z, a->z);  // |a| <= 3 2^29:  |u . a| <= 2^61
}

#endif
