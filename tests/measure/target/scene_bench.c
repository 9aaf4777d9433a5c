// Ticks of a scene whose instructions are counted.
#include "scene_bench.h"

#define BODIES 256
#define WARM_UP 20

const scene_bench_case scene_bench_cases[] = {
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
const unsigned scene_bench_count = sizeof scene_bench_cases / sizeof scene_bench_cases[0];

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

void scene_bench_plan(void) {
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

bool scene_bench_tick(void) {
  uint32_t count = 0;
  if (ray) {
    return cast_ray();
  }
  return traffic_apply(&state, &scene) == GJK_OK && gjk_scene_update_each(&scene, count_report, &count) == GJK_OK;
}

bool scene_bench_start(const scene_bench_case *c) {
  const gjk_scene_config config = traffic_config(c->kind, c->bodies);
  bool fine = gjk_scene_init(&scene, &config, block, sizeof block, traffic_shapes, TRAFFIC_SHAPES, NULL) == GJK_OK &&
              traffic_start(&state, &scene, c->kind, c->bodies, c->percent, bodies) == GJK_OK;
  ray = false;
  hits = 0;
  for (int i = 0; i < WARM_UP && fine; i++) {
    scene_bench_plan();
    fine = scene_bench_tick();
  }
  ray = c->ray;
  return fine;
}

void scene_bench_stats(gjk_scene_stats *out) {
  gjk_scene_get_stats(&scene, out);
  if (ray) {
    const gjk_scene_stats none = {.begun = hits};
    *out = none;
  }
}
