// Stands in for src/arith/gjk_big.c: any number, as tests/prove/big.c shows.
#include "big_any.h"

void gjk_big_set(gjk_big *x, int64_t value) {
  (void)value;
  any_big(x);
}

void gjk_big_set_long(gjk_big *x, int64_t high, uint32_t low) {
  (void)high, (void)low;
  any_big(x);
}

void gjk_big_copy(gjk_big *to, const gjk_big *from) {
  check_big(from);
  any_big(to);
}

void gjk_big_add(gjk_big *x, const gjk_big *y) {
  check_big(x);
  check_big(y);
  any_big(x);
}

void gjk_big_subtract(gjk_big *x, const gjk_big *y) {
  check_big(x);
  check_big(y);
  any_big(x);
}

void gjk_big_scale(gjk_big *x, uint32_t factor) {
  (void)factor;
  check_big(x);
  any_big(x);
}

void gjk_big_multiply(gjk_big *out, const gjk_big *x, const gjk_big *y) {
  //@ assert out != x && out != y;
  check_big(x);
  check_big(y);
  any_big(out);
}

void gjk_big_add_product(gjk_big *x, const gjk_big *y, int64_t factor) {
  (void)factor;
  check_big(x);
  check_big(y);
  any_big(x);
}

bool gjk_big_is_zero(const gjk_big *x) {
  check_big(x);
  return any_bool();
}

void gjk_big_shift_up(gjk_big *x, unsigned bits) {
  //@ assert bits < 256;
  check_big(x);
  any_big(x);
}

void gjk_big_shift_down(gjk_big *x, unsigned bits) {
  //@ assert bits < 256;
  check_big(x);
  any_big(x);
}

bool gjk_big_is_at_least(const gjk_big *x, const gjk_big *y) {
  check_big(x);
  check_big(y);
  return any_bool();
}

void gjk_big_divide(gjk_big *x, const gjk_big *y) {
  check_big(x);
  check_big(y);
  any_big(x);
}

int64_t gjk_big_nearest(gjk_big *x, const gjk_big *y) {
  check_big(x);
  check_big(y);
  any_big(x);
  return any_long();
}
