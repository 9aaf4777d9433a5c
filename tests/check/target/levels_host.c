// Host program: levels_host BUILD LEVEL PAIRS prints the hashes of a level's set by query. Fails where this build, for BUILD,
// does not refuse just the kinds beyond that, or where the set does not have pairs both apart and overlapping.
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "levels.h"

static bool print_set(const char *name, uint32_t overlaps, uint32_t pairs, const uint64_t hash[LEVELS_QUERIES]) {
  printf("%s", name);
  for (int i = 0; i < LEVELS_QUERIES; i++) {
    printf(" %016" PRIx64, hash[i]);
  }
  printf("\n");
  return overlaps > pairs / 10 && overlaps < pairs - pairs / 10;
}

int main(int count, char **argument) {
  uint64_t hash[LEVELS_QUERIES];
  if (count != 4) {
    return 2;
  }
  const unsigned build = (unsigned)atoi(argument[1]), level = (unsigned)atoi(argument[2]);
  const uint32_t pairs = (uint32_t)atoi(argument[3]);
  const uint32_t in_space = levels_hash(level, pairs, hash);
  const bool mixed = print_set("space", in_space, pairs, hash);
  const uint32_t in_plane = plane_levels_hash(level, pairs, hash);
  const bool mixed_in_plane = print_set("plane", in_plane, pairs, hash);
  const bool refuses = levels_refused() == levels_beyond(build) && plane_levels_refused() == plane_levels_beyond(build);
  if (!mixed || !mixed_in_plane || !refuses) {
    fprintf(stderr, "overlapping %" PRIu32 " and %" PRIu32 " of %" PRIu32 ", refuses %s\n", in_space, in_plane, pairs,
            refuses ? "what it must" : "other kinds");
    return 1;
  }
  return 0;
}
