// What casts with a radius measure of a direction and of a place on the way.
#include "../plane/gjk2_measure.h"
#include "gjk2_cast_report.h"

// One coordinate of a way at a fraction, to the nearest LSB.
static int64_t plane_part(int64_t way, gjk_q30 fraction) {
  return gjk_sar64(way * fraction + (INT64_C(1) << 29), 30);
}

gjk2_long gjk2_cast_place_from(const gjk2_way *way, gjk2_vec o, gjk_q30 fraction) {
  const gjk2_long from = {plane_part(way->t.x, fraction) - way->delta.x - o.x,
                          plane_part(way->t.y, fraction) - way->delta.y - o.y};
  return from;
}

// *to = *from. Where that may become a call of memcpy, word by word: see gjk2_copy.
GJK_ONCE static void plane_copy_collider(gjk2_collider *to, const gjk2_collider *from) {
#if GJK_64_BIT && !GJK_SMALL
  *to = *from;
#else
  to->shape = from->shape;
  to->buffer = from->buffer;
  gjk2_copy(&to->position, &from->position);
  gjk2_copy(&to->centre, &from->centre);
  gjk2_copy(&to->local_centre, &from->local_centre);
  for (int i = 0; i < 3; i++) {
    gjk2_copy(&to->frame[i], &from->frame[i]);
  }
  to->core_radius = from->core_radius;
  to->radius = from->radius;
  to->state = from->state;
  to->count = from->count;
  to->fraction[0] = from->fraction[0];
  to->fraction[1] = from->fraction[1];
  to->ordered = from->ordered;
#endif
}

const gjk2_collider *gjk2_cast_places(const gjk2_way *way, gjk_q30 fraction, gjk2_collider *at_a, gjk2_collider *at_b) {
  int64_t x = 0, y = 0;
  plane_copy_collider(at_b, way->b);
  if ((way->of_a.x | way->of_a.y) != 0) {
    x = plane_part(way->of_a.x, fraction);
    y = plane_part(way->of_a.y, fraction);
    plane_copy_collider(at_a, way->a);
    at_a->centre.x = (int32_t)(way->a->centre.x + x);
    at_a->centre.y = (int32_t)(way->a->centre.y + y);
  }
  at_b->centre.x = gjk_saturate(way->b->centre.x + x + plane_part(way->t.x, fraction));
  at_b->centre.y = gjk_saturate(way->b->centre.y + y + plane_part(way->t.y, fraction));
  return (way->of_a.x | way->of_a.y) != 0 ? at_a : way->a;
}

// |n| is scaled to 2^29 and above, so its rounding up to an integer costs at most radius / 2^29 of the gap.
//   |n| < 2^30 + 4, |w|, |t| < 2^32.7:  below 2^63
gjk2_bound gjk2_cast_bound(const gjk2_way *way, gjk2_vec n, int64_t most, int64_t radius, uint32_t near,
                           gjk_q30 *fraction, gjk2_rate *rate) {
  const unsigned zeros = gjk_clz64((uint64_t)gjk2_dot(n, n)) / 2;  // 2^(31 - zeros) <= |n| < 2^(32 - zeros)
  const unsigned up = zeros > 2 ? zeros - 2 : 0;
  const gjk2_vec scaled = {gjk_shl32(n.x, up), gjk_shl32(n.y, up)};
  const int64_t length = (int64_t)gjk2_root((uint64_t)gjk2_dot(scaled, scaled), near) + 1;
  const int64_t closing = -gjk2_way_ahead(way, scaled), ahead = -gjk_shl64(most, up) - radius * length;
  bool exact;
  *fraction = 0;
  if (closing <= 0) {
    return GJK2_BOUND_AWAY;
  }
  if (rate != NULL) {
    rate->length = length;
    rate->closing = closing;
  }
  if (ahead > closing) {
    return GJK2_BOUND_BEYOND;
  }
  if (ahead > 0) {
    *fraction = gjk2_ratio((uint64_t)ahead, (uint64_t)closing, &exact);
  }
  return GJK2_BOUND_AT;
}

int64_t gjk2_cast_foot(const gjk2_way *way, gjk2_vec p, gjk2_vec q, gjk_q30 fraction) {
  const gjk2_vec edge = gjk2_sub(q, p);
  const gjk2_long from = gjk2_cast_place_from(way, p, fraction);
  const int64_t part = from.x * edge.x + from.y * edge.y, whole = gjk2_dot(edge, edge);
  bool exact;
  if (part < 0 || part > whole) {
    return part < 0 ? -1 : (int64_t)GJK_Q30_ONE + 1;
  }
  return gjk2_ratio((uint64_t)part, (uint64_t)whole, &exact);
}
