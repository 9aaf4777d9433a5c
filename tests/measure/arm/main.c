// gjk-arms EDGES [REPETITIONS]: what edges of an arm of seven joints cost, and how many touches are missed. CSV:
// family,method,touches,missed,free,false alarms,microseconds an edge
//
// Edges  "random": of 1 radian, from a configuration that is free. "grazing": of 1 radian through one that nearly touches, or
//        overlaps by 1 to 256 LSB, along motions that keep this to first order; both ends are free.
// Truth  touch: some gap is 0 in double, at 4,000 places of the edge and 200 behind the first touch that the library proves.
//        Free: arm_truth_edge is sure that 16 LSB are left. Edges that are neither are left out.
// Times  processor's, of each edge the least of the repetitions. Poses of the links are given to other libraries.
#define _POSIX_C_SOURCE 199309L
#include "../measuring.h"
#include "arm/arm_truth.h"
#include "arm/seven.h"
#include "sweep.h"

#define SAMPLE 655    // 0.01 radians
#define SEGMENT 6554  // 0.1 radians
#define SAMPLES_MAX 400

static seven machine;
static int32_t from[SEVEN_JOINTS], to[SEVEN_JOINTS];

// The machine for other libraries.
static double points[SEVEN_PARTS + SEVEN_OBSTACLES][SEVEN_POINTS][3];
static sweep_solid parts[SEVEN_PARTS], obstacles[SEVEN_OBSTACLES];
static size_t pairs[SEVEN_PAIRS][2];
static sweep_pose poses[SAMPLES_MAX + 1][SEVEN_PARTS];

static void set_point(double out[3], double x, double y, double z) {
  out[0] = x / 65536;
  out[1] = y / 65536;
  out[2] = z / 65536;
}

static sweep_scene make_scene(void) {
  const gjk_arm *arm = &machine.arm;
  sweep_scene scene = {parts, obstacles, SEVEN_PARTS, arm->obstacle_count, arm->self_count, (const size_t(*)[2])pairs};
  for (unsigned i = 0; i < SEVEN_PARTS; i++) {
    for (unsigned k = 0; k < SEVEN_POINTS; k++) {
      const gjk_vec3 *v = &machine.points[i][k];
      set_point(points[i][k], v->x, v->y, v->z);
    }
    const sweep_solid solid = {(const double(*)[3])points[i], SEVEN_POINTS, 0};
    parts[i] = solid;
  }
  for (unsigned i = 0; i < arm->obstacle_count; i++) {
    const gjk_collider *c = &machine.obstacles[i];
    double(*out)[3] = points[SEVEN_PARTS + i];
    const gjk_vec3 *o = &c->centre;
    size_t count = 1;
    set_point(out[0], o->x, o->y, o->z);
    if (c->buffer != NULL) {
      for (count = 0; count < c->count; count++) {
        const gjk_vec3 *v = &c->buffer[count];
        set_point(out[count], (double)o->x + v->x, (double)o->y + v->y, (double)o->z + v->z);
      }
    } else if (c->count == 3) {
      for (count = 0; count < 8; count++) {
        double at[3] = {o->x, o->y, o->z};
        for (unsigned axis = 0; axis < 3; axis++) {
          const double side = count >> axis & 1 ? 1 : -1;
          at[0] += side * c->frame[axis].x;
          at[1] += side * c->frame[axis].y;
          at[2] += side * c->frame[axis].z;
        }
        set_point(out[count], at[0], at[1], at[2]);
      }
    }
    const sweep_solid solid = {(const double(*)[3])out, count, c->shape->convex_radius / 65536.0};
    obstacles[i] = solid;
  }
  for (uint32_t i = 0; i < arm->self_count; i++) {
    pairs[i][0] = machine.pairs[i].part;
    pairs[i][1] = machine.pairs[i].other;
  }
  return scene;
}

// How many steps of at most so far in any joint the edge has.
static unsigned steps_of(int32_t most) {
  int32_t change = 0;
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    change = abs(to[i] - from[i]) > change ? abs(to[i] - from[i]) : change;
  }
  return (unsigned)((change + most - 1) / most);
}

// Sets the poses of the parts at such steps. Returns how many.
static unsigned set_poses(int32_t most) {
  const unsigned steps = steps_of(most);
  for (unsigned s = 0; s <= steps && s <= SAMPLES_MAX; s++) {
    arm_truth_frame frames[GJK_ARM_LINKS_MAX];
    arm_truth_frames(&machine.arm, from, to, (double)s / steps, frames);
    for (unsigned i = 0; i < SEVEN_PARTS; i++) {
      const arm_truth_frame *f = &frames[machine.parts[i].link];
      memcpy(poses[s][i].q, f->q, sizeof f->q);
      set_point(poses[s][i].p, f->p[0], f->p[1], f->p[2]);
    }
  }
  return steps <= SAMPLES_MAX ? steps : SAMPLES_MAX;
}

