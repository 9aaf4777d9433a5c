// Wide integers against other arithmetic: long double where its rounding is harmless, identities elsewhere.
#include <math.h>

#include "check.h"
#include "exact/integer.h"
#include "random_vec.h"
#include "src/arith/gjk_vector.h"

#define SEED 4096
#define TRIALS ((int)check_trials(200000))

static gjk_u128 random_u128(random_state *random, unsigned bits) {
  gjk_u128 x = {random_u64(random), random_u64(random)};
  for (unsigned i = bits; i < 128; i++) {
    x.low = (x.low >> 1) | (x.high << 63);
    x.high >>= 1;
  }
  return x;
}

static long double value(const gjk_u128 *x) {
  return ldexpl((long double)x->high, 64) + (long double)x->low;
}

static long double share_value(const gjk_barycentric *s) {
  return ldexpl((long double)s->high, 16) + (long double)s->low;
}

// Coarse shares are within 3 of 2^31 times the real ones, fine ones at most 1 below 2^47 times the real ones. Neither
// add up to more than 1.
static void check_shares(const gjk_u128 part[3], const char *what) {
  const long double sum = value(&part[0]) + value(&part[1]) + value(&part[2]);
  for (int fine = 0; fine < 2; fine++) {
    gjk_barycentric share[2];
    gjk_barycentrics(&part[0], &part[1], &part[2], fine == 1, share);
    for (int i = 0; i < 2; i++) {
      const long double real = ldexpl(value(&part[i + 1]) / sum, 47), found = share_value(&share[i]);
      const long double error = found - real;
      CHECK_MSG(fine == 1 ? error <= 0.01L && error > -1.01L : fabsl(error) <= 3 * 65536.0L, "%s, fine %d: %.3Lf off",
                what, fine, error);
      CHECK(share[i].high >= 0);
      CHECK(share[i].low >= 0);
      CHECK(share[i].low < 65536);
    }
    CHECK((int64_t)share[0].high + share[1].high <= INT32_MAX);
  }
}

static void test_shares(void) {
  random_state random = random_seed(check_seed(SEED));
  // A sum that is a power of two: the reciprocal of 2^31, 2^32, is the only one that needs 33 bits.
  for (unsigned bit = 2; bit < 127; bit++) {
    const gjk_u128 part[3] = {
        {bit - 2 > 63 ? UINT64_C(1) << (bit - 66) : 0, bit - 2 > 63 ? 0 : UINT64_C(1) << (bit - 2)},
        {bit - 1 > 63 ? UINT64_C(1) << (bit - 65) : 0, bit - 1 > 63 ? 0 : UINT64_C(1) << (bit - 1)},
        {bit - 2 > 63 ? UINT64_C(1) << (bit - 66) : 0, bit - 2 > 63 ? 0 : UINT64_C(1) << (bit - 2)}};
    check_shares(part, "power");
  }
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const unsigned bits = 2 + random_below(&random, 123);
    gjk_u128 part[3];
    for (int k = 0; k < 3; k++) {
      part[k] = random_u128(&random, bits - (unsigned)k * random_below(&random, bits / 3 + 1));
      part[k].low |= 1;
    }
    check_shares(part, "random");
  }
}

static int sign_of(long double x) {
  return (x > 0) - (x < 0);
}

// p q + r s with p q near -r s: (x + i)(y + j) - x y = i y + j x + i j for small i, j.
static void test_sums(void) {
  random_state random = random_seed(check_seed(SEED) + 1);
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const unsigned shift = random_below(&random, 60);
    const int64_t x = (int64_t)(random_u64(&random) >> 3) >> shift, y = (int64_t)(random_u64(&random) >> 3) >> shift;
    const int32_t a = random_range(&random, -2, 2), b = random_range(&random, -2, 2);
    const int sign = sign_of((long double)a * (long double)y + (long double)b * (long double)x + a * b);
    const int flip = i % 2 == 0 ? 1 : -1;
    CHECK(gjk_sum_of_products_sign_exact(flip * (x + a), y + b, x, -flip * y) == flip * sign);
    CHECK(gjk_sum_of_products_sign_exact(x, y, -(x + a), y + b) == -sign);
    gjk_u128 sum;
    gjk_sum_of_products(x, y, -x, y - 1, &sum);
    CHECK(sum.high == 0);
    CHECK(sum.low == (uint64_t)x);
  }
}

