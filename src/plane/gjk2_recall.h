// The nearest feature of two polygons, if a cache names it and it still is the nearest.
#ifndef GJK2_SRC_RECALL_H
#define GJK2_SRC_RECALL_H

#include "gjk2_close.h"

// Measures the pair as gjk2_touch_without_search, if the cache names its canonical feature. False: a search is needed.
bool gjk2_recall(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cache *cache, unsigned parts,
                 gjk2_distance_result *out);

// The same, where registers hold 64 bits and the code is not chosen for size.
static inline bool gjk2_recalls(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cache *cache, unsigned parts,
                                gjk2_distance_result *out) {
#if GJK_64_BIT && !GJK_SMALL
  return cache != NULL && cache->count != 0 && gjk2_recall(a, b, cache, parts, out);
#else
  (void)a, (void)b, (void)cache, (void)parts, (void)out;
  return false;
#endif
}

#endif
