// Sums of moments in the plane.
#include "gjk2_moments.h"

void gjk2_moments_start(gjk2_moments *m) {
  gjk_big_set(&m->weight, 0);
  gjk_big_set(&m->first[0], 0);
  gjk_big_set(&m->first[1], 0);
  gjk_big_set(&m->second, 0);
}

void gjk2_moments_add(gjk2_moments *m, const gjk_big *weight, gjk2_vec s, int64_t q) {
  gjk_big_add(&m->weight, weight);
  gjk_big_add_product(&m->first[0], weight, s.x);
  gjk_big_add_product(&m->first[1], weight, s.y);
  gjk_big_add_product(&m->second, weight, q);
}

int64_t gjk2_moments_squares(gjk2_vec a, gjk2_vec b) {
  const gjk2_vec s = gjk2_add(a, b);  // components at most 2^30
  return gjk2_dot(s, s) + gjk2_dot(a, a) + gjk2_dot(b, b);
}

void gjk2_set_centre(const int64_t at[2], gjk2_mass *out) {
  int32_t nearest[2];
  for (int i = 0; i < 2; i++) {
    nearest[i] = (int32_t)gjk_sar64(at[i] + INT64_C(0x8000), 16);
    out->fraction[i] = (int16_t)(at[i] - gjk_shl64(nearest[i], 16));  // from -2^15 to 2^15 - 1
  }
  out->centre.x = nearest[0];
  out->centre.y = nearest[1];
}

void gjk2_set_body(uint64_t area, int64_t inertia, gjk2_mass *out) {
  static const int64_t origin[2] = {0, 0};
  out->area = area;
  out->mass = 0;
  out->inertia = inertia;
  gjk2_set_centre(origin, out);
}
