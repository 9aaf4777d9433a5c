// Rotation matrices and integer roots: the bounds that the rest of src relies on.
#include <math.h>

#include "check.h"
#include "random.h"
#include "src/arith/gjk_root.h"
#include "src/arith/gjk_rotation.h"

#define SEED 31337
#define ITERATIONS ((int)check_trials(200000))

// A quaternion within the tolerance of unit length. scale: how much of it the squared length uses, from -1 to 1.
static gjk_quat random_unit(random_state *random, long double scale) {
  long double c[4], squared = 0;
  for (int i = 0; i < 4; i++) {
    const unsigned bits = random_below(random, 31);
    c[i] = random_range(random, INT32_MIN >> 1, INT32_MAX >> 1) / ldexpl(1, (int)bits);
    squared += c[i] * c[i];
  }
  // Rounding a component moves |q|^2 by up to 2^-29. Staying 2^-26 inside the tolerance is safe.
  const long double length = sqrtl(1 + scale * (ldexpl(1, -16) - ldexpl(1, -26))), f = GJK_Q30_ONE * length;
  const long double norm = sqrtl(squared);
  return (gjk_quat){(gjk_q30)llroundl(c[0] / norm * f), (gjk_q30)llroundl(c[1] / norm * f),
                    (gjk_q30)llroundl(c[2] / norm * f), (gjk_q30)llroundl(c[3] / norm * f)};
}

