// Shapes and pairs of the plane at random, and the truth about them by brute force: the hull of all differences of
// vertices, each of its edges in 128 bits.
#ifndef PLANE_H
#define PLANE_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk2/gjk2.h"
#include "random.h"
#include "src/plane/gjk2_class.h"

#define PLANE_VERTICES 64

__extension__ typedef __int128 plane_wide;

typedef struct plane_point {
  int64_t x, y;
} plane_point;

typedef struct plane_body {
  gjk2_vec vertices[PLANE_VERTICES], buffer[PLANE_VERTICES];
  gjk2_shape shape;
  gjk2_pose pose;
  gjk2_collider collider;
} plane_body;

static int64_t plane_cross(plane_point a, plane_point b, plane_point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static int plane_compare(const void *p, const void *q) {
  const plane_point *a = (const plane_point *)p, *b = (const plane_point *)q;
  return a->x != b->x ? (a->x > b->x) - (a->x < b->x) : (a->y > b->y) - (a->y < b->y);
}

// The strict hull of points, counterclockwise, by Andrew's monotone chains. hull has room for count + 1.
static inline int plane_hull(plane_point *points, int count, plane_point *hull) {
  int n = 0;
  qsort(points, (size_t)count, sizeof *points, plane_compare);
  for (int pass = 0; pass < 2; pass++) {
    const int start = n;
    for (int i = 0; i < count; i++) {
      const plane_point p = points[pass == 0 ? i : count - 1 - i];
      while (n >= start + 2 && plane_cross(hull[n - 2], hull[n - 1], p) <= 0) {
        n--;
      }
      if (n == 0 || hull[n - 1].x != p.x || hull[n - 1].y != p.y) {
        hull[n++] = p;
      }
    }
    n -= n > start + (pass == 0);
  }
  return n > 0 ? n : 1;
}

// All posed vertices, world frame.
static inline int plane_vertices(const gjk2_collider *c, plane_point *out) {
  int n = 0;
  gjk2_vec offset;
  while (c->shape->type->vertex(c, (uint16_t)n, &offset)) {
    out[n].x = (int64_t)c->centre.x + offset.x;
    out[n].y = (int64_t)c->centre.y + offset.y;
    n++;
  }
  return n;
}

typedef struct plane_truth {
  plane_point hull[PLANE_VERTICES * PLANE_VERTICES + 2];
  int count;
  bool overlap;  // the cores share a point
} plane_truth;

static inline void plane_truth_of(const gjk2_collider *a, const gjk2_collider *b, plane_truth *t) {
  static plane_point differences[PLANE_VERTICES * PLANE_VERTICES], of_a[PLANE_VERTICES], of_b[PLANE_VERTICES];
  const int n = plane_vertices(a, of_a), m = plane_vertices(b, of_b);
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < m; j++) {
      differences[i * m + j].x = of_a[i].x - of_b[j].x;
      differences[i * m + j].y = of_a[i].y - of_b[j].y;
    }
  }
  t->count = plane_hull(differences, n * m, t->hull);
  const plane_point origin = {0, 0};
  t->overlap = true;
  for (int i = 0; i < t->count; i++) {
    const plane_point p = t->hull[i], q = t->hull[(i + 1) % t->count];
    t->overlap = t->overlap && plane_cross(p, q, origin) >= 0;
    if (t->count <= 2) {  // on the segment: between its ends too
      t->overlap =
          t->overlap && p.x * (p.x - q.x) + p.y * (p.y - q.y) >= 0 && (t->count == 2 || (p.x == 0 && p.y == 0));
    }
  }
}

// The sign of 2 distance - twice, where distance is that of the edge from p to q from the origin.
static inline int plane_compare_edge(plane_point p, plane_point q, int64_t twice) {
  const int64_t x = q.x - p.x, y = q.y - p.y, length = x * x + y * y;
  const int64_t foot = -(p.x * x + p.y * y);
  plane_wide left, right = (plane_wide)twice * twice;
  if (twice < 0) {
    return 1;
  }
  if (foot <= 0 || foot >= length) {
    const plane_point end = foot <= 0 ? p : q;
    left = 4 * ((plane_wide)end.x * end.x + (plane_wide)end.y * end.y);
  } else {
    const int64_t height = p.x * q.y - p.y * q.x;
    left = 4 * (plane_wide)height * height;
    right *= length;
  }
  return (left > right) - (left < right);
}

