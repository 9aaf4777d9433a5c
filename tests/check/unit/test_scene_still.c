// What a report calls still: since the pair's last report no call moved or changed a body of it. Its manifold is then the one
// that was reported, and bindings.keeps_manifolds leaves it out. After each kind of change, in slices, after saves and copies.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"
#include "src/scene/gjk_scene_block.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "same.h"
#define TEST_NAME "scene_still"
#define MOST 4
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
#else
#define MOST 2
static const gjk2_shape crate = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.5));
#endif

#define SEED 9100
#define UPDATES 400
#define STORED 4096

// Two crates that touch, a third one alone.
static const gjk_shape *const crates[] = {&crate, &crate};
static uint32_t block[4096], copy[4096];
static gjk_scene scene;
static gjk_body_id body[3];

static gjk_pose at(gjk_q16 x) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = x;
  return pose;
}

static void begin(void) {
  static const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  gjk_scene_config config = {.bodies = 3, .parts = 3, .pairs = 4, .persist = 1};
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, crates, 2, NULL) == GJK_OK);
  for (int i = 0; i < 3; i++) {
    gjk_body_setup setup = {.pose = at(i < 2 ? i * GJK_Q16(0.5) : GJK_Q16(9)), .part_count = 1, .category = 1};
    setup.parts = &part;
    setup.kind = GJK_BODY_DYNAMIC;
    setup.mask = 1;
    CHECK(gjk_scene_add(&scene, &setup, &body[i]) == GJK_OK);
  }
}

// Updates: the crates' pair is reported once, still or not; or not at all.
static void expect(int line, uint32_t reported, bool still) {
  gjk_report r[2];
  gjk_progress p;
  CHECK(gjk_scene_update(&scene, r, 2, &p) == GJK_OK && p.reports_left == 0);
  CHECK_MSG(p.reports == reported, "line %d", line);
  CHECK_MSG(p.reports == 0 || r[0].still == still, "line %d", line);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
}

#define EXPECT(reported, still) expect(__LINE__, reported, still)

static bool move(int i, gjk_q16 x) {
  const gjk_pose pose = at(x);
  return gjk_scene_move(&scene, body[i], &pose) == GJK_OK;
}

static bool teleport(int i, gjk_q16 x) {
  const gjk_pose pose = at(x);
  return gjk_scene_teleport(&scene, body[i], &pose) == GJK_OK;
}

static void test_changes(void) {
  begin();
  EXPECT(1, false);  // it begins
  EXPECT(1, true);
  CHECK(move(0, 0));  // to where it is
  CHECK(teleport(1, GJK_Q16(0.5)));
  EXPECT(1, true);
  CHECK(move(0, 1));
  EXPECT(1, false);
  EXPECT(1, true);
  CHECK(move(1, 0) && move(1, GJK_Q16(0.5)));  // and back
  EXPECT(1, false);
  CHECK(teleport(0, 0));
  EXPECT(1, false);
  CHECK(move(2, GJK_Q16(7)));  // another one
  EXPECT(1, true);
  CHECK(gjk_scene_set_filter(&scene, body[0], 1, 1) == GJK_OK);
  EXPECT(1, false);
  CHECK(gjk_scene_refilter(&scene, body[1]) == GJK_OK);
  EXPECT(1, false);
  CHECK(gjk_scene_set_user(&scene, body[1], 0) == GJK_OK);  // as it was
  EXPECT(1, true);
  CHECK(gjk_scene_set_user(&scene, body[1], 7) == GJK_OK);
  EXPECT(1, false);
  CHECK(gjk_scene_set_shape(&scene, body[0], 0, 1) == GJK_OK);
  EXPECT(1, false);
  CHECK(gjk_scene_remove(&scene, body[2]) == GJK_OK);
  EXPECT(1, true);
  CHECK(gjk_scene_set_filter(&scene, body[0], 2, 2) == GJK_OK);
  EXPECT(1, false);  // its end
  CHECK(gjk_scene_set_filter(&scene, body[0], 1, 1) == GJK_OK);
  EXPECT(1, false);  // it begins again
  EXPECT(1, true);
}

// What is not reported while both sleep is told when one wakes.
static void test_sleep(void) {
  begin();
  EXPECT(1, false);
  CHECK(gjk_scene_sleep(&scene, body[0]) == GJK_OK && gjk_scene_sleep(&scene, body[1]) == GJK_OK);
  EXPECT(0, false);
  CHECK(gjk_scene_wake(&scene, body[0]) == GJK_OK);
  EXPECT(1, true);
  CHECK(move(0, 5) && gjk_scene_sleep(&scene, body[0]) == GJK_OK);
  EXPECT(0, false);
  EXPECT(0, false);
  CHECK(gjk_scene_wake(&scene, body[1]) == GJK_OK);
  EXPECT(1, false);
  EXPECT(1, true);
}

