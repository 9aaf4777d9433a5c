// A small seeded generator of random numbers, splitmix64: a seed gives the same numbers on every target.
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

typedef struct random_state {
  uint64_t word;
} random_state;

static inline random_state random_seed(uint64_t seed) {
  random_state state = {seed};
  return state;
}

static inline uint64_t random_u64(random_state *state) {
  uint64_t z = state->word += UINT64_C(0x9E3779B97F4A7C15);
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return z ^ (z >> 31);
}

static inline uint32_t random_u32(random_state *state) {
  return (uint32_t)(random_u64(state) >> 32);
}

// A number from 0 to bound - 1. Pre: bound > 0.
static inline uint32_t random_below(random_state *state, uint32_t bound) {
  return (uint32_t)(((uint64_t)random_u32(state) * bound) >> 32);
}

// A number from low to high, both included. Pre: low <= high.
static inline int32_t random_range(random_state *state, int32_t low, int32_t high) {
  uint64_t width = (uint64_t)((int64_t)high - low) + 1;
  return (int32_t)((int64_t)((random_u64(state) >> 32) * width >> 32) + low);
}

#endif
