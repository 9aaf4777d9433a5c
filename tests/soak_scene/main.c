// A long run of random operations on a scene, saves and restores among them, against a search of all pairs.
//
// scene-soak OPERATIONS [SEED]
#include <stdlib.h>
#include <string.h>

#include "../check.h"
#include "../scene/world.h"

static world w, saved;
static world_list expected, actual;
static unsigned long updates, restores, failures, begun;

// Goes on in another block: a copy of this one, or of the one that was saved.
static void move_block(size_t bytes, void *save, bool back) {
  void *block = malloc(bytes);
  gjk_scene scene;
  if (!back) {
    CHECK(gjk_scene_seal(&w.scene) == GJK_OK);
  }
  memcpy(block, back ? save : w.scene.block, bytes);
  const gjk_status status = back ? gjk_scene_attach(&scene, block, bytes, world_shapes, WORLD_SHAPES)
                                 : gjk_scene_open(&scene, block, bytes, world_shapes, WORLD_SHAPES);
  CHECK_MSG(status == GJK_OK, "after %lu updates", updates);
  free(w.scene.block);
  if (back) {
    w = saved;
  }
  world_equip(&w, &scene);
  w.scene = scene;
  restores++;
}

static bool update(random_state *random) {
  gjk_progress progress = {0, 0, 0};
  bool fine = true;
  world_expect(&w, &expected);
  actual.count = 0;
  do {
    const uint32_t room = random_below(random, 8) == 0 ? random_below(random, 5) : WORLD_REPORTS - actual.count;
    fine = gjk_scene_update_slice(&w.scene, 1 + random_below(random, 400), &actual.report[actual.count], room,
                                  &progress) == GJK_OK;
    actual.count += progress.reports;
  } while (fine && (progress.pairs_left > 0 || progress.reports_left > 0));
  updates++;
  for (uint32_t i = 0; i < actual.count; i++) {
    begun += actual.report[i].event == GJK_EVENT_BEGIN;
  }
  return fine && world_same(&expected, &actual) && gjk_scene_check(&w.scene) == GJK_OK;
}

int main(int argc, char **argv) {
  const unsigned long operations = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
  random_state random = random_seed(argc > 2 ? strtoul(argv[2], NULL, 10) : 1);
  unsigned long done = 0;
  while (done < operations) {
    world_options options = {WORLD_BODIES, GJK_Q16(3), 0, 0, 0, 0, false, false, false};
    options.bodies = 2 + random_below(&random, WORLD_BODIES - 1);
    options.reach = random_range(&random, GJK_Q16(1), GJK_Q16(5));
    options.box_margin = random_range(&random, 0, GJK_Q16(0.5));
    options.detail = (uint8_t)(random_below(&random, 4) == 0 ? random_below(&random, 4) : random_below(&random, 2));
    options.persist = (uint8_t)random_below(&random, 2);
    options.predicate = random_below(&random, 2) == 0;
    options.margins = random_below(&random, 2) == 0;
    options.edges = random_below(&random, 8) == 0;
    const gjk_scene_config config = world_config(&options);
    const size_t bytes = gjk_scene_bytes(&config);
    void *save = malloc(bytes);
    bool fine = world_start(&w, &options, malloc(bytes), bytes);
    saved = w;
    memcpy(save, w.scene.block, bytes);
    for (int round = 0; round < 500 && fine && done < operations; round++) {
      const uint32_t changes = random_below(&random, 30);
      for (uint32_t i = 0; i < changes && fine; i++, done++) {
        fine = world_change(&w, &random);
      }
      fine = fine && gjk_scene_check(&w.scene) == GJK_OK && update(&random);
      const uint32_t what = random_below(&random, 20);
      if (what == 0) {
        saved = w;
        memcpy(save, w.scene.block, bytes);
      } else if (what < 3) {
        move_block(bytes, save, what == 2);
      }
    }
    CHECK_MSG(fine, "after %lu operations", done);
    failures += w.failures;
    free(w.scene.block);
    free(save);
    if (!fine) {
      break;
    }
  }
  printf("%lu operations, %lu of them refused for lack of room; %lu updates, %lu restores, %lu touches begun\n", done,
         failures, updates, restores, begun);
  // The mix must still do all of it.
  CHECK(failures * 400 > done && restores * 30 > updates && begun * 5 > updates);
  return check_done("scene_soak");
}
