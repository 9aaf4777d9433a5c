// See given_ceilings.h. The usual ceilings here are those of gjk/format.h and src/arith/gjk_ceilings.h.
#include "given_ceilings.h"

#include <stdlib.h>

int given_iterations = 127, given_cast_iterations = 249, given_rounds = 63, given_plane_rounds = 71;

static void take(const char *name, int *ceiling) {
  const char *text = getenv(name);
  if (text) {
    *ceiling = atoi(text) - 1;
  }
}

__attribute__((constructor)) static void take_all(void) {
  take("GJK_TEST_ITERATIONS", &given_iterations);
  take("GJK_TEST_CAST_ITERATIONS", &given_cast_iterations);
  take("GJK_TEST_ROUNDS", &given_rounds);
  take("GJK_TEST_ROUNDS", &given_plane_rounds);
}
