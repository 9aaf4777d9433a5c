// Any body of many parts, of a model class: what src/parts/gjk_parts_class.h says of a class, and no more. Walks of up to
// ANY_WALK parts.
#ifndef PROVE_PARTS_ANY_H
#define PROVE_PARTS_ANY_H

#include "colliders.h"
#include "src/parts/gjk_parts_class.h"

#ifndef ANY_WALK
#define ANY_WALK 2
#endif

static uint32_t any_uint32(void) {
  return (uint32_t)any_int32();
}

static gjk_aabb any_box(void) {
  const gjk_aabb box = {any_position(), any_position()};
  return box;
}

// Any collider; state: any, or posed.
static void any_bound_collider(gjk_collider *c, gjk_shape *shape, const gjk_shape_class *type) {
  any_collider(c, shape, type);
  c->buffer = NULL;
  c->position = any_position();
  c->local_centre = any_position();
  c->count = any_uint16();
  c->bits = (uint8_t)any_between(0, 31);
  for (int i = 0; i < 3; i++) {
    c->fraction[i] = (int8_t)any_between(INT8_MIN, INT8_MAX);
  }
  c->state = (uint16_t)(any_bool() ? GJK_STATE_POSED : any_bool() ? GJK_STATE_INITIALISED : any_uint16());
}

// It is set.
static void check_point(const gjk_vec3 *v) {
  check_size(v->x, INT64_C(1) << 31);
  check_size(v->y, INT64_C(1) << 31);
  check_size(v->z, INT64_C(1) << 31);
}

static void check_unit(const gjk_unit3 *u) {
  check_size(u->x, ANY_UNIT);
  check_size(u->y, ANY_UNIT);
  check_size(u->z, ANY_UNIT);
}

static void check_region(const gjk_region *region) {
  check_point(&region->box.lower);
  check_point(&region->box.upper);
  check_size(region->moves, 1);
}

static uint32_t any_count(const void *data) {
  (void)data;
  return any_uint32();
}

// Of a body all of whose parts are asked.
static uint32_t any_few(const void *data) {
  (void)data;
  return (uint32_t)any_between(0, ANY_WALK);
}

static uint32_t any_reach(const void *data) {
  (void)data;
  return any_uint32();
}

static uint32_t any_guess(const void *data, const gjk_region *region) {
  (void)data;
  check_region(region);
  return any_uint32();
}

static bool any_next(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  (void)data;
  check_region(region);
  check_size(walk->node, UINT32_MAX);
  const int32_t more = any_between(0, 1);
  //@ split more;
  if (walk->item >= ANY_WALK || more == 0) {
    return false;
  }
  walk->item++;
  *number = (uint32_t)Frama_C_long_long_interval(0, (int64_t)UINT32_MAX - 1);
  return true;
}

static gjk_status any_part_status(void) {
  const int32_t status = any_between(0, 2);
  //@ split status;
  return status == 0 ? GJK_OK : status == 1 ? GJK_ERROR_RANGE : GJK_ERROR_SIZE;
}

static void check_frame(const gjk_parts_frame *frame) {
  check_vec3(&frame->rows[0], GJK_Q30_ONE);
  check_vec3(&frame->rows[1], GJK_Q30_ONE);
  check_vec3(&frame->rows[2], GJK_Q30_ONE);
  check_size(frame->is_level, 1);
  check_point(&frame->parts->pose.position);
}

static gjk_status any_place(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room, gjk_collider *out) {
  check_frame(frame);
  (void)number;
  const int status = any_part_status();
  //@ split status;
  if (status == GJK_OK) {
    any_bound_collider(out, &room->shape, any_bool() ? &polytope : &curved);
    out->state = GJK_STATE_POSED;
  }
  return (gjk_status)status;
}

static gjk_status any_local(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  static gjk_pose own;
  (void)data, (void)number;
  const int status = any_part_status();
  //@ split status;
  if (status == GJK_OK) {
    own = any_pose();
    room->shape.type = any_bool() ? &polytope : &curved;
    room->shape.convex_radius = any_between(0, GJK_RADIUS_MAX);
    out->shape = &room->shape;
    out->own = any_bool() ? &own : NULL;
  }
  return (gjk_status)status;
}

static unsigned any_edges(const void *data, uint32_t number) {
  (void)data, (void)number;
  return (unsigned)any_between(0, 127);
}

static const gjk_parts_class any_class = {.count = any_count,
                                          .reach = any_reach,
                                          .guess = any_guess,
                                          .next = any_next,
                                          .place = any_place,
                                          .local = any_local,
                                          .settle = NULL,
                                          .meet = NULL,
                                          .edges = NULL};

#endif
