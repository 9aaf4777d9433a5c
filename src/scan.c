// The linear scan for the vertex farthest along a direction.
#include "scan.h"

#include "coarse.h"

// A running maximum that also sees near ties: whatever exceeds limit = (largest so far) - slack may matter.
#if GJK_NARROW_MULTIPLY

// The scan first compares coarse products, and multiplies in full only those that come near the largest.
// The exact scan of the vertices from first to before end whose coarse product is at least least.
static gjk_farthest scan_candidates(const gjk_vec3 *vertices, const gjk_vec3 *first, const gjk_vec3 *end,
                                    const gjk_vec3 *d, int64_t slack, const gjk_coarse *c, int32_t least) {
  const gjk_vec3 *best = first;
  int64_t limit = gjk_dot(first, d) - slack;
  bool tie = false;
  for (const gjk_vec3 *v = first + 1; v != end; v++) {
    if (gjk_coarse_dot(c, v) >= least) {
      const int64_t lead = gjk_dot(v, d) - limit;
      if (lead > 0) {
        tie = lead <= 2 * slack;
      }
      if (lead > slack) {
        best = v;
        limit += lead - slack;
      }
    }
  }
  const gjk_farthest found = {(uint16_t)(best - vertices), tie};
  return found;
}

gjk_farthest gjk_scan(const gjk_vec3 *vertices, uint32_t n, unsigned bits, const gjk_vec3 *d, uint32_t slack) {
  const gjk_coarse c = gjk_coarse_direction(d, bits);
  const unsigned shift = c.s + c.t;
  // A slack comes with a direction of 30 bits, so t >= 15 and margin < 2^19: with the differences of coarse products, at
  // most 3 2^29, it stays below 2^31.
  const int32_t margin = 2 * GJK_COARSE_ERROR + 1 +
                         (int32_t)(slack >> (shift < 2        ? 0
                                             : shift - 2 < 31 ? shift - 2
                                                              : 31));
  const gjk_vec3 *const end = vertices + n;
  const gjk_vec3 *best = vertices;
  int32_t limit = gjk_coarse_dot(&c, best) - margin;
  bool near = false;
  for (const gjk_vec3 *v = best + 1; v != end; v++) {
    const int32_t along = gjk_coarse_dot(&c, v);
    if (along > limit) {
      near = along - limit <= 2 * margin;
      if (along - limit > margin) {
        best = v;
        limit = along - margin;
      }
    }
  }
  if (near) {
    const gjk_vec3 *first = vertices;
    while (gjk_coarse_dot(&c, first) < limit) {  // ends at best or before
      first++;
      //@ assert first <= best;
    }
    return scan_candidates(vertices, first, end, d, (int64_t)slack * 4, &c, limit);
  }
  const gjk_farthest found = {(uint16_t)(best - vertices), false};
  return found;
}

#else

gjk_farthest gjk_scan(const gjk_vec3 *vertices, uint32_t n, unsigned bits, const gjk_vec3 *d, uint32_t slack) {
  (void)bits;
  const int32_t x = d->x, y = d->y, z = d->z;
  const int64_t margin = (int64_t)slack * 4;
  const gjk_vec3 *const end = vertices + n;
  const gjk_vec3 *best = vertices;
  int64_t limit = gjk_dot(best, d) - margin;
  bool tie = false;
  for (const gjk_vec3 *v = best + 1; v != end; v++) {
    const int64_t along = gjk_mac32(gjk_mac32(gjk_mul32(v->x, x), v->y, y), v->z, z);
    if (along > limit) {
      const int64_t lead = along - limit - margin;
      tie = lead <= margin;
      if (lead > 0) {
        best = v;
        limit = along - margin;
      }
    }
  }
  const gjk_farthest found = {(uint16_t)(best - vertices), tie};
  return found;
}

#endif
