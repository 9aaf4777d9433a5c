// The mass properties of rounded polygons.
//
// A polygon with a radius r falls into the polygon, a rectangle beside each edge, and a sector of a disc at each corner.
// An edge from a to b has the length L and s = a + b, a corner v turns by the angle t. The normals of all edges, times
// their lengths, sum up to 0; integrals of a sector's directions are differences of neighbouring edges' directions. So
// rectangles' and sectors' own moments join to sums over the whole outline:
//    2 area       = S + 2 r sum L + r^2 sum t
//    6 first      = F + 3 r sum L s + 3 r^2 sum t v
//   24 second     = M + 4 r sum L q + 24 r^2 S + 24 r^3 sum L + 12 r^2 sum t |v|^2 + 6 r^4 sum t
// for S, F, M as in gjk2_mass.c, and q = |s|^2 + |a|^2 + |b|^2. All is taken from the first vertex.
//
// L and t are irrational, in Q80, each at most 2^-79 too small. The angles' sum stands for 2 pi, so equal errors of a
// symmetric outline leave its centre exact. Bounds, with n corners, a reach of at most D <= 2^29 from the first vertex,
// r <= 2^28, and an area of at least 2 r D + pi r^2:
//   24 second    <= 24 2^58 2^58 < 2^121; in Q80 and times 2^32, < 2^233
//   area         is off by n (r 2^-79 + r^2 2^-80):  <= 2^-8
//   centre       the error n (r D 2^-80 + r^2 D 2^-80) of first, by the area:  <= n (2^-81 + r 2^-81) <= 2^-36
//   inertia      of second n (r D^2 + r^2 D^2 + ...) 2^-80, by the area:  <= n r D 2^-80 <= 2^-7
#include "../arith/gjk_big_angle.h"
#include "gjk2_moments.h"

typedef struct round_plane {
  gjk2_moments core, edges, corners;
} round_plane;

// *sum += factor r^power x. Pre: r >= 0.
static void add_power(gjk_big *sum, const gjk_big *x, uint32_t factor, int32_t r, int power) {
  gjk_big product;
  gjk_big_copy(&product, x);
  gjk_big_scale(&product, factor);
  for (int i = 0; i < power; i++) {
    gjk_big_scale(&product, (uint32_t)r);
  }
  gjk_big_add(sum, &product);
}

// The angle from edge e to edge f, Q80; of edges without length, those of a single vertex, a whole turn.
static void set_turn(gjk2_vec e, gjk2_vec f, gjk_big *out) {
  gjk_big x, y;
  const int64_t cosine = gjk2_dot(e, f), sine = gjk2_cross(e, f);
  if (cosine == 0 && sine == 0) {
    gjk_big_copy(out, &gjk_big_pi_q96);
    gjk_big_shift_down(out, 96 - GJK_BIG_FRACTION - 1);
    return;
  }
  gjk_big_set(&x, cosine);
  gjk_big_set(&y, sine);
  gjk_big_angle(&x, &y, out);
}

// Adds the edge from a to b, the triangle from the origin to it, and the corner b, after which c follows.
static void add_side(round_plane *sums, gjk2_vec a, gjk2_vec b, gjk2_vec c) {
  const gjk2_vec e = gjk2_sub(b, a), s = gjk2_add(a, b);
  const int64_t q = gjk2_moments_squares(a, b);
  gjk_big weight;
  gjk_big_set(&weight, gjk2_cross(a, b));
  gjk2_moments_add(&sums->core, &weight, s, q);
  gjk_big_set(&weight, gjk2_dot(e, e));
  gjk_big_length(&weight);
  gjk2_moments_add(&sums->edges, &weight, s, q);
  set_turn(e, gjk2_sub(c, b), &weight);
  gjk2_moments_add(&sums->corners, &weight, b, gjk2_dot(b, b));
}

