// Time per tick of scenes of 8 to 20,000 bodies on this machine, as CSV, against testing the boxes of all pairs.
//
// scene-bench [QUICK]: with an argument only the line that a figure is promised for, and whether it is kept.
#define _POSIX_C_SOURCE 199309L

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "../scene/traffic.h"

#define BODIES 20000
#define PROMISED_BODIES 10000
#define PROMISED_PERCENT 5
#define PROMISED_RATIO 20

static traffic_body bodies[BODIES];
static gjk_aabb boxes[BODIES];

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void ignore_report(void *user, const gjk_report *report) {
  uint32_t *count = user;
  *count += report->event;
}

// Nanoseconds for the boxes of all pairs, ready made; the caller's moves and posing are not in it.
static double test_all(const gjk_scene *scene, uint32_t count, uint32_t *meeting) {
  for (uint32_t i = 0; i < count; i++) {
    gjk_collider c;
    gjk_scene_collider(scene, bodies[i].handle, 0, &c);
    gjk_collider_aabb(&c, &boxes[i]);
  }
  const double start = now();
  uint32_t found = 0;
  for (uint32_t i = 0; i < count; i++) {
    for (uint32_t k = i + 1; k < count; k++) {
      const gjk_aabb *a = &boxes[i], *b = &boxes[k];
      found += a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y &&
               b->lower.y <= a->upper.y && a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
    }
  }
  *meeting = found;
  return now() - start;
}

// One line: the mean over as many ticks as take about a quarter of a second. Returns how many times faster than all pairs;
// negative when something failed.
static double run(const char *name, traffic_kind kind, uint32_t count, uint32_t percent) {
  const gjk_scene_config config = traffic_config(kind, count);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  gjk_scene scene;
  gjk_scene_stats stats;
  traffic t;
  uint32_t reports = 0, meeting = 0;
  bool fine = block != NULL &&
              gjk_scene_init(&scene, &config, block, bytes, traffic_shapes, TRAFFIC_SHAPES) == GJK_OK &&
              traffic_start(&t, &scene, kind, count, percent, bodies) == GJK_OK;
  double total = 0;
  unsigned ticks = 0;
  for (int i = -10; fine && (i < 10 || (total < 25e7 && i < 10000)); i++) {
    traffic_plan(&t);
    const double start = now();
    fine = traffic_apply(&t, &scene) == GJK_OK && gjk_scene_update_each(&scene, ignore_report, &reports) == GJK_OK;
    if (i >= 0) {
      total += now() - start;
      ticks++;
    }
  }
  if (!fine) {
    fprintf(stderr, "%s, %u bodies: failed\n", name, count);
    free(block);
    return -1;
  }
  gjk_scene_get_stats(&scene, &stats);
  const double all = test_all(&scene, count, &meeting), mean = total / ticks;
  const double share = stats.pairs > 0 ? 100.0 / stats.pairs : 0;
  printf("%s,%u,%u,%.0f,%.0f,%.1f,%u,%u,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f\n", name, count, percent, mean, all, all / mean,
         stats.pairs, meeting, stats.resting * share, stats.motion * share, stats.boxes * share,
         stats.direction * share, stats.warm * share, stats.cold * share);
  free(block);
  return all / mean;
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
  puts(
      "scene,bodies,percent moving,ns per tick,ns all box pairs,times faster,pairs,boxes meeting,"
      "% resting,% motion,% boxes,% direction,% warm,% cold");
  if (argc > 1) {
    const double ratio = run("sparse", TRAFFIC_SPARSE, PROMISED_BODIES, PROMISED_PERCENT);
    return ratio >= PROMISED_RATIO ? 0 : 1;
  }
  for (unsigned k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    for (unsigned n = 0; n < sizeof counts / sizeof counts[0]; n++) {
      for (unsigned p = 0; p < sizeof percents / sizeof percents[0]; p++) {
        if (run(kinds[k].name, kinds[k].kind, counts[n], percents[p]) < 0) {
          return 1;
        }
      }
    }
  }
  return 0;
}
