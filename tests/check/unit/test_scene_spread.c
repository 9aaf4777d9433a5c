// An update in slices, in small buffers, by a function, or by threads on ranges gives the reports of a whole one.
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"

// The test of the plane has included the plane's.
#ifndef WORLD_OF_PLANE
#include "scene/workspace_space.h"
#endif

#ifndef TEST_NAME
#define TEST_NAME "scene_spread"
#endif

#define SEED 4
#define UPDATES 150
#define THREADS 3

typedef enum manner { WHOLE, SLICES, SMALL_BUFFERS, FUNCTION, RANGES, MANNERS } manner;

static world worlds[MANNERS];
static world_list lists[MANNERS];

static bool in_slices(world *w, random_state *random, bool small, world_list *list) {
  gjk_progress progress;
  gjk_report few[3];
  do {
    const uint32_t tests = small ? UINT32_MAX : random_below(random, 9);
    const uint32_t room = random_below(random, 4);
    if (gjk_scene_update_slice(&w->scene, tests, few, room, &progress) != GJK_OK || progress.reports > room ||
        gjk_scene_check(&w->scene) != GJK_OK) {
      return false;
    }
    memcpy(&list->report[list->count], few, progress.reports * sizeof few[0]);
    list->count += progress.reports;
  } while (progress.pairs_left > 0 || progress.reports_left > 0);
  return true;
}

static void take_report(void *user, const gjk_report *report) {
  world_list *list = user;
  list->report[list->count++] = *report;
}

typedef struct range {
  gjk_scene scene;  // a copy with a workspace of its own
  world_workspace workspace;
  uint32_t begin, end;
  gjk_status status;
} range;

static void *test_range(void *argument) {
  range *r = argument;
  r->status = gjk_scene_test_pairs(&r->scene, r->begin, r->end);
  return NULL;
}

static void *sweep_range(void *argument) {
  range *r = argument;
  r->status = gjk_scene_sweep(&r->scene, r->begin, r->end);
  return NULL;
}

// Runs a function on ranges of count things by threads. The last few are left out.
static bool run_threads(world *w, void *(*function)(void *), uint32_t count) {
  static range ranges[THREADS];
  pthread_t threads[THREADS];
  bool fine = true;
  for (uint32_t i = 0; i < THREADS && fine; i++) {
    range *r = &ranges[i];
    r->scene = w->scene;
    world_bind_workspace(&r->workspace, &r->scene.bindings);
    r->begin = i * (count / THREADS);
    r->end = (i + 1) * (count / THREADS);
    fine = pthread_create(&threads[i], NULL, function, r) == 0;
  }
  for (uint32_t i = 0; i < THREADS && fine; i++) {
    fine = pthread_join(threads[i], NULL) == 0 && ranges[i].status == GJK_OK;
  }
  return fine;
}

// Ranges that leave a few pairs to the final update. Fast bodies are swept once all pairs are tested.
static bool in_ranges(world *w, world_list *list) {
  uint32_t pairs = 0, kept = 0;
  gjk_progress progress;
  bool fine = gjk_scene_update_begin(&w->scene, &pairs) == GJK_OK && run_threads(w, test_range, pairs);
  if (fine && w->options.motions) {
    fine = gjk_scene_test_pairs(&w->scene, 0, pairs) == GJK_OK && gjk_scene_sweep_count(&w->scene, &kept) == GJK_OK &&
           gjk_scene_sweep(&w->scene, 0, kept + 1) == GJK_ERROR_RANGE && run_threads(w, sweep_range, kept);
  }
  fine = fine && gjk_scene_update(&w->scene, list->report, WORLD_REPORTS, &progress) == GJK_OK;
  list->count = progress.reports;
  return fine && progress.reports_left == 0;
}

static bool update(manner how, random_state *random) {
  world *w = &worlds[how];
  world_list *list = &lists[how];
  gjk_progress progress;
  list->count = 0;
  switch (how) {
    case SLICES: return in_slices(w, random, false, list);
    case SMALL_BUFFERS: return in_slices(w, random, true, list);
    case FUNCTION: return gjk_scene_update_each(&w->scene, take_report, list) == GJK_OK;
    case RANGES: return in_ranges(w, list);
    default: break;
  }
  const bool fine = gjk_scene_update(&w->scene, list->report, WORLD_REPORTS, &progress) == GJK_OK;
  list->count = progress.reports;
  return fine;
}

static void check_manners(gjk_detail detail, bool motions) {
  const world_options options = {WORLD_BODIES, GJK_Q16(2.5), GJK_Q16(0.1), (uint8_t)detail, 1, 0,
                                 true,         true,         false,        motions,         0, false};
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  random_state random[MANNERS], slices = random_seed(check_seed(SEED));
  unsigned reports = 0, impacts = 0;
  for (int m = 0; m < MANNERS; m++) {
    random[m] = random_seed(check_seed(SEED) + 51);
    CHECK(world_start(&worlds[m], &options, malloc(bytes), bytes));
  }
  for (int i = 0; i < UPDATES; i++) {
    uint64_t hash[MANNERS];
    check_trial((unsigned long)i, NULL, NULL);
    gjk_scene_stats stats[MANNERS];
    for (int m = 0; m < MANNERS; m++) {
      for (int k = 0; k < 25; k++) {
        CHECK(world_change(&worlds[m], &random[m]));
      }
      CHECK_MSG(update((manner)m, &slices), "manner %d, update %d", m, i);
      CHECK(gjk_scene_hash(&worlds[m].scene, &hash[m]) == GJK_OK);
      CHECK(gjk_scene_get_stats(&worlds[m].scene, &stats[m]) == GJK_OK);
      CHECK_MSG(hash[m] == hash[0], "manner %d, update %d", m, i);
      CHECK_MSG(world_same(&lists[m], &lists[0]), "manner %d, update %d", m, i);
      CHECK_MSG(memcmp(&stats[m], &stats[0], sizeof stats[0]) == 0, "manner %d, update %d", m, i);
    }
    reports += lists[0].count;
    for (uint32_t k = 0; k < lists[0].count; k++) {
      impacts += lists[0].report[k].event == GJK_EVENT_IMPACT;
    }
  }
  printf("%u reports, %u impacts\n", reports, impacts);
  CHECK(reports > 20 * UPDATES && (impacts > UPDATES) == motions);
  for (int m = 0; m < MANNERS; m++) {
    free(worlds[m].scene.block);
  }
}

int main(void) {
  check_manners(GJK_DETAIL_DISTANCE, false);
  check_manners(GJK_DETAIL_DEPTH, false);
  check_manners(GJK_DETAIL_TOUCH, true);
  return check_done(TEST_NAME);
}
