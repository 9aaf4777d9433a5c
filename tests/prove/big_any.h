// Any integer of 256 bits; one that is set.
#ifndef PROVE_BIG_ANY_H
#define PROVE_BIG_ANY_H

#include "any.h"
#include "src/arith/gjk_big.h"

static uint32_t any_limb(void) {
  return (uint32_t)any_int32();
}

static int64_t any_long(void) {
  return Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
}

static void any_big(gjk_big *x) {
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    x->limb[i] = any_limb();
  }
}

static void check_big(const gjk_big *x) {
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    //@ assert \initialized(&x->limb[i]);
  }
}

#endif
