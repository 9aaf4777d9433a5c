// Template of a port: copy this folder, fill in what your target has, delete the rest. port/README.md is the contract.
#ifndef GJK_TEMPLATE_PORT_H
#define GJK_TEMPLATE_PORT_H

// What a violated contract does: log, halt or reset; it must not return into the query. Without it, nothing.
// void my_assert_failed(const char *condition);
// #define GJK_ASSERT(condition) ((condition) ? (void)0 : my_assert_failed(#condition))

// Leading zeros of a uint32_t that is not 0: an intrinsic of a compiler other than gcc and clang.
// #define GJK_CLZ32(x) __CLZ(x)

// 1 on a core without a multiplication of 32 x 32 to 64 bits. Found by itself for Cortex-M0, M0+, M1, M23, AVR and RV32
// without M, where the compiler is gcc or clang; to be defined for other 8- and 16-bit cores.
// #define GJK_NARROW_MULTIPLY 1

// 1 where the compiler has a signed 128-bit integer, and its name.
// #define GJK_INT128 1
// #define GJK_INT128_TYPE __int128

#endif
