// The exact oracle: decisions and distances from their certificates.
#include "exact.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "judge.h"

unsigned exact_vertex_count(const gjk_collider *collider) {
  const gjk_shape_class *type = collider->shape->type;
  if (type == &gjk_class_point) {
    return 1;
  }
  if (type == &gjk_class_segment) {
    return 2;
  }
  if (type == &gjk_class_triangle) {
    return 3;
  }
  if (type == &gjk_class_box) {
    return 8;
  }
  return (type == &gjk_class_hull || type == &gjk_class_table) && collider->buffer != NULL ? collider->shape->count : 0;
}

static void add_multiple(exact_point *p, int factor, const gjk_vec3 *v) {
  p->x[0] += factor * (int64_t)v->x;
  p->x[1] += factor * (int64_t)v->y;
  p->x[2] += factor * (int64_t)v->z;
}

exact_point exact_vertex(const gjk_collider *collider, unsigned number) {
  const gjk_shape_class *type = collider->shape->type;
  exact_point p = {{collider->centre.x, collider->centre.y, collider->centre.z}};
  if (type == &gjk_class_hull || type == &gjk_class_table) {
    add_multiple(&p, 1, &collider->buffer[number]);
  } else if (type == &gjk_class_triangle) {
    add_multiple(&p, 1, &collider->frame[number]);
  } else {
    const unsigned axes = type == &gjk_class_box ? 3 : type == &gjk_class_segment ? 1 : 0;
    for (unsigned i = 0; i < axes; i++) {
      add_multiple(&p, (number >> i & 1u) != 0 ? 1 : -1, &collider->frame[i]);
    }
  }
  return p;
}

static double centre_distance(const gjk_collider *a, const gjk_collider *b) {
  const double x = (double)a->centre.x - b->centre.x, y = (double)a->centre.y - b->centre.y;
  const double z = (double)a->centre.z - b->centre.z;
  return sqrt(x * x + y * y + z * z);
}

// In integers: a square root in double rounds to 2^30 for what is a little more.
bool exact_is_far(const gjk_collider *a, const gjk_collider *b) {
  const exact_int x = exact_from((int64_t)a->centre.x - b->centre.x), xx = exact_mul(&x, &x);
  const exact_int y = exact_from((int64_t)a->centre.y - b->centre.y), yy = exact_mul(&y, &y);
  const exact_int z = exact_from((int64_t)a->centre.z - b->centre.z), zz = exact_mul(&z, &z);
  const exact_int level = exact_add(&xx, &yy), squared = exact_add(&level, &zz);
  const exact_int limit = exact_from(INT64_C(1) << 60);
  return exact_compare(&squared, &limit) > 0;
}

bool judge_refuse(judge *j, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(j->why, j->size, format, arguments);
  va_end(arguments);
  return false;
}

bool judge_start(judge *j, const gjk_collider *a, const gjk_collider *b, int64_t distance, char *why, size_t n) {
  j->a = a;
  j->b = b;
  j->count_a = exact_vertex_count(a);
  j->count_b = exact_vertex_count(b);
  j->radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + distance;
  j->why = why;
  j->size = n;
  j->far = exact_is_far(a, b);
  j->decision_slack = 0;
  j->point_slack = 0;
  if (j->far) {  // of the smallest gap that the centres allow: that of a far pair exceeds 2^29
    j->decision_slack = (int64_t)ldexp(centre_distance(a, b), -28);
    j->point_slack = (int64_t)ldexp(centre_distance(a, b) - (double)a->radius - (double)b->radius, -27);
  }
  return j->count_a != 0 && j->count_b != 0 ? true : judge_refuse(j, "not a polytope");
}

bool judge_load(judge *j, const gjk_certificate *certificate, unsigned most) {
  j->count = certificate->count;
  if (j->count < 1 || j->count > most) {
    return judge_refuse(j, "%u pairs", j->count);
  }
  for (unsigned i = 0; i < j->count; i++) {
    if (certificate->a[i] >= j->count_a || certificate->b[i] >= j->count_b) {
      return judge_refuse(j, "no vertex pair %u %u", certificate->a[i], certificate->b[i]);
    }
    j->at_a[i] = exact_vertex(j->a, certificate->a[i]);
    j->at_b[i] = exact_vertex(j->b, certificate->b[i]);
    j->w[i] = exact_subtract(&j->at_a[i], &j->at_b[i]);
  }
  return true;
}

