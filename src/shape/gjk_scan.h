// Linear scans over vertices: where a query on hulls spends most of its time.
#ifndef GJK_SRC_SCAN_H
#define GJK_SRC_SCAN_H

#include "../arith/gjk_coarse.h"

// The first of the vertices from first to before end, at least one, with the largest vertex . d < 2^63. Their components are
// at most 2^bits in size, 1 <= bits <= 31.
const gjk_vec3 *gjk_scan(const gjk_vec3 *first, const gjk_vec3 *end, unsigned bits, const gjk_vec3 *d);

// Those of the vertices with vertex . d >= limit, one after the other. A component of d has 29 bits or more, and limit is the
// product of one of the vertices less a slack of at most 2^33, and at most 2^(bits + 2) for vertices of fewer than 31 bits.
typedef struct gjk_reach {
  const gjk_vec3 *next, *end;  // the vertices to look at, as above
  const gjk_vec3 *d;
  int64_t limit;
#if GJK_NARROW_MULTIPLY
  gjk_coarse coarse;
  int32_t coarse_limit;
#endif
} gjk_reach;

// Prepares the filter; the fields above are set.
#if GJK_NARROW_MULTIPLY
void gjk_reach_start(gjk_reach *reach, unsigned bits);
#else
static inline void gjk_reach_start(gjk_reach *reach, unsigned bits) {
  (void)reach;
  (void)bits;
}
#endif

// The next one; NULL: no more.
const gjk_vec3 *gjk_reach_next(gjk_reach *reach);

#endif
