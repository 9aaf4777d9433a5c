// Hash, saves, rollbacks and restores at other addresses; the order of adding; blocks that are refused.
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"
#include "scene_bodies.h"
#include "src/scene/gjk_scene_block.h"

#define SEED 5
#define TICKS 300

static world_options options = {
    WORLD_BODIES, GJK_Q16(2.5), GJK_Q16(0.1), GJK_DETAIL_DISTANCE, 1, 0, true, true, false, false, 0, false};

// One tick of a script that depends on its number alone.
static void tick(world *w, int number) {
  static world_list list;
  gjk_progress progress;
  random_state random = random_seed(check_seed(SEED) + (uint64_t)number * 77);
  for (int k = 0; k < 15; k++) {
    CHECK(world_change(w, &random));
  }
  CHECK(gjk_scene_update(&w->scene, list.report, WORLD_REPORTS, &progress) == GJK_OK);
  CHECK(progress.reports_left == 0);
}

// Moves the scene to another block, by a copy or through a sealed save.
static void transplant(world *w, size_t bytes, bool seal) {
  const gjk_scene_bindings bindings = world_bindings(&w->options);
  void *old = w->scene.block, *block = malloc(bytes);
  gjk_scene scene;
  CHECK(!seal || gjk_scene_seal(&w->scene) == GJK_OK);
  memcpy(block, old, bytes);
  memset(old, 0xA5, bytes);
  CHECK((seal ? gjk_scene_open : gjk_scene_attach)(&scene, block, bytes, world_shapes, WORLD_SHAPES, &bindings) ==
        GJK_OK);
  w->scene = scene;
  free(old);
}

// The same hashes, tick for tick, from a scene that is saved, moved and rolled back at random, and from one that skips
// nothing and has other capacities.
static void check_rollback(void) {
  static uint64_t hashes[TICKS + 1];
  static world w, other, saved;
  gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *save = malloc(bytes);
  random_state random = random_seed(check_seed(SEED) + 4);
  unsigned rollbacks = 0, transplants = 0;
  CHECK(world_start(&w, &options, malloc(bytes), bytes));
  for (int i = 0; i < TICKS; i++) {
    tick(&w, i);
    hashes[i] = scene_hash(&w.scene);
  }
  free(w.scene.block);

  CHECK(world_start(&other, &options, malloc(bytes), bytes));
  saved = other;
  memcpy(save, other.scene.block, bytes);
  int saved_at = 0;
  for (int i = 0; i < TICKS; i++) {
    const uint32_t what = random_below(&random, 12);
    if (what < 2) {
      transplant(&other, bytes, what == 0);
      transplants++;
    } else if (what < 4) {
      saved = other;
      saved_at = i;
      memcpy(save, other.scene.block, bytes);
    } else if (what == 4 && i - saved_at < 20 && rollbacks < 40) {
      const gjk_scene here = other.scene;  // the block may have moved since
      other = saved;
      other.scene = here;
      memcpy(here.block, save, bytes);
      i = saved_at;
      rollbacks++;
    }
    tick(&other, i);
    CHECK_MSG(scene_hash(&other.scene) == hashes[i], "tick %d", i);
  }
  free(other.scene.block);
  free(save);
  CHECK(rollbacks > 10);
  CHECK(transplants > 20);

  world_options plain = options;
  plain.retest_all = 1;
  plain.box_margin = GJK_Q16(0.4);
  config = world_config(&plain);
  config.pairs *= 2;
  config.parts += 5;
  const size_t more = gjk_scene_bytes(&config);
  CHECK(world_start(&other, &plain, malloc(more), more));
  const gjk_scene_bindings bindings = world_bindings(&plain);
  CHECK(gjk_scene_init(&other.scene, &config, other.scene.block, more, world_shapes, WORLD_SHAPES, &bindings) ==
        GJK_OK);
  for (int i = 0; i < TICKS; i++) {
    tick(&other, i);
    CHECK_MSG(scene_hash(&other.scene) == hashes[i], "without skips, tick %d", i);
  }
  free(other.scene.block);
}

