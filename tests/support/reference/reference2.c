// GJK and an expanding polygon in the plane, in double, with the tolerances that such code needs.
#include "reference2.h"

#include <math.h>
#include <string.h>

// The search ends when a step gains less than this share of the distance. No decision depends on it, from 1e-8 to 0.
#define RELATIVE 1e-12
// A squared distance below this share of the largest squared vertex counts as 0. Of all powers of ten this one decides
// best: of 168,000 pairs of the families (tests/support/generate) 96 are wrong, at 1e-31 348, at 1e-33 4,093.
// Some of the 96 overlap deeply: the origin lies on the simplex, and rounding leaves it a distance.
#define ENCLOSING 1e-32
#define ITERATIONS_MAX 200
#define POLYGON_MAX 256

typedef struct vertex2 {
  double w[2], a[2], b[2];
} vertex2;

typedef struct simplex2 {
  vertex2 v[3];
  double weight[3];
  int count;
} simplex2;

static double dot(const double p[2], const double q[2]) {
  return p[0] * q[0] + p[1] * q[1];
}

static double cross(const double p[2], const double q[2]) {
  return p[0] * q[1] - p[1] * q[0];
}

static void subtract(const double p[2], const double q[2], double out[2]) {
  out[0] = p[0] - q[0];
  out[1] = p[1] - q[1];
}

// The support point of the core along d.
static void farthest(const reference2_shape *s, const double d[2], double out[2]) {
  if (s->count == 0) {
    const double x = dot(s->axis[0], d), y = dot(s->axis[1], d), length = hypot(x, y);
    for (int k = 0; k < 2; k++) {
      out[k] = s->centre[k] + (length > 0 ? (x * s->axis[0][k] + y * s->axis[1][k]) / length : 0);
    }
    return;
  }
  size_t best = 0;
  for (size_t i = 1; i < s->count; i++) {
    best = dot(s->point[i], d) > dot(s->point[best], d) ? i : best;
  }
  memcpy(out, s->point[best], sizeof s->point[best]);
}

static void find_vertex(const reference2_shape *a, const reference2_shape *b, const double d[2], vertex2 *out) {
  const double back[2] = {-d[0], -d[1]};
  farthest(a, d, out->a);
  farthest(b, back, out->b);
  subtract(out->a, out->b, out->w);
}

// Keeps the edge i, k, or the one of its ends that is nearest to the origin. Returns the squared distance.
static double keep_edge(const simplex2 *s, int i, int k, simplex2 *out) {
  const double *p = s->v[i].w, *q = s->v[k].w;
  double e[2];
  subtract(q, p, e);
  const double square = dot(e, e), t = square > 0 ? -dot(p, e) / square : 0;
  const double held = t <= 0 ? 0 : t >= 1 ? 1 : t;
  const double point[2] = {p[0] + held * e[0], p[1] + held * e[1]};
  out->count = 0;
  if (held < 1) {
    out->v[out->count] = s->v[i];
    out->weight[out->count++] = 1 - held;
  }
  if (held > 0) {
    out->v[out->count] = s->v[k];
    out->weight[out->count++] = held;
  }
  return dot(point, point);
}

// Reduces the simplex to its feature nearest to the origin. True: the origin lies in the triangle.
static bool reduce(simplex2 *s) {
  simplex2 best = *s, tried;
  if (s->count == 1) {
    s->weight[0] = 1;
    return false;
  }
  double least = keep_edge(s, 0, 1, &best);
  if (s->count == 3) {
    const double area = cross(s->v[0].w, s->v[1].w), next = cross(s->v[1].w, s->v[2].w),
                 last = cross(s->v[2].w, s->v[0].w);
    if ((area > 0 && next > 0 && last > 0) || (area < 0 && next < 0 && last < 0)) {
      return true;
    }
    for (int i = 0; i < 2; i++) {
      const double found = keep_edge(s, i, 2, &tried);
      if (found < least) {
        least = found;
        best = tried;
      }
    }
  }
  *s = best;
  return false;
}

static void nearest_point(const simplex2 *s, double v[2], double a[2], double b[2]) {
  for (int k = 0; k < 2; k++) {
    v[k] = a[k] = b[k] = 0;
    for (int i = 0; i < s->count; i++) {
      v[k] += s->weight[i] * s->v[i].w[k];
      a[k] += s->weight[i] * s->v[i].a[k];
      b[k] += s->weight[i] * s->v[i].b[k];
    }
  }
}

static bool contains(const simplex2 *s, const double w[2]) {
  for (int i = 0; i < s->count; i++) {
    if (s->v[i].w[0] == w[0] && s->v[i].w[1] == w[1]) {
      return true;
    }
  }
  return false;
}

