// The exact depth of an overlap, by trying every direction that a facet of A - B can have.
//
// A facet of A - B is a face of A, farthest along the normal, minus a face of B, farthest against it. One of the two is
// a polygon, or both are edges that are not parallel. So the normal is the cross product of two edges between vertices
// of A, or of B, or of one of each. All these directions are tried. Every direction's height is at least the depth, so
// the least height is that of a facet.
#include "depth.h"

#include <assert.h>
#include <math.h>

__extension__ typedef __int128 wide;

#define EDGES_MAX (EXACT_DEPTH_VERTICES * (EXACT_DEPTH_VERTICES - 1) / 2)

// Vertices relative to A's first one: those of A are below 2^30, as its diameter is, those of B below 2^32.
typedef struct corner {
  int64_t x[3];
} corner;

// A vector: an edge, at most 2^30 in size, or a direction, at most 2^61; in the plane of a flat A - B 2^92.
typedef struct direction {
  wide x[3];
} direction;

typedef struct polytope {
  corner vertex[EXACT_DEPTH_VERTICES];
  unsigned count;  // of different vertices
} polytope;

typedef struct search {
  polytope a, b;
  bool apart, found;
  double height;  // of the best, to within 2^-50 of itself
  exact_plane *best;
} search;

static void load(const gjk_collider *c, const exact_point *origin, polytope *out) {
  const unsigned count = exact_vertex_count(c);
  assert(count > 0 && count <= EXACT_DEPTH_VERTICES);
  out->count = 0;
  for (unsigned i = 0; i < count; i++) {
    const exact_point world = exact_vertex(c, i), p = exact_subtract(&world, origin);
    unsigned k = 0;
    while (k < out->count &&
           (out->vertex[k].x[0] != p.x[0] || out->vertex[k].x[1] != p.x[1] || out->vertex[k].x[2] != p.x[2])) {
      k++;
    }
    if (k == out->count) {
      const corner found = {{p.x[0], p.x[1], p.x[2]}};
      out->vertex[out->count++] = found;
    }
  }
}

static direction edge(const polytope *p, unsigned i, unsigned k) {
  const direction e = {{p->vertex[k].x[0] - p->vertex[i].x[0], p->vertex[k].x[1] - p->vertex[i].x[1],
                        p->vertex[k].x[2] - p->vertex[i].x[2]}};
  return e;
}

// Edges are at most 2^30, so their cross product is at most 2^61; that of such a product and an edge 2^92.
static direction cross(const direction *a, const direction *b) {
  const direction n = {{a->x[1] * b->x[2] - a->x[2] * b->x[1], a->x[2] * b->x[0] - a->x[0] * b->x[2],
                        a->x[0] * b->x[1] - a->x[1] * b->x[0]}};
  return n;
}

static bool is_zero(const direction *d) {
  return d->x[0] == 0 && d->x[1] == 0 && d->x[2] == 0;
}

// |height| <= 3 * 2^92 * 2^32 < 2^126.
static wide dot(const direction *d, const corner *v) {
  return d->x[0] * v->x[0] + d->x[1] * v->x[1] + d->x[2] * v->x[2];
}

static void range(const polytope *p, const direction *d, wide *low, wide *high) {
  *low = *high = dot(d, &p->vertex[0]);
  for (unsigned i = 1; i < p->count; i++) {
    const wide along = dot(d, &p->vertex[i]);
    *low = along < *low ? along : *low;
    *high = along > *high ? along : *high;
  }
}

static exact_int from_wide(wide value) {
  const wide unit = (wide)1 << 62;
  const exact_int upper = exact_from((int64_t)(value / unit)), lower = exact_from((int64_t)(value % unit));
  const exact_int u = exact_from(INT64_C(1) << 62), product = exact_mul(&upper, &u);
  return exact_add(&product, &lower);
}

// The height of A - B along sign * d. Doubles tell most directions that are higher than the best one: both heights are
// known to within 2^-48.
static void consider(search *s, const direction *d, int sign, wide height) {
  if (height < 0) {
    s->apart = true;
    return;
  }
  const double x = (double)d->x[0], y = (double)d->x[1], z = (double)d->x[2];
  const double size = (double)height / sqrt(x * x + y * y + z * z);
  if (s->found && size > s->height * (1 + 1e-13)) {
    return;
  }
  exact_vector normal;
  for (int i = 0; i < 3; i++) {
    normal.x[i] = from_wide(sign * d->x[i]);
  }
  const exact_int exact = from_wide(height);
  exact_plane plane;
  exact_plane_make(&normal, &exact, &plane);
  if (!s->found || exact_plane_order(&plane, s->best) < 0) {
    *s->best = plane;
    s->height = size;
    s->found = true;
  }
}

