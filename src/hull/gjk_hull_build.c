// Points to a hull: their order, their dimension, and what each dimension needs.
//
//   1. Sort the points by their coordinates and leave out repeated ones. All that follows depends on that order alone.
//   2. Find four points that span space: the first, the last, and from all others those that span most. If there are
//      none, the points lie in a plane, in a line or in one place.
//   3. In space: gjk_hull_grow. In a plane: the outline in the order of the points, its lower and its upper chain.
//   4. Count what is extreme.
#include "gjk_hull_facets.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_sort.h"

// Does point i come before point j? By x, then y, then z, and equal ones by index: so of equals the first is kept.
static bool point_before(const void *items, uint32_t i, uint32_t j) {
  const gjk_hull_work *w = (const gjk_hull_work *)items;
  const gjk_vec3 *a = gjk_hull_point(w, i), *b = gjk_hull_point(w, j);
  if (a->x != b->x) {
    return a->x < b->x;
  }
  if (a->y != b->y) {
    return a->y < b->y;
  }
  return a->z != b->z ? a->z < b->z : w->order[i] < w->order[j];
}

static void exchange_hull_points(void *items, uint32_t i, uint32_t j) {
  uint16_t *order = ((const gjk_hull_work *)items)->order;
  const uint16_t index = order[i];
  order[i] = order[j];
  order[j] = index;
}

// Step 1.
static void sort_points(gjk_hull_work *w, uint32_t count) {
  static const gjk_sort_order by_coordinates = {point_before, exchange_hull_points};
  for (uint32_t i = 0; i < count; i++) {
    w->order[i] = (uint16_t)i;
  }
  gjk_sort(&by_coordinates, w, count);
  w->distinct = 1;
  for (uint32_t i = 1; i < count; i++) {
    const gjk_vec3 *p = &w->points[w->order[i]], *last = gjk_hull_point(w, w->distinct - 1);
    if (p->x != last->x || p->y != last->y || p->z != last->z) {
      w->order[w->distinct++] = w->order[i];
    }
  }
}

// The point that spans the largest triangle with the first and the last one, by the sum of its normal's components.
// False: all are in line.
static bool find_third(const gjk_hull_work *w, uint16_t corner[4]) {
  const gjk_vec3 *a = gjk_hull_point(w, corner[0]), *b = gjk_hull_point(w, corner[1]);
  uint64_t most = 0;
  for (uint32_t i = 1; i + 1 < w->distinct; i++) {
    gjk_long3 n;
    gjk_triangle_normal(a, b, gjk_hull_point(w, i), &n);  // each component below 2^60
    const uint64_t size = gjk_magnitude64(n.x) + gjk_magnitude64(n.y) + gjk_magnitude64(n.z);
    if (size > most) {
      most = size;
      corner[2] = (uint16_t)i;
    }
  }
  return most > 0;
}

// The point farthest from the plane of three, and the three so that it is below them. False: all are in the plane.
static bool find_fourth(const gjk_hull_work *w, uint16_t corner[4]) {
  gjk_hull_plane plane;
  plane.at = gjk_hull_point(w, corner[0]);
  gjk_triangle_normal(plane.at, gjk_hull_point(w, corner[1]), gjk_hull_point(w, corner[2]), &plane.n);
  int64_t most = 0;
  uint32_t most_low = 0;
  bool below = false;
  for (uint32_t i = 1; i + 1 < w->distinct; i++) {
    uint32_t low;
    int64_t high = gjk_hull_height(&plane, gjk_hull_point(w, i), &low);
    const bool negative = high < 0;
    if (negative) {  // the height as its size
      high = low == 0 ? -high : -high - 1;
      low = low == 0 ? 0 : (UINT32_C(1) << 31) - low;
    }
    if (high > most || (high == most && low > most_low)) {
      most = high;
      most_low = low;
      below = negative;
      corner[3] = (uint16_t)i;
    }
  }
  if (!below) {
    const uint16_t second = corner[1];
    corner[1] = corner[2];
    corner[2] = second;
  }
  return most != 0 || most_low != 0;
}

unsigned gjk_hull_span(const gjk_hull_work *w, uint16_t corner[4]) {
  corner[0] = 0;
  corner[1] = (uint16_t)(w->distinct - 1);
  corner[2] = corner[3] = 0;
  if (w->distinct < 3 || !find_third(w, corner)) {
    return w->distinct > 1 ? 1 : 0;
  }
  return find_fourth(w, corner) ? 3 : 2;
}