static void real_matrix(const gjk_quat *q, long double m[3][3]) {
  const long double x = q->x, y = q->y, z = q->z, w = q->w, s = GJK_Q30_ONE / (x * x + y * y + z * z + w * w);
  const long double rows[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                  {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                                  {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
  for (int i = 0; i < 9; i++) {
    m[i / 3][i % 3] = rows[i / 3][i % 3] * s;
  }
}

static int32_t entry(const gjk_vec3 *row, int column) {
  return column == 0 ? row->x : column == 1 ? row->y : row->z;
}

// A vector at most 2^bits long.
static gjk_vec3 random_vector(random_state *random, unsigned bits) {
  const int32_t size = (int32_t)(ldexpl(1, (int)bits) / sqrtl(3.0L)) - 1;
  gjk_vec3 v;
  v.x = random_below(random, 8) == 0 ? -size : random_range(random, -size, size);
  v.y = random_below(random, 8) == 0 ? size : random_range(random, -size, size);
  v.z = random_below(random, 8) == 0 ? size : random_range(random, -size, size);
  return v;
}

// The largest error of an entry.
static long double entry_error(const gjk_vec3 rows[3], long double m[3][3], bool *in_range) {
  long double error = 0;
  for (int i = 0; i < 9; i++) {
    const int32_t e = entry(&rows[i / 3], i % 3);
    error = fmaxl(error, fabsl(e - m[i / 3][i % 3]));
    *in_range = *in_range && e >= -GJK_Q30_ONE && e <= GJK_Q30_ONE;
  }
  return error;
}

static long double component_error(int64_t got, long double m0, long double m1, long double m2, const gjk_vec3 *v) {
  return fabsl((long double)got - (m0 * v->x + m1 * v->y + m2 * v->z) / GJK_Q30_ONE);
}

// The largest error of a component, over the three functions that turn a vector.
static long double turn_error(const gjk_vec3 rows[3], long double m[3][3], const gjk_vec3 *v) {
  const gjk_vec3 turned = gjk_rotate(rows, v), back = gjk_rotate_back(rows, v);
  int64_t wide[3];
  gjk_rotate_wide(rows, v, wide);
  long double error = 0;
  for (int i = 0; i < 3; i++) {
    error = fmaxl(error, component_error(entry(&turned, i), m[i][0], m[i][1], m[i][2], v));
    error = fmaxl(error, component_error(entry(&back, i), m[0][i], m[1][i], m[2][i], v));
    error = fmaxl(error, component_error(wide[i], m[i][0], m[i][1], m[i][2], v));
  }
  return error;
}

static void test_rotation(void) {
  random_state random = random_seed(check_seed(SEED));
  long double worst_entry = 0, worst_turn = 0;
  unsigned long refused = 0;
  bool in_range = true;
  for (int i = 0; i < ITERATIONS; i++) {
    const long double scale = i % 3 - 1 + (i % 3 == 1 ? random_range(&random, -999, 999) / 1000.0L : 0);
    const gjk_quat q = random_unit(&random, scale);
    gjk_vec3 rows[3];
    if (!gjk_rotation_from_quat(&q, rows)) {
      refused++;
      continue;
    }
    long double m[3][3];
    real_matrix(&q, m);
    worst_entry = fmaxl(worst_entry, entry_error(rows, m, &in_range));
    const gjk_vec3 v = random_vector(&random, 29), largest = random_vector(&random, 31);
    worst_turn = fmaxl(worst_turn, turn_error(rows, m, &v));
    // Checks the bounds of the header, for vectors as long as they may be.
    const long double sum = fabsl(largest.x * 1.0L) + fabsl(largest.y * 1.0L) + fabsl(largest.z * 1.0L);
    const long double error = turn_error(rows, m, &largest);
    CHECK_MSG(error <= 0.501L * (1 + sum / GJK_Q30_ONE), "trial %d: %.3Lf LSB", i, error);
  }
  printf("rotation: largest error of an entry %.4Lf LSB, of a vector up to 2^29 %.4Lf LSB\n", worst_entry, worst_turn);
  CHECK_MSG(refused == 0, "%lu of %d", refused, ITERATIONS);
  CHECK_MSG(worst_entry <= 0.5L + ldexpl(1, -13), "%.6Lf LSB", worst_entry);
  CHECK_MSG(worst_turn <= 1, "%.6Lf LSB", worst_turn);
  CHECK_MSG(in_range, "an entry beyond 1");
}

// The transposed matrix turns back: as the conjugate of q does.
static void test_transposed(void) {
  random_state random = random_seed(check_seed(SEED) + 1);
  unsigned long different = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_quat q = random_unit(&random, i % 3 - 1), conjugate = {-q.x, -q.y, -q.z, q.w};
    const gjk_vec3 v = random_vector(&random, 30);
    gjk_vec3 rows[3], columns[3];
    CHECK(gjk_rotation_from_quat(&q, rows));
    CHECK(gjk_rotation_from_quat(&conjugate, columns));
    const gjk_vec3 back = gjk_rotate_back(rows, &v), turned = gjk_rotate(columns, &v);
    different += back.x != turned.x || back.y != turned.y || back.z != turned.z;
  }
  CHECK_MSG(different == 0, "%lu of %d", different, ITERATIONS);
}

static bool is_root(uint64_t x) {
  const uint64_t r = gjk_isqrt64(x);
  return r * r <= x && (r == UINT32_MAX || (r + 1) * (r + 1) > x);
}

static void test_root(void) {
  random_state random = random_seed(check_seed(SEED) + 2);
  CHECK(gjk_isqrt64(0) == 0);
  CHECK(is_root(1));
  CHECK(is_root(2));
  CHECK(is_root(3));
  CHECK(is_root(UINT64_MAX));
  for (int i = 0; i < ITERATIONS; i++) {
    const uint64_t x = random_u64(&random) >> random_below(&random, 64);
    const uint64_t r = random_u32(&random) >> random_below(&random, 32);
    CHECK_MSG(is_root(x), "%llu", (unsigned long long)x);
    CHECK_MSG(is_root(r * r), "%llu squared", (unsigned long long)r);
    CHECK_MSG(is_root(r * r - (r > 0)), "%llu squared", (unsigned long long)r);
  }
}

static void test_reciprocal_root(void) {
  random_state random = random_seed(check_seed(SEED) + 3);
  long double low = 0, high = 0;
  CHECK(gjk_reciprocal_root(UINT32_C(1) << 30) == INT32_MAX);
  for (int i = 0; i < 5 * ITERATIONS; i++) {
    const uint32_t offset = i % 2 == 0 ? (uint32_t)i : random_below(&random, UINT32_C(0xC0000000));
    const uint32_t x = i % 4 == 0 ? UINT32_MAX - offset : (UINT32_C(1) << 30) + offset;
    const uint32_t y = gjk_reciprocal_root(x);
    const long double error = y - ldexpl(1, 46) / sqrtl(x);
    low = fminl(low, error);
    high = fmaxl(high, error);
    CHECK_MSG(y <= INT32_MAX, "%lu", (unsigned long)x);
  }
  printf("reciprocal root: from %.3Lf to %.3Lf\n", low, high);
  CHECK_MSG(low > -1.5L, "from %.3Lf to %.3Lf", low, high);
  CHECK_MSG(high < 0.5L, "from %.3Lf to %.3Lf", low, high);
}

int main(void) {
  test_rotation();
  test_transposed();
  test_root();
  test_reciprocal_root();
  return check_done("rotation");
}
