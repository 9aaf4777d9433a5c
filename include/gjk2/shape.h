// Shapes of the plane: convex geometry in its own frame, constant, fit for flash.
//
// A shape is a core and a convex radius around it: a circle is a point with a radius, a capsule a segment with one.
// Segments lie along local x. An initialiser makes each kind of shape:
//
//     static const gjk2_shape crate = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.25));
//
// An initialiser names the class of its kind. So a program links only the kinds that it mentions.
#ifndef GJK2_SHAPE_H
#define GJK2_SHAPE_H

#include "gjk2/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// The functions behind a kind of shape, opaque: one constant per kind.
typedef struct gjk2_shape_class gjk2_shape_class;

// The class of each kind of shape. The initialisers below name them.
extern const gjk2_shape_class gjk2_class_point;
extern const gjk2_shape_class gjk2_class_segment;
extern const gjk2_shape_class gjk2_class_box;
extern const gjk2_shape_class gjk2_class_triangle;
extern const gjk2_shape_class gjk2_class_polygon;
extern const gjk2_shape_class gjk2_class_ellipse;
extern const gjk2_shape_class gjk2_class_custom;

// The support function of a custom shape. It writes the shape's farthest point along direction to out.
//
// user       the shape's user pointer.
// direction  local frame, not zero, of any length up to 2^31.
// out        local frame, Q16.16; the local origin on entry. If the point is farther than size.x from that origin, it
//            is pulled back onto this bound. A port with asserts stops instead. If the point is e LSB from the true
//            farthest one, decisions and distances are right to within e LSB more.
typedef void gjk2_support_function(const void *user, const gjk2_vec *direction, gjk2_vec *out);

// A shape. The initialisers below set the fields, and gjk2_collider_init checks them.
typedef struct gjk2_shape {
  const gjk2_shape_class *type;    // the kind of shape
  const gjk2_vec *vertices;        // triangle, polygon: local frame, Q16.16, the caller's, must outlive the shape
  gjk2_support_function *support;  // custom: the support function
  const void *user;                // custom: the user pointer
  gjk2_vec size;                   // half extents or radii, Q16.16, by kind
  gjk_q16 convex_radius;           // at least 0
  uint16_t count;                  // polygon: number of vertices; triangle: 3
} gjk2_shape;

// Size and convex radius of a shape, Q16.16. A floating-point literal does not compile: write GJK_Q16(0.5) for 0.5.
#define GJK2_LENGTHS(x, y, radius) {GJK_INTEGER(x), GJK_INTEGER(y)}, GJK_INTEGER(radius)

// Shapes with a convex radius. A polygon is the convex hull of its vertices. They need no order. They may repeat, and
// may lie in a line or inside. Depths, contacts and bounds are found faster if the vertices are as gjk2_polygon_order
// writes them, counterclockwise and with none superfluous (gjk2/polygon.h). Coordinates are any int32_t within
// GJK2_RADIUS_MAX of the centre of the vertices' bounding box.
#define GJK2_ROUNDED_POINT(radius) \
  { &gjk2_class_point, 0, 0, 0, GJK2_LENGTHS(0, 0, radius), 0 }
#define GJK2_ROUNDED_SEGMENT(half, radius) \
  { &gjk2_class_segment, 0, 0, 0, GJK2_LENGTHS(half, 0, radius), 0 }
#define GJK2_ROUNDED_TRIANGLE(vertices3, radius) \
  { &gjk2_class_triangle, (vertices3), 0, 0, GJK2_LENGTHS(0, 0, radius), 3 }
#define GJK2_ROUNDED_BOX(half_x, half_y, radius) \
  { &gjk2_class_box, 0, 0, 0, GJK2_LENGTHS(half_x, half_y, radius), 0 }
#define GJK2_ROUNDED_POLYGON(vertices_n, n, radius) \
  { &gjk2_class_polygon, (vertices_n), 0, 0, GJK2_LENGTHS(0, 0, radius), (n) }
#define GJK2_ROUNDED_ELLIPSE(radius_x, radius_y, radius) \
  { &gjk2_class_ellipse, 0, 0, 0, GJK2_LENGTHS(radius_x, radius_y, radius), 0 }
#define GJK2_ROUNDED_CUSTOM(function, user_pointer, bound, radius) \
  { &gjk2_class_custom, 0, (function), (user_pointer), GJK2_LENGTHS(bound, 0, radius), 0 }

// The same shapes without a convex radius. A circle and a capsule have only this radius.
#define GJK2_POINT GJK2_ROUNDED_POINT(0)
#define GJK2_CIRCLE(radius) GJK2_ROUNDED_POINT(radius)
// A segment from (-half, 0) to (half, 0).
#define GJK2_SEGMENT(half) GJK2_ROUNDED_SEGMENT(half, 0)
// A segment with a radius. half is half the length of the straight part. gjk2_pose_between (gjk2/math.h) finds half and
// the pose from the two end points.
#define GJK2_CAPSULE(radius, half) GJK2_ROUNDED_SEGMENT(half, radius)
// The triangle of three vertices.
#define GJK2_TRIANGLE(vertices3) GJK2_ROUNDED_TRIANGLE(vertices3, 0)
// A box about the origin, given by its half extents.
#define GJK2_BOX(half_x, half_y) GJK2_ROUNDED_BOX(half_x, half_y, 0)
// The hull of n vertices.
#define GJK2_POLYGON(vertices_n, n) GJK2_ROUNDED_POLYGON(vertices_n, n, 0)
// An ellipse, given by its radii.
#define GJK2_ELLIPSE(radius_x, radius_y) GJK2_ROUNDED_ELLIPSE(radius_x, radius_y, 0)
// A custom shape. All its points are at most bound away from the local origin.
#define GJK2_CUSTOM(function, user_pointer, bound) GJK2_ROUNDED_CUSTOM(function, user_pointer, bound, 0)

#ifdef __cplusplus
}
#endif

#endif
