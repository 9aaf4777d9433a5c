// Hashes of your own state, for lockstep: the step that gjk_scene_hash takes for each word. So one number compares
// bodies' speeds, counters and inputs as well as the scene.
//
//     uint64_t hash = GJK_HASH_BEGIN;
//     hash = gjk_hash_word(hash, tick);
//     hash = gjk_hash_words(hash, (const uint32_t *)speeds, 3 * count);  // gjk_vec3 speeds[]
//
// Every machine computes the same, of either byte order. Sums of hashes do not depend on the order of what is summed.
// A change of one word always changes the hash. It does not protect against words chosen to deceive.
//
// Bits  part of the contract, as answers are: another step is another GJK_BITS_VERSION.
// Cost  a product of 64 bits for each word.
#ifndef GJK_HASH_H
#define GJK_HASH_H

#include "gjk/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a hash starts from. Any other number will do, such as the hash of a scene.
#define GJK_HASH_BEGIN UINT64_C(0x6A09E667F3BCC909)

// The hash of what came so far, and of a word. A signed one is converted: (uint32_t)x.
uint64_t gjk_hash_word(uint64_t hash, uint32_t word);

// Of count words, by their values: as that many calls of gjk_hash_word. NULL: of none.
uint64_t gjk_hash_words(uint64_t hash, const uint32_t *words, size_t count);

// Of count bytes, as text or packets have them, and of their number. Not for the memory of structures: its holes and byte
// order differ between machines. As gjk_hash_words of the bytes' words, the first byte the lowest and the last word filled
// up with 0, and then of count modulo 2^32. NULL: of none.
uint64_t gjk_hash_bytes(uint64_t hash, const void *bytes, size_t count);

#ifdef __cplusplus
}
#endif

#endif
