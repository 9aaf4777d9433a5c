// What a caller may keep per pair from one query to the next.
#ifndef GJK_CACHE_H
#define GJK_CACHE_H

#include "gjk/format.h"

// A cache changes speed and nothing else. Every field of every answer is the same with any cache and without, except
// iterations and certificate, which describe the search. A zeroed cache is a cold start; so is NULL. Any content is safe, also
// that of another pair or of another query. A cache serves pairs of polytopes, with or without a convex radius; queries on
// other pairs take nothing from it. tests/check/unit/test_canonical.c holds this.
typedef struct gjk_cache {
  int16_t direction[3];  // last direction from A to B; all zero: none
  uint16_t count;        // pairs in use
  uint16_t a[4], b[4];   // vertices of the last feature or simplex, in pairs; a[3] after a depth of boxes: its plane
} gjk_cache;

#endif
