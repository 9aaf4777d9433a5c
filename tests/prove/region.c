// src/parts/gjk_region.h: any body's rotation and position, any box of B, any way; grown and cut by anything, in any order.
#include "src/parts/gjk_region.h"

#include "simplex_any.h"

// Below 2^32.
#define WAY ((INT64_C(1) << 32) - 1)

static void check_box(const gjk_region *r) {
  check_size(r->box.lower.x ^ r->box.lower.y ^ r->box.lower.z, INT64_C(1) << 31);
  check_size(r->box.upper.x ^ r->box.upper.y ^ r->box.upper.z, INT64_C(1) << 31);
}

int main(void) {
  gjk_region r;
  gjk_vec3 rows[3];
  const gjk_vec3 position = any_position();
  const gjk_aabb world = {any_position(), any_position()}, box = {any_position(), any_position()};
  const gjk_long3 way = {any_long(WAY), any_long(WAY), any_long(WAY)};
  const int32_t moves = any_between(0, 1);
  for (int i = 0; i < 3; i++) {
    rows[i] = any_vec3(GJK_Q30_ONE);
  }
  //@ split moves;
  gjk_region_start(&r, rows, &position, &world, moves != 0 ? &way : NULL);
  check_box(&r);
  if (any_bool()) {
    gjk_region_grow(&r, Frama_C_long_long_interval(0, (INT64_C(1) << 40) - 1));
  }
  if (any_bool()) {
    gjk_region_cut(&r, any_between(0, GJK_Q30_ONE));
  }
  check_box(&r);
  (void)gjk_region_meets(&r, &box);
  return 0;
}
