// Debug drawing: lines and points of colliders, boxes, contacts, casts and scenes, handed to functions of yours.
//
// Nothing is stored, and nothing is linked that is not called. Lines are in the world frame, Q16.16, and come in an order
// that the arguments alone decide. Coordinates beyond int32 are saturated. No line has length 0.
//
// Outlines  points, segments, triangles and boxes by their edges, hulls by the edges of the faces that they have. Shapes
//           that are curved or have a convex radius, and hulls without faces, by three silhouettes: as seen along each axis
//           of the world, each the polygon of the surface points that are farthest in GJK_DRAW_DIRECTIONS directions. Of a
//           rounded polytope the edges of its core as well.
// Accuracy  a vertex is that of the collider; other surface points are within 4 LSB. A circle of radius r is drawn with
//           chords at most r / 100 inside of it.
// Statuses of every call: NULL for a pointer that is missing; UNINITIALISED for a collider that is not posed; CORRUPT for
// a handle whose block is not a scene's.
#ifndef GJK_DRAW_H
#define GJK_DRAW_H

#include "gjk/cast.h"
#include "gjk/parts.h"
#include "gjk/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Where drawing goes. A function that is NULL is not called.
typedef struct gjk_draw {
  // Draws a line from one point to another.
  void (*line)(void *user, const gjk_vec3 *from, const gjk_vec3 *to, gjk_draw_role role);
  // Draws a point.
  void (*point)(void *user, const gjk_vec3 *at, gjk_draw_role role);
  void *user;  // the first argument of both
} gjk_draw;

// The outline of a posed collider, in any role.
gjk_status gjk_draw_collider(const gjk_draw *draw, const gjk_collider *collider, gjk_draw_role role);

// The edges of a box.
gjk_status gjk_draw_box(const gjk_draw *draw, const gjk_aabb *box, gjk_draw_role role);

// Each contact: both points and the line between them, and from point_b a line of this length along the normal.
gjk_status gjk_draw_manifold(const gjk_draw *draw, const gjk_manifold *manifold, gjk_q16 length);

// A ray that ended with OK: its way, and at a hit the point and the normal.
gjk_status gjk_draw_ray(const gjk_draw *draw, const gjk_vec3 *from, const gjk_vec3 *to, const gjk_cast_result *result,
                        gjk_q16 length);

// A cast of B against a shape that stands. Drawn are its outline at the start, and where it rests or, without a hit,
// where the way ends; the way between both positions; and of a hit that is not inside, point_a and the normal.
//
// collider  B at the start.
// Statuses  RANGE: to takes its centre out of int32.
gjk_status gjk_draw_cast(const gjk_draw *draw, const gjk_collider *collider, const gjk_vec3 *to,
                         const gjk_cast_result *result, gjk_q16 length);

// A scene as it is now. what is a sum of GJK_DRAW_SHAPES (outlines of all parts), GJK_DRAW_BOXES (their boxes) and
// GJK_DRAW_PAIRS (pairs near at the last update). Parts of which gjk_scene_collider makes no collider are left out.
// Statuses  RANGE: what has another bit.
gjk_status gjk_draw_scene(const gjk_draw *draw, const gjk_scene *scene, unsigned what);

// The outlines of parts of a compound, mesh or height field.
//
// near   a box in the world: of each part with a point in it, and of no part whose box does not meet it. NULL: of all.
// most   at most so many parts, in the order in which they are found, which data alone decides.
// drawn  how many were; may be NULL.
// Statuses  CAPACITY: the same; there are more than most. Those of gjk/parts.h: nothing is drawn. RANGE: also, where near
//           ends before it begins.
gjk_status gjk_draw_parts(const gjk_draw *draw, const gjk_parts *parts, const gjk_aabb *near, uint32_t most,
                          gjk_draw_role role, uint32_t *drawn);

// What gjk_draw_scene leaves out: the concave parts of a scene (gjk/concave.h), as gjk_draw_parts, most of all together.
gjk_status gjk_draw_scene_concave(const gjk_draw *draw, const gjk_scene *scene, const gjk_aabb *near, uint32_t most,
                                  gjk_draw_role role, uint32_t *drawn);

#ifdef __cplusplus
}
#endif

#endif