// The sign of the turn a, b, c as seen against n, the normal of their plane. Pre: n != 0.
static int outline_turn(const gjk_hull_work *w, const gjk_long3 *n, uint16_t a, uint16_t b, uint16_t c) {
  gjk_long3 own;
  gjk_triangle_normal(gjk_hull_point(w, a), gjk_hull_point(w, b), gjk_hull_point(w, c), &own);
  // A multiple of n: any component of n that is not 0 tells its sign.
  const int64_t of_n = n->x != 0   ? n->x
                       : n->y != 0 ? n->y
                                   : n->z,
                of_own = n->x != 0   ? own.x
                         : n->y != 0 ? own.y
                                     : own.z;
  return of_own == 0 ? 0 : (of_own > 0) == (of_n > 0) ? 1 : -1;
}

// Adds a point to a chain that began at index base of next, and takes back those that no longer turn left.
static uint32_t extend_chain(gjk_hull_work *w, const gjk_long3 *n, uint32_t base, uint32_t length, uint16_t point) {
  while (length >= base + 2 && outline_turn(w, n, w->next[length - 2], w->next[length - 1], point) <= 0) {
    length--;  // each point once
  }
  w->next[length] = point;
  return length + 1;
}

// Step 3 in a plane: the corners of the outline, counterclockwise against n, to next (Andrew 1979). Returns how many.
// Points are in order by coordinates: no two are level along that direction. next has room for one point more, the
// first one again.
static uint32_t find_outline(gjk_hull_work *w, const gjk_long3 *n) {
  uint32_t length = 0;
  for (uint32_t i = 0; i < w->distinct; i++) {
    length = extend_chain(w, n, 0, length, (uint16_t)i);
  }
  const uint32_t base = length - 1;
  for (uint32_t i = w->distinct - 1; i > 0; i--) {
    length = extend_chain(w, n, base, length, (uint16_t)(i - 1));
  }
  return length - 1;
}

// Sets next of each corner to its number, of other points to GJK_HULL_NO_POINT. The first elements of w->of become the
// corners' numbers in the order of the outline.
static uint16_t number_outline(gjk_hull_work *w, uint32_t corners) {
  uint16_t number = 0;
  for (uint32_t i = 0; i < corners; i++) {
    w->of[i] = w->next[i];
  }
  for (uint32_t i = 0; i < w->distinct; i++) {
    w->next[i] = GJK_HULL_NO_POINT;
  }
  for (uint32_t i = 0; i < corners; i++) {
    w->next[w->of[i]] = 0;
  }
  for (uint32_t i = 0; i < w->distinct; i++) {
    if (w->next[i] == 0) {
      w->next[i] = number++;
    }
  }
  for (uint32_t i = 0; i < corners; i++) {
    w->of[i] = w->next[w->of[i]];
  }
  return number;
}

// Steps 2 to 4.
static void build_hull(gjk_hull_work *w, gjk_hull *out) {
  uint16_t corner[4];
  out->dimension = (uint8_t)gjk_hull_span(w, corner);
  out->faces = 0;
  out->edges = out->dimension;
  out->corners = 0;
  out->most_corners = 0;
  out->vertices = (uint16_t)(out->dimension + 1u);
  if (out->dimension == 2) {
    gjk_long3 n;
    gjk_triangle_normal(gjk_hull_point(w, corner[0]), gjk_hull_point(w, corner[1]), gjk_hull_point(w, corner[2]), &n);
    out->vertices = out->most_corners = number_outline(w, find_outline(w, &n));
    out->faces = 2;
    out->edges = out->vertices;
    out->corners = 2 * (uint32_t)out->vertices;
  } else if (out->dimension == 3) {
    gjk_hull_grow(w, corner);
    gjk_hull_join(w, out);
  }
}

gjk_status gjk_hull_build(const gjk_vec3 *points, uint16_t count, void *workspace, size_t bytes, gjk_hull *out) {
  if (points == NULL || workspace == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (!gjk_is_aligned(workspace)) {
    return GJK_ERROR_RANGE;
  }
  if (bytes < GJK_HULL_WORKSPACE(count)) {
    return GJK_ERROR_CAPACITY;
  }
  if (!gjk_hull_fits(points, count)) {
    return GJK_ERROR_SIZE;
  }
  gjk_hull_work w = gjk_hull_work_of(points, workspace, count);
  sort_points(&w, count);
  out->points = points;
  out->workspace = workspace;
  out->count = count;
  build_hull(&w, out);  // Steps 2 to 4
  out->distinct = w.distinct;
  out->triangles = w.triangles;
  return GJK_OK;
}
