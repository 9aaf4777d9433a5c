// A world that is saved, restored and moved to other memory.
#include "session.h"

#include <stdlib.h>
#include <string.h>

bool session_start(session *s, const world_options *options) {
  const gjk_scene_config config = world_config(options);
  s->bytes = gjk_scene_bytes(&config);
  s->save = malloc(s->bytes);
  void *block = malloc(s->bytes);
  if (s->save == NULL || block == NULL || !world_start(&s->now, options, block, s->bytes)) {
    return false;
  }
  session_keep(s);
  return true;
}

void session_end(session *s) {
  free(s->now.scene.block);
  free(s->save);
}

world_options session_options(random_state *random) {
  world_options options = {WORLD_BODIES, GJK_Q16(3), 0, 0, 0, 0, false, false, false, false, 0, false};
  options.bodies = 2 + random_below(random, WORLD_BODIES - 1);
  options.reach = random_range(random, GJK_Q16(1), GJK_Q16(5));
  options.box_margin = random_range(random, 0, GJK_Q16(0.5));
  options.detail = (uint8_t)(random_below(random, 4) == 0 ? random_below(random, 4) : random_below(random, 2));
  options.persist = (uint8_t)random_below(random, 2);
  options.predicate = random_below(random, 2) == 0;
  options.margins = random_below(random, 2) == 0;
  options.edges = random_below(random, 8) == 0;
  options.words = (uint8_t)(random_below(random, 8) == 0 ? GJK_SCENE_PAIR_WORDS_MAX : random_below(random, 4));
  options.sensors = random_below(random, 2) == 0;
  return options;
}

// Leaves impacts out, where the list of what is expected has none.
static void drop_impacts(world_list *list) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < list->count; i++) {
    if (list->report[i].event != GJK_EVENT_IMPACT) {
      list->report[count++] = list->report[i];
    }
  }
  list->count = count;
}

bool session_update(session *s, random_state *random) {
  static world_list expected, actual;
  gjk_progress progress = {0, 0, 0};
  bool fine = true;
  world_expect(&s->now, &expected);
  actual.count = 0;
  do {
    const uint32_t room = random_below(random, 8) == 0 ? random_below(random, 5) : WORLD_REPORTS - actual.count;
    fine = gjk_scene_update_slice(&s->now.scene, 1 + random_below(random, 400), &actual.report[actual.count], room,
                                  &progress) == GJK_OK;
    actual.count += progress.reports;
  } while (fine && (progress.pairs_left > 0 || progress.reports_left > 0));
  s->updates++;
  for (uint32_t i = 0; i < actual.count; i++) {
    s->begun += actual.report[i].event == GJK_EVENT_BEGIN;
  }
  if (world_is_tight()) {
    drop_impacts(&actual);
  }
  return fine && world_same(&expected, &actual) && gjk_scene_check(&s->now.scene) == GJK_OK &&
         world_write_words(&s->now, random);
}

void session_keep(session *s) {
  s->saved = s->now;
  memcpy(s->save, s->now.scene.block, s->bytes);
}

bool session_move(session *s, bool back) {
  const gjk_scene_bindings bindings = world_bindings(&s->now.options);
  void *block = malloc(s->bytes);
  gjk_scene scene;
  if (block == NULL || (!back && gjk_scene_seal(&s->now.scene) != GJK_OK)) {
    return false;
  }
  memcpy(block, back ? s->save : s->now.scene.block, s->bytes);
  const gjk_status status = back ? gjk_scene_attach(&scene, block, s->bytes, world_shapes, WORLD_SHAPES, &bindings)
                                 : gjk_scene_open(&scene, block, s->bytes, world_shapes, WORLD_SHAPES, &bindings);
  free(s->now.scene.block);
  if (back) {
    s->now = s->saved;
  }
  s->now.scene = scene;
  s->restores++;
  return status == GJK_OK;
}

bool session_change(session *s, random_state *random, uint32_t *what) {
  *what = random_below(random, 100);
  if (*what < 86) {
    return world_change(&s->now, random);
  }
  if (*what < 94) {
    return session_update(s, random);
  }
  if (*what < 96) {
    session_keep(s);
    return true;
  }
  return session_move(s, *what < 98);
}
