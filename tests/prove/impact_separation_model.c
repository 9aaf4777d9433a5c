// Stands in for src/motion/gjk_impact_separation.c under the time of impact: any fraction that tests/prove/separation.c
// shows possible.
#include "movers.h"

static void check_mover(const gjk_mover *m) {
  //@ assert m->reach <= ANY_REACH;
  check_turning(&m->turning);
}

void gjk_movers_start(gjk_movers *of) {
  for (int i = 0; i < 2; i++) {
    const gjk_motion *motion = of->mover[i].motion;
    //@ assert \initialized(&motion->from.position) && \initialized(&motion->to.position);
    check_turning(&of->mover[i].turning);
  }
}

gjk_q30 gjk_separation_of_spheres(const gjk_movers *pair, int64_t target) {
  check_mover(&pair->mover[0]);
  check_mover(&pair->mover[1]);
  //@ assert target >= 0 && target <= INT64_C(1) << 38;
  return any_between(0, GJK_Q30_ONE);
}

int64_t gjk_separation_fall(const gjk_separation *s, const gjk_vec3 *point_a, const gjk_vec3 *point_b) {
  check_unit3(&s->n);
  check_vec3(point_a, INT32_MAX);
  check_vec3(point_b, INT32_MAX);
  return any_long(INT64_MAX);
}

gjk_q30 gjk_separation_holds(gjk_separation *s, int64_t above, int64_t target, int64_t enough) {
  check_unit3(&s->n);
  //@ assert s->start >= 0 && s->start <= GJK_Q30_ONE;
  check_size(above, INT64_C(1) << 41);
  //@ assert target >= 0 && target <= INT64_C(1) << 38;
  //@ assert enough >= 1 && enough <= INT64_C(1) << 38;
  if (s->carrier != NULL) {
    check_turning(s->carrier);
  }
  if (any_bool()) {
    s->carrier = NULL;
  }
  return any_between(s->start, GJK_Q30_ONE);
}

bool gjk_turning_of_edges(const gjk_mover mover[2], const gjk_certificate *nearest, const gjk_unit3 *n,
                          gjk_turning *out) {
  check_mover(&mover[0]);
  check_mover(&mover[1]);
  //@ assert nearest->count >= 2 && nearest->count <= 3;
  check_unit3(n);
  any_turning(out);
  return any_bool();
}
