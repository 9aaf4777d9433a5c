// Any colliders of the plane: shapes of a model class whose supports are any offsets that a class may give
// (tests/prove/plane_shape.c shows that each class of the library gives no others), with vertices or without.
#ifndef PROVE_PLANE_COLLIDERS_H
#define PROVE_PLANE_COLLIDERS_H

#include "plane_any.h"
#include "src/plane/gjk2_edges.h"

static gjk_status any_measure(const gjk2_shape *shape, gjk2_extent *out) {
  (void)shape;
  (void)out;
  return GJK_ERROR_NULL;
}

static void keep_pose(gjk2_collider *c, const gjk2_vec *rotation) {
  (void)c;
  (void)rotation;
}

static void any_support(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  (void)c;
  check_vec2(*d, ANY_W);
  out->offset = any_vec2(ANY_OFFSET);
  out->vertex = (uint16_t)any_between(0, 3);
}

static bool any_vertex_of(const gjk2_collider *c, uint16_t number, gjk2_vec *offset) {
  (void)c;
  (void)number;
  if (any_bool()) {
    return false;
  }
  *offset = any_vec2(ANY_OFFSET);
  return true;
}

static void any_adjacent(const gjk2_collider *c, const gjk2_support *from, bool following, gjk2_support *way) {
  const gjk2_vec to = any_vec2(ANY_OFFSET);
  (void)c;
  (void)following;
  check_vec2(from->offset, ANY_OFFSET);
  way->offset = gjk2_sub(to, from->offset);
  way->vertex = (uint16_t)any_between(0, 3);
}

static void any_vertex(gjk2_vertex *v) {
  v->w = any_vec2(ANY_W);
  v->a.offset = any_vec2(ANY_OFFSET);
  v->b.offset = any_vec2(ANY_OFFSET);
  v->a.vertex = any_uint16();
  v->b.vertex = any_uint16();
}

// Stands for gjk2_curved_depth.
static bool any_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations);

static const gjk2_shape_class polygon = {.measure = any_measure,
                                         .pose = keep_pose,
                                         .support = any_support,
                                         .vertex = any_vertex_of,
                                         .adjacent = any_adjacent,
                                         .count = 4};
static const gjk2_shape_class curved = {
    .measure = any_measure, .pose = keep_pose, .support = any_support, .depth = any_depth};

static void any_collider(gjk2_collider *c, gjk2_shape *shape, const gjk2_shape_class *type) {
  shape->type = type;
  shape->convex_radius = any_between(0, GJK2_RADIUS_MAX);
  c->shape = shape;
  c->centre = any_position2();
  for (int i = 0; i < 3; i++) {
    c->frame[i] = any_vec2(ANY_OFFSET);
  }
  c->core_radius = any_between(3, GJK2_RADIUS_MAX + 3);
  c->radius = any_between(3, GJK2_RADIUS_MAX + 3);
  c->count = type->count;
  c->ordered = type == &polygon && any_bool();
  c->state = any_bool() ? GJK2_STATE_POSED : any_uint16();
}

static void any_cache(gjk2_cache *cache) {
  cache->direction[0] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  cache->direction[1] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  cache->count = any_uint16();
  for (int i = 0; i < 2; i++) {
    cache->a[i] = any_uint16();
    cache->b[i] = any_uint16();
  }
}

#endif
