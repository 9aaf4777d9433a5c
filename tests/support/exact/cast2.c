// The exact oracle of casts in the plane.
#include "cast2.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static exact_point to_point(const gjk2_vec *v) {
  const exact_point p = {{v->x, v->y, 0}};
  return p;
}

static bool is_zero_unit(const gjk2_unit *v) {
  return v->x == 0 && v->y == 0;
}

#define gjk_collider gjk2_collider
#define gjk_vec3 gjk2_vec
#define gjk_cast_path gjk2_cast_path
#define gjk_cast_result gjk2_cast_result
#define exact_cast exact2_cast
#define exact_cast_is_in_range exact2_cast_is_in_range
#define exact_check_cast exact2_check_cast

#include "cast_common.h"

static int64_t along(const exact_point *n, const exact2_point *p) {
  return n->x[0] * p->x + n->x[1] * p->y;
}

static void add_half_plane(exact2_cast *cast, int64_t x, int64_t y) {
  exact_difference *d = &cast->difference;
  exact_wide most = 0, least = 0;
  if (d->count == d->capacity) {
    d->capacity = 2 * d->capacity + 64;
    d->all = realloc(d->all, d->capacity * sizeof *d->all);
    if (d->all == NULL) {
      fprintf(stderr, "out of memory for the sides of A - B\n");
      exit(2);
    }
  }
  const exact2_shape *const shape[2] = {&cast->at_a.hull, &cast->at_b.hull};
  for (unsigned i = 0; i < shape[0]->count; i++) {
    const exact_wide p = (exact_wide)x * shape[0]->point[i].x + (exact_wide)y * shape[0]->point[i].y;
    most = i == 0 || p > most ? p : most;
  }
  for (unsigned i = 0; i < shape[1]->count; i++) {
    const exact_wide p = (exact_wide)x * shape[1]->point[i].x + (exact_wide)y * shape[1]->point[i].y;
    least = i == 0 || p < least ? p : least;
  }
  const exact_half_space half = {.normal = {x, y, 0}, .height = most - least};
  d->all[d->count++] = half;
}

// Both sides of each edge, and where all are parallel the ends of A - B.
static void find_difference(exact2_cast *cast) {
  const exact2_shape *const shape[2] = {&cast->at_a.hull, &cast->at_b.hull};
  exact_point first = nowhere;
  bool flat = true;
  cast->difference.count = 0;
  for (int s = 0; s < 2; s++) {
    for (unsigned i = 0; i < shape[s]->count; i++) {
      const exact2_point *p = &shape[s]->point[i], *q = &shape[s]->point[(i + 1) % shape[s]->count];
      const exact2_point e = {q->x - p->x, q->y - p->y};
      const exact_point turned = {{-e.y, e.x, 0}};
      if (e.x != 0 || e.y != 0) {
        flat = flat && along(&first, &e) == 0;  // edges are below 2^30
        first = first.x[0] == 0 && first.x[1] == 0 ? turned : first;
        add_half_plane(cast, turned.x[0], turned.x[1]);
        add_half_plane(cast, -turned.x[0], -turned.x[1]);
      }
    }
  }
  const bool point = first.x[0] == 0 && first.x[1] == 0;
  cast->difference.dimension = point ? 0 : flat ? 1 : 3;
  if (flat) {
    first.x[0] = point ? 1 : first.x[0];
    add_half_plane(cast, first.x[0], first.x[1]);
    add_half_plane(cast, -first.x[0], -first.x[1]);
    add_half_plane(cast, -first.x[1], first.x[0]);
    add_half_plane(cast, first.x[1], -first.x[0]);
  }
}

bool exact2_cast_set(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path, exact2_cast *out) {
  exact2_posed_free(&out->at_a);
  exact2_posed_free(&out->at_b);
  out->at_a.point = out->at_b.point = NULL;
  out->at_a.own_hull = out->at_b.own_hull = NULL;
  if (path->margin != 0 || a->shape->convex_radius != 0 || b->shape->convex_radius != 0 ||
      !exact2_cast_is_in_range(a, b, path, out) || !exact2_posed_set(a, &out->at_a)) {
    return false;
  }
  if (!exact2_posed_set(b, &out->at_b)) {
    return false;
  }
  find_difference(out);
  exact_cast_find(&out->difference, &nowhere, &out->way, &out->truth);
  return true;
}

// Is the point within so many LSB of the shape moved by a vector? By the oracle of the plane.
static bool is_of_shape(const gjk2_vec *point, const exact2_posed *shape, const gjk2_vec *from, const gjk2_vec *to,
                        int64_t limit) {
  const exact2_point at = {(int64_t)point->x - to->x + from->x, (int64_t)point->y - to->y + from->y};
  const exact2_shape one = {.point = &at, .count = 1};
  return exact2_within(&shape->hull, &one, limit);
}

// The shapes are at the reported fraction, which is less than a step of 2^-30 of the way before contact.
static bool are_points(const exact2_cast *cast, const gjk2_cast_result *r, char *why, size_t n) {
  const bool stands = is_zero(&cast->way_a);
  const int64_t longest = llabs(cast->way.x[0]) + llabs(cast->way.x[1]), step = longest / GJK_Q30_ONE;
  if (llabs((long long)r->point_a.x - r->point_b.x) > 1 + step ||
      llabs((long long)r->point_a.y - r->point_b.y) > 1 + step) {
    return refuse(why, n, "the points are apart");
  }
  if (!is_of_shape(&r->point_a, &cast->at_a, &cast->a->position, &r->rest_a, stands ? 1 : 3 + step)) {
    return refuse(why, n, "the point of A is off");
  }
  return is_of_shape(&r->point_b, &cast->at_b, &cast->b->position, &r->rest_b, 3 + step) ||
         refuse(why, n, "the point of B is off");
}

// A unit within 2^-28, against the way, and no a - b beyond the line across it through the entry.
static bool is_normal(const exact2_cast *cast, const gjk2_cast_result *r, char *why, size_t n) {
  const long double x = r->normal.x, y = r->normal.y, unit = GJK_Q30_ONE;
  const long double fraction = (long double)cast->truth.numerator / (long double)cast->truth.denominator;
  const long double way_x = (long double)cast->way.x[0], way_y = (long double)cast->way.x[1];
  bool right =
      fabsl(sqrtl(x * x + y * y) - unit) <= 4 && x * way_x + y * way_y <= 4.001L * (fabsl(way_x) + fabsl(way_y));
  for (unsigned i = 0; i < cast->at_a.hull.count && right; i++) {
    for (unsigned k = 0; k < cast->at_b.hull.count; k++) {
      const exact2_point *p = &cast->at_a.hull.point[i], *q = &cast->at_b.hull.point[k];
      const long double u = (long double)(p->x - q->x) - fraction * way_x;
      const long double v = (long double)(p->y - q->y) - fraction * way_y;
      right = right && x * u + y * v <= 4.001L * (fabsl(u) + fabsl(v)) + 1;
    }
  }
  return right || refuse(why, n, "the normal");
}
