// Roots, and angles by doubling them.
//
// An angle of (x, y) within a quarter of a turn, as a part of that quarter, has the binary digits 0.b1 b2 b3 ... Twice the
// angle is that of (x^2 - y^2, 2 x y). It has the digits b1.b2 b3 ...: b1 says whether it reaches a quarter, which is then
// taken off. So each doubling tells one digit. Rounding (x, y) at step k turns it by less than 2^-94. That is a part of
// 2^-k of the first angle, so all together they are off by less than 2^-93, whatever digits near a tie come out.
#include "gjk_big_angle.h"

#define ANGLE_DIGITS 84

// Bits of the larger of x and y at each step. Products then have at most 192 bits, sums of two 193.
#define ANGLE_BITS 96u

const gjk_big gjk_big_pi_q96 = {
    {UINT32_C(0x13198A2E), UINT32_C(0x85A308D3), UINT32_C(0x243F6A88), UINT32_C(3), 0, 0, 0, 0}};

// Bits of x: the least n with x < 2^n. Pre: x >= 0.
static unsigned big_bits(const gjk_big *x) {
  for (unsigned i = GJK_BIG_LIMBS; i > 0; i--) {
    if (x->limb[i - 1] != 0) {
      return 32u * i - gjk_clz32(x->limb[i - 1]);
    }
  }
  return 0;
}

// Digit by digit, in base 4: x is what the square of the root leaves, root holds twice the root so far.
void gjk_big_root(gjk_big *x) {
  gjk_big root, bit, sum;
  gjk_big_set(&root, 0);
  gjk_big_set(&bit, 1);
  gjk_big_shift_up(&bit, big_bits(x) & ~1u);
  while (!gjk_big_is_zero(&bit)) {  // at most 128 times
    gjk_big_copy(&sum, &root);
    gjk_big_add(&sum, &bit);
    gjk_big_shift_down(&root, 1);
    if (gjk_big_is_at_least(x, &sum)) {
      gjk_big_subtract(x, &sum);
      gjk_big_add(&root, &bit);
    }
    gjk_big_shift_down(&bit, 2);
  }
  gjk_big_copy(x, &root);
}

void gjk_big_length(gjk_big *x) {
  if (big_bits(x) <= 94) {
    gjk_big_shift_up(x, 2 * GJK_BIG_FRACTION);  // < 2^254
    gjk_big_root(x);
  } else {
    gjk_big_shift_up(x, 128);  // < 2^254
    gjk_big_root(x);
    gjk_big_shift_up(x, GJK_BIG_FRACTION - 64);
  }
}

// Scales (x, y) so that the larger one has ANGLE_BITS bits. Pre: both are at least 0, and one is above.
static void scale_to_angle_bits(gjk_big *x, gjk_big *y) {
  const unsigned bits = big_bits(gjk_big_is_at_least(x, y) ? x : y);
  if (bits > ANGLE_BITS) {
    gjk_big_shift_down(x, bits - ANGLE_BITS);
    gjk_big_shift_down(y, bits - ANGLE_BITS);
  } else {
    gjk_big_shift_up(x, ANGLE_BITS - bits);
    gjk_big_shift_up(y, ANGLE_BITS - bits);
  }
}

// Takes a quarter of a turn off: (y, -x).
static void turn_back(gjk_big *x, gjk_big *y) {
  gjk_big kept;
  gjk_big_copy(&kept, x);
  gjk_big_copy(x, y);
  gjk_big_set(y, 0);
  gjk_big_subtract(y, &kept);
}

// (x, y) = (x^2 - y^2, 2 x y).
static void double_angle(gjk_big *x, gjk_big *y) {
  gjk_big square, other;
  gjk_big_multiply(&square, x, x);
  gjk_big_multiply(&other, y, y);
  gjk_big_subtract(&square, &other);
  gjk_big_multiply(&other, x, y);
  gjk_big_copy(x, &square);
  gjk_big_copy(y, &other);
  gjk_big_add(y, &other);
}

static bool reaches_quarter(const gjk_big *x) {
  return gjk_big_is_negative(x) || gjk_big_is_zero(x);
}

void gjk_big_angle(const gjk_big *x_in, const gjk_big *y_in, gjk_big *out) {
  gjk_big x, y, digits, one;
  gjk_big_copy(&x, x_in);
  gjk_big_copy(&y, y_in);
  gjk_big_set(&digits, 0);
  gjk_big_set(&one, 1);
  for (int quarter = 0; quarter < 2 && reaches_quarter(&x); quarter++) {
    turn_back(&x, &y);
    gjk_big_add(&digits, &one);
  }
  for (int i = 0; i < ANGLE_DIGITS; i++) {
    gjk_big_add(&digits, &digits);
    if (!gjk_big_is_zero(&y)) {
      scale_to_angle_bits(&x, &y);
      double_angle(&x, &y);
      if (reaches_quarter(&x)) {
        turn_back(&x, &y);
        gjk_big_add(&digits, &one);
      }
    }
  }
  // digits pi / 2:  <= 2^85 2^98
  gjk_big_multiply(out, &digits, &gjk_big_pi_q96);
  gjk_big_shift_down(out, ANGLE_DIGITS + 1 + 96 - GJK_BIG_FRACTION);
}
