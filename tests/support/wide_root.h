// The integer square root of products that need 128 bits.
#ifndef WIDE_ROOT_H
#define WIDE_ROOT_H

#include <stdint.h>

__extension__ typedef __int128 wide_square;

// floor(sqrt(square)). Pre: 0 <= square < 2^122.
static inline int64_t wide_root(wide_square square) {
  int64_t root = 0;
  for (int bit = 60; bit >= 0; bit--) {
    const int64_t more = root + (INT64_C(1) << bit);
    root = (wide_square)more * more <= square ? more : root;
  }
  return root;
}

#endif
