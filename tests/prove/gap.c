// src/motion/gjk_gap.h on any two colliders and any way: CASE 0 polytopes, CASE 1 a curved shape and any. Two
// measurements, so that the second one starts from the first one's feature.
#include "src/motion/gjk_gap.h"

#include "gaps.h"

static bool any_close(gjk_iteration *it) {
  return any_bool();
}

// As boxes, which the search may close without an iteration.
static const gjk_shape_class closing = {.measure = any_measure,
                                        .pose = keep_pose,
                                        .support = any_support,
                                        .refine = any_refine,
                                        .vertex = any_vertex_of,
                                        .close = any_close,
                                        .kind = GJK_KIND_AXES};

static void read(gjk_gap *gap) {
  const gjk_slope slope = gjk_gap_slope(gap);
  check_size(slope.low, INT64_C(1) << 62);
  check_size(slope.high, INT64_C(1) << 62);
  check_size(gap->above, ANY_ABOVE);
  check_size(gap->normal.x, ANY_UNIT);
  check_size(gap->normal.y, ANY_UNIT);
  check_size(gap->normal.z, ANY_UNIT);
  const gjk_vec3 point = gjk_gap_point(gap);
  check_vec3(&point, ANY_POINT);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_way way;
  gjk_gap gap;
#if CASE == 0
  any_collider(&a, &shapes[0], any_bool() ? &polytope : &closing);
  any_collider(&b, &shapes[1], any_bool() ? &polytope : &closing);
#else
  any_collider(&a, &shapes[0], &curved);
  any_collider(&b, &shapes[1], any_bool() ? &polytope : &curved);
#endif
  any_way(&way);
  gjk_gap_start(&gap, &a, &b, &way, Frama_C_long_long_interval(0, 2 * (int64_t)GJK_RADIUS_MAX + INT32_MAX));
  for (int i = 0; i < 2; i++) {
    const int outcome = gjk_gap_measure(&gap, any_between(0, GJK_Q30_ONE));
    //@ split outcome;
    if (outcome != GJK_OUTCOME_ENCLOSING) {
      read(&gap);
      if (any_bool() && gjk_gap_follow(&gap, any_between(0, GJK_Q30_ONE))) {
        read(&gap);
      }
    }
  }
  return 0;
}