// The signed 128-bit integer with these halves.
static exact_int signed_value(const gjk_u128 *x) {
  const exact_int scale = exact_from(INT64_C(1) << 32), top = exact_from(gjk_int64(x->high));
  const exact_int middle = exact_from((int64_t)(x->low >> 32)), low = exact_from((int64_t)(x->low & UINT32_MAX));
  exact_int value = exact_mul(&top, &scale);
  value = exact_add(&value, &middle);
  value = exact_mul(&value, &scale);
  return exact_add(&value, &low);
}

static void check_sum(int64_t p, int64_t q, int64_t r, int64_t s) {
  const exact_int ep = exact_from(p), eq = exact_from(q), er = exact_from(r), es = exact_from(s);
  const exact_int pq = exact_mul(&ep, &eq), rs = exact_mul(&er, &es), expected = exact_add(&pq, &rs);
  gjk_u128 sum;
  gjk_sum_of_products(p, q, r, s, &sum);
  const exact_int found = signed_value(&sum);
  CHECK_MSG(exact_compare(&found, &expected) == 0, "%lld %lld + %lld %lld: high %llx low %llx", (long long)p,
            (long long)q, (long long)r, (long long)s, (unsigned long long)sum.high, (unsigned long long)sum.low);
}

// At the limits of the operands each product of digits is 2^62 in size, and four of them meet in the middle digit.
// Added in one chain they would overflow 64 bits.
static void test_sum_extremes(void) {
  static const int64_t size[] = {(INT64_C(1) << 62) - 1,
                                 (INT64_C(1) << 62) - INT32_MAX - 1,  // low digit 0
                                 (INT64_C(1) << 62) - INT32_MAX,
                                 (INT64_C(1) << 61) + INT32_MAX,
                                 INT64_C(1) << 31,
                                 INT32_MAX,
                                 1,
                                 0};
  const unsigned count = 2 * sizeof size / sizeof size[0];
  for (unsigned i = 0; i < count * count * count * count; i++) {
    int64_t x[4];
    for (unsigned k = 0, rest = i; k < 4; k++, rest /= count) {
      x[k] = rest % 2 == 0 ? size[rest % count / 2] : -size[rest % count / 2];
    }
    check_sum(x[0], x[1], x[2], x[3]);
  }
}

// The largest and smallest sums, by hand: 2 (2^62 - 1)^2 = 2^125 - 2^64 + 2.
static void test_largest_sums(void) {
  const int64_t most = (INT64_C(1) << 62) - 1;
  gjk_u128 sum;
  gjk_sum_of_products(most, most, -most, -most, &sum);
  CHECK(sum.high == UINT64_C(0x1FFFFFFFFFFFFFFF));
  CHECK(sum.low == 2);
  gjk_sum_of_products(most, -most, -most, most, &sum);
  CHECK(sum.high == UINT64_C(0xE000000000000000));
  CHECK(sum.low == UINT64_C(0xFFFFFFFFFFFFFFFE));
}

// (x + y)^2 - (x - y)^2 = 4 x y, in limbs.
static void test_limbs(void) {
  random_state random = random_seed(check_seed(SEED) + 2);
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const uint64_t x = random_u64(&random) >> (1 + random_below(&random, 63));
    const uint64_t y = random_below(&random, 4) == 0 ? x : random_u64(&random) >> (1 + random_below(&random, 63));
    const uint64_t larger = x > y ? x : y, smaller = x > y ? y : x;
    gjk_u192 a, b, sum, difference, product;
    gjk_u192_set(&a, x + y);
    gjk_u192_multiply(&sum, &a, &a);
    gjk_u192_set(&a, larger - smaller);
    gjk_u192_multiply(&difference, &a, &a);
    gjk_u192_set(&a, 2 * x);
    gjk_u192_set(&b, 2 * y);
    gjk_u192_multiply(&product, &a, &b);
    CHECK(gjk_u192_compare(&sum, &difference) == (x != 0 && y != 0));
    CHECK(gjk_u192_compare(&difference, &sum) == -(x != 0 && y != 0));
    gjk_u192_add(&difference, &product);
    CHECK(gjk_u192_compare(&sum, &difference) == 0);
  }
}

