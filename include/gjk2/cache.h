// What a caller may keep for each pair from one query of the plane to the next.
#ifndef GJK2_CACHE_H
#define GJK2_CACHE_H

#include "gjk2/format.h"

// A cache changes speed and nothing else. Only iterations and certificate, which describe the search, depend on it. All
// other fields of every answer are the same with any cache or none. A zeroed cache, or NULL, is a cold start. Any
// content is safe, even that of another pair or query. Caches serve pairs of polygons, with or without a convex radius.
// Other pairs do not use them. tests/check/unit/test_plane_canonical.c checks this.
typedef struct gjk2_cache {
  int16_t direction[2];  // last direction from A to B; both zero: none
  uint16_t count;        // pairs in use
  uint16_t a[2], b[2];   // vertices of the last feature, in pairs; of three the second above the first's 8 bits
} gjk2_cache;

#endif
