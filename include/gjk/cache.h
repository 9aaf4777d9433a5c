// What a caller may keep per pair from one query to the next.
#ifndef GJK_CACHE_H
#define GJK_CACHE_H

#include "gjk/format.h"

// A zeroed cache is a cold start; so is NULL. Any content is safe, also that of another pair or of another query. A
// cache serves pairs of polytopes, with or without a convex radius; queries on other pairs take nothing from it.
//
// Never depend on the cache   status, decision, distance, depth and bounds; what a scene reports
// May depend on it            iterations; and, between polytopes where several features are equally near, the witness
//                             points, normal, certificate, and contacts that follow from them
//
// A lockstep game that uses the latter saves its caches with its state, or passes none. tests/check/unit/test_history.c
// tests this, with low ceilings and small workspaces as well.
typedef struct gjk_cache {
  int16_t direction[3];  // last direction from A to B; all zero: none
  uint16_t count;        // pairs in use
  uint16_t a[4], b[4];   // vertices of the last feature or simplex, in pairs; a[3] after a depth of boxes: its plane
} gjk_cache;

#endif
