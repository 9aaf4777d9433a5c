// Symmetric tensors, rotated.
#include "gjk_tensor.h"

// floor(x factor / 2^30), exact. Pre: |x| < 2^62, |factor| <= 2^30.
static int64_t scale_q30(int64_t x, gjk_q30 factor) {
  // x = 2^31 high + low: 2 high factor + low factor / 2^30
  return 2 * gjk_mul32(gjk_high_digit(x), factor) + gjk_sar64(gjk_mul32(gjk_low_digit(x), factor), 30);
}

// m . (x, y, z), off by less than 3. Its size is below |(x, y, z)| (1 + 2^-28) + 3, since m is a unit vector to Q2.30.
static int64_t combine_q30(const gjk_vec3 *m, int64_t x, int64_t y, int64_t z) {
  return scale_q30(x, m->x) + scale_q30(y, m->y) + scale_q30(z, m->z);
}

void gjk_rotate_tensor(const gjk_vec3 rows[3], const gjk_inertia *t, gjk_inertia *out) {
  int64_t half[3][3], entry[6];  // half = R T: entries below sqrt(3) 2^60 + 3 < 2^61
  for (int i = 0; i < 3; i++) {
    half[i][0] = combine_q30(&rows[i], t->xx, t->xy, t->zx);
    half[i][1] = combine_q30(&rows[i], t->xy, t->yy, t->yz);
    half[i][2] = combine_q30(&rows[i], t->zx, t->yz, t->zz);
  }
  for (unsigned i = 0; i < 3; i++) {
    const unsigned j = gjk_next(i), k = gjk_next(j);
    entry[i] = combine_q30(&rows[i], half[i][0], half[i][1], half[i][2]);  // below 3 2^60 + 6 < 2^62
    entry[i + 3] = combine_q30(&rows[k], half[j][0], half[j][1], half[j][2]);
  }
  out->xx = entry[0];
  out->yy = entry[1];
  out->zz = entry[2];
  out->yz = entry[3];
  out->zx = entry[4];
  out->xy = entry[5];
}

bool gjk_tensor_fits(const gjk_inertia *t) {
  const int64_t entry[6] = {t->xx, t->yy, t->zz, t->yz, t->zx, t->xy};
  for (int i = 0; i < 6; i++) {
    if (entry[i] > GJK_INERTIA_MAX || entry[i] < -GJK_INERTIA_MAX) {
      return false;
    }
  }
  return true;
}
