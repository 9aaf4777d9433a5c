// Hashes of a program's own state.
#include "gjk/hash.h"

#include "gjk_hash.h"

uint64_t gjk_hash_word(uint64_t hash, uint32_t word) {
  return gjk_hash_step(hash, word);
}

uint64_t gjk_hash_words(uint64_t hash, const uint32_t *words, size_t count) {
  for (size_t i = 0; words != NULL && i < count; i++) {
    hash = gjk_hash_step(hash, words[i]);
  }
  return hash;
}

uint64_t gjk_hash_bytes(uint64_t hash, const void *bytes, size_t count) {
  const unsigned char *byte = (const unsigned char *)bytes;
  const size_t length = byte == NULL ? 0 : count;
  uint32_t word = 0;
  for (size_t i = 0; i < length; i++) {
    word |= (uint32_t)byte[i] << i % 4 * 8;
    if (i % 4 == 3 || i + 1 == length) {
      hash = gjk_hash_step(hash, word);
      word = 0;
    }
  }
  return gjk_hash_step(hash, (uint32_t)(length & UINT32_MAX));
}
