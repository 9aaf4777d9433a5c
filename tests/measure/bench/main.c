// gjk-bench: measures the methods and writes the figures as CSV, one value a line.
#define _POSIX_C_SOURCE 200112L
#include <unistd.h>

#include "../measuring.h"
#include "measure.h"

static const char usage[] =
    "usage: gjk-bench [option VALUE]...      writes CSV: family,query,method,measure,at,value\n"
    "  --pairs N         pairs of each family that errors are measured on (1000)\n"
    "  --timed N         the first so many of them are timed (100)\n"
    "  --seconds N       time is measured for so long, all methods in turn (60)\n"
    "  --repetitions N   ... but so many times at least (5)\n"
    "  --seed N          of the pairs (1)\n"
    "  --instructions 1  under callgrind: nothing but its dumps, one of each family,query,method\n";

static const char *const query_names[BENCH_QUERIES] = {"distance", "intersect", "depth", "contacts"};

typedef struct options {
  unsigned long pairs, timed, seconds, repetitions, seed, instructions;
} options;

// The figures of all methods on one family.
typedef struct work {
  const bench_family *family;
  bench_pair *pairs;
  size_t exact;                               // pairs whose depth is proven by exact integers
  bench_subject subjects[BENCH_METHODS_MAX];  // on the timed pairs
} work;

typedef struct bench {
  options asked;
  const bench_method *methods[BENCH_METHODS_MAX];
  size_t method_count;
  work *works;  // of each family
} bench;

static bool parse(int argc, char **argv, options *out) {
  const measuring_option known[] = {{"--pairs", &out->pairs},     {"--timed", &out->timed},
                                    {"--seconds", &out->seconds}, {"--repetitions", &out->repetitions},
                                    {"--seed", &out->seed},       {"--instructions", &out->instructions}};
  const bool good = measuring_options(argc, argv, known, sizeof known / sizeof known[0]);
  out->timed = out->timed < out->pairs ? out->timed : out->pairs;
  return good && out->timed > 0 && out->repetitions > 0;
}

// Shows the progress, on a terminal only, in a line that is overwritten.
static void progress(const char *text, const char *name, unsigned long done, unsigned long all) {
  if (isatty(STDERR_FILENO) != 0) {
    fprintf(stderr, "\r\033[K%s %lu of %lu: %s", text, done, all, name);
  }
}

static void progress_done(void) {
  if (isatty(STDERR_FILENO) != 0) {
    fprintf(stderr, "\r\033[K");
  }
}

static void put(const char *family, const char *query, const char *method, const char *measure, double value) {
  printf("%s,%s,%s,%s,,%.9g\n", family, query, method, measure, value);
}

static void put_at(const char *family, const char *query, const char *method, const char *measure, int at,
                   unsigned long value) {
  printf("%s,%s,%s,%s,%d,%lu\n", family, query, method, measure, at, value);
}

static void put_tally(const bench_method *method, const char *family, bench_query query, const bench_tally *t) {
  const char *q = query_names[query], *m = method->name;
  put(family, q, m, "pairs", (double)t->asked);
  put(family, q, m, "wrong", (double)t->wrong);
  if (query >= BENCH_DEPTH) {
    put(family, q, m, "failed", (double)t->failed);
    put(family, q, m, "says_apart", (double)t->apart);
    put(family, q, m, "too_small", (double)t->small);
    put(family, q, m, "too_large", (double)t->large);
  } else {
    put(family, q, m, "undecided", (double)t->undecided);
    put(family, q, m, "outside", (double)t->outside);
  }
  if (query == BENCH_CONTACTS) {
    put(family, q, m, "contacts", (double)t->contacts / (double)t->asked);
  }
  if (query != BENCH_INTERSECT) {
    put(family, q, m, "error_mean", t->error_sum / (double)t->asked);
    put(family, q, m, "error_most", t->error_most);
  }
  for (int i = 0; i < 256; i++) {
    if (t->iterations[i] > 0 && t->iterations[0] < t->asked) {
      put_at(family, q, m, "iterations", i, t->iterations[i]);
    }
  }
  const int *gaps = query == BENCH_DEPTH ? bench_depths : bench_gaps;
  const size_t gap_count = query == BENCH_DEPTH ? bench_depth_count : query == BENCH_CONTACTS ? 0 : bench_gap_count;
  for (size_t i = 0; i < gap_count; i++) {
    if (t->gap_asked[i] > 0) {
      put_at(family, q, m, "gap_pairs", gaps[i], t->gap_asked[i]);
      put_at(family, q, m, "gap_wrong", gaps[i], t->gap_wrong[i]);
      put_at(family, q, m, "gap_undecided", gaps[i], t->gap_undecided[i]);
    }
  }
}

// Does the method answer any query of the family?
static bool is_asked(const bench_method *method, const bench_family *family) {
  bool asked = false;
  for (int q = 0; q < BENCH_QUERIES; q++) {
    asked = asked || bench_answers(method, family, (bench_query)q);
  }
  return asked;
}

static void measure_errors(const bench *b, const work *w) {
  for (size_t m = 0; m < b->method_count; m++) {
    bench_subject all;
    if (!is_asked(b->methods[m], w->family)) {
      continue;
    }
    bench_subject_make(b->methods[m], w->pairs, b->asked.pairs, &all);
    for (int q = 0; q < BENCH_QUERIES; q++) {
      bench_tally tally;
      if (bench_answers(b->methods[m], w->family, (bench_query)q)) {
        bench_measure_errors(&all, (bench_query)q, w->pairs, &tally);
        put_tally(b->methods[m], w->family->name, (bench_query)q, &tally);
      }
    }
    bench_subject_free(&all);
  }
}

