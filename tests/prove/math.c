// Every function of gjk/math.h but gjk_quat_integrate, which integrate.c has, on any input at all.
#include "gjk/math.h"

#include "any.h"

static void numbers(void) {
  gjk_q30 sine, cosine;
  (void)gjk_q16_multiply(any_int32(), any_int32());
  (void)gjk_q16_divide(any_int32(), any_int32());
  (void)gjk_q16_sqrt(any_int32());
  (void)gjk_atan2(any_int32(), any_int32());
  gjk_sine_and_cosine(any_int32(), &sine, &cosine);
}

int main(void) {
  const gjk_vec3 a = any_position(), b = any_position();
  gjk_unit3 unit;
  gjk_quat rotation;
  gjk_pose pose;
  gjk_q16 half;
  numbers();
  (void)gjk_vec3_add(&a, &b);
  (void)gjk_vec3_subtract(&a, &b);
  (void)gjk_vec3_scale(&a, any_int32());
  (void)gjk_vec3_dot(&a, &b);
  (void)gjk_vec3_cross(&a, &b);
  (void)gjk_vec3_length(&a);
  (void)gjk_vec3_normalize(any_bool() ? &a : NULL, any_bool() ? &unit : NULL);
  (void)gjk_quat_between(any_bool() ? &a : NULL, any_bool() ? &b : NULL, any_bool() ? &rotation : NULL);
  (void)gjk_pose_between(any_bool() ? &a : NULL, any_bool() ? &b : NULL, any_bool() ? &pose : NULL,
                         any_bool() ? &half : NULL);
  return 0;
}
