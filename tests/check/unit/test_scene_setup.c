// What a program forgets to set is told: a body that nothing could meet, details without their code. And the bytes of a
// block as a constant.
#ifndef TEST_NAME
#include "gjk/gjk.h"
#define TEST_NAME "scene_setup"
#define SPACE 1
#endif

#include <string.h>

#include "check.h"
#include "random.h"

#if SPACE
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
#define BYTES(bodies, parts, pairs) GJK_SCENE_BYTES(bodies, parts, pairs)
#define MORE_BYTES(own_poses, motions, words) GJK_SCENE_MORE_BYTES(own_poses, motions, words)
#define CACHE_BYTES(pairs) (24 * (pairs))
#else
static const gjk_shape ball = GJK2_CIRCLE(GJK_Q16(0.5));
#define BYTES(bodies, parts, pairs) GJK2_SCENE_BYTES(bodies, parts, pairs)
#define MORE_BYTES(own_poses, motions, words) GJK2_SCENE_MORE_BYTES(own_poses, motions, words)
#define CACHE_BYTES(pairs) ((14 * (pairs) + 3) / 4 * 4)
#endif

static const gjk_shape *const kinds[] = {&ball};
static const gjk_part part = {0, false, GJK_POSE_IDENTITY};
static uint32_t block[BYTES(3, 3, 5) / 4];
static gjk_scene scene;

static gjk_scene_config config_of(uint8_t detail) {
  gjk_scene_config config = {.bodies = 3, .parts = 3, .pairs = 5};
  config.detail = detail;
  return config;
}

// A setup as it is when nothing but what is needed is set.
static gjk_body_setup setup_of(gjk_q16 x) {
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .parts = &part, .part_count = 1};
  setup.pose.position.x = x;
  return setup;
}

static uint32_t random_number(random_state *random, uint32_t most) {
  return random_below(random, (UINT32_C(1) << random_below(random, 20)) + 1) % (most + 1);
}

// The constant is what the function says, of random configurations and of the largest.
static void check_bytes(void) {
  random_state random = random_seed(check_seed(1));
  for (int i = 0; i < 20000; i++) {
    gjk_scene_config c = {.bodies = 1 + random_number(&random, GJK_SCENE_BODIES_MAX - 1),
                          .parts = 1 + random_number(&random, GJK_SCENE_BODIES_MAX - 1),
                          .own_poses = random_number(&random, GJK_SCENE_BODIES_MAX),
                          .pairs = 1 + random_number(&random, GJK_SCENE_PAIRS_MAX - 1),
                          .motions = random_number(&random, GJK_SCENE_BODIES_MAX)};
    c.pair_words = (uint8_t)random_number(&random, GJK_SCENE_PAIR_WORDS_MAX);
    if (i == 0) {
      c.bodies = c.parts = c.own_poses = c.motions = GJK_SCENE_BODIES_MAX;
      c.pairs = GJK_SCENE_PAIRS_MAX;
      c.pair_words = GJK_SCENE_PAIR_WORDS_MAX;
    }
    const uint32_t bytes =
        BYTES(c.bodies, c.parts, c.pairs) + MORE_BYTES(c.own_poses, c.motions, c.pairs * c.pair_words);
    c.detail = GJK_DETAIL_CONTACTS;
    CHECK(gjk_scene_bytes(&c) == bytes);
    c.detail = (uint8_t)random_below(&random, GJK_DETAIL_CONTACTS);
    CHECK(gjk_scene_bytes(&c) == bytes - CACHE_BYTES(c.pairs));
  }
}

static void check_details(void) {
  for (uint8_t detail = GJK_DETAIL_TOUCH; detail <= GJK_DETAIL_CONTACTS; detail++) {
    for (int with = 0; with < 4; with++) {  // no bindings, none of details, depths, contacts
      const gjk_scene_config config = config_of(detail), touches = config_of(GJK_DETAIL_TOUCH);
      const gjk_scene_bindings bindings = {.details = with == 3   ? &gjk_scene_contacts
                                                      : with == 2 ? &gjk_scene_depth
                                                                  : NULL};
      const gjk_scene_bindings *given = with == 0 ? NULL : &bindings;
      const bool able = with == 3 || detail < GJK_DETAIL_DEPTH || (with == 2 && detail == GJK_DETAIL_DEPTH);
      gjk_body_setup setup = setup_of(0);
      gjk_body_id id = {7, 7};
      gjk_progress progress;
      memset(&scene, 0, sizeof scene);
      CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, given) ==
            (able ? GJK_OK : GJK_ERROR_UNSUPPORTED));
      CHECK(able || scene.block == NULL);
      // The same of one body.
      setup.category = setup.mask = 1;
      setup.detail = detail;
      CHECK(gjk_scene_init(&scene, &touches, block, sizeof block, kinds, 1, given) == GJK_OK);
      CHECK(gjk_scene_add(&scene, &setup, &id) == (able ? GJK_OK : GJK_ERROR_UNSUPPORTED));
      CHECK(able || id.slot == 7);
      CHECK(gjk_scene_update(&scene, NULL, 0, &progress) == GJK_OK);
      setup.detail = GJK_DETAIL_SENSOR;
      CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_OK);
    }
  }
}

// Pairs near after an update of two bodies at the same place.
static uint32_t near_pairs(gjk_body_setup *setup, uint8_t kind) {
  const gjk_scene_config config = config_of(GJK_DETAIL_TOUCH);
  gjk_body_id a, b;
  gjk_report reports[5];
  gjk_progress progress = {0, 0, 0};
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, NULL) == GJK_OK);
  setup->kind = GJK_BODY_STATIC;
  CHECK(gjk_scene_add(&scene, setup, &a) == GJK_OK);
  setup->kind = kind;
  CHECK(gjk_scene_add(&scene, setup, &b) == GJK_OK);
  CHECK(gjk_scene_move(&scene, b, &setup->pose) == GJK_OK);
  CHECK(gjk_scene_update(&scene, reports, 5, &progress) == GJK_OK);
  return progress.reports;
}

static void check_meetings(void) {
  const gjk_scene_config config = config_of(GJK_DETAIL_TOUCH);
  gjk_body_setup setup = setup_of(0);
  gjk_body_id id = {7, 7};
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, NULL) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_add_at(&scene, 2, &setup, &id) == GJK_ERROR_RANGE);
  CHECK(id.slot == 7 && id.generation == 7);
  // One alone may be 0: queries without a filter see such a body.
  setup.category = 1;
  CHECK(near_pairs(&setup, GJK_BODY_DYNAMIC) == 0);
  setup.category = 0;
  setup.mask = 1;
  CHECK(near_pairs(&setup, GJK_BODY_DYNAMIC) == 0);
  setup.category = 1;
  CHECK(near_pairs(&setup, GJK_BODY_DYNAMIC) == 1);
  CHECK(near_pairs(&setup, GJK_BODY_KINEMATIC) == 1);
  CHECK(near_pairs(&setup, GJK_BODY_STATIC) == 0);
  // A body is taken out of all pairs later on.
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 1, NULL) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_OK);
  CHECK(gjk_scene_set_filter(&scene, id, 0, 0) == GJK_OK);
}

int main(void) {
  check_bytes();
  check_details();
  check_meetings();
  return check_done(TEST_NAME);
}
