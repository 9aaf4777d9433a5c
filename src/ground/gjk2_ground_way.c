// Which hits of a segment count.
//
// Ends of a segment are below 2^28 + 2 apart, |x| + |y|. A unit is Q2.30, and a centre below 2^32 from a vertex:
//   along . unit < 2^59, normal . (centre - vertex) <= 2^60
#include "gjk2_ground_way.h"

#include "../plane/gjk2_measure.h"

// The normal of a hit is within 2^-28. Less of it along the segment than this, per unit of |x| + |y|, is none.
#define ALONG_NOISE 16

bool gjk2_ground_is_own(const gjk2_line *line, const gjk2_unit *normal) {
  const gjk2_vec n = {normal->x, normal->y}, along = gjk2_sub(line->q, line->p);
  const int64_t off = gjk2_dot(along, n), noise = (int64_t)gjk2_norm1(along) * ALONG_NOISE;
  return off <= noise && off >= -noise;
}

gjk2_ground_side gjk2_ground_side_of(const gjk2_line *line, const gjk2_unit *normal) {
  const gjk2_vec n = {normal->x, normal->y}, along = gjk2_sub(line->q, line->p), own = gjk2_outward(along);
  if (gjk2_ground_is_own(line, normal)) {
    return GJK2_GROUND_OWN;
  }
  const bool at_end = gjk2_dot(along, n) > 0;
  if (at_end ? line->open_after : line->open_before) {
    return gjk2_dot(own, n) >= 0 ? GJK2_GROUND_BETWEEN : GJK2_GROUND_OTHER;
  }
  const gjk2_vec neighbour = at_end ? line->after : line->before, beside = gjk2_outward(neighbour);
  const int64_t turn = at_end ? gjk2_cross(along, neighbour) : gjk2_cross(neighbour, along);
  if (turn < 0) {
    return GJK2_GROUND_CONCAVE;
  }
  if (turn == 0 && gjk2_dot(along, neighbour) >= 0) {
    return GJK2_GROUND_OTHER;
  }
  // Counterclockwise from the first segment's normal to the second's, by at most half a turn.
  const gjk2_vec from = at_end ? own : beside, to = at_end ? beside : own;
  return gjk2_cross(from, n) >= 0 && gjk2_cross(n, to) >= 0 ? GJK2_GROUND_BETWEEN : GJK2_GROUND_OTHER;
}

bool gjk2_ground_is_ahead(const gjk2_line *line, const gjk2_collider *body, gjk_q16 apart) {
  const gjk2_vec n = gjk2_outward(gjk2_sub(line->q, line->p)), back = gjk2_negate(n);
  gjk2_support lowest;
  body->shape->type->support(body, &back, &lowest);
  const int64_t x = (int64_t)body->centre.x + lowest.offset.x - line->p.x;
  const int64_t y = (int64_t)body->centre.y + lowest.offset.y - line->p.y;
  const int64_t height = n.x * x + n.y * y;
  // Support points of curved shapes may be 1 LSB off.
  const int64_t radius = (int64_t)body->shape->convex_radius + apart + (gjk2_is_curved(body->shape) ? 2 : 0);
  return height > 0 && !gjk2_is_within(height, n, gjk_saturate(radius));
}

gjk2_aabb gjk2_ground_box_at(const gjk2_aabb *box, gjk_q16 margin, int64_t x, int64_t y) {
  const gjk2_aabb out = {{gjk_saturate(box->lower.x + x - margin), gjk_saturate(box->lower.y + y - margin)},
                         {gjk_saturate(box->upper.x + x + margin), gjk_saturate(box->upper.y + y + margin)}};
  return out;
}
