// Checks a port's primitives against the same in plain C, for extreme and random operands.
#include "port.h"

#include "gjk/gjk.h"
#include "random.h"
#include "src/arith/gjk_vector.h"

#define RANDOM_ITERATIONS 500

static port_counts counts;
static void (*say)(const char *text);

static void check(bool good, const char *what) {
  if (good) {
    counts.passed++;
    return;
  }
  counts.failed++;
  say("failed: ");
  say(what);
  say("\n");
}

static unsigned plain_clz(uint32_t x) {
  unsigned n = 0;
  while ((x & UINT32_C(0x80000000)) == 0) {
    x <<= 1;
    n++;
  }
  return n;
}

// Integers of 192 bits, two's complement, low word first: wide enough for every sum here.
typedef struct plain {
  uint32_t word[6];
} plain;

// sum += p q 2^(32 at), for unsigned p and q.
static void plain_add_product(plain *sum, uint32_t p, uint32_t q, int at) {
  uint64_t carry = (uint64_t)p * q;
  for (int i = at; i < 6; i++) {
    carry += sum->word[i];
    sum->word[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

static void plain_negate(plain *x) {
  uint64_t carry = 1;
  for (int i = 0; i < 6; i++) {
    carry += (uint32_t)~x->word[i];
    x->word[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

// sum += p q.
static void plain_add(plain *sum, int64_t p, int64_t q) {
  const bool negative = (p < 0) != (q < 0);
  const uint64_t a = p < 0 ? 0 - (uint64_t)p : (uint64_t)p, b = q < 0 ? 0 - (uint64_t)q : (uint64_t)q;
  const uint32_t a0 = (uint32_t)(a & UINT32_MAX), a1 = (uint32_t)(a >> 32);
  const uint32_t b0 = (uint32_t)(b & UINT32_MAX), b1 = (uint32_t)(b >> 32);
  if (negative) {
    plain_negate(sum);
  }
  plain_add_product(sum, a0, b0, 0);
  plain_add_product(sum, a0, b1, 1);
  plain_add_product(sum, a1, b0, 1);
  plain_add_product(sum, a1, b1, 2);
  if (negative) {
    plain_negate(sum);
  }
}

static int plain_sign(const plain *x) {
  uint32_t any = 0;
  for (int i = 0; i < 6; i++) {
    any |= x->word[i];
  }
  return (x->word[5] & UINT32_C(0x80000000)) != 0 ? -1 : any != 0;
}

static void check_clz(void) {
  for (unsigned n = 0; n < 32; n++) {
    const uint32_t x = UINT32_C(1) << n;
    check(gjk_clz32(x) == plain_clz(x), "clz of a power of two");
    check(gjk_clz32(2 * (x - 1) + 1) == plain_clz(2 * (x - 1) + 1), "clz of a power of two less 1");
    check(gjk_clz64((uint64_t)x) == 32 + plain_clz(x), "clz of a low word");
    check(gjk_clz64((uint64_t)x << 32 | 1) == plain_clz(x), "clz of a high word");
  }
}

static void check_product(int32_t a, int32_t b) {
  check(gjk_mul32(a, b) == (int64_t)a * b, "signed product");
  check(gjk_mac32((int64_t)b * b, a, b) == (int64_t)b * b + (int64_t)a * b, "sum with a product");
  check(gjk_umul32((uint32_t)a, (uint32_t)b) == (uint64_t)(uint32_t)a * (uint32_t)b, "unsigned product");
}

static void check_sum_sign(int64_t p, int64_t q, int64_t r, int64_t s) {
  plain sum = {{0, 0, 0, 0, 0, 0}};
  plain_add(&sum, p, q);
  plain_add(&sum, r, s);
  check(gjk_sum_of_products_sign(p, q, r, s) == plain_sign(&sum), "sign of a sum of products");
}

static void check_dot_sign(gjk_long3 n, gjk_vec3 v) {
  plain sum = {{0, 0, 0, 0, 0, 0}};
  plain_add(&sum, n.x, v.x);
  plain_add(&sum, n.y, v.y);
  plain_add(&sum, n.z, v.z);
  check(gjk_dot_sign(&n, &v) == plain_sign(&sum), "sign of a dot product");
}

static void check_extremes(void) {
  static const int32_t edges[] = {INT32_MIN, INT32_MIN + 1, -65537, -65536, -65535,        -1,       0,
                                  1,         65535,         65536,  65537,  INT32_MAX - 1, INT32_MAX};
  const unsigned n = sizeof edges / sizeof edges[0];
  for (unsigned i = 0; i < n; i++) {
    for (unsigned k = 0; k < n; k++) {
      check_product(edges[i], edges[k]);
      // Sums that are -1, 0 or 1: x x - (x - 1)(x + 1) = 1. Their products are up to 2^62 in size.
      const int64_t x = gjk_mul32(edges[i], edges[k]);
      const int64_t y = x / 2 + edges[k];
      check_sum_sign(y, y, 1 - y, y + 1);
      check_sum_sign(y, y, -y, y);
      check_sum_sign(y - 1, y + 1, -y, y);
    }
  }
  const int64_t most = INT64_C(1) << 62;
  const gjk_long3 normal = {most / 2, -(most / 2), 1}, flat = {most / 2, -(most / 2), 0};
  const gjk_vec3 up = {1 << 14, 1 << 14, 1}, down = {1 << 14, 1 << 14, -1};
  check_sum_sign(most, most, most, most);
  check_sum_sign(-most, most, -most, most);
  check_dot_sign(normal, up);
  check_dot_sign(normal, down);
  check_dot_sign(flat, up);
}

static int64_t random_wide(random_state *random) {
  return (int64_t)(random_u64(random) >> 2) - (INT64_C(1) << 61);
}

static void check_random(void) {
  random_state random = random_seed(32);
  int zeros = 0;
  for (int i = 0; i < RANDOM_ITERATIONS; i++) {
    const int32_t a = random_range(&random, INT32_MIN, INT32_MAX), b = random_range(&random, INT32_MIN, INT32_MAX);
    const int32_t c = random_range(&random, -1, 1);
    const int32_t d = random_range(&random, -GJK_Q30_ONE, GJK_Q30_ONE);
    const int64_t p = random_wide(&random), q = random_wide(&random);
    const int64_t r = random_wide(&random), s = random_wide(&random);
    check_product(a, b);
    check_sum_sign(p, q, r, s);
    check_sum_sign(p, q, -p, q + c);  // sign of -p c: where the leading words agree
    const gjk_long3 n = {p / 4, q / 4, r / 4};
    const gjk_vec3 v = {a / 2, b / 2, d};
    check_dot_sign(n, v);
    const gjk_vec3 along = {a / 2, b / 2, 1};
    const gjk_long3 across = {along.y * (int64_t)d, -along.x * (int64_t)d, c};
    check_dot_sign(across, along);  // sign of c
    zeros += gjk_dot_sign(&across, &along) == 0;
  }
  check(zeros > RANDOM_ITERATIONS / 4 && zeros < RANDOM_ITERATIONS / 2, "a third of the near cancellations is exact");
}

port_counts port_check(void (*print)(const char *text)) {
  const port_counts none = {0, 0};
  counts = none;
  say = print;
  check_clz();
  check_extremes();
  check_random();
  return counts;
}

static void reach_too_far(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  const gjk_vec3 far = {1001, 0, 0};
  (void)user;
  (void)direction;
  *out = far;
}

void port_violate_contract(void) {
  static const gjk_shape liar = GJK_CUSTOM(reach_too_far, 0, 1000), point = GJK_POINT;
  const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider a = {0}, b = {0};
  gjk_distance_result result;
  gjk_collider_init(&a, &liar, NULL, 0);
  gjk_collider_init(&b, &point, NULL, 0);
  gjk_collider_pose(&a, &pose);
  gjk_collider_pose(&b, &pose);
  gjk_distance(&a, &b, NULL, &result);
}
