// Exact polygons in a plane.
#include "flat.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exact/integer.h"

flat_base flat_base_of(const int32_t a[3], const int32_t b[3], const int32_t c[3]) {
  flat_base base = {a, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 3; i++) {
    const int32_t least = a[i] < b[i] ? a[i] : b[i], most = a[i] > b[i] ? a[i] : b[i];
    base.u[i] = b[i] - a[i];
    base.v[i] = c[i] - a[i];
    base.low[i] = least < c[i] ? least : c[i];
    base.high[i] = most > c[i] ? most : c[i];
  }
  return base;
}

flat_polygon flat_triangle(void) {
  static const flat_line edges[3] = {{0, 0, 1}, {1, -1, -1}, {0, 1, 0}};
  flat_polygon triangle = {solid_allocate(3, sizeof triangle.line[0]), 3};
  memcpy(triangle.line, edges, sizeof edges);
  return triangle;
}

void flat_free(flat_polygon *polygon) {
  free(polygon->line);
  polygon->line = NULL;
  polygon->lines = 0;
}

static solid_wide along(const int64_t n[3], const int32_t u[3]) {
  return (solid_wide)n[0] * u[0] + (solid_wide)n[1] * u[1] + (solid_wide)n[2] * u[2];
}

flat_line flat_trace(const flat_base *base, const solid_plane *plane, int sign) {
  const flat_line line = {sign * solid_height(plane, base->a), sign * along(plane->n, base->u),
                          sign * along(plane->n, base->v)};
  return line;
}

__extension__ typedef unsigned __int128 bits;

static exact_int exact_of(solid_wide a) {
  exact_int out = {(a > 0) - (a < 0), 0, {0}};
  for (bits rest = a < 0 ? 0 - (bits)a : (bits)a; rest != 0; rest >>= 32) {
    out.limb[out.count++] = (uint32_t)rest;
  }
  return out;
}

// a b - c d, exact.
static exact_int minor(solid_wide a, solid_wide b, solid_wide c, solid_wide d) {
  const exact_int first = exact_of(a), second = exact_of(b), third = exact_of(c), fourth = exact_of(d);
  const exact_int left = exact_mul(&first, &second), right = exact_mul(&third, &fourth);
  return exact_sub(&left, &right);
}

// The side of the line that the corner between p and q is on: the sign of det (p, q, line), since p turns to q by less than
// half a turn. Each value is below 2^93, the determinant below 2^282. Eleven roundings, each by 2^-64 at most of
// what is added up, decide nothing below 2^-59 of that.
static int corner_side(const flat_line *p, const flat_line *q, const flat_line *line) {
  const long double pk = (long double)p->k, ps = (long double)p->ks, pt = (long double)p->kt;
  const long double qk = (long double)q->k, qs = (long double)q->ks, qt = (long double)q->kt;
  const long double k = (long double)line->k, ks = (long double)line->ks, kt = (long double)line->kt;
  const long double sum = k * (ps * qt - pt * qs) + ks * (pt * qk - pk * qt) + kt * (pk * qs - ps * qk);
  const long double most = fabsl(k) * (fabsl(ps * qt) + fabsl(pt * qs)) +
                           fabsl(ks) * (fabsl(pt * qk) + fabsl(pk * qt)) +
                           fabsl(kt) * (fabsl(pk * qs) + fabsl(ps * qk));
  if (fabsl(sum) > ldexpl(most, -59)) {
    return sum > 0 ? 1 : -1;
  }
  const exact_int a = minor(p->ks, q->kt, p->kt, q->ks), b = minor(p->kt, q->k, p->k, q->kt);
  const exact_int c = minor(p->k, q->ks, p->ks, q->k), one = exact_of(line->k), two = exact_of(line->ks);
  const exact_int three = exact_of(line->kt), ka = exact_mul(&one, &a), kb = exact_mul(&two, &b);
  const exact_int kc = exact_mul(&three, &c), part = exact_add(&ka, &kb), all = exact_add(&part, &kc);
  return all.sign;
}

static int side_of_corner(const flat_polygon *polygon, unsigned i, const flat_line *line) {
  return corner_side(&polygon->line[i], &polygon->line[i + 1 == polygon->lines ? 0 : i + 1], line);
}

