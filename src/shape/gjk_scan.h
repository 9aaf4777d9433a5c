// Linear scans over vertices: where a query on hulls spends most of its time.
#ifndef GJK_SRC_SCAN_H
#define GJK_SRC_SCAN_H

#include "../arith/gjk_coarse.h"

// The vertex with the largest product vertex . d, the first of equals, from first to before end. Pre: there is at least
// one; products are below 2^63 in size, components of vertices at most 2^bits, 1 <= bits <= 31.
const gjk_vec3 *gjk_scan(const gjk_vec3 *first, const gjk_vec3 *end, unsigned bits, const gjk_vec3 *d);

// A scan for all vertices with vertex . d >= limit. Pre: limit is the product of one of the vertices, less a slack of at
// most 2^33. For the filter of GJK_NARROW_MULTIPLY also: the largest component of d has 29 bits or more; the slack is at
// most 2^(bits + 2) where bits is below 31.
typedef struct gjk_reach {
  const gjk_vec3 *next, *end;  // the vertices still to be looked at
  const gjk_vec3 *d;
  int64_t limit;
#if GJK_NARROW_MULTIPLY
  gjk_coarse coarse;
  int32_t coarse_limit;
#elif GJK_VECTORS
  unsigned bits;          // 0: vertices are looked at one by one
  const gjk_vec3 *first;  // bit i of marked: first[i] is yet to be looked at
  uint64_t marked;
#endif
} gjk_reach;

#if GJK_VECTORS
// Vectors are faster from this many vertices on. At least eight.
#define GJK_SCAN_VECTORS_FROM 12

// gjk_scan and gjk_reach_next for at least that many vertices.
const gjk_vec3 *gjk_scan_vectors(const gjk_vec3 *first, size_t count, unsigned bits, const gjk_vec3 *d);
const gjk_vec3 *gjk_reach_next_vectors(gjk_reach *reach);
#endif

// Prepares the filter. Pre: next, end, d and limit are set.
#if GJK_NARROW_MULTIPLY
void gjk_reach_start(gjk_reach *reach, unsigned bits);
#else
static inline void gjk_reach_start(gjk_reach *reach, unsigned bits) {
#if GJK_VECTORS
  reach->bits = reach->end - reach->next >= GJK_SCAN_VECTORS_FROM ? bits : 0;
  reach->first = NULL;
  reach->marked = 0;
#else
  (void)reach;
  (void)bits;
#endif
}
#endif

// The next vertex that reaches the limit; NULL: there are no more.
const gjk_vec3 *gjk_reach_next(gjk_reach *reach);

#endif
