// src/plane_motion/gjk2_advance_face.h on any way, fraction, gap and face. CASE 0: two polygons, 1: a curved shape and any.
#include "plane_ways.h"
#include "src/plane_motion/gjk2_advance_face.h"

static void any_advancing(gjk2_advancing *s, gjk2_way *way) {
  s->way = way;
  s->margin = any_between(0, INT32_MAX);
  s->radius = (int64_t)way->a->shape->convex_radius + way->b->shape->convex_radius + s->margin;
  s->curved = CASE == 1;
  s->fraction = any_between(0, GJK_Q30_ONE);
}

static void check_face(const gjk2_face *face) {
  check_vec2(face->n, ANY_UNIT);
  check_within(face->count, 2);
}

static void any_named(gjk2_distance_result *gap) {
  gap->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  gap->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  gap->certificate.proof = CASE == 1 ? GJK2_PROOF_NONE : GJK2_PROOF_NEAREST;
  gap->certificate.count = (uint8_t)any_between(1, 2);
  for (int i = 0; i < 2; i++) {
    gap->certificate.a[i] = any_uint16();
    gap->certificate.b[i] = any_uint16();
  }
}

// With an edge of the face, or a vertex alone.
static void any_face(gjk2_face *face) {
  const unsigned count = (unsigned)any_between(1, 2);
  //@ split count;
  face->count = count;
  face->n = any_vec2(GJK_Q30_ONE);
  any_span(&face->p);
  if (count == 2) {
    any_span(&face->q);
  }
}

int main(void) {
  gjk2_shape shapes[2] = {0};
  gjk2_collider a = {0}, b = {0};
  gjk2_way way;
  gjk2_advancing s;
  gjk2_face face;
  any_posed(&a, &shapes[0], CASE == 0 ? &polygon : &curved);
  any_posed(&b, &shapes[1], CASE == 0 || any_bool() ? &polygon : &curved);
  a.state = GJK2_STATE_POSED;
  b.state = GJK2_STATE_POSED;
  any_way(&way, &a, &b);
  any_advancing(&s, &way);
  (void)gjk2_face_is_near(&s, any_between(0, GJK_Q30_ONE));
  any_named(&s.gap);
  gjk2_face_of_gap(&s, &face);
  check_face(&face);
  if (CASE == 0) {
    if (gjk2_face_find(&s, any_between(0, GJK_Q30_ONE)) && !s.gap.intersecting) {
      check_face(&s.face);
    }
    if (gjk2_face_at_vertex(&s)) {
      check_face(&s.face);
    }
    any_face(&s.face);
    s.radius = any_long(0, (INT64_C(1) << 29) - 1);
    const gjk2_long from = {any_long(-2 * ANY_WAY, 2 * ANY_WAY), any_long(-2 * ANY_WAY, 2 * ANY_WAY)};
    (void)gjk2_face_is_within(&s, &s.face, &from);
    (void)gjk2_face_is_met(&s, &s.face);
    gjk2_face_touch(&s);
    check_face(&s.face);
  }
  return 0;
}
