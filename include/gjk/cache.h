// What a caller may keep per pair from one query to the next.
#ifndef GJK_CACHE_H
#define GJK_CACHE_H

#include "gjk/format.h"

// Zeroed is a cold start; so is NULL. Any content is safe, also that of another pair or of another query.
// Decision and distance never depend on it; witness points, normal and certificate may, among equally near
// ones. A lockstep game saves caches with its state, or passes none.
typedef struct gjk_cache {
  int16_t direction[3];  // last direction from A to B; all zero: none
  uint16_t count;        // pairs below
  uint16_t a[4], b[4];   // vertices of the last feature or simplex
} gjk_cache;

#endif
