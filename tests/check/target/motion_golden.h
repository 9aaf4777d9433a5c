// One number over every bit that fixed sets of casts, rays and times of impact answer, in space and in the plane: the
// same on every target.
#ifndef MOTION_GOLDEN_H
#define MOTION_GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

// Pairs in the full set, and in the start of it that small emulated cores have time for.
#define MOTION_GOLDEN_PAIRS 1500
#define MOTION_GOLDEN_FEW_PAIRS 60

// A changed bit is a changed contract: raise GJK_BITS_VERSION with these, and say why in the commit. The host's golden
// program prints the lines to put here.
#if GJK_BITS_VERSION != 3
#error "the golden hashes are those of GJK_BITS_VERSION 3: replace them"
#endif
#define MOTION_GOLDEN_HASH UINT64_C(0x61b03fbb9e12e1b7)
#define MOTION_GOLDEN_FEW_HASH UINT64_C(0x5bdbcee0fd634809)
#define PLANE_MOTION_GOLDEN_HASH UINT64_C(0x218b6197a18607eb)
#define PLANE_MOTION_GOLDEN_FEW_HASH UINT64_C(0xc41a398a6046da67)

// The hash over the first pairs of the set. Not reentrant: the colliders are static, to spare small stacks.
uint64_t motion_golden_hash(uint32_t pairs);
uint64_t plane_motion_golden_hash(uint32_t pairs);

#endif