static void check_quotient(const gjk_u128 *x, const gjk_u128 *by, unsigned scale) {
  gjk_divisor divisor;
  unsigned k;
  gjk_divisor_set(&divisor, by);
  const int32_t m = gjk_divide(x, &divisor, scale, &k);
  const long double real = ldexpl(value(x) / value(by), (int)scale), found = ldexpl(m, -(int)k);
  CHECK(m >= 0);
  CHECK(k <= 32);
  CHECK_MSG(real >= 2147483648.0L ? found > 2147483000.0L : fabsl(found - real) <= ldexpl(real, -28) + ldexpl(1, -32),
            "%.10Lg instead of %.10Lg", found, real);
}

static void test_quotients(void) {
  random_state random = random_seed(check_seed(SEED) + 1);
  const gjk_u128 zero = {0, 0}, one = {0, 1}, most = {INT64_MAX, UINT64_MAX};
  check_quotient(&zero, &one, 30);
  check_quotient(&one, &one, 30);
  check_quotient(&one, &one, 31);
  check_quotient(&one, &one, 64);
  check_quotient(&most, &one, 0);
  check_quotient(&one, &most, 64);
  check_quotient(&most, &most, 30);
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const unsigned bits = 1 + random_below(&random, 127), less = random_below(&random, 70);
    gjk_u128 x = random_u128(&random, bits), by = random_u128(&random, bits > less ? bits - less : 1);
    by.low |= 1;
    check_quotient(&x, &by, random_below(&random, 65));
  }
}

static void test_magnitudes(void) {
  random_state random = random_seed(check_seed(SEED) + 2);
  for (int i = 0; i < 1000; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const int64_t high = gjk_int64(random_u64(&random)) >> random_below(&random, 64);
    const uint32_t low = random_below(&random, 4) == 0 ? 0 : random_u32(&random) >> 1;
    const long double real = fabsl(ldexpl((long double)high, 31) + low);
    gjk_u128 size;
    gjk_magnitude95(high, low, &size);
    CHECK_MSG(fabsl(value(&size) - real) <= ldexpl(real, -62), "%Lg instead of %Lg", value(&size), real);
  }
}

static void test_leading_zeros(void) {
  for (unsigned n = 0; n < 64; n++) {
    const uint64_t lowest = (UINT64_MAX >> n >> 1) + 1, highest = UINT64_MAX >> n;
    CHECK(gjk_clz64(lowest) == n && gjk_clz64(highest) == n);
    CHECK(n < 32 || (gjk_clz32((uint32_t)lowest) == n - 32 && gjk_clz32((uint32_t)highest) == n - 32));
  }
}

static void test_saturation(void) {
  static const struct {
    int64_t x;
    int32_t saturated;
  } cases[] = {{0, 0},
               {-1, -1},
               {INT32_MAX, INT32_MAX},
               {INT32_MIN, INT32_MIN},
               {(int64_t)INT32_MAX + 1, INT32_MAX},
               {(int64_t)INT32_MIN - 1, INT32_MIN},
               {INT64_C(1) << 32, INT32_MAX},
               {-(INT64_C(1) << 32), INT32_MIN},
               {INT64_MAX, INT32_MAX},
               {INT64_MIN, INT32_MIN}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    bool noted = false;
    CHECK(gjk_saturate(cases[i].x) == cases[i].saturated);
    CHECK(gjk_saturate_noting(cases[i].x, &noted) == cases[i].saturated);
    CHECK(noted == (cases[i].saturated != cases[i].x));
  }
}

// x / 2^k to the nearest integer, a tie up.
static int64_t nearest(int64_t x, unsigned k) {
  return k == 0 ? x : gjk_sar64(gjk_sar64(x, k - 1) + 1, 1);
}

