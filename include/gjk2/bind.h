// Shapes of the plane by functions, for languages that call the library without a C compiler. gjk/bind.h is the same
// for space; its gjk_size_of and gjk_constant know the structures and constants of the plane, too.
#ifndef GJK2_BIND_H
#define GJK2_BIND_H

#include "gjk/status.h"
#include "gjk2/scene.h"
#include "gjk2/shape.h"

#ifdef __cplusplus
extern "C" {
#endif

// Each makes what the macro of its name makes: gjk2_shape_box that of GJK2_ROUNDED_BOX.
//
// radius    the convex radius, Q16.16, at least 0. A box with 0 is GJK2_BOX, a point with a radius is GJK2_CIRCLE, a
//           segment with one is GJK2_CAPSULE.
// out       written when the result is GJK_OK. What a shape points to stays the caller's, and must outlive it.
// Statuses  those of gjk2_collider_init for the shape: NULL, NEGATIVE, SIZE, EMPTY, RANGE.
// Cost      that of gjk2_collider_init.
gjk_status gjk2_shape_point(gjk_q16 radius, gjk2_shape *out);
gjk_status gjk2_shape_segment(gjk_q16 half, gjk_q16 radius, gjk2_shape *out);
gjk_status gjk2_shape_triangle(const gjk2_vec *vertices3, gjk_q16 radius, gjk2_shape *out);
gjk_status gjk2_shape_box(gjk_q16 half_x, gjk_q16 half_y, gjk_q16 radius, gjk2_shape *out);
gjk_status gjk2_shape_polygon(const gjk2_vec *vertices, uint16_t count, gjk_q16 radius, gjk2_shape *out);
gjk_status gjk2_shape_ellipse(gjk_q16 radius_x, gjk_q16 radius_y, gjk_q16 radius, gjk2_shape *out);
gjk_status gjk2_shape_custom(gjk2_support_function *support, const void *user, gjk_q16 bound, gjk_q16 radius,
                             gjk2_shape *out);

// As gjk_scene_bind_all.
gjk_status gjk2_scene_bind_all(gjk2_scene_bindings *out);

#ifdef __cplusplus
}
#endif

#endif
