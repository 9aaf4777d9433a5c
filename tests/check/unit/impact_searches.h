// Times of impact against a search of the whole way with proven bounds: between two fractions a gap can change by no more
// than the bodies' farthest points move.
//
// A test says before what its dimension is: the type trial, with a setup of times of impact and a family, and the types
// named as in space; and after it the functions declared here. A trial is shown by show where it fails.
#ifndef IMPACT_SEARCHES_H
#define IMPACT_SEARCHES_H

#include "check.h"
#include "exact/clearance.h"

#define TRIALS 1500

// The most distances of one search.
#define MEASUREMENTS 20000

#define ONE GJK_Q30_ONE

enum { NEEDLES, GRAZING, TURNING, FAST, STRAIGHT, FAMILIES };

static void show(const void *subject);

// Makes one of its family. False: it cannot be made.
static bool make(random_state *random, trial *t);

// The shapes at a fraction, and the time of impact.
static gjk_distance_result gap_at(const trial *t, gjk_q30 fraction);
static gjk_status ask(const trial *t, uint8_t iterations, gjk_impact_result *out);

// Sets the speed, and which gaps are clear: measured ones from least on, those between from between on.
static void set_clearance(const trial *t, clearance *c);

// Without turns a cast knows whether they touch.
static void check_cast(const trial *t, const gjk_impact_result *r, gjk_status status);

static struct {
  unsigned long made[FAMILIES], hits[FAMILIES], misses[FAMILIES], limits[FAMILIES];
  unsigned long overlaps, proven, open, measured, cut, useful, casts;
} tally;

static bool measure(void *user, gjk_q30 fraction, int64_t *out) {
  *out = gap_at((const trial *)user, fraction).distance;
  return true;
}

// Is the gap above the margin at all fractions before limit, but for what posing rounds?
static clearance_outcome search(trial *t, gjk_q30 limit) {
  clearance c = {.gap = measure, .user = t, .most = MEASUREMENTS};
  set_clearance(t, &c);
  const clearance_outcome outcome = clearance_search(&c, limit);
  tally.measured += c.measured;
  return outcome;
}

// Of a grazing pair the margin is about the least gap on the way, at most this one.
static void choose_margin(random_state *random, trial *t, gjk_q16 most) {
  t->setup.margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, 2000);
  if (t->family == GRAZING) {
    int64_t least = INT64_MAX;
    for (int i = 0; i <= 400; i++) {
      const int64_t gap = gap_at(t, (gjk_q30)((int64_t)ONE * i / 400)).distance;
      least = gap < least ? gap : least;
    }
    least += random_range(random, -40, 10);
    t->setup.margin = least < 0 ? 0 : least > most ? most : (gjk_q16)least;
  }
}

static void check_ceilings(const trial *t, const gjk_impact_result *full, gjk_status status) {
  static const uint8_t ceilings[] = {1, 2, 3, 10};
  gjk_q30 lower = 0;
  for (unsigned i = 0; i < sizeof ceilings; i++) {
    gjk_impact_result r;
    const gjk_status limited = ask(t, ceilings[i], &r);
    if (full->iterations <= ceilings[i]) {
      CHECK(limited == status && r.hit == full->hit && r.lower == full->lower && r.upper == full->upper);
    } else {
      CHECK(limited == GJK_ERROR_ITERATION_LIMIT && !r.hit && !r.overlap && r.upper == ONE);
      CHECK(r.lower >= lower && r.lower <= full->lower);
      tally.cut++;
      tally.useful += r.lower > 0;
    }
    lower = r.lower;
  }
}

static void check(trial *t) {
  gjk_impact_result r;
  const gjk_status status = ask(t, 0, &r);
  CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
  tally.made[t->family]++;
  if (r.overlap) {
    tally.overlaps++;
    CHECK(r.hit && r.lower == 0 && r.upper == 0 && gap_at(t, 0).distance <= t->setup.margin);
    return;
  }
  tally.hits[t->family] += r.hit;
  tally.misses[t->family] += status == GJK_OK && !r.hit;
  tally.limits[t->family] += status != GJK_OK;
  CHECK(r.hit || r.upper == ONE);
  CHECK(status != GJK_OK || r.hit || r.lower == ONE);
  if (r.hit) {
    const gjk_distance_result gap = gap_at(t, r.upper);
    CHECK_MSG(gap.distance <= (int64_t)t->setup.margin + t->setup.tolerance, "gap %ld at upper", (long)gap.distance);
  }
  const clearance_outcome found = search(t, r.lower);
  CHECK_MSG(found != CLEARANCE_TOUCHED, "contact before %ld", (long)r.lower);
  tally.proven += found == CLEARANCE_PROVEN;
  tally.open += found == CLEARANCE_OPEN;
  check_ceilings(t, &r, status);
  if (t->family == STRAIGHT) {
    check_cast(t, &r, status);
  }
}

// Runs argv's or the test's trials.
static void check_trials_of(trial *t, int argc, char **argv, uint64_t seed) {
  random_state random = random_seed(argc > 1 ? check_seeded(strtoull(argv[1], NULL, 10)) : check_seed(seed));
  const unsigned long trials = argc > 2 ? strtoul(argv[2], NULL, 10) : check_trials(TRIALS);
  static const char *const names[FAMILIES] = {"needles", "grazing", "turning", "fast", "straight"};
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, show, t);
    if (make(&random, t)) {
      check(t);
    }
  }
  check_trial(trials, NULL, NULL);
  for (unsigned i = 0; i < FAMILIES; i++) {
    printf("%-9s %lu: %lu hits, %lu misses, %lu at the ceiling\n", names[i], tally.made[i], tally.hits[i],
           tally.misses[i], tally.limits[i]);
    CHECK(trials < 500 || (tally.made[i] > trials / 10 && tally.hits[i] > 10 && tally.misses[i] > 10));
  }
  printf("%lu overlaps, %lu proven clear, %lu not, %lu distances; %lu cut short, %lu of them above 0\n", tally.overlaps,
         tally.proven, tally.open, tally.measured, tally.cut, tally.useful);
  CHECK(tally.proven > tally.open * 10);
  CHECK(tally.useful > tally.cut / 2 && (trials < 500 || tally.casts > trials / 100));
}

#endif
