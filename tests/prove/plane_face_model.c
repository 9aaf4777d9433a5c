// Stands in for src/plane_motion/gjk2_advance_face.c under casts with a radius: any answer that tests/prove/plane_face.c shows
// possible.
#include "plane_ways.h"
#include "src/plane_motion/gjk2_advance_face.h"

static void any_gap(gjk2_advancing *s) {
  gjk2_distance_result *gap = &s->gap;
  s->way->scans += any_uint16();
  gap->intersecting = any_bool();
  gap->saturated = any_bool();
  gap->distance = gap->intersecting ? 0 : any_between(0, INT32_MAX);
  gap->lower = gap->distance;
  gap->upper = gap->intersecting ? 0 : any_between(0, INT32_MAX);
  gap->point_a = any_position2();
  gap->point_b = any_position2();
  gap->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  gap->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  for (int i = 0; i < 2; i++) {
    gap->certificate.a[i] = any_uint16();
    gap->certificate.b[i] = any_uint16();
  }
}

// Of curved shapes a direction alone.
static void any_face(const gjk2_advancing *s, gjk2_face *face) {
  face->n = any_vec2(ANY_UNIT);
  face->count = 1;
  if (s->curved) {
    face->p.o = any_vec2(ANY_UNIT);
    return;
  }
  any_span(&face->p);
  if (any_bool()) {
    any_span(&face->q);
    face->count = 2;
  }
}

static void check_fraction(gjk_q30 fraction) {
  check_within(fraction, GJK_Q30_ONE);
}

bool gjk2_face_is_near(gjk2_advancing *s, gjk_q30 fraction) {
  check_fraction(fraction);
  any_gap(s);
  s->nearest = false;
  s->raw = false;
  s->open = any_bool();
  return any_bool();
}

void gjk2_face_of_gap(const gjk2_advancing *s, gjk2_face *face) {
  any_face(s, face);
}

void gjk2_face_load(const gjk2_way *way, uint16_t a, uint16_t b, gjk2_span *out) {
  (void)way;
  check_within(a, UINT16_MAX);
  check_within(b, UINT16_MAX);
  any_span(out);
}

void gjk2_face_touch(gjk2_advancing *s) {
  check_fraction(s->fraction);
  check_vec2(s->face.p.o, 2 * ANY_OFFSET);
  s->nearest = false;
  s->way->scans += any_uint16();
  any_face(s, &s->face);
}

void gjk2_face_shorten(gjk2_vec *n) {
  check_vec2(*n, ANY_UNIT);
  *n = any_vec2(ANY_UNIT);
}

bool gjk2_face_find(gjk2_advancing *s, gjk_q30 fraction) {
  check_fraction(fraction);
  s->nearest = true;
  if (any_bool()) {
    return false;
  }
  any_gap(s);
  if (!s->gap.intersecting) {
    any_face(s, &s->face);
  }
  return true;
}

bool gjk2_face_at_vertex(gjk2_advancing *s) {
  check_fraction(s->fraction);
  if (any_bool()) {
    return false;
  }
  s->way->scans++;
  any_face(s, &s->face);
  s->face.count = 1;
  return true;
}

bool gjk2_face_is_within(const gjk2_advancing *s, const gjk2_face *face, const gjk2_long *from) {
  check_within(s->radius, (INT64_C(1) << 29) - 1);
  check_vec2(face->n, ANY_UNIT);
  check_long2(from);
  return any_bool();
}

bool gjk2_face_is_met(const gjk2_advancing *s, const gjk2_face *face) {
  check_within(s->radius, (INT64_C(1) << 29) - 1);
  check_vec2(face->n, ANY_UNIT);
  return any_bool();
}
