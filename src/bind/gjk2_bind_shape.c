// Shapes of the plane by functions, for other languages. gjk2_collider_init says what is wrong with a shape.
#include "gjk2/bind.h"
#include "gjk2/collider.h"

static gjk_status take_plane_shape(const gjk2_shape *shape, gjk2_shape *out) {
  gjk2_collider collider;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk2_collider_init(&collider, shape, NULL, 0);
  if (status == GJK_OK) {
    *out = *shape;
  }
  return status;
}

gjk_status gjk2_shape_point(gjk_q16 radius, gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_POINT(radius);
  return take_plane_shape(&shape, out);
}

gjk_status gjk2_shape_segment(gjk_q16 half, gjk_q16 radius, gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_SEGMENT(half, radius);
  return take_plane_shape(&shape, out);
}

gjk_status gjk2_shape_triangle(const gjk2_vec *vertices3, gjk_q16 radius, gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_TRIANGLE(vertices3, radius);
  return take_plane_shape(&shape, out);
}

gjk_status gjk2_shape_box(gjk_q16 half_x, gjk_q16 half_y, gjk_q16 radius, gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_BOX(half_x, half_y, radius);
  return take_plane_shape(&shape, out);
}

gjk_status gjk2_shape_polygon(const gjk2_vec *vertices, uint16_t count, gjk_q16 radius, gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_POLYGON(vertices, count, radius);
  return take_plane_shape(&shape, out);
}

gjk_status gjk2_shape_ellipse(gjk_q16 radius_x, gjk_q16 radius_y, gjk_q16 radius, gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_ELLIPSE(radius_x, radius_y, radius);
  return take_plane_shape(&shape, out);
}

gjk_status gjk2_shape_custom(gjk2_support_function *support, const void *user, gjk_q16 bound, gjk_q16 radius,
                             gjk2_shape *out) {
  const gjk2_shape shape = GJK2_ROUNDED_CUSTOM(support, user, bound, radius);
  return take_plane_shape(&shape, out);
}
