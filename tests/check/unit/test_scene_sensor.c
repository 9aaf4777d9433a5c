// Sensors: what is reported of them, what is refused, and that no distance, depth or manifold is found for them. Scenes
// of random bodies with sensors are compared with a search of all pairs in test_scene_random.c and test_scene_fast.c.
#ifndef TEST_NAME
#include "gjk/gjk.h"
#define TEST_NAME "scene_sensor"
#define SPACE 1
#endif

#include "check.h"
#include "random.h"
#include "scene_bodies.h"

#define SEED 9100
#define TICKS 400
#define BODIES 12

#if SPACE
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_shape wall = GJK_BOX(GJK_Q16(0.25), GJK_Q16(4.0), GJK_Q16(4.0));
#else
static const gjk_shape ball = GJK2_CIRCLE(GJK_Q16(0.5));
static const gjk_shape wall = GJK2_BOX(GJK_Q16(0.25), GJK_Q16(4.0));
#endif

static const gjk_shape *const kinds[] = {&ball, &wall};
static const gjk_part parts[] = {{0, false, GJK_POSE_IDENTITY}, {1, false, GJK_POSE_IDENTITY}};
static uint32_t block[8192];
static gjk_manifold manifolds[64];
static gjk_report reports[64];
static gjk_scene scene;
static uint32_t count;
static const gjk_scene_bindings all = {
    .details = &gjk_scene_contacts, .manifolds = manifolds, .motion = &gjk_scene_motion};

static gjk_scene_config config_of(uint8_t detail) {
  gjk_scene_config config = {.bodies = BODIES, .parts = BODIES, .pairs = 64, .persist = 1, .motions = BODIES};
  config.detail = detail;
  return config;
}

static void start(uint8_t detail, const gjk_scene_bindings *bindings) {
  const gjk_scene_config config = config_of(detail);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, kinds, 2, bindings) == GJK_OK);
}

static gjk_status try_put(uint16_t shape, uint8_t kind, uint8_t detail, gjk_q16 x, gjk_body_id *id) {
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .part_count = 1, .category = 1, .mask = 1};
  setup.parts = &parts[shape];
  setup.kind = kind;
  setup.detail = detail;
  setup.pose.position.x = x;
  return gjk_scene_add(&scene, &setup, id);
}

static gjk_body_id put(uint16_t shape, uint8_t kind, uint8_t detail, gjk_q16 x) {
  gjk_body_id id = {0, 0};
  CHECK(try_put(shape, kind, detail, x, &id) == GJK_OK);
  return id;
}

static void update(void) {
  count = scene_update(&scene, reports, 64);
}

// A ball rolls through a sensor, against a wall: the sensor begins and ends, the wall begins and persists.
static void check_events(uint8_t detail) {
  start(detail, &all);
  const gjk_body_id sensor = put(1, GJK_BODY_STATIC, GJK_DETAIL_SENSOR, 0);
  const gjk_body_id end = put(1, GJK_BODY_STATIC, GJK_DETAIL_CONTACTS, GJK_Q16(3.0));
  const gjk_body_id roller = put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, GJK_Q16(-3.0));
  unsigned begun = 0, ended = 0, persisting = 0;
  for (int32_t x = -30; x <= 25; x++) {
    scene_move_to(&scene, roller, x * GJK_Q16_ONE / 10, 0);
    update();
    for (uint32_t i = 0; i < count; i++) {
      const gjk_report *r = &reports[i];
      const bool of_sensor = r->a.slot == sensor.slot;
      CHECK(r->b.slot == roller.slot && (of_sensor || r->a.slot == end.slot));
      CHECK(r->detail == (of_sensor ? GJK_DETAIL_TOUCH : GJK_DETAIL_CONTACTS));
      CHECK((r->manifold != NULL) == !of_sensor && (of_sensor ? r->distance == 0 : r->manifold->count > 0));
      begun += of_sensor && r->event == GJK_EVENT_BEGIN;
      ended += of_sensor && r->event == GJK_EVENT_END;
      persisting += of_sensor && r->event == GJK_EVENT_PERSIST;
    }
    uint32_t cursor = 0, near = 0;
    bool found = false;
    gjk_report r;
    while (gjk_scene_next_near(&scene, &cursor, &r, &found) == GJK_OK && found) {
      near += r.a.slot == sensor.slot;
    }
    CHECK(near == (x >= -7 && x <= 7));  // the wall's half and the ball's radius: 0.75
  }
  CHECK(begun == 1 && ended == 1 && persisting == 0);
  CHECK(count == 1 && reports[0].a.slot == end.slot);
}

// The same walk of bodies at random, once where all but one are sensors, and once where none is.
static void check_work(uint8_t detail, bool sensors) {
  random_state random = random_seed(check_seed(SEED) + detail);
  gjk_body_id ids[BODIES];
  unsigned begun = 0, ended = 0, measured = 0, met = 0;
  start(detail, &all);
  for (int i = 0; i < BODIES; i++) {
    const uint8_t wish = sensors && i > 0 ? GJK_DETAIL_SENSOR : GJK_DETAIL_TOUCH;
    ids[i] = put(0, i % 3 == 1 ? GJK_BODY_KINEMATIC : GJK_BODY_DYNAMIC, wish, i * GJK_Q16_ONE);
  }
  for (int tick = 0; tick < TICKS; tick++) {
    gjk_scene_stats stats;
    for (int i = 0; i < 3; i++) {
      scene_move_to(&scene, ids[random_below(&random, BODIES)], random_range(&random, GJK_Q16(-8.0), GJK_Q16(8.0)), 0);
    }
    update();
    CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK);
    begun += stats.begun;
    ended += stats.ended;
    measured += stats.measured;
    met += stats.manifolds;
    CHECK(!sensors || stats.persisting == 0);
    for (uint32_t i = 0; i < count; i++) {
      CHECK(!sensors || (reports[i].manifold == NULL && reports[i].distance == 0));
    }
  }
  CHECK(begun > 100 && ended > 100);
  CHECK_MSG((measured > 100) == (!sensors && (detail == GJK_DETAIL_DISTANCE || detail == GJK_DETAIL_DEPTH)), "%u",
            measured);
  CHECK_MSG((met > 100) == (!sensors && detail == GJK_DETAIL_CONTACTS), "%u", met);
  CHECK(!sensors || (measured == 0 && met == 0));
}