// Compares twice the distance of A - B from the origin with a number.
static inline int plane_compare_distance(const plane_truth *t, int64_t twice) {
  int least = 1;
  for (int i = 0; i < t->count; i++) {
    const int sign = plane_compare_edge(t->hull[i], t->hull[(i + 1) % t->count], twice);
    least = sign < least ? sign : least;
  }
  return least;
}

// Compares the distance of the nearest edge's line, of an overlap, with a number of LSB.
static inline int plane_compare_depth(const plane_truth *t, int64_t lsb) {
  int least = 1;
  if (t->count == 1) {
    return (0 > lsb) - (0 < lsb);
  }
  for (int i = 0; i < t->count; i++) {
    const plane_point p = t->hull[i], q = t->hull[(i + 1) % t->count];
    const int64_t x = q.x - p.x, y = q.y - p.y, height = p.x * q.y - p.y * q.x;
    const plane_wide left = (plane_wide)height * height, right = (plane_wide)lsb * lsb * (x * x + y * y);
    const int sign = (left > right) - (left < right);
    least = lsb < 0 ? 1 : sign < least ? sign : least;
  }
  return least;
}

// How far a point is from the boundary of a shape's core, in LSB. inside: is it in the core? NULL: not asked.
static inline long double plane_boundary_distance(const gjk2_collider *c, const gjk2_vec *point, bool *inside) {
  plane_point vertices[PLANE_VERTICES], hull[PLANE_VERTICES + 2];
  const int n = plane_hull(vertices, plane_vertices(c, vertices), hull);
  long double least = INFINITY;
  bool left_of_all = n > 2;
  for (int i = 0; i < n; i++) {
    const plane_point p = hull[i], q = hull[(i + 1) % n];
    const long double x = q.x - p.x, y = q.y - p.y, u = point->x - p.x, v = point->y - p.y;
    const long double length = x * x + y * y;
    long double t = length > 0 ? (u * x + v * y) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    const long double distance = hypotl(u - t * x, v - t * y);
    least = distance < least ? distance : least;
    left_of_all = left_of_all && x * v - y * u >= 0;
  }
  if (inside != NULL) {
    *inside = left_of_all;
  }
  return least;
}

// How far a point is from a shape's core, in LSB; 0 inside.
static inline long double plane_distance_from(const gjk2_collider *c, const gjk2_vec *point) {
  bool inside;
  const long double least = plane_boundary_distance(c, point, &inside);
  return inside ? 0 : least;
}

// Each component from -most to most.
static inline gjk2_vec plane_random_vec(random_state *r, int32_t most) {
  gjk2_vec v;
  v.x = random_range(r, -most, most);
  v.y = random_range(r, -most, most);
  return v;
}

static inline gjk2_rotation plane_random_rotation(random_state *r) {
  gjk2_rotation rotation = {GJK_Q30_ONE, 0};
  switch (random_below(r, 4)) {
    case 0: break;
    case 1: {
      const gjk2_rotation raw = {random_range(r, -4, 4), random_range(r, -4, 4)};
      (void)gjk2_rotation_normalize(&raw, &rotation);
      break;
    }
    default: (void)gjk2_rotation_from_angle(random_range(r, -500000, 500000), &rotation);
  }
  return rotation;
}

