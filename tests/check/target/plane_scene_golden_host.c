// Host program: prints the hashes of the match of the plane in this build, without and with rollbacks.
#include <inttypes.h>
#include <stdio.h>

#include "plane_scene_golden.h"

int main(void) {
  const uint64_t few = plane_scene_golden_hash(PLANE_SCENE_GOLDEN_FEW_TICKS, 1);
  const uint64_t straight = plane_scene_golden_hash(PLANE_SCENE_GOLDEN_TICKS, 0),
                 rolled = plane_scene_golden_hash(PLANE_SCENE_GOLDEN_TICKS, 1);
  printf("%016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", few, straight, rolled);
  return few == PLANE_SCENE_GOLDEN_FEW_HASH && straight == PLANE_SCENE_GOLDEN_HASH && rolled == PLANE_SCENE_GOLDEN_HASH
             ? 0
             : 1;
}
