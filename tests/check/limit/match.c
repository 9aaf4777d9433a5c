// Plays the lockstep match in small workspaces, under the ceiling on iterations that it is built with: with skipped
// tests, with every pair tested anew, and saved and rolled back at random. Prints how many ticks had the same hash, and
// how many queries were left unsettled.
#include <stdio.h>
#include <string.h>

#include "random.h"
#include "scene/match.h"
#include "src/scene/gjk_scene_block.h"

#define TICKS 250u
#define CELLS_MOST 60u
#define CELLS_STEP 12u

static match plain, unskipped, rolled, saved;
static uint64_t hashes[TICKS];

static match_input input_of(uint32_t tick, uint64_t player) {
  random_state random = random_seed(tick * UINT64_C(2) + player);
  const uint32_t any = random_u32(&random);
  return (match_input)(any & any >> 8 & 0xFFu);  // each bit a quarter of the time
}

static bool begin(match *m, uint32_t cells, uint8_t retest_all) {
  gjk_scene_header *h = (void *)m->block;
  const bool fine = match_start(m);
  h->config.workspace_cells = cells;
  h->config.retest_all = retest_all;
  return fine;
}

static bool tick(match *m) {
  return match_tick(m, input_of(m->tick, 0), input_of(m->tick, 1));
}

// The hashes of a match that skips tests must be those of a match that tests every pair anew (retest_all).
static bool play(uint32_t cells, unsigned *unsettled) {
  bool same = begin(&plain, cells, 0) && begin(&unskipped, cells, 1);
  for (uint32_t i = 0; i < TICKS && same; i++) {
    const gjk_scene_header *h = (const void *)plain.block;
    same = tick(&plain) && tick(&unskipped);
    hashes[i] = match_hash(&plain);
    same = same && hashes[i] != 0 && match_hash(&unskipped) == hashes[i];
    *unsettled += h->stats.unsettled;
  }
  return same;
}

// The same for a match that goes back to saves.
static bool play_rolled(uint32_t cells) {
  random_state random = random_seed(cells);
  bool same = begin(&rolled, cells, 0);
  saved = rolled;
  for (unsigned left = 3 * TICKS; rolled.tick < TICKS && same; left--) {
    const uint32_t what = random_below(&random, 20);
    if (what == 0) {
      saved = rolled;
    } else if (what == 1 && left > TICKS) {
      rolled = saved;
    }
    const uint32_t at = rolled.tick;
    same = tick(&rolled) && match_hash(&rolled) == hashes[at];
  }
  return same;
}

int main(void) {
  unsigned unsettled = 0;
  for (uint32_t cells = 0; cells <= CELLS_MOST; cells += CELLS_STEP) {
    if (!play(cells, &unsettled) || !play_rolled(cells)) {
      printf("%u cells: different after tick %u\n", (unsigned)cells, (unsigned)plain.tick);
      return 1;
    }
  }
  printf("ceiling %d: %u queries unsettled\n", GJK_ITERATIONS_MAX, unsettled);
  return unsettled > 0 ? 0 : 1;
}
