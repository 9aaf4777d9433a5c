// One number over what a scene with concave bodies reports and answers: a mesh and a height field as ground, compounds that
// move, fast bodies, move and slide. It is the same on every target.
#ifndef CONCAVE_GOLDEN_H
#define CONCAVE_GOLDEN_H

#include <stdint.h>

#include "gjk/version.h"

#define CONCAVE_GOLDEN_TICKS 80
#define CONCAVE_GOLDEN_MANY_TICKS 800

// A changed bit is a changed contract: raise GJK_BITS_VERSION with this, and say why in the commit. The host's golden
// program prints the line to put here.
#if GJK_BITS_VERSION != 6
#error "the golden hash is that of GJK_BITS_VERSION 6: replace it"
#endif
#define CONCAVE_GOLDEN_MANY_HASH UINT64_C(0x7e00698d04f8f9a7)
#define CONCAVE_GOLDEN_HASH UINT64_C(0xb08740cd88e3bda9)

// The hash after so many ticks. 0: a call failed. Not reentrant: the scene is static, to spare small stacks.
uint64_t concave_golden_hash(uint32_t ticks);

#endif
