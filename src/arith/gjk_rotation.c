// Rotation matrices of unit quaternions, and what they do to vectors.
//
// From a quaternion q near a unit to the matrix of q / |q|:
//   1. Measure the deviation |q|^2 - 1 exactly. Refuse q beyond GJK_ROTATION_TOLERANCE.
//   2. excess = 1 - 1 / |q|^2, by the first two terms of its series.
//   3. The entries of the matrix of q are sums of products of two components, exact in Q60.
//   4. Multiply each entry by 1 - excess, which divides it by |q|^2. No division, and no square root, is needed.
//   5. Round the entries from Q60 to Q30, for the matrix that rotates vertices.
#include "gjk_rotation.h"

#include "gjk_root.h"

bool gjk_quat_deviation(const gjk_quat *q, int64_t *deviation) {
  // Each square <= 2^62:  squared <= 2^64. A sum of 2^64 wraps to 0, which is beyond the tolerance as well.
  const uint64_t squared = (uint64_t)gjk_mul32(q->x, q->x) + (uint64_t)gjk_mul32(q->y, q->y) +
                           (uint64_t)gjk_mul32(q->z, q->z) + (uint64_t)gjk_mul32(q->w, q->w);
  const int64_t off = gjk_int64(squared - (UINT64_C(1) << 60));
  const uint64_t tolerance = (uint64_t)GJK_ROTATION_TOLERANCE << 30;
  if ((uint64_t)off + tolerance > 2 * tolerance) {  // |off| > tolerance
    return false;
  }
  //@ assert off >= -(INT64_C(1) << 44) && off <= INT64_C(1) << 44;
  //@ assert q->x >= -INT32_C(0x40002000) && q->x <= INT32_C(0x40002000);
  //@ assert q->y >= -INT32_C(0x40002000) && q->y <= INT32_C(0x40002000);
  //@ assert q->z >= -INT32_C(0x40002000) && q->z <= INT32_C(0x40002000);
  //@ assert q->w >= -INT32_C(0x40002000) && q->w <= INT32_C(0x40002000);
  *deviation = off;
  return true;
}

// Step 4: x (1 - excess / 2^46), Q60, as gjk_corrected_q30 has it.
GJK_ONCE static int64_t corrected(int64_t x, int32_t excess) {
  //@ assert x >= -(INT64_C(33) << 55) && x <= INT64_C(33) << 55;
  // x / 2^30 times excess, from Q76 to Q60:         |x / 2^30| < 2^31, |excess| < 2^31:  |product| < 2^62
  // The first shift loses 1 in Q30 times excess:    < 2^-45, since excess / 2^46 < 2^-15
  // The second shift loses 1 in Q60:                < 2^-60
  return x - gjk_sar64(gjk_mul32((int32_t)gjk_sar64(x, 30), excess), 16);
}

// Step 5: Q60 to the nearest Q30.
static gjk_q30 to_q30(int64_t x) {
  return (gjk_q30)gjk_sar64(x + (INT64_C(1) << 29), 30);
}

gjk_q30 gjk_corrected_q30(int64_t x, int32_t excess) {
  return to_q30(corrected(x, excess));
}

// |p|^2 - 1, Q60, from 0 to 5 too small, for p in Q60 of so many components. Pre: |p|^2 is within 2^-28 of 1.
static int64_t excess_q60(const uint64_t p[4], int count) {
  // p = 2^30 h + l, 0 <= l < 2^30, per component:  p^2 / 2^60 = h^2 + 2 h l / 2^30 + (less than 1)
  //   |h| <= 2^30 + 8, length:  squares < 2^61, products < 2^62
  uint64_t squares = 0, products = 0;
  for (int i = 0; i < count; i++) {
    const uint32_t h = (uint32_t)(p[i] >> 30), l = (uint32_t)(p[i] & 0x3FFFFFFFu);
    squares += gjk_umul32(h, h);
    products += gjk_umul32(h, l);
  }
  return gjk_int64(squares + (products >> 29) - (UINT64_C(1) << 60));
}

