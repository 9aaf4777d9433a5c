// Judges what gjk_cast says of polytopes.
#include "cast_claim.h"

static exact_point to_point(const gjk_vec3 *v) {
  const exact_point p = {{v->x, v->y, v->z}};
  return p;
}

static bool is_zero_unit(const gjk_unit3 *v) {
  return v->x == 0 && v->y == 0 && v->z == 0;
}

#include "cast_common.h"

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
  const bool stands = is_zero(&cast->way_a);
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
  return exact_cast_is_normal(cast->a, cast->b, &cast->truth, &cast->way, &r->normal) || refuse(why, n, "the normal");
}
