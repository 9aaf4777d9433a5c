// What a caller may keep per pair from one query of the plane to the next.
#ifndef GJK2_CACHE_H
#define GJK2_CACHE_H

#include "gjk2/format.h"

// A zeroed cache is a cold start; so is NULL. Any content is safe, also that of another pair or of another query. A
// cache serves pairs of polygons, with or without a convex radius; queries on other pairs take nothing from it.
//
// Never depend on the cache   status, decision, distance, depth and bounds
// May depend on it            iterations; and, between polygons where several features are equally near, the witness
//                             points, normal, certificate, and contacts that follow from them
//
// A lockstep game that uses the latter saves its caches with its state, or passes none.
typedef struct gjk2_cache {
  int16_t direction[2];  // last direction from A to B; both zero: none
  uint16_t count;        // pairs in use
  uint16_t a[2], b[2];   // vertices of the last feature, in pairs
} gjk2_cache;

#endif