bool gjk_normalize(const int32_t v[4], int count, gjk_q30 unit[4]) {
  uint32_t bits = 0;
  for (int i = 0; i < count; i++) {
    bits |= gjk_magnitude32(v[i]);
  }
  if (bits == 0) {
    return false;
  }
  const unsigned up = gjk_clz32(bits);
  // A quarter of |q 2^up|^2. One component >= 2^31, all < 2^32:  2^60 <= quarter < 2^64
  uint64_t quarter = 0;
  for (int i = 0; i < count; i++) {
    const uint32_t size = gjk_magnitude32(v[i]) << up;
    quarter += gjk_umul32(size, size) >> 2;
  }
  //@ assert quarter >= UINT64_C(1) << 60;
  const unsigned zeros = gjk_clz64(quarter) & ~1u;  // 0 or 2
  // root = 2^46 sqrt(2^32) / sqrt(quarter 2^zeros) = 2^(63 - zeros / 2) / |q 2^up|, relative error <= 2^-29.4
  const uint32_t root = gjk_reciprocal_root((uint32_t)((quarter << zeros) >> 32));
  const unsigned down = 3 - zeros / 2;
  uint64_t p[4];
  for (int i = 0; i < count; i++) {
    p[i] = gjk_umul32(gjk_magnitude32(v[i]) << up, root) >> down;
  }
  // p is a unit in Q60 but for the error of root. Correct it: 1 - 1 / sqrt(1 + e) = e / 2 - ..., Q46, below 2^18.
  const int64_t off = excess_q60(p, count);
  //@ assert off >= -(INT64_C(1) << 33) && off <= INT64_C(1) << 33;
  const int32_t excess = (int32_t)gjk_sar64(off, 15);
  for (int i = 0; i < count; i++) {
    const gjk_q30 size = gjk_corrected_q30((int64_t)p[i], excess);
    const int32_t sign = gjk_sar32(v[i], 31);
    unit[i] = (size ^ sign) - sign;
  }
  return true;
}

bool gjk_axis_normalize(const gjk_vec3 *v, gjk_unit3 *out) {
  const int32_t component[4] = {v->x, v->y, v->z, 0};
  gjk_q30 unit[4];
  if (!gjk_normalize(component, 3, unit)) {
    return false;
  }
  out->x = unit[0];
  out->y = unit[1];
  out->z = unit[2];
  return true;
}

void gjk_quat_multiply(const gjk_quat *a, int64_t off_a, const gjk_quat *b, int64_t off_b, gjk_quat *out) {
  // e = |a|^2 |b|^2 - 1 in Q45:  |ea|, |eb| <= 2^29, |e| <= 2^30 + 2^13
  const int32_t ea = (int32_t)gjk_sar64(off_a, 15), eb = (int32_t)gjk_sar64(off_b, 15);
  const int32_t e = ea + eb + (int32_t)gjk_sar64(gjk_mul32(ea, eb), 45);
  // 1 - 1 / sqrt(1 + e) = e / 2 - 3/8 e^2 + ..., in Q46:  3 e^2 < 2^62, the other terms together < 1
  const int32_t excess = e - (int32_t)gjk_sar64(3 * gjk_mul32(e, e), 47);
  int64_t p[4];
  gjk_quat_product(a, b, p);  // |a| |b| <= 2^60 (1 + 2^-16)
  const gjk_quat product = {gjk_corrected_q30(p[0], excess), gjk_corrected_q30(p[1], excess),
                            gjk_corrected_q30(p[2], excess), gjk_corrected_q30(p[3], excess)};
  *out = product;
}

// Step 2, for e = |q|^2 - 1 in Q46: 1 - 1 / |q|^2 = e - e^2 + e^3 - ...
static inline int32_t quat_excess(int64_t deviation) {
  const int32_t e = (int32_t)gjk_sar64(deviation, 14);  // |deviation| <= 2^44:  |e| <= 2^30
  return e - (int32_t)gjk_sar64(gjk_mul32(e, e), 46);   // e^2 <= 2^14, and e^3 < 1
}

