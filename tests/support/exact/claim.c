// The exact oracle: judges claims by brute force.
#include "claim.h"

#include <math.h>
#include <stdio.h>

#include "depth.h"
#include "judge.h"

void exact_claims_open(const gjk_collider *a, const gjk_collider *b, char *why, size_t size, exact_claims *out) {
  out->a = a;
  out->b = b;
  out->why = why;
  out->size = size;
  exact_brute(a, b, &out->truth);
}

static bool refuse(const exact_claims *c, const char *what) {
  snprintf(c->why, c->size, "%s", what);
  return false;
}

bool exact_claims_decision(const exact_claims *c, gjk_q16 distance, const gjk_decision *decision) {
  return exact_truth_within(&c->truth, c->a, c->b, distance) == decision->yes || refuse(c, "yes");
}

// Is the point within 1 LSB of the shape?
static bool is_of_shape(const gjk_vec3 *point, const gjk_collider *shape) {
  static const gjk_shape point_shape = GJK_POINT;
  gjk_collider at = {0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  exact_truth truth;
  pose.position = *point;
  if (gjk_collider_init(&at, &point_shape, NULL, 0) != GJK_OK || gjk_collider_pose(&at, &pose) != GJK_OK) {
    return false;
  }
  exact_brute(shape, &at, &truth);
  return exact_truth_within(&truth, shape, &at, 1);
}

static bool are_of_shapes(const exact_claims *c, const gjk_vec3 *a, const gjk_vec3 *b) {
  return (is_of_shape(a, c->a) || refuse(c, "point_a")) && (is_of_shape(b, c->b) || refuse(c, "point_b"));
}

static double norm(double x, double y, double z) {
  return sqrt(x * x + y * y + z * z);
}

bool exact_claims_distance(const exact_claims *c, const gjk_distance_result *r) {
  const bool together = exact_truth_within(&c->truth, c->a, c->b, 0);
  if (r->intersecting != together) {
    return refuse(c, "intersecting");
  }
  if (r->distance != exact_truth_distance(&c->truth, c->a, c->b)) {
    return refuse(c, "distance");
  }
  if (r->lower != r->distance || r->upper != r->distance || r->saturated) {
    return refuse(c, r->saturated ? "saturated" : "bounds");
  }
  if (together) {
    return true;
  }
  judge j = {0};
  j.why = c->why;
  j.size = c->size;
  const exact_vector direction = judge_opposite(&c->truth.nearest.point);
  const gjk_vec3 *a = &r->point_a, *b = &r->point_b;
  const double gap = norm((double)b->x - a->x, (double)b->y - a->y, (double)b->z - a->z),
               distance =
                   sqrt(exact_to_double(&c->truth.nearest.squared) / exact_to_double(&c->truth.nearest.denominator)) -
                   c->a->shape->convex_radius - c->b->shape->convex_radius;
  return judge_normal(&j, &direction, &r->normal) && are_of_shapes(c, a, b) &&
         (fabs(gap - distance) <= 2.0001 || refuse(c, "the points' distance"));
}

// How far A - B, convex radii included, reaches along the normal; within 2^-20 for shapes below 2^30 LSB.
static long double reach_along(const exact_claims *c, const gjk_unit3 *n) {
  long double most[2] = {-1e30L, -1e30L};
  const gjk_collider *const shape[2] = {c->a, c->b};
  for (int k = 0; k < 2; k++) {
    for (unsigned i = 0; i < exact_vertex_count(shape[k]); i++) {
      const exact_point p = exact_vertex(shape[k], i);
      const long double along =
          ((long double)p.x[0] * n->x + (long double)p.x[1] * n->y + (long double)p.x[2] * n->z) * (k == 0 ? 1 : -1);
      most[k] = along > most[k] ? along : most[k];
    }
  }
  return (most[0] + most[1]) / GJK_Q30_ONE + c->a->shape->convex_radius + c->b->shape->convex_radius;
}

// Do the shapes no longer overlap when B has moved?
static bool is_parted(const exact_claims *c, const gjk_penetration_result *r) {
  const exact_point t = exact_move(r);
  const gjk_vec3 *at = &c->b->position;
  const gjk_vec3 to = {at->x + (gjk_q16)t.x[0], at->y + (gjk_q16)t.x[1], at->z + (gjk_q16)t.x[2]};
  const int64_t radius = (int64_t)c->a->shape->convex_radius + c->b->shape->convex_radius;
  gjk_collider moved = *c->b;
  exact_truth truth;
  exact_plane plane;
  if (gjk_collider_move(&moved, &to) != GJK_OK) {
    return false;
  }
  exact_brute(c->a, &moved, &truth);
  if (truth.enclosing) {
    return radius == 0 && exact_depth(c->a, &moved, &plane) && exact_plane_compare(&plane, 0) == 0;
  }
  return exact_feature_compare(&truth.nearest, 2 * radius) >= 0;
}

bool exact_claims_penetration(const exact_claims *c, const gjk_penetration_result *r) {
  if (r->intersecting != exact_truth_within(&c->truth, c->a, c->b, 0)) {
    return refuse(c, "intersecting");
  }
  if (!r->intersecting) {
    return true;
  }
  if (r->depth < 0 || r->lower != r->depth || r->upper != r->depth) {
    return refuse(c, "bounds");
  }
  const gjk_unit3 *n = &r->normal;
  if (fabs(norm(n->x, n->y, n->z) - GJK_Q30_ONE) > 4.0001) {
    return refuse(c, "normal: its length");
  }
  // Slack: the normal is off by 2^-28, and A - B is at most so long.
  const long double size = (long double)c->a->radius + c->b->radius;
  const long double slack = 2 * size / (1 << 28) + 0.0001L, reach = reach_along(c, n);
  if (reach > r->depth + slack || reach < r->depth - 1 - slack) {
    return refuse(c, "depth along the normal");
  }
  const gjk_vec3 *a = &r->point_a, *b = &r->point_b;
  const double depth = (double)r->depth / GJK_Q30_ONE;
  const double off =
      norm((double)a->x - b->x - depth * n->x, (double)a->y - b->y - depth * n->y, (double)a->z - b->z - depth * n->z);
  return (off <= 3.0001 + 4 * depth || refuse(c, "the points do not meet")) && are_of_shapes(c, a, b) &&
         (is_parted(c, r) || refuse(c, "the move"));
}
