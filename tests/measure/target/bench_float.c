// The reference in float.
#define real float
#define BENCH_SOLVER bench_float
#define BENCH_SOLVER_NAME "float"
#define BENCH_RELATIVE 1e-5f
#define BENCH_ENCLOSING 1e-11f

#include "bench_reference.h"

static float real_sqrt(float x) {
#if defined(__ARM_FP) && (__ARM_FP & 4)
  return __builtin_sqrtf(x);
#else
  return soft_root_float(x);
#endif
}
