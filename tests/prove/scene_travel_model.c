// Stands in for what scenes ask about motion: any answers.
#include "gjk/impact.h"
#include "scene_any.h"
#include "src/scene/gjk_scene_travel.h"

static void read_vec3(const gjk_vec3 *v) {
  check_size(v->x ^ v->y ^ v->z, INT64_C(1) << 31);
}

static void read_motion_pose(const gjk_pose *pose) {
  read_vec3(&pose->position);
  check_size(pose->rotation.x ^ pose->rotation.y ^ pose->rotation.z ^ pose->rotation.w, INT64_C(1) << 31);
}

static gjk_status any_cast_status(void) {
  return any_bool() ? GJK_OK : any_bool() ? GJK_ERROR_ITERATION_LIMIT : GJK_ERROR_RANGE;
}

static void any_cast_result(gjk_cast_result *out) {
  out->hit = any_bool();
  out->inside = any_bool();
  out->fraction = any_between(0, GJK_Q30_ONE);
  out->point_a = any_position();
  out->point_b = any_position();
  out->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  out->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  out->normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  out->rest_a = any_position();
  out->rest_b = any_position();
  out->saturated = any_bool();
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  out->certificate.direction = any_position();
  for (int i = 0; i < 3; i++) {
    out->certificate.a[i] = any_uint16();
    out->certificate.b[i] = any_uint16();
  }
  out->certificate.count = (uint8_t)any_between(0, 3);
  out->certificate.proof = (uint8_t)any_between(0, GJK_CAST_PROOF_SWEPT);
}

gjk_status gjk_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out) {
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  //@ assert path->margin >= 0;
  if (path->to_a != NULL) {
    read_vec3(path->to_a);
  }
  if (path->to_b != NULL) {
    read_vec3(path->to_b);
  }
  const int status = any_cast_status();
  //@ split status;
  if (status == GJK_OK) {
    any_cast_result(out);
  }
  return (gjk_status)status;
}

gjk_status gjk_cast_ray(const gjk_collider *a, const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out) {
  //@ assert a->state == GJK_STATE_POSED;
  read_vec3(from);
  read_vec3(to);
  any_cast_result(out);
  return GJK_OK;
}

gjk_status gjk_motion_pose(const gjk_motion *motion, gjk_q30 fraction, gjk_pose *out) {
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  read_motion_pose(&motion->from);
  read_motion_pose(&motion->to);
  read_vec3(&motion->spin);
  *out = any_pose();
  return any_bool() ? GJK_OK : GJK_ERROR_ROTATION;
}

gjk_status gjk_time_of_impact(const gjk_collider *a, const gjk_motion *motion_a, const gjk_collider *b,
                              const gjk_motion *motion_b, const gjk_impact_setup *setup, gjk_impact_result *out) {
  //@ assert a->shape->convex_radius >= 0 && b->shape->convex_radius >= 0;
  //@ assert setup->margin >= 0 && setup->margin <= GJK_IMPACT_MARGIN_MAX;
  //@ assert setup->tolerance >= GJK_IMPACT_TOLERANCE_MIN;
  read_motion_pose(&motion_a->from);
  read_motion_pose(&motion_a->to);
  read_motion_pose(&motion_b->from);
  read_motion_pose(&motion_b->to);
  const int status = any_cast_status();
  if (status != GJK_ERROR_RANGE) {
    out->hit = any_bool();
    out->lower = any_between(0, GJK_Q30_ONE);
    out->upper = any_between(0, GJK_Q30_ONE);
  }
  return (gjk_status)status;
}

gjk_status gjk_collider_move(gjk_collider *c, const gjk_vec3 *position) {
  //@ assert c->state == GJK_STATE_POSED;
  read_vec3(position);
  if (any_bool()) {
    return GJK_ERROR_RANGE;
  }
  c->position = *position;
  c->centre = any_position();
  return GJK_OK;
}
