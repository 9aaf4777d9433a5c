// The convex hull of a set of points and its numbers: Graham's scan, in place.
//
//   1. Check that no cross product can overflow. Copy the points to out.
//   2. Bring the lowest point, of equally low ones the leftmost, to the front.
//   3. Sort the others by their angle about it, the nearer first among equals: a heapsort, which needs no memory.
//   4. Keep those at which the boundary turns left.
// Cross products decide steps 3 and 4: of edges below 2^30 they are below 2^61, so every sign is exact.
#include "gjk2/polygon.h"

#include "gjk2_outline.h"

// Step 3: does p come before q, seen from origin? Of p = q neither does.
static bool has_smaller_angle(gjk2_vec origin, gjk2_vec p, gjk2_vec q) {
  const gjk2_vec from_p = gjk2_sub(p, origin), from_q = gjk2_sub(q, origin);
  //@ assert from_p.x >= -2 * GJK2_RADIUS_MAX && from_p.x <= 2 * GJK2_RADIUS_MAX;
  //@ assert from_p.y >= -2 * GJK2_RADIUS_MAX && from_p.y <= 2 * GJK2_RADIUS_MAX;
  //@ assert from_q.x >= -2 * GJK2_RADIUS_MAX && from_q.x <= 2 * GJK2_RADIUS_MAX;
  //@ assert from_q.y >= -2 * GJK2_RADIUS_MAX && from_q.y <= 2 * GJK2_RADIUS_MAX;
  const int64_t turn = gjk2_cross(from_p, from_q);
  // Both lie in the upper half, so equal angles are equal directions; origin itself comes first of all.
  if (gjk2_norm1(from_p) == 0 || gjk2_norm1(from_q) == 0) {
    return gjk2_norm1(from_p) < gjk2_norm1(from_q);
  }
  return turn != 0 ? turn > 0 : gjk2_norm1(from_p) < gjk2_norm1(from_q);
}

static void exchange_points(gjk2_vec *p, gjk2_vec *q) {
  const gjk2_vec kept = *p;
  *p = *q;
  *q = kept;
}

// Restores the heap below item i of the first count items: no item comes after its parent.
static void sift_down(gjk2_vec origin, gjk2_vec *items, uint32_t i, uint32_t count) {
  for (uint32_t child = 2 * i + 1; child < count; child = 2 * i + 1) {  // at most 16 levels
    if (child + 1 < count && has_smaller_angle(origin, items[child], items[child + 1])) {
      child++;
    }
    if (!has_smaller_angle(origin, items[i], items[child])) {
      return;
    }
    exchange_points(&items[i], &items[child]);
    i = child;
  }
}

static void sort_by_angle(gjk2_vec origin, gjk2_vec *items, uint32_t count) {
  for (uint32_t i = count / 2; i > 0; i--) {
    sift_down(origin, items, i - 1, count);
  }
  for (uint32_t end = count; end > 1; end--) {
    exchange_points(&items[0], &items[end - 1]);
    sift_down(origin, items, 0, end - 1);
  }
}

// Step 4. A corner is dropped when the way by it to the next point does not turn left.
static uint32_t keep_corners(gjk2_vec *v, uint32_t count) {
  uint32_t kept = 1;
  for (uint32_t i = 1; i < count; i++) {
    if (gjk2_equal(v[i], v[0])) {
      continue;
    }
    while (kept > 1 && gjk2_cross(gjk2_sub(v[kept - 1], v[kept - 2]), gjk2_sub(v[i], v[kept - 1])) <= 0) {
      kept--;
    }
    v[kept++] = v[i];
  }
  return kept;
}

// Do two regions of as many bytes share a byte without being the same?
static bool overlap_partly(const void *p, const void *q, size_t bytes) {
  const uintptr_t a = (uintptr_t)p, b = (uintptr_t)q;
  return a != b && (a < b ? b - a : a - b) < bytes;
}

gjk_status gjk2_polygon_order(const gjk2_vec *points, uint16_t count, gjk2_vec *out, uint16_t *out_count) {
  if (points == NULL || out == NULL || out_count == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (overlap_partly(points, out, count * sizeof *out)) {
    return GJK_ERROR_OVERLAP;
  }
  if (!gjk2_outline_fits(points, count)) {  // Step 1
    return GJK_ERROR_SIZE;
  }
  uint32_t lowest = 0;
  for (uint32_t i = 0; i < count; i++) {
    out[i] = points[i];
    if (out[i].y < out[lowest].y || (out[i].y == out[lowest].y && out[i].x < out[lowest].x)) {
      lowest = i;
    }
  }
  exchange_points(&out[0], &out[lowest]);               // Step 2
  sort_by_angle(out[0], out + 1, count - UINT32_C(1));  // Step 3
  *out_count = (uint16_t)keep_corners(out, count);
  return GJK_OK;
}

gjk_status gjk2_hull_build(const gjk2_vec *points, uint16_t count, gjk2_vec *vertices, gjk2_hull *out) {
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  uint16_t corners;
  const gjk_status status = gjk2_polygon_order(points, count, vertices, &corners);
  if (status != GJK_OK) {
    return status;
  }
  uint64_t area = 0;  // of triangles from the first corner: in all at most 2 (2 GJK2_RADIUS_MAX)^2 < 2^59
  for (uint32_t i = 1; i + 1 < corners; i++) {
    area += (uint64_t)gjk2_cross(gjk2_sub(vertices[i], vertices[0]), gjk2_sub(vertices[i + 1], vertices[0]));
  }
  out->dimension = corners < 3 ? (uint8_t)(corners - 1u) : 2;
  out->vertices = corners;
  out->twice_area = area;
  return GJK_OK;
}
