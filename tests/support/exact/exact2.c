// Decides and measures pairs of the plane by trying everything.
//
//   1. The hull of each shape's points: Andrew's monotone chain.
//   2. Do the cores meet? They do not, if and only if a direction parts them: the normal of an edge of A or of B; where
//      both are flat, also along it.
//   3. Apart: each corner of one core against each edge of the other.
//   4. Meeting: each edge of A and of B is one of A - B. The depth is the least height of its line above the origin.
//
// What fits in 128 bits, for points at most 2^33 apart in all and 2^29 in one shape:
//   edge . difference, edge x difference   < 2^64
//   its square, times 4                    < 2^128, unsigned
//   (2 d + 1)^2 edge^2                     < 2^70 2^58 for d < 2^34
#include "exact2.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

__extension__ typedef __int128 wide;

static exact2_point minus(exact2_point a, exact2_point b) {
  const exact2_point out = {a.x - b.x, a.y - b.y};
  return out;
}

static wide dot(exact2_point a, exact2_point b) {
  return (wide)a.x * b.x + (wide)a.y * b.y;
}

static wide cross(exact2_point a, exact2_point b) {
  return (wide)a.x * b.y - (wide)a.y * b.x;
}

// Step 1.

static int compare_points(const void *left, const void *right) {
  const exact2_point *a = left, *b = right;
  return a->x != b->x ? (a->x < b->x ? -1 : 1) : (a->y > b->y) - (a->y < b->y);
}

// Adds a point to a chain that turns left, the first of whose points stands at index from.
static void add_to_chain(exact2_hull *hull, unsigned from, exact2_point p) {
  while (hull->count >= from + 2) {
    const exact2_point last = hull->vertex[hull->count - 1], before = hull->vertex[hull->count - 2];
    if (cross(minus(last, before), minus(p, last)) > 0) {
      break;
    }
    hull->count--;
  }
  assert(hull->count < EXACT2_VERTICES_MAX);
  hull->vertex[hull->count++] = p;
}

void exact2_hull_find(const exact2_point *point, unsigned count, exact2_hull *out) {
  exact2_point *sorted = malloc(count * sizeof *sorted);
  assert(sorted != NULL && count > 0);
  unsigned n = 0;
  for (unsigned i = 0; i < count; i++) {
    sorted[i] = point[i];
  }
  qsort(sorted, count, sizeof *sorted, compare_points);
  for (unsigned i = 0; i < count; i++) {
    if (n == 0 || compare_points(&sorted[n - 1], &sorted[i]) != 0) {
      sorted[n++] = sorted[i];
    }
  }
  out->count = 0;
  for (unsigned i = 0; i < n; i++) {  // below, from left to right
    add_to_chain(out, 0, sorted[i]);
  }
  const unsigned turn = out->count - 1;
  for (unsigned i = n - 1; i-- > 0;) {  // above, back to the first
    add_to_chain(out, turn, sorted[i]);
  }
  out->count -= out->count > 1 ? 1 : 0;  // the first point once
  free(sorted);
}

// Edge i of a hull, counterclockwise. A hull of two corners has two edges, there and back.
static exact2_point edge(const exact2_hull *hull, unsigned i) {
  return minus(hull->vertex[i + 1 < hull->count ? i + 1 : 0], hull->vertex[i]);
}

static exact2_point outward(exact2_point e) {
  const exact2_point normal = {e.y, -e.x};
  return normal;
}

// Step 2.

// The largest n . (v - v0) of a hull, v0 being its first corner. Pre: n is an edge, turned by a quarter or not.
//   |components| <= 2^29:  each product <= 2^58
static int64_t reach(const exact2_hull *hull, exact2_point n) {
  int64_t most = 0;
  for (unsigned i = 1; i < hull->count; i++) {
    const exact2_point v = minus(hull->vertex[i], hull->vertex[0]);
    const int64_t along = n.x * v.x + n.y * v.y;
    most = along > most ? along : most;
  }
  return most;
}

// The largest n . (a - b). Pre: as of reach.
static wide height(const exact2_hull *a, const exact2_hull *b, exact2_point n) {
  const exact2_point opposite = {-n.x, -n.y};
  return dot(n, minus(a->vertex[0], b->vertex[0])) + reach(a, n) + reach(b, opposite);
}

