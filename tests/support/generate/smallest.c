// Makes pairs whose deciding determinant is the smallest that the lattice allows.
//
// The plane through two integer edges e and f has the normal n = e x f, |n| <= 2^59. If the components of n have no
// common factor, the extended Euclidean algorithm finds an integer point p with n . p = k for any k: at height k / |n|.
// Multiples of e and f, subtracted from p, bring it above the face, or the edges to where they cross.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact.h"
#include "exact/feature.h"
#include "generate.h"
#include "polytope.h"

__extension__ typedef __int128 wide;

// How far the contact stays from borders, in parts of an edge.
#define MARGIN 0.001L

typedef struct lattice_plane {
  int64_t e[3], f[3], n[3];
  long double alpha, beta;  // of the reduced point: alpha e + beta f, and its height
} lattice_plane;

// The greatest common divisor u a + v b, never negative.
static int64_t euclid(int64_t a, int64_t b, int64_t *u, int64_t *v) {
  int64_t u0 = 1, v0 = 0, u1 = 0, v1 = 1;
  while (b != 0) {
    const int64_t quotient = a / b, rest = a % b, u2 = u0 - quotient * u1, v2 = v0 - quotient * v1;
    a = b;
    b = rest;
    u0 = u1;
    v0 = v1;
    u1 = u2;
    v1 = v2;
  }
  *u = a < 0 ? -u0 : u0;
  *v = a < 0 ? -v0 : v0;
  return a < 0 ? -a : a;
}

static void cross(const int64_t *a, const int64_t *b, int64_t *out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

// The coordinates of p along e and f, good to some 2^-50 of themselves.
static void coordinates(lattice_plane *plane, const wide *p) {
  const int64_t *e = plane->e, *f = plane->f, *n = plane->n;
  long double squared = 0, alpha = 0, beta = 0;
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const long double normal = (long double)n[i], pj = (long double)p[j], pk = (long double)p[k];
    squared += normal * normal;
    alpha += (pj * (long double)f[k] - pk * (long double)f[j]) * normal;
    beta += ((long double)e[j] * pk - (long double)e[k] * pj) * normal;
  }
  plane->alpha = alpha / squared;
  plane->beta = beta / squared;
}

// Subtracts multiples of e and f until 0 <= alpha < 1 and low <= beta < low + 1.
static bool reduce(lattice_plane *plane, wide *p, long double low) {
  for (int iterations = 0; iterations < 12; iterations++) {
    coordinates(plane, p);
    const long double of_e = floorl(plane->alpha), of_f = floorl(plane->beta - low);
    if (of_e == 0 && of_f == 0) {
      return true;
    }
    for (int i = 0; i < 3; i++) {
      p[i] -= (wide)of_e * plane->e[i] + (wide)of_f * plane->f[i];
    }
  }
  return false;
}

// Finds a point with n . p = k, reduced. False: the components of n have a common factor, or the point is near a
// border.
static bool solve(lattice_plane *plane, int64_t k, long double low, int64_t *out) {
  int64_t u, v, s, t;
  const int64_t *n = plane->n, pair = euclid(n[0], n[1], &u, &v);
  if (euclid(pair, n[2], &s, &t) != 1) {
    return false;
  }
  wide p[3] = {(wide)u * s, (wide)v * s, t};  // n . p = 1
  if (!reduce(plane, p, low)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    p[i] *= k;  // 2^30 times 2^63
  }
  if (!reduce(plane, p, low)) {
    return false;
  }
  wide height = 0;
  for (int i = 0; i < 3; i++) {
    out[i] = (int64_t)p[i];
    height += (wide)n[i] * p[i];
  }
  const long double beta = plane->beta - low;
  return height == k && plane->alpha > MARGIN && plane->alpha < 1 - MARGIN && beta > MARGIN && beta < 1 - MARGIN;
}

// Finds a point of the plane itself. There is one inside only if e and f are multiples of shorter integer vectors.
static void meet(random_state *random, lattice_plane *plane, bool crossing, int multiple, int64_t *out) {
  const int64_t s = random_range(random, 1, multiple - 1);
  const int64_t t = random_range(random, 1, multiple - 1) * (crossing ? -1 : 1);
  for (int i = 0; i < 3; i++) {
    out[i] = s * (plane->e[i] / multiple) + t * (plane->f[i] / multiple);
  }
  plane->alpha = (long double)s / multiple;
  plane->beta = (long double)t / multiple;
}

// The sign of k / |n| - level / 2.
static int compare_height(const int64_t *n, int64_t k, int64_t level) {
  const exact_int two = exact_from(2), factor = exact_from(k), twice = exact_mul(&two, &factor), l = exact_from(level);
  const exact_vector normal = {{exact_from(n[0]), exact_from(n[1]), exact_from(n[2])}};
  const exact_point point = {{n[0], n[1], n[2]}};
  const exact_int left = exact_mul(&twice, &twice), squared = exact_dot(&normal, &point);
  const exact_int by_level = exact_mul(&squared, &l), right = exact_mul(&by_level, &l);
  return k < 0 ? -1 : exact_compare(&left, &right);
}

