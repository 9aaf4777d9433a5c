// Any way of a cast in the plane that src/plane_motion/gjk2_way.c may set, and what lies on it.
#ifndef PROVE_PLANE_WAYS_H
#define PROVE_PLANE_WAYS_H

#include "plane_colliders.h"
#include "src/plane_motion/gjk2_way.h"

// A component of a way, and of the difference of centres.
#define ANY_WAY ((INT64_C(1) << 32) - 1)

static bool any_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations) {
  (void)s;
  (void)edge;
  (void)lower;
  (void)iterations;
  return any_bool();
}

static void any_long2(gjk2_long *v) {
  v->x = any_long(-ANY_WAY, ANY_WAY);
  v->y = any_long(-ANY_WAY, ANY_WAY);
}

static void any_posed(gjk2_collider *c, gjk2_shape *shape, const gjk2_shape_class *type) {
  any_collider(c, shape, type);
  c->position = any_position2();
  c->local_centre = any_position2();
  c->fraction[0] = (int8_t)any_between(INT8_MIN, INT8_MAX);
  c->fraction[1] = (int8_t)any_between(INT8_MIN, INT8_MAX);
  c->buffer = NULL;
}

static void any_span(gjk2_span *span) {
  span->a.offset = any_vec2(ANY_OFFSET);
  span->b.offset = any_vec2(ANY_OFFSET);
  span->a.vertex = any_uint16();
  span->b.vertex = any_uint16();
  span->o = any_vec2(2 * ANY_OFFSET);
}

static void any_way(gjk2_way *way, const gjk2_collider *a, const gjk2_collider *b) {
  way->a = a;
  way->b = b;
  any_long2(&way->of_a);
  any_long2(&way->of_b);
  any_long2(&way->t);
  any_long2(&way->delta);
  way->d = any_vec2((INT32_C(1) << 30) - 1);
  way->base = any_long(-(INT64_C(1) << 62), INT64_C(1) << 62);
  const int32_t wide = any_between(0, 1);
  //@ split wide;
  way->wide = wide != 0;
  if (wide == 0) {
    way->t.x = way->d.x;
    way->t.y = way->d.y;
    way->delta.x = any_between(1 - (INT32_C(1) << 30), (INT32_C(1) << 30) - 1);
    way->delta.y = any_between(1 - (INT32_C(1) << 30), (INT32_C(1) << 30) - 1);
    way->base = any_long(-(INT64_C(1) << 61), INT64_C(1) << 61);
  }
  way->scans = 0;
}

static void check_long2(const gjk2_long *v) {
  check_within(v->x, ANY_WAY);
  check_within(v->y, ANY_WAY);
}

#endif
