// Sums over simplices. What they are and their bounds stand in gjk_moments.h.
#include "gjk_moments.h"

// The axes of the entries of a symmetric matrix.
const uint8_t gjk_entry_axis[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};

void gjk_moments_start(gjk_moments *m, const gjk_vec3 *origin) {
  gjk_set(origin, &m->origin);
  gjk_big_set(&m->weight, 0);
  for (int i = 0; i < 3; i++) {
    gjk_big_set(&m->first[i], 0);
  }
  for (int i = 0; i < 6; i++) {
    gjk_big_set(&m->second[i], 0);
  }
}

void gjk_moments_add(gjk_moments *m, const gjk_big *weight, const gjk_vec3 *const corner[], int corners) {
  int32_t at[3][3], sum[3] = {0, 0, 0};  // |at| <= 2^29, |sum| <= 3 2^29
  for (int i = 0; i < corners; i++) {
    const gjk_vec3 v = gjk_sub(*corner[i], m->origin);
    at[i][0] = v.x;
    at[i][1] = v.y;
    at[i][2] = v.z;
    for (int j = 0; j < 3; j++) {
      sum[j] += at[i][j];
    }
  }
  gjk_big_add(&m->weight, weight);
  for (int i = 0; i < 3; i++) {
    gjk_big_add_product(&m->first[i], weight, sum[i]);
  }
  for (int i = 0; i < 6; i++) {
    const unsigned p = gjk_entry_axis[i][0], q = gjk_entry_axis[i][1];
    int64_t second = gjk_mul32(sum[p], sum[q]);  // <= 9 2^58
    for (int j = 0; j < corners; j++) {
      second = gjk_mac32(second, at[j][p], at[j][q]);  // 2^58 each:  <= 12 2^58 < 2^62
    }
    gjk_big_add_product(&m->second[i], weight, second);
  }
}

bool gjk_moments_add_tetrahedron(gjk_moments *m, const gjk_vec3 *const corner[3]) {
  gjk_long3 n;
  gjk_big weight;
  uint32_t low;
  const gjk_vec3 v = gjk_sub(*corner[0], m->origin);
  gjk_triangle_normal(corner[0], corner[1], corner[2], &n);
  const int64_t high = gjk_dot_exact(&n, &v, &low);  // 2^31 high + low = n . v < 2^90
  if (high < 0) {
    return false;
  }
  if (high > 0 || low > 0) {
    gjk_big_set_long(&weight, high, low);
    gjk_moments_add(m, &weight, corner, 3);
  }
  return true;
}

// The axis that the normal of a triangle is longest along, or 3 where the triangle degenerates.
unsigned gjk_longest_axis(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c) {
  gjk_long3 n;
  uint64_t most = 0;
  unsigned longest = 3;
  gjk_triangle_normal(a, b, c, &n);
  for (unsigned axis = 0; axis < 3; axis++) {
    const uint64_t size = gjk_magnitude64(gjk_long_component(&n, axis));
    if (size > most) {
      most = size;
      longest = axis;
    }
  }
  return longest;
}

void gjk_moments_add_flat(gjk_moments *m, unsigned axis, const gjk_vec3 *const corner[3]) {
  gjk_long3 n;
  gjk_big weight;
  gjk_triangle_normal(corner[0], corner[1], corner[2], &n);
  const int64_t area = gjk_long_component(&n, axis);
  gjk_big_set(&weight, area < 0 ? -area : area);
  gjk_moments_add(m, &weight, corner, 3);
}

void gjk_inertia_of_second(gjk_big m[6]) {
  gjk_big trace, entry;
  gjk_big_copy(&trace, &m[0]);
  gjk_big_add(&trace, &m[1]);
  gjk_big_add(&trace, &m[2]);
  for (int i = 0; i < 6; i++) {
    gjk_big_copy(&entry, &m[i]);
    if (i < 3) {
      gjk_big_copy(&m[i], &trace);
    } else {
      gjk_big_set(&m[i], 0);
    }
    gjk_big_subtract(&m[i], &entry);
  }
}

