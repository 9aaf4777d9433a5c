// The sums of Steiner's formula for a cone, which is the limit of pyramids.
//
// A cone has a base radius a, a height h and a slant s, s^2 = a^2 + h^2. Its side has edges along all its slants: they turn
// by 2 pi h / s together. The base's rim has the length 2 pi a and turns by t, the angle of (-a, h). The apex has the solid
// angle 2 pi (1 - a / s), the rim the rest of 4 pi, spread evenly. From the middle of the base, with z along the axis, and
// divided by pi:
//            S                 F along z         M along z          M across
//   solid    2 a^2 h           2 a^2 h^2         4 a^2 h^3          6 a^4 h
//   faces    2 a s + 2 a^2     2 a h s           4 a h^2 s          6 a^3 s + 6 a^4
//   edges    2 h + 2 a t       2 h^2             4 h^3              2 a^2 h + 6 a^3 t
//   corners  4                 2 h (1 - a / s)   4 h^2 (1 - a / s)  2 a^2 (1 + a / s)
//   N N' / |N|    across a h^2 / s            along z 2 a^3 / s + 2 a^2
//   t e e' / L    across a^2 h / s^2 + a t    along z 2 h^3 / s^2
// Lengths are below 2^29, so products of four in Q80 < 2^200. s, 1 / s and t are off by 2^-79, or as much of themselves.
#include "../arith/gjk_big_angle.h"
#include "gjk_mass_rounded.h"

// a, h, and in Q80: 1, s, a / s, t.
typedef struct round_cone {
  int32_t a, h;
  gjk_big one, slant, ratio, turn;
} round_cone;

// *sum += factor a^p h^q x.
static void add_cone_term(const round_cone *k, gjk_big *sum, uint32_t factor, int p, int q, const gjk_big *x) {
  gjk_big product;
  gjk_big_copy(&product, x);
  gjk_big_scale(&product, factor);
  for (int i = 0; i < p; i++) {
    gjk_big_scale(&product, (uint32_t)k->a);
  }
  for (int i = 0; i < q; i++) {
    gjk_big_scale(&product, (uint32_t)k->h);
  }
  gjk_big_add(sum, &product);
}

static void set_cone(int32_t base_radius, int32_t half, round_cone *k) {
  gjk_big square, other;
  k->a = base_radius;
  k->h = 2 * half;  // < 2^29
  gjk_big_set(&k->one, 1);
  gjk_big_shift_up(&k->one, GJK_BIG_FRACTION);
  gjk_big_set(&k->slant, gjk_mul32(k->a, k->a) + gjk_mul32(k->h, k->h));
  gjk_big_length(&k->slant);
  gjk_big_set(&k->ratio, k->a);
  gjk_big_shift_up(&k->ratio, 2 * GJK_BIG_FRACTION);
  gjk_big_divide(&k->ratio, &k->slant);
  gjk_big_set(&square, -k->a);
  gjk_big_set(&other, k->h);
  gjk_big_angle(&square, &other, &k->turn);
}

static void add_cone_solid(const round_cone *k, gjk_moments *m) {
  gjk_big unit;
  gjk_big_set(&unit, 1);
  add_cone_term(k, &m->weight, 2, 2, 1, &unit);
  add_cone_term(k, &m->first[2], 2, 2, 2, &unit);
  add_cone_term(k, &m->second[2], 4, 2, 3, &unit);
  add_cone_term(k, &m->second[0], 6, 4, 1, &unit);
}

static void add_cone_faces(const round_cone *k, gjk_moments *m) {
  add_cone_term(k, &m->weight, 2, 1, 0, &k->slant);
  add_cone_term(k, &m->weight, 2, 2, 0, &k->one);
  add_cone_term(k, &m->first[2], 2, 1, 1, &k->slant);
  add_cone_term(k, &m->second[2], 4, 1, 2, &k->slant);
  add_cone_term(k, &m->second[0], 6, 3, 0, &k->slant);
  add_cone_term(k, &m->second[0], 6, 4, 0, &k->one);
}

static void add_cone_edges(const round_cone *k, gjk_moments *m) {
  add_cone_term(k, &m->weight, 2, 0, 1, &k->one);
  add_cone_term(k, &m->weight, 2, 1, 0, &k->turn);
  add_cone_term(k, &m->first[2], 2, 0, 2, &k->one);
  add_cone_term(k, &m->second[2], 4, 0, 3, &k->one);
  add_cone_term(k, &m->second[0], 2, 2, 1, &k->one);
  add_cone_term(k, &m->second[0], 6, 3, 0, &k->turn);
}

static void add_cone_corners(const round_cone *k, gjk_moments *m) {
  gjk_big apex, rim;
  gjk_big_copy(&apex, &k->one);
  gjk_big_subtract(&apex, &k->ratio);
  gjk_big_copy(&rim, &k->one);
  gjk_big_add(&rim, &k->ratio);
  add_cone_term(k, &m->weight, 4, 0, 0, &k->one);
  add_cone_term(k, &m->first[2], 2, 0, 1, &apex);
  add_cone_term(k, &m->second[2], 4, 0, 2, &apex);
  add_cone_term(k, &m->second[0], 2, 2, 0, &rim);
}

static void add_cone_directions(const round_cone *k, gjk_round_sums *sums) {
  gjk_big square, across, up;
  add_cone_term(k, &sums->normal[0], 1, 0, 2, &k->ratio);
  add_cone_term(k, &sums->normal[2], 2, 2, 0, &k->ratio);
  add_cone_term(k, &sums->normal[2], 2, 2, 0, &k->one);
  gjk_big_set(&square, gjk_mul32(k->a, k->a) + gjk_mul32(k->h, k->h));
  gjk_big_set(&across, 0);
  gjk_big_set(&up, 0);
  add_cone_term(k, &across, 1, 2, 1, &k->one);
  add_cone_term(k, &up, 2, 0, 3, &k->one);
  gjk_big_divide(&across, &square);
  gjk_big_divide(&up, &square);
  gjk_big_add(&sums->along[0], &across);
  gjk_big_add(&sums->along[2], &up);
  add_cone_term(k, &sums->along[0], 1, 1, 0, &k->turn);
}

void gjk_mass_of_rounded_cone(int32_t base_radius, int32_t half, int32_t radius, gjk_mass *out) {
  const gjk_vec3 base = {0, 0, -half};
  gjk_round_sums sums;
  round_cone k;
  set_cone(base_radius, half, &k);
  gjk_round_start(&sums, &base);
  add_cone_solid(&k, &sums.solid);
  add_cone_faces(&k, &sums.faces);
  add_cone_edges(&k, &sums.edges);
  add_cone_corners(&k, &sums.corners);
  add_cone_directions(&k, &sums);
  gjk_big_copy(&sums.solid.second[1], &sums.solid.second[0]);
  gjk_big_copy(&sums.faces.second[1], &sums.faces.second[0]);
  gjk_big_copy(&sums.edges.second[1], &sums.edges.second[0]);
  gjk_big_copy(&sums.corners.second[1], &sums.corners.second[0]);
  gjk_big_copy(&sums.normal[1], &sums.normal[0]);
  gjk_big_copy(&sums.along[1], &sums.along[0]);
  (void)gjk_round_finish(&sums, radius, true, out);
}
