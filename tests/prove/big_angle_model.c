// Stands in for src/arith/gjk_big_angle.c: any number, as tests/prove/big.c shows.
#include "src/arith/gjk_big_angle.h"

#include "big_any.h"

const gjk_big gjk_big_pi_q96 = {{UINT32_C(0x13198A2E), UINT32_C(0x85A308D3), UINT32_C(0x243F6A88), UINT32_C(3)}};

void gjk_big_root(gjk_big *x) {
  any_big(x);
}

void gjk_big_length(gjk_big *x) {
  any_big(x);
}

void gjk_big_angle(const gjk_big *x, const gjk_big *y, gjk_big *out) {
  (void)x, (void)y;
  any_big(out);
}
