// Stands in for src/motion/gjk_quotient.c: a fraction makes of a number one that is between 0 and it, rounded down.
#include "src/motion/gjk_quotient.h"

#include "ways.h"

void gjk_quotient_set(gjk_quotient *q, const gjk_u128 *numerator, const gjk_u128 *denominator) {
  //@ assert \initialized(numerator) && \initialized(denominator);
  q->high = (uint32_t)Frama_C_long_long_interval(0, UINT32_MAX);
  q->numerator = (uint64_t)any_long(INT64_MAX);
  q->denominator = (uint64_t)any_long(INT64_MAX);
  q->one = any_bool();
}

int64_t gjk_quotient_split(const gjk_quotient *q, int64_t x, bool *whole) {
  //@ assert \initialized(&q->high);
  check_size(x, (INT64_C(1) << 34) - 1);
  *whole = any_bool();
  return Frama_C_long_long_interval(x < 0 ? x : 0, x > 0 ? x : 0);
}
