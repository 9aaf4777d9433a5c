// FNV-1a, the hash of the golden sets, word by word.
#ifndef FNV_H
#define FNV_H

#include <stdint.h>

#define FNV_START UINT64_C(0xCBF29CE484222325)

// Goes on with the bytes of a word, lowest first: the same on either byte order.
static inline uint64_t fnv_word(uint64_t hash, uint32_t word) {
  for (int i = 0; i < 4; i++) {
    hash = (hash ^ (word & 0xFFu)) * UINT64_C(0x100000001B3);
    word >>= 8;
  }
  return hash;
}

#endif
