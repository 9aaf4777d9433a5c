// The order of hits: by fraction, slot and part. For qsort; a test of the plane includes it under the plane's names.
#ifndef SCENE_HITS_H
#define SCENE_HITS_H

#include "scene/world.h"

static int order_hits(const void *x, const void *y) {
  const gjk_scene_hit *a = x, *b = y;
  const uint32_t key_a[] = {a->fraction, a->body.slot, a->part}, key_b[] = {b->fraction, b->body.slot, b->part};
  for (int i = 0; i < 3; i++) {
    if (key_a[i] != key_b[i]) {
      return key_a[i] < key_b[i] ? -1 : 1;
    }
  }
  return 0;
}

static bool same_hits(const gjk_scene_hit *a, const gjk_scene_hit *b, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    if (order_hits(&a[i], &b[i]) != 0 || a[i].body.generation != b[i].body.generation || a[i].user != b[i].user) {
      return false;
    }
  }
  return true;
}

#endif
