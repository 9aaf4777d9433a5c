// gjk/bind.h on any lengths, numbers and names, null pointers too. Shapes are checked by gjk_collider_init, which shape.c
// shows for each kind; here it is any status.
#include "gjk/bind.h"

#include <limits.h>

#include "any.h"
#include "gjk/collider.h"
#include "gjk2/bind.h"
#include "gjk2/collider.h"

#define NAME 5

gjk_status gjk_collider_init(gjk_collider *collider, const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity) {
  //@ assert \initialized(&shape->type) && \initialized(&shape->vertices) && \initialized(&shape->support);
  //@ assert \initialized(&shape->user) && \initialized(&shape->size) && \initialized(&shape->convex_radius);
  //@ assert \initialized(&shape->count) && \initialized(&shape->faces);
  (void)collider, (void)buffer, (void)capacity;
  return any_bool() ? GJK_OK : GJK_ERROR_SIZE;
}

gjk_status gjk2_collider_init(gjk2_collider *collider, const gjk2_shape *shape, gjk2_vec *buffer, uint16_t capacity) {
  //@ assert \initialized(&shape->type) && \initialized(&shape->vertices) && \initialized(&shape->convex_radius);
  (void)collider, (void)buffer, (void)capacity;
  return any_bool() ? GJK_OK : GJK_ERROR_SIZE;
}

static void corner(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  (void)user, (void)direction;
  *out = any_position();
}

static void name_anything(void) {
  char name[NAME];
  int64_t value;
  for (int i = 0; i < NAME - 1; i++) {
    name[i] = (char)any_between(CHAR_MIN, CHAR_MAX);
  }
  name[NAME - 1] = '\0';
  (void)gjk_size_of(any_bool() ? name : NULL);
  const int status = gjk_constant(any_bool() ? name : NULL, any_bool() ? &value : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert \initialized(&value);
  }
}

int main(void) {
  static gjk_vec3 vertices[3];
  static gjk2_vec corners[3];
  const gjk_q16 x = any_int32(), y = any_int32(), z = any_int32(), radius = any_int32();
  const gjk_vec3 *of = any_bool() ? vertices : NULL;
  gjk_shape shape;
  gjk2_shape flat;
  gjk_parts parts;
  gjk_shape *out = any_bool() ? &shape : NULL;
  gjk2_shape *flat_out = any_bool() ? &flat : NULL;
  (void)gjk_shape_point(radius, out);
  (void)gjk_shape_segment(x, radius, out);
  (void)gjk_shape_triangle(of, radius, out);
  (void)gjk_shape_box(x, y, z, radius, out);
  (void)gjk_shape_cylinder(x, y, radius, out);
  (void)gjk_shape_cone(x, y, radius, out);
  (void)gjk_shape_ellipsoid(x, y, z, radius, out);
  (void)gjk_shape_custom(any_bool() ? corner : NULL, of, x, radius, out);
  (void)gjk_shape_hull(of, any_uint16(), NULL, radius, out);
  (void)gjk_shape_hull_with_table(of, any_uint16(), NULL, NULL, radius, out);
  (void)gjk2_shape_point(radius, flat_out);
  (void)gjk2_shape_segment(x, radius, flat_out);
  (void)gjk2_shape_box(x, y, radius, flat_out);
  (void)gjk2_shape_triangle(any_bool() ? corners : NULL, radius, flat_out);
  (void)gjk2_shape_polygon(any_bool() ? corners : NULL, any_uint16(), radius, flat_out);
  (void)gjk2_shape_ellipse(x, y, radius, flat_out);
  const gjk_mesh mesh = {0};
  (void)gjk_parts_of_mesh(any_bool() ? &mesh : NULL, any_bool() ? &parts : NULL);
  const gjk_compound compound = {0};
  (void)gjk_parts_of_compound(any_bool() ? &compound : NULL, any_bool() ? &parts : NULL);
  const gjk_height_field field = {0};
  (void)gjk_parts_of_height_field(any_bool() ? &field : NULL, any_bool() ? &parts : NULL);
  (void)gjk_compound_nodes((uint32_t)any_int32());
  (void)gjk_mesh_nodes((uint32_t)any_int32());
  (void)gjk_table_cells((uint8_t)any_between(0, UINT8_MAX));
  (void)gjk_hull_workspace((uint32_t)any_int32());
  (void)gjk_hull_simplify_workspace((uint32_t)any_int32());
  name_anything();
  return 0;
}
