// Integers of up to 512 bits.
#include "integer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const exact_int zero = {0, 0, {0}};

static void require_room(unsigned limbs) {
  if (limbs > EXACT_LIMBS) {
    fprintf(stderr, "exact_int: more than %d bits\n", 32 * EXACT_LIMBS);
    abort();
  }
}

// Drops leading zeros; the value 0 gets sign 0.
static void trim(exact_int *a) {
  while (a->count > 0 && a->limb[a->count - 1] == 0) {
    a->count--;
  }
  if (a->count == 0) {
    a->sign = 0;
  }
}

exact_int exact_from(int64_t value) {
  exact_int a = zero;
  const uint64_t magnitude = value < 0 ? (uint64_t)0 - (uint64_t)value : (uint64_t)value;
  a.sign = value < 0 ? -1 : 1;
  a.count = 2;
  a.limb[0] = (uint32_t)magnitude;
  a.limb[1] = (uint32_t)(magnitude >> 32);
  trim(&a);
  return a;
}

exact_int exact_negate(exact_int a) {
  a.sign = -a.sign;
  return a;
}

static int compare_magnitudes(const exact_int *a, const exact_int *b) {
  if (a->count != b->count) {
    return a->count < b->count ? -1 : 1;
  }
  for (unsigned i = a->count; i-- > 0;) {
    if (a->limb[i] != b->limb[i]) {
      return a->limb[i] < b->limb[i] ? -1 : 1;
    }
  }
  return 0;
}

// |a| + |b|. Pre: |a| >= |b|.
static exact_int add_magnitudes(const exact_int *a, const exact_int *b) {
  exact_int sum = zero;
  uint64_t carry = 0;
  for (unsigned i = 0; i < a->count; i++) {
    carry += (uint64_t)a->limb[i] + (i < b->count ? b->limb[i] : 0);
    sum.limb[i] = (uint32_t)carry;
    carry >>= 32;
  }
  sum.count = a->count;
  if (carry != 0) {
    require_room(sum.count + 1);
    sum.limb[sum.count++] = (uint32_t)carry;
  }
  return sum;
}

// |a| - |b|. Pre: |a| >= |b|.
static exact_int subtract_magnitudes(const exact_int *a, const exact_int *b) {
  exact_int difference = zero;
  uint32_t borrow = 0;
  for (unsigned i = 0; i < a->count; i++) {
    const uint64_t taken = (uint64_t)borrow + (i < b->count ? b->limb[i] : 0);
    difference.limb[i] = (uint32_t)(a->limb[i] - taken);
    borrow = a->limb[i] < taken;
  }
  difference.count = a->count;
  return difference;
}

exact_int exact_add(const exact_int *a, const exact_int *b) {
  const exact_int *large = a, *small = b;
  if (compare_magnitudes(a, b) < 0) {
    large = b;
    small = a;
  }
  exact_int sum = large->sign * small->sign < 0 ? subtract_magnitudes(large, small) : add_magnitudes(large, small);
  sum.sign = large->sign;
  trim(&sum);
  return sum;
}

exact_int exact_sub(const exact_int *a, const exact_int *b) {
  const exact_int opposite = exact_negate(*b);
  return exact_add(a, &opposite);
}

exact_int exact_mul(const exact_int *a, const exact_int *b) {
  exact_int product = zero;
  if (a->sign == 0 || b->sign == 0) {
    return product;
  }
  // The product has count or count - 1 limbs. Only numbers far above every bound of the tests come near the end.
  product.count = a->count + b->count;
  require_room(product.count);
  for (unsigned i = 0; i < a->count; i++) {
    uint64_t carry = 0;
    for (unsigned j = 0; j < b->count; j++) {
      carry += (uint64_t)a->limb[i] * b->limb[j] + product.limb[i + j];  // at most 2^64 - 1
      product.limb[i + j] = (uint32_t)carry;
      carry >>= 32;
    }
    product.limb[i + b->count] = (uint32_t)carry;
  }
  product.sign = a->sign * b->sign;
  trim(&product);
  return product;
}

int exact_compare(const exact_int *a, const exact_int *b) {
  if (a->sign != b->sign) {
    return a->sign < b->sign ? -1 : 1;
  }
  return a->sign * compare_magnitudes(a, b);
}

exact_int exact_product(int64_t a, int64_t b) {
  const exact_int x = exact_from(a), y = exact_from(b);
  return exact_mul(&x, &y);
}

void exact_add_to(exact_int *sum, exact_int x) {
  *sum = exact_add(sum, &x);
}

bool exact_is_rounded(int64_t value, exact_int x, exact_int y, int64_t scale, int half) {
  const exact_int twice_scale = exact_from(2 * scale), offset = exact_from(half), low = exact_from(2 * value),
                  high = exact_from(2 * (value + 1));
  exact_int middle = exact_mul(&x, &twice_scale);
  const exact_int below = exact_mul(&y, &low), above = exact_mul(&y, &high);
  exact_add_to(&middle, exact_mul(&y, &offset));
  return exact_compare(&below, &middle) <= 0 && exact_compare(&middle, &above) < 0;
}

double exact_to_double(const exact_int *a) {
  double value = 0;
  for (unsigned i = a->count; i-- > 0;) {
    value = value * 4294967296.0 + a->limb[i];  // only the first additions that are not exact can matter
  }
  return a->sign * value;
}
