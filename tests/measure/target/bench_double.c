// The reference in double.
#define real double
#define BENCH_SOLVER bench_double
#define BENCH_SOLVER_NAME "double"
#define BENCH_RELATIVE 1e-10
#define BENCH_ENCLOSING 1e-15

#include "bench_reference.h"

static double real_sqrt(double x) {
#if defined(__ARM_FP) && (__ARM_FP & 8)
  return __builtin_sqrt(x);
#else
  return soft_root_double(x);
#endif
}
