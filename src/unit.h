// Unit vectors and lengths along them, rounded: for what a query reports, never for what it decides.
#ifndef GJK_SRC_UNIT_H
#define GJK_SRC_UNIT_H

#include "vector.h"

// d / |d|, Q2.30, each component within 1 LSB for the given d. Pre: d != 0, |d| < 2^31.
gjk_unit3 gjk_unit(const gjk_vec3 *d);

#endif
