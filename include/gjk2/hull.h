// The convex hull of points of the plane, exactly, and the check of an outline.
#ifndef GJK2_HULL_H
#define GJK2_HULL_H

#include "gjk/status.h"
#include "gjk2/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// What gjk2_hull_build found.
typedef struct gjk2_hull {
  uint8_t dimension;    // of the points: 0 to 2
  uint16_t vertices;    // written; 1 and 2 of points of dimension 0 and 1
  uint64_t twice_area;  // square LSB, exact
} gjk2_hull;

// Finds the hull: gjk2_polygon_order of gjk2/polygon.h, with its dimension and area.
//
// points    the caller's, in any order, repeated ones too.
// vertices  room for count of them, which is all the memory that is needed; may be points itself.
// Exact     the vertices are those of the real hull, counterclockwise from the lowest on, the same for any order of the
//           points.
// Statuses  those of gjk2_polygon_order.
gjk_status gjk2_hull_build(const gjk2_vec *points, uint16_t count, gjk2_vec *vertices, gjk2_hull *out);

// What is wrong with an outline.
typedef enum gjk2_hull_fault {
  GJK2_HULL_SOUND = 0,  // nothing
  GJK2_HULL_FEW,        // fewer than 3 vertices
  GJK2_HULL_REPEATED,   // a vertex at the place of the one before
  GJK2_HULL_STRAIGHT,   // a vertex within an edge, or a way straight back
  GJK2_HULL_TURN,       // a vertex where the outline turns right: it is concave, or runs clockwise
  GJK2_HULL_LAYERS      // it turns left everywhere, but goes more than once around
} gjk2_hull_fault;

// What gjk2_hull_check found.
typedef struct gjk2_hull_report {
  uint8_t fault;    // a gjk2_hull_fault, the first in their order
  uint16_t vertex;  // the first vertex that has it; LAYERS, FEW: 0
} gjk2_hull_report;

// Is an outline convex, counterclockwise, once around, without a vertex to spare?
//
// vertices  count of them, no more than 2 GJK2_RADIUS_MAX apart along an axis (SIZE).
// Statuses  NULL; EMPTY. OK: out is written, whatever it says.
gjk_status gjk2_hull_check(const gjk2_vec *vertices, uint16_t count, gjk2_hull_report *out);

#ifdef __cplusplus
}
#endif

#endif
