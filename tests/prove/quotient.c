// src/motion/gjk_quotient.h: any fraction of a denominator below 2^93, and what it makes of any number below 2^34.
#include "src/motion/gjk_quotient.h"

#include "any.h"

static uint64_t any_uint64(void) {
  return (uint64_t)Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
}

int main(void) {
  const gjk_u128 numerator = {(uint64_t)Frama_C_long_long_interval(0, (INT64_C(1) << 29) - 1), any_uint64()};
  gjk_u128 denominator = {(uint64_t)Frama_C_long_long_interval(0, (INT64_C(1) << 29) - 1), any_uint64()};
  gjk_quotient q;
  if (denominator.high == 0 && denominator.low == 0) {
    return 0;
  }
  gjk_quotient_set(&q, &numerator, &denominator);
  const int64_t least = 1 - (INT64_C(1) << 34), most = (INT64_C(1) << 34) - 1;
  (void)gjk_quotient_floor(&q, Frama_C_long_long_interval(least, -1));
  (void)gjk_quotient_floor(&q, Frama_C_long_long_interval(0, most));
  (void)gjk_quotient_nearest(&q, Frama_C_long_long_interval(1 - (INT64_C(1) << 33), (INT64_C(1) << 33) - 1));
  return 0;
}
