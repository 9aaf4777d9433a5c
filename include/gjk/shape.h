// Shapes: convex geometry in its own frame, constant, fit for flash.
//
// A shape is a core and a convex radius around it: a sphere is a point with a radius, a capsule a segment with one.
// Long axes lie along local z. An initialiser makes each kind of shape:
//
//     static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.25));
//
// An initialiser names the class of its kind. So a program links only the kinds that it mentions.
#ifndef GJK_SHAPE_H
#define GJK_SHAPE_H

#include "gjk/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions behind a kind of shape, opaque: one constant per kind.
typedef struct gjk_shape_class gjk_shape_class;

// The class of each kind of shape. The initialisers below name them.
extern const gjk_shape_class gjk_class_point;
extern const gjk_shape_class gjk_class_segment;
extern const gjk_shape_class gjk_class_box;
extern const gjk_shape_class gjk_class_triangle;
extern const gjk_shape_class gjk_class_hull;
extern const gjk_shape_class gjk_class_table;
extern const gjk_shape_class gjk_class_cylinder;
extern const gjk_shape_class gjk_class_cone;
extern const gjk_shape_class gjk_class_ellipsoid;
extern const gjk_shape_class gjk_class_custom;

// The support function of a custom shape. It writes the shape's farthest point along direction to out.
//
// user       the shape's user pointer.
// direction  local frame, not zero, of any length up to 2^31.
// out        local frame, Q16.16; the local origin on entry. If the point is farther than size.x from that origin, it
//            is pulled back onto this bound. A port with asserts stops instead. If the point is e LSB from the true
//            farthest one, decisions and distances are right to within e LSB more.
typedef void gjk_support_function(const void *user, const gjk_vec3 *direction, gjk_vec3 *out);

// The faces of a hull: convex polygons of 3 to GJK_FACE_CORNERS_MAX corners. Contacts, mass properties and drawing use
// them. GJK_HULL_CORNERS_MAX and GJK_HULL_FACES_MAX (gjk/hull.h) size the arrays.
typedef struct gjk_hull_faces {
  const uint16_t *corner;  // vertex numbers of all faces, face after face, each counterclockwise seen from outside
  const uint16_t *end;     // end[i]: where face i ends in corner
  uint16_t count;          // number of faces
} gjk_hull_faces;

// A table of a hull, made by gjk/table.h. For each cell of directions it lists the vertices that may be farthest along
// one of them. Support scans look only at these. It pays from about 32 vertices on.
//
// gjk_collider_init checks only that every list can be read. If a cell lacks vertices, answers are wrong, as if the
// hull lacked them along those directions. gjk_hull_table_check proves that none is missing.
typedef struct gjk_hull_table {
  const uint16_t *vertex;  // vertex numbers of all cells, cell after cell, ascending within each
  const uint16_t *end;     // end[i]: where cell i ends in vertex; no cell is empty
  uint8_t level;           // 0 to GJK_TABLE_LEVEL_MAX: there are GJK_TABLE_CELLS(level) cells
} gjk_hull_table;

// A shape. The initialisers below set the fields, and gjk_collider_init checks them.
typedef struct gjk_shape {
  const gjk_shape_class *type;    // the kind of shape
  const gjk_vec3 *vertices;       // triangle, hull: local frame, Q16.16, the caller's, must outlive the shape
  gjk_support_function *support;  // custom: the support function
  const void *user;               // custom: the user pointer; hull with a table: the gjk_hull_table, the caller's
  gjk_vec3 size;                  // half extents or radii, Q16.16, by kind
  gjk_q16 convex_radius;          // at least 0
  uint16_t count;                 // hull: number of vertices; triangle: 3
  const gjk_hull_faces *faces;    // hull: optional, the caller's
} gjk_shape;

// Size and convex radius of a shape, Q16.16. A floating-point literal does not compile: write GJK_Q16(0.5) for 0.5.
#define GJK_LENGTHS(x, y, z, radius) {GJK_INTEGER(x), GJK_INTEGER(y), GJK_INTEGER(z)}, GJK_INTEGER(radius)

// Shapes with a convex radius. The vertices of a hull need no order. They may repeat, and may lie in a line, in a plane
// or inside the hull. Their coordinates are any int32_t within GJK_RADIUS_MAX of the centre of their bounding box.
#define GJK_ROUNDED_POINT(radius) \
  { &gjk_class_point, 0, 0, 0, GJK_LENGTHS(0, 0, 0, radius), 0, 0 }
#define GJK_ROUNDED_SEGMENT(half, radius) \
  { &gjk_class_segment, 0, 0, 0, GJK_LENGTHS(0, 0, half, radius), 0, 0 }
