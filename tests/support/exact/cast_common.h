// What the judges of casts in space and in the plane have in common: cast_claim.c includes this, and cast2.c under the plane's
// names. to_point makes a point of a vector,
// with z = 0 in the plane; is_zero_unit: is a unit vector none?
#ifndef EXACT_CAST_COMMON_H
#define EXACT_CAST_COMMON_H

#include "refuse.h"

static const exact_point nowhere = {{0, 0, 0}};

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

static bool is_zero(const exact_point *p) {
  return p->x[0] == 0 && p->x[1] == 0 && p->x[2] == 0;
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

static bool rests(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n) {
  const exact_point by_a = way_of(cast->a, &r->rest_a), by_b = way_of(cast->b, &r->rest_b);
  if (cast->truth.inside) {
    return (is_zero(&by_a) && is_zero(&by_b)) || refuse(why, n, "inside: the places of rest are not the start");
  }
  if (!is_near(&cast->truth, cast->a, &cast->way_a, &r->rest_a, 1)) {
    return refuse(why, n, "A's place of rest is an LSB off");
  }
  // A's place is rounded, and B's away from it.
  if (!is_near(&cast->truth, cast->b, &cast->way_b, &r->rest_b, is_zero(&cast->way_a) ? 1 : 2)) {
    return refuse(why, n, "B's place of rest is an LSB off");
  }
  const exact_point at = exact_subtract(&by_b, &by_a);
  return exact_difference_side(&cast->difference, &at, &nowhere, 0, 1) <= 0 ||
         refuse(why, n, "at their places of rest they overlap");
}

// Of shapes that overlap at the start.
static bool is_normal_inside(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n) {
  const bool inner = exact_difference_side(&cast->difference, &nowhere, &nowhere, 0, 1) > 0;
  return is_zero_unit(&r->normal) || !inner || refuse(why, n, "a normal, though they overlap at the start");
}

static bool is_normal(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n);
static bool are_points(const exact_cast *cast, const gjk_cast_result *r, char *why, size_t n);

bool exact_check_cast(const exact_cast *cast, const gjk_cast_result *result, char *why, size_t n) {
  const exact_cast_truth *truth = &cast->truth;
  if (result->hit != truth->hit) {
    return refuse(why, n, "%s", truth->hit ? "a hit is missed" : "a miss is hit");
  }
  if (!truth->hit) {
    return true;
  }
  if (result->inside != truth->inside || result->fraction != truth->fraction) {
    return refuse(why, n, "fraction %ld, exactly %ld%s", (long)result->fraction, (long)truth->fraction,
                  truth->inside ? ", inside" : "");
  }
  return (truth->inside ? is_normal_inside(cast, result, why, n) : is_normal(cast, result, why, n)) &&
         rests(cast, result, why, n) && (result->saturated || truth->inside || are_points(cast, result, why, n));
}

#endif