static void try_direction(search *s, const direction *d) {
  if (!is_zero(d)) {
    wide low_a, high_a, low_b, high_b;
    range(&s->a, d, &low_a, &high_a);
    range(&s->b, d, &low_b, &high_b);
    consider(s, d, 1, high_a - low_b);
    consider(s, d, -1, high_b - low_a);
  }
}

// Tries the planes of three vertices of one shape.
static void try_faces(search *s, const polytope *p) {
  for (unsigned i = 0; i < p->count; i++) {
    for (unsigned k = i + 1; k < p->count; k++) {
      const direction first = edge(p, i, k);
      for (unsigned l = k + 1; l < p->count; l++) {
        const direction second = edge(p, i, l), normal = cross(&first, &second);
        try_direction(s, &normal);
      }
    }
  }
}

static unsigned list_edges(const polytope *p, direction *out) {
  unsigned count = 0;
  for (unsigned i = 0; i < p->count; i++) {
    for (unsigned k = i + 1; k < p->count; k++) {
      out[count++] = edge(p, i, k);
    }
  }
  return count;
}

// The dimension of A - B. base: as many of its edges, which are not in one line or plane.
static unsigned dimension(const direction *edges, unsigned count, direction base[3]) {
  unsigned rank = 0;
  for (unsigned i = 0; i < count && rank < 3; i++) {
    const direction *e = &edges[i];
    bool grows = !is_zero(e);
    if (rank == 1) {
      const direction normal = cross(&base[0], e);
      grows = !is_zero(&normal);
    } else if (rank == 2) {
      const direction normal = cross(&base[0], &base[1]);
      grows = normal.x[0] * e->x[0] + normal.x[1] * e->x[1] + normal.x[2] * e->x[2] != 0;
    }
    if (grows) {
      base[rank++] = *e;
    }
  }
  return rank;
}

// Of a flat A - B: finds a plane through the origin, or sets s->apart.
static void try_flat(search *s, unsigned rank, const direction base[3], const direction *edges, unsigned count) {
  static const direction axes[3] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  if (rank == 2) {
    const direction normal = cross(&base[0], &base[1]);
    try_direction(s, &normal);
    for (unsigned i = 0; i < count && !s->apart; i++) {
      const direction within = cross(&normal, &edges[i]);
      try_direction(s, &within);
    }
    return;
  }
  for (int i = 0; i < 3; i++) {  // a line or a point: its extent along the axes, and that the origin is in the line
    try_direction(s, &axes[i]);
    if (rank == 1) {
      const direction across = cross(&axes[i], &base[0]);
      try_direction(s, &across);
    }
  }
}

unsigned long exact_depth_work(const gjk_collider *a, const gjk_collider *b) {
  const unsigned long p = exact_vertex_count(a), q = exact_vertex_count(b);
  return p * p * p / 6 + q * q * q / 6 + p * p * q * q / 4;
}

bool exact_depth(const gjk_collider *a, const gjk_collider *b, exact_plane *out) {
  static direction edges[2 * EDGES_MAX];
  const exact_point origin = exact_vertex(a, 0);
  direction base[3];
  search s;
  s.apart = s.found = false;
  s.height = 0;
  s.best = out;
  load(a, &origin, &s.a);
  load(b, &origin, &s.b);
  const unsigned of_a = list_edges(&s.a, edges), of_b = list_edges(&s.b, edges + of_a);
  const unsigned rank = dimension(edges, of_a + of_b, base);
  if (rank < 3) {
    try_flat(&s, rank, base, edges, of_a + of_b);
    return !s.apart;
  }
  try_faces(&s, &s.a);
  try_faces(&s, &s.b);
  for (unsigned i = 0; i < of_a && !s.apart; i++) {
    for (unsigned k = 0; k < of_b; k++) {
      const direction normal = cross(&edges[i], &edges[of_a + k]);
      try_direction(&s, &normal);
    }
  }
  return !s.apart;
}

bool exact_overlap_find(const gjk_collider *a, const gjk_collider *b, exact_overlap *out) {
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  const unsigned count_a = exact_vertex_count(a), count_b = exact_vertex_count(b);
  exact_plane plane;
  exact_truth truth;
  if (count_a > EXACT_DEPTH_VERTICES || count_b > EXACT_DEPTH_VERTICES ||
      exact_depth_work(a, b) > EXACT_DEPTH_DIRECTIONS) {
    return false;
  }
  if (!exact_depth(a, b, &plane)) {
    out->intersecting = false;
    out->touching = false;
    if (radius == 0) {
      return true;
    }
    if (count_a * count_b > EXACT_OVERLAP_BRUTE) {
      return false;
    }
    exact_brute(a, b, &truth);
    exact_plane_behind(&truth.nearest, &plane);
  }
  const int side = exact_plane_compare(&plane, -radius);
  out->intersecting = side >= 0;
  out->touching = side == 0;
  out->depth = radius + exact_plane_ceiling(&plane);
  return true;
}