// *twice = 2 area, first = 6 first, *second = 24 second, all Q80.
static void join_sides(round_plane *sums, int32_t r, gjk_big *twice, gjk_big first[2], gjk_big *second) {
  gjk_big_shift_up(&sums->core.weight, GJK_BIG_FRACTION);
  gjk_big_copy(twice, &sums->core.weight);
  add_power(twice, &sums->edges.weight, 2, r, 1);
  add_power(twice, &sums->corners.weight, 1, r, 2);
  for (int i = 0; i < 2; i++) {
    gjk_big_copy(&first[i], &sums->core.first[i]);
    gjk_big_shift_up(&first[i], GJK_BIG_FRACTION);
    add_power(&first[i], &sums->edges.first[i], 3, r, 1);
    add_power(&first[i], &sums->corners.first[i], 3, r, 2);
  }
  gjk_big_copy(second, &sums->core.second);
  gjk_big_shift_up(second, GJK_BIG_FRACTION);
  add_power(second, &sums->edges.second, 4, r, 1);
  add_power(second, &sums->core.weight, 24, r, 2);
  add_power(second, &sums->edges.weight, 24, r, 3);
  add_power(second, &sums->corners.second, 12, r, 2);
  add_power(second, &sums->corners.weight, 6, r, 4);
}

// From 24 second about the first vertex to the inertia about the centre c, which is at / 2^16. What c misses of the real
// centre, less than 2^-16, changes it by less than 2^-31.
//   24 (second - 2 c first + c^2 area) = 24 second + c (12 c 2 area - 8 6 first)
static int64_t inertia_about(const int64_t at[2], const gjk_big *twice, const gjk_big first[2], gjk_big *second) {
  gjk_big part, other;
  gjk_big_shift_up(second, 32);
  for (int i = 0; i < 2; i++) {
    gjk_big_copy(&part, &first[i]);
    gjk_big_scale(&part, 8);
    gjk_big_shift_up(&part, 16);
    gjk_big_copy(&other, twice);
    gjk_big_scale(&other, 12);
    gjk_big_add_product(second, &part, -at[i]);
    gjk_big_set(&part, 0);
    gjk_big_add_product(&part, &other, at[i]);
    gjk_big_add_product(second, &part, at[i]);
  }
  gjk_big_copy(&other, twice);
  gjk_big_scale(&other, 12);
  gjk_big_shift_up(&other, 32);
  return gjk_big_nearest(second, &other);
}

void gjk2_mass_of_rounded(const gjk2_vec *v, uint32_t count, int32_t radius, gjk2_mass *out) {
  round_plane sums;
  gjk_big twice, first[2], second, whole;
  int64_t at[2];
  gjk2_moments_start(&sums.core);
  gjk2_moments_start(&sums.edges);
  gjk2_moments_start(&sums.corners);
  for (uint32_t i = 0; i < count; i++) {
    const uint32_t next = i + 1 < count ? i + 1 : 0, after = next + 1 < count ? next + 1 : 0;
    add_side(&sums, gjk2_sub(v[i], v[0]), gjk2_sub(v[next], v[0]), gjk2_sub(v[after], v[0]));
  }
  join_sides(&sums, radius, &twice, first, &second);
  for (int i = 0; i < 2; i++) {
    gjk_big quotient;
    gjk_big_copy(&quotient, &first[i]);
    gjk_big_shift_up(&quotient, 16);
    gjk_big_copy(&whole, &twice);
    gjk_big_scale(&whole, 3);
    gjk_big_divide(&quotient, &whole);
    at[i] = gjk_big_low(&quotient);  // |at| <= 2^45
  }
  const int64_t inertia = inertia_about(at, &twice, first, &second);
  gjk_big_set(&whole, 1);
  gjk_big_shift_up(&whole, GJK_BIG_FRACTION + 1);
  gjk2_set_body((uint64_t)gjk_big_nearest(&twice, &whole), inertia, out);
  at[0] += gjk_shl64(v[0].x, 16);
  at[1] += gjk_shl64(v[0].y, 16);
  gjk2_set_centre(at, out);
}