unsigned flat_sides(const flat_polygon *polygon, const flat_line *line) {
  if (line->ks == 0 && line->kt == 0) {
    return polygon->lines == 0 || line->k == 0 ? 0 : line->k > 0 ? FLAT_BEYOND : FLAT_BEHIND;
  }
  unsigned sides = 0;
  for (unsigned i = 0; i < polygon->lines && sides != (FLAT_BEYOND | FLAT_BEHIND); i++) {
    const int side = side_of_corner(polygon, i, line);
    sides |= side > 0 ? FLAT_BEYOND : side < 0 ? FLAT_BEHIND : 0;
  }
  return sides;
}

flat_polygon flat_clip(const flat_polygon *polygon, const flat_line *line, int sign) {
  flat_polygon out = {solid_allocate((size_t)polygon->lines + 1, sizeof out.line[0]), 0};
  const flat_line border = {sign * line->k, sign * line->ks, sign * line->kt};
  const unsigned sides = flat_sides(polygon, &border);
  if (sides != (FLAT_BEYOND | FLAT_BEHIND)) {
    out.lines = sides == FLAT_BEYOND ? polygon->lines : 0;
    memcpy(out.line, polygon->line, out.lines * sizeof out.line[0]);
    return out;
  }
  int before = side_of_corner(polygon, polygon->lines - 1, &border);
  for (unsigned i = 0; i < polygon->lines; i++) {  // edge i runs from corner i - 1 to corner i
    const int after = side_of_corner(polygon, i, &border);
    if (before > 0 || after > 0) {
      out.line[out.lines++] = polygon->line[i];
    }
    if (before > 0 && after <= 0) {
      out.line[out.lines++] = border;
    }
    before = after;
  }
  return out;
}

void flat_corner(const flat_base *base, const flat_polygon *polygon, unsigned corner, long double out[3]) {
  const flat_line *p = &polygon->line[corner], *q = &polygon->line[corner + 1 == polygon->lines ? 0 : corner + 1];
  const long double pk = (long double)p->k, ps = (long double)p->ks, pt = (long double)p->kt;
  const long double qk = (long double)q->k, qs = (long double)q->ks, qt = (long double)q->kt;
  const long double w = ps * qt - pt * qs, s = (pt * qk - pk * qt) / w, t = (pk * qs - ps * qk) / w;
  for (int i = 0; i < 3; i++) {
    out[i] = base->a[i] + s * base->u[i] + t * base->v[i];
  }
}

// Is (i, j) / 2^60 strictly on the positive side?
static bool is_within(const flat_line *line, int64_t i, int64_t j) {
  const exact_int k = exact_of(line->k), ks = exact_of(line->ks), kt = exact_of(line->kt);
  const exact_int one = exact_from((int64_t)1 << 60), s = exact_from(i), t = exact_from(j);
  const exact_int a = exact_mul(&k, &one), b = exact_mul(&ks, &s), c = exact_mul(&kt, &t);
  const exact_int part = exact_add(&a, &b), all = exact_add(&part, &c);
  return all.sign > 0;
}

bool flat_inner(const flat_polygon *polygon, unsigned attempt, int64_t *i, int64_t *j) {
  long double s = 0, t = 0, weights = 0;
  for (unsigned n = 0; n < polygon->lines; n++) {
    const flat_line *p = &polygon->line[n], *q = &polygon->line[n + 1 == polygon->lines ? 0 : n + 1];
    const long double pk = (long double)p->k, ps = (long double)p->ks, pt = (long double)p->kt;
    const long double qk = (long double)q->k, qs = (long double)q->ks, qt = (long double)q->kt;
    const long double w = ps * qt - pt * qs, weight = 1 + (n * 7 + 3) * attempt % 11;
    s += weight * (pt * qk - pk * qt) / w;
    t += weight * (pk * qs - ps * qk) / w;
    weights += weight;
  }
  s /= weights;
  t /= weights;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) {
    return false;
  }
  *i = (int64_t)ldexpl(s, 60);
  *j = (int64_t)ldexpl(t, 60);
  for (unsigned n = 0; n < polygon->lines; n++) {
    if (!is_within(&polygon->line[n], *i, *j)) {
      return false;
    }
  }
  return true;
}
