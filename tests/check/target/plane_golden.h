// One number over every bit that a fixed set of queries in the plane answers, the same on every target.
#ifndef PLANE_GOLDEN_H
#define PLANE_GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

// Pairs in the full set, and in the start of it that small emulated cores have time for; many: a larger set, for hosts.
#define PLANE_GOLDEN_PAIRS 3000
#define PLANE_GOLDEN_FEW_PAIRS 150
#define PLANE_GOLDEN_MANY_PAIRS 60000

// A changed bit is a changed contract: raise GJK_BITS_VERSION with these, and say why in the commit. The host's golden
// program prints the lines to put here.
#if GJK_BITS_VERSION != 6
#error "the golden hashes are those of GJK_BITS_VERSION 6: replace them"
#endif
#define PLANE_GOLDEN_HASH UINT64_C(0xeb3f2dbf4da9cca5)
#define PLANE_GOLDEN_MANY_HASH UINT64_C(0x4bd55d2798e3d612)
#define PLANE_GOLDEN_FEW_HASH UINT64_C(0x598f60effdb438b6)

// The hash over the first pairs of the set. Not reentrant: the colliders are static, to spare small stacks.
uint64_t plane_golden_hash(uint32_t pairs);

#endif
