// One number over every bit that fixed sets of casts, rays and times of impact answer, in space and in the plane: the
// same on every target.
#ifndef MOTION_GOLDEN_H
#define MOTION_GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

// Pairs in the full set, and in the start of it that small emulated cores have time for; many: a larger set, for hosts.
#define MOTION_GOLDEN_PAIRS 1500
#define MOTION_GOLDEN_FEW_PAIRS 60
#define MOTION_GOLDEN_MANY_PAIRS 60000

// A changed bit is a changed contract: raise GJK_BITS_VERSION with these, and say why in the commit. The host's golden
// program prints the lines to put here.
#if GJK_BITS_VERSION != 6
#error "the golden hashes are those of GJK_BITS_VERSION 6: replace them"
#endif
#define MOTION_GOLDEN_HASH UINT64_C(0xf33668ac1b78f226)
#define MOTION_GOLDEN_MANY_HASH UINT64_C(0xc85db724f47cabb2)
#define MOTION_GOLDEN_FEW_HASH UINT64_C(0xb3cd5a7da0546f56)
#define PLANE_MOTION_GOLDEN_HASH UINT64_C(0x114b9f7ca27c2ae3)
#define PLANE_MOTION_GOLDEN_MANY_HASH UINT64_C(0xfde63c0eadc0d61a)
#define PLANE_MOTION_GOLDEN_FEW_HASH UINT64_C(0x2f8b7e3525021f6a)

// The hash over the first pairs of the set. Not reentrant: the colliders are static, to spare small stacks.
uint64_t motion_golden_hash(uint32_t pairs);
uint64_t plane_motion_golden_hash(uint32_t pairs);

#endif
