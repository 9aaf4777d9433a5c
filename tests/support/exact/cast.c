// The exact oracle of casts in space.
#include "cast.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct edges {
  unsigned count;
  exact_point e[EXACT_DIFFERENCE_EDGES];
} edges;

exact_int exact_from_wide(exact_wide value) {
  const exact_wide unit = (exact_wide)1 << 62;
  const exact_int high = exact_from((int64_t)(value / unit / unit)), scale = exact_from((int64_t)unit);
  const exact_int middle = exact_from((int64_t)(value / unit % unit)), low = exact_from((int64_t)(value % unit));
  const exact_int first = exact_mul(&high, &scale), sum = exact_add(&first, &middle);
  const exact_int second = exact_mul(&sum, &scale);
  return exact_add(&second, &low);
}

// Doubles settle most. A factor is within 2^-53 of itself, a product within 2^-51; below 2^253.
int exact_compare_products(exact_wide p, exact_wide q, exact_wide r, exact_wide s) {
  const double pq = (double)p * (double)q, rs = (double)r * (double)s;
  const double error = ldexp(fabs(pq) + fabs(rs), -49);
  if (pq - rs > error || rs - pq > error) {
    return pq > rs ? 1 : -1;
  }
  const exact_int a = exact_from_wide(p), b = exact_from_wide(q), c = exact_from_wide(r), d = exact_from_wide(s);
  const exact_int ab = exact_mul(&a, &b), cd = exact_mul(&c, &d);
  return exact_compare(&ab, &cd);
}

static void cross(const exact_wide a[3], const exact_wide b[3], exact_wide out[3]) {
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = a[j] * b[k] - a[k] * b[j];
  }
}

static void widen(const exact_point *p, exact_wide out[3]) {
  for (int i = 0; i < 3; i++) {
    out[i] = p->x[i];
  }
}

static bool is_zero(const exact_wide v[3]) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

static exact_wide along(const exact_wide normal[3], const exact_point *p) {
  return normal[0] * p->x[0] + normal[1] * p->x[1] + normal[2] * p->x[2];
}

// Adds the differences of vertices, but for 0 and what is parallel to an earlier one.
static bool add_edges(const gjk_collider *c, unsigned count, edges *out) {
  for (unsigned i = 0; i < count; i++) {
    for (unsigned k = 0; k < i; k++) {
      const exact_point p = exact_vertex(c, i), q = exact_vertex(c, k), e = exact_subtract(&p, &q);
      exact_wide wide[3];
      widen(&e, wide);
      bool known = is_zero(wide);
      for (unsigned m = 0; m < out->count && !known; m++) {
        exact_wide earlier[3], n[3];
        widen(&out->e[m], earlier);
        cross(wide, earlier, n);
        known = is_zero(n);
      }
      if (!known && out->count == EXACT_DIFFERENCE_EDGES) {
        return false;
      }
      if (!known) {
        out->e[out->count++] = e;
      }
    }
  }
  return true;
}

static void add_half_space(const gjk_collider *a, const gjk_collider *b, const exact_wide normal[3], int sign,
                           exact_difference *out) {
  if (out->count == out->capacity) {
    out->capacity = 2 * out->capacity + 64;
    out->all = realloc(out->all, out->capacity * sizeof *out->all);
    if (out->all == NULL) {
      fprintf(stderr, "out of memory for the planes of A - B\n");
      exit(2);
    }
  }
  exact_half_space *half = &out->all[out->count++];
  for (int i = 0; i < 3; i++) {
    half->normal[i] = sign * normal[i];
  }
  exact_wide most = 0, least = 0;
  for (unsigned i = 0; i < exact_vertex_count(a); i++) {
    const exact_point v = exact_vertex(a, i);
    const exact_wide x = along(half->normal, &v);
    most = i == 0 || x > most ? x : most;
  }
  for (unsigned i = 0; i < exact_vertex_count(b); i++) {
    const exact_point v = exact_vertex(b, i);
    const exact_wide x = along(half->normal, &v);
    least = i == 0 || x < least ? x : least;
  }
  half->height = most - least;
}

