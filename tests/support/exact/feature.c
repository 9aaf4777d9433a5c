// Exact geometry of points, segments, triangles and tetrahedra against the origin.
#include "feature.h"

exact_point exact_subtract(const exact_point *a, const exact_point *b) {
  exact_point difference;
  for (int i = 0; i < 3; i++) {
    difference.x[i] = a->x[i] - b->x[i];
  }
  return difference;
}

static exact_vector from_point(const exact_point *a) {
  exact_vector v;
  for (int i = 0; i < 3; i++) {
    v.x[i] = exact_from(a->x[i]);
  }
  return v;
}

// p q - r s.
static exact_int cross_term(int64_t p, int64_t q, int64_t r, int64_t s) {
  const exact_int a = exact_from(p), b = exact_from(q), c = exact_from(r), d = exact_from(s);
  const exact_int ab = exact_mul(&a, &b), cd = exact_mul(&c, &d);
  return exact_sub(&ab, &cd);
}

exact_vector exact_cross(const exact_point *a, const exact_point *b) {
  exact_vector v;
  v.x[0] = cross_term(a->x[1], b->x[2], a->x[2], b->x[1]);
  v.x[1] = cross_term(a->x[2], b->x[0], a->x[0], b->x[2]);
  v.x[2] = cross_term(a->x[0], b->x[1], a->x[1], b->x[0]);
  return v;
}

static exact_int dot(const exact_vector *a, const exact_vector *b) {
  exact_int sum = exact_mul(&a->x[0], &b->x[0]);
  for (int i = 1; i < 3; i++) {
    const exact_int term = exact_mul(&a->x[i], &b->x[i]);
    sum = exact_add(&sum, &term);
  }
  return sum;
}

exact_int exact_dot(const exact_vector *a, const exact_point *b) {
  const exact_vector v = from_point(b);
  return dot(a, &v);
}

static exact_int dot_points(const exact_point *a, const exact_point *b) {
  const exact_vector v = from_point(a);
  return exact_dot(&v, b);
}

static void weigh_segment(const exact_point *points, exact_feature *out) {
  const exact_point e = exact_subtract(&points[1], &points[0]);
  out->denominator = dot_points(&e, &e);
  out->weight[0] = dot_points(&points[1], &e);
  out->weight[1] = exact_negate(dot_points(&points[0], &e));
}

// Along the normal n the origin spans with each edge the area n . (p x q) / 2, the weight of the opposite corner.
static void weigh_triangle(const exact_point *points, exact_feature *out) {
  const exact_point e = exact_subtract(&points[1], &points[0]), f = exact_subtract(&points[2], &points[0]);
  const exact_vector n = exact_cross(&e, &f);
  out->denominator = dot(&n, &n);
  for (int i = 0; i < 3; i++) {
    const exact_vector opposite = exact_cross(&points[(i + 1) % 3], &points[(i + 2) % 3]);
    out->weight[i] = dot(&n, &opposite);
  }
}

bool exact_feature_make(const exact_point *points, unsigned count, exact_feature *out) {
  switch (count) {
    case 1: out->denominator = out->weight[0] = exact_from(1); break;
    case 2: weigh_segment(points, out); break;
    case 3: weigh_triangle(points, out); break;
    default: return false;
  }
  for (int i = 0; i < 3; i++) {
    out->point.x[i] = exact_from(0);
    for (unsigned k = 0; k < count; k++) {
      const exact_int x = exact_from(points[k].x[i]), term = exact_mul(&out->weight[k], &x);
      out->point.x[i] = exact_add(&out->point.x[i], &term);
    }
  }
  // The nearest point p of a line or plane is at right angles to it, so p . p = p . q for each point q of it.
  out->squared = exact_dot(&out->point, &points[0]);
  return out->denominator.sign > 0;
}

bool exact_feature_contains(const exact_feature *feature, unsigned count, bool inside) {
  for (unsigned i = 0; i < count; i++) {
    if (feature->weight[i].sign < (inside ? 1 : 0)) {
      return false;
    }
  }
  return true;
}

// Takes the points whose bits are set in mask. Returns their number.
static unsigned choose(const exact_point *points, unsigned count, unsigned mask, exact_point *chosen) {
  unsigned n = 0;
  for (unsigned i = 0; i < count; i++) {
    if ((mask >> i & 1u) != 0) {
      chosen[n++] = points[i];
    }
  }
  return n;
}

int exact_feature_order(const exact_feature *a, const exact_feature *b) {
  const exact_int first = exact_mul(&a->squared, &b->denominator), second = exact_mul(&b->squared, &a->denominator);
  return exact_compare(&first, &second);
}

void exact_feature_nearest(const exact_point *points, unsigned count, exact_feature *out) {
  bool found = false;
  for (unsigned mask = (1u << count) - 1; mask > 0; mask--) {
    exact_point chosen[3] = {{{0, 0, 0}}};
    exact_feature feature;
    const unsigned n = choose(points, count, mask, chosen);
    if (!exact_feature_make(chosen, n, &feature) || !exact_feature_contains(&feature, n, false)) {
      continue;
    }
    if (!found || exact_feature_order(&feature, out) < 0) {
      *out = feature;
      found = true;
    }
    if (n == count) {  // the nearest point of the whole plane or line is as near as any part of it
      return;
    }
  }
}

static int determinant_sign(const exact_point *a, const exact_point *b, const exact_point *c) {
  const exact_vector n = exact_cross(a, b);
  return exact_dot(&n, c).sign;
}

// The origin is inside if all four faces turn the same way as seen from it. If the tetrahedron is flat, its faces tell.
static bool tetrahedron_encloses(const exact_point *p) {
  const exact_point e = exact_subtract(&p[1], &p[0]), f = exact_subtract(&p[2], &p[0]);
  const exact_point g = exact_subtract(&p[3], &p[0]);
  const int side = determinant_sign(&e, &f, &g);
  const int seen[4] = {determinant_sign(&p[1], &p[2], &p[3]), -determinant_sign(&p[0], &p[2], &p[3]),
                       determinant_sign(&p[0], &p[1], &p[3]), -determinant_sign(&p[0], &p[1], &p[2])};
  for (int i = 0; i < 4; i++) {
    if (seen[i] * side < 0) {
      return false;
    }
  }
  return side != 0;
}

bool exact_encloses(const exact_point *points, unsigned count) {
  if (count == 4 && tetrahedron_encloses(points)) {
    return true;
  }
  for (unsigned mask = 1; mask < 1u << count; mask++) {
    exact_point chosen[4] = {{{0, 0, 0}}};
    exact_feature feature;
    const unsigned n = choose(points, count, mask, chosen);
    if (n < 4 && exact_feature_make(chosen, n, &feature) && feature.squared.sign == 0 &&
        exact_feature_contains(&feature, n, false)) {
      return true;
    }
  }
  return false;
}

int exact_feature_compare(const exact_feature *feature, int64_t half) {
  const exact_int four = exact_from(4), h = exact_from(half), squared = exact_mul(&h, &h);
  const exact_int mine = exact_mul(&four, &feature->squared), other = exact_mul(&squared, &feature->denominator);
  return exact_compare(&mine, &other);
}
