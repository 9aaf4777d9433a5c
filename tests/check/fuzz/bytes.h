// Reads a fuzzer's input as a stream of values, which are 0 after its end, and makes pairs of them.
#ifndef FUZZ_BYTES_H
#define FUZZ_BYTES_H

#include "case/case.h"

typedef struct fuzz_bytes {
  const uint8_t *at, *end;
} fuzz_bytes;

static inline uint8_t fuzz_u8(fuzz_bytes *bytes) {
  return bytes->at < bytes->end ? *bytes->at++ : 0;
}

// A number of several bytes, lowest byte first.
static inline int32_t fuzz_i32(fuzz_bytes *bytes) {
  uint32_t value = 0;
  for (unsigned i = 0; i < 32; i += 8) {
    value |= (uint32_t)fuzz_u8(bytes) << i;
  }
  return (int32_t)value;
}

static inline gjk_vec3 fuzz_vec3(fuzz_bytes *bytes) {
  gjk_vec3 v;
  v.x = fuzz_i32(bytes);
  v.y = fuzz_i32(bytes);
  v.z = fuzz_i32(bytes);
  return v;
}

static inline gjk_cache fuzz_cache(fuzz_bytes *bytes) {
  gjk_cache cache;
  for (int i = 0; i < 3; i++) {
    cache.direction[i] = (int16_t)(fuzz_u8(bytes) << 8 | fuzz_u8(bytes));
  }
  cache.count = fuzz_u8(bytes);
  for (int i = 0; i < 4; i++) {
    cache.a[i] = fuzz_u8(bytes);
    cache.b[i] = fuzz_u8(bytes);
  }
  return cache;
}

// Makes a pair of shapes. Both are within the limits of a case; all else is as the bytes say. seeds.c writes the same
// format.
void fuzz_pair(fuzz_bytes *bytes, case_pair *pair);

// Ends the program so that the fuzzer notices it.
void fuzz_fail(const char *what);

#endif