static bool run_edge(const gjk_arm_setup *setup, gjk_arm_edge_result *result) {
  return gjk_arm_edge_start(&machine.arm, from, to, setup, NULL, NULL) == GJK_OK &&
         gjk_arm_edge_run(&machine.arm, 1000000, result) == GJK_OK;
}

static arm_truth truth_of(void) {
  const gjk_arm_setup exact = {0, GJK_ARM_TOLERANCE_MIN, 0};
  gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
  unsigned samples;
  if (!run_edge(&exact, &result)) {
    abort();
  }
  for (unsigned i = 0; i <= 200 && result.answer == GJK_ARM_TOUCH; i++) {
    const double at = fmin(1, result.lower / (double)GJK_Q30_ONE + i * 2e-5);
    if (arm_truth_gap(&machine.arm, from, to, at, 100) <= 0) {
      return ARM_TRUTH_TOUCH;
    }
  }
  if (arm_truth_edge(&machine.arm, from, to, 0, 1, 16, &samples) == ARM_TRUTH_FREE) {
    return ARM_TRUTH_FREE;
  }
  for (unsigned i = 0; i <= 4000; i++) {
    if (arm_truth_gap(&machine.arm, from, to, i / 4000.0, 100) <= 0) {
      return ARM_TRUTH_TOUCH;
    }
  }
  return ARM_TRUTH_OPEN;
}

static void random_edge(random_state *random) {
  bool near = true;
  while (near) {
    seven_any(random, from);
    if (gjk_arm_near(&machine.arm, from, 100, &near, NULL) != GJK_OK) {
      abort();
    }
  }
  seven_beside(random, from, 65536, to);
}

// Through the place where a random edge first touches, along what keeps the distance there.
static bool grazing_edge(random_state *random) {
  const gjk_arm_setup exact = {100, GJK_ARM_TOLERANCE_MIN, 0};
  gjk_arm_edge_result result;
  gjk_arm_distance_result nearest;
  gjk_q16 slope[SEVEN_JOINTS];
  int32_t middle[SEVEN_JOINTS], aside[SEVEN_JOINTS];
  double along = 0, square = 0;
  random_edge(random);
  if (!run_edge(&exact, &result) || result.answer != GJK_ARM_TOUCH || result.lower == 0) {
    return false;
  }
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    middle[i] = from[i] + (int32_t)((int64_t)(to[i] - from[i]) * result.lower / GJK_Q30_ONE);
  }
  if (gjk_arm_distance(&machine.arm, middle, GJK_DISTANCE_MAX, &nearest) != GJK_OK || nearest.distance.intersecting ||
      gjk_arm_gradient(&machine.arm, middle, &nearest, slope) != GJK_OK) {
    return false;
  }
  // Every other one goes on, by 1 to 256 LSB into what it meets.
  double rate = 0;
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    rate -= (double)slope[i] * (to[i] - from[i]) / 65536;
  }
  const double further = rate > 1000 && random_below(random, 2) == 0
                             ? (nearest.distance.distance + (1 << random_below(random, 9))) / rate
                             : 0;
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    middle[i] += (int32_t)((to[i] - from[i]) * further);
  }
  seven_beside(random, middle, 32768, aside);
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    along += (double)(aside[i] - middle[i]) * slope[i];
    square += (double)slope[i] * slope[i];
  }
  bool near = true;
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    const int32_t d = aside[i] - middle[i] - (int32_t)(square > 0 ? slope[i] * along / square : 0);
    from[i] = middle[i] - d;
    to[i] = middle[i] + d;
  }
  return gjk_arm_near(&machine.arm, from, 100, &near, NULL) == GJK_OK && !near &&
         gjk_arm_near(&machine.arm, to, 100, &near, NULL) == GJK_OK && !near;
}

// The methods. Each says whether the edge touches.
static void *prepared[2];
static const sweep_method *peer[2];

static bool by_edge(void) {
  const gjk_arm_setup any = {0, 64, GJK_Q30_ONE};
  gjk_arm_edge_result result;
  return !run_edge(&any, &result) || result.answer != GJK_ARM_FREE;
}

