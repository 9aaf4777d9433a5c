// A long match with random inputs, and its hash. plane_scene_golden.c has the same of the plane.
#include "random.h"

#ifndef MATCH_OF_PLANE
#include "scene/match.h"
#include "scene_golden.h"
#endif

static match playing, saved;

static match_input input_of(uint32_t tick, uint64_t player) {
  random_state random = random_seed(tick * UINT64_C(2) + player);
  const uint32_t any = random_u32(&random);
  return (match_input)(any & any >> 8 & 0xFFu);  // each bit a quarter of the time
}

static void copy(match *to, const match *from) {
  const volatile uint32_t *word = (const void *)from;
  uint32_t *out = (void *)to;
  for (uint32_t i = 0; i < sizeof *from / sizeof *out; i++) {
    out[i] = word[i];
  }
}

uint64_t scene_golden_hash(uint32_t ticks, int rollbacks) {
  uint64_t sum = UINT64_C(0xCBF29CE484222325), saved_sum = sum;
  random_state random = random_seed(3);
  if (!match_start(&playing)) {
    return 0;
  }
  copy(&saved, &playing);
  for (uint32_t i = 0; i < ticks; i++) {
    const uint32_t what = rollbacks ? random_below(&random, 100) : 100;
    if (what < 3 || i - saved.tick > 30) {
      copy(&saved, &playing);
      saved_sum = sum;
    } else if (what < 5) {
      copy(&playing, &saved);
      sum = saved_sum;
      i = saved.tick;
    }
    if (!match_tick(&playing, input_of(i, 0), input_of(i, 1))) {
      return 0;
    }
    sum = (sum ^ match_hash(&playing)) * UINT64_C(0x100000001B3);
  }
  return sum;
}
