// Sine and cosine in integers.
//
//   1. Multiply |angle| by 1 / (4 pi): half of it, counted in turns, with 64 bits of fraction. Whole turns drop out.
//   2. Split the turn into the nearest quarter and the rest, r, from -pi/4 to pi/4 in radians.
//   3. With h = r^2 / 2 sum the nested Taylor series, of GJK_SINE_TERMS divisors each:
//        sin r = r (1 - h/3 (1 - h/10 (1 - h/21 (1 - h/36 (1 - h/55)))))         divisors k (2 k + 1), error < 2^-37
//        cos r = 1 - h (1 - h/6 (1 - h/15 (1 - h/28 (1 - h/45 (1 - h/66)))))     divisors (k + 1) (2 k + 1), < 2^-41
//   4. Turn (sine, cosine) by the quarter, and give the sine the sign of the angle.
//
// This is a header, so that the one function of each of its two users inlines it.
#ifndef GJK_SRC_SINE_H
#define GJK_SRC_SINE_H

#include "gjk/format.h"
#include "gjk_wide.h"

// 2^80 / (4 pi), in two words: what half an angle of 1 LSB is in units of 2^-96 turns.
#define GJK_HALF_TURNS_HIGH UINT64_C(0x145F306DC9C8)
#define GJK_HALF_TURNS_LOW UINT32_C(0x82A53F84)

// 2^32 pi / 4.
#define GJK_EIGHTH_TURN UINT32_C(3373259426)

#define GJK_SINE_TERMS 5

// a b / 2^33. It fits, since a, b < 2^32: numbers below 1/2 in Q33.
static uint32_t gjk_multiply_q33(uint32_t a, uint32_t b) {
  return (uint32_t)(gjk_umul32(a, b) >> 33);
}

// A term of the series, c h, and what follows.
static inline uint32_t gjk_sine_step(uint32_t c, uint32_t h, uint32_t sum) {
  const uint32_t term = gjk_umulh32(h, c);
  return term - gjk_multiply_q33(term, sum);
}

// A term of both series, sum[0] of the sine and sum[1] of the cosine.
static inline void gjk_sine_steps(const uint32_t c[2], uint32_t h, uint32_t sum[2]) {
  sum[0] = gjk_sine_step(c[0], h, sum[0]);
  sum[1] = gjk_sine_step(c[1], h, sum[1]);
}

// Both series, c0 h (1 - c1 h (1 - c2 h (...))), Q33. c: Q32, at most 1/3; h: Q33, at most pi^2 / 32. Within 1.3 LSB: the
// floors of the last step, one each way, are below 1; c is rounded; at most 1/9 of the error of earlier steps remains.
static inline void gjk_sine_series(const uint32_t c[GJK_SINE_TERMS][2], uint32_t h, uint32_t sum[2]) {
  sum[0] = sum[1] = 0;
#if GJK_SMALL || !GJK_64_BIT
  for (int i = GJK_SINE_TERMS - 1; i >= 0; i--) {
    gjk_sine_steps(c[i], h, sum);
  }
#else
  gjk_sine_steps(c[4], h, sum);
  gjk_sine_steps(c[3], h, sum);
  gjk_sine_steps(c[2], h, sum);
  gjk_sine_steps(c[1], h, sum);
  gjk_sine_steps(c[0], h, sum);
#endif
}

// Step 1: half an angle of this size as a part of a turn, in units of 2^-64; the error is below 1.
static inline uint64_t gjk_half_turns(uint32_t size) {
  return size * GJK_HALF_TURNS_HIGH + gjk_umulh32(size, GJK_HALF_TURNS_LOW);
}

// Steps 2 to 4: sine and cosine, Q30, of a turn in units of 2^-64. The turn has the sign of angle. Each result is within
// 1 LSB of the real one.
static void gjk_sine_cosine(gjk_angle angle, uint64_t turn, gjk_q30 *sine, gjk_q30 *cosine) {
  static const uint32_t terms[GJK_SINE_TERMS][2] = {{UINT32_C(1431655765), UINT32_C(715827883)},
                                                    {UINT32_C(429496730), UINT32_C(286331153)},
                                                    {UINT32_C(204522252), UINT32_C(153391689)},
                                                    {UINT32_C(119304647), UINT32_C(95443718)},
                                                    {UINT32_C(78090314), UINT32_C(65075262)}};
  // Step 2
  const uint64_t eighth = UINT64_C(1) << 61;
  const unsigned quarter = (unsigned)((turn + eighth) >> 62);
  const uint64_t rest = turn - ((uint64_t)quarter << 62);  // from -2^61 to below 2^61, modulo 2^64
  const bool below = rest >= eighth;
  // |rest| as a part of an eighth of a turn, Q32; of a negative rest, |rest| less 2^-64 turns.
  const uint32_t part = (uint32_t)((below ? ~rest : rest) >> 29);
  // |r|, Q32, within 0.9: part stands for the middle of all values that truncate to it.
  // The sum is below 2^64 pi / 4 + 2^32.
  const uint32_t half = UINT32_C(1) << 31;
  const uint32_t r = (uint32_t)((gjk_umul32(part, GJK_EIGHTH_TURN) + GJK_EIGHTH_TURN / 2 + half) >> 32);
  const uint32_t h = gjk_umulh32(r, r);
  uint32_t sum[2];
  gjk_sine_series(terms, h, sum);
  // Step 3: sin = r (1 - series), Q64 to Q30; cos = 1 - h (1 - series), Q33 to Q30.
  const uint64_t s_wide = ((uint64_t)r << 32) - (gjk_umul32(r, sum[0]) >> 1);
  const gjk_q30 s = (gjk_q30)((s_wide + (UINT64_C(1) << 33)) >> 34);
  const uint32_t drop = h - gjk_multiply_q33(h, sum[1]);
  const gjk_q30 c = (gjk_q30)(((UINT64_C(1) << 33) - drop + 4) >> 3);
  const gjk_q30 s_rest = below ? -s : s;
  // Step 4: a quarter turn takes (sine, cosine) to (cosine, -sine), half a turn to their opposites.
  const gjk_q30 s_turned = (quarter & 1u) != 0 ? c : s_rest, c_turned = (quarter & 1u) != 0 ? -s_rest : c;
  const bool opposite = (quarter & 2u) != 0;
  *sine = opposite != (angle < 0) ? -s_turned : s_turned;
  *cosine = opposite ? -c_turned : c_turned;
}

#endif
