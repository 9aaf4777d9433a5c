// Judges a cast by its certificate.
//
//   quantity                                     size
//   vertex of A - B, way t                       < 2^33 per axis
//   direction d of a certificate, d x t          < 2^31, 2^65
//   n = (w_1 - w_0) x (w_2 - w_0)                < 2^62
//   n . w, n . t, det(t, w_i, w_j)               < 2^101

#include "cast_claim.h"
#include "gjk/intersect.h"
#include "refuse.h"

typedef struct cast_judge {
  const gjk_collider *a, *b;
  unsigned count_a, count_b;
  exact_point way;
  exact_point w[3];
  unsigned count;
  exact_wide n[3];
  char *why;
  size_t size;
} cast_judge;

static void cross(const exact_wide p[3], const exact_wide q[3], exact_wide out[3]) {
  for (int i = 0; i < 3; i++) {
    const int k = (i + 1) % 3, m = (i + 2) % 3;
    out[i] = p[k] * q[m] - p[m] * q[k];
  }
}

static void widen(const exact_point *p, exact_wide out[3]) {
  for (int i = 0; i < 3; i++) {
    out[i] = p->x[i];
  }
}

static exact_wide dot(const exact_wide n[3], const exact_point *p) {
  return n[0] * p->x[0] + n[1] * p->x[1] + n[2] * p->x[2];
}

// The largest n . w over all of A - B.
static exact_wide reach(const cast_judge *j) {
  exact_wide most = 0, least = 0;
  for (unsigned i = 0; i < j->count_a; i++) {
    const exact_point v = exact_vertex(j->a, i);
    const exact_wide x = dot(j->n, &v);
    most = i == 0 || x > most ? x : most;
  }
  for (unsigned i = 0; i < j->count_b; i++) {
    const exact_point v = exact_vertex(j->b, i);
    const exact_wide x = dot(j->n, &v);
    least = i == 0 || x < least ? x : least;
  }
  return most - least;
}

static bool load(cast_judge *j, const gjk_cast_certificate *certificate) {
  j->count = certificate->count;
  if (j->count > 3) {
    return refuse(j->why, j->size, "%u pairs", j->count);
  }
  for (unsigned i = 0; i < j->count; i++) {
    if (certificate->a[i] >= j->count_a || certificate->b[i] >= j->count_b) {
      return refuse(j->why, j->size, "no vertex pair %u %u", certificate->a[i], certificate->b[i]);
    }
    const exact_point p = exact_vertex(j->a, certificate->a[i]), q = exact_vertex(j->b, certificate->b[i]);
    j->w[i] = exact_subtract(&p, &q);
  }
  return true;
}

// The plane's outward normal: of three pairs their own, else the direction.
static bool set_normal(cast_judge *j, const gjk_cast_certificate *certificate) {
  const gjk_vec3 *d = &certificate->direction;
  if (j->count == 3) {
    const exact_point e = exact_subtract(&j->w[1], &j->w[0]), f = exact_subtract(&j->w[2], &j->w[0]);
    exact_wide p[3], q[3];
    widen(&e, p);
    widen(&f, q);
    cross(p, q, j->n);
  } else {
    j->n[0] = d->x;
    j->n[1] = d->y;
    j->n[2] = d->z;
  }
  return j->count > 0 || refuse(j->why, j->size, "no pairs");
}

// Is the product of the vectors' components zero, and their dot product at most 0? The components are below 2^67.
static bool is_opposite(const exact_wide p[3], const exact_wide q[3]) {
  exact_int sum = exact_from(0);
  for (int i = 0; i < 3; i++) {
    const int k = (i + 1) % 3;
    const exact_int x = exact_from_wide(p[i]), y = exact_from_wide(q[i]), xy = exact_mul(&x, &y);
    sum = exact_add(&sum, &xy);
    if (exact_compare_products(p[i], q[k], p[k], q[i]) != 0) {
      return false;
    }
  }
  return sum.sign <= 0;
}

