// src/motion/gjk_way.h on any two colliders that are posed, any path, null pointers too; and src/motion/gjk_spheres.h on
// any way.
#include "src/motion/gjk_spheres.h"

#include "ways.h"

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_way way;
  const gjk_vec3 to_a = any_position(), to_b = any_position();
  const gjk_cast_path path = {any_bool() ? &to_a : NULL, any_bool() ? &to_b : NULL, any_int32()};
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &polytope);
  a.position = any_position();
  b.position = any_position();
  const int status = gjk_way_set(&way, &a, &b, any_bool() ? &path : NULL);
  //@ split status;
  if (status == GJK_OK) {
    check_way(&way);
  }
  any_way(&way);
  (void)gjk_spheres_part(&a, &b, &way, Frama_C_long_long_interval(0, (INT64_C(1) << 32) - 1));
  return 0;
}
