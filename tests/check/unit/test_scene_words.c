// The caller's words of a pair: 0 at its begin, kept until its end is reported, saved, hashed, and free where they are not
// asked for. Random scenes with words in slices, with skips and with restores: test_scene_random.c, test_history.c and
// test_plane_scene_random.c.
#ifndef TEST_NAME
#include "gjk/gjk.h"
#define TEST_NAME "scene_words"
#define SPACE 1
#endif

#include <string.h>

#include "check.h"
#include "scene_bodies.h"

#define BODIES 4
#define PAIRS 8
#define WORDS 3

#if SPACE
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
#else
static const gjk_shape ball = GJK2_CIRCLE(GJK_Q16(0.5));
#endif

static const gjk_shape *const kinds[] = {&ball};
static uint32_t block[2048], copy[2048];
static gjk_report reports[PAIRS];
static gjk_scene scene;
static uint32_t count;

static gjk_scene_config config_of(uint8_t words) {
  gjk_scene_config config = {.bodies = BODIES, .parts = BODIES, .pairs = PAIRS, .motions = BODIES};
  config.pair_words = words;
  return config;
}

static gjk_body_id put(gjk_q16 x) {
  const gjk_pose pose = scene_pose(x, 0);
  return scene_add_shape(&scene, 0, GJK_BODY_DYNAMIC, &pose);
}

static void update(void) {
  count = scene_update(&scene, reports, PAIRS);
}

static bool are(const uint32_t *words, uint32_t first) {
  return words[0] == first && words[1] == (first == 0 ? 0 : first + 1) && words[2] == (first == 0 ? 0 : first + 2);
}

static void write(uint32_t *words, uint32_t first) {
  for (uint32_t i = 0; i < WORDS; i++) {
    words[i] = first + i;
  }
}

// Two bodies at 0 and half a unit, near; returns the words of their pair.
static uint32_t *start(gjk_body_id *a, gjk_body_id *b) {
  const gjk_scene_config config = config_of(WORDS);
  const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, &bindings) == GJK_OK);
  *a = put(0);
  *b = put(GJK_Q16(0.5));
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_BEGIN && are(reports[0].words, 0));
  return reports[0].words;
}

// What the words are from begin to end, and again.
static void check_life(void) {
  gjk_body_id a, b;
  uint32_t *words = start(&a, &b), cursor = 0;
  gjk_report near;
  bool found;
  write(words, 70);
  for (int i = 0; i < 5; i++) {  // still, then a motion that is skipped, then one that is not
    scene_move_to(&scene, b, i == 0 ? GJK_Q16(0.5) : GJK_Q16(0.5) + i * i * i * 100, 0);
    update();
    cursor = 0;
    CHECK(count == 0 && gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK && found);
    CHECK(near.words == words && are(words, 70));
  }
  scene_move_to(&scene, b, GJK_Q16(1.05), 0);  // apart; where boxes leave room, the record stays
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_END && reports[0].words == words && are(words, 70));
  cursor = 0;
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK && !found);
  scene_move_to(&scene, b, GJK_Q16(0.9), 0);
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_BEGIN && are(reports[0].words, 0));
  write(reports[0].words, 90);
  CHECK(gjk_scene_remove(&scene, a) == GJK_OK);
  cursor = 0;
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK && found);
  CHECK(near.event == GJK_EVENT_END && are(near.words, 90));
  // Another body in the slot of the one that is gone: the old pair ends with its words, the new one has none yet.
  (void)put(0);
  update();
  CHECK(count == 2 && reports[0].event == GJK_EVENT_END && reports[1].event == GJK_EVENT_BEGIN);
  CHECK(are(reports[0].words, 90) && are(reports[1].words, 0) && reports[0].words != reports[1].words);
}

// A pair that the filters end keeps its record; its words end all the same.
static void check_filter(void) {
  gjk_body_id a, b;
  write(start(&a, &b), 5);
  CHECK(gjk_scene_set_filter(&scene, b, 2, 2) == GJK_OK);
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_END && are(reports[0].words, 5));
  CHECK(gjk_scene_set_filter(&scene, b, 1, 1) == GJK_OK);
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_BEGIN && are(reports[0].words, 0));
}

// Words are written between the slices of an update, and while its reports are left.
static void check_slices(void) {
  gjk_body_id a, b;
  gjk_progress progress;
  uint32_t *words = start(&a, &b);
  const gjk_body_id c = put(GJK_Q16(-0.75));
  scene_move_to(&scene, b, GJK_Q16(0.6), 0);
  CHECK(gjk_scene_update_slice(&scene, 0, reports, PAIRS, &progress) == GJK_OK && progress.pairs_left > 0);
  write(words, 31);
  CHECK(gjk_scene_update_slice(&scene, UINT32_MAX, NULL, 0, &progress) == GJK_OK && progress.reports_left == 1);
  CHECK(are(words, 31));
  write(words, 32);
  update();
  CHECK(count == 1 && reports[0].b.slot == c.slot && reports[0].event == GJK_EVENT_BEGIN && are(reports[0].words, 0));
  CHECK(are(words, 32));
}

