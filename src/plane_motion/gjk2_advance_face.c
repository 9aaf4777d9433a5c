// Faces of A - B: which is nearest when B has gone a fraction of its way, and whether the way meets it.
#include "gjk2_advance_face.h"

#include "../plane/gjk2_canonical.h"
#include "../plane/gjk2_close.h"
#include "../plane/gjk2_measure.h"
#include "gjk2/intersect.h"

GJK_OUT_OF_LINE bool gjk2_face_is_near(gjk2_advancing *s, gjk_q30 fraction) {
  gjk2_collider moved, at_b;
  const gjk2_collider *at_a = gjk2_cast_places(s->way, fraction, &moved, &at_b);
  s->nearest = false;
  s->raw = false;
  s->open = gjk2_distance(at_a, &at_b, NULL, &s->gap) != GJK_OK;
  s->way->scans += s->gap.iterations;
  if (s->gap.intersecting || s->gap.distance != s->margin || s->margin == 0) {
    return s->gap.intersecting || s->gap.distance < s->margin;
  }
  gjk2_decision decision;
  if (gjk2_within(at_a, &at_b, s->margin, NULL, &decision) != GJK_OK) {
    return true;
  }
  s->way->scans += decision.iterations;
  return decision.yes;
}

void gjk2_face_load(const gjk2_way *way, uint16_t a, uint16_t b, gjk2_span *out) {
  const gjk2_vec none = {0, 0};
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    gjk2_copy_span(out, &gjk2_origin_span);
    return;
  }
  out->a.vertex = a;
  out->b.vertex = b;
  out->a.offset = none;
  out->b.offset = none;
  (void)way->a->shape->type->vertex(way->a, a, &out->a.offset);
  (void)way->b->shape->type->vertex(way->b, b, &out->b.offset);
  out->o = gjk2_sub(out->a.offset, out->b.offset);
}

// Makes the face the edge from p to q, unless they are the same, with its normal on the side of towards.
static void plane_face_turn(gjk2_face *face, gjk2_vec towards) {
  const gjk2_vec across = gjk2_outward(gjk2_sub(face->q.o, face->p.o));
  if (gjk2_norm1(across) != 0) {
    face->count = 2;
    face->n = gjk2_dot(across, towards) < 0 ? gjk2_negate(across) : across;
  }
}

void gjk2_face_of_gap(const gjk2_advancing *s, gjk2_face *face) {
  const gjk2_certificate *c = &s->gap.certificate;
  face->n.x = s->gap.normal.x;
  face->n.y = s->gap.normal.y;
  face->p.o = gjk2_negate(face->n);  // not used: of polygons apart the proof is NEAREST
  face->count = 1;
  if (c->proof != GJK2_PROOF_NEAREST) {
    return;
  }
  gjk2_face_load(s->way, c->a[0], c->b[0], &face->p);
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && c->count == 2) {
    gjk2_face_load(s->way, c->a[1], c->b[1], &face->q);
    plane_face_turn(face, face->n);
  }
}

// One coordinate of the way at a fraction, exact, less from, Q30. Pre: it is below 2^30 in size.
GJK_ONE_COPY static int64_t plane_fine_part(int64_t way, gjk_q30 fraction, int64_t from) {
  const int64_t exact = way * fraction, whole = gjk_sar64(exact, 30);  // below 2^62
  return gjk_shl64(whole - from, 30) + (exact - gjk_shl64(whole, 30));
}

// From a vertex to the exact place of the fraction, as fine as 30 bits allow. Pre: it is at most 2^29 away along an axis.
static gjk2_vec plane_fine_place(const gjk2_advancing *s, gjk2_vec o) {
  const gjk2_way *way = s->way;
  const int64_t x = plane_fine_part(way->t.x, s->fraction, way->delta.x + o.x);
  const int64_t y = plane_fine_part(way->t.y, s->fraction, way->delta.y + o.y);
  const unsigned zeros = gjk_clz64(gjk_magnitude64(x) | gjk_magnitude64(y) | 1);
  const unsigned down = zeros < 35 ? 35 - zeros : 0;
  const gjk2_vec n = {(int32_t)gjk_sar64(x, down), (int32_t)gjk_sar64(y, down)};  // below 2^29
  return n;
}

// Is the foot of a place between the vertices x and p, and the place on the other side of their line than q? to: from x.
static bool plane_faces(gjk2_vec to, gjk2_vec x, gjk2_vec p, gjk2_vec q) {
  const gjk2_vec edge = gjk2_sub(p, x);
  const int64_t side = gjk2_cross(edge, to);
  return gjk2_dot(to, edge) > 0 && (gjk2_cross(edge, gjk2_sub(q, x)) > 0 ? side < 0 : side > 0);
}

void gjk2_face_touch(gjk2_advancing *s) {
  gjk2_face *face = &s->face;
  s->nearest = false;
  face->count = 1;
  face->n = plane_fine_place(s, face->p.o);
  for (int i = 0; i < 16 && GJK_SHAPES >= GJK_SHAPES_ROUND; i++) {  // of points the face is the vertex
    gjk2_span x;
    gjk2_way_scan(s->way, face->n, &x);
    if (gjk2_dot(face->n, gjk2_sub(x.o, face->p.o)) <= 0) {
      break;
    }
    const gjk2_vec to = plane_fine_place(s, x.o);
    if (face->count == 1 ? gjk2_dot(to, gjk2_sub(face->p.o, x.o)) > 0 : plane_faces(to, x.o, face->p.o, face->q.o)) {
      gjk2_copy_span(&face->q, &x);
      plane_face_turn(face, to);
    } else if (face->count == 2 && plane_faces(to, x.o, face->q.o, face->p.o)) {
      gjk2_copy_span(&face->p, &x);
      plane_face_turn(face, to);
    } else {
      gjk2_copy_span(&face->p, &x);
      face->count = 1;
      gjk2_copy(&face->n, &to);
    }
  }
}

