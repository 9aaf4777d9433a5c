// Stands in for src/plane/gjk2_meeting.c under the contacts: any answer that tests/prove/plane_query.c shows possible. Numbers
// are those of vertices.
#include "plane_colliders.h"
#include "src/plane/gjk2_meeting.h"

static uint16_t any_number(const gjk2_collider *c) {
  return (uint16_t)any_between(0, c->count > 0 ? c->count - 1 : 0);
}

gjk_status gjk2_meet(gjk2_meeting *m, const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache) {
  const gjk_status status = any_bool() ? GJK_OK : any_bool() ? GJK_ERROR_CAPACITY : GJK_ERROR_ITERATION_LIMIT;
  //@ split status;
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return status;
  }
  any_vertex(&m->edge.p);
  m->edge.p.a.vertex = any_number(a);
  m->edge.p.b.vertex = any_number(b);
  m->p = &m->edge.p;
  const gjk2_vec u = any_vec2(ANY_UNIT);
  m->normal.x = u.x;
  m->normal.y = u.y;
  m->distance = any_between(-(INT32_C(1) << 30), INT32_MAX);
  if (cache != NULL) {
    any_cache(cache);
  }
  return status;
}

bool gjk2_meeting_points(const gjk2_meeting *m, gjk2_vec *point_a, gjk2_vec *point_b) {
  check_within(m->distance, INT32_MAX);
  *point_a = any_position2();
  *point_b = any_position2();
  return any_bool();
}