// A copy has the words, and goes on with them; what is written later is not in it. A write breaks the seal.
static void check_saves(void) {
  gjk_body_id a, b;
  uint32_t *words = start(&a, &b);
  gjk_scene other;
  gjk_report near;
  uint32_t cursor = 0;
  bool found;
  const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  write(words, 12);
  CHECK(gjk_scene_seal(&scene) == GJK_OK);
  memcpy(copy, block, sizeof block);
  const uint64_t before = scene_hash(&scene);
  write(words, 13);
  CHECK(scene_hash(&scene) != before);
  CHECK(gjk_scene_open(&other, block, sizeof block, kinds, 1, &bindings) == GJK_ERROR_CORRUPT);
  CHECK(gjk_scene_seal(&scene) == GJK_OK);
  CHECK(gjk_scene_open(&other, block, sizeof block, kinds, 1, &bindings) == GJK_OK);
  CHECK(gjk_scene_open(&scene, copy, sizeof copy, kinds, 1, &bindings) == GJK_OK);
  CHECK(scene_hash(&scene) == before);
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK && found);
  CHECK(are(near.words, 12) && are(words, 13) && near.words - copy == words - block);
}

// Words of pairs that are not near do not count in the hash; each word of one that is does, in its place.
static void check_hash(void) {
  gjk_body_id a, b;
  uint32_t *words = start(&a, &b);
  uint64_t seen[WORDS + 1];
  for (int i = 0; i <= WORDS; i++) {
    memset(words, 0, WORDS * sizeof *words);
    if (i > 0) {
      words[i - 1] = 1;
    }
    seen[i] = scene_hash(&scene);
    for (int k = 0; k < i; k++) {
      CHECK(seen[k] != seen[i]);
    }
  }
  scene_move_to(&scene, b, GJK_Q16(1.01), 0);
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_END);
  const uint64_t apart = scene_hash(&scene);
  write(words, 1000);
  CHECK(scene_hash(&scene) == apart);
}

static void check_sizes(void) {
  gjk_scene_config config = config_of(0);
  const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  const size_t without = gjk_scene_bytes(&config);
  gjk_scene other;
  for (unsigned words = 0; words <= UINT8_MAX; words++) {
    config.pair_words = (uint8_t)words;
    CHECK(gjk_scene_bytes(&config) == (words <= GJK_SCENE_PAIR_WORDS_MAX ? without + 4 * words * PAIRS : 0));
  }
  CHECK(gjk_scene_init(&other, &config, block, sizeof block, kinds, 1, NULL) == GJK_ERROR_RANGE);
  config.pair_words = WORDS;
  CHECK(gjk_scene_init(&other, &config, block, without, kinds, 1, NULL) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_init(&other, &config, block, without + 4 * WORDS * PAIRS - 1, kinds, 1, NULL) == GJK_ERROR_CAPACITY);
  // The largest block there is.
  config.bodies = config.parts = config.own_poses = config.motions = GJK_SCENE_BODIES_MAX;
  config.pairs = GJK_SCENE_PAIRS_MAX;
  config.pair_words = 0;
  const size_t most = gjk_scene_bytes(&config);
  config.pair_words = GJK_SCENE_PAIR_WORDS_MAX;
  CHECK(gjk_scene_bytes(&config) == most + (size_t)4 * GJK_SCENE_PAIR_WORDS_MAX * GJK_SCENE_PAIRS_MAX);
  CHECK(gjk_scene_bytes(&config) < (size_t)1 << 31);
  // None are configured: none are reported.
  config = config_of(0);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, &bindings) == GJK_OK);
  (void)put(0);
  const gjk_body_id fast = put(0);
  CHECK(gjk_scene_set_motion(&scene, fast, GJK_MOTION_FAST) == GJK_OK);
  update();
  CHECK(count > 0 && reports[0].event == GJK_EVENT_BEGIN && reports[0].words == NULL);
}

// The report of an impact has no words: it is no pair.
static void check_impact(void) {
  gjk_body_id a, b;
  (void)start(&a, &b);
  const gjk_body_id fast = put(GJK_Q16(-20.0));
  CHECK(gjk_scene_set_motion(&scene, fast, GJK_MOTION_FAST) == GJK_OK);
  update();
  scene_move_to(&scene, fast, GJK_Q16(20.0), 0);
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_IMPACT && reports[0].words == NULL);
}

int main(void) {
  check_life();
  check_filter();
  check_slices();
  check_saves();
  check_hash();
  check_sizes();
  check_impact();
  return check_done(TEST_NAME);
}
