// Firmware: instructions per tick of a scene, one line per case: NAME|mean|worst|pairs|resting|motion|boxes|direction|warm|cold,
// the last seven as means
#include "count.h"
#include "gjk/probe.h"
#include "scene/traffic.h"

#define BODIES 256
#define WARM_UP 20
#define TICKS 50

typedef struct scene_bench_case {
  const char *name;
  traffic_kind kind;
  uint32_t bodies, percent;
  bool ray;  // what is measured is a ray through them, not a tick
} scene_bench_case;

static const scene_bench_case cases[] = {
    {.name = "64 bodies sparse, 25 % moving", .kind = TRAFFIC_SPARSE, .bodies = 64, .percent = 25},
    {.name = "64 bodies crowded, 25 % moving", .kind = TRAFFIC_CROWDED, .bodies = 64, .percent = 25},
    {.name = "64 bodies in piles, 25 % moving", .kind = TRAFFIC_PILES, .bodies = 64, .percent = 25},
    {.name = "64 bodies crowded, all moving", .kind = TRAFFIC_CROWDED, .bodies = 64, .percent = 100},
    {.name = "64 bodies crowded, at rest", .kind = TRAFFIC_CROWDED, .bodies = 64, .percent = 0},
    {.name = "256 bodies sparse, 25 % moving", .kind = TRAFFIC_SPARSE, .bodies = 256, .percent = 25},
    {.name = "256 bodies crowded, 25 % moving", .kind = TRAFFIC_CROWDED, .bodies = 256, .percent = 25},
    {.name = "256 bodies in piles, 25 % moving", .kind = TRAFFIC_PILES, .bodies = 256, .percent = 25},
    {.name = "256 bodies crowded, all moving", .kind = TRAFFIC_CROWDED, .bodies = 256, .percent = 100},
    {.name = "256 bodies crowded, at rest", .kind = TRAFFIC_CROWDED, .bodies = 256, .percent = 0},
    {.name = "ray through 256 bodies sparse", .kind = TRAFFIC_SPARSE, .bodies = 256, .percent = 25, .ray = true},
    {.name = "ray through 256 bodies crowded", .kind = TRAFFIC_CROWDED, .bodies = 256, .percent = 25, .ray = true},
    {.name = "ray through 256 bodies in piles", .kind = TRAFFIC_PILES, .bodies = 256, .percent = 25, .ray = true},
};

static uint32_t block[(BODIES * 250 + (BODIES * 10 + 64) * 48 + 1000) / 4];
static traffic_body bodies[BODIES];
static traffic state;
static gjk_scene scene;
static bool ray;
static gjk_vec3 from, to;
static uint32_t hits;

// A ray goes from one side of the room to the other one.
static void plan_ray(void) {
  random_state *random = &state.random;
  from.x = -state.reach.x;
  to.x = state.reach.x;
  from.y = random_range(random, -state.reach.y, state.reach.y);
  to.y = random_range(random, -state.reach.y, state.reach.y);
  from.z = random_range(random, -state.reach.z, state.reach.z);
  to.z = random_range(random, -state.reach.z, state.reach.z);
}

COUNTED void plan(void) {
  if (ray) {
    plan_ray();
  } else {
    traffic_plan(&state);
  }
}

static void count_report(void *user, const gjk_report *report) {
  uint32_t *count = user;
  *count += report->event;
}

static bool cast_ray(void) {
  gjk_scene_hit hit;
  gjk_cast_result result;
  bool found;
  const bool fine = gjk_scene_cast_ray(&scene, &from, &to, NULL, &hit, &result, &found) == GJK_OK;
  hits += found;
  return fine;
}

// What is measured: the moves of a tick that is already planned, and the update.
COUNTED bool tick(void) {
  uint32_t count = 0;
  if (ray) {
    return cast_ray();
  }
  return traffic_apply(&state, &scene) == GJK_OK && gjk_scene_update_each(&scene, count_report, &count) == GJK_OK;
}

// Starts a case and runs its first ticks. False: the scene could not be made.
COUNTED bool start_case(const scene_bench_case *c) {
  const gjk_scene_config config = traffic_config(c->kind, c->bodies);
  bool fine = gjk_scene_init(&scene, &config, block, sizeof block, traffic_shapes, TRAFFIC_SHAPES, NULL) == GJK_OK &&
              traffic_start(&state, &scene, c->kind, c->bodies, c->percent, bodies) == GJK_OK;
  ray = false;
  hits = 0;
  for (int i = 0; i < WARM_UP && fine; i++) {
    plan();
    fine = tick();
  }
  ray = c->ray;
  return fine;
}

// Of the tick before.
static void get_stats(gjk_scene_stats *out) {
  gjk_scene_get_stats(&scene, out);
  if (ray) {
    const gjk_scene_stats none = {.begun = hits};
    *out = none;
  }
}

static bool measure(const scene_bench_case *c) {
  count_tally t = {0, 0, 0};
  gjk_scene_stats all = {0}, stats;
  bool fine = start_case(c);
  for (int i = 0; i < TICKS && fine; i++) {
    plan();
    const uint32_t start = board_ticks();
    fine = tick();
    count_add(&t, count_since(start));
    get_stats(&stats);
    all.pairs += stats.pairs;
    all.resting += stats.resting;
    all.motion += stats.motion;
    all.boxes += stats.boxes;
    all.direction += stats.direction;
    all.warm += stats.warm;
    all.cold += stats.cold;
  }
  const uint32_t sums[] = {all.pairs, all.resting, all.motion, all.boxes, all.direction, all.warm, all.cold};
  count_line(c->name, &t);
  for (unsigned i = 0; i < sizeof sums / sizeof sums[0]; i++) {
    count_field(sums[i] / TICKS);
  }
  board_print("\n");
  return fine;
}

int firmware_main(void) {
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    if (!measure(&cases[i])) {
      board_print("a scene failed\n");
      return 1;
    }
  }
  return 0;
}
