// The list of methods.
#include "method.h"

// A peer that is not linked has no list.
__attribute__((weak)) extern bench_method_list bench_ccd_methods, bench_bullet_methods, bench_fcl_methods;

static size_t append(const bench_method *const *list, const bench_method *out[], size_t count) {
  while (list != NULL && *list != NULL && count < BENCH_METHODS_MAX) {
    out[count++] = *list++;
  }
  return count;
}

size_t bench_methods(const bench_method *out[BENCH_METHODS_MAX]) {
  size_t count = append(bench_gjk_methods, out, 0);
  count = append(bench_reference_methods, out, count);
  count = append(bench_ccd_methods, out, count);
  count = append(bench_bullet_methods, out, count);
  return append(bench_fcl_methods, out, count);
}
