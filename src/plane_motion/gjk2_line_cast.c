// Casts against a segment of ground. Where a body comes down on its inside, neither the start nor the end is searched.
//
// Let n be the segment's normal, e the edge of A - B that faces the body: from the segment's ends to the one or two vertices of
// the body that are lowest along n. Where the body is above the segment, and the foot of the origin is inside e, e is nearest.
//
//   1. That holds at the start, and the gap is more than the radii and the margin: no hit there.
//   2. At the end the foot is inside e too, and the height is at most the radii and the margin. Both change in proportion
//      to the way, so where the height is just that much the foot is inside: a hit.
//   3. Then gjk2_advance would find e at the start and go on from there. So that is what is done.
#include "../plane/gjk2_line.h"
#include "../plane/gjk2_measure.h"
#include "gjk2_cast_report.h"

// Vertices of a point, a segment or a box.
#define LINE_FEW 4

// An end of e.
static void span_of(gjk2_span *out, uint16_t vertex, const gjk2_vec *of_line, const gjk2_support *of_body) {
  out->a.vertex = vertex;
  gjk2_copy(&out->a.offset, of_line);
  gjk2_copy_support(&out->b, of_body);
  out->o = gjk2_sub(*of_line, of_body->offset);
}

// The lowest vertices of a body along n: the one farthest along the line in p, the one least far in q. False: there are others
// there, or many vertices.
static bool find_lowest(const gjk2_collider *body, gjk2_vec n, gjk2_vec along, gjk2_support *p, gjk2_support *q) {
  unsigned level = 1;
  if (body->count > LINE_FEW || gjk2_is_curved(body->shape)) {
    return false;
  }
  p->vertex = 0;
  (void)body->shape->type->vertex(body, 0, &p->offset);
  gjk2_copy_support(q, p);
  for (uint16_t i = 1; i < body->count; i++) {
    gjk2_support v;
    v.vertex = i;
    (void)body->shape->type->vertex(body, i, &v.offset);
    const int64_t higher = gjk2_dot(n, gjk2_sub(v.offset, p->offset));
    if (higher > 0) {
      continue;
    }
    level = higher < 0 ? 1 : level + 1;
    if (higher < 0 || gjk2_dot(along, gjk2_sub(v.offset, p->offset)) > 0) {
      gjk2_copy_support(p, &v);
    }
    if (higher < 0 || gjk2_dot(along, gjk2_sub(v.offset, q->offset)) < 0) {
      gjk2_copy_support(q, &v);
    }
  }
  return level == 1 || (level == 2 && !gjk2_equal(p->offset, q->offset));
}

// Is the foot of the origin inside e, seen from an end of the way? at: what to add to its ends.
static bool has_foot_inside(gjk2_vec at, gjk2_vec p, gjk2_vec q) {
  const gjk2_vec e = gjk2_sub(q, p);
  return gjk2_dot(gjk2_add(at, p), e) < 0 && gjk2_dot(gjk2_add(at, q), e) > 0;
}

// Steps 1 and 2. Sets e.
//
//   |delta|, |t| < 2^30, an offset <= 2^28, |n.x| + |n.y| <= 2^28 + 4:  heights < 2^60
static bool comes_down(const gjk2_way *way, int64_t radius, gjk2_vec n, gjk2_span *p, gjk2_span *q) {
  const gjk2_collider *line = way->a;
  const gjk2_vec along = gjk2_sub(line->frame[1], line->frame[0]);
  gjk2_support low, high;
  if (way->wide || !find_lowest(way->b, n, along, &low, &high)) {
    return false;
  }
  span_of(p, 0, &line->frame[0], &low);
  span_of(q, 1, &line->frame[1], &high);
  const gjk2_vec start = {(int32_t)way->delta.x, (int32_t)way->delta.y};
  const gjk2_vec end = {(int32_t)(way->delta.x - way->t.x), (int32_t)(way->delta.y - way->t.y)};
  const uint32_t x = gjk_magnitude32(n.x), y = gjk_magnitude32(n.y);
  const int64_t longest = (int64_t)x + y, least = x > y ? x : y;  // |n| is between
  return -gjk2_dot(n, gjk2_add(start, p->o)) > radius * longest &&
         -gjk2_dot(n, gjk2_add(end, p->o)) <= radius * least && has_foot_inside(start, p->o, q->o) &&
         has_foot_inside(end, p->o, q->o);
}

gjk_status gjk2_line_cast(const gjk2_collider *line, const gjk2_collider *body, const gjk2_cast_path *path,
                          gjk2_cast_result *out) {
  gjk2_way way;
  gjk2_span p, q;
  bool early, late;
  if (gjk2_way_set(&way, line, body, path, out) == GJK_OK) {
    const int64_t radius = (int64_t)body->shape->convex_radius + path->margin;
    const gjk2_vec n = gjk2_outward(gjk2_sub(line->frame[1], line->frame[0]));
    if (radius > 0 && comes_down(&way, radius, n, &p, &q) && gjk2_way_may_meet(&way, radius, &early, &late) && early) {
      return gjk2_advance_to_edge(&way, path->margin, &p, &q, out);
    }
  }
  return gjk2_cast(line, body, path, out);
}