#define GJK_ROUNDED_TRIANGLE(vertices3, radius) \
  { &gjk_class_triangle, (vertices3), 0, 0, GJK_LENGTHS(0, 0, 0, radius), 3, 0 }
#define GJK_ROUNDED_BOX(half_x, half_y, half_z, radius) \
  { &gjk_class_box, 0, 0, 0, GJK_LENGTHS(half_x, half_y, half_z, radius), 0, 0 }
#define GJK_ROUNDED_HULL(vertices_n, n, radius) \
  { &gjk_class_hull, (vertices_n), 0, 0, GJK_LENGTHS(0, 0, 0, radius), (n), 0 }
#define GJK_ROUNDED_CYLINDER(base_radius, half, radius) \
  { &gjk_class_cylinder, 0, 0, 0, GJK_LENGTHS(base_radius, base_radius, half, radius), 0, 0 }
#define GJK_ROUNDED_CONE(base_radius, half, radius) \
  { &gjk_class_cone, 0, 0, 0, GJK_LENGTHS(base_radius, base_radius, half, radius), 0, 0 }
#define GJK_ROUNDED_ELLIPSOID(radius_x, radius_y, radius_z, radius) \
  { &gjk_class_ellipsoid, 0, 0, 0, GJK_LENGTHS(radius_x, radius_y, radius_z, radius), 0, 0 }
#define GJK_ROUNDED_CUSTOM(function, user_pointer, bound, radius) \
  { &gjk_class_custom, 0, (function), (user_pointer), GJK_LENGTHS(bound, 0, 0, radius), 0, 0 }

// A hull with faces, for contacts.
#define GJK_ROUNDED_HULL_WITH_FACES(vertices_n, n, faces_pointer, radius) \
  { &gjk_class_hull, (vertices_n), 0, 0, GJK_LENGTHS(0, 0, 0, radius), (n), (faces_pointer) }

// faces_pointer may be 0.
#define GJK_ROUNDED_HULL_WITH_TABLE(vertices_n, n, faces_pointer, table_pointer, radius)                              \
  {                                                                                                                   \
    &gjk_class_table, (vertices_n), 0, 1 ? (table_pointer) : (const gjk_hull_table *)0, GJK_LENGTHS(0, 0, 0, radius), \
        (n), (faces_pointer)                                                                                          \
  }

// The same shapes without a convex radius. A sphere and a capsule have only this radius.
#define GJK_POINT GJK_ROUNDED_POINT(0)
#define GJK_SPHERE(radius) GJK_ROUNDED_POINT(radius)
// A segment from (0, 0, -half) to (0, 0, half).
#define GJK_SEGMENT(half) GJK_ROUNDED_SEGMENT(half, 0)
// A segment with a radius. half is half the length of the straight part. gjk_pose_between (gjk/math.h) finds half and
// the pose from the two end points.
#define GJK_CAPSULE(radius, half) GJK_ROUNDED_SEGMENT(half, radius)
// The triangle of three vertices.
#define GJK_TRIANGLE(vertices3) GJK_ROUNDED_TRIANGLE(vertices3, 0)
// A box about the origin, given by its half extents.
#define GJK_BOX(half_x, half_y, half_z) GJK_ROUNDED_BOX(half_x, half_y, half_z, 0)
// The hull of n vertices, also with faces for contacts, or with a table.
#define GJK_HULL(vertices_n, n) GJK_ROUNDED_HULL(vertices_n, n, 0)
#define GJK_HULL_WITH_FACES(vertices_n, n, faces_pointer) GJK_ROUNDED_HULL_WITH_FACES(vertices_n, n, faces_pointer, 0)
#define GJK_HULL_WITH_TABLE(vertices_n, n, table_pointer) \
  GJK_ROUNDED_HULL_WITH_TABLE(vertices_n, n, 0, table_pointer, 0)
// A cylinder from z = -half to z = half.
#define GJK_CYLINDER(base_radius, half) GJK_ROUNDED_CYLINDER(base_radius, half, 0)
// A cone: apex at z = half, base at z = -half.
#define GJK_CONE(base_radius, half) GJK_ROUNDED_CONE(base_radius, half, 0)
// An ellipsoid, given by its radii.
#define GJK_ELLIPSOID(radius_x, radius_y, radius_z) GJK_ROUNDED_ELLIPSOID(radius_x, radius_y, radius_z, 0)
// A custom shape. All its points are at most bound away from the local origin.
#define GJK_CUSTOM(function, user_pointer, bound) GJK_ROUNDED_CUSTOM(function, user_pointer, bound, 0)

#ifdef __cplusplus
}
#endif

#endif
