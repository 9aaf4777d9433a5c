// Products of a quotient and whole numbers, against the compiler's 128 bits.
#include "../../../src/motion/gjk_quotient.h"
#include "../../../src/plane_motion/gjk2_way.h"

#include "check.h"
#include "random.h"

#define SEED 93
#define TRIALS check_trials(400000)

__extension__ typedef unsigned __int128 wide;
__extension__ typedef __int128 wide_signed;

static wide random_wide(random_state *random, unsigned bits) {
  const wide x = (wide)random_u64(random) << 64 | random_u64(random);
  return bits == 0 ? 0 : x >> (128 - bits);
}

static gjk_u128 halves(wide x) {
  return (gjk_u128){(uint64_t)(x >> 64), (uint64_t)x};
}

// floor(x n / d), for |x| < 2^34, n <= d < 2^93
static int64_t product(int64_t x, wide n, wide d) {
  const wide_signed p = (wide_signed)n * x, q = (wide_signed)d;
  const wide_signed floor = p / q - (p % q < 0 ? 1 : 0);
  return (int64_t)floor;
}

static void check_quotient(wide n, wide d, int64_t x) {
  const gjk_u128 numerator = halves(n), denominator = halves(d);
  gjk_quotient q;
  gjk_quotient_set(&q, &numerator, &denominator);
  CHECK(q.one == (n == d));
  if (!q.one) {
    CHECK(q.high == (uint64_t)((n << 32) / d));
  }
  bool whole;
  CHECK(gjk_quotient_split(&q, x, &whole) == product(x, n, d));
  CHECK(whole == ((wide)(x < 0 ? -x : x) * n % d == 0));
  CHECK(gjk_quotient_floor(&q, x) == product(x, n, d));
  const int64_t half = x / 2;
  CHECK(gjk_quotient_nearest(&q, half) == product(2 * half, n, d) / 2 + (product(2 * half, n, d) % 2 > 0 ? 1 : 0));
}

// Fractions of ways in the plane: whole ones, any, and divisors of 33 bits, whose leading 32 are least exact.
static void check_ratio(random_state *random) {
  const uint32_t kind = random_below(random, 3);
  const uint64_t any = random_u64(random), part = random_below(random, (1u << 30) + 1);
  const uint64_t den = kind == 0 ? (any >> 31 | 1) << 30 : kind == 1 ? any >> 1 | 1 : (UINT64_C(1) << 32) + (any >> 33);
  const uint64_t num = kind == 0 ? (den >> 30) * part : kind == 1 ? random_u64(random) % (den + 1) : den - part;
  bool exact;
  CHECK((wide)gjk2_ratio(num, den, &exact) == ((wide)num << 30) / den);
  CHECK(exact == (((wide)num << 30) % den == 0));
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned long i = 0; i < TRIALS; i++) {
    const unsigned bits = 1 + random_below(&random, 93);
    wide d = random_wide(&random, bits) | 1;
    wide n = random_wide(&random, bits) % (d + 1);
    int64_t x = (int64_t)(random_u64(&random) >> (30 + random_below(&random, 34)));
    x = random_below(&random, 2) == 0 ? x : -x;
    if (random_below(&random, 3) == 0 && x != 0) {
      // a product that is whole, or off by the least there is
      const wide whole = (wide)(x < 0 ? -x : x);
      d = (random_wide(&random, 50) + 2) * whole;
      n = d / whole * (random_wide(&random, 30) % whole) + random_below(&random, 3);
      n = n > 0 ? n - 1 : n;
      n = n > d ? d : n;
    }
    check_trial(i, NULL, NULL);
    check_quotient(n, d, x);
    check_ratio(&random);
  }
  return check_done("quotient");
}