// A copy goes on as the scene did when it was made; a save in the middle of an update, too.
static void test_copies(void) {
  gjk_report r;
  gjk_progress p;
  begin();
  EXPECT(1, false);
  memcpy(copy, block, sizeof block);
  CHECK(move(0, 5));
  memcpy(block, copy, sizeof block);
  EXPECT(1, true);
  CHECK(move(0, 5));
  memcpy(copy, block, sizeof block);
  EXPECT(1, false);
  memcpy(block, copy, sizeof block);
  EXPECT(1, false);
  for (int moved = 0; moved < 2; moved++) {
    CHECK(moved == 0 || move(1, GJK_Q16(0.5) + 3));
    CHECK(gjk_scene_update(&scene, &r, 0, &p) == GJK_OK);
    CHECK(p.reports_left == 1);
    CHECK(gjk_scene_seal(&scene) == GJK_OK);
    memcpy(copy, block, sizeof block);
    CHECK(gjk_scene_open(&scene, copy, sizeof copy, crates, 2, NULL) == GJK_OK);
    CHECK(gjk_scene_update(&scene, &r, 1, &p) == GJK_OK);
    CHECK(p.reports == 1 && r.still == (moved == 0));
    CHECK(gjk_scene_attach(&scene, block, sizeof block, crates, 2, NULL) == GJK_OK);
    CHECK(gjk_scene_update(&scene, &r, 1, &p) == GJK_OK);
    CHECK(p.reports == 1 && r.still == (moved == 0));
  }
}

// The manifolds that a program keeps, by their pairs.
typedef struct kept_manifold {
  gjk_report pair;
  gjk_manifold manifold;
} kept_manifold;

static kept_manifold store[STORED], saved_store[STORED];
static unsigned stored, saved_stored, still_count, found_count;
static world now, saved;
static world_list expected, actual;

static kept_manifold *kept_of(const gjk_report *r) {
  for (unsigned i = 0; i < stored; i++) {
    const gjk_report *s = &store[i].pair;
    if (s->a.slot == r->a.slot && s->a.generation == r->a.generation && s->b.slot == r->b.slot &&
        s->b.generation == r->b.generation && s->part_a == r->part_a && s->part_b == r->part_b) {
      return &store[i];
    }
  }
  return NULL;
}

// Keeps the manifold of a report, or finds the one that was kept; it must be that of the current poses.
static void take(const gjk_report *r) {
  gjk_manifold fresh = {0};
  if (r->detail != GJK_DETAIL_CONTACTS || r->event > GJK_EVENT_PERSIST) {
    CHECK(r->manifold == NULL);
    return;
  }
  const gjk_status status = gjk_scene_manifold(&now.scene, r, MOST, &fresh);
  const bool written = status == GJK_OK || status == GJK_ERROR_CAPACITY;
  CHECK(written || status == GJK_ERROR_ITERATION_LIMIT);
  kept_manifold *kept = kept_of(r);
  CHECK((r->manifold == NULL) == r->still);
  if (!r->still && kept == NULL) {
    CHECK(stored < STORED);
    kept = &store[stored++];
    kept->pair = *r;
  }
  CHECK(kept != NULL);
  if (r->still) {
    CHECK(r->distance == 0);
    still_count++;
  } else {
    kept->manifold = *r->manifold;
    found_count++;
  }
  CHECK(!written || same_manifold(&kept->manifold, &fresh));
}

// An update in slices and small buffers.
static void update_slices(random_state *random) {
  gjk_progress p;
  world_expect(&now, &expected);
  for (uint32_t i = 0; i < expected.count; i++) {
    gjk_report *r = &expected.report[i];
    r->distance = r->still && r->detail == GJK_DETAIL_CONTACTS ? 0 : r->distance;
  }
  actual.count = 0;
  do {
    gjk_report *reports = &actual.report[actual.count];
    CHECK(gjk_scene_update_slice(&now.scene, random_below(random, 200), reports, random_below(random, 20), &p) ==
          GJK_OK);
    for (uint32_t i = 0; i < p.reports; i++) {
      take(&reports[i]);
    }
    actual.count += p.reports;
  } while (p.pairs_left > 0 || p.reports_left > 0);
  CHECK(world_same(&expected, &actual));
}

// Puts rubbish or zeros into the caches of the block: answers must not depend on them.
static void spoil_caches(random_state *random) {
  gjk_scene_view v;
  CHECK(gjk_scene_view_of(&now.scene, &v) == GJK_OK);
  CHECK((v.caches == NULL) == (v.header->config.retest_all != 0));
  const bool zero = random_below(random, 2) == 0;
  unsigned char *byte = (unsigned char *)v.caches;
  for (size_t i = 0; v.caches != NULL && i < v.header->config.pairs * sizeof *v.caches; i++) {
    byte[i] = (unsigned char)(zero ? 0 : random_u32(random));
  }
}

