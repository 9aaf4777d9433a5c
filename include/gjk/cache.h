// What a caller may keep for each pair from one query to the next.
#ifndef GJK_CACHE_H
#define GJK_CACHE_H

#include "gjk/format.h"

// A cache changes speed and nothing else. Only iterations and certificate, which describe the search, depend on it. All
// other fields of every answer are the same with any cache or none. A zeroed cache, or NULL, is a cold start. Any
// content is safe, even that of another pair or query. Caches serve pairs of polytopes, with or without a convex
// radius. Other pairs do not use them. tests/check/unit/test_canonical.c checks this.
typedef struct gjk_cache {
  int16_t direction[3];  // last direction from A to B; all zero: none
  uint16_t count;        // pairs in use
  uint16_t a[4], b[4];   // vertices of the last feature or simplex, in pairs; after a depth of boxes a[3] is its plane
} gjk_cache;

#endif
