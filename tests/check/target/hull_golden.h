// One number over every bit that hulls of a fixed set of points and their mass properties have, in space and in the plane:
// the same on every target.
#ifndef HULL_GOLDEN_H
#define HULL_GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

// Sets in the full list, and in the start of it that small emulated cores have time for; many: a larger set, for hosts.
#define HULL_GOLDEN_SETS 300
#define HULL_GOLDEN_FEW_SETS 20
#define HULL_GOLDEN_MANY_SETS 2000

// A changed bit is a changed contract: raise GJK_BITS_VERSION with these, and say why in the commit. The host's golden
// program prints the lines to put here.
#if GJK_BITS_VERSION != 6
#error "the golden hashes are those of GJK_BITS_VERSION 6: replace them"
#endif
#define HULL_GOLDEN_HASH UINT64_C(0x58982c10de33fe93)
#define HULL_GOLDEN_MANY_HASH UINT64_C(0xb7212fe621defe12)
#define HULL_GOLDEN_FEW_HASH UINT64_C(0xb100c49ba0d0f90c)

// The hash over the first sets. Not reentrant: the workspace is static, to spare small stacks.
uint64_t hull_golden_hash(uint32_t sets);

#endif
