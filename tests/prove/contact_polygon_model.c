// Stands in for src/contact/gjk_contact_polygon.c: any polygon, as tests/prove/polygon.c shows.
#include "src/contact/gjk_contact_polygon.h"

#include "polygons.h"

void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *direction, gjk_polygon *out) {
  static const int32_t counts[] = {1, 2, 3, GJK_FACE_CORNERS_MAX};
  const int32_t kind = any_between(0, 3);
  check_vec3(position, INT32_C(1) << 29);
  check_vec3(direction, ANY_UNIT);
  //@ split kind;
  any_polygon(out, counts[kind]);
}
