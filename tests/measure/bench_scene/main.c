// scene-bench [QUICK]: CPU time per tick of scenes of 8 to 20,000 bodies on this machine, as CSV. Beside it other
// libraries' broad phases, where they are linked, and a test of the boxes of all pairs. Reading the clock adds up to
// 0.1 us to a tick.
//
// With an argument it measures only what a figure is promised for, of the library and of all pairs, and whether the promise
// is kept.
//
// Every method replays the same recorded motion, MOTION_TICKS ticks at a time, in turn. A figure is the median of the
// means over so many ticks. Exit status 1: a scene failed, a count of pairs is wrong, or the promise is not kept.
#define _POSIX_C_SOURCE 199309L
#include "../measuring.h"
#include "method_gjk.h"
#include "motion.h"

#define PROMISED_BODIES 10000
#define PROMISED_PERCENT 5
#define PROMISED_RATIO 20

#define WARM_UP 3  // blocks of MOTION_TICKS, in all but the first shares are counted, too
#define REPETITIONS_LEAST 5
#define REPETITIONS_MOST 60
#define TIME_ENOUGH 3e8  // ns of one line

// A library that is not linked has no method.
#pragma weak scene_bullet
#pragma weak scene_fcl
static const scene_method *const methods[] = {&scene_gjk_whole, &scene_gjk_broad, &scene_gjk_posing, &scene_bullet,
                                              &scene_fcl};
#define METHODS (sizeof methods / sizeof methods[0])
#define WHOLE 0
#define BROAD 1

typedef struct measured {
  void *world;
  double times[REPETITIONS_MOST];
  uint32_t held, meeting;
} measured;

// The pairs that skips settled in a tick, and those that went to a query, added up.
typedef struct shares {
  double ticks, pairs, resting, motion, boxes, direction, warm, cold;
} shares;

typedef struct line {
  const char *name;
  traffic_kind kind;
  uint32_t count, percent;
  bool quick;
  unsigned repetitions;
  measured of[METHODS];
  double all[REPETITIONS_MOST];
  uint32_t meeting;
  shares shares;
} line;

static double now(void) {
  return measuring_ns(CLOCK_PROCESS_CPUTIME_ID);
}

static double median(const double *values, unsigned count) {
  double sorted[REPETITIONS_MOST];
  for (unsigned i = 0; i < count; i++) {
    sorted[i] = values[i];
  }
  return measuring_median(sorted, count);
}

static bool used(const line *l, unsigned method) {
  return methods[method] != NULL && (!l->quick || method <= BROAD);
}

// Mean nanoseconds of the recorded ticks; negative: one failed.
static double replay(const motion *m, const scene_method *method, void *world) {
  const double start = now();
  bool fine = true;
  for (unsigned i = 0; i < MOTION_TICKS && fine; i++) {
    const scene_tick changes = motion_tick(m, i);
    fine = method->tick(world, &changes);
  }
  return fine ? (now() - start) / MOTION_TICKS : -1;
}

static void add_shares(shares *s, const gjk_scene_stats *stats) {
  s->ticks++;
  s->pairs += stats->pairs;
  s->resting += stats->resting;
  s->motion += stats->motion;
  s->boxes += stats->boxes;
  s->direction += stats->direction;
  s->warm += stats->warm;
  s->cold += stats->cold;
}

// Replays the recorded ticks to the library without timing, and counts what became of the pairs in each.
static bool count_shares(line *l, const motion *m) {
  for (unsigned i = 0; i < MOTION_TICKS; i++) {
    const scene_tick changes = motion_tick(m, i);
    if (!methods[WHOLE]->tick(l->of[WHOLE].world, &changes)) {
      return false;
    }
    const gjk_scene_stats stats = method_gjk_stats(l->of[WHOLE].world);
    add_shares(&l->shares, &stats);
  }
  return true;
}

// Records a block of motion and replays it to each method.
static bool repeat(line *l, motion *m, bool warm_up, double *spent) {
  const unsigned at = warm_up ? 0 : l->repetitions++;
  if (!motion_record(m)) {
    return false;
  }
  for (unsigned i = 0; i < METHODS; i++) {
    if (warm_up && i == WHOLE) {
      if (!count_shares(l, m)) {
        return false;
      }
    } else if (used(l, i)) {
      l->of[i].times[at] = replay(m, methods[i], l->of[i].world);
      *spent += l->of[i].times[at] * MOTION_TICKS;
      if (l->of[i].times[at] < 0) {
        return false;
      }
    }
  }
  if (!warm_up) {
    const double start = now();
    l->meeting = motion_test_all(m);
    l->all[at] = now() - start;
    *spent += l->all[at];
  }
  return true;
}

