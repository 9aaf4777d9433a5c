// Families of random worlds (world.h), of space or, after plane_names.h, of the plane: every report of every update is
// compared with a search of all pairs.
#ifndef SCENE_FAMILIES_H
#define SCENE_FAMILIES_H

#include <stdlib.h>

#include "check.h"
#include "scene/world.h"

#define UPDATES 400

// May queries of a family stay unsettled?
#ifndef FAMILY_MAY_STAY_OPEN
#define FAMILY_MAY_STAY_OPEN(options) false
#endif

#define FAMILY(count, distance, margin, level, ...)                                                             \
  {                                                                                                             \
    .bodies = (count), .reach = GJK_Q16(distance), .box_margin = GJK_Q16(margin), .detail = GJK_DETAIL_##level, \
    __VA_ARGS__                                                                                                 \
  }

static const world_options families[] = {
    // bodies, reach, margin of their boxes, detail
    FAMILY(WORLD_BODIES, 3, 0.1, TOUCH, .retest_all = 0),
    FAMILY(WORLD_BODIES, 3, 0.1, TOUCH, .retest_all = 1),
    FAMILY(WORLD_BODIES, 2, 0, DISTANCE, .persist = 1, .predicate = true, .margins = true, .words = 1, .sensors = true),
    FAMILY(WORLD_BODIES, 2, 1, DISTANCE, .persist = 1, .retest_all = 1, .predicate = true, .margins = true, .words = 1,
           .sensors = true),
    FAMILY(WORLD_BODIES, 4, 0.25, TOUCH, .persist = 1, .margins = true),
    FAMILY(5, 1, 0.05, DISTANCE, .persist = 1, .margins = true),
    FAMILY(WORLD_BODIES, 2, 0.1, DEPTH, .persist = 1, .margins = true, .words = 5, .sensors = true),
    FAMILY(WORLD_BODIES, 2, 0.3, DEPTH, .persist = 1, .retest_all = 1, .margins = true, .words = 5, .sensors = true),
    FAMILY(WORLD_BODIES, 1.5, 0.2, DISTANCE, .persist = 1, .margins = true, .edges = true),
    FAMILY(WORLD_BODIES, 1.5, 4000, DISTANCE, .persist = 1, .retest_all = 1, .margins = true, .edges = true),
};

#define FAMILIES (sizeof families / sizeof families[0])

static world w;
static world_list expected, actual;
static unsigned unsettled;

static bool update(void) {
  gjk_progress progress;
  const gjk_status status = gjk_scene_update(&w.scene, actual.report, WORLD_REPORTS, &progress);
  actual.count = progress.reports;
  return status == GJK_OK && progress.reports_left == 0 && progress.pairs_left == 0;
}

// Every pair that the skips and queries are counted for is counted once.
static bool counted(const gjk_scene_stats *s) {
  return s->resting + s->filtered + s->motion + s->boxes + s->direction + s->warm + s->cold == s->pairs;
}

static void run_family(unsigned family, uint64_t seed) {
  const world_options *options = &families[family];
  const gjk_scene_config config = world_config(options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  random_state random = random_seed(seed + family / 2);
  gjk_scene_stats all = {0}, stats;
  CHECK(block != NULL);
  CHECK(world_start(&w, options, block, bytes));
  for (int i = 0; i < UPDATES; i++) {
    bool fine = true;
    check_trial((unsigned long)i, NULL, NULL);
    const uint32_t changes = random_below(&random, 4) == 0 ? 60 : 12;
    for (uint32_t k = 0; k < changes && fine; k++) {
      fine = world_change(&w, &random);
    }
    CHECK_MSG(fine, "a change, family %u, update %d", family, i);
    CHECK_MSG(gjk_scene_check(&w.scene) == GJK_OK, "before, family %u, update %d", family, i);
    world_expect(&w, &expected);
    CHECK_MSG(update(), "family %u, update %d", family, i);
    CHECK_MSG(gjk_scene_check(&w.scene) == GJK_OK, "after, family %u, update %d", family, i);
    const bool same = world_same(&expected, &actual);
    CHECK_MSG(same, "family %u, update %d: %u reports, %u expected", family, i, actual.count, expected.count);
    CHECK_MSG(world_write_words(&w, &random), "family %u, update %d: words", family, i);
    gjk_scene_get_stats(&w.scene, &stats);
    all.begun += stats.begun;
    all.ended += stats.ended;
    all.persisting += stats.persisting;
    all.resting += stats.resting;
    all.motion += stats.motion;
    all.boxes += stats.boxes;
    all.direction += stats.direction;
    all.warm += stats.warm;
    all.cold += stats.cold;
    all.unsettled += stats.unsettled;
    CHECK(counted(&stats));
    if (!same || !fine) {
      break;
    }
  }
  printf(
      "family %u: %u begun, %u ended, %u persisting; %u resting, %u motion, %u boxes, %u direction, %u warm, %u cold, "
      "%u unsettled\n",
      family, all.begun, all.ended, all.persisting, all.resting, all.motion, all.boxes, all.direction, all.warm,
      all.cold, all.unsettled);
  CHECK(!options->persist || options->bodies < WORLD_BODIES || (w.still > 1000 && all.persisting - w.still > 1000));
  // Each family must still come to touch and part, and each skip must have had its turn.
  CHECK(options->bodies < WORLD_BODIES || (all.begun > 200 && all.ended > 200));
  CHECK(all.unsettled == 0 || world_is_tight() || FAMILY_MAY_STAY_OPEN(options));
  unsettled += all.unsettled;
  if (options->retest_all) {
    CHECK(all.resting + all.motion + all.direction + all.warm == 0);
  } else if (options->bodies == WORLD_BODIES) {
    CHECK(all.resting > 100);
    CHECK(all.motion > 100);
    CHECK(all.boxes > 100);
    CHECK(all.direction > 100);
    CHECK(all.warm > 100);
  }
  free(block);
}

#endif
