// What the block keeps for the next query of a pair decides no answer: the same reports, manifolds and hashes from a scene
// whose caches and hints are filled with random bytes or zeros between ticks, and between slices of an update.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"
#include "src/scene/gjk_scene_block.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "same.h"
#define TEST_NAME "scene_caches"
static void spoil_hint(random_state *random, gjk_scene_pair *pair) {
  for (int i = 0; i < 3; i++) {
    pair->hint.direction[i] = (int16_t)random_range(random, -32768, 32767);
  }
  for (int i = 0; i < 4; i++) {
    pair->a[i] = (uint8_t)random_below(random, 256);
    pair->b[i] = (uint8_t)random_below(random, 256);
  }
}
#else
static void spoil_hint(random_state *random, gjk_scene_pair *pair) {
  pair->hint[0] = (uint16_t)random_below(random, 65536);
  pair->hint[1] = (uint16_t)random_below(random, 65536);
}
#endif

#define SEED 9300
#define UPDATES 300

// Twins that are changed alike. reports and manifolds of the last update.
typedef struct twin {
  world world;
  void *block;
  gjk_report reports[WORLD_REPORTS];
  gjk_manifold manifolds[WORLD_REPORTS];
  uint32_t count;
} twin;

static twin plain, spoiled;
static world saved[2];
static struct { unsigned long reports, manifolds, still, filled, warm, rollbacks; } tally;

// Fills what a query starts from: the caches of contacts, and the hints of pairs that are linked.
static void spoil(random_state *random) {
  gjk_scene_view v;
  CHECK(gjk_scene_view_of(&spoiled.world.scene, &v) == GJK_OK);
  const bool zero = random_below(random, 4) == 0;
  unsigned char *byte = (unsigned char *)v.caches;
  for (size_t i = 0; v.caches != NULL && i < v.header->config.pairs * sizeof *v.caches; i++) {
    byte[i] = (unsigned char)(zero ? 0 : random_u32(random));
  }
  for (uint32_t i = 0; i < v.header->pairs.fresh; i++) {
    gjk_scene_pair *pair = &v.pairs[i];
    if ((pair->state & (GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_GONE)) == GJK_SCENE_PAIR_LIVE) {
      const unsigned flags = pair->state & ((1u << GJK_SCENE_PAIR_CACHED) - 1);
      const unsigned count = zero ? 0 : random_below(random, 5);
      gjk_scene_clear_hint(pair);
      pair->state = (uint8_t)(flags | count << GJK_SCENE_PAIR_CACHED);
      if (!zero) {
        spoil_hint(random, pair);
      }
      tally.filled++;
    }
  }
  CHECK(gjk_scene_check(&spoiled.world.scene) == GJK_OK);
}

static bool same_report(const gjk_report *x, const gjk_report *y) {
  return x->a.slot == y->a.slot && x->a.generation == y->a.generation && x->b.slot == y->b.slot &&
         x->b.generation == y->b.generation && x->part_a == y->part_a && x->part_b == y->part_b &&
         x->event == y->event && x->detail == y->detail && x->still == y->still && x->distance == y->distance &&
         x->fraction == y->fraction && (x->manifold == NULL) == (y->manifold == NULL) &&
         (x->manifold == NULL || same_manifold(x->manifold, y->manifold));
}

static bool begin(twin *t, const world_options *options, size_t bytes) {
  t->block = malloc(bytes);
  const bool fine = t->block != NULL && world_start(&t->world, options, t->block, bytes);
  t->world.scene.bindings.manifolds = t->manifolds;
  return fine;
}

// An update at once, or in slices between which everything is spoiled.
static void update(twin *t, random_state *slices) {
  gjk_progress p;
  t->count = 0;
  do {
    const uint32_t tests = slices != NULL ? random_below(slices, 60) : UINT32_MAX;
    const uint32_t room = slices != NULL ? random_below(slices, 20) : WORLD_REPORTS;
    t->world.scene.bindings.manifolds = &t->manifolds[t->count];
    CHECK(gjk_scene_update_slice(&t->world.scene, tests, &t->reports[t->count], room, &p) == GJK_OK);
    t->count += p.reports;
    if (slices != NULL && random_below(slices, 3) == 0) {
      spoil(slices);
    }
  } while (p.pairs_left > 0 || p.reports_left > 0);
}