static bool measure(line *l, motion *m) {
  static const shares none;
  double spent = 0;
  for (unsigned i = 0; i < WARM_UP; i++) {
    if (!repeat(l, m, true, &spent)) {
      return false;
    }
    l->shares = i == 0 ? none : l->shares;  // all pairs are new in the first tick
  }
  spent = 0;
  while (l->repetitions < REPETITIONS_LEAST || (l->repetitions < REPETITIONS_MOST && spent < TIME_ENOUGH)) {
    if (!repeat(l, m, false, &spent)) {
      return false;
    }
  }
  return true;
}

// Every method that holds pairs must hold all whose exact boxes meet.
static bool check_pairs(line *l, motion *m) {
  bool right = true;
  for (unsigned i = 0; i < METHODS; i++) {
    measured *d = &l->of[i];
    if (used(l, i) && methods[i]->count != NULL) {
      methods[i]->count(d->world, motion_meet, m, &d->held, &d->meeting);
      if (d->meeting != l->meeting) {
        fprintf(stderr, "%s, %u bodies, %u %% moving: %s holds %u of the %u pairs whose boxes meet\n", l->name,
                l->count, l->percent, methods[i]->name, d->meeting, l->meeting);
        right = false;
      }
    }
  }
  return right;
}

static void put_number(bool there, double value) {
  printf(there ? ",%.4g" : ",", value);
}

static void put_line(const line *l) {
  const shares *s = &l->shares;
  const double all = median(l->all, l->repetitions), share = s->pairs > 0 ? 100 / s->pairs : 0;
  printf("%s,%u,%u", l->name, l->count, l->percent);
  for (unsigned i = 0; i < METHODS; i++) {
    put_number(used(l, i), median(l->of[i].times, l->repetitions));
  }
  put_number(true, all);
  printf(",%u,%.0f", l->meeting, s->pairs / s->ticks);
  for (unsigned i = 0; i < METHODS; i++) {
    if (i > WHOLE && methods[i] != &scene_gjk_posing) {
      put_number(used(l, i) && methods[i]->count != NULL, l->of[i].held);
    }
  }
  printf(",%.1f,%.1f,%.1f,%.1f,%.1f,%.1f\n", s->resting * share, s->motion * share, s->boxes * share,
         s->direction * share, s->warm * share, s->cold * share);
  fflush(stdout);
}

// Measures, and prints a line. Returns how many times faster a whole tick is than all pairs; negative: something
// failed.
static double run(const char *name, traffic_kind kind, uint32_t count, uint32_t percent, bool quick) {
  static line l;
  static const line none;
  motion m;
  l = none;
  l.name = name;
  l.kind = kind;
  l.count = count;
  l.percent = percent;
  l.quick = quick;
  bool fine = motion_start(&m, kind, count, percent);
  const scene_tick all = fine ? motion_all(&m) : (scene_tick){NULL, NULL, 0};
  fine = all.count == count;
  for (unsigned i = 0; i < METHODS && fine; i++) {
    l.of[i].world = used(&l, i) ? methods[i]->start(&all) : NULL;
    fine = !used(&l, i) || l.of[i].world != NULL;
  }
  fine = fine && measure(&l, &m) && check_pairs(&l, &m);
  if (fine) {
    put_line(&l);
  } else {
    fprintf(stderr, "%s, %u bodies: failed\n", name, count);
  }
  for (unsigned i = 0; i < METHODS; i++) {
    if (l.of[i].world != NULL) {
      methods[i]->stop(l.of[i].world);
    }
  }
  motion_free(&m);
  return fine ? median(l.all, l.repetitions) / median(l.of[WHOLE].times, l.repetitions) : -1;
}

static void put_head(void) {
  // Times in ns. Those of gjk include posing; those of the others start from finished boxes. all pairs: the boxes
  // alone.
  puts(
      "scene,bodies,percent moving,gjk whole tick ns,gjk broad phase ns,gjk posing ns,Bullet ns,FCL ns,all pairs ns,"
      "boxes meeting,gjk pairs,gjk broad pairs,Bullet pairs,FCL pairs,"
      "% resting,% motion,% boxes,% direction,% warm,% cold");
}

int main(int argc, char **argv) {
  static const struct {
    const char *name;
    traffic_kind kind;
  } kinds[] = {{"sparse", TRAFFIC_SPARSE},
               {"crowded", TRAFFIC_CROWDED},
               {"piles", TRAFFIC_PILES},
               {"streaming", TRAFFIC_STREAMING}};
  static const uint32_t counts[] = {8, 64, 256, 1000, 4000, 10000, 20000}, percents[] = {0, 5, 25, 100};
  (void)argv;
  put_head();
  if (argc > 1) {
    return run("sparse", TRAFFIC_SPARSE, PROMISED_BODIES, PROMISED_PERCENT, true) >= PROMISED_RATIO ? 0 : 1;
  }
  for (unsigned k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    for (unsigned n = 0; n < sizeof counts / sizeof counts[0]; n++) {
      for (unsigned p = 0; p < sizeof percents / sizeof percents[0]; p++) {
        if (run(kinds[k].name, kinds[k].kind, counts[n], percents[p], false) < 0) {
          return 1;
        }
      }
    }
  }
  return 0;
}
