// What the core asks of its surroundings: an assert and a few optional primitives.
//
// A port is a header that defines some of the macros below, named by GJK_PORT_HEADER, for example
// -DGJK_PORT_HEADER='"generic/gjk_port.h"' -Iport. Without one, the defaults here are complete, portable C. A port
// changes speed and what a failed assert does, never an answer. port/README.md is the contract.
#ifndef GJK_SRC_PORT_DEFAULTS_H
#define GJK_SRC_PORT_DEFAULTS_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef GJK_PORT_HEADER
#include GJK_PORT_HEADER
#endif

#if CHAR_BIT != 8
#error "gjk needs 8-bit bytes: this target's char has another width, and no setting can change that"
#endif

// GJK_ASSERT(condition): a violated contract that no status can express. Default: compiled out.
#ifndef GJK_ASSERT
#define GJK_ASSERT(condition) ((void)0)
#endif

// GJK_CLZ32(x): leading zeros of a uint32_t that is not 0. Default: portable C in wide.h.

// GJK_NARROW_MULTIPLY: 1 on a core without a multiplication of 32 x 32 to 64 bits, which is better off with four
// products of halves. Default 0: the language's own.
#ifndef GJK_NARROW_MULTIPLY
#define GJK_NARROW_MULTIPLY 0
#endif
#if GJK_NARROW_MULTIPLY != 0 && GJK_NARROW_MULTIPLY != 1
#error "GJK_NARROW_MULTIPLY must be 0 or 1: set it to 1 in the port header for cores without 32 x 32 -> 64 bits"
#endif

// GJK_INT128: 1 where the compiler has a signed 128-bit integer named by GJK_INT128_TYPE. Default: two halves.
#ifndef GJK_INT128
#define GJK_INT128 0
#endif
#if GJK_INT128 != 0 && GJK_INT128 != 1
#error "GJK_INT128 must be 0 or 1: set it to 1 in the port header where the compiler has a 128-bit integer"
#endif
#if GJK_INT128 && !defined(GJK_INT128_TYPE)
#error "GJK_INT128 is 1 without a type: define GJK_INT128_TYPE in the port header, for example __int128"
#endif

#endif
