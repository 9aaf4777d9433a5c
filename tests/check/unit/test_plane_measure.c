// The plane's lengths, distances and weights against exact arithmetic: ends of the ranges, exact ties, squares and what lies
// next to them.
#include "src/plane/gjk2_measure.h"

#include <math.h>

#include "check.h"
#include "random.h"
#include "wide_root.h"

#define TRIALS 200000
#define LENGTH_MAX 1610612736.0  // 3 2^29

static unsigned long ties;

// Integers of all sizes up to 2^bits, often a power of two or next to one.
static uint64_t any_size(random_state *random, unsigned bits) {
  const uint64_t x = random_u64(random) >> (64 - 1 - random_below(random, bits));
  return random_below(random, 4) != 0 ? x : (UINT64_C(1) << random_below(random, bits)) - random_below(random, 2);
}

static int32_t any_component(random_state *random, unsigned bits) {
  const int32_t x = (int32_t)any_size(random, bits);
  return random_below(random, 2) != 0 ? x : -x;
}

// A vector that is not 0; one in four has an integer length.
static gjk2_vec any_vector(random_state *random) {
  for (;;) {
    const unsigned bits = 1 + random_below(random, 30);
    gjk2_vec n = {any_component(random, bits), any_component(random, bits)};
    if (random_below(random, 4) == 0) {
      const int32_t unit = any_component(random, 28);
      n.x = 3 * unit;
      n.y = random_below(random, 2) != 0 ? 4 * unit : 0;
    }
    if ((n.x != 0 || n.y != 0) && hypot(n.x, n.y) <= LENGTH_MAX) {
      return n;
    }
  }
}

static void check_root(random_state *random) {
  const uint64_t r = any_size(random, 31), squared = r * r;
  const uint64_t of[] = {squared - (r > 0), squared, squared + r, squared + 2 * r, any_size(random, 62)};
  for (unsigned i = 0; i < sizeof of / sizeof of[0]; i++) {
    const uint64_t x = of[i] >> 62 == 0 ? of[i] : squared;
    for (int near = -10; near <= 10; near++) {
      const uint64_t guess = r + (uint64_t)near;
      const uint32_t root = gjk2_root(x, guess >> 31 == 0 ? (uint32_t)guess : (uint32_t)(r >> (near + 10)));
      CHECK((uint64_t)root * root <= x && (wide_square)(root + UINT64_C(1)) * (root + UINT64_C(1)) > x);
    }
  }
}

// Is h / |n| at least k / 2? Pre: h and squared = |n|^2 are below 2^62, k below 2^32.
static bool reaches_half(uint64_t h, uint64_t k, uint64_t squared) {
  return 4 * (wide_square)h * h >= (wide_square)k * k * squared;  // both below 2^126
}

static void check_distance(random_state *random) {
  const gjk2_vec n = any_vector(random);
  gjk2_length length;
  gjk2_unit unit, alone;
  gjk2_length_set(&length, n);
  gjk2_normal_set(&unit, &length, &n);
  gjk2_unit_set(&alone, &length, n);
  const double size = hypot(n.x, n.y);
  CHECK(length.squared == (uint64_t)((int64_t)n.x * n.x + (int64_t)n.y * n.y));
  CHECK(fabs(ldexp(size * length.inverse, (int)length.zeros - 62) - 1) <= 1.0 / (1 << 29));
  CHECK(fabs(unit.x - n.x / size * GJK_Q30_ONE) <= 2 && fabs(unit.y - n.y / size * GJK_Q30_ONE) <= 2);
  CHECK(fabs(alone.x - n.x / size * GJK_Q30_ONE) <= 2 && fabs(alone.y - n.y / size * GJK_Q30_ONE) <= 2);
  const uint32_t above = gjk2_length_bound(n);
  CHECK(above >= size && above <= size * 9 / 8 + 2);
  // h is any, or as near as an integer comes to a whole or half distance.
  const uint64_t halves = any_size(random, 31);
  uint64_t h = any_size(random, 62);
  if (random_below(random, 4) != 0) {
    h = (uint64_t)wide_root((wide_square)halves * halves * length.squared / 4) + random_below(random, 3) - (halves > 1);
  }
  if ((double)h > 9.0 * (1 << 29) * (1 << 29) || (double)h / size > LENGTH_MAX) {
    return;
  }
  const uint64_t down = (uint64_t)gjk2_round_distance(&length, GJK2_ROUND_DOWN, h),
                 nearest = (uint64_t)gjk2_round_distance(&length, GJK2_ROUND_NEAREST, h),
                 up = (uint64_t)gjk2_round_distance(&length, GJK2_ROUND_UP, h);
  CHECK(down < UINT64_C(1) << 31 && reaches_half(h, 2 * down, length.squared) &&
        !reaches_half(h, 2 * down + 2, length.squared));
  CHECK(up == down + ((wide_square)h * h != (wide_square)down * down * length.squared));
  CHECK(nearest == down + reaches_half(h, 2 * down + 1, length.squared));
  ties += 4 * (wide_square)h * h == (wide_square)(2 * down + 1) * (2 * down + 1) * length.squared;
  for (int by = -1; by <= 1; by++) {
    const int64_t radius = (int64_t)down + by;
    CHECK(radius < 0 || gjk2_is_within((int64_t)h, n, (int32_t)radius) == (radius >= (int64_t)up));
  }
  unsigned shift;
  const uint64_t leading = gjk2_quotient(&length, &shift, h);
  const long double quotient = ldexpl((long double)leading, -(int)shift),
                    exact = (long double)h / sqrtl((long double)length.squared);
  CHECK(fabsl(quotient - exact) <= exact / (1 << 28) + ldexpl(1, -(int)shift));
}

static void check_reaches(random_state *random) {
  const uint64_t h = any_size(random, 62), squared = any_size(random, 62), rest = any_size(random, 63);
  const wide_square most = ((wide_square)h * h - (wide_square)rest) / (squared == 0 ? 1 : (wide_square)squared);
  const uint64_t x = most > 1 && most >> 61 == 0 ? (uint64_t)most + random_below(random, 3) - 1 : any_size(random, 62);
  CHECK(gjk2_reaches(h, squared, x, rest) == ((wide_square)h * h >= (wide_square)x * squared + rest));
}

static void check_weight(random_state *random) {
  const gjk2_vec n = any_vector(random);
  gjk2_length length;
  gjk2_length_set(&length, n);
  if (length.squared >> 62 != 0) {
    return;
  }
  const int64_t whole = (int64_t)length.squared,
                part = (int64_t)((wide_square)whole * random_below(random, 1001) / 1000);
  const int32_t coarse = gjk2_weight(&length, false, part), fine = gjk2_weight(&length, true, part);
  const long double exact = (long double)part / whole * 2147483648.0L;
  CHECK(fabsl(coarse - exact) <= exact / (1 << 27) + 1 && fabsl(fine - exact) <= 1);
}

int main(void) {
  random_state random = random_seed(check_seed(3511));
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    check_root(&random);
    check_distance(&random);
    check_reaches(&random);
    check_weight(&random);
  }
  CHECK(ties > TRIALS / 1000);
  printf("%lu exact ties\n", ties);
  return check_done("plane measure");
}