// A direction is its normal / 2^k, rounded, with the least k that brings x and -1 - x below 2^30 for each component x.
static void check_direction(const gjk_long3 *n, unsigned long *halved, unsigned long *inexact) {
  const int64_t component[3] = {n->x, n->y, n->z};
  unsigned k = 0;
  gjk_search_direction d;
  for (int i = 0; i < 3; i++) {
    while (gjk_sar64(component[i], k + 30) != 0 && gjk_sar64(component[i], k + 30) != -1) {
      k++;
    }
  }
  bool exact = true;
  for (int i = 0; i < 3; i++) {
    exact = exact && gjk_shl64(gjk_sar64(component[i], k), k) == component[i];
  }
  gjk_search_direction_of(n, &d);
  CHECK(d.d.x == nearest(n->x, k) && d.d.y == nearest(n->y, k) && d.d.z == nearest(n->z, k));
  CHECK(d.exact == exact);
  *halved += k > 0;
  *inexact += !exact;
}

static void test_directions(void) {
  random_state random = random_seed(check_seed(SEED) + 3);
  unsigned long halved = 0, inexact = 0;
  const unsigned long trials = (unsigned long)TRIALS;
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    // |component| < 2^62; zeros at the low end in every other trial.
    const unsigned size = 2 + random_below(&random, 62), zeros = i % 2 == 0 ? 0 : random_below(&random, 62);
    const gjk_long3 n = {gjk_shl64(gjk_sar64(gjk_int64(random_u64(&random)), size + (zeros < 62 - size ? zeros : 0)),
                                   zeros < 62 - size ? zeros : 0),
                         gjk_sar64(gjk_int64(random_u64(&random)), size), 0};
    check_direction(&n, &halved, &inexact);
  }
  for (unsigned k = 28; k < 62; k++) {  // at the ends of a size
    const int64_t most = INT64_C(1) << k;
    for (int64_t off = -1; off <= 1; off++) {
      const gjk_long3 n = {most + (k < 61 ? off : -1), -most - (k < 61 ? off : -1), off};
      check_direction(&n, &halved, &inexact);
    }
  }
  CHECK(halved > trials / 4 && halved < trials * 3 / 4);
  CHECK(inexact > trials / 8 && inexact < halved);
}

// Products of the largest vectors, against wider integers.
static void test_products(void) {
  random_state random = random_seed(check_seed(SEED) + 4);
  unsigned long signs[3] = {0, 0, 0};
  const int trials = TRIALS / 10;
  for (int i = 0; i < trials; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const int32_t size = (INT32_C(1) << 30) / (i % 3 == 0 ? 1 : 1 << random_below(&random, 28));
    const gjk_vec3 a = random_in_cube(&random, size),
                   b = {random_range(&random, -size, size), random_range(&random, -size, size), 1},
                   v = i % 4 == 0 ? a : b;
    gjk_long3 n;
    gjk_cross(&a, &b, &n);
    CHECK(n.x == (int64_t)a.y * b.z - (int64_t)a.z * b.y);
    CHECK(n.y == (int64_t)a.z * b.x - (int64_t)a.x * b.z);
    CHECK(n.z == (int64_t)a.x * b.y - (int64_t)a.y * b.x);
    n.x += i % 2 == 0 ? 0 : (int64_t)random_below(&random, 3) - 1;
    const int64_t of_n[3] = {n.x, n.y, n.z}, of_v[3] = {v.x, v.y, v.z};
    exact_int sum = exact_from(0);
    for (int k = 0; k < 3; k++) {
      const exact_int left = exact_from(of_n[k]), right = exact_from(of_v[k]), product = exact_mul(&left, &right);
      sum = exact_add(&sum, &product);
    }
    CHECK(gjk_dot_sign(&n, &v) == sum.sign);
    signs[sum.sign + 1]++;
  }
  CHECK(signs[0] > (unsigned long)trials / 20 && signs[1] > (unsigned long)trials / 4 &&
        signs[2] > (unsigned long)trials / 20);
}

int main(void) {
  test_shares();
  test_sums();
  test_sum_extremes();
  test_largest_sums();
  test_limbs();
  test_quotients();
  test_magnitudes();
  test_leading_zeros();
  test_saturation();
  test_directions();
  test_products();
  return check_done("wide");
}
