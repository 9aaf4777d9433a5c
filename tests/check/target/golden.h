// One number over every bit that a fixed set of queries answers, the same on every target.
#ifndef GOLDEN_H
#define GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

// Pairs in the full set, and in the start of it that small emulated cores have time for; many: a larger set, for hosts.
#define GOLDEN_PAIRS 3000
#define GOLDEN_FEW_PAIRS 150
#define GOLDEN_MANY_PAIRS 30000

// A changed bit is a changed contract: raise GJK_BITS_VERSION with these, and say why in the commit.
#if GJK_BITS_VERSION != 6
#error "the golden hashes are those of GJK_BITS_VERSION 6: replace them"
#endif
#define GOLDEN_HASH UINT64_C(0xd8f80fbf1a5f69eb)
#define GOLDEN_MANY_HASH UINT64_C(0x09145ff42abeec9e)
#define GOLDEN_FEW_HASH UINT64_C(0xf4805fbe972352f0)

// The hash over the first pairs of the set. Not reentrant: the colliders are static, to spare small stacks.
uint64_t golden_hash(uint32_t pairs);

#endif