// Doubles settle most vertices. With p within 2^-51 of itself, the products and sums in double are off by less than
// 2^-49 of the sum of their sizes.
bool judge_none_before(const gjk_collider *c, unsigned count, const exact_point *base, const exact_vector *direction,
                       int sign) {
  const double p[3] = {exact_to_double(&direction->x[0]), exact_to_double(&direction->x[1]),
                       exact_to_double(&direction->x[2])};
  for (unsigned i = 0; i < count; i++) {
    const exact_point vertex = exact_vertex(c, i), u = exact_subtract(&vertex, base);
    const double x = p[0] * (double)u.x[0], y = p[1] * (double)u.x[1], z = p[2] * (double)u.x[2];
    const double along = x + y + z, error = ldexp(fabs(x) + fabs(y) + fabs(z), -49);
    const int side = along > error ? 1 : along < -error ? -1 : exact_dot(direction, &u).sign;
    if (side * sign < 0) {
      return false;
    }
  }
  return true;
}

bool judge_nearest(judge *j, const gjk_certificate *certificate) {
  if (!judge_load(j, certificate, 3)) {
    return false;
  }
  if (!exact_feature_make(j->w, j->count, &j->feature)) {
    return judge_refuse(j, "the feature is flat");
  }
  if (!exact_feature_contains(&j->feature, j->count, true)) {
    return judge_refuse(j, "the feature's nearest point is not inside it");
  }
  if (!judge_none_before(j->a, j->count_a, &j->at_a[0], &j->feature.point, 1)) {
    return judge_refuse(j, "a vertex of A lies nearer");
  }
  return judge_none_before(j->b, j->count_b, &j->at_b[0], &j->feature.point, -1) ||
         judge_refuse(j, "a vertex of B lies nearer");
}

// Is the feature's point farther from the origin than the radius?
static bool is_beyond(judge *j) {
  return exact_feature_compare(&j->feature, 2 * j->radius) > 0 || judge_refuse(j, "it comes within the radius");
}

static bool is_enclosing(judge *j, const gjk_certificate *certificate) {
  return judge_load(j, certificate, 4) &&
         (exact_encloses(j->w, j->count) || judge_refuse(j, "the pairs do not hold the origin"));
}

static bool is_near(judge *j, const gjk_certificate *certificate) {
  if (!judge_load(j, certificate, 3)) {
    return false;
  }
  exact_feature_nearest(j->w, j->count, &j->feature);
  return exact_feature_compare(&j->feature, 2 * (j->radius + j->decision_slack)) <= 0 ||
         judge_refuse(j, "the feature is farther than the radius");
}

// The largest sign * direction . vertex, in the world.
static exact_int farthest(const gjk_collider *c, unsigned count, const exact_vector *direction, int sign) {
  exact_int largest = exact_from(0);
  for (unsigned i = 0; i < count; i++) {
    const exact_point vertex = exact_vertex(c, i);
    exact_int along = exact_dot(direction, &vertex);
    along.sign *= sign;
    if (i == 0 || exact_compare(&along, &largest) > 0) {
      largest = along;
    }
  }
  return largest;
}

bool judge_clears(const judge *j, const exact_vector *direction, int64_t radius) {
  return judge_clears_fine(j, direction, JUDGE_FINE * radius);
}

bool judge_clears_fine(const judge *j, const exact_vector *direction, int64_t radius) {
  const exact_int from_a = farthest(j->a, j->count_a, direction, 1), from_b = farthest(j->b, j->count_b, direction, -1);
  const exact_int lsb = exact_add(&from_a, &from_b), fine = exact_from(JUDGE_FINE);
  const exact_int along = exact_mul(&lsb, &fine), r = exact_from(radius);
  exact_int length = exact_from(0);
  for (int i = 0; i < 3; i++) {
    const exact_int square = exact_mul(&direction->x[i], &direction->x[i]);
    length = exact_add(&length, &square);
  }
  const exact_int r_squared = exact_mul(&r, &r), asked = exact_mul(&r_squared, &length);
  const exact_int squared = exact_mul(&along, &along);
  return along.sign < 0 && exact_compare(&squared, &asked) > 0;
}

static bool is_separating(judge *j, const gjk_vec3 *d) {
  const exact_vector direction = {{exact_from(d->x), exact_from(d->y), exact_from(d->z)}};
  const int64_t radius = j->radius > j->decision_slack ? j->radius - j->decision_slack : 0;
  return judge_clears(j, &direction, radius) || judge_refuse(j, "the direction does not separate");
}

