// Counting checks: a failed one prints its place and the program goes on.
#ifndef CHECK_H
#define CHECK_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static unsigned long check_passed, check_failed;

// What a failed check shows beside its place, in tests with random trials.
static struct {
  bool seeded, numbered;
  uint64_t seed;
  unsigned long trial;
  void (*print)(const void *subject);  // NULL: nothing, or it was shown
  const void *subject;
} check_now;

// The seed of a random test is this one. The first call prints it.
static inline uint64_t check_seeded(uint64_t seed) {
  if (!check_now.seeded) {
    printf("seed %llu\n", (unsigned long long)seed);
  }
  check_now.seeded = true;
  check_now.seed = seed;
  return seed;
}

// The same: GJK_TEST_SEED, or else the test's own.
static inline uint64_t check_seed(uint64_t own) {
  const char *given = getenv("GJK_TEST_SEED");
  return check_seeded(given == NULL ? own : strtoull(given, NULL, 10));
}

// A trial begins: if a check of it fails, print shows subject; NULL: its number says it all.
static inline void check_trial(unsigned long number, void (*print)(const void *subject), const void *subject) {
  check_now.numbered = true;
  check_now.trial = number;
  check_now.print = print;
  check_now.subject = subject;
}

static inline void check_show(void) {
  if (check_now.seeded && check_now.numbered) {
    printf("  trial %lu of seed %llu\n", check_now.trial, (unsigned long long)check_now.seed);
  }
  if (check_now.print != NULL) {
    check_now.print(check_now.subject);
    check_now.print = NULL;
  }
}

#define CHECK_MSG(condition, ...)                                    \
  do {                                                               \
    if (condition) {                                                 \
      check_passed++;                                                \
    } else {                                                         \
      check_failed++;                                                \
      printf("%s:%d: failed: %s: ", __FILE__, __LINE__, #condition); \
      printf(__VA_ARGS__);                                           \
      printf("\n");                                                  \
      check_show();                                                  \
    }                                                                \
  } while (0)

#define CHECK(condition) CHECK_MSG(condition, "%s", "")

// How many of n random trials to make: all, or GJK_TEST_PERCENT of them, for runs that repeat the tests many times over.
static inline unsigned long check_trials(unsigned long n) {
  const char *percent = getenv("GJK_TEST_PERCENT");
  const unsigned long share = percent == NULL ? n : n * strtoul(percent, NULL, 10) / 100;
  return share > 0 ? share : 1;
}

// The program's exit status; prints the line that the test runner adds up.
static inline int check_done(const char *name) {
  printf("%s: %lu passed, %lu failed\n", name, check_passed, check_failed);
  return check_failed == 0 && check_passed > 0 ? 0 : 1;
}

#endif
