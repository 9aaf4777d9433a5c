// Stands in for src/arith/gjk_rotation.c under bodies of many parts: any rotation, as tests/prove/pose.c shows.
#include "src/arith/gjk_rotation.h"

#include "simplex_any.h"

bool gjk_rotation_from_quat(const gjk_quat *q, gjk_vec3 rows[3]) {
  check_size(q->x ^ q->y ^ q->z ^ q->w, INT64_C(1) << 31);
  const int32_t unit = any_between(0, 1);
  //@ split unit;
  if (unit == 0) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    rows[i] = any_vec3(GJK_Q30_ONE);
  }
  return true;
}

gjk_vec3 gjk_rotate(const gjk_vec3 rows[3], const gjk_vec3 *v) {
  for (int i = 0; i < 3; i++) {
    check_vec3(&rows[i], GJK_Q30_ONE);
  }
  check_vec3(v, INT32_C(1) << 30);
  return any_position();
}
