// The library as a method. The file of the plane includes this one under the plane's names.
#include <stdlib.h>

#include "rest.h"

#ifndef REST_OF_PLANE
#include "gjk/concave.h"
#include "gjk/scene.h"
#define REST_METHOD(kind) rest_gjk_##kind
#define REST_NAME(kind) "gjk: " kind
#define REST_PLANE false
#endif

typedef struct rest_world {
  const rest_stage *stage;
  gjk_scene scene;
  gjk_body_id id[REST_BODIES];
  unsigned frame;
  uint32_t capacity;
  gjk_report *reports;
  gjk_manifold *manifolds;
} rest_world;

static const gjk_pose *pose_of(const rest_world *w, unsigned frame, unsigned body) {
  return (const gjk_pose *)w->stage->poses + (size_t)frame * w->stage->bodies + body;
}

static bool same_pose(const gjk_pose *a, const gjk_pose *b) {
  const int32_t *x = (const int32_t *)a, *y = (const int32_t *)b;
  bool same = true;
  for (unsigned i = 0; i < sizeof *a / sizeof *x; i++) {
    same = same && x[i] == y[i];
  }
  return same;
}

static void stop(void *world) {
  rest_world *w = world;
  free(w->scene.block);
  free(w->reports);
  free(w->manifolds);
  free(w);
}

static bool add_bodies(rest_world *w) {
  bool fine = true;
  for (unsigned i = 0; i < w->stage->bodies && fine; i++) {
    const rest_body *b = &w->stage->body[i];
    const gjk_part part = {b->shape, false, GJK_POSE_IDENTITY};
    const gjk_body_setup setup = {.pose = *pose_of(w, 0, i),
                                  .parts = &part,
                                  .part_count = 1,
                                  .kind = b->fixed ? GJK_BODY_STATIC : GJK_BODY_DYNAMIC,
                                  .category = 1,
                                  .mask = 1,
                                  .margin = REST_MARGIN / 2};
    fine = gjk_scene_add(&w->scene, &setup, &w->id[i]) == GJK_OK;
  }
  return fine;
}

static void *start(const rest_stage *stage, bool manifolds, bool keeps) {
  const gjk_scene_config config = {.bodies = stage->bodies,
                                   .parts = stage->bodies,
                                   .pairs = 16 * stage->bodies,
                                   .box_margin = GJK_Q16(0.05),
                                   .detail = manifolds ? GJK_DETAIL_CONTACTS : GJK_DETAIL_TOUCH,
                                   .persist = 1};
  rest_world *w = calloc(1, sizeof *w);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  w->capacity = config.pairs;
  w->reports = malloc(w->capacity * sizeof *w->reports);
  w->manifolds = malloc(w->capacity * sizeof *w->manifolds);
  w->stage = stage;
  const gjk_scene_bindings bindings = {
      .details = &gjk_scene_contacts, .manifolds = manifolds ? w->manifolds : NULL, .keeps_manifolds = keeps};
  if (gjk_scene_init(&w->scene, &config, block, bytes, (const gjk_shape *const *)stage->shape, REST_SHAPES,
                     &bindings) != GJK_OK ||
      !add_bodies(w)) {
    w->scene.block = block;
    stop(w);
    return NULL;
  }
  return w;
}

static void *start_manifolds(const rest_stage *stage) {
  return start(stage, true, false);
}

static void *start_kept(const rest_stage *stage) {
  return start(stage, true, true);
}

static void *start_near(const rest_stage *stage) {
  return start(stage, false, false);
}

static bool go(void *world, unsigned frame, rest_found *found) {
  rest_world *w = world;
  gjk_progress progress;
  bool fine = true;
  found->moved = 0;
  for (unsigned i = 0; i < w->stage->bodies && fine; i++) {
    const gjk_pose *to = pose_of(w, frame, i);
    if (!w->stage->body[i].fixed && !same_pose(to, pose_of(w, w->frame, i))) {
      fine = gjk_scene_move(&w->scene, w->id[i], to) == GJK_OK;
      found->moved++;
    }
  }
  w->frame = frame;
  fine = fine && gjk_scene_update(&w->scene, w->reports, w->capacity, &progress) == GJK_OK;
  gjk_scene_stats stats = {0};
  fine = fine && progress.reports_left == 0 && gjk_scene_get_stats(&w->scene, &stats) == GJK_OK;
  found->pairs = stats.pairs;
  found->near = stats.begun + stats.persisting;
  found->manifolds = stats.manifolds;
  found->queried = stats.warm + stats.cold;
  return fine;
}

const rest_method REST_METHOD(manifolds) = {
    .name = REST_NAME("manifolds"), .plane = REST_PLANE, .start = start_manifolds, .go = go, .stop = stop};
const rest_method REST_METHOD(kept) = {
    .name = REST_NAME("not still"), .plane = REST_PLANE, .start = start_kept, .go = go, .stop = stop};
const rest_method REST_METHOD(near) = {
    .name = REST_NAME("near or not"), .plane = REST_PLANE, .start = start_near, .go = go, .stop = stop};
