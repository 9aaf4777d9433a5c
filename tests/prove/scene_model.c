// Stands in for what the scene asks of the rest of the library: any answers.
#include "gjk/pose.h"
#include "gjk/contacts.h"
#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "any.h"
#include "shape_class.h"

static gjk_status any_status(void) {
  return any_bool() ? GJK_OK : GJK_ERROR_RANGE;
}

gjk_status gjk_collider_init(gjk_collider *c, const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity) {
  if (any_bool()) {
    return GJK_ERROR_SIZE;
  }
  c->shape = shape;
  c->buffer = NULL;
  c->local_centre = any_position();
  c->core_radius = any_between(4, GJK_RADIUS_MAX + 4);
  c->radius = c->core_radius;
  c->state = GJK_STATE_INITIALISED;
  return GJK_OK;
}

gjk_status gjk_collider_pose(gjk_collider *c, const gjk_pose *pose) {
  //@ assert c->state == GJK_STATE_INITIALISED || c->state == GJK_STATE_POSED;
  if (any_bool()) {
    return GJK_ERROR_RANGE;
  }
  c->position = pose->position;
  c->centre = any_position();
  for (int i = 0; i < 3; i++) {
    c->frame[i] = any_position();
  }
  c->state = GJK_STATE_POSED;
  return GJK_OK;
}

gjk_status gjk_collider_aabb(const gjk_collider *c, gjk_aabb *out) {
  //@ assert c->state == GJK_STATE_POSED;
  out->lower = any_position();
  out->upper = any_position();
  return GJK_OK;
}

gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out) {
  *out = any_pose();
  return any_status();
}

gjk_status gjk_quat_invert(const gjk_quat *q, gjk_quat *out) {
  *out = any_quat();
  return any_status();
}
