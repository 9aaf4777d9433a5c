// Fixed-point numbers against real arithmetic: test_numbers [FIRST STEP].
//
// Functions of one number are tried at FIRST, FIRST + STEP ... of the 2^32 inputs, by default every 1021st; `make numbers` takes
// all of them. Functions of two numbers are tried at random ones, at halves between two results, and at all ends of ranges.
#include <math.h>

#include "gjk/number.h"
#include "gjk/pose.h"
#include "gjk2/pose.h"

#include "check.h"
#include "random.h"

#define STEP 1021
#define TRIALS 200000

static const double ONE_Q30 = 1073741824.0;
static const int32_t ends[] = {
    0,     1,     -1,     2,      -2,     32767,     32768,         -32768,    65535,
    65536, 65537, -65536, 205887, 205888, INT32_MAX, INT32_MAX - 1, INT32_MIN, INT32_MIN + 1};
#define ENDS (sizeof ends / sizeof ends[0])

static double worst_sine, worst_half;
static long double worst_atan;

static double larger(double a, double b) {
  return a > b ? a : b;
}

// double has the sine of any angle to 2^-52, which is 2^-22 LSB.
static void check_angle(gjk_angle angle) {
  const double exact = angle / 65536.0, s = sin(exact) * ONE_Q30, c = cos(exact) * ONE_Q30;
  gjk_q30 sine, cosine;
  gjk_sine_and_cosine(angle, &sine, &cosine);
  const double off = larger(fabs(s - sine), fabs(c - cosine));
  worst_sine = larger(worst_sine, off);
  CHECK(off <= 0.83);

  gjk2_rotation rotation;
  CHECK(gjk2_rotation_from_angle(angle, &rotation) == GJK_OK && rotation.s == sine && rotation.c == cosine);

  const gjk_vec3 z = {0, 0, 1};
  gjk_quat q;
  CHECK(gjk_quat_from_axis_angle(&z, angle, &q) == GJK_OK && q.x == 0 && q.y == 0);
  const double half = larger(fabs(sin(exact / 2) * ONE_Q30 - q.z), fabs(cos(exact / 2) * ONE_Q30 - q.w));
  worst_half = larger(worst_half, half);
  CHECK(half <= 1);
}

static void check_root(int32_t x) {
  const int64_t root = gjk_q16_sqrt(x);
  if (x <= 0) {
    CHECK(root == 0);
  } else {  // 4 (root - 1/2)^2 <= 4 x <= 4 (root + 1/2)^2
    const int64_t wide = (int64_t)x * 65536;
    CHECK((2 * root - 1) * (2 * root - 1) <= 4 * wide && 4 * wide <= (2 * root + 1) * (2 * root + 1));
  }
}

// Numbers of every size, and the ends of the range.
static int32_t any_number(random_state *random) {
  return random_below(random, 8) == 0 ? ends[random_below(random, ENDS)]
                                      : (int32_t)random_u32(random) >> random_below(random, 32);
}

static int64_t within(int64_t x) {
  return x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : x;
}

// a / b to the nearest, halves away from zero, for b > 0.
static int64_t nearest_quotient(int64_t a, int64_t b) {
  return a < 0 ? -((-a + b / 2) / b) : (a + b / 2) / b;
}

static unsigned long halves;

static void check_pair(gjk_q16 a, gjk_q16 b) {
  const int64_t product = (int64_t)a * b;
  CHECK(gjk_q16_multiply(a, b) == within(nearest_quotient(product, 65536)));
  halves += (product & 65535) == 32768;
  if (b == 0) {
    CHECK(gjk_q16_divide(a, b) == (a == 0 ? 0 : a < 0 ? INT32_MIN : INT32_MAX));
  } else {  // 2 |quotient| - 1 <= 2 |a| 2^16 / |b| < 2 |quotient| + 1, in integers
    const int64_t size = llabs((int64_t)b), scaled = llabs((int64_t)a) * 65536, quotient = gjk_q16_divide(a, b);
    const int64_t rounded = (2 * scaled + size) / (2 * size);
    CHECK(quotient == within((a < 0) != (b < 0) ? -rounded : rounded));
    halves += 2 * scaled % (2 * size) == size;
  }
  const long double off = fabsl(atan2l(a, b) * 65536 - gjk_atan2(a, b));
  worst_atan = fmaxl(worst_atan, off);
  CHECK(off <= 0.501L);
}

static void check_pairs(void) {
  random_state random = random_seed(check_seed(2027));
  for (unsigned i = 0; i < ENDS; i++) {
    for (unsigned j = 0; j < ENDS; j++) {
      check_pair(ends[i], ends[j]);
    }
  }
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    check_pair(any_number(&random), any_number(&random));
    // Halves: odd numbers times 2^15; and quotients by powers of two above 2^16.
    check_pair((gjk_q16)(random_u32(&random) | 1u), random_range(&random, -32767, 32767) | 32768);
    check_pair(any_number(&random),
               (random_below(&random, 2) == 0 ? 1 : -1) * (INT32_C(1) << random_below(&random, 31)));
  }
  CHECK(halves > TRIALS / 20);
  CHECK(gjk_atan2(0, 0) == 0 && gjk_atan2(0, 5) == 0 && gjk_atan2(0, -5) == GJK_ANGLE(3.14159265358979));
  CHECK(gjk_atan2(INT32_MIN, 0) == GJK_ANGLE(-1.5707963267949) && gjk_atan2(-1, INT32_MIN) == -205887);
}

int main(int argc, char **argv) {
  const uint64_t first = argc == 3 ? strtoull(argv[1], NULL, 10) : 0;
  const uint64_t step = argc == 3 ? strtoull(argv[2], NULL, 10) : STEP;
  if (step == 0) {
    return 2;
  }
  check_pairs();
  for (unsigned i = 0; i < ENDS; i++) {
    check_angle(ends[i]);
    check_root(ends[i]);
  }
  for (uint64_t i = first; i <= UINT32_MAX; i += step) {
    check_trial((unsigned long)i, NULL, NULL);
    const int32_t x = (int32_t)((int64_t)i + INT32_MIN);
    check_angle(x);
    check_root(x);
  }
  printf("worst of each %llu: sine %.4f LSB, of half an angle %.4f; atan2 %.5Lf\n", (unsigned long long)step,
         worst_sine, worst_half, worst_atan);
  return check_done("numbers");
}