// One of the two heights next to the level.
static int64_t choose_height(random_state *random, const int64_t *n, int64_t level) {
  if (level == 0) {
    return random_below(random, 2) == 0 ? -1 : 1;
  }
  const long double x = (long double)n[0], y = (long double)n[1], z = (long double)n[2];
  int64_t k = (int64_t)(sqrtl(x * x + y * y + z * z) * (long double)level / 2);
  while (compare_height(n, k, level) > 0) {
    k--;
  }
  while (compare_height(n, k + 1, level) <= 0) {
    k++;
  }
  return k + (int64_t)random_below(random, 2);
}

// Rounds to a multiple.
static void round_vector(const double *v, int multiple, int64_t *out) {
  for (int i = 0; i < 3; i++) {
    out[i] = multiple * llrint(v[i] / multiple);
  }
}

// Two edges: of one face, almost equilateral, or of two shapes, almost square. e and f are as long as the shapes may
// be.
static void choose_edges(random_state *random, bool crossing, int multiple, double reach, lattice_plane *plane) {
  const gjk_vec3 a = generate_vector(random, 1e9), b = generate_vector(random, 1e9);
  const int64_t first[3] = {a.x, a.y, a.z}, second[3] = {b.x, b.y, b.z};
  int64_t normal[3], side[3];
  cross(first, second, normal);  // 2^61
  const double scale = 1e9 / sqrt((double)normal[0] * (double)normal[0] + (double)normal[1] * (double)normal[1] +
                                  (double)normal[2] * (double)normal[2]);
  const double unit[3] = {(double)normal[0] * scale, (double)normal[1] * scale, (double)normal[2] * scale};
  round_vector(unit, 1, side);
  cross(side, first, normal);
  const double jitter = 0.8 + 0.2 * generate_unit(random), angle = crossing ? 1.3 + 0.5 * generate_unit(random) : 1.05;
  const double length = reach * (crossing ? 1.9 : 1.5 + 0.15 * generate_unit(random));
  double e[3], f[3];
  for (int i = 0; i < 3; i++) {
    const double along = (double)first[i] / 1e9, across = (double)normal[i] / 1e18;
    e[i] = length * along;
    f[i] = length * jitter * (cos(angle) * along + sin(angle) * across);
  }
  round_vector(e, multiple, plane->e);
  round_vector(f, multiple, plane->f);
  cross(plane->e, plane->f, plane->n);
}

static gjk_vec3 to_vec3(const int64_t *p) {
  const gjk_vec3 v = {(gjk_q16)p[0], (gjk_q16)p[1], (gjk_q16)p[2]};
  return v;
}

// p + s e + t f, for integer s and t.
static gjk_vec3 combine(const lattice_plane *plane, const int64_t *p, int s, int t) {
  int64_t sum[3];
  for (int i = 0; i < 3; i++) {
    sum[i] = p[i] + s * plane->e[i] + t * plane->f[i];
  }
  return to_vec3(sum);
}

static void append(case_shape *shape, gjk_vec3 vertex) {
  case_shape_set_count(shape, shape->count + 1);
  shape->vertices[shape->count - 1] = vertex;
}

// Adds points behind the contact point `at`, on the side away from the other shape, spread across the edge of a shape
// that has one. They are at least some LSB behind it, so rounding never takes them to the front.
static void thicken(random_state *random, const lattice_plane *plane, const int64_t *edge, const double *at,
                    double reach, double side, case_shape *shape) {
  const double n[3] = {(double)plane->n[0], (double)plane->n[1], (double)plane->n[2]};
  const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), depth = 8 + reach * 0.2 * generate_unit(random);
  double across[3];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    across[i] = (n[j] * (double)edge[k] - n[k] * (double)edge[j]) / length;
  }
  const double width = sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
  for (int turn = -1; turn <= 1; turn += 2) {
    int64_t vertex[3];
    for (int i = 0; i < 3; i++) {
      vertex[i] = llrint(at[i] + side * depth * n[i] / length + turn * depth * 0.5 * across[i] / width);
    }
    append(shape, to_vec3(vertex));
  }
}

static void make_face(const lattice_plane *plane, case_shape *shape) {
  static const int64_t origin[3] = {0, 0, 0};
  const int corner = plane->alpha + plane->beta > 1 ? 1 : 0;
  append(shape, combine(plane, origin, corner, corner));
  append(shape, combine(plane, origin, 1, 0));
  append(shape, combine(plane, origin, 0, 1));
}

