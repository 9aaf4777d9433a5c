// Template of a port: copy this folder, fill in what your target has, delete the rest. port/README.md is the contract.
#ifndef GJK_TEMPLATE_PORT_H
#define GJK_TEMPLATE_PORT_H

// A violated contract: log, halt or reset; never return into the query. Without it asserts are compiled out.
// void my_assert_failed(const char *condition);
// #define GJK_ASSERT(condition) ((condition) ? (void)0 : my_assert_failed(#condition))

// Leading zeros of a uint32_t that is not 0, where the core has an instruction and the compiler no builtin for it.
// #define GJK_CLZ32(x) __clz(x)

// 1 where a 32 x 32 -> 64 bit multiplication is a library call: Cortex-M0, 8- and 16-bit cores. Default 0.
// #define GJK_NARROW_MULTIPLY 1

// 1 where the compiler has a signed 128-bit integer. Default 0: two halves, the same results.
// #define GJK_INT128 1
// #define GJK_INT128_TYPE __int128

#endif
