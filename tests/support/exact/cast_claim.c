// Judges what gjk_cast says of polytopes.
#include "cast_claim.h"

#include <string.h>

#include "refuse.h"

static const exact_point nowhere = {{0, 0, 0}};

static exact_point to_point(const gjk_vec3 *v) {
  const exact_point p = {{v->x, v->y, v->z}};
  return p;
}

static exact_point way_of(const gjk_collider *c, const gjk_vec3 *to) {
  const exact_point at = to_point(&c->position), end = to == NULL ? at : to_point(to);
  return exact_subtract(&end, &at);
}

static bool stays_in_range(const gjk_collider *c, const exact_point *way) {
  const exact_point at = to_point(&c->centre);
  for (int i = 0; i < 3; i++) {
    const int64_t end = at.x[i] + way->x[i];
    if (end < INT32_MIN || end > INT32_MAX) {
      return false;
    }
  }
  return true;
}

bool exact_cast_is_in_range(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, exact_cast *out) {
  const int64_t limit = INT64_C(1) << 32;
  out->a = a;
  out->b = b;
  out->way_a = way_of(a, path->to_a);
  out->way_b = way_of(b, path->to_b);
  out->way = exact_subtract(&out->way_b, &out->way_a);
  bool right = stays_in_range(a, &out->way_a) && stays_in_range(b, &out->way_b);
  for (int i = 0; i < 3; i++) {
    right = right && out->way.x[i] < limit && out->way.x[i] > -limit;
  }
  return right;
}

bool exact_cast_set(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, exact_cast *out) {
  if (path->margin != 0 || a->shape->convex_radius != 0 || b->shape->convex_radius != 0 ||
      !exact_cast_is_in_range(a, b, path, out) || !exact_difference_find(a, b, &out->difference)) {
    return false;
  }
  exact_cast_find(&out->difference, &nowhere, &out->way, &out->truth);
  return true;
}

void exact_cast_free(exact_cast *cast) {
  exact_difference_free(&cast->difference);
}

// Is the place less than so many LSB from where the collider is at the fraction, along each axis?
static bool is_near(const exact_cast_truth *truth, const gjk_collider *c, const exact_point *way, const gjk_vec3 *place,
                    int64_t limit) {
  const exact_point at = to_point(&c->position), found = to_point(place);
  for (int i = 0; i < 3; i++) {
    if (exact_cast_compare(truth, &at, way, i, found.x[i] - limit) <= 0 ||
        exact_cast_compare(truth, &at, way, i, found.x[i] + limit) >= 0) {
      return false;
    }
  }
  return true;
}

// Where both stand, B against A: the displacement of B.
static exact_point displacement(const exact_cast *cast, const gjk_cast_result *r) {
  const exact_point a = to_point(&r->rest_a), b = to_point(&r->rest_b);
  const exact_point at_a = to_point(&cast->a->position), at_b = to_point(&cast->b->position);
  const exact_point by_a = exact_subtract(&a, &at_a), by_b = exact_subtract(&b, &at_b);
  return exact_subtract(&by_b, &by_a);
}

static bool same(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

static bool rests(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n) {
  const bool stands = cast->way_a.x[0] == 0 && cast->way_a.x[1] == 0 && cast->way_a.x[2] == 0;
  if (cast->truth.inside) {
    return (same(&r->rest_a, &cast->a->position) && same(&r->rest_b, &cast->b->position)) ||
           refuse(why, n, "inside: the places of rest are not the start");
  }
  if (!is_near(&cast->truth, cast->a, &cast->way_a, &r->rest_a, 1)) {
    return refuse(why, n, "A's place of rest is an LSB off");
  }
  // A's place is rounded, and B's away from it.
  if (!is_near(&cast->truth, cast->b, &cast->way_b, &r->rest_b, stands ? 1 : 2)) {
    return refuse(why, n, "B's place of rest is an LSB off");
  }
  const exact_point at = displacement(cast, r);
  return exact_difference_side(&cast->difference, &at, &nowhere, 0, 1) <= 0 ||
         refuse(why, n, "at their places of rest they overlap");
}

// Is the point within so many LSB of the shape, when its pose is there? Shapes of too many vertices are not looked at.
static bool is_of_shape(const gjk_vec3 *point, const gjk_collider *shape, const gjk_vec3 *position, gjk_q16 limit) {
  static const gjk_shape point_shape = GJK_POINT;
  gjk_collider at = {0}, moved = *shape;
  gjk_pose pose = GJK_POSE_IDENTITY;
  exact_truth truth;
  pose.position = *point;
  if (exact_vertex_count(shape) > EXACT_BRUTE_MAX / 2) {
    return true;
  }
  if (gjk_collider_move(&moved, position) != GJK_OK || gjk_collider_init(&at, &point_shape, NULL, 0) != GJK_OK ||
      gjk_collider_pose(&at, &pose) != GJK_OK) {
    return false;
  }
  exact_brute(&moved, &at, &truth);
  return exact_truth_within(&truth, &moved, &at, limit);
}

// The shapes at their places of rest are within 1 LSB per axis of where they touch, so less than 2 LSB off.
static bool are_points(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n) {
  const exact_point a = to_point(&r->point_a), b = to_point(&r->point_b);
  const bool stands = cast->way_a.x[0] == 0 && cast->way_a.x[1] == 0 && cast->way_a.x[2] == 0;
  for (int i = 0; i < 3; i++) {
    if (a.x[i] - b.x[i] > 1 || b.x[i] - a.x[i] > 1) {
      return refuse(why, n, "the points are apart");
    }
  }
  if (!is_of_shape(&r->point_a, cast->a, &r->rest_a, stands ? 1 : 3)) {
    return refuse(why, n, "the point of A is off");
  }
  return is_of_shape(&r->point_b, cast->b, &r->rest_b, 3) || refuse(why, n, "the point of B is off");
}

static bool is_normal(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n) {
  const bool zero = r->normal.x == 0 && r->normal.y == 0 && r->normal.z == 0;
  if (cast->truth.inside) {
    const bool inner = exact_difference_side(&cast->difference, &nowhere, &nowhere, 0, 1) > 0;
    return zero || !inner || refuse(why, n, "a normal, though they overlap at the start");
  }
  return exact_cast_is_normal(cast->a, cast->b, &cast->truth, &cast->way, &r->normal) || refuse(why, n, "the normal");
}

bool exact_check_cast(const exact_cast *cast, const gjk_cast_result *result, char *why, size_t n) {
  const exact_cast_truth *truth = &cast->truth;
  if (result->hit != truth->hit) {
    return refuse(why, n, "%s", truth->hit ? "a hit is missed" : "a miss is hit");
  }
  if (!truth->hit) {
    return true;
  }
  if (result->inside != truth->inside) {
    return refuse(why, n, "inside: %d", truth->inside);
  }
  if (result->fraction != truth->fraction) {
    return refuse(why, n, "fraction %ld, exactly %ld", (long)result->fraction, (long)truth->fraction);
  }
  return is_normal(cast, result, why, n) && rests(cast, result, why, n) &&
         (result->saturated || truth->inside || are_points(cast, result, why, n));
}