static void add_both(const gjk_collider *a, const gjk_collider *b, const exact_wide normal[3], exact_difference *out) {
  if (!is_zero(normal)) {
    add_half_space(a, b, normal, 1, out);
    add_half_space(a, b, normal, -1, out);
  }
}

// The dimension of what the edges span; if it is 2, normal is at right angles to them.
static unsigned find_dimension(const edges *from, exact_wide normal[3]) {
  exact_wide first[3], other[3];
  if (from->count < 2) {  // no two are parallel
    return from->count;
  }
  widen(&from->e[0], first);
  widen(&from->e[1], other);
  cross(first, other, normal);
  for (unsigned i = 2; i < from->count; i++) {
    if (along(normal, &from->e[i]) != 0) {
      return 3;
    }
  }
  return 2;
}

// A facet of A - B is spanned by two edges, each of which is an edge of A or of B.
static void add_facets(const gjk_collider *a, const gjk_collider *b, const edges *from, exact_difference *out) {
  for (unsigned i = 0; i < from->count; i++) {
    for (unsigned k = 0; k < i; k++) {
      exact_wide p[3], q[3], n[3];
      widen(&from->e[i], p);
      widen(&from->e[k], q);
      cross(p, q, n);
      add_both(a, b, n, out);
    }
  }
}

// What is flat lies between two planes, and its sides are the edges. A segment lies on lines that three pairs of planes
// hold, and between two ends; a point between the axes' planes.
static void add_flat(const gjk_collider *a, const gjk_collider *b, const edges *from, const exact_wide normal[3],
                     exact_difference *out) {
  static const exact_wide axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  exact_wide e[3], n[3];
  if (out->dimension == 2) {
    add_both(a, b, normal, out);
    for (unsigned i = 0; i < from->count; i++) {
      widen(&from->e[i], e);
      cross(e, normal, n);
      add_both(a, b, n, out);
    }
    return;
  }
  for (int i = 0; i < 3; i++) {
    if (out->dimension == 0) {
      add_both(a, b, axes[i], out);
    } else {
      widen(&from->e[0], e);
      cross(e, axes[i], n);
      add_both(a, b, n, out);
    }
  }
  if (out->dimension == 1) {
    add_both(a, b, e, out);
  }
}

bool exact_difference_find(const gjk_collider *a, const gjk_collider *b, exact_difference *out) {
  static edges all;
  exact_wide normal[3] = {0, 0, 0};
  const unsigned count_a = exact_vertex_count(a), count_b = exact_vertex_count(b);
  all.count = 0;
  out->count = 0;
  if (count_a == 0 || count_b == 0 || !add_edges(a, count_a, &all) || !add_edges(b, count_b, &all)) {
    return false;
  }
  out->dimension = find_dimension(&all, normal);
  if (out->dimension == 3) {
    add_facets(a, b, &all, out);
  } else {
    add_flat(a, b, &all, normal, out);
  }
  return true;
}

void exact_difference_free(exact_difference *difference) {
  free(difference->all);
  difference->all = NULL;
  difference->count = difference->capacity = 0;
}

int exact_difference_side(const exact_difference *difference, const exact_point *from, const exact_point *way,
                          int64_t numerator, int64_t denominator) {
  int side = difference->dimension == 3 ? 1 : 0;
  for (size_t i = 0; i < difference->count; i++) {
    const exact_half_space *h = &difference->all[i];
    // Is numerator / denominator * along below room? Both are below 2^125.
    const exact_wide room = h->height - along(h->normal, from);
    const int inside = exact_compare_products(room, denominator, along(h->normal, way), numerator);
    side = inside < side ? inside : side;
  }
  return side;
}

// The way leaves the half space at room / speed, if speed is positive, or enters it there.
typedef struct crossing {
  exact_wide numerator, denominator;  // denominator > 0
} crossing;

static int order(const crossing *a, const crossing *b) {
  return exact_compare_products(a->numerator, b->denominator, b->numerator, a->denominator);
}

gjk_q30 exact_fraction_floor(exact_wide numerator, exact_wide denominator) {
  int64_t quotient = (int64_t)(numerator / denominator);  // 0 or 1
  exact_wide rest = numerator % denominator;
  for (int bit = 0; bit < 30; bit++) {
    rest *= 2;
    quotient = 2 * quotient + (rest >= denominator ? 1 : 0);
    rest -= rest >= denominator ? denominator : 0;
  }
  return (gjk_q30)quotient;
}

