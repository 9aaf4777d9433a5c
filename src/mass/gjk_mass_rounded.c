// Steiner's formula for moments.
//
// A body with a radius r falls into the body, a prism on each face, a wedge along each edge and a sector of a ball at
// each corner. A triangle of a face has a normal N, twice its area long. An edge e has the length L, and turns by an angle
// t between its faces. A corner has the solid angle w of its normals. Integrals of the normals alone vanish or join to
// simple ones, by the divergence theorem on the surface:
//   sum A n = 0, sum A c n' = V 1                            for faces of area A with the centre c
//   sum L int u = 0, sum L m (int u)' = sum A (1 - n n')     for edges with the middle m, over their normals u
//   sum L int u u' = sum L t (1 - d d') / 2                  for edges along d
//   sum v (int u)' = sum L t d d' / 2                        for corners v
// Let S, F, M be the sums of gjk_moments.h: over tetrahedra, over triangles with the weight |N|, over edges with L t, and
// over corners with w; S4 to S1. The integrals over the rounded body then are
//     6 volume = S4 + 3 r S3 + 3 r^2 S2 + 2 r^3 S1
//    24 first  = F4 + 4 r F3 + 6 r^2 F2 + 8 r^3 F1
//   120 second = M4 + 5 r M3 + 10 r^2 M2 + 20 r^3 M1 + (20 r^2 S4 + 40 r^3 S3 + 15 r^4 S2 + 8 r^5 S1) 1
//                - 20 r^3 sum N N' / |N| + 15 r^4 sum t e e' / L
// A flat body has its faces twice, and t = pi around; a segment has t = 2 pi; w = 2 pi less the angles of its faces.
//
// Bounds. A body is within a ball of 2^28, taken from one of its vertices; D <= 2^29 is how far the others are.
//   6 volume     < 2^89, in Q80 < 2^169
//   120 second   < 2^151, in Q80 and times 2^16 < 2^247; sums of five such numbers < 2^250
// Errors. All but S4, F4, M4 have one of Q80: |N| and L of 2^-80 or 2^-111 of themselves, t and face angles of 2^-79.
// The volume is at least pi r^2 D + 4 r^3. So of the inertia
//   n edges      n D 2^-79 r^2 D^2 / (2 volume)        <= n D^2 2^-81:  2^-8 for n < 2^15
//   n angles     n 2^-79 r^3 D^2 / (3 volume)          <= n r D 2^-82:  2^-7 for n < 2^18
//   the centre, which is taken to 2^-9 along each axis:  <= 2^-17 in all
#include "gjk_mass_rounded.h"

#include "../arith/gjk_big_angle.h"

void gjk_round_start(gjk_round_sums *sums, const gjk_vec3 *origin) {
  gjk_moments_start(&sums->solid, origin);
  gjk_moments_start(&sums->faces, origin);
  gjk_moments_start(&sums->edges, origin);
  gjk_moments_start(&sums->corners, origin);
  for (int i = 0; i < 6; i++) {
    gjk_big_set(&sums->normal[i], 0);
    gjk_big_set(&sums->along[i], 0);
  }
}

// *sum += factor r^power x, or its opposite. Pre: r >= 0.
static void add_round_term(gjk_big *sum, const gjk_big *x, int32_t factor, int32_t r, int power) {
  gjk_big product;
  gjk_big_copy(&product, x);
  gjk_big_scale(&product, gjk_magnitude32(factor));
  for (int i = 0; i < power; i++) {
    gjk_big_scale(&product, (uint32_t)r);
  }
  if (factor < 0) {
    gjk_big_subtract(sum, &product);
  } else {
    gjk_big_add(sum, &product);
  }
}

// solid.weight, first, second become 6 volume, 24 first and 120 second, Q80.
static void join_round(gjk_round_sums *s, int32_t r) {
  gjk_moments *all = &s->solid;
  gjk_big sphere;  // of the second moment, along each axis
  gjk_big_shift_up(&all->weight, GJK_BIG_FRACTION);
  gjk_big_set(&sphere, 0);
  add_round_term(&sphere, &all->weight, 20, r, 2);
  add_round_term(&sphere, &s->faces.weight, 40, r, 3);
  add_round_term(&sphere, &s->edges.weight, 15, r, 4);
  add_round_term(&sphere, &s->corners.weight, 8, r, 5);
  for (int i = 0; i < 6; i++) {
    gjk_big_shift_up(&all->second[i], GJK_BIG_FRACTION);
    add_round_term(&all->second[i], &s->faces.second[i], 5, r, 1);
    add_round_term(&all->second[i], &s->edges.second[i], 10, r, 2);
    add_round_term(&all->second[i], &s->corners.second[i], 20, r, 3);
    add_round_term(&all->second[i], &s->normal[i], -20, r, 3);
    add_round_term(&all->second[i], &s->along[i], 15, r, 4);
    if (i < 3) {
      gjk_big_add(&all->second[i], &sphere);
    }
  }
  for (int i = 0; i < 3; i++) {
    gjk_big_shift_up(&all->first[i], GJK_BIG_FRACTION);
    add_round_term(&all->first[i], &s->faces.first[i], 4, r, 1);
    add_round_term(&all->first[i], &s->edges.first[i], 6, r, 2);
    add_round_term(&all->first[i], &s->corners.first[i], 8, r, 3);
  }
  add_round_term(&all->weight, &s->faces.weight, 3, r, 1);
  add_round_term(&all->weight, &s->edges.weight, 3, r, 2);
  add_round_term(&all->weight, &s->corners.weight, 2, r, 3);
}

