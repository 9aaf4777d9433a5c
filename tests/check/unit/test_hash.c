// Hashes of a program's own state. test_hash_orders.sh runs this on a big-endian machine as well.
#include <string.h>

#include "check.h"
#include "gjk/hash.h"
#include "random.h"

#define SEED 9200
#define TRIALS 20000u

// The step, from its definition with products of 32 bits.
static uint64_t step(uint64_t hash, uint32_t word) {
  const uint64_t x = hash ^ word, low = x & UINT32_MAX, high = x >> 32;
  const uint64_t factor_low = UINT64_C(0x7F4A7C15), factor_high = UINT64_C(0x9E3779B9);
  const uint64_t product = low * factor_low + ((high * factor_low + low * factor_high) << 32);
  return product ^ product >> 32;
}

// The same numbers everywhere.
static void check_known(void) {
  static const uint32_t words[3] = {1, UINT32_C(0x80000000), 0};
  static const char text[] = "lockstep";
  CHECK(gjk_hash_word(GJK_HASH_BEGIN, 0) == UINT64_C(0xC7C2E565C4B43CD8));
  CHECK(gjk_hash_words(GJK_HASH_BEGIN, words, 3) == UINT64_C(0xBBBC69B34324718F));
  CHECK(gjk_hash_bytes(GJK_HASH_BEGIN, text, 8) == UINT64_C(0x600D116F032C1B31));
  CHECK(gjk_hash_bytes(GJK_HASH_BEGIN, text, 7) == UINT64_C(0x6CDC6B9696AEA7A7));
}

static void check_random(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned long n = 0; n < check_trials(TRIALS); n++) {
    unsigned char bytes[40];
    uint32_t words[10] = {0};
    const uint32_t count = random_below(&random, 41);
    uint64_t hash = (uint64_t)random_u32(&random) << 32 | random_u32(&random), expected = hash;
    check_trial(n, NULL, NULL);
    for (uint32_t i = 0; i < count; i++) {
      bytes[i] = (unsigned char)(random_below(&random, 4) == 0 ? 0 : random_below(&random, 256));
      words[i / 4] |= (uint32_t)bytes[i] << i % 4 * 8;
    }
    for (uint32_t i = 0; i < (count + 3) / 4; i++) {
      CHECK(gjk_hash_word(expected, words[i]) == step(expected, words[i]));
      expected = step(expected, words[i]);
    }
    CHECK(gjk_hash_words(hash, words, (count + 3) / 4) == expected);
    CHECK(gjk_hash_bytes(hash, bytes, count) == step(expected, count));
    if (count > 0) {  // one bit
      const uint32_t at = random_below(&random, count);
      const uint64_t before = gjk_hash_bytes(hash, bytes, count);
      bytes[at] = (unsigned char)(bytes[at] ^ 1u << random_below(&random, 8));
      CHECK(gjk_hash_bytes(hash, bytes, count) != before);
    }
  }
}

// Where they are, how many zeros there are, and none at all.
static void check_edges(void) {
  unsigned char room[44];
  uint64_t seen[41];
  memset(room, 0, sizeof room);
  for (unsigned count = 0; count <= 40; count++) {
    seen[count] = gjk_hash_bytes(GJK_HASH_BEGIN, room, count);
    for (unsigned i = 0; i < count; i++) {
      CHECK(seen[i] != seen[count]);
    }
  }
  for (unsigned at = 0; at < 4; at++) {
    memcpy(room + at, "0123456789", 10);
    CHECK(gjk_hash_bytes(7, room + at, 10) == gjk_hash_bytes(7, "0123456789", 10));
  }
  CHECK(gjk_hash_words(7, NULL, 3) == 7 && gjk_hash_words(7, (const uint32_t[]){1}, 0) == 7);
  CHECK(gjk_hash_bytes(7, NULL, 3) == gjk_hash_bytes(7, room, 0));
}

int main(void) {
  check_known();
  check_random();
  check_edges();
  return check_done("hash");
}
