// Integers of 256 bits, limb by limb.
#include "gjk_big.h"

#include "gjk_memory.h"

void gjk_big_set(gjk_big *x, int64_t value) {
  const uint32_t sign = value < 0 ? UINT32_MAX : 0;
  x->limb[0] = gjk_low32(value);
  x->limb[1] = (uint32_t)((uint64_t)value >> 32);
  for (int i = 2; i < GJK_BIG_LIMBS; i++) {
    *(volatile uint32_t *)&x->limb[i] = sign;
  }
}

void gjk_big_copy(gjk_big *to, const gjk_big *from) {
  gjk_copy(to, from, sizeof *to);
}

void gjk_big_add(gjk_big *x, const gjk_big *y) {
  uint64_t carry = 0;
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    carry += (uint64_t)x->limb[i] + y->limb[i];  // <= 2 (2^32 - 1) + 1
    x->limb[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

void gjk_big_subtract(gjk_big *x, const gjk_big *y) {
  uint64_t carry = 1;
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    carry += (uint64_t)x->limb[i] + (UINT32_MAX - y->limb[i]);
    x->limb[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

// x += 2^(32 shift) y factor.
static void add_scaled(gjk_big *x, const gjk_big *y, uint32_t factor, int shift) {
  uint64_t carry = 0;
  for (int i = shift; i < GJK_BIG_LIMBS; i++) {
    // <= (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1
    carry += gjk_umul32(y->limb[i - shift], factor) + x->limb[i];
    x->limb[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

void gjk_big_scale(gjk_big *x, uint32_t factor) {
  uint64_t carry = 0;
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    carry += gjk_umul32(x->limb[i], factor);  // <= (2^32 - 1)^2 + 2^32 - 1
    x->limb[i] = (uint32_t)(carry & UINT32_MAX);
    carry >>= 32;
  }
}

void gjk_big_multiply(gjk_big *out, const gjk_big *x, const gjk_big *y) {
  gjk_big_set(out, 0);
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    if (y->limb[i] != 0) {
      add_scaled(out, x, y->limb[i], i);
    }
  }
}

void gjk_big_set_long(gjk_big *x, int64_t high, uint32_t low) {
  gjk_big rest;
  gjk_big_set(&rest, low);
  gjk_big_set(x, high);
  gjk_big_scale(x, UINT32_C(1) << 31);
  gjk_big_add(x, &rest);
}

void gjk_big_add_product(gjk_big *x, const gjk_big *y, int64_t factor) {
  gjk_big other, product;
  gjk_big_set(&other, factor);
  gjk_big_multiply(&product, &other, y);
  gjk_big_add(x, &product);
}

bool gjk_big_is_zero(const gjk_big *x) {
  uint32_t bits = 0;
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    bits |= x->limb[i];
  }
  return bits == 0;
}

// x = -x.
static void negate_big(gjk_big *x) {
  gjk_big kept;
  gjk_big_copy(&kept, x);
  gjk_big_set(x, 0);
  gjk_big_subtract(x, &kept);
}

void gjk_big_shift_up(gjk_big *x, unsigned bits) {
  const int limbs = (int)(bits / 32u);
  const unsigned rest = bits % 32u;
  for (int i = GJK_BIG_LIMBS - 1; i >= 0; i--) {
    const uint32_t own = i >= limbs ? x->limb[i - limbs] : 0, below = i > limbs ? x->limb[i - limbs - 1] : 0;
    x->limb[i] = own << rest | (below >> 1) >> (31u - rest);
  }
}

void gjk_big_shift_down(gjk_big *x, unsigned bits) {
  const int limbs = (int)(bits / 32u);
  const unsigned rest = bits % 32u;
  for (int i = 0; i < GJK_BIG_LIMBS; i++) {
    const uint32_t own = i + limbs < GJK_BIG_LIMBS ? x->limb[i + limbs] : 0,
                   above = i + limbs + 1 < GJK_BIG_LIMBS ? x->limb[i + limbs + 1] : 0;
    x->limb[i] = own >> rest | (above << 1) << (31u - rest);
  }
}

bool gjk_big_is_at_least(const gjk_big *x, const gjk_big *y) {
  for (int i = GJK_BIG_LIMBS; i > 0; i--) {
    if (x->limb[i - 1] != y->limb[i - 1]) {
      return x->limb[i - 1] > y->limb[i - 1];
    }
  }
  return true;
}

void gjk_big_divide(gjk_big *x, const gjk_big *y) {
  gjk_big rest, multiple;
  const bool negative = gjk_big_is_negative(x);
  unsigned bits = 1;
  gjk_big_copy(&rest, x);
  if (negative) {
    negate_big(&rest);
  }
  gjk_big_copy(&multiple, y);
  while (!gjk_big_is_negative(&multiple) && gjk_big_is_at_least(&rest, &multiple)) {  // at most 255 times
    gjk_big_add(&multiple, &multiple);
    bits++;
  }
  gjk_big_set(x, 0);
  for (; bits > 0; bits--) {  // rest < 2 multiple
    gjk_big_add(x, x);
    if (gjk_big_is_at_least(&rest, &multiple)) {
      gjk_big_subtract(&rest, &multiple);
      x->limb[0] |= 1;
    }
    gjk_big_shift_down(&multiple, 1);
  }
  if (negative) {  // floor(-a) = -ceil(a)
    gjk_big one;
    gjk_big_set(&one, gjk_big_is_zero(&rest) ? 0 : 1);
    gjk_big_add(x, &one);
    negate_big(x);
  }
}

int64_t gjk_big_nearest(gjk_big *x, const gjk_big *y) {
  gjk_big twice;
  gjk_big_add(x, x);
  gjk_big_add(x, y);
  gjk_big_copy(&twice, y);
  gjk_big_add(&twice, &twice);
  gjk_big_divide(x, &twice);
  return gjk_big_low(x);
}