// Searches the nearest point of the cores. True: they meet, and s is the simplex that holds the origin.
static bool search(const reference2_shape *a, const reference2_shape *b, simplex2 *s, double v[2],
                   reference2_result *out) {
  const double first[2] = {1, 0};
  double largest = 0;
  s->count = 1;
  find_vertex(a, b, first, &s->v[0]);
  for (out->iterations = 0; out->iterations < ITERATIONS_MAX; out->iterations++) {
    if (reduce(s)) {
      return true;
    }
    nearest_point(s, v, out->a, out->b);
    for (int i = 0; i < s->count; i++) {
      largest = fmax(largest, dot(s->v[i].w, s->v[i].w));
    }
    const double square = dot(v, v), d[2] = {-v[0], -v[1]};
    if (square <= ENCLOSING * largest) {
      return true;
    }
    vertex2 found;
    find_vertex(a, b, d, &found);
    if (contains(s, found.w) || square - dot(v, found.w) <= RELATIVE * square) {
      return false;
    }
    s->v[s->count++] = found;
  }
  return false;
}

typedef struct polygon2 {
  vertex2 v[POLYGON_MAX];
  int count;
} polygon2;

// Makes the simplex that holds the origin a triangle, counterclockwise. False: the difference is flat.
static bool make_triangle(const reference2_shape *a, const reference2_shape *b, const simplex2 *s, polygon2 *out) {
  static const double way[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  out->count = s->count;
  memcpy(out->v, s->v, sizeof s->v);
  for (int i = 0; i < 8 && out->count < 3; i++) {
    vertex2 found;
    double e[2] = {0, 0}, f[2];
    find_vertex(a, b, way[i], &found);
    subtract(found.w, out->v[0].w, f);
    if (out->count == 2) {
      subtract(out->v[1].w, out->v[0].w, e);
    }
    if (out->count == 1 ? dot(f, f) > 0 : fabs(cross(e, f)) > 1e-12 * dot(e, e)) {
      out->v[out->count++] = found;
    }
  }
  if (out->count < 3) {
    return false;
  }
  double e[2], f[2];
  subtract(out->v[1].w, out->v[0].w, e);
  subtract(out->v[2].w, out->v[0].w, f);
  if (cross(e, f) < 0) {
    const vertex2 kept = out->v[1];
    out->v[1] = out->v[2];
    out->v[2] = kept;
  }
  return true;
}

// The edge of the polygon whose line is nearest to the origin, its outward normal and height.
static int nearest_edge(const polygon2 *p, double normal[2], double *height) {
  int best = 0;
  *height = INFINITY;
  for (int i = 0; i < p->count; i++) {
    const double *from = p->v[i].w;
    double e[2];
    subtract(p->v[(i + 1) % p->count].w, from, e);
    const double length = hypot(e[0], e[1]), n[2] = {e[1] / length, -e[0] / length};
    if (length > 0 && dot(n, from) < *height) {
      *height = dot(n, from);
      memcpy(normal, n, sizeof n);
      best = i;
    }
  }
  return best;
}

// Expands the polygon until the edge nearest to the origin is one of A - B.
static void expand(const reference2_shape *a, const reference2_shape *b, polygon2 *p, reference2_result *out) {
  double height;
  int edge = nearest_edge(p, out->normal, &height);
  while (p->count < POLYGON_MAX) {
    vertex2 found;
    find_vertex(a, b, out->normal, &found);
    out->iterations++;
    if (dot(out->normal, found.w) - height <= RELATIVE * fmax(height, fabs(dot(out->normal, found.w)))) {
      break;
    }
    memmove(&p->v[edge + 2], &p->v[edge + 1], (size_t)(p->count - edge - 1) * sizeof p->v[0]);
    p->v[edge + 1] = found;
    p->count++;
    edge = nearest_edge(p, out->normal, &height);
  }
  simplex2 s = {{p->v[edge], p->v[(edge + 1) % p->count]}, {0, 0, 0}, 2}, kept;
  double v[2];
  keep_edge(&s, 0, 1, &kept);
  nearest_point(&kept, v, out->a, out->b);
  out->distance = -fmax(height, 0);
}

void reference2_query(const reference2_shape *a, const reference2_shape *b, reference2_result *out) {
  static polygon2 polygon;
  simplex2 s;
  double v[2];
  memset(out, 0, sizeof *out);
  if (!search(a, b, &s, v, out)) {
    out->distance = hypot(v[0], v[1]);
    out->normal[0] = -v[0] / out->distance;
    out->normal[1] = -v[1] / out->distance;
  } else if (make_triangle(a, b, &s, &polygon)) {
    expand(a, b, &polygon, out);
  } else {  // flat: any direction across it
    out->normal[0] = 0;
    out->normal[1] = 1;
  }
  out->distance -= a->convex_radius + b->convex_radius;
  out->intersecting = out->distance <= 0;
  for (int k = 0; k < 2; k++) {
    out->a[k] += a->convex_radius * out->normal[k];
    out->b[k] -= b->convex_radius * out->normal[k];
  }
}