static exact2_point negated(exact2_point p) {
  const exact2_point out = {-p.x, -p.y};
  return out;
}

// Does an edge of a hull part the two? sign: 1 for an edge of A, -1 for one of B.
static bool parts(const exact2_hull *a, const exact2_hull *b, exact2_point e, int sign) {
  const exact2_point normal = sign > 0 ? outward(e) : negated(outward(e));
  const bool flat = a->count <= 2 && b->count <= 2;
  return height(a, b, normal) < 0 || (flat && (height(a, b, e) < 0 || height(a, b, negated(e)) < 0));
}

static bool hulls_meet(const exact2_hull *a, const exact2_hull *b) {
  for (unsigned i = 0; i < a->count; i++) {
    if (parts(a, b, edge(a, i), 1)) {
      return false;
    }
  }
  for (unsigned i = 0; i < b->count; i++) {
    if (parts(a, b, edge(b, i), -1)) {
      return false;
    }
  }
  return a->count > 1 || b->count > 1 || compare_points(&a->vertex[0], &b->vertex[0]) == 0;
}

// Step 3.

// A squared distance, and the vector that has it, times a positive number.
typedef struct gap {
  exact2_wide numerator, denominator;
  exact2_point direction;
} gap;

static long double real(exact2_wide x) {
  return 0x1p64L * (uint64_t)(x >> 64) + (uint64_t)x;
}

// Its square, within 2^-62 of itself.
static long double squared(const gap *g) {
  return real(g->numerator) / real(g->denominator);
}

// The sign of the distance - twice / 2. Pre: 0 <= twice < 2^35.
static int compare_half(const gap *g, uint64_t twice) {
  const exact2_wide left = 4 * g->numerator, right = (exact2_wide)twice * twice * g->denominator;
  return left < right ? -1 : left > right;
}

// The largest integer that is at most the distance less half an LSB (half), or the distance.
static int64_t rounded_down(const gap *g, bool half) {
  int64_t d = (int64_t)sqrtl(squared(g));
  const int64_t more = half ? 1 : 0;
  while (d >= 0 && compare_half(g, (uint64_t)(2 * d + more)) < 0) {
    d--;
  }
  while (compare_half(g, (uint64_t)(2 * d + 2 + more)) >= 0) {
    d++;
  }
  return d;
}

// From a point to the segment q, q + e. The direction leads from the point to the segment.
static gap gap_to_edge(exact2_point p, exact2_point q, exact2_point e) {
  const exact2_point from = minus(p, q);
  const wide along = dot(from, e), square = dot(e, e);
  gap out = {0, 1, {0, 0}};
  if (square > 0 && along > 0 && along < square) {
    const wide area = cross(e, from);
    out.numerator = (exact2_wide)(area * (area < 0 ? -1 : 1));
    out.numerator *= out.numerator;
    out.denominator = (exact2_wide)square;
    out.direction = area > 0 ? outward(e) : negated(outward(e));
    return out;
  }
  const exact2_point end = {q.x + (along > 0 ? e.x : 0), q.y + (along > 0 ? e.y : 0)};
  out.direction = minus(end, p);
  out.numerator = (exact2_wide)dot(out.direction, out.direction);
  return out;
}

// *high 2^128 + *low = a b.
static void multiply(exact2_wide a, exact2_wide b, exact2_wide *high, exact2_wide *low) {
  const exact2_wide a0 = (uint64_t)a, a1 = a >> 64, b0 = (uint64_t)b, b1 = b >> 64;
  const exact2_wide middle = a1 * b0 + (a0 * b0 >> 64), other = a0 * b1 + (uint64_t)middle;
  *high = a1 * b1 + (middle >> 64) + (other >> 64);
  *low = (other << 64) + (uint64_t)(a0 * b0);
}

// Is a less than b? Where products with 64 bits differ by more than rounding they tell it.
static bool is_nearer(const gap *a, const gap *b, long double numerator_b, long double denominator_b) {
  const long double x = real(a->numerator) * denominator_b, y = numerator_b * real(a->denominator);
  if (x < y * (1 - 1e-17L) || y < x * (1 - 1e-17L)) {
    return x < y;
  }
  exact2_wide high_a, low_a, high_b, low_b;
  multiply(a->numerator, b->denominator, &high_a, &low_a);
  multiply(b->numerator, a->denominator, &high_b, &low_b);
  return high_a != high_b ? high_a < high_b : low_a < low_b;
}

