// Candidates for the nearest facet.
#include "facet.h"

#include "unit.h"

uint32_t gjk_height(const gjk_vec3 *d, const gjk_vec3 *w) {
  const gjk_unit3 u = gjk_unit(d);
  const int64_t along = gjk_sar64(gjk_along(&u, w), 30);
  return along <= 0 ? 0 : along < GJK_HEIGHT_MAX ? (uint32_t)along : GJK_HEIGHT_MAX;
}

bool gjk_facet_wants(const gjk_facet *best, int shift, uint32_t height) {
  if (!best->found || (!best->covers && height <= best->height + 2 * GJK_HEIGHT_ERROR)) {
    return true;
  }
  // Its exact height is above height - error, and has to be at most depth - 1.
  return best->depth > 0 && height <= ((uint32_t)(best->depth - 1) << shift) + GJK_HEIGHT_ERROR;
}

// The exact height of the simplex's triangle in LSB, rounded up.
static gjk_q16 exact_depth(const gjk_iteration *it, uint32_t height) {
  const uint32_t least = height > GJK_HEIGHT_ERROR ? height - GJK_HEIGHT_ERROR : 0, most = height + GJK_HEIGHT_ERROR;
  gjk_q16 low = gjk_height_to_lsb(least, it->shift), high = gjk_height_to_lsb(most, it->shift);
  if (low == high) {
    return low;
  }
  gjk_limbs numerator, denominator;
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  while (low < high) {  // at most 11 apart, so 4 times
    const gjk_q16 middle = low + (high - low) / 2;
    if (gjk_compare_distance(&numerator, &denominator, (uint64_t)middle << (it->shift + 1)) > 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

void gjk_facet_consider(gjk_facet *best, gjk_iteration *it, uint32_t height, gjk_q16 bound) {
  gjk_simplex *s = &it->simplex;
  const gjk_vertex corner[3] = {s->slot[0], s->slot[1], s->slot[2]};
  gjk_simplex_set(s, 3);
  const gjk_q16 depth = bound < 0 ? exact_depth(it, height) : bound;
  const bool covers = bound >= 0 || gjk_simplex_beyond(s) == 3;
  if (best->found && (depth > best->depth || (depth == best->depth && (best->covers || !covers)))) {
    return;
  }
  best->found = true;
  best->covers = covers;
  best->depth = depth;
  best->height = height;
  best->direction = it->direction;
  for (int i = 0; i < 3; i++) {
    best->corner[i] = corner[i];
  }
}

void gjk_facet_load(const gjk_facet *facet, gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  for (int i = 0; i < 3; i++) {
    s->slot[i] = facet->corner[i];
  }
  gjk_simplex_set(s, 3);
  if (gjk_simplex_beyond(s) == 3) {
    return;
  }
  // The nearest of its features: each vertex that is added makes the feature strictly nearer.
  gjk_simplex_clear(s);
  bool nearer = true;
  for (int round = 0; round < 4 && nearer; round++) {
    nearer = false;
    for (int i = 0; i < 3; i++) {
      *gjk_simplex_free(s) = facet->corner[i];
      nearer = (s->count < 3 && gjk_simplex_add(s) == GJK_STEP_NEARER) || nearer;
    }
  }
}
