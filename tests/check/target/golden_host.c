// Host program: prints the golden hashes of this build.
#include "golden.h"

#include <inttypes.h>
#include <stdio.h>

#include "scene_golden.h"

int main(void) {
  const uint64_t few = golden_hash(GOLDEN_FEW_PAIRS), all = golden_hash(GOLDEN_PAIRS);
  const uint64_t scene = scene_golden_hash(SCENE_GOLDEN_FEW_TICKS, 1);
  printf("%016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", few, all, scene);
  return few == GOLDEN_FEW_HASH && all == GOLDEN_HASH && scene == SCENE_GOLDEN_FEW_HASH ? 0 : 1;
}
