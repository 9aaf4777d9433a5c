// Proves src/depth/gjk_box_sat.h for points, segments and boxes: any half axes, CASE of A's against 0, 1 and 3 of B's.
#include "src/depth/gjk_box_sat.h"

#include "colliders.h"
#include "facets.h"

extern int facet_is_found;  // by the model of the facet

static const gjk_shape_class axes = {.measure = any_measure,
                                     .pose = keep_pose,
                                     .support = any_support,
                                     .refine = any_refine,
                                     .vertex = any_vertex_of,
                                     .kind = GJK_KIND_AXES};

static void check_direction(const gjk_vec3 *d) {
  const gjk_vec3 copy = {d->x, d->y, d->z};
  check_vec3(&copy, INT32_C(1) << 30);
}

static void run(uint16_t count_a, uint16_t count_b) {
  gjk_shape shapes[2] = {0};
  gjk_collider a = {0}, b = {0};
  gjk_iteration it;
  gjk_facet facet;
  any_collider(&a, &shapes[0], &axes);
  any_collider(&b, &shapes[1], &axes);
  a.count = count_a;
  b.count = count_b;
  it.a = &a;
  it.b = &b;
  it.shift = (int8_t)any_between(0, 29);
  it.delta = any_vec3(INT32_C(1) << 30);
  it.stalls = NULL;
  gjk_simplex_clear(&it.simplex);
  facet.found = false;
  facet_is_found = 0;
  if (gjk_is_box_pair(&it)) {
    unsigned plane = (unsigned)any_between(0, 70000);
    bool points = any_bool();
    const gjk_box_sat_answer answer = gjk_box_sat(&it, &plane, &points, &facet);
    //@ split answer;
    if (answer == GJK_BOX_SAT_FACET) {
      check_facet(&facet, false);
    } else if (answer == GJK_BOX_SAT_APART) {
      check_direction(&it.direction.d);
    }
  }
}

int main(void) {
  run(CASE, 0);
  run(CASE, 1);
  run(CASE, 3);
  return 0;
}
