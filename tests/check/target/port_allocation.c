// Checks a port's allocation: alignment, overlap, exhaustion, reuse.
#include "gjk/gjk.h"
#include "gjk_allocate.h"
#include "port.h"

#define BLOCKS_MAX 128u

typedef union strictest {
  gjk_collider collider;
  gjk_distance_result result;
  gjk_cache cache;
  int64_t number;
} strictest;

typedef struct probe {
  char first;
  strictest aligned;
} probe;

static port_counts counts;
static void (*say)(const char *text);
static unsigned char *blocks[BLOCKS_MAX];

static void check(bool good, const char *what) {
  if (good) {
    counts.passed++;
    return;
  }
  counts.failed++;
  say("failed: ");
  say(what);
  say("\n");
}

static size_t size_of(size_t block) {
  return 1 + block * 7 % 90;
}

// Takes blocks of mixed sizes until there are no more, and fills each with its number. Returns how many.
static size_t take(void) {
  size_t n = 0;
  while (n < BLOCKS_MAX && (blocks[n] = (unsigned char *)gjk_port_allocate(size_of(n))) != NULL) {
    check((uintptr_t)blocks[n] % offsetof(probe, aligned) == 0, "a block is aligned");
    for (size_t i = 0; i < size_of(n); i++) {
      blocks[n][i] = (unsigned char)n;
    }
    n++;
  }
  return n;
}

static void check_contents(size_t n) {
  for (size_t k = 0; k < n; k++) {
    bool intact = true;
    for (size_t i = 0; i < size_of(k); i++) {
      intact = intact && blocks[k][i] == (unsigned char)k;
    }
    check(intact, "no block overlaps another");
  }
}

static void check_exhaustion(size_t arena_bytes) {
  const size_t n = take();
  size_t taken = 0;
  for (size_t i = 0; i < n; i++) {
    taken += size_of(i);
  }
  check(n > 2 && n < BLOCKS_MAX, "the arena has an end");
  check(taken <= arena_bytes && taken * 2 > arena_bytes, "the arena has the size asked for, less what blocks cost");
  check(gjk_port_allocate(arena_bytes) == NULL, "nothing left");
  check_contents(n);

  gjk_port_release(blocks[n - 1]);
  check(gjk_port_allocate(size_of(n - 1)) == blocks[n - 1], "the newest block is used again");
  gjk_port_release(blocks[n - 2]);
  void *elsewhere = gjk_port_allocate(1);
  check(elsewhere != blocks[n - 2], "a block under another is not used again yet");
  gjk_port_release(elsewhere);
  gjk_port_release(blocks[n - 1]);
  void *both = gjk_port_allocate(size_of(n - 2) + size_of(n - 1));
  check(both == blocks[n - 2], "then both are");
  gjk_port_release(both);
  check_contents(n - 2);

  for (size_t i = 0; i < n - 2; i++) {  // oldest first, the worst order
    gjk_port_release(blocks[i]);
  }
  void *all = gjk_port_allocate(arena_bytes - 2 * sizeof(strictest));
  check(all == blocks[0], "after all are released the arena is whole again");
  gjk_port_release(all);
}

port_counts port_check_allocation(void (*print)(const char *text), size_t arena_bytes) {
  const port_counts none = {0, 0};
  counts = none;
  say = print;
  gjk_port_release(NULL);
  check(gjk_port_allocate(0) == NULL, "0 bytes are none");
  check(gjk_port_allocate(SIZE_MAX / 2 + 1) == NULL, "more bytes than an object can have are refused");
  check(gjk_port_allocate(SIZE_MAX) == NULL, "the size in units does not wrap around");
  if (arena_bytes != 0) {
    check_exhaustion(arena_bytes);
    return counts;
  }
  const size_t n = take();
  check(n == BLOCKS_MAX, "there is room");
  check_contents(n);
  for (size_t i = 0; i < n; i++) {
    gjk_port_release(blocks[i]);
  }
  return counts;
}
