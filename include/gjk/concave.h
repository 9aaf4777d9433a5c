// Concave bodies in a scene: a mesh, a height field or a compound as one part of a body.
//
//     static const gjk_parts hills = GJK_PARTS_OF_MESH(&mesh);
//     static gjk_concave ground;
//     static gjk_shape ground_shape;
//     gjk_concave_init(&hills, &ground, &ground_shape);  // then &ground_shape goes into the scene's table of shapes
//
// A part of such a shape is like any other. Its body may be static or move and may have more parts; the part may have a
// pose of its own. Whatever the scene answers about it is what gjk/parts.h answers about the body of many parts at the
// part's pose. Updates ask gjk_parts_within, gjk_parts_distance, gjk_parts_penetration and gjk_parts_manifolds. Rays
// and casts ask gjk_parts_cast_ray and gjk_parts_cast. So nothing depends on the tree, on caches or skips.
//
// Saves    hold the index of the shape, as of any other. Peers need the same meshes, as they need the same shapes.
// Boxes    gjk_scene_query_box and gjk_scene_query_ray take such a part for its box in its own frame, turned.
// Drawing  gjk_draw_scene leaves such a part out, and its pairs. gjk_draw_scene_concave draws what is near a box.
// Numbers  Triangles are not numbered in reports. For a triangle's number, query the part that gjk_scene_parts gives.
// Fast     A body that touches such a part at the start of its way, and was near it at the last update, may still meet
//          another triangle or part of it: one in front of which it was at the start. gjk_parts_cast_ahead has the rule.
//          A part is in front of nothing that it touches. Two concave parts that touch at the start do not meet later.
// Cost     an update asks each pair whose boxes meet anew when a body of it moved, at the cost of gjk/parts.h: that grows
//          with the triangles that are near. Convex bodies cost what they cost without such shapes.
// Links    the queries of gjk/parts.h, casts and impacts too; a program without such shapes links none of them.
//
// Bodies of a few convex shapes that move are as well given as parts of the body (gjk/scene.h), whose pairs are reported
// part by part. A compound takes less of the block's memory: it is one part, whatever it holds.
#ifndef GJK_CONCAVE_H
#define GJK_CONCAVE_H

#include "gjk/parts.h"
#include "gjk/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// The class of shapes of many parts, which GJK_CONCAVE and gjk_concave_init name.
extern const gjk_shape_class gjk_class_concave;

// No point of a concave part may be farther from its origin: 8191 units.
#define GJK_CONCAVE_REACH ((gjk_q16)536805376)

// What a shape of many parts is made of. gjk_concave_init fills it; as a constant it may be in flash.
typedef struct gjk_concave {
  gjk_parts parts;  // its pose is not read
  gjk_vec3 centre;  // of the box that holds all parts, in their frame
} gjk_concave;

// The shape of a concave body whose gjk_concave and half extents are known, as a constant. A scene refuses one that names
// no body (NULL) or no parts (EMPTY). What else gjk_concave_init checks is the caller's to know: where parts beyond their
// reach have no answer, a pair counts as near, unsettled, at distance 0.
#define GJK_CONCAVE(concave_pointer, half_x, half_y, half_z)                                                          \
  {                                                                                                                   \
    &gjk_class_concave, 0, 0, 1 ? (concave_pointer) : (const gjk_concave *)0, GJK_LENGTHS(half_x, half_y, half_z, 0), \
        0, 0                                                                                                          \
  }

// Makes a shape of a body of many parts.
//
// parts   read during the call alone; its data is the caller's, and must outlive the shape.
// out     the caller's, must outlive the shape.
// shape   the caller's. gjk_collider_init refuses it (UNSUPPORTED): only a scene takes it.
// Box     of all parts, and 64 LSB on each side for what posing rounds.
// Statuses  those of gjk/parts.h; SIZE: a point of a part is farther than GJK_CONCAVE_REACH from the origin, or than
//           GJK_RADIUS_MAX from the middle of the box.
// Cost      one pass over all parts.
gjk_status gjk_concave_init(const gjk_parts *parts, gjk_concave *out, gjk_shape *shape);

// A concave part at its current pose, for any query of gjk/parts.h. gjk_scene_collider refuses such parts.
// Statuses: BODY_ID, RANGE for a part that is not there, UNSUPPORTED for one that is not concave.
gjk_status gjk_scene_parts(const gjk_scene *scene, gjk_body_id id, uint16_t part, gjk_parts *out);

// All manifolds of a reported pair at its bodies' current poses, the deepest first: contacts of different normals need
// one each. gjk_scene_manifold, and so the manifold of a report, is the first of them. Of two convex parts there is one.
//
// out       room for capacity manifolds, 1 to GJK_PARTS_MANIFOLDS_MAX (RANGE).
// count     how many there are in out.
// Normals   of a surface are those of gjk_surface_contacts. gjk_parts_manifolds puts them together, with room for
//           GJK_PARTS_MANIFOLDS_MAX whatever capacity is: fewer are the first of them.
// Statuses  as of gjk_scene_manifold; nothing is written but after OK and CAPACITY.
gjk_status gjk_scene_manifolds(const gjk_scene *scene, const gjk_report *report, unsigned most, gjk_manifold *out,
                               unsigned capacity, unsigned *count);

#ifdef __cplusplus
}
#endif

#endif