// A shape of one of the kinds with vertices, within size of its origin.
static inline void plane_random_shape(random_state *r, int32_t size, plane_body *body) {
  const gjk_q16 radius = random_below(r, 3) == 0 ? random_range(r, 0, size / 2) : 0;
  const gjk_q16 x = random_range(r, 0, size), y = random_range(r, 0, size);
  const gjk2_shape shapes[5] = {GJK2_ROUNDED_POINT(radius), GJK2_ROUNDED_SEGMENT(x, radius),
                                GJK2_ROUNDED_BOX(x, y, radius), GJK2_ROUNDED_TRIANGLE(body->vertices, radius),
                                GJK2_ROUNDED_POLYGON(body->vertices, 0, radius)};
  const unsigned kind = random_below(r, 7);
  gjk2_shape shape = shapes[kind < 4 ? kind : 4];
  uint16_t count = (uint16_t)(1 + random_below(r, random_below(r, 4) == 0 ? PLANE_VERTICES : 9));
  const gjk2_vec origin = plane_random_vec(r, size);
  const bool round = random_below(r, 2) == 0, line = random_below(r, 12) == 0;
  for (int i = 0; i < PLANE_VERTICES; i++) {
    gjk2_vec *v = &body->vertices[i];
    gjk2_rotation turn;
    (void)gjk2_rotation_from_angle(random_range(r, -300000, 300000), &turn);
    v->x = random_range(r, -size, size);
    v->y = random_range(r, -size, size);
    if (round) {
      v->x = (int32_t)((int64_t)turn.c * size >> 30);
      v->y = (int32_t)((int64_t)turn.s * size >> 30);
    }
    if (line) {
      v->y = v->x / 2 * 1;
    }
    if (i > 0 && random_below(r, 8) == 0) {
      *v = body->vertices[random_below(r, (uint32_t)i)];
      v->x -= origin.x;
      v->y -= origin.y;
    }
    v->x += origin.x;
    v->y += origin.y;
  }
  if (kind == 6) {
    (void)gjk2_polygon_order(body->vertices, count, body->vertices, &count);
  }
  if (kind >= 4) {
    shape.count = count;
  }
  body->shape = shape;
}

// Poses the body. baked: with its buffer.
static inline void plane_place(plane_body *body, bool baked) {
  body->collider.state = 0;
  const gjk_status status =
      gjk2_collider_init(&body->collider, &body->shape, baked ? body->buffer : NULL, PLANE_VERTICES);
  CHECK(status == GJK_OK);
  CHECK(gjk2_collider_pose(&body->collider, &body->pose) == GJK_OK);
}

// Two bodies of about size, spread apart from their common centre.
static inline void plane_random_pair(random_state *r, int32_t size, int32_t spread, plane_body pair[2]) {
  const gjk2_vec centre = plane_random_vec(r, 1000000);
  for (int i = 0; i < 2; i++) {
    plane_random_shape(r, size, &pair[i]);
    pair[i].pose.rotation = plane_random_rotation(r);
    gjk2_vec at = {0, 0};
    // Centre each body, whatever its shape's origin.
    pair[i].pose.position = at;
    plane_place(&pair[i], random_below(r, 2) == 0);
    at.x = centre.x + random_range(r, -spread, spread) - pair[i].collider.centre.x;
    at.y = centre.y + random_range(r, -spread, spread) - pair[i].collider.centre.y;
    pair[i].pose.position = at;
    CHECK(gjk2_collider_pose(&pair[i].collider, &pair[i].pose) == GJK_OK);
  }
}

// A pair of any size from an LSB to 2^26, its bodies spread by up to most / 2 of it.
static inline void plane_any_pair(random_state *r, int32_t most, plane_body pair[2]) {
  static const int32_t sizes[] = {1, 2, 3, 8, 40, 1000, 65536, 1 << 22, 1 << 26};
  const int32_t size = sizes[random_below(r, 9)];
  plane_random_pair(r, size, (int32_t)((int64_t)size * random_range(r, 0, most) / 2), pair);
}

static inline void plane_print(const void *subject) {
  const plane_body *pair = (const plane_body *)subject;
  for (int i = 0; i < 2; i++) {
    const gjk2_collider *c = &pair[i].collider;
    plane_point vertices[PLANE_VERTICES];
    const int n = plane_vertices(c, vertices);
    printf("  radius %d, ordered %d:", (int)c->shape->convex_radius, c->ordered);
    for (int k = 0; k < n; k++) {
      printf(" (%lld, %lld)", (long long)vertices[k].x, (long long)vertices[k].y);
    }
    printf("\n");
  }
}

#endif
