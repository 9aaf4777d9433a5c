// The sums of Steiner's formula over a hull's faces, edges and corners.
#include "../arith/gjk_big_angle.h"
#include "gjk_mass_rounded.h"

// Fraction bits of the sums normal and along while they grow: |N N'| / |N| < 2^62, t |e e'| / L < 2^34.
#define NORMAL_FRACTION 140
#define ALONG_FRACTION 110

// *sum += weight x x'.
static void add_outer(gjk_big sum[6], const gjk_big *weight, const int64_t x[3]) {
  for (int i = 0; i < 6; i++) {
    gjk_big product;
    gjk_big_set(&product, 0);
    gjk_big_add_product(&product, weight, x[gjk_entry_axis[i][0]]);
    gjk_big_add_product(&sum[i], &product, x[gjk_entry_axis[i][1]]);
  }
}

// *out = the length of a vector, Q80. Pre: components below 2^62.
static void set_length(const int64_t x[3], gjk_big *out) {
  gjk_big factor;
  gjk_big_set(out, 0);
  for (int i = 0; i < 3; i++) {
    gjk_big_set(&factor, x[i]);
    gjk_big_add_product(out, &factor, x[i]);
  }
  gjk_big_length(out);
}

static void set_components(const gjk_vec3 *a, const gjk_vec3 *b, int64_t e[3]) {
  const gjk_vec3 d = gjk_sub(*b, *a);
  e[0] = d.x;
  e[1] = d.y;
  e[2] = d.z;
}

// 2^bits / x, rounded down; 0 for x = 0.
static void set_reciprocal(const gjk_big *x, unsigned bits, gjk_big *out) {
  gjk_big_set(out, 0);
  if (!gjk_big_is_zero(x)) {
    gjk_big_set(out, 1);
    gjk_big_shift_up(out, bits);
    gjk_big_divide(out, x);
  }
}

// Takes the angle of a triangle at corner a from a's solid angle. length: of the normal, Q80.
static void take_angle(gjk_round_sums *sums, const gjk_big *length, const gjk_vec3 *a, const gjk_vec3 *b,
                       const gjk_vec3 *c) {
  const gjk_vec3 ab = gjk_sub(*b, *a), ac = gjk_sub(*c, *a);
  gjk_big cosine, angle, opposite;
  gjk_big_set(&cosine, gjk_dot(&ab, &ac));
  gjk_big_shift_up(&cosine, GJK_BIG_FRACTION);
  gjk_big_angle(&cosine, length, &angle);
  gjk_big_set(&opposite, 0);
  gjk_big_subtract(&opposite, &angle);
  gjk_moments_add(&sums->corners, &opposite, &a, 1);
}

// A triangle of a face, and the tetrahedron from the origin to it. False: that is above the triangle.
static bool add_round_triangle(gjk_round_sums *sums, const gjk_vec3 *const corner[3]) {
  gjk_long3 n;
  gjk_big length, reciprocal;
  gjk_triangle_normal(corner[0], corner[1], corner[2], &n);
  const int64_t normal[3] = {n.x, n.y, n.z};
  set_length(normal, &length);
  gjk_moments_add(&sums->faces, &length, corner, 3);
  set_reciprocal(&length, NORMAL_FRACTION + GJK_BIG_FRACTION, &reciprocal);
  add_outer(sums->normal, &reciprocal, normal);
  for (unsigned i = 0; i < 3; i++) {
    const unsigned j = gjk_next(i);
    take_angle(sums, &length, corner[i], corner[j], corner[gjk_next(j)]);
  }
  return gjk_moments_add_tetrahedron(&sums->solid, corner);
}

// The edge from a to b that turns by an angle, Q80. length: its own, Q80.
static void add_turn(gjk_round_sums *sums, const gjk_vec3 *a, const gjk_vec3 *b, const gjk_big *length,
                     const gjk_big *angle) {
  const gjk_vec3 *ends[2];
  gjk_big product;
  ends[0] = a;
  ends[1] = b;
  gjk_big_multiply(&product, length, angle);  // < 2^110 2^83
  gjk_big_shift_down(&product, GJK_BIG_FRACTION);
  gjk_moments_add(&sums->edges, &product, ends, 2);
  if (!gjk_big_is_zero(length)) {
    int64_t e[3];
    gjk_big_copy(&product, angle);
    gjk_big_shift_up(&product, ALONG_FRACTION);  // < 2^193
    gjk_big_divide(&product, length);
    set_components(a, b, e);
    add_outer(sums->along, &product, e);
  }
}

// The edge from a to b of a face on to c, and of the face across it on to d. The normals are N and M; N x M = L V along it,
// with V = -N (d - a) six times the volume of the tetrahedron. False: V < 0, the edge is reflex.
static bool add_round_edge(gjk_round_sums *sums, const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c,
                           const gjk_vec3 *d) {
  gjk_long3 n, m;
  int64_t e[3];
  gjk_big cosine, sine, length, factor, angle;
  uint32_t low;
  const gjk_vec3 beyond = gjk_sub(*a, *d);
  gjk_triangle_normal(a, b, c, &n);
  gjk_triangle_normal(b, a, d, &m);
  const int64_t high = gjk_dot_exact(&n, &beyond, &low);  // < 2^92
  if (high < 0) {
    return false;
  }
  set_components(a, b, e);
  set_length(e, &length);  // < 2^110
  gjk_big_set_long(&factor, high, low);
  gjk_big_multiply(&sine, &length, &factor);  // < 2^202
  gjk_big_set(&cosine, 0);
  gjk_big_set(&factor, n.x);
  gjk_big_add_product(&cosine, &factor, m.x);
  gjk_big_set(&factor, n.y);
  gjk_big_add_product(&cosine, &factor, m.y);
  gjk_big_set(&factor, n.z);
  gjk_big_add_product(&cosine, &factor, m.z);  // < 2^125
  gjk_big_shift_up(&cosine, GJK_BIG_FRACTION);
  gjk_big_angle(&cosine, &sine, &angle);
  add_turn(sums, a, b, &length, &angle);
  return true;
}

