// What C says of its operators, for WP: conversions to unsigned types, shifts and bits as sums and products.
#ifndef PROVE_CHECKER_OPERATORS_H
#define PROVE_CHECKER_OPERATORS_H

#include <stdint.h>

/*@ axiomatic operators {
      // floor(x / 2^n): a word of its own, because WP 25 itself takes (x >> 4) <= 0 for x <= 0, which is wrong.
      logic integer down(integer x, integer n) reads \nothing;
      axiom shifted: \forall integer x, n; (x >> n) == down(x, n);
      axiom to_u16: \forall integer x; (uint16_t)x == x - 0x10000 * down(x, 16);
      axiom to_u32: \forall integer x; (uint32_t)x == x - 0x100000000 * down(x, 32);
      axiom to_u64: \forall integer x; (uint64_t)x == x - 0x10000000000000000 * down(x, 64);
      axiom shift0: \forall integer x, n; n == 0 ==> down(x, n) == x;
      axiom shift1: \forall integer x; 2 * down(x, 1) <= x < 2 * down(x, 1) + 2;
      axiom shift2: \forall integer x; 4 * down(x, 2) <= x < 4 * down(x, 2) + 4;
      axiom shift3: \forall integer x; 8 * down(x, 3) <= x < 8 * down(x, 3) + 8;
      axiom shift16: \forall integer x; 0x10000 * down(x, 16) <= x < 0x10000 * down(x, 16) + 0x10000;
      axiom shift27: \forall integer x; 0x8000000 * down(x, 27) <= x < 0x8000000 * down(x, 27) + 0x8000000;
      axiom shift30: \forall integer x; 0x40000000 * down(x, 30) <= x < 0x40000000 * down(x, 30) + 0x40000000;
      axiom shift31: \forall integer x; 0x80000000 * down(x, 31) <= x < 0x80000000 * down(x, 31) + 0x80000000;
      axiom shift32: \forall integer x; 0x100000000 * down(x, 32) <= x < 0x100000000 * down(x, 32) + 0x100000000;
      axiom shift33: \forall integer x; 0x200000000 * down(x, 33) <= x < 0x200000000 * down(x, 33) + 0x200000000;
      axiom shift62: \forall integer x;
        0x4000000000000000 * down(x, 62) <= x < 0x4000000000000000 * down(x, 62) + 0x4000000000000000;
      axiom shift63: \forall integer x;
        0x8000000000000000 * down(x, 63) <= x < 0x8000000000000000 * down(x, 63) + 0x8000000000000000;
      axiom shift64: \forall integer x;
        0x10000000000000000 * down(x, 64) <= x < 0x10000000000000000 * down(x, 64) + 0x10000000000000000;
      axiom left1: \forall integer x; (x << 1) == x * 2;
      axiom left16: \forall integer x; (x << 16) == x * 0x10000;
      axiom left29: \forall integer x; (x << 29) == x * 0x20000000;
      axiom left30: \forall integer x; (x << 30) == x * 0x40000000;
      axiom left31: \forall integer x; (x << 31) == x * 0x80000000;
      axiom left32: \forall integer x; (x << 32) == x * 0x100000000;
      axiom left62: \forall integer x; (x << 62) == x * 0x4000000000000000;
      axiom and2: \forall integer x; (x & 3) == x - 4 * down(x, 2);
      axiom and16: \forall integer x; (x & 0xffff) == x - 0x10000 * down(x, 16);
      axiom and31: \forall integer x; (x & 0x7fffffff) == x - 0x80000000 * down(x, 31);
      axiom and32: \forall integer x; (x & 0xffffffff) == x - 0x100000000 * down(x, 32);
      axiom above27: \forall integer x; (x & -0x8000000) == 0x8000000 * down(x, 27);
      axiom above30: \forall integer x; (x & -0x40000000) == 0x40000000 * down(x, 30);
      axiom above32: \forall integer x; (x & -0x100000000) == 0x100000000 * down(x, 32);
      axiom upper27: \forall integer x; 0 <= x < 0x100000000 ==> (x & 0xf8000000) == 0x8000000 * down(x, 27);
      axiom above31: \forall integer x; 0 <= x < 0x10000000000000000 ==> (x & 0xffffffff80000000) == 0x80000000 * down(x, 31);
      axiom from31: \forall integer x; (x & -0x80000000) == 0x80000000 * down(x, 31);
      axiom bit31: \forall integer x; 0 <= x < 0x100000000 ==> ((x & 0x80000000) == 0 <==> x < 0x80000000);
      axiom or16: \forall integer x, y;
        0 <= x == 0x10000 * down(x, 16) && 0 <= y < 0x10000 ==> (x | y) == x + y && (y | x) == x + y;
      axiom or31: \forall integer x, y;
        0 <= x == 0x80000000 * down(x, 31) && 0 <= y < 0x80000000 ==> (x | y) == x + y && (y | x) == x + y;
      axiom or31_above: \forall integer x, y;
        0 <= x < 0x80000000 && 0 <= y == 0x80000000 * down(y, 31) ==> (x | y) == x + y;
      axiom or32: \forall integer x, y;
        0 <= x == 0x100000000 * down(x, 32) && 0 <= y < 0x100000000 ==> (x | y) == x + y && (y | x) == x + y;
      axiom or62: \forall integer x, y;
        0 <= x == 0x4000000000000000 * down(x, 62) && 0 <= y < 0x4000000000000000 ==> (x | y) == x + y && (y | x) == x + y;
      axiom complement: \forall integer x; (~x) == -1 - x;
      axiom xor_sign: \forall integer x, y; (y == 0 ==> (x ^ y) == x) && (y == -1 ==> (x ^ y) == -1 - x);
      axiom sign_xor: \forall integer x, y; (x == 0 ==> (x ^ y) == y) && (x == -1 ==> (x ^ y) == -1 - y);
      axiom or_least: \forall integer x, y; 0 <= x && 0 <= y ==> (x | y) >= x && (x | y) >= y;
      axiom or30: \forall integer x, y; 0 <= x < 0x40000000 && 0 <= y < 0x40000000 ==> (x | y) < 0x40000000;
      axiom or_most: \forall integer x, y; 0 <= x < 0x100000000 && 0 <= y < 0x100000000 ==> (x | y) < 0x100000000;
    } */

// x with the bits of its sign turned, as the sources write it, and what or says of three such sizes.
#define ONES(x, n) (((x) ^ down(x, n)) == ((x) < 0 ? -1 - (x) : (x)))
#define JOINED(x, y, z) (((x) | (y) | (z)) >= (x) && ((x) | (y) | (z)) >= (y) && ((x) | (y) | (z)) >= (z))

#endif