static void make_upper(const lattice_plane *plane, generate_contact contact, const int64_t *p, case_shape *shape) {
  append(shape, combine(plane, p, 0, 0));
  if (contact == GENERATE_EDGE_EDGE) {
    append(shape, combine(plane, p, 0, 1));
  } else if (contact == GENERATE_FACE_FACE) {
    append(shape, combine(plane, p, -1, 0));
    append(shape, combine(plane, p, 0, -1));
  }
}

static unsigned length_bits(const int64_t *n, int factor) {
  const double x = (double)n[0], y = (double)n[1], z = (double)n[2];
  int bits;
  frexp(factor * sqrt(x * x + y * y + z * z), &bits);
  return (unsigned)bits;
}

static bool fits(const case_shape *shape) {
  case_collider built;
  memset(&built, 0, sizeof built);
  const bool ok = case_collider_build(&built, shape, false) == GJK_OK;
  case_collider_free(&built);
  return ok;
}

static bool try_smallest(random_state *random, generate_contact contact, int64_t level, bool thick, double reach,
                         case_pair *pair, generate_height *height) {
  static const int64_t origin[3] = {0, 0, 0};
  const bool crossing = contact == GENERATE_EDGE_EDGE;
  lattice_plane plane;
  int64_t p[3];
  const int multiple = level == 0 && random_below(random, 3) == 0 ? random_range(random, 2, 7) : 1;
  choose_edges(random, crossing, multiple, reach, &plane);
  const int64_t k = multiple > 1 ? 0 : choose_height(random, plane.n, level);
  if (multiple > 1) {
    meet(random, &plane, crossing, multiple, p);
  } else if (!solve(&plane, k, crossing ? -1 : 0, p)) {
    return false;
  }
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  pair->a.kind = pair->b.kind = CASE_HULL;
  if (crossing) {
    append(&pair->a, combine(&plane, origin, 0, 0));
    append(&pair->a, combine(&plane, origin, 1, 0));
  } else {
    make_face(&plane, &pair->a);
  }
  make_upper(&plane, contact, p, &pair->b);
  if (thick) {
    double below[3], above[3];
    for (int i = 0; i < 3; i++) {
      below[i] = (double)plane.alpha * (double)plane.e[i] + (crossing ? 0 : (double)plane.beta * (double)plane.f[i]);
      above[i] = crossing ? (double)p[i] - (double)plane.beta * (double)plane.f[i] : (double)p[i];
    }
    thicken(random, &plane, plane.e, below, reach, -1, &pair->a);
    thicken(random, &plane, plane.f, above, reach, 1, &pair->b);
  }
  if (pair->a.count == 3 && random_below(random, 2) == 0) {
    pair->a.kind = CASE_TRIANGLE;
  }
  height->level = level;
  height->side = level == 0 ? (k > 0) - (k < 0) : compare_height(plane.n, k, level);
  height->bits = length_bits(plane.n, contact == GENERATE_FACE_FACE ? 4 : 1);
  pair->a.pose.position = pair->b.pose.position = generate_vector(random, (double)generate_reach(random));
  return fits(&pair->a) && fits(&pair->b);
}

void generate_smallest(random_state *random, generate_contact contact, int64_t level, bool thick, case_pair *pair,
                       generate_height *height) {
  bool done = false;
  while (!done) {
    const double reach = random_below(random, 4) == 0 ? (double)generate_reach(random) * 0.85 + 1000
                                                      : GENERATE_REACH_MAX * (0.8 + 0.2 * generate_unit(random));
    done = try_smallest(random, contact, level, thick, reach, pair, height);
  }
}

static void smallest(random_state *random, generate_contact contact, case_pair *pair) {
  generate_height height;
  generate_smallest(random, contact, 0, random_below(random, 2) == 0, pair, &height);
}

void generate_smallest_face_vertex(random_state *random, case_pair *pair) {
  smallest(random, GENERATE_FACE_VERTEX, pair);
}

void generate_smallest_face_face(random_state *random, case_pair *pair) {
  smallest(random, GENERATE_FACE_FACE, pair);
}

void generate_smallest_edge_edge(random_state *random, case_pair *pair) {
  smallest(random, GENERATE_EDGE_EDGE, pair);
}

void generate_smallest_rounded(random_state *random, case_pair *pair) {
  generate_height height;
  const generate_contact contact = (generate_contact)random_below(random, GENERATE_EDGE_EDGE + 1);
  const int64_t level = random_range(random, 2, 40);
  generate_smallest(random, contact, level, random_below(random, 2) == 0, pair, &height);
  pair->a.convex_radius = random_range(random, 0, (int32_t)(level / 2));
  pair->b.convex_radius = (int32_t)(level / 2) - pair->a.convex_radius;
}