// Random scenes, rolled back at times, with what the program keeps.
static void test_kept(uint8_t retest_all) {
  const world_options options = {.bodies = WORLD_BODIES,
                                 .reach = GJK_Q16(2),
                                 .box_margin = GJK_Q16(0.1),
                                 .detail = GJK_DETAIL_CONTACTS,
                                 .persist = 1,
                                 .retest_all = retest_all,
                                 .margins = true,
                                 .words = 1,
                                 .sensors = true};
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *memory = malloc(bytes), *save = malloc(bytes);
  random_state random = random_seed(check_seed(SEED));
  CHECK(memory != NULL && save != NULL && world_start(&now, &options, memory, bytes));
  now.scene.bindings.keeps_manifolds = true;
  stored = saved_stored = still_count = found_count = 0;
  saved = now;
  memcpy(save, memory, bytes);
  for (unsigned i = 0; i < check_trials(UPDATES); i++) {
    check_trial(i, NULL, NULL);
    for (uint32_t k = random_below(&random, 16); k > 0; k--) {
      CHECK(world_change(&now, &random));
    }
    update_slices(&random);
    const uint32_t what = random_below(&random, 12);
    if (what == 2) {
      spoil_caches(&random);
    }
    if (what == 0) {
      saved = now;
      memcpy(save, memory, bytes);
      memcpy(saved_store, store, sizeof store);
      saved_stored = stored;
    } else if (what == 1) {
      now = saved;
      memcpy(memory, save, bytes);
      memcpy(store, saved_store, sizeof store);
      stored = saved_stored;
    }
  }
  printf("%u manifolds still, %u found\n", still_count, found_count);
  CHECK(!check_is_full() || (still_count > UPDATES && found_count > UPDATES));
  free(memory);
  free(save);
}

#define LATTICE 30

// Crates on a lattice, where several features are equally near: manifolds from caches are those of a cold start.
static void test_ties(void) {
  static uint32_t memory[16384];
  static gjk_report reports[1024];
  static gjk_manifold manifolds[1024];
  static const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_scene_config config = {
      .bodies = LATTICE, .parts = LATTICE, .pairs = LATTICE * LATTICE / 2, .detail = GJK_DETAIL_CONTACTS, .persist = 1};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts, .manifolds = manifolds};
  random_state random = random_seed(check_seed(SEED) + 1);
  gjk_body_id id[LATTICE];
  gjk_pose pose = GJK_POSE_IDENTITY;
  unsigned compared = 0;
  CHECK(gjk_scene_init(&scene, &config, memory, sizeof memory, crates, 2, &bindings) == GJK_OK);
  for (int i = 0; i < LATTICE; i++) {
    gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY,
                            .parts = &part,
                            .part_count = 1,
                            .category = 1,
                            .mask = 1,
                            .kind = GJK_BODY_DYNAMIC,
                            .margin = GJK_Q16(0.25)};
    CHECK(gjk_scene_add(&scene, &setup, &id[i]) == GJK_OK);
  }
  for (unsigned i = 0; i < check_trials(UPDATES); i++) {
    gjk_progress p;
    check_trial(i, NULL, NULL);
    for (int k = 0; k < 8; k++) {
      pose.position.x = random_range(&random, -8, 8) * GJK_Q16(0.25);
      pose.position.y = random_range(&random, -8, 8) * GJK_Q16(0.25);
      CHECK(gjk_scene_move(&scene, id[random_below(&random, LATTICE)], &pose) == GJK_OK);
    }
    CHECK(gjk_scene_update(&scene, reports, 1024, &p) == GJK_OK && p.reports_left == 0);
    for (uint32_t k = 0; k < p.reports; k++) {
      gjk_manifold cold = {0};
      if (reports[k].event <= GJK_EVENT_PERSIST) {
        CHECK(gjk_scene_manifold(&scene, &reports[k], MOST, &cold) == GJK_OK);
        CHECK(same_manifold(reports[k].manifold, &cold));
        compared += reports[k].event == GJK_EVENT_PERSIST && !reports[k].still;
      }
    }
  }
  printf("%u manifolds of crates on a lattice, from caches\n", compared);
  CHECK(compared > check_trials(UPDATES) * 10);
}

int main(void) {
  test_ties();
  test_changes();
  test_sleep();
  test_copies();
  test_kept(0);
  test_kept(1);
  return check_done(TEST_NAME);
}
