// src/arith/gjk_big.h and gjk_big_angle.h on any numbers.
#include "src/arith/gjk_big_angle.h"

#include "big_any.h"

int main(void) {
  gjk_big x, y, out;
  any_big(&y);
  gjk_big_set(&x, any_long());
  check_big(&x);
  gjk_big_set_long(&x, any_long(), any_limb());
  check_big(&x);
  any_big(&x);
  gjk_big_add(&x, any_bool() ? &x : &y);
  gjk_big_subtract(&x, &y);
  gjk_big_scale(&x, any_limb());
  gjk_big_add_product(&x, &y, any_long());
  gjk_big_multiply(&out, &x, any_bool() ? &x : &y);
  check_big(&out);
  gjk_big_copy(&out, &y);
  check_big(&out);
  gjk_big_shift_up(&x, (unsigned)any_between(0, 255));
  gjk_big_shift_down(&y, (unsigned)any_between(0, 255));
  (void)gjk_big_is_at_least(&x, &y);
  (void)gjk_big_is_zero(&x);
  (void)gjk_big_is_negative(&x);
  (void)gjk_big_low(&x);
  any_big(&x);
  any_big(&y);
  gjk_big_angle(&x, &y, &out);
  check_big(&out);
  gjk_big_divide(&x, &y);
  check_big(&x);
  any_big(&x);
  (void)gjk_big_nearest(&x, &y);
  gjk_big_root(&y);
  check_big(&y);
  any_big(&y);
  gjk_big_length(&y);
  check_big(&y);
  return 0;
}