// Steps 3 and 4 for the entries (i, i), (i, j) and (j, i) of the rows m, where j follows i. c: x, y, z, w.
GJK_ONCE static void set_entries(const gjk_q30 c[4], unsigned i, int32_t excess, int64_t m[9]) {
  const unsigned j = gjk_next(i), k = gjk_next(j);
  // |products|, |partial sums| <= |q|^2 <= 2^60 (1 + 2^-16), and so is each entry.
  const int64_t product = gjk_mul32(c[i], c[j]), square = gjk_mac32(gjk_mul32(c[3], c[3]), c[i], c[i]);
  m[4 * i] = corrected(gjk_msub32(gjk_msub32(square, c[j], c[j]), c[k], c[k]), excess);
  m[3 * i + j] = corrected(2 * gjk_msub32(product, c[3], c[k]), excess);
  m[3 * j + i] = corrected(2 * gjk_mac32(product, c[3], c[k]), excess);
}

// Steps 1 to 4: the matrix of q / |q| by rows, Q60; entries within 2^-43. False, and m not set, as
// gjk_rotation_from_quat.
static bool fine_matrix(const gjk_quat *q, int64_t m[9]) {
  int64_t deviation;
  if (!gjk_quat_deviation(q, &deviation)) {  // Step 1
    return false;
  }
  const gjk_q30 c[4] = {q->x, q->y, q->z, q->w};
  const int32_t excess = quat_excess(deviation);
  set_entries(c, 0, excess, m);
  set_entries(c, 1, excess, m);
  set_entries(c, 2, excess, m);
  return true;
}

// What to_q30 drops of x, its low 30 bits as a signed number, from Q60 to Q45, rounded down: at most 2^14 in size.
static int32_t dropped(int64_t x) {
  return gjk_sar32(gjk_int32(gjk_low32(x) << 2), 17);
}

// Step 5
static void round_matrix(const int64_t m[9], gjk_vec3 rows[3]) {
  for (int i = 0; i < 3; i++) {
    rows[i].x = to_q30(m[3 * i]);
    rows[i].y = to_q30(m[3 * i + 1]);
    rows[i].z = to_q30(m[3 * i + 2]);
  }
}

#if GJK_SMALL

bool gjk_rotation_from_quat(const gjk_quat *q, gjk_vec3 rows[3]) {
  int64_t m[9];
  if (!fine_matrix(q, m)) {
    return false;
  }
  round_matrix(m, rows);
  return true;
}

#else

// Steps 4 and 5: in line, unless products are calls or long.
#if GJK_NARROW_MULTIPLY
GJK_OUT_OF_LINE
#else
GJK_ONCE
#endif
static gjk_q30 rounded_entry(int64_t x, int32_t excess) {
  return to_q30(corrected(x, excess));
}

// All steps of each entry at once: the sums are those of set_entries.
bool gjk_rotation_from_quat(const gjk_quat *q, gjk_vec3 rows[3]) {
  int64_t deviation;
  if (!gjk_quat_deviation(q, &deviation)) {
    return false;
  }
  const int32_t x = q->x, y = q->y, z = q->z, w = q->w, excess = quat_excess(deviation);
  const int64_t xx = gjk_mul32(x, x), yy = gjk_mul32(y, y), zz = gjk_mul32(z, z), ww = gjk_mul32(w, w);
  const int64_t xy = gjk_mul32(x, y), yz = gjk_mul32(y, z), zx = gjk_mul32(z, x);
  rows[0].x = rounded_entry(ww + xx - yy - zz, excess);
  rows[0].y = rounded_entry(2 * gjk_msub32(xy, w, z), excess);
  rows[0].z = rounded_entry(2 * gjk_mac32(zx, w, y), excess);
  rows[1].x = rounded_entry(2 * gjk_mac32(xy, w, z), excess);
  rows[1].y = rounded_entry(ww + yy - zz - xx, excess);
  rows[1].z = rounded_entry(2 * gjk_msub32(yz, w, x), excess);
  rows[2].x = rounded_entry(2 * gjk_msub32(zx, w, y), excess);
  rows[2].y = rounded_entry(2 * gjk_mac32(yz, w, x), excess);
  rows[2].z = rounded_entry(ww + zz - xx - yy, excess);
  return true;
}

#endif

