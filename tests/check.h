// Counting checks: a failed one prints its place and the program goes on.
#ifndef CHECK_H
#define CHECK_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static unsigned long check_passed, check_failed;

#define CHECK_MSG(condition, ...)                                    \
  do {                                                               \
    if (condition) {                                                 \
      check_passed++;                                                \
    } else {                                                         \
      check_failed++;                                                \
      printf("%s:%d: failed: %s: ", __FILE__, __LINE__, #condition); \
      printf(__VA_ARGS__);                                           \
      printf("\n");                                                  \
    }                                                                \
  } while (0)

#define CHECK(condition) CHECK_MSG(condition, "%s", "")

// How many of n random trials to make: all, or GJK_TEST_PERCENT of them, for runs that repeat the tests many times over.
static inline unsigned long check_trials(unsigned long n) {
  const char *percent = getenv("GJK_TEST_PERCENT");
  const unsigned long share = percent == NULL ? n : n * strtoul(percent, NULL, 10) / 100;
  return share > 0 ? share : 1;
}

// The seed of a random test: GJK_TEST_SEED, or else its own. Printed, so that a failure can be had again.
static inline uint64_t check_seed(uint64_t own) {
  const char *given = getenv("GJK_TEST_SEED");
  const uint64_t seed = given == NULL ? own : strtoull(given, NULL, 10);
  printf("seed %llu\n", (unsigned long long)seed);
  return seed;
}

// The program's exit status; prints the line that the test runner adds up.
static inline int check_done(const char *name) {
  printf("%s: %lu passed, %lu failed\n", name, check_passed, check_failed);
  return check_failed == 0 && check_passed > 0 ? 0 : 1;
}

#endif
