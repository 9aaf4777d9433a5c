// gjk2_contacts on any two colliders, margin and number of contacts: A of any kind, B curved or a polygon.
#include "gjk2/contacts.h"
#include "plane_colliders.h"

static bool any_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations) {
  (void)s;
  (void)edge;
  (void)lower;
  (void)iterations;
  return any_bool();
}

static gjk2_vec buffer[4];

#define OF_VERTICES .support = any_support, .vertex = any_vertex_of, .adjacent = any_adjacent

static const gjk2_shape_class point = {OF_VERTICES, .count = 1};
static const gjk2_shape_class segment = {OF_VERTICES, .count = 2};
static const gjk2_shape_class triangle = {OF_VERTICES, .count = 3};
static const gjk2_shape_class listed = {OF_VERTICES, .buffered = true, .count = 0};

static const gjk2_shape_class *const classes[] = {&curved, &point, &segment, &triangle, &polygon, &listed};

static void any_of_kind(gjk2_collider *c, gjk2_shape *shape, int32_t kind) {
  any_collider(c, shape, classes[kind]);
  if (kind == 3) {
    c->ordered = any_bool();
  }
  if (kind == 5) {
    c->count = (uint16_t)any_between(1, 4);
    c->ordered = c->count > 2 && any_bool();
    c->buffer = any_bool() ? buffer : NULL;
  }
}

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  gjk2_cache cache;
  gjk2_manifold manifold;
  const int32_t kind_a = any_between(0, 5), kind_b = 5 * any_between(0, 1);
  //@ split kind_a;
  //@ split kind_b;
  for (int i = 0; i < 4; i++) {
    buffer[i] = any_vec2(ANY_OFFSET);
  }
  any_of_kind(&a, &shapes[0], kind_a);
  any_of_kind(&b, &shapes[1], kind_b);
  any_cache(&cache);
  (void)gjk2_contacts(&a, &b, any_int32(), (unsigned)any_between(0, 3), any_bool() ? &cache : NULL, &manifold);
  return 0;
}
