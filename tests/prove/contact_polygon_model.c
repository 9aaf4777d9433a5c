// Stands in for src/contact_polygon.c under gjk_contacts: any polygon that it may give, as tests/prove/shape.c shows it.
#include "contact_polygon.h"
#include "simplex_any.h"

void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *direction, gjk_polygon *out) {
  check_vec3(position, INT32_C(1) << 29);
  check_vec3(direction, GJK_Q30_ONE);
  const int32_t count = any_between(1, 3);
  //@ split count;
  out->direction = *direction;
  out->feature = any_uint16();
  out->count = (uint8_t)(count < 3 ? count : any_between(3, GJK_FACE_CORNERS_MAX));
  for (unsigned i = 0; count > 1 && i < GJK_FACE_CORNERS_MAX; i++) {
    out->corner[i] = any_vec3(INT32_C(1) << 30);
    out->vertex[i] = any_uint16();
  }
  if (count > 2) {
    any_normal(&out->normal);
  }
}
