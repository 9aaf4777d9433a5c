// Square roots for cores without floating point, digit by digit on the bits of IEEE 754 numbers: what a soft libm does,
// at about the same cost. Rounded towards 0; 0 for what is not a positive normal number.
#ifndef SOFT_ROOT_H
#define SOFT_ROOT_H

#include <stdint.h>

static inline double soft_root_double(double x) {
  union {
    double number;
    uint64_t bits;
  } as = {x};
  const int exponent = (int)(as.bits >> 52) - 1023;
  if (exponent <= -1023 || exponent > 1023) {
    return 0;
  }
  // 1 <= rest / 2^52 < 4; the root's 53 bits come from the top.
  uint64_t rest = (as.bits & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
  rest <<= exponent & 1;
  uint64_t root = 0, twice = 0;
  for (uint64_t bit = UINT64_C(1) << 52; bit != 0; bit >>= 1) {
    if (twice + bit <= rest) {
      rest -= twice + bit;
      twice += 2 * bit;
      root += bit;
    }
    rest <<= 1;
  }
  as.bits = (root & ((UINT64_C(1) << 52) - 1)) | (uint64_t)(((exponent - (exponent & 1)) / 2) + 1023) << 52;
  return as.number;
}

static inline float soft_root_float(float x) {
  union {
    float number;
    uint32_t bits;
  } as = {x};
  const int exponent = (int)(as.bits >> 23) - 127;
  if (exponent <= -127 || exponent > 127) {
    return 0;
  }
  uint32_t rest = (as.bits & 0x7FFFFFu) | 0x800000u;
  rest <<= exponent & 1;
  uint32_t root = 0, twice = 0;
  for (uint32_t bit = UINT32_C(1) << 23; bit != 0; bit >>= 1) {
    if (twice + bit <= rest) {
      rest -= twice + bit;
      twice += 2 * bit;
      root += bit;
    }
    rest <<= 1;
  }
  as.bits = (root & 0x7FFFFFu) | (uint32_t)(((exponent - (exponent & 1)) / 2) + 127) << 23;
  return as.number;
}

#endif
