// Hashes of your own state, for lockstep. Each word is mixed in as gjk_scene_hash does it. So one number can compare
// speeds, counters and inputs as well as the scene.
//
//     uint64_t hash = GJK_HASH_BEGIN;
//     hash = gjk_hash_word(hash, tick);
//     hash = gjk_hash_words(hash, (const uint32_t *)speeds, 3 * count);  // gjk_vec3 speeds[]
//
// Every machine computes the same hash, whatever its byte order. The sum of several hashes does not depend on their
// order. A change of one word always changes the hash. The hash does not protect against words chosen to deceive.
//
// Bits  part of the contract, like answers: a changed step changes GJK_BITS_VERSION.
// Cost  one 64-bit product for each word.
#ifndef GJK_HASH_H
#define GJK_HASH_H

#include "gjk/format.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a hash starts from. Any other number will do, such as the hash of a scene.
#define GJK_HASH_BEGIN UINT64_C(0x6A09E667F3BCC909)

// The hash after one more word. Convert a signed word: (uint32_t)x.
uint64_t gjk_hash_word(uint64_t hash, uint32_t word);

// The hash after count words, by their values: the same as count calls of gjk_hash_word. NULL: no words.
uint64_t gjk_hash_words(uint64_t hash, const uint32_t *words, size_t count);

// The hash after count bytes, such as text or a packet, and after their number. Not for the memory of structures: its
// padding and byte order differ between machines.
//
// The bytes are taken as words, the first byte the lowest, and the last word is filled up with 0. The hash is that of
// gjk_hash_words of these, and then of count modulo 2^32. NULL: no bytes.
uint64_t gjk_hash_bytes(uint64_t hash, const void *bytes, size_t count);

#ifdef __cplusplus
}
#endif

#endif
