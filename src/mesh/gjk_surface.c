// The contacts of a body with a surface: those of every triangle that is near.
#include "../arith/gjk_memory.h"
#include "gjk/surface.h"
#include "gjk_triangle.h"

gjk_status gjk_surface_contacts(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                                const gjk_workspace *workspace, gjk_surface_contact *out, uint16_t capacity,
                                uint16_t *count) {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  gjk_surface_contact found;
  gjk_cache cache;
  uint16_t filled = 0;
  bool overflows = false;
  gjk_zero(&cache, sizeof cache);
  if (b == NULL || count == NULL || (out == NULL && capacity != 0)) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_open(&frame, &region, a, b), worst = GJK_OK;
  if (status != GJK_OK) {
    return status;
  }
  if (a->type->edges == NULL) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (margin < 0 || margin > GJK_RADIUS_MAX || most < 1 || most > GJK_CONTACTS_MAX) {
    return margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk_region_grow(&region, margin);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(&frame, &region, &walk, &found.triangle)) {  // ends: each triangle comes once
    gjk_manifold *manifold = filled < capacity ? &out[filled].manifold : &found.manifold;
    status = gjk_surface_meet(&frame, found.triangle, b, margin, most, &cache, workspace, manifold);
    worst = status == GJK_OK || worst == GJK_ERROR_ITERATION_LIMIT ? worst : status;
    if (status != GJK_OK && status != GJK_ERROR_CAPACITY && status != GJK_ERROR_ITERATION_LIMIT) {
      return status;
    }
    if (manifold->count > 0) {
      overflows = overflows || filled == capacity;
      if (filled < capacity) {
        out[filled].triangle = found.triangle;
        filled++;
      }
    }
  }
  *count = filled;
  return overflows ? GJK_ERROR_CAPACITY : worst;
}
