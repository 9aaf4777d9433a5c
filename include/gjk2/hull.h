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
  uint8_t dimension;    // dimension of the points, 0 to 2
  uint16_t vertices;    // vertices written; 1 and 2 for points of dimension 0 and 1
  uint64_t twice_area;  // twice the area in square LSB, exact
} gjk2_hull;

// Finds the hull as gjk2_polygon_order of gjk2/polygon.h does, with its dimension and area.
//
// points    the caller's, in any order; may repeat.
// vertices  room for count vertices, which is all the memory needed; may be points itself.
// Exact     the vertices are those of the real hull, counterclockwise from the lowest, for any order of the points.
// Statuses  those of gjk2_polygon_order.
gjk_status gjk2_hull_build(const gjk2_vec *points, uint16_t count, gjk2_vec *vertices, gjk2_hull *out);

// The fewest vertices that a hull can be simplified to.
#define GJK2_HULL_SIMPLE_MIN 4

// What gjk2_hull_simplify found.
typedef struct gjk2_hull_simple {
  uint16_t vertices;  // vertices written
  uint32_t excess;    // bound of the distance from a point of the simple hull to the hull of the points, LSB
} gjk2_hull_simple;

// Makes a hull of at most a given number of vertices that encloses the hull of the points, exactly. It removes edges
// whose neighbours meet near them, the nearest first.
//
// most      the most vertices, at least GJK2_HULL_SIMPLE_MIN (RANGE).
// vertices  room for 2 count vertices, all the memory needed; must not be points. The simple hull comes first. It runs
//           counterclockwise from its lowest vertex, or if it is a box from its lower left corner.
// Exact     every point is inside or on the simple hull; a final test makes sure. If the hull has no more than most
//           vertices, they are the result, and the excess is 0. The result is the same for any order of the points.
// Excess    measured: never below the largest distance, and at most 4 LSB above it; at most that of the bounding box.
// Statuses  those of gjk2_polygon_order; then out is not written, but vertices may be.
// Cost      rounds of the order of the hull's vertices squared.
gjk_status gjk2_hull_simplify(const gjk2_vec *points, uint16_t count, uint16_t most, gjk2_vec *vertices,
                              gjk2_hull_simple *out);

// What is wrong with an outline.
typedef enum gjk2_hull_fault {
  GJK2_HULL_SOUND = 0,  // nothing
  GJK2_HULL_FEW,        // fewer than 3 vertices
  GJK2_HULL_REPEATED,   // a vertex at the place of the one before it
  GJK2_HULL_STRAIGHT,   // a vertex within an edge, or an edge straight back
  GJK2_HULL_TURN,       // a vertex where the outline turns right: it is concave, or runs clockwise
  GJK2_HULL_LAYERS      // the outline turns left everywhere, but goes around more than once
} gjk2_hull_fault;

// What gjk2_hull_check found.
typedef struct gjk2_hull_report {
  uint8_t fault;    // a gjk2_hull_fault: the first that applies, in the order of the enumeration
  uint16_t vertex;  // the first vertex with the fault; LAYERS, FEW: 0
} gjk2_hull_report;

// Is an outline convex and counterclockwise, once around, with no superfluous vertex?
//
// vertices  count vertices, at most 2 GJK2_RADIUS_MAX apart along an axis (SIZE).
// Statuses  NULL; EMPTY. OK: out is written, with or without a fault.
gjk_status gjk2_hull_check(const gjk2_vec *vertices, uint16_t count, gjk2_hull_report *out);

#ifdef __cplusplus
}
#endif

#endif
