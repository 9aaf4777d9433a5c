// src/motion/gjk_swept.h on any two colliders of vertices and any way, and the class of the swept shape on any direction
// that a query asks for.
#include "src/motion/gjk_swept.h"

#include "ways.h"

static void any_query_direction(gjk_direction *direction, const gjk_vec3 *a, const gjk_vec3 *b, const gjk_long3 *n) {
  const int32_t spanning = any_between(1, 3);
  //@ split spanning;
  direction->a = a;
  direction->b = b;
  direction->n = n;
  direction->ta = any_long(ANY_TOWARD);
  direction->tb = any_long(ANY_TOWARD);
  direction->spanning = (uint8_t)spanning;
  direction->opposite = any_bool();
  direction->level = NULL;
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_way way;
  gjk_swept swept;
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &polytope);
  b.count = any_uint16();
  any_way(&way);
  if (!gjk_swept_set(&swept, &a, &b, &way)) {
    return 0;
  }
  const gjk_collider *c = &swept.swept;
  const gjk_shape_class *type = c->shape->type;
  check_size(c->core_radius, INT64_C(1) << 30);
  const gjk_vec3 d = any_vec3(ANY_DIRECTION), w = any_vec3(ANY_W), v = any_vec3(ANY_W);
  gjk_support at;
  gjk_direction direction;
  gjk_long3 n;
  gjk_vec3 offset;
  any_normal(&n);
  any_query_direction(&direction, &w, &v, &n);
  type->support(c, &d, &at);
  check_size(at.offset.x, INT64_C(1) << 30);
  check_size(at.offset.y, INT64_C(1) << 30);
  check_size(at.offset.z, INT64_C(1) << 30);
  at.vertex = any_uint16();
  (void)type->refine(c, &w, &direction, &at);
  if (type->vertex(c, any_uint16(), &offset)) {
    check_vec3(&offset, INT32_C(1) << 30);
  }
  return 0;
}