// A sensor needs no details, and asks for none.
static void check_unbound(void) {
  gjk_body_id id = {0, 0};
  start(GJK_DETAIL_TOUCH, NULL);
  (void)put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_SENSOR, 0);
  (void)put(0, GJK_BODY_STATIC, GJK_DETAIL_SENSOR, GJK_Q16(0.5));
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_BEGIN && reports[0].detail == GJK_DETAIL_TOUCH);
  CHECK(try_put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_CONTACTS, 0, &id) == GJK_ERROR_UNSUPPORTED);
}

// Two static bodies are no pair, though one is a sensor. A removed sensor ends its pairs.
static void check_static_and_removed(void) {
  start(GJK_DETAIL_CONTACTS, &all);
  const gjk_body_id sensor = put(1, GJK_BODY_STATIC, GJK_DETAIL_SENSOR, 0);
  (void)put(1, GJK_BODY_STATIC, GJK_DETAIL_TOUCH, 0);
  update();
  CHECK(count == 0);
  (void)put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 0);
  update();
  CHECK(count == 2 && reports[0].manifold == NULL && reports[1].manifold != NULL);
  CHECK(gjk_scene_remove(&scene, sensor) == GJK_OK);
  update();
  CHECK(count == 2 && reports[0].event == GJK_EVENT_END && reports[0].a.generation == sensor.generation);
  CHECK(reports[1].event == GJK_EVENT_PERSIST);
}

// A fast body passes a sensor, and meets what is behind.
static void check_fast(uint8_t detail, bool met) {
  start(GJK_DETAIL_TOUCH, &all);
  (void)put(1, GJK_BODY_STATIC, detail, 0);
  (void)put(1, GJK_BODY_STATIC, GJK_DETAIL_TOUCH, GJK_Q16(20.0));
  const gjk_body_id bullet = put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, GJK_Q16(-40.0));
  CHECK(gjk_scene_set_motion(&scene, bullet, GJK_MOTION_FAST) == GJK_OK);
  update();
  scene_move_to(&scene, bullet, GJK_Q16(40.0), 0);
  update();
  CHECK(count == 1 && reports[0].event == GJK_EVENT_IMPACT && reports[0].b.slot == (met ? 0u : 1u));
}

static void check_refusals(void) {
  const gjk_scene_config config = config_of(GJK_DETAIL_SENSOR);
  gjk_scene other;
  gjk_body_id id = {7, 7};
  gjk_body_state state;
  CHECK(gjk_scene_bytes(&config) == 0);
  CHECK(gjk_scene_init(&other, &config, block, sizeof block, kinds, 2, &all) == GJK_ERROR_RANGE);
  start(GJK_DETAIL_TOUCH, &all);
  CHECK(try_put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_SENSOR + 1, 0, &id) == GJK_ERROR_RANGE);
  CHECK(id.slot == 7 && id.generation == 7);
  id = put(0, GJK_BODY_DYNAMIC, GJK_DETAIL_SENSOR, 0);
  CHECK(gjk_scene_set_motion(&scene, id, GJK_MOTION_FAST) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_set_motion(&scene, id, GJK_MOTION_KEPT) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_get(&scene, id, &state) == GJK_OK && state.detail == GJK_DETAIL_SENSOR);
  CHECK(state.motion == GJK_MOTION_NOT_KEPT);
}

// Sensors count in the hash, and are saved.
static void check_saved(void) {
  uint64_t hash[2] = {0, 0};
  gjk_scene opened;
  gjk_body_state state;
  for (int i = 0; i < 2; i++) {
    start(GJK_DETAIL_TOUCH, &all);
    const gjk_body_id id = put(0, GJK_BODY_DYNAMIC, i == 0 ? GJK_DETAIL_TOUCH : GJK_DETAIL_SENSOR, 0);
    CHECK(gjk_scene_hash(&scene, &hash[i]) == GJK_OK);
    CHECK(gjk_scene_seal(&scene) == GJK_OK);
    CHECK(gjk_scene_open(&opened, block, sizeof block, kinds, 2, &all) == GJK_OK);
    CHECK(gjk_scene_get(&opened, id, &state) == GJK_OK);
    CHECK(state.detail == (i == 0 ? GJK_DETAIL_TOUCH : GJK_DETAIL_SENSOR));
  }
  CHECK(hash[0] != hash[1]);
}

int main(void) {
  for (uint8_t detail = GJK_DETAIL_TOUCH; detail <= GJK_DETAIL_CONTACTS; detail++) {
    check_events(detail);
    check_work(detail, false);
    check_work(detail, true);
  }
  check_unbound();
  check_static_and_removed();
  check_fast(GJK_DETAIL_SENSOR, false);
  check_fast(GJK_DETAIL_TOUCH, true);
  check_refusals();
  check_saved();
  return check_done(TEST_NAME);
}
