// Closed forms, as polynomials in a shape's lengths with coefficients p + q pi.
//
// A box of half extents a, b, c with a radius r falls into the box and slabs of thickness r on its sides. Quarters of
// cylinders lie along its edges, octants of a ball at its corners. A quarter of a disc has its centre 4 r / (3 pi) from
// each of its sides, an octant of a ball 3 r / 8. So the volume V and the integral X of x^2 are
//   3 V  = 24 (a b c + r (a b + b c + c a)) + pi (6 r^2 (a + b + c) + 4 r^3)
//   60 X = 160 (a^3 b c + a^3 r (b + c) + b c r (3 a^2 + 3 a r + r^2)) + 320 a r^3 (b + c)
//          + pi (40 a^3 r^2 + (b + c) (120 a^2 r^2 + 30 r^4) + 80 a^2 r^3 + 60 a r^4 + 16 r^5)
//
// A rounded cylinder has a radius a and a half length b. It reaches up to b + r within a of its axis, and to b + s at
// a + u, with s^2 = r^2 - u^2. The integrals over u from 0 to r, divided by pi, with X across and Z along the axis:
//   3 V   = 6 a^2 b + 6 a^2 r + 12 a b r + 6 b r^2 + 4 r^3 + pi 3 a r^2
//   120 X = 60 a^4 b + 60 a^4 r + 240 a^3 b r + 360 a^2 b r^2 + 240 a b r^3 + 60 b r^4 + 240 a^2 r^3 + 32 r^5
//           + pi (60 a^3 r^2 + 45 a r^4)
//   120 Z = 80 a^2 (b + r)^3 + 160 a (b^3 r + 2 b r^3) + 80 b^3 r^2 + 160 b^2 r^3 + 120 b r^4 + 32 r^5
//           + pi (120 a b^2 r^2 + 30 a r^4)
//
// Lengths are below 2^28. Each coefficient sum is below 2^12, so 60 X and 120 X < 2^152; in units of 2^-61, < 2^215.
#include "gjk_mass_round.h"

// pi 2^61, to the nearest.
#define PI_Q61 INT64_C(0x6487ED5110B4611A)

// factor times the product of the lengths, each to its power: four bits each, the last length in the lowest.
typedef struct mass_term {
  uint16_t factor, powers;
} mass_term;

typedef struct mass_polynomial {
  const mass_term *plain, *of_pi;
  uint8_t plain_count, of_pi_count;
} mass_polynomial;

