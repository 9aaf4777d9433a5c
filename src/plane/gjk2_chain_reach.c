// How far a body reaches towards a chain.
//
// Everything is relative to the body's centre. Vertices and directions are those of gjk2_chain_contacts.c:
//   |d| <= 2^30.5, |b - v| <= 2^30.5:   |height| <= 2^61, |d|^2 <= 2^61
#include "gjk2_chain_reach.h"

#include "../arith/gjk_wide.h"
#include "gjk2_hull.h"

#define EDGE_BYTE 255
#define CORNER_BYTES 127

void gjk2_chain_aim_along(const gjk2_collider *body, const gjk2_vec *d, const gjk2_vec *v, gjk2_chain_aim *out) {
  const gjk2_vec back = gjk2_negate(*d);
  gjk2_support found;
  if (gjk2_is_curved(body->shape)) {
    body->shape->type->support(body, &back, &found);
  } else {
    gjk2_hull_corner(body, back, &found);
  }
  out->d = *d;
  out->at = found.offset;
  out->height = gjk2_dot(*d, gjk2_sub(found.offset, *v));
  out->squared = (uint64_t)gjk2_dot(*d, *d);
  out->feature = found.vertex;
  out->id = (uint8_t)(found.vertex & CORNER_BYTES);
}

// out = height^2 squared, 192 bits: below 2^61^2 2^61.
static void square_of_reach(int64_t height, uint64_t squared, gjk_u192 *out) {
  gjk_u192 factor, product;
  gjk_u192_set(&factor, gjk_magnitude64(height));
  gjk_u192_multiply(&product, &factor, &factor);
  gjk_u192_set(&factor, squared);
  gjk_u192_multiply(out, &product, &factor);
}

#if !GJK_SMALL
// The leading bits of height^2 squared: (returned) / 2^*zeros, within 2^-29 of itself. 2^61 <= (returned); height != 0.
static uint64_t lead_of_reach(int64_t height, uint64_t squared, unsigned *zeros) {
  const uint64_t size = gjk_magnitude64(height);
  const unsigned hz = gjk_clz64(size), sz = gjk_clz64(squared);
  const uint32_t top = gjk_upper32(size, hz);
  *zeros = 2 * hz + sz;
  return gjk_umul32(gjk_umulh32(top, top), gjk_upper32(squared, sz));
}

// The sign of |a's reach| - |b's reach| where their leading bits tell; else 0.
static int compare_leads(const gjk2_chain_aim *a, const gjk2_chain_aim *b) {
  unsigned za, zb;
  if (a->height == 0 || b->height == 0) {
    return 0;
  }
  uint64_t x = lead_of_reach(a->height, b->squared, &za) >> 2, y = lead_of_reach(b->height, a->squared, &zb) >> 2;
  // Both are from 2^59 to 2^62: 4 bits of the exponent tell.
  if (za + 4 <= zb || zb + 4 <= za) {
    return za < zb ? 1 : -1;
  }
  x >>= za > zb ? za - zb : 0;
  y >>= zb > za ? zb - za : 0;
  const uint64_t slack = (x >> 26) + (y >> 26) + 2;
  return x > y + slack ? 1 : y > x + slack ? -1 : 0;
}

#endif

bool gjk2_chain_is_farther(const gjk2_chain_aim *a, const gjk2_chain_aim *b) {
  if ((a->height < 0) != (b->height < 0)) {
    return b->height < 0;
  }
#if !GJK_SMALL
  const int lead = compare_leads(a, b);
  if (lead != 0) {
    return a->height < 0 ? lead < 0 : lead > 0;
  }
#endif
  gjk_u192 x, y;
  square_of_reach(a->height, b->squared, &x);
  square_of_reach(b->height, a->squared, &y);
  const int sign = gjk_u192_compare(&x, &y);
  return a->height < 0 ? sign < 0 : sign > 0;
}

GJK_ONE_COPY static void keep_farther(const gjk2_chain_aim *aim, bool *found, gjk2_chain_aim *best) {
  if (!*found || gjk2_chain_is_farther(aim, best)) {
    gjk2_copy(&best->d, &aim->d);
    gjk2_copy(&best->at, &aim->at);
    best->height = aim->height;
    best->squared = aim->squared;
    best->feature = aim->feature;
    best->id = aim->id;
  }
  *found = true;
}

bool gjk2_chain_find_in_wedge(const gjk2_collider *body, const gjk2_vec *from, const gjk2_vec *to, const gjk2_vec *v,
                              gjk2_chain_aim *best) {
  gjk2_support corner, next, previous;  // next and previous: the ways from corner
  gjk2_chain_aim aim;
  bool found = false;
  gjk2_hull_corner(body, gjk2_negate(*from), &corner);
  (void)gjk2_hull_neighbour(body, &corner, false, &previous);  // 0 where there is none
  for (uint32_t i = 0; i <= body->count; i++) {                // at most once round
    const bool more = gjk2_hull_neighbour(body, &corner, true, &next);
    const gjk2_vec d = gjk2_sub(corner.offset, *v);
    const gjk2_vec edge = more ? next.offset : d;
    // v is nearest to this corner.
    if (gjk2_chain_is_in_wedge(from, to, &d) &&
        (!more || (gjk2_dot(edge, d) >= 0 && gjk2_dot(previous.offset, d) >= 0))) {
      aim.d = d;
      aim.squared = (uint64_t)gjk2_dot(d, d);
      aim.height = (int64_t)aim.squared;
      aim.at = corner.offset;
      aim.feature = corner.vertex;
      aim.id = (uint8_t)(corner.vertex & CORNER_BYTES);
      keep_farther(&aim, &found, best);
    }
    const gjk2_vec inward = gjk2_negate(gjk2_outward(edge));
    if (!more || !gjk2_chain_is_in_wedge(from, to, &inward)) {
      break;
    }
    const uint16_t low = corner.vertex < next.vertex ? corner.vertex : next.vertex;
    const uint16_t high = corner.vertex < next.vertex ? next.vertex : corner.vertex;
    aim.d = inward;
    aim.height = gjk2_dot(inward, d);
    aim.squared = (uint64_t)gjk2_dot(edge, edge);
    aim.at = corner.offset;
    aim.feature = (uint16_t)((low + 256 * (uint32_t)high) & UINT16_MAX);
    aim.id = EDGE_BYTE;
    keep_farther(&aim, &found, best);
    previous.offset = gjk2_negate(edge);
    gjk2_follow(&corner, &next);
  }
  return found;
}

int64_t gjk2_chain_measure(const gjk2_chain_aim *aim, gjk2_unit *unit) {
  gjk2_length length;
  gjk2_normal_set(unit, &length, &aim->d);
  const int64_t size = gjk2_round_distance(&length, GJK2_ROUND_NEAREST, gjk_magnitude64(aim->height));
  return aim->height < 0 ? -size : size;
}
