// The library as a method, three ways.
//
// Whole: the moves of the bodies (posing and boxes in them), tree, pairs, and the exact answer of every pair, reported.
// Broad: the same with a predicate that refuses every pair when it is asked: posing, boxes, tree, pairs of enlarged
//   boxes, one call of the predicate per pair of a body that moved; no test of any pair. What is left of the test, the
//   filter and that call, stays in the figure.
// Posing: poses the same bodies and takes their boxes, nothing else: what a user of another library does beforehand.
#include "method_gjk.h"

#include <stdlib.h>

#include "scene/traffic.h"

typedef struct gjk_world {
  gjk_scene scene;
  uint32_t count;
  uint32_t reports;
  scene_meet *meet;  // for counting
  const void *meet_user;
  uint32_t held, meeting;
  traffic_body bodies[];  // with the handles in this scene
} gjk_world;

static void count_report(void *user, const gjk_report *report) {
  gjk_world *w = user;
  w->reports += report->event;
}

static bool refuse(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b) {
  gjk_world *w = user;
  (void)user_a;
  (void)user_b;
  if (w->meet != NULL) {
    w->held++;
    w->meeting += w->meet(w->meet_user, a.slot, b.slot);
  }
  return false;
}

static bool update(gjk_world *w) {
  return gjk_scene_update_each(&w->scene, count_report, w) == GJK_OK;
}

static void stop(void *world) {
  gjk_world *w = world;
  free(w->scene.block);
  free(w);
}

static void *start_bound(const scene_tick *all, gjk_scene_predicate *predicate) {
  const gjk_scene_config config = traffic_config(TRAFFIC_CROWDED, all->count);
  const size_t bytes = gjk_scene_bytes(&config);
  gjk_world *w = calloc(1, sizeof *w + all->count * sizeof w->bodies[0]);
  void *block = malloc(bytes);
  const gjk_scene_bindings bindings = {.predicate = predicate, .user = w};
  if (w == NULL || block == NULL ||
      gjk_scene_init(&w->scene, &config, block, bytes, traffic_shapes, TRAFFIC_SHAPES, &bindings) != GJK_OK) {
    free(block);
    free(w);
    return NULL;
  }
  w->count = all->count;
  for (uint32_t i = 0; i < all->count; i++) {
    w->bodies[i] = all->bodies[i];
    if (traffic_add(&w->scene, i, &w->bodies[i]) != GJK_OK) {
      stop(w);
      return NULL;
    }
  }
  return w;
}

static void *start(const scene_tick *all) {
  return start_bound(all, NULL);
}

static void *start_broad(const scene_tick *all) {
  return start_bound(all, refuse);
}

static bool replace(gjk_world *w, uint32_t slot, const traffic_body *body) {
  const gjk_body_id old = w->bodies[slot].handle;
  w->bodies[slot] = *body;
  return gjk_scene_remove(&w->scene, old) == GJK_OK && traffic_add(&w->scene, slot, &w->bodies[slot]) == GJK_OK;
}

static bool tick(void *world, const scene_tick *changes) {
  gjk_world *w = world;
  bool fine = true;
  for (uint32_t i = 0; i < changes->count && fine; i++) {
    const uint32_t slot = changes->boxes[i].body;
    fine = changes->boxes[i].anew
               ? replace(w, slot, &changes->bodies[i])
               : gjk_scene_move(&w->scene, w->bodies[slot].handle, &changes->bodies[i].pose) == GJK_OK;
  }
  return fine && update(w);
}

// Has the predicate asked about every pair.
static void count(void *world, scene_meet *meet, const void *user, uint32_t *held, uint32_t *meeting) {
  gjk_world *w = world;
  w->meet = meet;
  w->meet_user = user;
  for (uint32_t i = 0; i < w->count; i++) {
    (void)gjk_scene_refilter(&w->scene, w->bodies[i].handle);
  }
  (void)update(w);
  *held = w->held;
  *meeting = w->meeting;
}

gjk_scene_stats method_gjk_stats(void *world) {
  const gjk_world *w = world;
  gjk_scene_stats stats = {0};
  (void)gjk_scene_get_stats(&w->scene, &stats);
  return stats;
}

typedef struct poser {
  gjk_collider collider;
  gjk_aabb box;
} poser;

static bool pose(poser *p, const traffic_body *body, bool anew) {
  return (!anew || gjk_collider_init(&p->collider, traffic_shapes[body->shape], NULL, 0) == GJK_OK) &&
         gjk_collider_pose(&p->collider, &body->pose) == GJK_OK && gjk_collider_aabb(&p->collider, &p->box) == GJK_OK;
}

static bool tick_posing(void *world, const scene_tick *changes) {
  poser *posers = world;
  bool fine = true;
  for (uint32_t i = 0; i < changes->count && fine; i++) {
    fine = pose(&posers[changes->boxes[i].body], &changes->bodies[i], changes->boxes[i].anew);
  }
  return fine;
}

static void *start_posing(const scene_tick *all) {
  poser *posers = calloc(all->count, sizeof *posers);
  if (posers != NULL && !tick_posing(posers, all)) {
    free(posers);
    return NULL;
  }
  return posers;
}

const scene_method scene_gjk_whole = {"gjk: whole tick", start, tick, NULL, stop};
const scene_method scene_gjk_broad = {"gjk: broad phase", start_broad, tick, count, stop};
const scene_method scene_gjk_posing = {"gjk: posing", start_posing, tick_posing, NULL, free};
