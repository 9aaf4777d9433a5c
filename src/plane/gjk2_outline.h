// An outline: vertices in order around a convex polygon.
#ifndef GJK2_SRC_OUTLINE_H
#define GJK2_SRC_OUTLINE_H

#include "gjk2/hull.h"
#include "gjk2_vector.h"

// Are the points at most 2 GJK2_RADIUS_MAX apart along each axis? Pre: there is one.
bool gjk2_outline_fits(const gjk2_vec *v, uint32_t count);

// What is wrong with an outline that fits.
void gjk2_outline_check(const gjk2_vec *v, uint32_t count, gjk2_hull_report *out);

#endif
