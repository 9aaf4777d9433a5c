// The nearest points of any feature of one to three vertices, CASE, in any frame.
#include "src/gjk/gjk_witness.h"

#include "colliders.h"

static const gjk_shape_class axes = {.kind = GJK_KIND_AXES};

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_iteration it;
  gjk_vec3 points[2];
  bool saturated = false;
  any_collider(&a, &shapes[0], &curved);
  any_collider(&b, &shapes[1], &axes);
  gjk_simplex_clear(&it.simplex);
  it.a = &a;
  it.b = &b;
  it.shift = (int8_t)any_between(-3, 29);
  it.simplex.count = CASE;
  for (int i = 0; i < CASE; i++) {
    any_vertex(&it.simplex.slot[i]);
    for (int k = 0; k < CASE; k++) {
      it.simplex.toward[i][k] = Frama_C_long_long_interval(1, ANY_TOWARD);
    }
  }
  const gjk_vec3 u = any_vec3(ANY_UNIT);
  const gjk_unit3 normal = {u.x, u.y, u.z};
  gjk_witness_points(&it, &normal, &points[0], &points[1], &saturated);
  return 0;
}
