// Roots and angles of 80 fraction bits: by their squares exactly, by sums of angles that are known, and in long double.
#include <math.h>

#include "../../../src/arith/gjk_big_angle.h"
#include "check.h"
#include "random.h"

#define MOST_BITS 31

static gjk_big from(int64_t value) {
  gjk_big x;
  gjk_big_set(&x, value);
  return x;
}

// |a - b| <= size
static bool is_near(const gjk_big *a, const gjk_big *b, int64_t size) {
  gjk_big rest = *a, low = from(size);
  gjk_big_subtract(&rest, b);
  gjk_big_add(&rest, &low);
  gjk_big_scale(&low, 2);
  return !gjk_big_is_negative(&rest) && gjk_big_is_at_least(&low, &rest);
}

static gjk_big angle_of(int64_t x, int64_t y) {
  const gjk_big a = from(x), b = from(y);
  gjk_big angle;
  gjk_big_angle(&a, &b, &angle);
  return angle;
}

// pi 2^(80 + bits), rounded down
static gjk_big pi_times(unsigned bits) {
  gjk_big pi = gjk_big_pi_q96;
  gjk_big_shift_down(&pi, 96 - GJK_BIG_FRACTION - bits);
  return pi;
}

static void test_shifts(void) {
  random_state random = {7};
  for (unsigned long trial = 0; trial < 2000; trial++) {
    const unsigned bits = random_below(&random, 256);
    const unsigned shift = 1 + random_below(&random, 63);
    const int64_t value = (int64_t)(random_u64(&random) >> shift);
    gjk_big x = from(value), y = from(value);
    check_trial(trial, NULL, NULL);
    gjk_big_shift_up(&x, bits);
    for (unsigned i = 0; i < bits; i++) {
      gjk_big_add(&y, &y);
    }
    CHECK(is_near(&x, &y, 0));
    if (bits < 192) {
      gjk_big_shift_down(&x, bits);
      y = from(value);
      CHECK(is_near(&x, &y, 0));
    }
    const unsigned down = bits % 64;
    gjk_big_shift_down(&y, down);
    CHECK(bits >= 192 || gjk_big_low(&y) == value >> down);
  }
}

static void test_roots(uint64_t seed) {
  random_state random = random_seed(seed);
  for (unsigned long trial = 0; trial < 5000; trial++) {
    const unsigned bits = trial < 254 ? (unsigned)trial : random_below(&random, 255);
    gjk_big x, root, square, step;
    check_trial(trial, NULL, NULL);
    for (int i = 0; i < GJK_BIG_LIMBS; i++) {
      x.limb[i] = trial % 5 == 0 ? UINT32_MAX : random_u32(&random);
    }
    gjk_big_shift_down(&x, 1);
    gjk_big_shift_down(&x, 255 - bits);
    root = x;
    gjk_big_root(&root);
    gjk_big_multiply(&square, &root, &root);
    CHECK(gjk_big_is_at_least(&x, &square));
    gjk_big_subtract(&x, &square);  // at most 2 root
    step = root;
    gjk_big_add(&step, &step);
    CHECK(gjk_big_is_at_least(&step, &x));
  }
  // A length of either precision: the squares of its neighbours enclose it.
  for (unsigned long trial = 0; trial < 2000; trial++) {
    const unsigned bits = 1 + random_below(&random, 126), fraction = bits <= 94 ? 80 : 64;
    gjk_big x = from((int64_t)(random_u64(&random) >> 2)), length, square, one = from(1);
    const gjk_big other = from((int64_t)(random_u64(&random) >> 2));
    check_trial(trial, NULL, NULL);
    gjk_big_multiply(&length, &x, &other);
    gjk_big_shift_down(&length, 124 - (bits < 124 ? bits : 124));
    x = length;
    gjk_big_length(&length);
    gjk_big_shift_down(&length, GJK_BIG_FRACTION - fraction);
    gjk_big_multiply(&square, &length, &length);
    gjk_big_shift_up(&x, 2 * fraction);
    CHECK(gjk_big_is_at_least(&x, &square));
    gjk_big_add(&length, &one);
    gjk_big_multiply(&square, &length, &length);
    CHECK(!gjk_big_is_at_least(&x, &square));
  }
}

static void test_known_angles(void) {
  const gjk_big pi = pi_times(0), zero = from(0);
  gjk_big x = angle_of(5, 0), half = pi, quarter = pi;
  CHECK(is_near(&x, &zero, 0));
  x = angle_of(-1, 0);
  CHECK(is_near(&x, &pi, 0));
  gjk_big_shift_down(&half, 1);
  gjk_big_shift_down(&quarter, 2);
  x = angle_of(0, INT64_MAX);
  CHECK(is_near(&x, &half, 0));
  x = angle_of(77, 77);
  CHECK(is_near(&x, &quarter, 0));
  // Machin: pi / 4 = 4 atan(1/5) - atan(1/239)
  gjk_big four = angle_of(5, 1), one = angle_of(239, 1);
  gjk_big_scale(&four, 4);
  gjk_big_subtract(&four, &one);
  CHECK(is_near(&four, &quarter, 10));
  // Euler: pi / 4 = atan(1/2) + atan(1/3)
  four = angle_of(2, 1);
  one = angle_of(3, 1);
  gjk_big_add(&four, &one);
  CHECK(is_near(&four, &quarter, 4));
}

// The angle of a turn and of what it leaves of half a turn; of the sum of two angles; and the same in long double.
static void test_random_angles(uint64_t seed) {
  random_state random = random_seed(seed + 1);
  const gjk_big pi = pi_times(0);
  unsigned steep = 0;
  for (unsigned long trial = 0; trial < 2000; trial++) {
    const unsigned shift_x = random_below(&random, MOST_BITS), shift_y = random_below(&random, MOST_BITS);
    const int64_t x = random_range(&random, -INT32_MAX, INT32_MAX) >> shift_x;
    const int64_t y = random_range(&random, 1, INT32_MAX) >> shift_y;
    const int64_t p = random_range(&random, -999, 999), q = random_range(&random, 1, 999);
    check_trial(trial, NULL, NULL);
    if (y == 0) {
      continue;
    }
    gjk_big a = angle_of(x, y), b = angle_of(-x, y);
    const long double known = atan2l((long double)y, (long double)x);
    gjk_big top = a;
    gjk_big_shift_down(&top, GJK_BIG_FRACTION - 58);
    CHECK_MSG(fabsl(ldexpl((long double)gjk_big_low(&top), -58) - known) <= 0x1p-57L, "%lld %lld", (long long)x,
              (long long)y);
    gjk_big_add(&a, &b);
    CHECK(is_near(&a, &pi, 4));
    steep += (x < 0 ? -x : x) < y;
    // (x + i y) (p + i q), as long as it does not pass half a turn
    const int64_t re = x * p - y * q, im = x * q + y * p;
    if (im >= 0) {
      a = angle_of(x, y);
      b = angle_of(p, q);
      gjk_big_add(&a, &b);
      b = angle_of(re, im);
      CHECK(is_near(&a, &b, 4));
    }
  }
  CHECK_MSG(steep > 500 && steep < 1800, "%u", steep);
}

int main(void) {
  const uint64_t seed = check_seed(31);
  test_shifts();
  test_roots(seed);
  test_known_angles();
  test_random_angles(seed);
  return check_done("big angle");
}