// Does the line of the way pass through what the pairs span?
static bool passes(const cast_judge *j) {
  exact_wide t[3], w[3][3], turned[3][3];
  widen(&j->way, t);
  for (unsigned i = 0; i < j->count; i++) {
    widen(&j->w[i], w[i]);
    cross(t, w[i], turned[i]);
  }
  if (j->count == 1) {
    return turned[0][0] == 0 && turned[0][1] == 0 && turned[0][2] == 0;
  }
  if (j->count == 2) {
    return is_opposite(turned[0], turned[1]);
  }
  bool left = false, right = false;
  for (unsigned i = 0; i < 3; i++) {
    const exact_wide side = dot(turned[i], &j->w[(i + 1) % 3]);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

static bool is_facet(cast_judge *j, const gjk_cast_result *r) {
  if (!load(j, &r->certificate) || !set_normal(j, &r->certificate)) {
    return false;
  }
  const exact_wide height = dot(j->n, &j->w[0]), speed = dot(j->n, &j->way);
  for (unsigned i = 1; i < j->count; i++) {
    if (dot(j->n, &j->w[i]) != height) {
      return refuse(j->why, j->size, "the pairs are not in the plane");
    }
  }
  if (reach(j) != height) {
    return refuse(j->why, j->size, "a vertex lies beyond the plane");
  }
  if (speed >= 0 || height >= 0 || height < speed) {
    return refuse(j->why, j->size, "the way does not cross the plane");
  }
  if (!passes(j)) {
    return refuse(j->why, j->size, "the way passes beside the pairs");
  }
  const gjk_q30 fraction = exact_fraction_floor(-height, -speed);
  return fraction == r->fraction ||
         refuse(j->why, j->size, "fraction %ld, the plane's is %ld", (long)r->fraction, (long)fraction);
}

// All of A - B lies behind the plane across d x way through the way; (1, 0, 0) stands for a way of 0.
static bool is_beside(cast_judge *j, const gjk_cast_certificate *certificate) {
  const exact_wide d[3] = {certificate->direction.x, certificate->direction.y, certificate->direction.z};
  exact_wide t[3];
  widen(&j->way, t);
  t[0] = t[0] == 0 && t[1] == 0 && t[2] == 0 ? 1 : t[0];
  cross(d, t, j->n);
  return reach(j) < 0 || refuse(j->why, j->size, "the way is not beside");
}

static bool is_short(cast_judge *j, const gjk_cast_certificate *certificate) {
  if (!load(j, certificate) || !set_normal(j, certificate)) {
    return false;
  }
  const exact_wide most = reach(j);
  return (most < 0 && most < dot(j->n, &j->way)) || refuse(j->why, j->size, "the way is not short");
}

// Are the centres more than the radii apart at every point of the way? The nearest point of the way is its start, its
// end, or c . t / t . t of the way, with c from the start to A - B's centre; that squared is (c x t)^2 / t . t.
static bool is_spheres(cast_judge *j) {
  const gjk_vec3 *p = &j->a->centre, *q = &j->b->centre;
  const exact_point c = {{(int64_t)p->x - q->x, (int64_t)p->y - q->y, (int64_t)p->z - q->z}};
  const exact_point ends[2] = {c, exact_subtract(&c, &j->way)};
  exact_feature nearest;
  exact_feature_nearest(ends, 2, &nearest);
  return exact_feature_compare(&nearest, 2 * ((int64_t)j->a->core_radius + j->b->core_radius)) > 0 ||
         refuse(j->why, j->size, "the spheres meet");
}

// The library may find that they meet, as only its proof counts.
static bool is_inside(cast_judge *j, const gjk_cast_result *r) {
  gjk_decision decision;
  if (r->fraction != 0) {
    return refuse(j->why, j->size, "inside, but the fraction is %ld", (long)r->fraction);
  }
  return (gjk_intersect(j->a, j->b, NULL, &decision) == GJK_OK && decision.yes &&
          exact_check_decision(j->a, j->b, 0, &decision, j->why, j->size)) ||
         refuse(j->why, j->size, "not together at the start");
}

bool exact_check_cast_certificate(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                                  const gjk_cast_result *result, char *why, size_t n) {
  cast_judge j = {.a = a, .b = b, .why = why, .size = n};
  exact_cast cast;
  const gjk_cast_certificate *certificate = &result->certificate;
  j.count_a = exact_vertex_count(a);
  j.count_b = exact_vertex_count(b);
  if (j.count_a == 0 || j.count_b == 0 || !exact_cast_is_in_range(a, b, path, &cast)) {
    return refuse(j.why, j.size, "no polytopes, or out of range");
  }
  j.way = cast.way;
  if (result->hit) {
    return result->inside ? certificate->proof == GJK_CAST_PROOF_INSIDE && is_inside(&j, result)
                          : certificate->proof == GJK_CAST_PROOF_FACET && is_facet(&j, result);
  }
  switch (certificate->proof) {
    case GJK_CAST_PROOF_SPHERES: return is_spheres(&j);
    case GJK_CAST_PROOF_BESIDE: return is_beside(&j, certificate);
    case GJK_CAST_PROOF_SHORT: return is_short(&j, certificate);
    default: return refuse(j.why, j.size, "proof %u for a miss", certificate->proof);
  }
}
