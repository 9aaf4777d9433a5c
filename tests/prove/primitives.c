// The bodies of what tests/prove/contracts.h has contracts for: any numbers, and any vectors below 2^30. What longer ones
// may overflow is what the contracts ask of each caller.
#include "any.h"
#include "src/arith/gjk_vector.h"

int main(void) {
  const int32_t a = any_int32(), b = any_int32();
  const uint32_t x = (uint32_t)any_int32(), y = (uint32_t)any_int32();
  const gjk_vec3 corner[3] = {any_vec3(INT32_C(1) << 28), any_vec3(INT32_C(1) << 28), any_vec3(INT32_C(1) << 28)};
  const gjk_vec3 v = any_vec3(INT32_C(1) << 30), w = any_vec3((INT32_C(1) << 30) - 1);
  gjk_long3 n;
  (void)gjk_mul32(a, b);
  (void)gjk_umul32(x, y);
  (void)gjk_sub(v, w);
  (void)gjk_negate(v);
  (void)gjk_mac32(INT64_C(1) << 62, a, b / 2);
  (void)gjk_dot(&v, &w);
  gjk_cross(&v, &w, &n);
  gjk_triangle_normal(&corner[0], &corner[1], &corner[2], &n);
  if (x != 0) {
    const unsigned zeros = gjk_clz32(x);
    //@ assert zeros <= 31;
  }
  if (x != 0) {
    const unsigned zeros = gjk_clz64(((uint64_t)x << 32) | y);
    //@ assert zeros <= 31;
  } else if (y != 0) {
    const unsigned zeros = gjk_clz64(y);
    //@ assert zeros >= 32 && zeros <= 63;
  }
  return 0;
}
