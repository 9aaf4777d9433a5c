// Principal axes by rotations in planes of two axes.
//
//   1. Scale the tensor up, so that its largest entry has 60 bits.
//   2. Take it in the frame of the axes so far.
//   3. Find the largest product of inertia. If it is small, the axes are found.
//   4. Turn the two axes so that it vanishes: with T.pp - T.qq = d and T.pq = b by an angle t, tan 2 t = 2 b / d. Of the
//      solutions that of at most 45 degrees. On from 2.
//
// Bounds on what is left. A component of the axes' quaternion is off by 0.51 LSB, so an axis by less than 2^-29. Their
// matrix is off by 2^-30.9. A product of inertia is off by that times the difference of two moments, and by what the
// matrix adds. Together that is below 2^-28 of the largest entry. Step 3 allows 2^-26.
#include "../arith/gjk_rotation.h"
#include "gjk_tensor.h"

#define MASS_ROTATIONS_MAX 40

// What a product of inertia may be, square LSB, besides 2^-26 of the largest entry.
#define PRODUCT_SLACK 8

static void set_quat(gjk_quat *q, gjk_q30 x, gjk_q30 y, gjk_q30 z, gjk_q30 w) {
  q->x = x;
  q->y = y;
  q->z = z;
  q->w = w;
}

// *cosine, *sine of half the angle of (x, y), Q2.30. Pre: not 0; x >= 0.
static void halve_angle(gjk_q30 x, gjk_q30 y, gjk_q30 *cosine, gjk_q30 *sine) {
  gjk_quat q;
  set_quat(&q, 0, 0, gjk_sar32(y, 1), gjk_sar32(x, 1) + GJK_Q30_ONE / 2);  // the sum with (1, 0), halved
  (void)gjk_quat_normalize(&q, &q);
  *cosine = q.w;
  *sine = q.z;
}

// The quaternion's part for step 4: the cosine and sine of half the angle.
static void half_turn(int64_t d, int64_t twice_b, gjk_q30 *cosine, gjk_q30 *sine) {
  const bool opposite = d < 0;
  const uint64_t bits = gjk_magnitude64(d) | gjk_magnitude64(twice_b);
  const unsigned zeros = gjk_clz64(bits), shift = zeros < 33 ? 33 - zeros : 0;
  gjk_quat q;
  set_quat(&q, 0, 0, (int32_t)gjk_sar64(opposite ? -twice_b : twice_b, shift),
           (int32_t)gjk_sar64(opposite ? -d : d, shift));  // each below 2^31
  (void)gjk_quat_normalize(&q, &q);
  halve_angle(q.w, q.z, cosine, sine);
  halve_angle(*cosine, *sine, cosine, sine);
}

// Step 2: rows becomes the matrix of the opposite rotation, which takes the tensor into the axes' frame.
static void view_tensor(const gjk_quat *rotation, const gjk_inertia *t, gjk_inertia *out) {
  gjk_vec3 rows[3];
  gjk_quat back;
  (void)gjk_quat_invert(rotation, &back);
  (void)gjk_rotation_from_quat(&back, rows);  // a normalised quaternion is a unit
  gjk_rotate_tensor(rows, t, out);
}

// Step 1: by how many bits.
static unsigned room_of(const gjk_inertia *t) {
  const uint64_t bits = gjk_magnitude64(t->xx) | gjk_magnitude64(t->yy) | gjk_magnitude64(t->zz) |
                        gjk_magnitude64(t->yz) | gjk_magnitude64(t->zx) | gjk_magnitude64(t->xy);
  const unsigned zeros = bits == 0 ? 4 : gjk_clz64(bits);
  return zeros > 4 ? zeros - 4 : 0;
}

static void scale_tensor(const gjk_inertia *t, unsigned up, gjk_inertia *out) {
  out->xx = gjk_shl64(t->xx, up);
  out->yy = gjk_shl64(t->yy, up);
  out->zz = gjk_shl64(t->zz, up);
  out->yz = gjk_shl64(t->yz, up);
  out->zx = gjk_shl64(t->zx, up);
  out->xy = gjk_shl64(t->xy, up);
}

// Steps 3 and 4. False: the products are at most limit.
static bool turn_axes(const gjk_inertia *t, int64_t limit, gjk_quat *rotation) {
  const int64_t product[3] = {t->yz, t->zx, t->xy}, moment[3] = {t->xx, t->yy, t->zz};
  unsigned about = 0;
  for (unsigned i = 1; i < 3; i++) {
    about = gjk_magnitude64(product[i]) > gjk_magnitude64(product[about]) ? i : about;
  }
  if (gjk_magnitude64(product[about]) <= (uint64_t)limit) {
    return false;
  }
  const unsigned p = gjk_next(about), q = gjk_next(p);
  gjk_q30 cosine, sine;
  gjk_quat turn;
  half_turn(moment[p] - moment[q], 2 * product[about], &cosine, &sine);  // each below 2^63
  set_quat(&turn, about == 0 ? sine : 0, about == 1 ? sine : 0, about == 2 ? sine : 0, cosine);
  (void)gjk_quat_compose(rotation, &turn, rotation);
  return true;
}

gjk_status gjk_mass_principal(const gjk_mass *body, gjk_principal *out) {
  if (body == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (!gjk_tensor_fits(&body->inertia)) {
    return GJK_ERROR_RANGE;
  }
  const unsigned up = room_of(&body->inertia);
  const int64_t slack = gjk_shl64(PRODUCT_SLACK, up), least = INT64_C(1) << 33;  // up <= 59
  const int64_t limit = slack > least ? slack : least;
  gjk_quat rotation;
  gjk_inertia scaled, seen;
  set_quat(&rotation, 0, 0, 0, GJK_Q30_ONE);
  scale_tensor(&body->inertia, up, &scaled);
  for (int i = 0; i < MASS_ROTATIONS_MAX; i++) {
    view_tensor(&rotation, &scaled, &seen);
    if (!turn_axes(&seen, limit, &rotation)) {
      const int64_t half = up > 0 ? gjk_shl64(1, up - 1) : 0;
      set_quat(&out->rotation, rotation.x, rotation.y, rotation.z, rotation.w);
      out->moment[0] = gjk_sar64(seen.xx + half, up);
      out->moment[1] = gjk_sar64(seen.yy + half, up);
      out->moment[2] = gjk_sar64(seen.zz + half, up);
      return GJK_OK;
    }
  }
  return GJK_ERROR_ITERATION_LIMIT;
}
