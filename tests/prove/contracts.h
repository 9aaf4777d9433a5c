// Contracts that stand in for a function's body under Eva: a precondition becomes one obligation per call. What the
// bodies do is shown by tests/prove/primitives.c.
#ifndef PROVE_CONTRACTS_H
#define PROVE_CONTRACTS_H

#include <stdint.h>

#include "gjk/format.h"

/*@ requires fits_x: -0x7fffffff <= a.x - b.x <= 0x7fffffff;
    requires fits_y: -0x7fffffff <= a.y - b.y <= 0x7fffffff;
    requires fits_z: -0x7fffffff <= a.z - b.z <= 0x7fffffff;
    assigns \result \from a, b;
    ensures \result.x == a.x - b.x && \result.x >= -0x7fffffff;
    ensures \result.y == a.y - b.y && \result.y >= -0x7fffffff;
    ensures \result.z == a.z - b.z && \result.z >= -0x7fffffff; */
static inline gjk_vec3 gjk_sub(gjk_vec3 a, gjk_vec3 b);

/*@ requires positive: x != 0;
    assigns \result \from x;
    ensures \result <= 31;
    ensures x >= 0x80000000 ==> \result == 0;
    ensures x >= 0x40000000 ==> \result <= 1;
    ensures x >= 0x20000000 ==> \result <= 2;
    ensures x >= 0x10000000 ==> \result <= 3;
    ensures x >= 0x8000 ==> \result <= 16;
    ensures x < 0x80000000 ==> \result >= 1;
    ensures x < 0x40000000 ==> \result >= 2;
    ensures x < 0x20000000 ==> \result >= 3; */
static inline unsigned gjk_clz32(uint32_t x);

/*@ requires positive: x != 0;
    assigns \result \from x;
    ensures \result <= 63;
    ensures x >= 0x8000000000000000 ==> \result == 0;
    ensures x >= 0x4000000000000000 ==> \result <= 1;
    ensures x >= 0x1000000000000000 ==> \result <= 3;
    ensures x >= 0x40000000 ==> \result <= 33;
    ensures x < 0x8000000000000000 ==> \result >= 1; */
static inline unsigned gjk_clz64(uint64_t x);

// The products, however they are made.
/*@ assigns \result \from a, b;
    ensures \result == a * b; */
static inline int64_t gjk_mul32(int32_t a, int32_t b);

/*@ assigns \result \from a, b;
    ensures \result == a * b; */
static inline uint64_t gjk_umul32(uint32_t a, uint32_t b);

#endif
