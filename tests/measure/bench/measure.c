// Measures methods on a family of pairs.
#define _POSIX_C_SOURCE 199309L
#include "measure.h"

#include "../measuring.h"

void bench_subject_make(const bench_method *method, const bench_pair *pairs, size_t count, bench_subject *out) {
  memset(out, 0, sizeof *out);
  out->method = method;
  out->count = count;
  out->prepared = measuring_allocate(count, sizeof *out->prepared);
  for (size_t i = 0; i < count; i++) {
    out->prepared[i] = method->prepare(method, &pairs[i]);
    if (out->prepared[i] == NULL) {
      exit(2);
    }
  }
}

void bench_subject_free(bench_subject *subject) {
  for (size_t i = 0; i < subject->count; i++) {
    subject->method->release(subject->prepared[i]);
  }
  free(subject->prepared);
  for (int q = 0; q < BENCH_QUERIES; q++) {
    free(subject->times[q]);
  }
}

static bench_answer ask(const bench_subject *subject, bench_query query, size_t pair) {
  bench_answer answer;
  memset(&answer, 0, sizeof answer);
  subject->method->run(subject->method, subject->prepared[pair], query, &answer);
  return answer;
}

// Which of bench_depths' ranges a depth is in, or which of bench_gaps a pair was made for. Returns their count: none.
static size_t find_gap(const bench_pair *pair, bool deep) {
  size_t i = 0;
  if (deep) {
    while (i < bench_depth_count && -pair->distance > bench_depths[i]) {
      i++;
    }
    return i;
  }
  while (i < bench_gap_count && bench_gaps[i] != pair->placed) {
    i++;
  }
  return i;
}

static void count_gap(const bench_pair *pair, bool deep, bool wrong, bool undecided, bench_tally *out) {
  const size_t i = find_gap(pair, deep);
  if (i < (deep ? bench_depth_count : bench_gap_count)) {
    out->gap_asked[i]++;
    out->gap_wrong[i] += wrong;
    out->gap_undecided[i] += undecided;
  }
}

// Bounds are integers, rounded to the nearest if the answer is exact.
static bool is_outside(const bench_answer *answer, double distance) {
  const double slack = answer->lower < answer->upper ? 0 : 0.5;
  return answer->bounded && (distance < answer->lower - slack || distance > answer->upper + slack);
}

static bool is_wrong_decision(const bench_answer *answer, const bench_pair *pair, bench_tally *out) {
  out->undecided += answer->decision == BENCH_UNDECIDED;
  return answer->decision != BENCH_UNDECIDED && (answer->decision == BENCH_TOGETHER) != pair->intersecting;
}

// The shapes overlap. A method without an answer gets the whole depth as its error.
static bool is_wrong_depth(const bench_answer *answer, const bench_pair *pair, double *error, bench_tally *out) {
  const double depth = -pair->distance, found = -answer->distance, slack = fmax(1, depth / 100);
  const bool failed = answer->decision == BENCH_UNDECIDED || !isfinite(found),
             apart = !failed && answer->decision == BENCH_APART, small = !failed && !apart && found < depth - slack,
             large = !failed && !apart && found > depth + slack;
  *error = failed || apart ? depth : fabs(found - depth);
  out->failed += failed;
  out->apart += apart;
  out->small += small;
  out->large += large;
  return failed || apart || small || large;
}

void bench_measure_errors(const bench_subject *subject, bench_query query, const bench_pair *pairs, bench_tally *out) {
  const bool deep = query >= BENCH_DEPTH;
  memset(out, 0, sizeof *out);
  for (size_t i = 0; i < subject->count; i++) {
    const bench_answer answer = ask(subject, query, i);
    double error = isnan(answer.distance) ? INFINITY : fabs(answer.distance - pairs[i].distance);
    const bool wrong =
        deep ? is_wrong_depth(&answer, &pairs[i], &error, out) : is_wrong_decision(&answer, &pairs[i], out);
    out->asked++;
    out->wrong += wrong;
    out->outside += is_outside(&answer, pairs[i].distance);
    out->error_sum += error;
    out->error_most = error > out->error_most ? error : out->error_most;
    out->iterations[answer.iterations < 255 ? answer.iterations : 255]++;
    out->contacts += answer.contacts;
    count_gap(&pairs[i], deep, wrong, answer.decision == BENCH_UNDECIDED, out);
  }
}

static void pass(const bench_subject *subject, bench_query query) {
  bench_answer answer;
  memset(&answer, 0, sizeof answer);
  for (size_t i = 0; i < subject->count; i++) {
    subject->method->run(subject->method, subject->prepared[i], query, &answer);
  }
}

// Makes more room at each power of two.
static void keep_time(bench_subject *subject, bench_query query, double time) {
  const size_t n = subject->repetitions[query]++;
  if ((n & (n - 1)) == 0) {
    subject->times[query] = realloc(subject->times[query], (n == 0 ? 1 : 2 * n) * sizeof *subject->times[query]);
    if (subject->times[query] == NULL) {
      exit(2);
    }
  }
  subject->times[query][n] = time;
}

void bench_measure_time(bench_subject *subject, bench_query query, bool keep) {
  const double start = measuring_ns(CLOCK_MONOTONIC);
  pass(subject, query);
  const double ns = measuring_ns(CLOCK_MONOTONIC) - start;
  if (keep) {
    keep_time(subject, query, ns / (double)subject->count);
  }
}

double bench_median_time(bench_subject *subject, bench_query query) {
  return measuring_median(subject->times[query], subject->repetitions[query]);
}

bool bench_measure_instructions(const bench_subject *subject, bench_query query, const char *label) {
  if (!measuring_count()) {
    return false;
  }
  pass(subject, query);
  measuring_dump(label);
  return true;
}
