// Host program: prints the hash of ground in this build.
#include <inttypes.h>
#include <stdio.h>

#include "ground_golden.h"

int main(void) {
  const uint64_t hash = ground_golden_hash();
  printf("%016" PRIx64 "\n", hash);
  return hash == GROUND_GOLDEN_HASH ? 0 : 1;
}