static bool is_bounded(const gjk_collider *c, unsigned count) {
  const int64_t limit = c->core_radius;
  const exact_point centre = {{c->centre.x, c->centre.y, c->centre.z}};
  for (unsigned i = 0; i < count; i++) {
    const exact_point vertex = exact_vertex(c, i), u = exact_subtract(&vertex, &centre);
    if (u.x[0] * u.x[0] + u.x[1] * u.x[1] + u.x[2] * u.x[2] > limit * limit) {  // at most 3 2^60
      return false;
    }
  }
  return c->radius - c->core_radius == c->shape->convex_radius;
}

// Are spheres around the centres that hold the shapes farther apart than the asked distance?
static bool is_spheres(judge *j) {
  const gjk_vec3 *p = &j->a->centre, *q = &j->b->centre;
  const exact_point apart = {{(int64_t)p->x - q->x, (int64_t)p->y - q->y, (int64_t)p->z - q->z}};
  exact_feature feature;
  exact_feature_make(&apart, 1, &feature);
  if (!is_bounded(j->a, j->count_a) || !is_bounded(j->b, j->count_b)) {
    return judge_refuse(j, "a vertex lies outside of the bounding sphere");
  }
  const int64_t reach = j->radius + j->a->core_radius + j->b->core_radius;
  return exact_feature_compare(&feature, 2 * reach) > 0 || judge_refuse(j, "the bounding spheres are not apart");
}

static bool is_apart(judge *j, const gjk_certificate *certificate) {
  switch (certificate->proof) {
    case GJK_PROOF_SPHERES: return is_spheres(j);
    case GJK_PROOF_DIRECTION: return is_separating(j, &certificate->direction);
    case GJK_PROOF_NEAREST:
      return j->far ? judge_far_apart(j, certificate) : judge_nearest(j, certificate) && is_beyond(j);
    default: return judge_refuse(j, "proof %u for apart", certificate->proof);
  }
}

static bool is_together(judge *j, const gjk_certificate *certificate) {
  switch (certificate->proof) {
    case GJK_PROOF_NEAR: return is_near(j, certificate);
    case GJK_PROOF_ENCLOSING: return is_enclosing(j, certificate);
    default: return judge_refuse(j, "proof %u for together", certificate->proof);
  }
}

bool exact_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, const gjk_decision *decision,
                          char *why, size_t n) {
  judge j;
  return judge_start(&j, a, b, distance, why, n) &&
         (decision->yes ? is_together(&j, &decision->certificate) : is_apart(&j, &decision->certificate));
}

// Rounded correctly: 2 D - 1 <= 2 (distance of the cores - radius) < 2 D + 1; the left part only if D > 0.
static bool is_rounded(judge *j, int64_t distance) {
  const int64_t twice = 2 * (distance + j->radius);
  if (distance > 0 && exact_feature_compare(&j->feature, twice - 1) < 0) {
    return judge_refuse(j, "the distance is too large");
  }
  return exact_feature_compare(&j->feature, twice + 1) < 0 || judge_refuse(j, "the distance is too small");
}

bool exact_check_gap(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                     size_t n) {
  judge j;
  if (!judge_start(&j, a, b, 0, why, n)) {
    return false;
  }
  if (result->lower != result->distance || result->upper != result->distance || result->distance < 0) {
    return judge_refuse(&j, "bounds differ from the distance");
  }
  if (result->intersecting) {
    return (result->distance == 0 || judge_refuse(&j, "a distance above 0")) && is_together(&j, &result->certificate);
  }
  if (result->certificate.proof != GJK_PROOF_NEAREST) {
    return judge_refuse(&j, "proof %u for a distance", result->certificate.proof);
  }
  return is_apart(&j, &result->certificate) &&
         (j.far ? judge_far_distance(&j, result) : is_rounded(&j, result->distance));
}

bool exact_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                          size_t n) {
  return exact_check_gap(a, b, result, why, n) && exact_check_points(a, b, result, why, n);
}

bool exact_named_feature(const gjk_collider *a, const gjk_collider *b, const gjk_certificate *certificate,
                         exact_feature *out) {
  judge j;
  char why[64];
  return judge_start(&j, a, b, 0, why, sizeof why) && judge_load(&j, certificate, 3) &&
         exact_feature_make(j.w, j.count, out);
}
