// Cuts polygons into triangles: fans of convex ones, ears of others.
#include "polygon.h"

#include <stdlib.h>

#include "memory.h"

__extension__ typedef __int128 wide;

typedef struct flat_point {
  int64_t p, q;
} flat_point;

// Twice the area of a triangle, above 0 if it is counterclockwise: differences below 2^33, products below 2^66.
static wide turn(const flat_point *a, const flat_point *b, const flat_point *c) {
  return (wide)(b->p - a->p) * (c->q - a->q) - (wide)(b->q - a->q) * (c->p - a->p);
}

static bool is_same(const flat_point *a, const flat_point *b) {
  return a->p == b->p && a->q == b->q;
}

static int64_t coordinate(const gjk_vec3 *v, int axis) {
  return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

// Twice the polygon's area as seen along an axis: sums of 2^12 products below 2^63.
static wide area_along(const gjk_vec3 *points, const uint32_t *at, size_t corners, int axis) {
  const int p = (axis + 1) % 3, q = (axis + 2) % 3;
  wide sum = 0;
  for (size_t i = 0; i < corners; i++) {
    const gjk_vec3 *a = &points[at[i]], *b = &points[at[(i + 1) % corners]];
    sum += (wide)coordinate(a, p) * coordinate(b, q) - (wide)coordinate(a, q) * coordinate(b, p);
  }
  return sum;
}

static wide magnitude(wide a) {
  return a < 0 ? -a : a;
}

// The polygon in the plane, counterclockwise, as seen along the axis from which it looks largest. False: it has no area.
static bool flatten(const gjk_vec3 *points, const uint32_t *at, size_t corners, flat_point *out) {
  int axis = 0;
  wide area = 0;
  for (int i = 0; i < 3; i++) {
    const wide one = area_along(points, at, corners, i);
    if (magnitude(one) > magnitude(area)) {
      area = one;
      axis = i;
    }
  }
  for (size_t i = 0; i < corners; i++) {
    const int64_t p = coordinate(&points[at[i]], (axis + 1) % 3), q = coordinate(&points[at[i]], (axis + 2) % 3);
    out[i].p = area < 0 ? q : p;
    out[i].q = area < 0 ? p : q;
  }
  return area != 0;
}

// Is the corner 'which' of those that are left an ear: a triangle turned as the polygon is, without any other corner?
static bool is_ear(const flat_point *flat, const size_t *left, size_t count, size_t which) {
  const flat_point *a = &flat[left[(which + count - 1) % count]], *b = &flat[left[which]];
  const flat_point *c = &flat[left[(which + 1) % count]];
  bool ear = turn(a, b, c) > 0;
  for (size_t i = 0; i < count && ear; i++) {
    const flat_point *x = &flat[left[i]];
    ear =
        turn(a, b, x) < 0 || turn(b, c, x) < 0 || turn(c, a, x) < 0 || is_same(x, a) || is_same(x, b) || is_same(x, c);
  }
  return ear;
}

// Cuts ears off until a fan is left. left: room for the corners' numbers.
static void cut_ears(const flat_point *flat, const uint32_t *at, size_t corners, size_t *left,
                     uint32_t (*triangle)[3]) {
  size_t count = corners, cut = 0, which = 0;
  for (size_t i = 0; i < corners; i++) {
    left[i] = i;
  }
  for (size_t tried = 0; count > 3 && tried < count;) {
    if (!is_ear(flat, left, count, which)) {
      which = (which + 1) % count;
      tried++;
      continue;
    }
    triangle[cut][0] = at[left[(which + count - 1) % count]];
    triangle[cut][1] = at[left[which]];
    triangle[cut++][2] = at[left[(which + 1) % count]];
    for (size_t i = which; i + 1 < count; i++) {
      left[i] = left[i + 1];
    }
    which = which % --count;
    tried = 0;
  }
  for (size_t i = 1; i + 1 < count; i++, cut++) {
    triangle[cut][0] = at[left[0]];
    triangle[cut][1] = at[left[i]];
    triangle[cut][2] = at[left[i + 1]];
  }
}

void polygon_cut(const gjk_vec3 *points, const uint32_t *at, size_t corners, uint32_t (*triangle)[3]) {
  flat_point *flat = solid_allocate(corners, sizeof flat[0]);
  size_t *left = solid_allocate(corners, sizeof left[0]);
  bool fan = !flatten(points, at, corners, flat);
  for (size_t i = 1; i + 1 < corners && !fan; i++) {
    if (turn(&flat[0], &flat[i], &flat[i + 1]) <= 0) {
      break;
    }
    fan = i + 2 == corners;
  }
  for (size_t i = 1; i + 1 < corners && fan; i++) {
    triangle[i - 1][0] = at[0];
    triangle[i - 1][1] = at[i];
    triangle[i - 1][2] = at[i + 1];
  }
  if (!fan) {
    cut_ears(flat, at, corners, left, triangle);
  }
  free(left);
  free(flat);
}
