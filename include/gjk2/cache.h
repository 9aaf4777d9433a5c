// What a caller may keep per pair from one query of the plane to the next.
#ifndef GJK2_CACHE_H
#define GJK2_CACHE_H

#include "gjk2/format.h"

// A cache changes speed and nothing else: every field of every answer but iterations and certificate, which tell of the way
// to it, is the same with any cache and without. A zeroed cache is a cold start; so is NULL. Any content is safe, also that
// of another pair or of another query. A cache serves pairs of polygons, with or without a convex radius; queries on other
// pairs take nothing from it. tests/check/unit/test_plane_canonical.c holds this.
typedef struct gjk2_cache {
  int16_t direction[2];  // last direction from A to B; both zero: none
  uint16_t count;        // pairs in use
  uint16_t a[2], b[2];   // vertices of the last feature, in pairs
} gjk2_cache;

#endif
