// How far points lie beyond a hull.
#ifndef GJK_SRC_HULL_EXCESS_H
#define GJK_SRC_HULL_EXCESS_H

#include "gjk_hull_grow.h"

// The normal of a plane as a unit.
gjk_unit3 gjk_hull_unit(const gjk_hull_plane *plane);

// The largest distance of points from a hull, at most 2 LSB too large, never too small. least: room for count numbers.
// Pre: components of differences of all these points are below 2^30.
uint32_t gjk_hull_excess(const gjk_hull_work *w, const gjk_vec3 *points, uint16_t count, uint32_t *least);

#endif
