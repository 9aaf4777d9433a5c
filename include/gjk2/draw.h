// Debug drawing in the plane: lines and points of colliders, boxes, contacts, casts and scenes, for your functions.
//
// Nothing is stored, and a program links only what it calls. Lines are in the world frame, Q16.16. Their order depends
// only on the arguments. Coordinates beyond int32 are saturated. No line has length 0.
//
// Outlines  Points, segments, triangles, boxes and ordered polygons are drawn by their edges. Curved shapes, shapes
//           with a convex radius, and other polygons are drawn by one polygon. Its corners are the surface points
//           farthest in GJK_DRAW_DIRECTIONS directions.
// Accuracy  Vertices are those of the collider; other surface points are within 4 LSB. The chords of a circle of radius
//           r are at most r / 100 inside it.
// Statuses of every call: NULL (a missing pointer), UNINITIALISED (a collider that is not posed), CORRUPT (a handle
// whose block is not a scene).
#ifndef GJK2_DRAW_H
#define GJK2_DRAW_H

#include "gjk2/cast.h"
#include "gjk2/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions that draw. A function that is NULL is not called.
typedef struct gjk2_draw {
  // Draws a line from one point to another.
  void (*line)(void *user, const gjk2_vec *from, const gjk2_vec *to, gjk_draw_role role);
  // Draws a point.
  void (*point)(void *user, const gjk2_vec *at, gjk_draw_role role);
  void *user;  // the first argument of both functions
} gjk2_draw;

// Draws the outline of a posed collider, in any role.
gjk_status gjk2_draw_collider(const gjk2_draw *draw, const gjk2_collider *collider, gjk_draw_role role);

// Draws the edges of a box.
gjk_status gjk2_draw_box(const gjk2_draw *draw, const gjk2_aabb *box, gjk_draw_role role);

// Draws each contact: both points, the line between them, and a line of this length along the normal from point_b.
gjk_status gjk2_draw_manifold(const gjk2_draw *draw, const gjk2_manifold *manifold, gjk_q16 length);

// Draws a ray whose cast ended with OK: its way, and after a hit the point and the normal.
gjk_status gjk2_draw_ray(const gjk2_draw *draw, const gjk2_vec *from, const gjk2_vec *to,
                         const gjk2_cast_result *result, gjk_q16 length);

// Draws a cast of B against a shape that does not move. It shows B's outline at the start and where it comes to rest,
// which without a hit is the end. It shows the way between, and after a hit that is not inside, point_a and the normal.
//
// collider  B at the start.
// Statuses  RANGE: to takes the centre of B out of int32.
gjk_status gjk2_draw_cast(const gjk2_draw *draw, const gjk2_collider *collider, const gjk2_vec *to,
                          const gjk2_cast_result *result, gjk_q16 length);

// Draws a scene as it is now. what is a sum of GJK_DRAW_SHAPES (outlines of all parts), GJK_DRAW_BOXES (their boxes)
// and GJK_DRAW_PAIRS (pairs near at the last update). Parts that gjk2_scene_collider refuses are left out.
// Statuses  RANGE: what has another bit.
gjk_status gjk2_draw_scene(const gjk2_draw *draw, const gjk2_scene *scene, unsigned what);

#ifdef __cplusplus
}
#endif

#endif
