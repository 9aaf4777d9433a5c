// Unit vectors and lengths along them, rounded: for what a query reports, never for what it decides.
#ifndef GJK_SRC_UNIT_H
#define GJK_SRC_UNIT_H

#include "vector.h"

// d / |d|, Q2.30, each component within 1.5 LSB for an exact d. inexact: d is a floor, its fraction unknown; the middle is
// taken, and the direction is then within 2^-29 + 2^-30. Pre: d != 0; |d| <= 2^30 per component, 3 2^29 when exact.
gjk_unit3 gjk_unit(const gjk_vec3 *d, bool exact);

#endif
