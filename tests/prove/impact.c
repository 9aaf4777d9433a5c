// gjk_time_of_impact on any two colliders, motions and setup, null pointers too; and of bodies that carry their shapes at
// any pose. CASE 0: shapes with vertices, 1: a curved one and any.
#include "src/motion/gjk_impact.h"

#include "colliders.h"

static void check_result(int status, const gjk_impact_result *r) {
  //@ split status;
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT) {
    check_size(r->hit, 1);
    check_size(r->overlap, 1);
    //@ assert r->lower >= 0 && r->lower <= r->upper && r->upper <= GJK_Q30_ONE;
    check_size(r->pose_a.position.x, INT64_C(1) << 31);
    check_size(r->pose_b.position.x, INT64_C(1) << 31);
    check_size(r->iterations, UINT8_MAX);
    if (r->hit) {
      //@ assert r->distance >= 0;
    }
  }
}

// Fails for parts that are not as they were built.
static gjk_status compose(const gjk_pose *body, const gjk_pose *own, gjk_pose *out) {
  //@ assert \initialized(body) && \initialized(own);
  if (any_bool()) {
    return GJK_ERROR_RANGE;
  }
  *out = any_pose();
  return GJK_OK;
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_impact_result result;
  const gjk_motion motion_a = {any_pose(), any_pose(), any_position()},
                   motion_b = {any_pose(), any_pose(), any_position()};
  const gjk_impact_setup setup = {any_int32(), any_int32(), (uint8_t)any_between(0, UINT8_MAX)};
  any_collider(&a, &shapes[0], CASE == 0 ? &polytope : &curved);
  any_collider(&b, &shapes[1], CASE == 0 || any_bool() ? &polytope : &curved);
  a.count = any_uint16();
  b.count = any_uint16();
  a.local_centre = any_position();
  b.local_centre = any_position();
  const int status =
      gjk_time_of_impact(any_bool() ? &a : NULL, any_bool() ? &motion_a : NULL, any_bool() ? &b : NULL,
                         any_bool() ? &motion_b : NULL, any_bool() ? &setup : NULL, any_bool() ? &result : NULL);
  check_result(status, &result);
  const gjk_pose own = any_pose();
  const gjk_carried of[2] = {{&a, &motion_a, any_bool() ? &own : NULL, (uint32_t)any_between(0, INT32_MAX)},
                             {&b, &motion_b, any_bool() ? &own : NULL, (uint32_t)any_between(0, INT32_MAX)}};
  gjk_impact_result carried;
  const int carried_status = gjk_impact_of_carried(of, &setup, compose, &carried);
  check_result(carried_status, &carried);
  return 0;
}
