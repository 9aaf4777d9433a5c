// Newton's iterations for every number that they take, every step or, for a quick look, with larger ones: what
// tests/prove/contracts.h says of them. tests/build/bounds.sh builds it with the assertions of the sources as checks.
#include <stdio.h>
#include <stdlib.h>

#include "src/arith/gjk_root.h"
#include "src/arith/gjk_wide.c"
#include "src/plane/gjk2_measure.c"

int main(int count, char **arguments) {
  const uint64_t step = count > 1 ? strtoull(arguments[1], NULL, 10) : 1;
  for (uint64_t x = UINT64_C(1) << 30; x <= UINT32_MAX; x += step) {
    const uint32_t y = gjk_reciprocal_root((uint32_t)x);
    if (y < 0x3FFFFFFF || y > 0x7FFFFFFF) {
      printf("root of %llu: %lu\n", (unsigned long long)x, (unsigned long)y);
      return 1;
    }
    const uint32_t z = gjk2_inverse_root((uint32_t)x);
    if (z < 0x3FFFFFFF || z > 0x7FFFFFFF) {
      printf("root of the plane of %llu: %lu\n", (unsigned long long)x, (unsigned long)z);
      return 1;
    }
  }
  for (uint64_t x = UINT64_C(1) << 31; x <= UINT32_MAX; x += step) {
    const uint32_t y = gjk_reciprocal((uint32_t)x);
    if (y < 0x7FFFFFFF) {
      printf("reciprocal of %llu: %lu\n", (unsigned long long)x, (unsigned long)y);
      return 1;
    }
  }
  return 0;
}