// Bodies added to stated slots in any order: the same hashes and reports afterwards.
static void check_order(void) {
  static world first, second;
  static world_body bodies[WORLD_BODIES];
  static world_list a, b;
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  uint32_t slots[WORLD_BODIES];
  random_state random = random_seed(check_seed(SEED) + 5);
  for (int round = 0; round < 10; round++) {
    CHECK(world_start(&second, &options, malloc(bytes), bytes));
    CHECK(world_start(&first, &options, malloc(bytes), bytes));
    for (uint32_t i = 0; i < WORLD_BODIES; i++) {
      slots[i] = i;
      world_random_setup(&first, &random, &bodies[i]);
      if (bodies[i].setup.part_count > 1) {
        bodies[i].setup.part_count = 1;
      }
      CHECK(world_add_at(&first, i, &bodies[i]) == GJK_OK);
    }
    for (uint32_t i = WORLD_BODIES; i > 0; i--) {
      const uint32_t k = random_below(&random, i), slot = slots[k];
      slots[k] = slots[i - 1];
      CHECK(world_add_at(&second, slot, &bodies[slot]) == GJK_OK);
    }
    CHECK(scene_hash(&first.scene) == scene_hash(&second.scene));
    for (int i = 0; i < 20; i++) {
      gjk_progress progress;
      random_state same = random_seed(check_seed(SEED) + (uint64_t)(round * 100 + i)), again = same;
      for (int k = 0; k < 10; k++) {
        CHECK(world_change(&first, &same));
        CHECK(world_change(&second, &again));
      }
      CHECK(gjk_scene_update(&first.scene, a.report, WORLD_REPORTS, &progress) == GJK_OK);
      a.count = progress.reports;
      CHECK(gjk_scene_update(&second.scene, b.report, WORLD_REPORTS, &progress) == GJK_OK);
      b.count = progress.reports;
      CHECK_MSG(world_same(&a, &b), "round %d, tick %d", round, i);
      CHECK_MSG(scene_hash(&first.scene) == scene_hash(&second.scene), "round %d, tick %d", round, i);
    }
    free(first.scene.block);
    free(second.scene.block);
  }
}

// The checksum is the same on all builds: each word but for the seal mixed in with all 64 bits, from the first to the last.
static void check_checksum(const void *block) {
  const gjk_scene_header *h = block;
  const uint32_t *word = block, seal = offsetof(gjk_scene_header, sealed) / 4;
  uint64_t sum = 0;
  for (uint32_t i = 0; i < h->bytes / 4; i++) {
    if (i < seal || i > seal + 2) {
      sum = (sum ^ word[i]) * UINT64_C(0x9E3779B97F4A7C15);
      sum ^= sum >> 32;
    }
  }
  CHECK(h->sealed == 1);
  CHECK(h->checksum[0] == (uint32_t)sum);
  CHECK(h->checksum[1] == (uint32_t)(sum >> 32));
}