#define TERMS(terms) ((uint8_t)(sizeof(terms) / sizeof(terms)[0]))
#define MASS_POLYNOMIAL(name) \
  { name, name##_pi, TERMS(name), TERMS(name##_pi) }

// *out = the sum of terms.
static void sum_terms(const mass_term *terms, unsigned count, const int32_t length[4], gjk_big *out) {
  gjk_big_set(out, 0);
  for (unsigned i = 0; i < count; i++) {
    gjk_big product;
    gjk_big_set(&product, terms[i].factor);
    for (unsigned j = 0; j < 4; j++) {
      for (unsigned power = terms[i].powers >> (12 - 4 * j) & 15u; power > 0; power--) {
        gjk_big_scale(&product, (uint32_t)length[j]);
      }
    }
    gjk_big_add(out, &product);
  }
}

// *out = 2^61 times the polynomial's value.
static void evaluate(const mass_polynomial *p, const int32_t length[4], gjk_big *out) {
  gjk_big of_pi;
  sum_terms(p->plain, p->plain_count, length, out);
  gjk_big_scale(out, UINT32_C(1) << 30);
  gjk_big_scale(out, UINT32_C(1) << 31);
  sum_terms(p->of_pi, p->of_pi_count, length, &of_pi);
  gjk_big_add_product(out, &of_pi, PI_Q61);
}

// Writes centre 0 and the inertia of a shape that is symmetric about its axes, from the mean squares of x, y, z times
// whole.
static void set_symmetric(gjk_big square[3], const gjk_big *whole, gjk_mass *out) {
  static const int64_t origin[3] = {0, 0, 0};
  gjk_big second[6];
  for (int i = 0; i < 3; i++) {
    gjk_big_copy(&second[i], &square[i]);
    gjk_big_set(&second[i + 3], 0);
  }
  gjk_inertia_of_second(second);
  gjk_set_inertia(second, whole, &out->inertia);
  gjk_set_centre(origin, out);
  out->mass = 0;
}

// The same from lengths that are not rounded: the mean square is factor length^2 / 60.
static void set_simple(const uint8_t factor[3], const int32_t length[3], gjk_mass *out) {
  gjk_big square[3], whole;
  for (int i = 0; i < 3; i++) {
    gjk_big_set(&square[i], factor[i] * gjk_mul32(length[i], length[i]));  // < 2^5 2^56
  }
  gjk_big_set(&whole, 60);
  set_symmetric(square, &whole, out);
}

// Writes the volume: three times it is *triple / 2^61.
static void set_third(gjk_big *triple, gjk_mass *out) {
  gjk_big three;
  gjk_big_set(&three, INT64_C(3) << 61);
  gjk_set_volume(triple, &three, &out->volume);
}

// Writes the volume pi factor a b c / 3.
static void set_pi_volume(uint16_t factor, int32_t a, int32_t b, int32_t c, gjk_mass *out) {
  const mass_term one = {factor, 0x1110};
  const int32_t length[4] = {a, b, c, 0};
  gjk_big product, triple;
  sum_terms(&one, 1, length, &product);
  gjk_big_set(&triple, 0);
  gjk_big_add_product(&triple, &product, PI_Q61);
  set_third(&triple, out);
}

void gjk_mass_of_axes(const int32_t half[3], int32_t radius, gjk_mass *out) {
  static const uint8_t thirds[3] = {20, 20, 20};
  // Powers of a, b, c, r.
  static const mass_term box_volume[] = {{24, 0x1110}, {24, 0x1101}, {24, 0x0111}, {24, 0x1011}};
  static const mass_term box_volume_pi[] = {{6, 0x1002}, {6, 0x0102}, {6, 0x0012}, {4, 0x0003}};
  static const mass_term box_square[] = {{160, 0x3110}, {160, 0x3101}, {160, 0x3011}, {480, 0x2111},
                                         {480, 0x1112}, {160, 0x0113}, {320, 0x1103}, {320, 0x1013}};
  static const mass_term box_square_pi[] = {{40, 0x3002}, {120, 0x2102}, {30, 0x0104}, {120, 0x2012},
                                            {30, 0x0014}, {80, 0x2003},  {60, 0x1004}, {16, 0x0005}};
  static const mass_polynomial volume_of_box = MASS_POLYNOMIAL(box_volume);
  static const mass_polynomial square_in_box = MASS_POLYNOMIAL(box_square);
  gjk_big square[3], triple;
  for (unsigned i = 0; i < 3; i++) {
    const unsigned j = gjk_next(i);
    const int32_t length[4] = {half[i], half[j], half[gjk_next(j)], radius};
    evaluate(&square_in_box, length, &square[i]);
    evaluate(&volume_of_box, length, &triple);  // the same for each i
  }
  if (radius > 0) {
    gjk_big whole;
    gjk_big_copy(&whole, &triple);
    gjk_big_scale(&whole, 20);
    set_symmetric(square, &whole, out);  // X / V = 60 X / (20 3 V)
  } else {
    set_simple(thirds, half, out);
  }
  set_third(&triple, out);
}

void gjk_mass_of_cylinder(int32_t base_radius, int32_t half, int32_t radius, gjk_mass *out) {
  static const uint8_t factors[3] = {15, 15, 20};
  // Powers of a, b, r.
  static const mass_term cylinder_volume[] = {{6, 0x210}, {6, 0x201}, {12, 0x111}, {6, 0x012}, {4, 0x003}};
  static const mass_term cylinder_volume_pi[] = {{3, 0x102}};
  static const mass_term cylinder_across[] = {{60, 0x410},  {60, 0x401}, {240, 0x311}, {360, 0x212},
                                              {240, 0x113}, {60, 0x014}, {240, 0x203}, {32, 0x005}};
  static const mass_term cylinder_across_pi[] = {{60, 0x302}, {45, 0x104}};
  static const mass_term cylinder_along[] = {{80, 0x230},  {240, 0x221}, {240, 0x212}, {80, 0x203},  {160, 0x131},
                                             {320, 0x113}, {80, 0x032},  {160, 0x023}, {120, 0x014}, {32, 0x005}};
  static const mass_term cylinder_along_pi[] = {{120, 0x122}, {30, 0x104}};
  static const mass_polynomial volume_of_cylinder = MASS_POLYNOMIAL(cylinder_volume);
  static const mass_polynomial square_across = MASS_POLYNOMIAL(cylinder_across);
  static const mass_polynomial square_along = MASS_POLYNOMIAL(cylinder_along);
  const int32_t length[4] = {0, base_radius, half, radius}, simple[3] = {base_radius, base_radius, half};
  gjk_big square[3], triple, of_pi;
  evaluate(&volume_of_cylinder, length, &triple);
  if (radius > 0) {
    gjk_big whole;
    evaluate(&square_across, length, &square[0]);
    gjk_big_copy(&square[1], &square[0]);
    evaluate(&square_along, length, &square[2]);
    gjk_big_copy(&whole, &triple);
    gjk_big_scale(&whole, 40);
    set_symmetric(square, &whole, out);  // X / V = 120 X / (40 3 V)
  } else {
    set_simple(factors, simple, out);
  }
  gjk_big_set(&of_pi, PI_Q61);
  gjk_big_multiply(&square[0], &triple, &of_pi);  // in units of 2^-122:  < 2^(93 + 61 + 63)
  gjk_big_set(&of_pi, 1);
  for (int i = 0; i < 2; i++) {
    gjk_big_scale(&of_pi, UINT32_C(1) << 30);
    gjk_big_scale(&of_pi, UINT32_C(1) << 31);
  }
  gjk_big_scale(&of_pi, 3);
  gjk_set_volume(&square[0], &of_pi, &out->volume);
}

void gjk_mass_of_cone(int32_t base_radius, int32_t half, gjk_mass *out) {
  static const uint8_t factors[3] = {9, 9, 9};
  const int32_t length[3] = {base_radius, base_radius, half};
  const int64_t centre[3] = {0, 0, -gjk_shl64(half, 15)};  // a quarter of the way up from the base: z = -half / 2
  set_simple(factors, length, out);
  gjk_set_centre(centre, out);
  set_pi_volume(2, base_radius, base_radius, half, out);
}

void gjk_mass_of_ellipsoid(const int32_t radius[3], gjk_mass *out) {
  static const uint8_t fifths[3] = {12, 12, 12};
  set_simple(fifths, radius, out);
  set_pi_volume(4, radius[0], radius[1], radius[2], out);
}