// The corner after an edge in the face that has the edge.
static bool find_across(const gjk_hull_faces *faces, uint16_t from, uint16_t to, uint16_t *beyond) {
  uint32_t first = 0;
  for (uint32_t face = 0; face < faces->count; face++) {
    const uint32_t end = faces->end[face];
    for (uint32_t i = first; i < end; i++) {
      const uint32_t next = i + 1 < end ? i + 1 : first, after = next + 1 < end ? next + 1 : first;
      if (faces->corner[i] == from && faces->corner[next] == to) {
        *beyond = faces->corner[after];
        return true;
      }
    }
    first = end;
  }
  return false;
}

// The edges of a face, each where its first end has the lower number. False: one has no face across, or is reflex.
static bool add_round_edges(gjk_round_sums *sums, const gjk_vec3 *v, const gjk_hull_faces *faces, uint32_t first,
                            uint32_t end) {
  for (uint32_t i = first; i < end; i++) {
    const uint32_t next = i + 1 < end ? i + 1 : first, after = next + 1 < end ? next + 1 : first;
    const uint16_t from = faces->corner[i], to = faces->corner[next];
    uint16_t beyond;
    if (from < to && (!find_across(faces, to, from, &beyond) ||
                      !add_round_edge(sums, &v[from], &v[to], &v[faces->corner[after]], &v[beyond]))) {
      return false;
    }
  }
  return true;
}

// Adds 2 pi, of which the angles of faces are taken.
static void add_whole_corner(gjk_round_sums *sums, const gjk_vec3 *v) {
  gjk_big turn;
  gjk_big_copy(&turn, &gjk_big_pi_q96);
  gjk_big_shift_down(&turn, 96 - GJK_BIG_FRACTION - 1);
  gjk_moments_add(&sums->corners, &turn, &v, 1);
}

static bool is_first_of_vertex(const gjk_hull_faces *faces, uint32_t at) {
  for (uint32_t i = 0; i < at; i++) {
    if (faces->corner[i] == faces->corner[at]) {
      return false;
    }
  }
  return true;
}

// *sum / 2^bits, rounded down.
static void lower_fraction(gjk_big sum[6], unsigned bits) {
  gjk_big unit;
  gjk_big_set(&unit, 1);
  gjk_big_shift_up(&unit, bits);
  for (int i = 0; i < 6; i++) {
    gjk_big_divide(&sum[i], &unit);
  }
}

static bool finish_polytope(gjk_round_sums *sums, int32_t radius, gjk_mass *out) {
  lower_fraction(sums->normal, NORMAL_FRACTION - GJK_BIG_FRACTION);
  lower_fraction(sums->along, ALONG_FRACTION - GJK_BIG_FRACTION);
  return gjk_round_finish(sums, radius, false, out);
}

gjk_status gjk_mass_of_rounded_faces(const gjk_vec3 *v, const gjk_hull_faces *faces, int32_t radius, gjk_mass *out) {
  gjk_round_sums sums;
  uint32_t first = 0;
  gjk_round_start(&sums, &v[faces->corner[0]]);
  for (uint32_t face = 0; face < faces->count; face++) {
    const uint32_t end = faces->end[face];
    const gjk_vec3 *corner[3];
    corner[0] = &v[faces->corner[first]];
    for (uint32_t i = first + 1; i + 1 < end; i++) {
      corner[1] = &v[faces->corner[i]];
      corner[2] = &v[faces->corner[i + 1]];
      if (!add_round_triangle(&sums, corner)) {
        return GJK_ERROR_RANGE;
      }
    }
    for (uint32_t i = first; i < end; i++) {
      if (is_first_of_vertex(faces, i)) {
        add_whole_corner(&sums, &v[faces->corner[i]]);
      }
    }
    if (!add_round_edges(&sums, v, faces, first, end)) {
      return GJK_ERROR_RANGE;
    }
    first = end;
  }
  return finish_polytope(&sums, radius, out) ? GJK_OK : GJK_ERROR_RANGE;
}

void gjk_mass_of_rounded_segment(const gjk_vec3 *a, const gjk_vec3 *b, int32_t radius, gjk_mass *out) {
  gjk_round_sums sums;
  gjk_big length, turn;
  int64_t e[3];
  gjk_round_start(&sums, a);
  set_components(a, b, e);
  set_length(e, &length);
  gjk_big_copy(&turn, &gjk_big_pi_q96);
  gjk_big_shift_down(&turn, 96 - GJK_BIG_FRACTION - 1);
  add_turn(&sums, a, b, &length, &turn);
  add_whole_corner(&sums, a);
  add_whole_corner(&sums, b);
  (void)finish_polytope(&sums, radius, out);
}
