// One step of a hash.
#ifndef GJK_SRC_HASH_H
#define GJK_SRC_HASH_H

#include "gjk/format.h"

// For a fixed value of one argument, different values of the other one give different results.
static inline uint64_t gjk_hash_step(uint64_t hash, uint32_t word) {
  hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
  return hash ^ hash >> 32;
}

#endif
