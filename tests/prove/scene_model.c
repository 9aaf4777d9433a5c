// Stands in for what the scene asks of the rest of the library: any answers.
#include "gjk/contacts.h"
#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk/pose.h"
#include "scene_any.h"
#include "src/arith/gjk_rotation.h"
#include "src/shape/gjk_shape_class.h"

static gjk_status any_status(void) {
  return any_bool() ? GJK_OK : GJK_ERROR_RANGE;
}

static void read_quat(const gjk_quat *q) {
  (void)(q->x ^ q->y ^ q->z ^ q->w);
}

bool gjk_quat_deviation(const gjk_quat *q, int64_t *deviation) {
  read_quat(q);
  if (any_bool()) {
    return false;
  }
  *deviation = any_int32();
  return true;
}

static void read_pose(const gjk_pose *pose) {
  (void)(pose->position.x ^ pose->position.y ^ pose->position.z);
  read_quat(&pose->rotation);
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
  read_pose(pose);
  c->position = pose->position;
  c->centre = any_position();
  for (int i = 0; i < 3; i++) {
    c->frame[i] = any_position();
    c->fraction[i] = (int8_t)any_between(INT8_MIN, INT8_MAX);
  }
  c->state = GJK_STATE_POSED;
  return GJK_OK;
}

gjk_status gjk_collider_aabb(const gjk_collider *c, gjk_aabb *out) {
  if (c == NULL || c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  out->lower = any_position();
  out->upper = any_position();
  return GJK_OK;
}

gjk_status gjk_pose_compose(const gjk_pose *a, const gjk_pose *b, gjk_pose *out) {
  read_pose(a);
  read_pose(b);
  *out = any_pose();
  return any_status();
}

gjk_status gjk_quat_invert(const gjk_quat *q, gjk_quat *out) {
  read_quat(q);
  *out = any_quat();
  return any_status();
}

static void check_posed(const gjk_collider *a, const gjk_collider *b) {
  //@ assert a->state == GJK_STATE_POSED && b->state == GJK_STATE_POSED;
  //@ assert a->shape->convex_radius >= 0 && b->shape->convex_radius >= 0;
}

gjk_status gjk_within(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, gjk_cache *cache,
                      gjk_decision *out) {
  check_posed(a, b);
  if (any_bool()) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->yes = any_bool();
  out->certificate.proof = (uint8_t)any_between(GJK_PROOF_NONE, GJK_PROOF_PLANE);
  if (a->shape->type->vertex == NULL && out->certificate.proof == GJK_PROOF_NEAR) {
    out->certificate.proof = GJK_PROOF_NONE;
  }
  out->certificate.direction = any_vec3(INT32_C(3) << 29);
  out->certificate.a[0] = (uint16_t)any_between(0, NAMED - 1);
  out->certificate.b[0] = (uint16_t)any_between(0, NAMED - 1);
  if (cache != NULL) {
    Frama_C_make_unknown((char *)cache, sizeof *cache);
  }
  return GJK_OK;
}

static gjk_status any_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               gjk_distance_result *out) {
  check_posed(a, b);
  out->lower = any_int32();
  if (any_bool()) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  out->distance = any_int32();
  out->intersecting = any_bool();
  out->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  out->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  out->normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  if (cache != NULL) {
    Frama_C_make_unknown((char *)cache, sizeof *cache);
  }
  return GJK_OK;
}

gjk_status gjk_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, gjk_distance_result *out) {
  return any_distance(a, b, cache, out);
}

gjk_status gjk_signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                               const gjk_workspace *workspace, gjk_distance_result *out) {
  const gjk_status status = any_distance(a, b, cache, out);
  return status == GJK_OK && any_bool() ? GJK_ERROR_CAPACITY : status;
}

gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out) {
  check_posed(a, b);
  out->count = (uint8_t)any_between(0, 4);
  for (int i = 0; i < 4; i++) {
    out->contact[i].distance = any_int32();
  }
  return any_status();
}
