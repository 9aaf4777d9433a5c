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

// Fewest vertices that a hull can be simplified to.
#define GJK2_HULL_SIMPLE_MIN 4

// What gjk2_hull_simplify found.
typedef struct gjk2_hull_simple {
  uint16_t vertices;  // written
  uint32_t excess;    // no point of the simple hull is farther than this from the hull of the points, LSB
} gjk2_hull_simple;

// A hull of at most so many vertices that encloses the hull of the points, exactly. Edges are removed whose neighbours
// meet near them, the nearest first.
//
// most      vertices wanted, from GJK2_HULL_SIMPLE_MIN on (RANGE).
// vertices  room for 2 count of them, the memory that is needed; may not be points. The first ones are the simple hull,
//           counterclockwise from the lowest on, or a box from its lower left corner on.
// Exact     every point is inside or on the simple hull, which is tested in the end. Where the hull has no more vertices
//           than wanted, they are the result, and the excess is 0. The same for any order of the points.
// Excess    measured: at most 4 LSB above the largest distance, never below it. Never more than that of the bounding box.
// Statuses  those of gjk2_polygon_order; then out is not written, vertices may be.
// Cost      rounds of the order of the hull's vertices squared.
gjk_status gjk2_hull_simplify(const gjk2_vec *points, uint16_t count, uint16_t most, gjk2_vec *vertices,
                              gjk2_hull_simple *out);

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
