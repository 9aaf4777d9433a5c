// src/motion/gjk_impact_separation.h on any two bodies, direction and carrier. CASE 0: their shapes are any with vertices,
// 1: curved ones, 2: hulls that are not baked.
#include "movers.h"

// Of a hull that is not baked the vertices are scanned.
static const gjk_shape_class lazy_class = {.measure = any_measure,
                                           .pose = keep_pose,
                                           .support = any_support,
                                           .refine = any_refine,
                                           .vertex = any_vertex_of,
                                           .buffered = true,
                                           .kind = GJK_KIND_VERTICES};

static gjk_vec3 vertices[2];

static void any_mover(gjk_mover *m, gjk_shape *shape, const gjk_motion *motion, const gjk_pose *own) {
  any_collider(&m->collider, shape, CASE == 1 ? &curved : CASE == 2 ? &lazy_class : &polytope);
  shape->vertices = vertices;
  shape->user = NULL;
  shape->count = 2;
  m->collider.buffer = NULL;
  m->collider.position = any_position();
  m->motion = motion;
  m->own = own;
  m->place = any_position();
  m->reach = (uint32_t)Frama_C_long_long_interval(4, ANY_REACH);
  any_turning(&m->turning);
}

int main(void) {
  gjk_shape shapes[2] = {0};
  gjk_movers pair = {0};
  gjk_mover *mover = pair.mover;
  const gjk_motion motions[2] = {{any_pose(), any_pose(), any_position()}, {any_pose(), any_pose(), any_position()}};
  const gjk_pose own = any_pose();
  gjk_separation s;
  gjk_turning on;
  for (int i = 0; i < 2; i++) {
    vertices[i] = any_vec3(INT32_MAX);
  }
  for (int i = 0; i < 2; i++) {
    any_mover(&mover[i], &shapes[i], &motions[i], any_bool() ? &own : NULL);
  }
  const int64_t target = Frama_C_long_long_interval(0, INT64_C(1) << 38),
                enough = Frama_C_long_long_interval(1, INT64_C(1) << 38);
  gjk_movers_start(&pair);
  const gjk_q30 first = gjk_separation_of_spheres(&pair, target);
  //@ assert first >= 0 && first <= GJK_Q30_ONE;
  const gjk_certificate nearest = {{0, 0, 0}, {0, 1, 2, 0}, {2, 2, 3, 0}, 3, 0};
  s.pair = &pair;
  s.n = any_unit3();
  s.start = any_between(0, GJK_Q30_ONE);
  const int32_t carried = any_between(0, CASE == 1 ? 2 : 3);  // a curved shape has no edges
  //@ split carried;
  s.carrier = NULL;
  if (carried == 3) {
    if (gjk_turning_of_edges(mover, &nearest, &s.n, &on)) {
      check_turning(&on);
      s.carrier = &on;
    }
  } else if (carried > 0) {
    s.carrier = &mover[carried - 1].turning;
  }
  const gjk_vec3 point_a = any_position(), point_b = any_position();
  s.fall = gjk_separation_fall(&s, &point_a, &point_b);
  const gjk_q30 last = gjk_separation_holds(&s, any_long(INT64_C(1) << 41), target, enough);
  //@ assert last >= 0 && last <= GJK_Q30_ONE;
  return 0;
}
