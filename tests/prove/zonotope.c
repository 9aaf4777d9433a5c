// The facets of boxes, segments and points in each other: any half axes and centres, in any near frame.
#include "zonotope.h"

#include "colliders.h"

static void any_axes(gjk_collider *c, int32_t count) {
  c->count = (uint16_t)(count < 2 ? count : 3);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_iteration it;
  gjk_facet facet;
  const int32_t count_a = any_between(0, 2), count_b = any_between(0, 2);
  any_collider(&a, &shapes[0], &polytope);
  any_collider(&b, &shapes[1], &polytope);
  //@ split count_a;
  any_axes(&a, count_a);
  //@ split count_b;
  any_axes(&b, count_b);
  (void)gjk_iteration_start(&it, &a, &b, GJK_GOAL_SIGNED, any_between(0, 2 * GJK_RADIUS_MAX));
  if (it.shift >= 0) {
    facet.found = false;
    (void)gjk_zonotope_facet(&it, &facet);
  }
  return 0;
}
