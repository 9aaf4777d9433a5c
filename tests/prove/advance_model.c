// Stands in for src/motion/gjk_advance.c under the casts: any answer, with what tests/prove/advance.c shows of it.
#include "src/motion/gjk_advance.h"

#include "gaps.h"

gjk_advance_answer gjk_advance(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, gjk_q16 margin,
                               gjk_cast_result *out) {
  const bool curved = gjk_is_curved(a->shape) || gjk_is_curved(b->shape);
  int32_t answer = any_between(GJK_ADVANCE_MISS, GJK_ADVANCE_LIMIT);
  check_way(way);
  //@ assert margin >= 0;
  if (curved && (answer == GJK_ADVANCE_START || answer == GJK_ADVANCE_OPEN)) {
    answer = GJK_ADVANCE_MISS;
  }
  //@ split answer;
  out->iterations = (uint8_t)any_between(0, UINT8_MAX);
  if (answer != GJK_ADVANCE_MISS && answer != GJK_ADVANCE_INSIDE) {
    const gjk_vec3 u = any_vec3(ANY_UNIT);
    out->inside = false;
    out->fraction = any_between(0, GJK_Q30_ONE);
    out->normal.x = u.x;
    out->normal.y = u.y;
    out->normal.z = u.z;
    out->point_a = any_position();
    out->point_b = any_position();
    out->rest_a = any_position();
    out->rest_b = any_position();
    out->saturated = any_bool();
  }
  return (gjk_advance_answer)answer;
}
