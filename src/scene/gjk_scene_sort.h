// A heap sort of items that the caller alone knows: in place, without recursion, in O(count log count) whatever their
// order.
#ifndef GJK_SRC_SCENE_SORT_H
#define GJK_SRC_SCENE_SORT_H

#include <stdbool.h>
#include <stdint.h>

// How to compare and exchange two items by their places in an array.
typedef struct gjk_scene_order {
  bool (*before)(const void *items, uint32_t i, uint32_t j);  // does item i come before item j?
  void (*exchange)(void *items, uint32_t i, uint32_t j);
} gjk_scene_order;

// Lets the item at a place sink in a heap of count items, which has the last item in order on top. Pre: at < count; the
// items below it are a heap.
void gjk_scene_sink(const gjk_scene_order *order, void *items, uint32_t at, uint32_t count);

// Makes count items a heap.
void gjk_scene_make_heap(const gjk_scene_order *order, void *items, uint32_t count);

// Sorts count items.
void gjk_scene_sort(const gjk_scene_order *order, void *items, uint32_t count);

#endif