static void prepare(bench *b) {
  b->method_count = bench_methods(b->methods);
  b->works = measuring_allocate(bench_family_count, sizeof *b->works);
  for (size_t f = 0; f < bench_family_count; f++) {
    work *w = &b->works[f];
    w->family = &bench_families[f];
    progress("pairs and errors: family", w->family->name, f + 1, bench_family_count);
    w->pairs = bench_pairs_make(w->family, b->asked.seed, b->asked.pairs, &w->exact);
    if (b->asked.instructions == 0) {
      measure_errors(b, w);
    }
    for (size_t m = 0; m < b->method_count; m++) {
      if (is_asked(b->methods[m], w->family)) {
        bench_subject_make(b->methods[m], w->pairs, b->asked.timed, &w->subjects[m]);
      }
    }
  }
  progress_done();
}

static void release(bench *b) {
  for (size_t f = 0; f < bench_family_count; f++) {
    for (size_t m = 0; m < b->method_count; m++) {
      if (is_asked(b->methods[m], b->works[f].family)) {
        bench_subject_free(&b->works[f].subjects[m]);
      }
    }
    bench_pairs_free(b->works[f].pairs, b->asked.pairs);
  }
  free(b->works);
}

// Writes how the depths of each family are known.
static void put_proofs(const bench *b) {
  for (size_t f = 0; f < bench_family_count; f++) {
    if (bench_families[f].asked & (BENCH_ASK(BENCH_DEPTH) | BENCH_ASK(BENCH_CONTACTS))) {
      printf("%s,,,exact,,%zu\n", bench_families[f].name, b->works[f].exact);
    }
  }
}

static void put_about(const bench *b) {
  printf("family,query,method,measure,at,value\n");
  for (size_t f = 0; f < bench_family_count; f++) {
    printf("%s,,,what,,%s\n", bench_families[f].name, bench_families[f].what);
    printf("%s,,,vertices,,%u\n", bench_families[f].name, bench_families[f].vertices);
  }
  for (size_t m = 0; m < b->method_count; m++) {
    printf(",,%s,series,%d,%s\n", b->methods[m]->name, b->methods[m]->setting, b->methods[m]->series);
  }
}

// A method goes through all families twice, and the second time counts. So each method finds the processor (caches,
// branch prediction) as it leaves it itself, not as a method before has left it.
static void time_method(bench *b, size_t method, bench_query query) {
  for (int pass = 0; pass < 2; pass++) {
    for (size_t f = 0; f < bench_family_count; f++) {
      if (bench_answers(b->methods[method], &bench_families[f], query)) {
        bench_measure_time(&b->works[f].subjects[method], query, pass == 1);
      }
    }
  }
}

// Measures all methods in turn, so that what slows the machine for a while slows all of them alike.
static void repeat_once(bench *b) {
  for (int q = 0; q < BENCH_QUERIES; q++) {
    for (size_t m = 0; m < b->method_count; m++) {
      time_method(b, m, (bench_query)q);
    }
  }
}

static void measure_times(bench *b) {
  const time_t start = time(NULL);
  unsigned long done = 0;
  double spent = 0;
  while (done < b->asked.repetitions || spent < (double)b->asked.seconds) {
    repeat_once(b);
    done++;
    spent = difftime(time(NULL), start);
    progress("time: second", "all methods on all families in turn", (unsigned long)spent, b->asked.seconds);
  }
  progress_done();
  printf(",,,repetitions,,%lu\n", done);
  for (size_t f = 0; f < bench_family_count; f++) {
    for (int q = 0; q < BENCH_QUERIES; q++) {
      for (size_t m = 0; m < b->method_count; m++) {
        bench_subject *s = &b->works[f].subjects[m];
        if (bench_answers(b->methods[m], &bench_families[f], (bench_query)q)) {
          put(bench_families[f].name, query_names[q], s->method->name, "time", bench_median_time(s, (bench_query)q));
        }
      }
    }
  }
}

static bool measure_instructions(const bench *b) {
  for (size_t f = 0; f < bench_family_count; f++) {
    for (int q = 0; q < BENCH_QUERIES; q++) {
      for (size_t m = 0; m < b->method_count; m++) {
        const bench_subject *s = &b->works[f].subjects[m];
        char label[160];
        snprintf(label, sizeof label, "%s,%s,%s", bench_families[f].name, query_names[q], b->methods[m]->name);
        if (bench_answers(b->methods[m], &bench_families[f], (bench_query)q) &&
            !bench_measure_instructions(s, (bench_query)q, label)) {
          return false;
        }
      }
    }
  }
  return true;
}

int main(int argc, char **argv) {
  bench b;
  memset(&b, 0, sizeof b);
  const options defaults = {1000, 100, 60, 5, 1, 0};
  b.asked = defaults;
  if (!parse(argc, argv, &b.asked)) {
    fputs(usage, stderr);
    return 2;
  }
  bool done = true;
  if (b.asked.instructions != 0) {
    prepare(&b);
    done = measure_instructions(&b);
  } else {
    b.method_count = bench_methods(b.methods);
    put_about(&b);
    prepare(&b);
    put_proofs(&b);
    measure_times(&b);
  }
  release(&b);
  if (fflush(stdout) != 0 || ferror(stdout) != 0) {
    fprintf(stderr, "gjk-bench: cannot write\n");
    return 2;
  }
  return done ? 0 : 1;
}