// A block of another version, or of a build with other ceilings, is refused; GJK_ITERATIONS_MAX is in the hash.
static void check_builds(void) {
  static world w;
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  gjk_scene_header *h = block;
  gjk_scene opened;
  CHECK(world_start(&w, &options, block, bytes));
  CHECK(h->version == GJK_SCENE_BLOCK_VERSION);
  CHECK(h->iterations == GJK_ITERATIONS_MAX);
  const uint64_t before = scene_hash(&w.scene);
  h->version = 1;
  CHECK(gjk_scene_attach(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  h->version = GJK_SCENE_BLOCK_VERSION;
  CHECK(gjk_scene_attach(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_OK);
  h->iterations++;
  CHECK(scene_hash(&w.scene) != before);
  CHECK(gjk_scene_attach(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  CHECK(gjk_scene_seal(&w.scene) == GJK_OK);
  CHECK(gjk_scene_open(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  h->iterations--;
  const uint32_t casts = h->casts, others[] = {casts - 1, casts + 1, casts + 65536, casts - 65536, 0};
  for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
    h->casts = others[i];
    CHECK(gjk_scene_attach(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
    CHECK(gjk_scene_seal(&w.scene) == GJK_OK);
    CHECK(gjk_scene_open(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  }
  h->casts = casts;
  CHECK(gjk_scene_seal(&w.scene) == GJK_OK);
  CHECK(gjk_scene_open(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_OK);
  free(block);
}

// Any byte of a sealed block that differs is noticed, and so is what is no scene at all.
static void check_refused(void) {
  static world w;
  world_options small = options;
  small.bodies = 6;
  gjk_scene_config config = world_config(&small);
  config.pairs = 12;
  config.parts = 8;
  const size_t bytes = gjk_scene_bytes(&config);
  unsigned char *block = malloc(bytes), *copy = malloc(bytes);
  gjk_scene opened;
  CHECK(!world_start(&w, &small, block, 0));  // no room, but the world is set up
  CHECK(gjk_scene_init(&w.scene, &config, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_OK);
  random_state random = random_seed(check_seed(SEED) + 7);
  for (int i = 0; i < 40; i++) {
    gjk_report report[20];
    gjk_progress progress;
    (void)world_change(&w, &random);
    CHECK(gjk_scene_update(&w.scene, report, 20, &progress) == GJK_OK);
  }
  memcpy(copy, block, bytes);
  CHECK(gjk_scene_open(&opened, copy, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);  // not sealed
  CHECK(gjk_scene_seal(&w.scene) == GJK_OK);
  check_checksum(block);
  memcpy(copy, block, bytes);
  CHECK(gjk_scene_open(&opened, copy, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_OK);
  CHECK(gjk_scene_open(&opened, copy, bytes - 1, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_open(&opened, copy, 3, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_open(&opened, copy, bytes, world_shapes, 1, NULL) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_open(&opened, NULL, bytes, world_shapes, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_open(NULL, copy, bytes, world_shapes, 1, NULL) == GJK_ERROR_NULL);
  unsigned accepted = 0;
  for (size_t i = 0; i < bytes; i++) {
    for (unsigned bit = 1; bit < 256; bit <<= 1) {
      copy[i] = (unsigned char)(copy[i] ^ bit);
      accepted += gjk_scene_open(&opened, copy, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_OK;
      copy[i] = (unsigned char)(copy[i] ^ bit);
    }
  }
  CHECK_MSG(accepted == 0, "%u changed blocks were opened", accepted);
  // With the byte order of the other kind of machine.
  for (size_t i = 0; i < bytes; i += 4) {
    const unsigned char word[4] = {copy[i + 3], copy[i + 2], copy[i + 1], copy[i]};
    memcpy(copy + i, word, 4);
  }
  CHECK(gjk_scene_open(&opened, copy, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  // A whole header tells that it is none.
  CHECK(gjk_scene_open(&opened, copy, GJK_SCENE_HEADER_BYTES, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  CHECK(gjk_scene_open(&opened, copy, GJK_SCENE_HEADER_BYTES - 1, world_shapes, WORLD_SHAPES, NULL) ==
        GJK_ERROR_CAPACITY);
  // A change breaks the seal.
  CHECK(gjk_scene_wake(&w.scene, w.bodies[0].id) == GJK_OK);
  CHECK(gjk_scene_open(&opened, block, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_ERROR_CORRUPT);
  free(block);
  free(copy);
}

// Blocks that were changed and sealed again: whatever is wrong with an index, opening ends and never reads outside.
static void check_forged(void) {
  static world w;
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  unsigned char *block = malloc(bytes), *copy = malloc(bytes);
  random_state random = random_seed(check_seed(SEED) + 8);
  CHECK(world_start(&w, &options, block, bytes));
  for (int i = 0; i < 30; i++) {
    tick(&w, i);
  }
  unsigned refused = 0;
  for (int i = 0; i < 3000; i++) {
    gjk_scene forged, opened;
    memcpy(copy, block, bytes);
    // The header and the records in use, which come first in their pools.
    const size_t at =
        random_below(&random, 2) == 0 ? random_below(&random, 272) : random_below(&random, (uint32_t)bytes / 4);
    copy[at] = (unsigned char)random_u32(&random);
    if (gjk_scene_attach(&forged, copy, bytes, world_shapes, WORLD_SHAPES, NULL) != GJK_OK) {
      refused++;
      continue;
    }
    CHECK(gjk_scene_seal(&forged) == GJK_OK);
    refused += gjk_scene_open(&opened, copy, bytes, world_shapes, WORLD_SHAPES, NULL) != GJK_OK;
  }
  printf("%u of 3000 forged blocks refused\n", refused);
  CHECK(refused > 1000);
  free(block);
  free(copy);
}

// The hash counts the filter and the user word of a body, and nothing of the way to them.
static void check_counted(void) {
  static world w;
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  CHECK(world_start(&w, &options, malloc(bytes), bytes));
  tick(&w, 0);
  gjk_scene *scene = &w.scene;
  unsigned bodies = 0;
  for (uint32_t slot = 0; slot < config.bodies; slot++) {
    gjk_body_id id;
    gjk_body_state state;
    CHECK(gjk_scene_body_at(scene, slot, &id) == GJK_OK);
    if (id.generation % 2 == 0) {
      continue;
    }
    const uint64_t before = scene_hash(scene);
    CHECK(gjk_scene_get(scene, id, &state) == GJK_OK);
    CHECK(gjk_scene_set_user(scene, id, state.user ^ 1) == GJK_OK && scene_hash(scene) != before);
    CHECK(gjk_scene_set_user(scene, id, state.user) == GJK_OK && scene_hash(scene) == before);
    CHECK(gjk_scene_set_filter(scene, id, state.category ^ 8, state.mask) == GJK_OK && scene_hash(scene) != before);
    CHECK(gjk_scene_set_filter(scene, id, state.category, state.mask ^ 8) == GJK_OK && scene_hash(scene) != before);
    CHECK(gjk_scene_set_filter(scene, id, state.category, state.mask) == GJK_OK && scene_hash(scene) == before);
    bodies++;
  }
  CHECK(bodies > 5);
  free(scene->block);
}

int main(void) {
  options.detail = GJK_DETAIL_DEPTH;
  check_rollback();
  options.detail = GJK_DETAIL_DISTANCE;
  check_rollback();
  check_order();
  check_builds();
  check_refused();
  check_forged();
  check_counted();
  return check_done("scene_save");
}
