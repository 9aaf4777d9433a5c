// Heap sort (Williams 1964).
//
// In a heap item i comes after items 2 i + 1 and 2 i + 2, so item 0 is the last in order.
// 1. Make the items a heap: from the last item that has others below it to the first, let each sink.
// 2. Exchange item 0 with the last item of the heap, which is then in its place. The heap is one item shorter.
// 3. Let item 0 sink. Go on at 2 until one item is left.
#include "gjk_scene_sort.h"

void gjk_scene_sink(const gjk_scene_order *order, void *items, uint32_t at, uint32_t count) {
  for (uint32_t child = 2 * at + 1; child < count; child = 2 * at + 1) {  // ends: at most log2 count iterations
    if (child + 1 < count && order->before(items, child, child + 1)) {
      child++;
    }
    if (!order->before(items, at, child)) {
      return;
    }
    order->exchange(items, at, child);
    at = child;
  }
}

void gjk_scene_make_heap(const gjk_scene_order *order, void *items, uint32_t count) {
  for (uint32_t i = count / 2; i > 0; i--) {
    gjk_scene_sink(order, items, i - 1, count);
  }
}

void gjk_scene_sort(const gjk_scene_order *order, void *items, uint32_t count) {
  gjk_scene_make_heap(order, items, count);  // Step 1
  for (uint32_t end = count; end > 1; end--) {
    order->exchange(items, 0, end - 1);        // Step 2
    gjk_scene_sink(order, items, 0, end - 1);  // Step 3
  }
}
