// Concave bodies in a scene: a mesh, a height field or a compound as one part of a body.
//
//     static const gjk_parts hills = GJK_PARTS_OF_MESH(&mesh);
//     static gjk_concave ground;
//     static gjk_shape ground_shape;
//     gjk_concave_init(&hills, &ground, &ground_shape);  // then &ground_shape goes into the scene's table of shapes
//
// A part with such a shape is like any other. Its body may be static or move, and may have more parts. The part may
// have a pose of its own. The scene answers about the part what gjk/parts.h answers about the body of many parts at the
// part's pose. Updates call gjk_parts_within, gjk_parts_distance, gjk_parts_penetration and gjk_parts_manifolds. Rays
// and casts call gjk_parts_cast_ray and gjk_parts_cast. So no answer depends on the tree, caches or skips.
//
// Saves    hold the index of the shape, as for any shape. Lockstep peers need the same meshes.
// Boxes    gjk_scene_query_box and gjk_scene_query_ray treat such a part as its own box, turned with it.
// Drawing  gjk_draw_scene leaves out such a part and its pairs. gjk_draw_scene_concave draws what is near a box.
// Numbers  Reports do not give triangle numbers. To get one, query the part that gjk_scene_parts returns.
// Fast     A fast body may touch such a part at the start of its way, and have been near it at the last update. It can
//          then still meet the triangles or parts that it was in front of at the start (gjk_parts_cast_ahead). It is
//          never in front of one that it touches. Two concave parts that touch at the start do not meet later.
// Cost     when a body of a pair has moved, an update queries the pair anew if the boxes meet. The cost is that of
//          gjk/parts.h, which grows with the triangles nearby. The cost of convex bodies does not change.
// Links    all queries of gjk/parts.h, casts and impacts included. A program without such shapes links none of them.
//
// A moving body of a few convex shapes may have them as its own parts instead (gjk/scene.h), which are reported pair by
// pair. A compound takes less memory in the block, because it is one part.
#ifndef GJK_CONCAVE_H
#define GJK_CONCAVE_H

#include "gjk/parts.h"
#include "gjk/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// The class of shapes of many parts. GJK_CONCAVE and gjk_concave_init name it.
extern const gjk_shape_class gjk_class_concave;

// The largest distance of a point of a concave part from the part's origin: 8191 units.
#define GJK_CONCAVE_REACH ((gjk_q16)536805376)

// The data of a shape of many parts. gjk_concave_init fills it; as a constant it may be in flash.
typedef struct gjk_concave {
  gjk_parts parts;  // the body; its pose is not read
  gjk_vec3 centre;  // centre of the box that holds all parts, in their frame
} gjk_concave;

// The constant shape of a concave body whose gjk_concave and half extents are known. A scene refuses one without a body
// (NULL) or without parts (EMPTY). The caller answers for all else that gjk_concave_init checks. If parts beyond their
// reach leave a pair without an answer, it counts as near and unsettled, at distance 0.
#define GJK_CONCAVE(concave_pointer, half_x, half_y, half_z)                                                          \
  {                                                                                                                   \
    &gjk_class_concave, 0, 0, 1 ? (concave_pointer) : (const gjk_concave *)0, GJK_LENGTHS(half_x, half_y, half_z, 0), \
        0, 0                                                                                                          \
  }

// Makes the shape of a body of many parts.
//
// parts     read only during the call; its data are the caller's and must outlive the shape.
// out       the caller's, must outlive the shape.
// shape     the caller's, for scenes only: gjk_collider_init refuses it (UNSUPPORTED).
// Box       that of all parts, with 64 LSB more on each side for the rounding of posing.
// Statuses  those of gjk/parts.h. SIZE: a point of a part is more than GJK_CONCAVE_REACH from the origin, or more than
//           GJK_RADIUS_MAX from the middle of the box.
// Cost      one pass over all parts.
gjk_status gjk_concave_init(const gjk_parts *parts, gjk_concave *out, gjk_shape *shape);

// A concave part at its current pose, for any query of gjk/parts.h. gjk_scene_collider refuses such parts.
// Statuses: BODY_ID, RANGE (no such part), UNSUPPORTED (the part is not concave).
gjk_status gjk_scene_parts(const gjk_scene *scene, gjk_body_id id, uint16_t part, gjk_parts *out);

// All manifolds of a reported pair at its bodies' current poses, the deepest first. Each direction of contact has one.
// The first is the one of gjk_scene_manifold and of the report. A pair of convex parts has only one.
//
// out       room for capacity manifolds, 1 to GJK_PARTS_MANIFOLDS_MAX (RANGE).
// count     the number of manifolds in out.
// Normals   On surfaces, those of gjk_surface_contacts. gjk_parts_manifolds merges them with room for
//           GJK_PARTS_MANIFOLDS_MAX, whatever capacity is. out has the first capacity of these.
// Statuses  as in gjk_scene_manifold. Only OK and CAPACITY write anything.
gjk_status gjk_scene_manifolds(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out,
                               unsigned capacity, unsigned *count);

#ifdef __cplusplus
}
#endif

#endif