void gjk_set_inertia(gjk_big entry[6], const gjk_big *whole, gjk_inertia *out) {
  out->xx = gjk_big_nearest(&entry[0], whole);
  out->yy = gjk_big_nearest(&entry[1], whole);
  out->zz = gjk_big_nearest(&entry[2], whole);
  out->yz = gjk_big_nearest(&entry[3], whole);
  out->zx = gjk_big_nearest(&entry[4], whole);
  out->xy = gjk_big_nearest(&entry[5], whole);
}

void gjk_set_centre(const int64_t at[3], gjk_mass *out) {
  int32_t nearest[3];
  for (int i = 0; i < 3; i++) {
    nearest[i] = (int32_t)gjk_sar64(at[i] + INT64_C(0x8000), 16);
    out->fraction[i] = (int16_t)(at[i] - gjk_shl64(nearest[i], 16));  // from -2^15 to 2^15 - 1
  }
  out->centre.x = nearest[0];
  out->centre.y = nearest[1];
  out->centre.z = nearest[2];
}

void gjk_set_volume(gjk_big *x, const gjk_big *y, gjk_volume *out) {
  gjk_big twice;
  gjk_big_copy(&twice, y);
  gjk_big_add(&twice, y);
  gjk_big_add(x, x);
  gjk_big_add(x, y);
  gjk_big_divide(x, &twice);
  out->high = (uint64_t)x->limb[3] << 32 | x->limb[2];
  out->low = (uint64_t)x->limb[1] << 32 | x->limb[0];
}

// C of the sums, for k vertices a simplex, and what it is to be divided by.
static void take_second(const gjk_moments *m, unsigned k, gjk_big second[6], gjk_big *whole) {
  for (unsigned i = 0; i < 6; i++) {
    gjk_big square;
    gjk_big_multiply(&square, &m->first[gjk_entry_axis[i][0]], &m->first[gjk_entry_axis[i][1]]);
    gjk_big_scale(&square, k * (k + 1));
    gjk_big_multiply(&second[i], &m->weight, &m->second[i]);
    gjk_big_scale(&second[i], k * k);
    gjk_big_subtract(&second[i], &square);
  }
  gjk_big_multiply(whole, &m->weight, &m->weight);
  gjk_big_scale(whole, k * k * k * (k + 1));  // <= 320
}

void gjk_moments_finish(gjk_moments *m, unsigned k, gjk_mass *out) {
  gjk_big second[6], whole, six;
  const int32_t origin[3] = {m->origin.x, m->origin.y, m->origin.z};
  int64_t centre[3];
  take_second(m, k, second, &whole);
  gjk_inertia_of_second(second);
  gjk_set_inertia(second, &whole, &out->inertia);
  gjk_big_copy(&whole, &m->weight);
  gjk_big_scale(&whole, k);
  for (int i = 0; i < 3; i++) {
    gjk_big_scale(&m->first[i], UINT32_C(1) << 16);
    gjk_big_divide(&m->first[i], &whole);
    centre[i] = gjk_shl64(origin[i], 16) + gjk_big_low(&m->first[i]);  // |quotient| <= 2^29 2^16
  }
  gjk_set_centre(centre, out);
  gjk_big_set(&six, 6);
  if (k < 4) {
    gjk_big_set(&m->weight, 0);
  }
  gjk_set_volume(&m->weight, &six, &out->volume);
  out->mass = 0;
}

void gjk_moments_of_segment(const gjk_vec3 *a, const gjk_vec3 *b, gjk_mass *out) {
  const gjk_vec3 *corner[2];
  gjk_moments m;
  gjk_big one;
  corner[0] = a;
  corner[1] = b;
  gjk_moments_start(&m, a);
  gjk_big_set(&one, 1);
  gjk_moments_add(&m, &one, corner, 2);
  gjk_moments_finish(&m, 2, out);
}
