// Linear scans over vertices: where a query on hulls spends most of its time.
#ifndef GJK_SRC_SCAN_H
#define GJK_SRC_SCAN_H

#include "coarse.h"

// Vertices with components of at most 2^bits in size, 1 <= bits <= 31; along the directions asked, vertex . d < 2^63.
typedef struct gjk_vertices {
  const gjk_vec3 *first;
  uint16_t count;  // at least 1
  uint8_t bits;
} gjk_vertices;

// The first of the vertices with the largest vertex . d.
const gjk_vec3 *gjk_scan(gjk_vertices vertices, const gjk_vec3 *d);

// The vertices with vertex . d >= limit, one after the other. Only this file and its source look inside.
typedef struct gjk_reach {
  const gjk_vec3 *next, *end, *d;
  int64_t limit;
#if GJK_NARROW_MULTIPLY
  gjk_coarse coarse;
  int32_t coarse_limit;
#endif
} gjk_reach;

// d stays in place.
void gjk_reach_start(gjk_reach *reach, gjk_vertices vertices, const gjk_vec3 *d, int64_t limit);

// The next one; NULL: no more.
const gjk_vec3 *gjk_reach_next(gjk_reach *reach);

#endif
