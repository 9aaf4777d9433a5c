// Debug drawing: lines and points of colliders, boxes, contacts, casts and scenes, passed to your own functions.
//
// Nothing is stored, and a program links only what it calls. Lines are in the world frame, Q16.16. Their order depends
// only on the arguments. Coordinates beyond int32 are saturated. No line has length 0.
//
// Outlines  Points, segments, triangles and boxes are drawn by their edges, hulls by the edges of their faces. Curved
//           shapes, shapes with a convex radius, and hulls without faces are drawn by three silhouettes, one along each
//           world axis. Each is the polygon of the surface points farthest in GJK_DRAW_DIRECTIONS directions. A rounded
//           polytope shows the edges of its core as well.
// Accuracy  Vertices are those of the collider; other surface points are within 4 LSB. The chords of a circle of radius
//           r are at most r / 100 inside it.
// Statuses of every call: NULL (a missing pointer), UNINITIALISED (a collider that is not posed), CORRUPT (a handle
// whose block is not a scene).
#ifndef GJK_DRAW_H
#define GJK_DRAW_H

#include "gjk/cast.h"
#include "gjk/parts.h"
#include "gjk/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions that draw. A function that is NULL is not called.
typedef struct gjk_draw {
  // Draws a line from one point to another.
  void (*line)(void *user, const gjk_vec3 *from, const gjk_vec3 *to, gjk_draw_role role);
  // Draws a point.
  void (*point)(void *user, const gjk_vec3 *at, gjk_draw_role role);
  void *user;  // the first argument of both functions
} gjk_draw;

// Draws the outline of a posed collider, in any role.
gjk_status gjk_draw_collider(const gjk_draw *draw, const gjk_collider *collider, gjk_draw_role role);

// Draws the edges of a box.
gjk_status gjk_draw_box(const gjk_draw *draw, const gjk_aabb *box, gjk_draw_role role);

// Draws each contact: both points, the line between them, and a line of this length along the normal from point_b.
gjk_status gjk_draw_manifold(const gjk_draw *draw, const gjk_manifold *manifold, gjk_q16 length);

// Draws a ray whose cast ended with OK: its way, and after a hit the point and the normal.
gjk_status gjk_draw_ray(const gjk_draw *draw, const gjk_vec3 *from, const gjk_vec3 *to, const gjk_cast_result *result,
                        gjk_q16 length);

// Draws a cast of B against a shape that does not move. It shows B's outline at the start and where it comes to rest,
// which without a hit is the end. It shows the way between, and after a hit that is not inside, point_a and the normal.
//
// collider  B at the start.
// Statuses  RANGE: to takes the centre of B out of int32.
gjk_status gjk_draw_cast(const gjk_draw *draw, const gjk_collider *collider, const gjk_vec3 *to,
                         const gjk_cast_result *result, gjk_q16 length);

// Draws a scene as it is now. what is a sum of GJK_DRAW_SHAPES (outlines of all parts), GJK_DRAW_BOXES (their boxes)
// and GJK_DRAW_PAIRS (pairs near at the last update). Parts that gjk_scene_collider refuses are left out.
// Statuses  RANGE: what has another bit.
gjk_status gjk_draw_scene(const gjk_draw *draw, const gjk_scene *scene, unsigned what);

// Draws the outlines of parts of a compound, mesh or height field.
//
// near   a box in the world: parts with a point in it are drawn, parts whose boxes miss it are not. NULL: all parts.
// most   the most parts drawn. They come in the order in which they are found, which depends only on the data.
// drawn  the number of parts drawn; may be NULL.
// Statuses  CAPACITY: the same; there are more parts than most. RANGE: near ends before it begins. With RANGE and all
//           statuses of gjk/parts.h, nothing is drawn.
gjk_status gjk_draw_parts(const gjk_draw *draw, const gjk_parts *parts, const gjk_aabb *near, uint32_t most,
                          gjk_draw_role role, uint32_t *drawn);

// Draws a scene's concave parts (gjk/concave.h), which gjk_draw_scene leaves out. As gjk_draw_parts; most counts all.
gjk_status gjk_draw_scene_concave(const gjk_draw *draw, const gjk_scene *scene, const gjk_aabb *near, uint32_t most,
                                  gjk_draw_role role, uint32_t *drawn);

#ifdef __cplusplus
}
#endif

#endif
