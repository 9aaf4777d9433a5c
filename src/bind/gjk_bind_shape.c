// Shapes by functions, for other languages. gjk_collider_init says what is wrong with a shape.
#include "gjk/bind.h"
#include "gjk/collider.h"

static gjk_status take_shape(const gjk_shape *shape, gjk_shape *out) {
  gjk_collider collider;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk_collider_init(&collider, shape, NULL, 0);
  if (status == GJK_OK) {
    *out = *shape;
  }
  return status;
}

gjk_status gjk_shape_point(gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_POINT(radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_segment(gjk_q16 half, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_SEGMENT(half, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_triangle(const gjk_vec3 *vertices3, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_TRIANGLE(vertices3, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_box(gjk_q16 half_x, gjk_q16 half_y, gjk_q16 half_z, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_BOX(half_x, half_y, half_z, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_cylinder(gjk_q16 base_radius, gjk_q16 half, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_CYLINDER(base_radius, half, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_cone(gjk_q16 base_radius, gjk_q16 half, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_CONE(base_radius, half, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_ellipsoid(gjk_q16 radius_x, gjk_q16 radius_y, gjk_q16 radius_z, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_ELLIPSOID(radius_x, radius_y, radius_z, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_custom(gjk_support_function *support, const void *user, gjk_q16 bound, gjk_q16 radius,
                            gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_CUSTOM(support, user, bound, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_hull(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces, gjk_q16 radius,
                          gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_HULL_WITH_FACES(vertices, count, faces, radius);
  return take_shape(&shape, out);
}

gjk_status gjk_shape_hull_with_table(const gjk_vec3 *vertices, uint16_t count, const gjk_hull_faces *faces,
                                     const gjk_hull_table *table, gjk_q16 radius, gjk_shape *out) {
  const gjk_shape shape = GJK_ROUNDED_HULL_WITH_TABLE(vertices, count, faces, table, radius);
  return take_shape(&shape, out);
}
