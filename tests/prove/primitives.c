// The bodies of what tests/prove/contracts.h has contracts for, on any input that those allow.
#include "any.h"
#include "vector.h"

int main(void) {
  const int32_t a = any_int32(), b = any_int32();
  const uint32_t x = (uint32_t)any_int32(), y = (uint32_t)any_int32();
  const uint64_t wide = ((uint64_t)x << 32) | y;
  const gjk_vec3 v = any_vec3(INT32_C(1) << 30), w = any_vec3((INT32_C(1) << 30) - 1);
  (void)gjk_mul32(a, b);
  (void)gjk_umul32(x, y);
  (void)gjk_sub(v, w);
  if (x != 0) {
    const unsigned zeros = gjk_clz32(x);
    //@ assert zeros <= 31;
  }
  if (x != 0 || y != 0) {
    const unsigned zeros = gjk_clz64(wide);
    //@ assert zeros <= 63;
  }
  return 0;
}