#if GJK_SHAPES == GJK_SHAPES_ROUND
bool gjk_rotation_of_z(const gjk_quat *q, gjk_vec3 rows[3]) {
  int64_t deviation;
  if (!gjk_quat_deviation(q, &deviation)) {
    return false;
  }
  const int32_t excess = quat_excess(deviation);
  const int64_t ww = gjk_mul32(q->w, q->w), zz = gjk_mul32(q->z, q->z);
  rows[0].z = gjk_corrected_q30(2 * gjk_mac32(gjk_mul32(q->x, q->z), q->w, q->y), excess);
  rows[1].z = gjk_corrected_q30(2 * gjk_mac32(gjk_mul32(q->y, q->z), -q->w, q->x), excess);
  rows[2].z = gjk_corrected_q30(ww - gjk_mul32(q->x, q->x) - gjk_mul32(q->y, q->y) + zz, excess);
  return true;
}
#endif

// Row i of m, Q60, to Q30, and times v, as gjk_rotation_with_point has it.
static int64_t round_and_rotate(const int64_t m[3], const gjk_vec3 *v, gjk_vec3 *row) {
  const gjk_vec3 high = {to_q30(m[0]), to_q30(m[1]), to_q30(m[2])};
  *row = high;
  const int64_t fine =
      gjk_mac32(gjk_mac32(gjk_mul32(dropped(m[0]), v->x), dropped(m[1]), v->y), dropped(m[2]), v->z);  // |fine| < 2^47
  return gjk_dot(&high, v) + gjk_sar64(fine, 15);
}

bool gjk_rotation_with_point(const gjk_quat *q, const gjk_vec3 *v, gjk_vec3 rows[3], int64_t rotated[3]) {
  int64_t m[9];
  if (!fine_matrix(q, m)) {
    return false;
  }
  if ((v->x | v->y | v->z) == 0) {
    round_matrix(m, rows);
    rotated[0] = rotated[1] = rotated[2] = 0;
    return true;
  }
  for (int i = 0; i < 3; i++) {
    rotated[i] = round_and_rotate(&m[3 * i], v, &rows[i]);
  }
  return true;
}

// floor(row . v + start), from Q30 to LSB.
static int64_t component(int32_t x, int32_t y, int32_t z, const gjk_vec3 *v, int32_t start) {
  const int64_t sum = gjk_mac32(gjk_mac32(gjk_mul32(x, v->x), y, v->y), z, v->z);  // |row| <= 2^30 + 1,
  return gjk_sar64(sum + start, 30);                                               // |v| <= sqrt(3) 2^31:  |sum| < 2^62
}

// The same, for a result that fits. One copy in a build for size, which has six calls of it.
GJK_ONCE static int32_t narrow_component(int32_t x, int32_t y, int32_t z, const gjk_vec3 *v, int32_t start) {
  const int64_t rotated = component(x, y, z, v, start);
  //@ assert rotated >= INT32_MIN && rotated <= INT32_MAX;
  return (int32_t)rotated;
}

gjk_vec3 gjk_rotate_onto(const gjk_vec3 rows[3], const gjk_vec3 *v, const int8_t fraction[3]) {
  const gjk_vec3 rotated = {narrow_component(rows[0].x, rows[0].y, rows[0].z, v, gjk_rotation_start(fraction[0])),
                            narrow_component(rows[1].x, rows[1].y, rows[1].z, v, gjk_rotation_start(fraction[1])),
                            narrow_component(rows[2].x, rows[2].y, rows[2].z, v, gjk_rotation_start(fraction[2]))};
  return rotated;
}

gjk_vec3 gjk_rotate(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  static const int8_t none[3] = {0, 0, 0};
  return gjk_rotate_onto(rows, v, none);
}

gjk_vec3 gjk_rotate_back(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  const gjk_vec3 rotated = {narrow_component(rows[0].x, rows[1].x, rows[2].x, v, GJK_ROTATION_HALF),
                            narrow_component(rows[0].y, rows[1].y, rows[2].y, v, GJK_ROTATION_HALF),
                            narrow_component(rows[0].z, rows[1].z, rows[2].z, v, GJK_ROTATION_HALF)};
  return rotated;
}

void gjk_rotate_wide(const gjk_vec3 rows[3], const gjk_vec3 *v, int64_t out[3]) {
  for (int i = 0; i < 3; i++) {
    out[i] = component(rows[i].x, rows[i].y, rows[i].z, v, GJK_ROTATION_HALF);
  }
}
