// CHECK counts conditions that hold and that fail. A failed one prints its place, and the program goes on.
//
// A test ends with `return check_done(NAME)`. A test with random trials takes its seed from check_seed, so that
// GJK_TEST_SEED changes it, and calls check_trial before each trial, so that a failure names the trial.
#ifndef CHECK_H
#define CHECK_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static unsigned long check_passed, check_failed;

// What a failed check prints besides its place, in tests with random trials.
static struct {
  bool seeded, numbered;
  uint64_t seed;
  unsigned long trial;
  void (*print)(const void *subject);  // NULL: there is nothing to print, or it was printed before
  const void *subject;
} check_now;

// Sets the seed that failures name, and returns it. The first call prints it.
static inline uint64_t check_seeded(uint64_t seed) {
  if (!check_now.seeded) {
    printf("seed %llu\n", (unsigned long long)seed);
  }
  check_now.seeded = true;
  check_now.seed = seed;
  return seed;
}

// Sets, prints and returns the seed: GJK_TEST_SEED if that is set, else own.
static inline uint64_t check_seed(uint64_t own) {
  const char *given = getenv("GJK_TEST_SEED");
  return check_seeded(given == NULL ? own : strtoull(given, NULL, 10));
}

// Begins trial number: if one of its checks fails, print(subject) shows it once. print NULL: the number is enough.
static inline void check_trial(unsigned long number, void (*print)(const void *subject), const void *subject) {
  check_now.numbered = true;
  check_now.trial = number;
  check_now.print = print;
  check_now.subject = subject;
}

// Prints the present trial after a failure.
static inline void check_show(void) {
  if (check_now.seeded && check_now.numbered) {
    printf("  trial %lu of seed %llu\n", check_now.trial, (unsigned long long)check_now.seed);
  }
  if (check_now.print != NULL) {
    check_now.print(check_now.subject);
    check_now.print = NULL;
  }
}

// CHECK, with a printf format and its arguments to print after a failure.
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

// How many of n random trials to make: n, or GJK_TEST_PERCENT percent of n, at least 1. Mutants, coverage and quick
// looks set GJK_TEST_PERCENT, since they run the tests many times over.
static inline unsigned long check_trials(unsigned long n) {
  const char *percent = getenv("GJK_TEST_PERCENT");
  const unsigned long share = percent == NULL ? n : n * strtoul(percent, NULL, 10) / 100;
  return share > 0 ? share : 1;
}

// Are all trials made? A share of them need not show every kind of case.
static inline bool check_is_full(void) {
  return check_trials(100) >= 100;
}

// check_trials(n), but at least so many: for trials whose mix is asserted and needs them.
static inline unsigned long check_trials_least(unsigned long n, unsigned long least) {
  const unsigned long share = check_trials(n);
  return share > least ? share : least;
}

// Prints the counts, which tests/build/run-tests.sh adds up, and returns the exit status of the test: 1 also without
// any check.
static inline int check_done(const char *name) {
  printf("%s: %lu passed, %lu failed\n", name, check_passed, check_failed);
  return check_failed == 0 && check_passed > 0 ? 0 : 1;
}

#endif