static void compare(void) {
  uint64_t a = 0, b = 1;
  gjk_scene_stats stats;
  CHECK(plain.count == spoiled.count);
  for (uint32_t i = 0; i < plain.count && i < spoiled.count; i++) {
    CHECK_MSG(same_report(&plain.reports[i], &spoiled.reports[i]), "report %u", i);
    tally.manifolds += plain.reports[i].manifold != NULL;
    tally.still += plain.reports[i].still;
  }
  tally.reports += plain.count;
  CHECK(gjk_scene_hash(&plain.world.scene, &a) == GJK_OK);
  CHECK(gjk_scene_hash(&spoiled.world.scene, &b) == GJK_OK);
  CHECK(a == b);
  CHECK(gjk_scene_get_stats(&plain.world.scene, &stats) == GJK_OK);
  tally.warm += stats.warm;
}

// Both go back to the same copy. The spoiled one forgets what it kept for queries.
static void roll_back(const void *copy, size_t bytes, random_state *random) {
  plain.world = saved[0];
  spoiled.world = saved[1];
  memcpy(plain.block, copy, bytes);
  memcpy(spoiled.block, copy, bytes);
  spoil(random);
  tally.rollbacks++;
}

static void play(uint8_t detail, bool kept) {
  const world_options options = {.bodies = WORLD_BODIES,
                                 .reach = GJK_Q16(2),
                                 .box_margin = GJK_Q16(0.1),
                                 .detail = detail,
                                 .persist = 1,
                                 .margins = true,
                                 .words = 1,
                                 .sensors = true};
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *copy = malloc(bytes);
  const uint64_t seed = check_seed(SEED) + detail;
  random_state spoils = random_seed(seed + 1000000);
  CHECK(copy != NULL && begin(&plain, &options, bytes) && begin(&spoiled, &options, bytes));
  plain.world.scene.bindings.keeps_manifolds = spoiled.world.scene.bindings.keeps_manifolds = kept;
  memcpy(copy, plain.block, bytes);
  saved[0] = plain.world;
  saved[1] = spoiled.world;
  for (unsigned i = 0; i < check_trials(UPDATES); i++) {
    check_trial(i, NULL, NULL);
    random_state changes = random_seed(seed + 77 * i), same = changes;
    for (uint32_t k = random_below(&spoils, 16); k > 0; k--) {
      CHECK(world_change(&plain.world, &changes) && world_change(&spoiled.world, &same));
    }
    update(&plain, NULL);
    update(&spoiled, &spoils);
    compare();
    const uint32_t what = random_below(&spoils, 10);
    if (what == 0) {
      memcpy(copy, plain.block, bytes);
      saved[0] = plain.world;
      saved[1] = spoiled.world;
    } else if (what == 1) {
      roll_back(copy, bytes, &spoils);
    } else if (what < 6) {
      spoil(&spoils);
    }
  }
  free(copy);
  free(plain.block);
  free(spoiled.block);
}

int main(void) {
  play(GJK_DETAIL_CONTACTS, false);
  play(GJK_DETAIL_CONTACTS, true);
  play(GJK_DETAIL_DEPTH, false);
  play(GJK_DETAIL_DISTANCE, false);
  play(GJK_DETAIL_TOUCH, false);
  printf("%lu reports, %lu manifolds, %lu still, %lu pairs filled, %lu queries warm, %lu rollbacks\n", tally.reports,
         tally.manifolds, tally.still, tally.filled, tally.warm, tally.rollbacks);
  if (check_is_full()) {
    CHECK(tally.reports > 100 * UPDATES && tally.manifolds > 10 * UPDATES);
    CHECK(tally.still > UPDATES && tally.filled > 100 * UPDATES);
    CHECK(tally.warm > UPDATES && tally.rollbacks > UPDATES / 10);
  }
  return check_done(TEST_NAME);
}
