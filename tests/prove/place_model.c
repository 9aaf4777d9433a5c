// Stands in for src/place/gjk_collider.c, gjk_aabb.c and gjk_pose.c under bodies of many parts: any place, as
// tests/prove/shape.c and pose.c show.
#include "colliders.h"
#include "gjk/pose.h"

static void read_pose(const gjk_pose *pose) {
  check_size(pose->position.x ^ pose->position.y ^ pose->position.z, INT64_C(1) << 31);
  check_size(pose->rotation.x ^ pose->rotation.y ^ pose->rotation.z ^ pose->rotation.w, INT64_C(1) << 31);
}

gjk_status gjk_collider_init(gjk_collider *c, const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity) {
  (void)capacity;
  if (c == NULL || shape == NULL || shape->type == NULL) {
    return GJK_ERROR_NULL;
  }
  const int32_t good = any_between(0, 1);
  //@ split good;
  if (good == 0) {
    return GJK_ERROR_SIZE;
  }
  c->shape = shape;
  c->buffer = buffer;
  c->local_centre = any_position();
  c->core_radius = any_between(4, ANY_OFFSET);
  c->radius = any_between(4, ANY_OFFSET);
  c->bits = (uint8_t)any_between(0, 31);
  c->count = any_uint16();
  c->state = GJK_STATE_INITIALISED;
  return GJK_OK;
}

gjk_status gjk_collider_pose(gjk_collider *c, const gjk_pose *pose) {
  if (c == NULL || pose == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_INITIALISED && c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  read_pose(pose);
  const int32_t good = any_between(0, 2);
  //@ split good;
  if (good != 0) {
    return good == 1 ? GJK_ERROR_ROTATION : GJK_ERROR_RANGE;
  }
  c->position = pose->position;
  c->centre = any_position();
  for (int i = 0; i < 3; i++) {
    c->frame[i] = any_vec3(ANY_OFFSET);
    c->fraction[i] = (int8_t)any_between(INT8_MIN, INT8_MAX);
  }
  c->state = GJK_STATE_POSED;
  return GJK_OK;
}

gjk_status gjk_collider_move(gjk_collider *c, const gjk_vec3 *position) {
  if (c == NULL || position == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  check_size(position->x ^ position->y ^ position->z, INT64_C(1) << 31);
  if (any_bool()) {
    return GJK_ERROR_RANGE;
  }
  c->position = *position;
  c->centre = any_position();
  return GJK_OK;
}

gjk_status gjk_collider_aabb(const gjk_collider *c, gjk_aabb *out) {
  if (c == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  out->lower = any_position();
  out->upper = any_position();
  return GJK_OK;
}

gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out) {
  read_pose(a);
  read_pose(b);
  if (any_bool()) {
    return any_bool() ? GJK_ERROR_ROTATION : GJK_ERROR_RANGE;
  }
  *out = any_pose();
  return GJK_OK;
}