static bool by_samples(void) {
  const unsigned steps = steps_of(SAMPLE);
  bool near = false;
  for (unsigned s = 0; s <= steps && !near; s++) {
    int32_t values[SEVEN_JOINTS];
    for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
      values[i] = from[i] + (int32_t)((int64_t)(to[i] - from[i]) * s / (int32_t)steps);
    }
    (void)gjk_arm_near(&machine.arm, values, 0, &near, NULL);
  }
  return near;
}

static unsigned steps_set;  // of the poses

static bool samples_of(unsigned which) {
  bool yes = false;
  for (unsigned s = 0; s <= steps_set && !yes; s++) {
    yes = peer[which]->touches(prepared[which], poses[s]);
  }
  return yes;
}

static bool sweeps_of(unsigned which) {
  bool yes = false;
  for (unsigned s = 0; s < steps_set && !yes; s++) {
    yes = peer[which]->sweeps(prepared[which], poses[s], poses[s + 1]);
  }
  return yes;
}

typedef struct tally {
  unsigned touches, missed, free, alarms;
  double seconds;
} tally;

static double now(void) {
  return 1e-9 * measuring_ns(CLOCK_PROCESS_CPUTIME_ID);
}

// method: 0 the edge, 1 its samples, then samples and sweeps of each other library.
static bool ask(unsigned method) {
  return method == 0   ? by_edge()
         : method == 1 ? by_samples()
         : method % 2  ? sweeps_of(method / 2 - 1)
                       : samples_of(method / 2 - 1);
}

static void measure(unsigned method, arm_truth truth, unsigned repetitions, tally *t) {
  double least = 1e30;
  bool yes = false;
  if (method > 1) {
    steps_set = set_poses(method % 2 ? SEGMENT : SAMPLE);
  }
  for (unsigned i = 0; i < repetitions; i++) {
    const double start = now();
    yes = ask(method);
    const double spent = now() - start;
    least = spent < least ? spent : least;
  }
  t->seconds += least;
  t->touches += truth == ARM_TRUTH_TOUCH;
  t->missed += truth == ARM_TRUTH_TOUCH && !yes;
  t->free += truth == ARM_TRUTH_FREE;
  t->alarms += truth == ARM_TRUTH_FREE && yes;
}

int main(int argc, char **argv) {
  const unsigned long edges = argc > 1 ? strtoul(argv[1], NULL, 10) : 0;
  const unsigned repetitions = argc > 2 ? (unsigned)strtoul(argv[2], NULL, 10) : 3;
  const gjk_pose base = GJK_POSE_IDENTITY;
  unsigned peers = 0;
#ifdef SWEEP_FCL
  peer[peers++] = &sweep_fcl;
#endif
#ifdef SWEEP_BULLET
  peer[peers++] = &sweep_bullet;
#endif
  if (edges == 0 || repetitions == 0 || !seven_make(&machine, &base)) {
    fputs("usage: gjk-arms EDGES [REPETITIONS]\n", stderr);
    return 2;
  }
  for (unsigned family = 0; family < 2; family++) {
    random_state random = random_seed(5 + family);
    tally tallies[6] = {{0, 0, 0, 0, 0}};
    unsigned long done = 0;
    for (unsigned long tries = 0; done < edges && tries < 100 * edges; tries++) {
      if (tries % 4 == 0 && !seven_surround(&machine, &random, 10 + random_below(&random, 11))) {
        return 1;
      }
      if (family == 0) {
        random_edge(&random);
      } else if (!grazing_edge(&random)) {
        continue;
      }
      const arm_truth truth = truth_of();
      if (truth == ARM_TRUTH_OPEN) {
        continue;
      }
      const sweep_scene scene = make_scene();
      for (unsigned i = 0; i < peers; i++) {
        prepared[i] = peer[i]->prepare(&scene);
      }
      for (unsigned m = 0; m < 2 + 2 * peers; m++) {
        measure(m, truth, repetitions, &tallies[m]);
      }
      for (unsigned i = 0; i < peers; i++) {
        peer[i]->release(prepared[i]);
      }
      done++;
    }
    for (unsigned m = 0; m < 2 + 2 * peers; m++) {
      const tally *t = &tallies[m];
      printf("%s,%s%s,%u,%u,%u,%u,%.1f\n", family == 0 ? "random" : "grazing", m < 2 ? "gjk" : peer[m / 2 - 1]->name,
             m == 0       ? "; the whole edge"
             : m % 2 == 0 ? "; samples of 0.01 rad"
             : m == 1     ? "; samples of 0.01 rad"
                          : "; sweeps of 0.1 rad",
             t->touches, t->missed, t->free, t->alarms, 1e6 * t->seconds / (double)done);
    }
  }
  return 0;
}
