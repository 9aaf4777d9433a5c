// Heap sort (Williams 1964) of items that only the caller knows: in place, without recursion, in O(count log count).
//
// In a heap item i comes after items 2 i + 1 and 2 i + 2, so item 0 is the last in order.
//
// 1. Make the items a heap: from the last item that has others below it to the first, let each sink.
// 2. Exchange item 0 with the last item of the heap, which is then in its place. The heap is one item shorter.
// 3. Let item 0 sink. Go on at 2 until one item is left.
//
// The functions are in a header so that compilers see the order and inline its functions. With calls through pointers,
// a query that sorts its hits takes 27 % more instructions. gjk_sort_sink stays out of line, once per file: inlined it
// makes the library 1,000 bytes larger.
#ifndef GJK_SRC_SORT_H
#define GJK_SRC_SORT_H

#include "gjk_wide.h"

// How to compare and exchange two items by their places. A file that sorts has one such constant.
typedef struct gjk_sort_order {
  bool (*before)(const void *items, uint32_t i, uint32_t j);  // does item i come before item j?
  void (*exchange)(void *items, uint32_t i, uint32_t j);
} gjk_sort_order;

// Lets the item at a place sink in a heap of count items: it is exchanged with the later one of the two below it, while
// that comes after it. Pre: the items below it are a heap.
GJK_OUT_OF_LINE static void gjk_sort_sink(const gjk_sort_order *order, void *items, uint32_t at, uint32_t count) {
  for (uint32_t child = 2 * at + 1; child < count; child = 2 * at + 1) {  // ends: at most log2 count iterations
    if (child + 1 < count && order->before(items, child, child + 1)) {
      child++;
    }
    if (!order->before(items, at, child)) {
      break;
    }
    order->exchange(items, at, child);
    at = child;
  }
}

// Makes count items a heap.
static inline void gjk_sort_make_heap(const gjk_sort_order *order, void *items, uint32_t count) {
  for (uint32_t i = count / 2; i > 0; i--) {
    gjk_sort_sink(order, items, i - 1, count);
  }
}

// Sorts count items.
static inline void gjk_sort(const gjk_sort_order *order, void *items, uint32_t count) {
  gjk_sort_make_heap(order, items, count);  // Step 1
  for (uint32_t end = count; end > 1; end--) {
    order->exchange(items, 0, end - 1);       // Step 2
    gjk_sort_sink(order, items, 0, end - 1);  // Step 3
  }
}

#endif