// *at = 24 first / (4 6 volume), in 2^-16 LSB, rounded down. False: it is farther away than the body can be.
static bool divide_round(const gjk_big *first, const gjk_big *volume, int64_t *at) {
  gjk_big quotient, whole;
  gjk_big_copy(&quotient, first);
  gjk_big_shift_up(&quotient, 16);
  gjk_big_copy(&whole, volume);
  gjk_big_scale(&whole, 4);
  gjk_big_divide(&quotient, &whole);
  *at = gjk_big_low(&quotient);
  gjk_big_set(&whole, *at);
  gjk_big_subtract(&quotient, &whole);
  return gjk_big_is_zero(&quotient) && gjk_magnitude64(*at) <= UINT64_C(1) << 46;
}

// From 120 second to the second moment about c / 2^8, of a mass of 1, times *whole:
//   2^16 120 second - 5 2^8 (c_i 24 first_j + c_j 24 first_i) + 20 c_i c_j 6 volume, by 20 2^16 6 volume
static void centre_round(gjk_moments *m, const int64_t c[3], gjk_big *whole) {
  gjk_big part, twenty;
  gjk_big_copy(&twenty, &m->weight);
  gjk_big_scale(&twenty, 20);
  for (int i = 0; i < 3; i++) {
    gjk_big_scale(&m->first[i], 5);
    gjk_big_shift_up(&m->first[i], 8);
  }
  for (int i = 0; i < 6; i++) {
    const unsigned p = gjk_entry_axis[i][0], q = gjk_entry_axis[i][1];
    gjk_big_shift_up(&m->second[i], 16);
    gjk_big_add_product(&m->second[i], &m->first[p], -c[q]);
    gjk_big_add_product(&m->second[i], &m->first[q], -c[p]);
    gjk_big_set(&part, 0);
    gjk_big_add_product(&part, &twenty, c[p]);
    gjk_big_add_product(&m->second[i], &part, c[q]);
  }
  gjk_big_copy(whole, &twenty);
  gjk_big_shift_up(whole, 16);
}

// The volume: *six / 6 in Q80, or that times pi.
static void set_round_volume(gjk_big *six, bool of_pi, gjk_mass *out) {
  gjk_big whole, product;
  gjk_big_set(&whole, 6);
  if (of_pi) {
    gjk_big_shift_down(six, 24);                       // < 2^145
    gjk_big_multiply(&product, six, &gjk_big_pi_q96);  // < 2^243
    gjk_big_shift_up(&whole, GJK_BIG_FRACTION - 24 + 96);
    gjk_set_volume(&product, &whole, &out->volume);
  } else {
    gjk_big_shift_up(&whole, GJK_BIG_FRACTION);
    gjk_set_volume(six, &whole, &out->volume);
  }
}

bool gjk_round_finish(gjk_round_sums *sums, int32_t radius, bool of_pi, gjk_mass *out) {
  gjk_moments *all = &sums->solid;
  const int32_t origin[3] = {all->origin.x, all->origin.y, all->origin.z};
  int64_t at[3], c[3];
  gjk_big whole;
  join_round(sums, radius);
  if (gjk_big_is_negative(&all->weight) || gjk_big_is_zero(&all->weight)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    if (!divide_round(&all->first[i], &all->weight, &at[i])) {
      return false;
    }
    c[i] = gjk_sar64(at[i] + 128, 8);
    at[i] += gjk_shl64(origin[i], 16);
  }
  centre_round(all, c, &whole);
  gjk_inertia_of_second(all->second);
  gjk_set_inertia(all->second, &whole, &out->inertia);
  gjk_set_centre(at, out);
  set_round_volume(&all->weight, of_pi, out);
  out->mass = 0;
  return true;
}