#if !GJK_SMALL  // code chosen for size measures distances alone
void gjk2_face_shorten(gjk2_vec *n) {
  gjk2_length length;
  gjk2_unit unit;
  gjk2_normal_set(&unit, &length, n);
  n->x = unit.x;
  n->y = unit.y;
}

// A vertex of A - B.
static void plane_take_vertex(const gjk2_vertex *from, gjk2_span *out) {
  gjk2_copy_support(&out->a, &from->a);
  gjk2_copy_support(&out->b, &from->b);
  out->o = gjk2_sub(out->a.offset, out->b.offset);
}

GJK_OUT_OF_LINE bool gjk2_face_find(gjk2_advancing *s, gjk_q30 fraction) {
  gjk2_distance_result *gap = &s->gap;
  gjk2_search search;
  gjk2_collider moved, moved_b;
  const gjk2_collider *at_a = s->way->a, *at_b = s->way->b;
  if (fraction != 0) {
    at_a = gjk2_cast_places(s->way, fraction, &moved, &moved_b);
    at_b = &moved_b;
  }
  s->nearest = true;
  if (gjk2_touch_without_search(at_a, at_b, 0, gap)) {
    s->way->scans++;
    s->raw = gap->certificate.count == 1;
    gap->normal.x = gap->certificate.direction.x;
    gap->normal.y = gap->certificate.direction.y;
    if (!gap->intersecting) {
      gjk2_face_of_gap(s, &s->face);
    }
    return true;
  }
  (void)gjk2_search_start(&search, at_a, at_b, false, (uint32_t)(s->radius - s->margin));
  if (search.far != 0) {
    return false;
  }
  const gjk2_outcome outcome = gjk2_search_feature(&search, GJK2_GOAL_DISTANCE, GJK2_NO_LIMIT);
  s->way->scans += search.iterations;
  gap->intersecting = outcome != GJK2_OUTCOME_NEAREST;
  if (gap->intersecting) {
    gjk2_search_certify(&search, outcome, &gap->certificate);
    return true;
  }
  gjk2_face *face = &s->face;
  face->count = search.count;
  gjk2_copy(&face->n, &search.d);
  plane_take_vertex(gjk2_search_vertex(&search, 0), &face->p);
  if (search.count == 2) {
    plane_take_vertex(gjk2_search_vertex(&search, 1), &face->q);
  } else {
    s->raw = GJK2_DIRECT;
    if (!GJK2_DIRECT) {
      gjk2_face_shorten(&face->n);
    }
  }
  return true;
}

bool gjk2_face_at_vertex(gjk2_advancing *s) {
  const gjk2_long from = gjk2_cast_place_from(s->way, gjk2_origin_span.o, s->fraction);
  const int64_t near = INT64_C(1) << 28, radii = s->radius - s->margin;
  if (from.x > near || from.x < -near || from.y > near || from.y < -near ||
      from.x * from.x + from.y * from.y <= radii * radii) {
    return false;
  }
  s->way->scans++;
  s->raw = GJK2_DIRECT;
  s->face.n.x = (int32_t)from.x;
  s->face.n.y = (int32_t)from.y;
  if (!GJK2_DIRECT) {
    gjk2_face_shorten(&s->face.n);
  }
  s->face.count = 1;
  gjk2_copy_span(&s->face.p, &gjk2_origin_span);
  return true;
}

//   |edge|, |n| <= 2^30, components of from below 3 2^29:  products below 3 2^60, and its square below 9 2^59
bool gjk2_face_is_within(const gjk2_advancing *s, const gjk2_face *face, const gjk2_long *from) {
  const int64_t reach = INT64_C(3) << 29;
  if (from->x >= reach || from->x <= -reach || from->y >= reach || from->y <= -reach) {
    return false;
  }
  const gjk2_vec at = {(int32_t)from->x, (int32_t)from->y};
  if (face->count == 1) {
    return gjk2_dot(at, at) <= s->radius * s->radius;
  }
  const gjk2_vec edge = gjk2_sub(face->q.o, face->p.o);
  const int64_t height = gjk2_dot(face->n, at), part = gjk2_dot(edge, at);
  return height >= 0 && part >= 0 && part <= gjk2_dot(edge, edge) &&
         gjk2_is_within(height, face->n, (int32_t)s->radius);
}

bool gjk2_face_is_met(const gjk2_advancing *s, const gjk2_face *face) {
  const gjk2_way *way = s->way;
  const gjk2_vec p = face->p.o;
  const gjk2_long end = {way->t.x - way->delta.x - p.x, way->t.y - way->delta.y - p.y};
  if (way->wide) {
    return false;
  }
  if (face->count == 1 && gjk2_way_is_ahead(way, p, true) <= 0) {  // the line is nearest to p before the end
    return gjk2_way_is_ahead(way, p, false) >= 0 && !gjk2_way_is_beside(way, p, s->radius);
  }
  if (face->count == 2 && gjk2_way_along(way, face->n, p) <= 0 && face->n.x * end.x + face->n.y * end.y < 0) {
    const int64_t side_p = gjk2_way_side(way, p), side_q = gjk2_way_side(way, face->q.o);
    return side_p <= 0 ? side_q >= 0 : side_q <= 0;  // from one side of the edge to the other, between its ends
  }
  return gjk2_face_is_within(s, face, &end);
}
#endif
