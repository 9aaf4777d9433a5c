// Any colliders: shapes of a model class whose supports are any offsets that a class may give (tests/prove/shape.c
// shows that each class of the library gives no others), with vertices or without.
#ifndef PROVE_COLLIDERS_H
#define PROVE_COLLIDERS_H

#include "gjk/cache.h"
#include "simplex_any.h"
#include "src/shape/gjk_shape_class.h"

static bool any_offset(gjk_vec3 *offset) {
  if (any_bool()) {
    return false;
  }
  *offset = any_vec3(ANY_OFFSET);
  return true;
}

static void any_support(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  check_vec3(d, ANY_DIRECTION);
  out->offset = any_vec3(ANY_OFFSET);
  out->vertex = any_uint16();
}

static void any_curved_support(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  check_vec3(d, ANY_DIRECTION);
  out->offset = any_vec3(ANY_OFFSET);
  out->vertex = 0;
}

static bool any_refine(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
  check_vec3(d, ANY_W);
  direction->ties = any_uint16();
  at->vertex = any_uint16();
  return any_offset(&at->offset);
}

static bool any_vertex_of(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  return any_offset(offset);
}

static void keep_pose(gjk_collider *c, const gjk_vec3 rows[3]) {
}

static gjk_status any_measure(const gjk_shape *shape, gjk_extent *out) {
  return GJK_ERROR_NULL;
}

static bool any_stalls(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late) {
  check_vec3(d, ANY_W);
  check_vec3(from, ANY_W);
  check_vec3(to, ANY_W);
  //@ assert shift >= -3 && shift <= 29;
  return any_bool();
}

static const gjk_shape_class polytope = {.measure = any_measure,
                                         .pose = keep_pose,
                                         .support = any_support,
                                         .refine = any_refine,
                                         .vertex = any_vertex_of,
                                         .kind = GJK_KIND_SMOOTH};
static const gjk_shape_class curved = {.measure = any_measure,
                                       .pose = keep_pose,
                                       .support = any_curved_support,
                                       .stalls = any_stalls,
                                       .kind = GJK_KIND_SMOOTH};

static void any_collider(gjk_collider *c, gjk_shape *shape, const gjk_shape_class *type) {
  shape->type = type;
  for (int i = 0; i < 3; i++) {
    c->frame[i] = any_vec3(ANY_OFFSET);
  }
  shape->convex_radius = any_between(0, GJK_RADIUS_MAX);
  c->shape = shape;
  c->centre = any_position();
  c->core_radius = any_between(4, ANY_OFFSET);
  c->radius = c->core_radius;
  c->state = any_bool() ? GJK_STATE_POSED : (uint32_t)any_int32();
}

static void any_cache(gjk_cache *cache) {
  for (int i = 0; i < 3; i++) {
    cache->direction[i] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  }
  cache->count = any_uint16();
  for (int i = 0; i < 4; i++) {
    cache->a[i] = any_uint16();
    cache->b[i] = any_uint16();
  }
}

#endif