void exact_cast_find(const exact_difference *difference, const exact_point *from, const exact_point *way,
                     exact_cast_truth *out) {
  crossing in = {.numerator = 0, .denominator = 1}, end = {.numerator = 1, .denominator = 1};
  bool beside = false;
  out->inside = true;
  out->entry = out->entries = 0;
  for (size_t i = 0; i < difference->count; i++) {
    const exact_half_space *h = &difference->all[i];
    const exact_wide room = h->height - along(h->normal, from), speed = along(h->normal, way);
    const crossing at = {.numerator = speed < 0 ? -room : room, .denominator = speed < 0 ? -speed : speed};
    out->inside = out->inside && room >= 0;
    beside = beside || (room < 0 && speed >= 0);
    if (room < 0 && speed < 0) {
      const int later = order(&at, &in);
      out->entries = later > 0 ? 1 : out->entries + (later == 0);
      out->entry = later > 0 ? i : out->entry;
      in = later > 0 ? at : in;
    } else if (speed > 0 && order(&at, &end) < 0) {
      end = at;
    }
  }
  out->hit = !beside && order(&in, &end) <= 0;
  out->ends = out->hit && order(&in, &end) == 0;
  out->numerator = in.numerator;
  out->denominator = in.denominator;
  out->fraction = out->hit ? exact_fraction_floor(in.numerator, in.denominator) : 0;
}

// (from - whole) denominator + numerator way, in products below 2^159.
static exact_int ahead_of(const exact_cast_truth *truth, const exact_point *from, const exact_point *way, int axis,
                          int64_t whole) {
  const exact_int n = exact_from_wide(truth->numerator), d = exact_from_wide(truth->denominator);
  const exact_int w = exact_from(way->x[axis]), f = exact_from(from->x[axis] - whole);
  const exact_int first = exact_mul(&f, &d), second = exact_mul(&n, &w);
  return exact_add(&first, &second);
}

int exact_cast_compare(const exact_cast_truth *truth, const exact_point *from, const exact_point *way, int axis,
                       int64_t whole) {
  return ahead_of(truth, from, way, axis, whole).sign;
}

int64_t exact_cast_floor(const exact_cast_truth *truth, const exact_point *from, const exact_point *way, int axis) {
  const double fraction = (double)truth->numerator / (double)truth->denominator;
  int64_t x = from->x[axis] + (int64_t)(fraction * (double)way->x[axis]) - 2;
  while (exact_cast_compare(truth, from, way, axis, x + 1) >= 0) {  // a few times: the double is off by less than 1
    x++;
  }
  return x;
}

// With x the entry: normal . (w - x) <= slack |w - x|, in long double, whose error is below 2^-60 of the lengths.
bool exact_cast_is_normal(const gjk_collider *a, const gjk_collider *b, const exact_cast_truth *truth,
                          const exact_point *way, const gjk_unit3 *normal) {
  const long double n[3] = {normal->x, normal->y, normal->z}, unit = GJK_Q30_ONE;
  const long double fraction = (long double)truth->numerator / (long double)truth->denominator;
  const long double length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  long double toward = 0;
  for (int i = 0; i < 3; i++) {
    toward += n[i] * (long double)way->x[i];
  }
  if (fabsl(length - unit) > 4 || toward > 0x1p-27L * unit * sqrtl(3.0L) * 0x1p33L) {
    return false;
  }
  for (unsigned i = 0; i < exact_vertex_count(a); i++) {
    for (unsigned k = 0; k < exact_vertex_count(b); k++) {
      const exact_point p = exact_vertex(a, i), q = exact_vertex(b, k), w = exact_subtract(&p, &q);
      long double beyond = 0, size = 0;
      for (int m = 0; m < 3; m++) {
        const long double x = (long double)w.x[m] - fraction * (long double)way->x[m];
        beyond += n[m] * x;
        size += fabsl(x) + 0x1p-28L * fabsl((long double)way->x[m]);
      }
      if (beyond > 4.001L * size + 1) {
        return false;
      }
    }
  }
  return true;
}
