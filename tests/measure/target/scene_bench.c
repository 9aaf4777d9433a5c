// Ticks of a scene whose instructions are counted.
#include "scene_bench.h"

#define BODIES 256
#define WARM_UP 20

const scene_bench_case scene_bench_cases[] = {
    {"64 bodies sparse, 25 % moving", TRAFFIC_SPARSE, 64, 25},
    {"64 bodies crowded, 25 % moving", TRAFFIC_CROWDED, 64, 25},
    {"64 bodies in piles, 25 % moving", TRAFFIC_PILES, 64, 25},
    {"64 bodies crowded, all moving", TRAFFIC_CROWDED, 64, 100},
    {"64 bodies crowded, at rest", TRAFFIC_CROWDED, 64, 0},
    {"256 bodies sparse, 25 % moving", TRAFFIC_SPARSE, 256, 25},
    {"256 bodies crowded, 25 % moving", TRAFFIC_CROWDED, 256, 25},
    {"256 bodies in piles, 25 % moving", TRAFFIC_PILES, 256, 25},
    {"256 bodies crowded, all moving", TRAFFIC_CROWDED, 256, 100},
    {"256 bodies crowded, at rest", TRAFFIC_CROWDED, 256, 0},
};
const unsigned scene_bench_count = sizeof scene_bench_cases / sizeof scene_bench_cases[0];

static uint32_t block[(BODIES * 250 + (BODIES * 10 + 64) * 48 + 1000) / 4];
static traffic_body bodies[BODIES];
static traffic state;
static gjk_scene scene;

void scene_bench_plan(void) {
  traffic_plan(&state);
}

static void count_report(void *user, const gjk_report *report) {
  uint32_t *count = user;
  *count += report->event;
}

bool scene_bench_tick(void) {
  uint32_t count = 0;
  return traffic_apply(&state, &scene) == GJK_OK && gjk_scene_update_each(&scene, count_report, &count) == GJK_OK;
}

bool scene_bench_start(const scene_bench_case *c) {
  const gjk_scene_config config = traffic_config(c->kind, c->bodies);
  bool fine = gjk_scene_init(&scene, &config, block, sizeof block, traffic_shapes, TRAFFIC_SHAPES, NULL) == GJK_OK &&
              traffic_start(&state, &scene, c->kind, c->bodies, c->percent, bodies) == GJK_OK;
  for (int i = 0; i < WARM_UP && fine; i++) {
    scene_bench_plan();
    fine = scene_bench_tick();
  }
  return fine;
}

void scene_bench_stats(gjk_scene_stats *out) {
  gjk_scene_get_stats(&scene, out);
}
