// The linear scan for the vertex farthest along a direction.
#include "scan.h"

// A running maximum that also sees near ties: whatever exceeds limit = (largest so far) - slack may matter.
#if GJK_NARROW_MULTIPLY

// On a core without a long multiplication a product of 32 bits costs a fifth of one of 64. So the scan first compares
// vertices and direction cut to 14 and 16 bits, and multiplies in full only those that come near the largest.
//
// With v = 2^s vc + r, d = 2^t dc + q, all 0 <= r < 2^s, 0 <= q < 2^t, |vc| <= 2^13, |dc| <= 2^15 per component:
//   v . d / 2^(s + t) - vc . dc = vc . q / 2^t + r . d / 2^(s + t)
// is at most 3 2^13 + 3 2^15 in size, and |vc . dc| <= 3 2^28.
#define COARSE_ERROR (3 * INT32_C(8192) + 3 * INT32_C(32768))

static unsigned bits_of(uint32_t x) {
  return x == 0 ? 0 : 32 - gjk_clz32(x);
}

typedef struct coarse {
  int32_t x, y, z;  // of the direction
  unsigned s;
} coarse;

static int32_t coarse_dot(const coarse *c, const gjk_vec3 *v) {
  return gjk_sar32(v->x, c->s) * c->x + gjk_sar32(v->y, c->s) * c->y + gjk_sar32(v->z, c->s) * c->z;
}

// The exact scan of the vertices whose coarse product is at least limit.
static uint16_t scan_candidates(const gjk_scan *scan, const coarse *c, int32_t limit, uint32_t first, bool *tie) {
  uint32_t best = first;
  int64_t farthest = gjk_dot(scan->vertices[first], scan->d) - scan->slack;
  *tie = false;
  for (uint32_t i = first + 1; i < scan->n; i++) {
    if (coarse_dot(c, &scan->vertices[i]) >= limit) {
      const int64_t along = gjk_dot(scan->vertices[i], scan->d);
      if (along > farthest) {
        const int64_t lead = along - farthest;
        *tie = lead <= 2 * scan->slack;
        if (lead > scan->slack) {
          best = i;
          farthest = along - scan->slack;
        }
      }
    }
  }
  return (uint16_t)best;
}

uint16_t gjk_scan_farthest(const gjk_scan *scan, bool *tie) {
  const gjk_vec3 d = scan->d;
  const unsigned v_bits = bits_of(scan->reach);
  const unsigned d_bits = bits_of(gjk_magnitude32(d.x) | gjk_magnitude32(d.y) | gjk_magnitude32(d.z));
  const unsigned s = v_bits > 13 ? v_bits - 13 : 0, t = d_bits > 15 ? d_bits - 15 : 0;
  const coarse c = {gjk_sar32(d.x, t), gjk_sar32(d.y, t), gjk_sar32(d.z, t), s};
  // A slack comes with a direction of 30 bits, so t >= 15 and margin < 2^19: with the differences of coarse products, at
  // most 3 2^29, it stays below 2^31.
  const int32_t margin = 2 * COARSE_ERROR + 1 + (int32_t)gjk_sar64(scan->slack, s + t);
  const gjk_vec3 *const end = scan->vertices + scan->n;
  const gjk_vec3 *best = scan->vertices;
  int32_t limit = coarse_dot(&c, best) - margin;
  bool near = false;
  for (const gjk_vec3 *v = best + 1; v != end; v++) {
    const int32_t along = coarse_dot(&c, v);
    if (along > limit) {
      near = along - limit <= 2 * margin;
      if (along - limit > margin) {
        best = v;
        limit = along - margin;
      }
    }
  }
  *tie = false;
  if (!near) {
    return (uint16_t)(best - scan->vertices);
  }
  uint32_t first = 0;
  while (coarse_dot(&c, &scan->vertices[first]) < limit) {  // ends at best or before
    first++;
  }
  return scan_candidates(scan, &c, limit, first, tie);
}

#else

uint16_t gjk_scan_farthest(const gjk_scan *scan, bool *tie) {
  const int32_t x = scan->d.x, y = scan->d.y, z = scan->d.z;
  const int64_t slack = scan->slack;
  const gjk_vec3 *const end = scan->vertices + scan->n;
  const gjk_vec3 *best = scan->vertices;
  int64_t limit = gjk_dot(*best, scan->d) - slack;
  bool near = false;
  for (const gjk_vec3 *v = best + 1; v != end; v++) {
    const int64_t along = gjk_mul32(v->x, x) + gjk_mul32(v->y, y) + gjk_mul32(v->z, z);
    if (along > limit) {
      near = along - limit <= 2 * slack;
      if (along - limit > slack) {
        best = v;
        limit = along - slack;
      }
    }
  }
  *tie = near;
  return (uint16_t)(best - scan->vertices);
}

#endif
