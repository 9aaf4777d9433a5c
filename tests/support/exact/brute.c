// Brute force over all simplices of a small Minkowski difference.
#include <assert.h>

#include "exact.h"

typedef struct search {
  exact_point w[EXACT_BRUTE_MAX];
  unsigned count;
  bool found;
  exact_truth *out;
} search;

static void try_feature(search *s, const exact_point *points, unsigned count) {
  exact_feature feature;
  if (exact_feature_make(points, count, &feature) && exact_feature_contains(&feature, count, false) &&
      (!s->found || exact_feature_order(&feature, &s->out->nearest) < 0)) {
    s->out->nearest = feature;
    s->found = true;
  }
}

// Tries all simplices of one to three points. If the origin is outside of the hull, the nearest point of the hull is in
// one of them.
static void try_features(search *s) {
  exact_point p[3];
  for (unsigned i = 0; i < s->count; i++) {
    p[0] = s->w[i];
    try_feature(s, p, 1);
    for (unsigned k = 0; k < i; k++) {
      p[1] = s->w[k];
      try_feature(s, p, 2);
      for (unsigned l = 0; l < k; l++) {
        p[2] = s->w[l];
        try_feature(s, p, 3);
      }
    }
  }
}

// The origin is outside exactly if the plane across the nearest point of the surface has all points behind it.
static bool is_outside(const search *s) {
  const exact_feature *f = &s->out->nearest;
  for (unsigned i = 0; i < s->count; i++) {
    const exact_int along = exact_dot(&f->point, &s->w[i]);
    if (exact_compare(&along, &f->squared) < 0) {
      return false;
    }
  }
  return f->squared.sign > 0;
}

static void begin(search *s, exact_truth *out) {
  s->count = 0;
  s->found = false;
  s->out = out;
}

static void add_vertices(search *s, const gjk_collider *a, const gjk_collider *b, const exact_point *moved) {
  for (unsigned i = 0; i < exact_vertex_count(a); i++) {
    for (unsigned k = 0; k < exact_vertex_count(b); k++) {
      const exact_point at_a = exact_vertex(a, i), at_b = exact_vertex(b, k), w = exact_subtract(&at_a, &at_b);
      assert(s->count < EXACT_BRUTE_MAX);
      s->w[s->count++] = exact_subtract(&w, moved);
    }
  }
}

static const exact_point nowhere = {{0, 0, 0}};

void exact_brute(const gjk_collider *a, const gjk_collider *b, exact_truth *out) {
  search s;
  begin(&s, out);
  add_vertices(&s, a, b, &nowhere);
  assert(s.count > 0);
  try_features(&s);
  out->enclosing = !is_outside(&s);
}

void exact_brute_way(const gjk_collider *a, const gjk_collider *b, const exact_point *way, exact_truth *out) {
  search s;
  begin(&s, out);
  add_vertices(&s, a, b, &nowhere);
  add_vertices(&s, a, b, way);
  assert(s.count > 0);
  try_features(&s);
  out->enclosing = !is_outside(&s);
}

bool exact_truth_within(const exact_truth *truth, const gjk_collider *a, const gjk_collider *b, gjk_q16 distance) {
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + distance;
  return truth->enclosing || exact_feature_compare(&truth->nearest, 2 * radius) <= 0;
}

int64_t exact_truth_distance(const exact_truth *truth, const gjk_collider *a, const gjk_collider *b) {
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  int64_t low = 0, high = INT64_C(1) << 34;
  if (exact_truth_within(truth, a, b, 0)) {
    return 0;
  }
  while (low < high) {  // the smallest distance that is at least the gap less half
    const int64_t middle = (low + high) / 2;
    if (exact_feature_compare(&truth->nearest, 2 * (middle + radius) + 1) >= 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
