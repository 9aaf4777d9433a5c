// The exact oracle: witness points and normals, and pairs that are far apart.
#include <math.h>

#include "judge.h"

exact_vector judge_opposite(const exact_vector *v) {
  const exact_vector negated = {{exact_negate(v->x[0]), exact_negate(v->x[1]), exact_negate(v->x[2])}};
  return negated;
}

// The vertices of a far pair are rounded, so they may name a neighbour of the nearest feature. The distance of what
// they span is an upper bound.
bool judge_far_apart(judge *j, const gjk_certificate *certificate) {
  if (!judge_load(j, certificate, 3)) {
    return false;
  }
  exact_feature_nearest(j->w, j->count, &j->feature);
  const exact_vector direction = judge_opposite(&j->feature.point);
  return judge_clears(j, &direction, j->radius > j->decision_slack ? j->radius - j->decision_slack : 0) ||
         judge_refuse(j, "far: the feature does not separate");
}

// With d the reported distance and g the gap: d - g <= g / 2^28 if g >= d - d / (2^28 + 1), and g - d <= g / 2^28 if g
// <= d + d / (2^28 - 1). Bounds are rounded inwards to parts of an LSB.
bool judge_far_distance(judge *j, const gjk_distance_result *result) {
  const int64_t d = JUDGE_FINE * (int64_t)result->distance, radius = JUDGE_FINE * j->radius;
  const int64_t least = radius + d - d / ((INT64_C(1) << 28) + 1), most = radius + d + d / ((INT64_C(1) << 28) - 1);
  const exact_vector direction = judge_opposite(&j->feature.point);
  if (!judge_clears_fine(j, &direction, least)) {
    return judge_refuse(j, "far: the distance is too large");
  }
  const exact_int m = exact_from(most), fine = exact_from(JUDGE_FINE), unit = exact_mul(&fine, &fine);
  const exact_int squared = exact_mul(&m, &m), limit = exact_mul(&squared, &j->feature.denominator);
  const exact_int mine = exact_mul(&unit, &j->feature.squared);
  const bool cut = result->saturated && result->distance == GJK_DISTANCE_MAX;
  return cut || exact_compare(&mine, &limit) <= 0 || judge_refuse(j, "far: the distance is too small");
}

static exact_point from_vec3(const gjk_vec3 *v) {
  const exact_point p = {{v->x, v->y, v->z}};
  return p;
}

// The normal of a far pair comes from rounded vertices. It is right if the distance along it is.
static bool is_far_normal(judge *j, const gjk_distance_result *result) {
  const gjk_unit3 *n = &result->normal;
  const exact_vector direction = {{exact_from(n->x), exact_from(n->y), exact_from(n->z)}};
  return judge_clears(j, &direction, result->distance + j->radius - j->point_slack) ||
         judge_refuse(j, "far: the distance along the normal is less");
}

bool judge_at(const exact_point *point, const exact_point *vertices, unsigned count, int64_t limit) {
  exact_point relative[3];
  exact_feature feature;
  for (unsigned i = 0; i < count; i++) {
    relative[i] = exact_subtract(&vertices[i], point);
  }
  exact_feature_nearest(relative, count, &feature);
  return exact_feature_compare(&feature, 2 * limit) <= 0;
}

// The lengths here are below 2^34 and known to 2^-49 of themselves.
static bool is_gap(judge *j, const exact_point *a, const exact_point *b) {
  const exact_point between = exact_subtract(a, b);
  exact_feature feature;
  exact_feature_make(&between, 1, &feature);
  const double gap = sqrt(exact_to_double(&feature.squared));
  const double distance =
      sqrt(exact_to_double(&j->feature.squared) / exact_to_double(&j->feature.denominator)) - (double)j->radius;
  return fabs(gap - distance) <= (double)(2 + j->point_slack) + 1e-4 ||
         judge_refuse(j, "points %.4f apart, distance %.4f", gap, distance);
}

bool judge_normal(judge *j, const exact_vector *direction, const gjk_unit3 *normal) {
  const double n[3] = {normal->x, normal->y, normal->z};
  double p[3], length = 0, off = 0;
  for (int i = 0; i < 3; i++) {
    p[i] = exact_to_double(&direction->x[i]);
    length += p[i] * p[i];
    if (direction->x[i].sign == 0 ? n[i] != 0 : direction->x[i].sign * n[i] < 0) {
      return judge_refuse(j, "a component of the normal has another sign");
    }
  }
  for (int i = 0; i < 3; i++) {
    const double difference = n[i] - p[i] / sqrt(length) * 1073741824.0;
    off += difference * difference;
  }
  // 2^-28 is 4 in Q2.30.
  return sqrt(off) <= 4 || judge_refuse(j, "the normal is off by %.3f 2^-30", sqrt(off));
}

bool judge_is_cut(const gjk_vec3 *v) {
  return v->x == INT32_MAX || v->x == INT32_MIN || v->y == INT32_MAX || v->y == INT32_MIN || v->z == INT32_MAX ||
         v->z == INT32_MIN;
}

bool exact_check_points(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                        size_t n) {
  judge j;
  if (result->intersecting) {
    return true;
  }
  if (!judge_start(&j, a, b, 0, why, n) || !judge_load(&j, &result->certificate, 3)) {
    return false;
  }
  exact_feature_nearest(j.w, j.count, &j.feature);
  const exact_vector direction = judge_opposite(&j.feature.point);
  if (j.far ? !is_far_normal(&j, result) : !judge_normal(&j, &direction, &result->normal)) {
    return false;
  }
  if (result->saturated) {
    return result->distance == GJK_DISTANCE_MAX || judge_is_cut(&result->point_a) || judge_is_cut(&result->point_b) ||
           judge_refuse(&j, "saturated without a reason");
  }
  const exact_point at_a = from_vec3(&result->point_a), at_b = from_vec3(&result->point_b);
  if (!judge_at(&at_a, j.at_a, j.count, a->shape->convex_radius + 1 + j.point_slack)) {
    return judge_refuse(&j, "the point of A is off");
  }
  if (!judge_at(&at_b, j.at_b, j.count, b->shape->convex_radius + 1 + j.point_slack)) {
    return judge_refuse(&j, "the point of B is off");
  }
  return is_gap(&j, &at_a, &at_b);
}
