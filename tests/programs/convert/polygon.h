// Polygons of a file, cut into triangles.
#ifndef POLYGON_H
#define POLYGON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "gjk/format.h"

// Cuts a polygon into corners - 2 triangles, which are turned as it is. They are those that share its first corner, where all
// of these are turned as it is, none without area; so it is with strictly convex polygons. Else ears are cut off, exactly, as seen along the axis
// from which the polygon looks largest.
//
// points    of the whole mesh; at[i] is the number of corner i.
// triangle  corners - 2 of them.
//
// A polygon that crosses itself may leave triangles that overlap; its edges are kept all the same.
void polygon_cut(const gjk_vec3 *points, const uint32_t *at, size_t corners, uint32_t (*triangle)[3]);

#endif