// The gaps from each corner to each edge. swapped: from B's corners to A's edges; directions lead from A to B.
static void take_gaps(const exact2_hull *from, const exact2_hull *to, bool swapped, gap *best) {
  long double numerator = real(best->numerator), denominator = real(best->denominator);
  for (unsigned i = 0; i < from->count; i++) {
    for (unsigned k = 0; k < to->count; k++) {
      gap g = gap_to_edge(from->vertex[i], to->vertex[k], edge(to, k));
      g.direction = swapped ? negated(g.direction) : g.direction;
      if (best->denominator == 0 || is_nearer(&g, best, numerator, denominator)) {
        *best = g;
        numerator = real(g.numerator);
        denominator = real(g.denominator);
      }
    }
  }
}

// Step 4.

// The least k >= 0 with k |n| >= height. Pre: 0 <= height < 2^63, n != 0.
static int64_t rounded_up(wide h, exact2_point n) {
  const wide square = dot(n, n);
  wide k = (wide)((long double)h / sqrtl((long double)square));
  while (k > 0 && (k - 1) * (k - 1) * square >= h * h) {
    k--;
  }
  while (k * k * square < h * h) {
    k++;
  }
  return (int64_t)k;
}

static void take_lower(const exact2_hull *a, const exact2_hull *b, exact2_point normal, long double *least,
                       exact2_truth *out) {
  if (normal.x == 0 && normal.y == 0) {
    return;
  }
  const wide h = height(a, b, normal);
  const int64_t depth = rounded_up(h, normal);
  const long double real = (long double)h / sqrtl((long double)dot(normal, normal));
  if (*least < 0 || real < *least) {
    *least = real;
    out->direction = normal;
  }
  out->depth = depth < out->depth ? depth : out->depth;
}

static void find_depth(const exact2_hull *a, const exact2_hull *b, exact2_truth *out) {
  long double least = -1;
  out->depth = INT64_MAX;
  for (unsigned i = 0; i < a->count; i++) {
    take_lower(a, b, outward(edge(a, i)), &least, out);
  }
  for (unsigned i = 0; i < b->count; i++) {
    take_lower(a, b, negated(outward(edge(b, i))), &least, out);
  }
  out->depth = least < 0 ? 0 : out->depth;  // two points
}

// All.

typedef struct both_hulls {
  exact2_hull a, b;
} both_hulls;

static both_hulls *find_hulls(const exact2_shape *a, const exact2_shape *b) {
  both_hulls *h = malloc(sizeof *h);
  assert(h != NULL);
  exact2_hull_find(a->point, a->count, &h->a);
  exact2_hull_find(b->point, b->count, &h->b);
  return h;
}

bool exact2_truth_within(const exact2_truth *truth, int64_t radii, int64_t distance) {
  const gap least = {truth->numerator, truth->denominator, {0, 0}};
  return truth->cores_meet || compare_half(&least, 2 * (uint64_t)(radii + distance)) <= 0;
}

void exact2_find(const exact2_shape *a, const exact2_shape *b, exact2_truth *out) {
  static const exact2_truth empty;
  const int64_t radii = a->radius + b->radius;
  both_hulls *h = find_hulls(a, b);
  gap least = {0, 0, {0, 0}};
  *out = empty;
  out->denominator = 1;
  out->cores_meet = hulls_meet(&h->a, &h->b);
  if (out->cores_meet) {
    find_depth(&h->a, &h->b, out);
    out->depth += radii;
  } else {
    take_gaps(&h->a, &h->b, false, &least);
    take_gaps(&h->b, &h->a, true, &least);
    out->direction = least.direction;
    out->numerator = least.numerator;
    out->denominator = least.denominator;
  }
  out->intersecting = exact2_truth_within(out, radii, 0);
  if (!out->cores_meet) {
    out->distance = out->intersecting ? 0 : rounded_down(&least, true) + 1 - radii;
    out->depth = out->intersecting ? radii - rounded_down(&least, false) : 0;
  }
  free(h);
}

bool exact2_within(const exact2_shape *a, const exact2_shape *b, int64_t distance) {
  exact2_truth truth;
  exact2_find(a, b, &truth);
  return exact2_truth_within(&truth, a->radius + b->radius, distance);
}
