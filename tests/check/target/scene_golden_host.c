// Host program: prints the hashes of the match in this build, without and with rollbacks.
#include <inttypes.h>
#include <stdio.h>

#include "scene_golden.h"

int main(void) {
  const uint64_t few = scene_golden_hash(SCENE_GOLDEN_FEW_TICKS, 1);
  const uint64_t straight = scene_golden_hash(SCENE_GOLDEN_TICKS, 0), rolled = scene_golden_hash(SCENE_GOLDEN_TICKS, 1);
  printf("%016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", few, straight, rolled);
  return few == SCENE_GOLDEN_FEW_HASH && straight == SCENE_GOLDEN_HASH && rolled == SCENE_GOLDEN_HASH ? 0 : 1;
}
