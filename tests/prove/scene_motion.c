// Fast bodies, CASE, on any scene that gjk_scene_check lets through, with up to two kept motions.
#define MOTIONS 2
#include "scene_any.h"

// Values of CASE.
#define SET 1
#define SWEEP 2
#define TESTING 3
#define REPORTING 4

static void update(gjk_scene *scene) {
  gjk_report reports[1];
  gjk_progress progress;
  gjk_scene_header *h = scene->block;
  h->phase = CASE == TESTING ? GJK_SCENE_TESTING : GJK_SCENE_REPORTING;
#if CASE == TESTING
  h->queued = 0;  // what is done with pairs is shown by scene_ops.c
#endif
  (void)gjk_scene_update_slice(scene, any_below(2), any_bool() ? reports : NULL, any_below(2),
                               any_bool() ? &progress : NULL);
}

int main(void) {
  apart_block apart;
  gjk_scene scene;
  uint32_t count;
  if (!any_scene(&scene, &apart)) {
    return 0;
  }
#if CASE == SET
  (void)gjk_scene_set_motion(&scene, any_body_handle(), (uint8_t)any_uint16());
#elif CASE == SWEEP
  (void)gjk_scene_sweep_count(&scene, any_bool() ? &count : NULL);
  (void)gjk_scene_sweep(&scene, any_uint32(), any_uint32());
#else
  update(&scene);
#endif
  return 0;
}
