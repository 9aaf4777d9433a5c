// Debug drawing in the plane: lines and points of colliders, boxes, contacts, casts and scenes, handed to functions of yours.
//
// Nothing is stored, and nothing is linked that is not called. Lines are in the world frame, Q16.16, and come in an order
// that the arguments alone decide. Coordinates beyond int32 are saturated. No line has length 0.
//
// Outlines  points, segments, triangles, boxes and polygons in order by their edges. Shapes that are curved or have a
//           convex radius, and other polygons, by the polygon of the surface points that are farthest in
//           GJK_DRAW_DIRECTIONS directions.
// Accuracy  a vertex is that of the collider; other surface points are within 4 LSB. A circle of radius r is drawn with
//           chords at most r / 100 inside of it.
// Statuses of every call: NULL for a pointer that is missing; UNINITIALISED for a collider that is not posed; CORRUPT for
// a handle whose block is not a scene's.
#ifndef GJK2_DRAW_H
#define GJK2_DRAW_H

#include "gjk2/cast.h"
#include "gjk2/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Where drawing goes. A function that is NULL is not called.
typedef struct gjk2_draw {
  // Draws a line from one point to another.
  void (*line)(void *user, const gjk2_vec *from, const gjk2_vec *to, gjk_draw_role role);
  // Draws a point.
  void (*point)(void *user, const gjk2_vec *at, gjk_draw_role role);
  void *user;  // the first argument of both
} gjk2_draw;

// The outline of a posed collider, in any role.
gjk_status gjk2_draw_collider(const gjk2_draw *draw, const gjk2_collider *collider, gjk_draw_role role);

// The edges of a box.
gjk_status gjk2_draw_box(const gjk2_draw *draw, const gjk2_aabb *box, gjk_draw_role role);

// Each contact: both points and the line between them, and from point_b a line of this length along the normal.
gjk_status gjk2_draw_manifold(const gjk2_draw *draw, const gjk2_manifold *manifold, gjk_q16 length);

// A ray that ended with OK: its way, and at a hit the point and the normal.
gjk_status gjk2_draw_ray(const gjk2_draw *draw, const gjk2_vec *from, const gjk2_vec *to,
                         const gjk2_cast_result *result, gjk_q16 length);

// A cast of B against a shape that stands. Drawn are its outline at the start, and where it rests or, without a hit,
// where the way ends; the way between both positions; and of a hit that is not inside, point_a and the normal.
//
// collider  B at the start.
// Statuses  RANGE: to takes its centre out of int32.
gjk_status gjk2_draw_cast(const gjk2_draw *draw, const gjk2_collider *collider, const gjk2_vec *to,
                          const gjk2_cast_result *result, gjk_q16 length);

// A scene as it is now. what is a sum of GJK_DRAW_SHAPES (outlines of all parts), GJK_DRAW_BOXES (their boxes) and
// GJK_DRAW_PAIRS (pairs near at the last update). Parts of which gjk2_scene_collider makes no collider are left out.
// Statuses  RANGE: what has another bit.
gjk_status gjk2_draw_scene(const gjk2_draw *draw, const gjk2_scene *scene, unsigned what);

#ifdef __cplusplus
}
#endif

#endif
