// What the core asks of its surroundings: an assert and a few optional primitives.
//
// A port is a header that defines some of the macros below. GJK_PORT_HEADER names it, for example
// -DGJK_PORT_HEADER='"generic/gjk_port.h"' -Iport. If no macro names one, compilers that can look for it take a
// gjk_port.h on the include path. The defaults below are complete, so no port is needed. A port changes only speed and
// what a failed assert does, never an answer. port/README.md is the contract.
//
// This file and gjk_wide.h are the only ones of the core that look at the compiler.
#ifndef GJK_SRC_PORT_DEFAULTS_H
#define GJK_SRC_PORT_DEFAULTS_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// What GJK_SHAPES may be.
#define GJK_SHAPES_POINTS 1     // points with a radius alone: spheres; circles in the plane
#define GJK_SHAPES_ROUND 2      // and segments: capsules
#define GJK_SHAPES_BOXES 3      // and boxes, rounded or not
#define GJK_SHAPES_POLYTOPES 4  // and triangles, hulls and polygons
#define GJK_SHAPES_ALL 5        // and curved shapes

#ifdef GJK_PORT_HEADER
#include GJK_PORT_HEADER
#elif defined(__has_include)
#if __has_include(<gjk_port.h>)
#include <gjk_port.h>
#endif
#endif

// GJK_SHAPES: the kinds of shapes that a program has. Code for kinds beyond these is left out, and gjk_collider_init
// refuses them. Default: all.
#ifndef GJK_SHAPES
#define GJK_SHAPES GJK_SHAPES_ALL
#endif
#if GJK_SHAPES < GJK_SHAPES_POINTS || GJK_SHAPES > GJK_SHAPES_ALL
#error "GJK_SHAPES must be one of GJK_SHAPES_POINTS, _ROUND, _BOXES, _POLYTOPES and _ALL"
#endif

#if CHAR_BIT != 8
#error "gjk needs 8-bit bytes: this target's char has another width, and no setting can change that"
#endif

// GJK_ASSERT(condition): a violated contract that no status can express. Default: compiled out.
#ifndef GJK_ASSERT
#define GJK_ASSERT(condition) ((void)0)
#endif

// GJK_CLZ32(x): leading zeros of a uint32_t that is not 0. Default, in gjk_clz32 of gjk_wide.h: the builtin of gcc and
// clang where the core has the instruction; portable C, five comparisons, on ARM before ARMv7, ARMv8-M baseline,
// RISC-V, cores with a 16-bit int, and with other compilers.

// GJK_NARROW_MULTIPLY: 1 on a core without a multiplication of 32 x 32 to 64 bits. Four products of 16-bit halves are
// faster there than the compiler's library call. Default: 1 on ARMv6-M (Cortex-M0, M0+, M1), ARMv8-M baseline
// (Cortex-M23), AVR, and RISC-V without multiplication; else 0, the language's own product.
#ifndef GJK_NARROW_MULTIPLY
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__) || defined(__AVR__)
#define GJK_NARROW_MULTIPLY 1
#elif defined(__riscv) && !defined(__riscv_mul)
#define GJK_NARROW_MULTIPLY 1
#else
#define GJK_NARROW_MULTIPLY 0
#endif
#endif
#if GJK_NARROW_MULTIPLY != 0 && GJK_NARROW_MULTIPLY != 1
#error "GJK_NARROW_MULTIPLY must be 0 or 1: set it to 1 in the port header for cores without 32 x 32 -> 64 bits"
#endif

// GJK_VECTORS: 1 on a core with vectors of 128 bits: x86 with SSE2, which is all x86-64, and AArch64. Scans over many
// vertices then look at eight at a time. Default: 1 there with gcc and clang, unless they optimise for size; else 0.
#if defined(__GNUC__) && (defined(__SSE2__) || (defined(__aarch64__) && !defined(__AARCH64EB__))) && \
    !GJK_NARROW_MULTIPLY
#define GJK_HAS_VECTORS 1
#else
#define GJK_HAS_VECTORS 0
#endif
#if GJK_HAS_VECTORS && defined(__SSE2__) && defined(__has_builtin)
#if !__has_builtin(__builtin_ia32_packssdw128) || !__has_builtin(__builtin_ia32_packsswb128) || \
    !__has_builtin(__builtin_ia32_pmaddwd128) || !__has_builtin(__builtin_ia32_pmovmskb128)
#undef GJK_HAS_VECTORS
#define GJK_HAS_VECTORS 0
#endif
#endif
#ifndef GJK_VECTORS
#if GJK_HAS_VECTORS && !defined(__OPTIMIZE_SIZE__)
#define GJK_VECTORS 1
#else
#define GJK_VECTORS 0
#endif
#endif
#if GJK_VECTORS != 0 && (GJK_VECTORS != 1 || !GJK_HAS_VECTORS)
#error "GJK_VECTORS must be 0 or 1, and 0 without SSE2 or AArch64, gcc or clang: set it to 0 in the port header"
#endif

// GJK_INT128: 1 where the compiler has a signed 128-bit integer named by GJK_INT128_TYPE. Default 0: two halves.
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
