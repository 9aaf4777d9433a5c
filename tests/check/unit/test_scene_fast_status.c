// Fast bodies one by one: what each call refuses, what a scene without them costs, when there is an impact and when not,
// what the hash and a saved block hold of them, and that a block with a wrong record is refused.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "scene_bodies.h"
#include "src/scene/gjk_scene_block.h"

#define ONE GJK_Q16_ONE
#define WORDS 4096

static const gjk_shape crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2);
static uint32_t sound[WORDS], block[WORDS];
static gjk_scene scene;
static gjk_scene_view v;
static const gjk_shape ball = GJK_SPHERE(ONE / 4), plate = GJK_BOX(4, 4 * ONE, 4 * ONE), stick = GJK_SEGMENT(ONE);
static const gjk_shape *const kinds[] = {&crate, &ball, &plate, &stick};
static const gjk_scene_config room = {8, 8, 0, 28, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 3};
static gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
static gjk_report reports[64];

static void start(void) {
  bindings.predicate = NULL;
  CHECK(gjk_scene_init(&scene, &room, block, sizeof block, kinds, 4, &bindings) == GJK_OK);
}

static gjk_body_id put(uint16_t shape, uint8_t kind, gjk_q16 x, gjk_q16 y) {
  const gjk_pose pose = scene_pose(x, y);
  return scene_add_shape(&scene, shape, kind, &pose);
}

static gjk_body_id put_fast(uint16_t shape, gjk_q16 x, gjk_q16 y) {
  const gjk_body_id id = put(shape, GJK_BODY_DYNAMIC, x, y);
  CHECK(gjk_scene_set_motion(&scene, id, GJK_MOTION_FAST) == GJK_OK);
  return id;
}

// Updates; the impacts are then in reports. Returns how many there are.
static uint32_t impacts(void) {
  gjk_progress progress;
  uint32_t count = 0;
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(gjk_scene_update(&scene, reports, 64, &progress) == GJK_OK);
  CHECK(progress.reports_left == 0 && progress.pairs_left == 0);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  for (uint32_t i = 0; i < progress.reports; i++) {
    if (reports[i].event == GJK_EVENT_IMPACT) {
      reports[count++] = reports[i];
    } else {
      CHECK(count == 0 && reports[i].fraction == 0);  // impacts come last
    }
  }
  return count;
}

static void check_statuses(void) {
  gjk_body_state state;
  gjk_progress progress;
  uint32_t count;
  start();
  const gjk_body_id wall = put(2, GJK_BODY_STATIC, 0, 0), a = put(1, GJK_BODY_DYNAMIC, -ONE, 0);
  const gjk_body_id b = put(1, GJK_BODY_KINEMATIC, ONE, 0), c = put(1, GJK_BODY_DYNAMIC, 3 * ONE, 0);
  const gjk_body_id d = put(1, GJK_BODY_DYNAMIC, 5 * ONE, 0), nobody = {7, 1};
  CHECK(gjk_scene_set_motion(NULL, a, GJK_MOTION_FAST) == GJK_ERROR_NULL);
  CHECK(gjk_scene_set_motion(&scene, nobody, GJK_MOTION_FAST) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_set_motion(&scene, wall, GJK_MOTION_FAST) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_set_motion(&scene, a, GJK_MOTION_FAST + 1) == GJK_ERROR_RANGE);
  scene.bindings.motion = NULL;
  CHECK(gjk_scene_set_motion(&scene, a, GJK_MOTION_FAST) == GJK_ERROR_UNSUPPORTED);
  scene.bindings.motion = &gjk_scene_motion;
  CHECK(gjk_scene_set_motion(&scene, c, GJK_MOTION_FAST) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, a, GJK_MOTION_FAST) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_KEPT) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, d, GJK_MOTION_KEPT) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_FAST) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_KEPT) == GJK_OK);
  CHECK(gjk_scene_get(&scene, a, &state) == GJK_OK && state.motion == GJK_MOTION_FAST);
  CHECK(gjk_scene_get(&scene, b, &state) == GJK_OK && state.motion == GJK_MOTION_KEPT);
  CHECK(gjk_scene_get(&scene, d, &state) == GJK_OK && state.motion == GJK_MOTION_NOT_KEPT);
  // Without the code no update, teleport or removal of such a body; what else there is goes on.
  scene.bindings.motion = NULL;
  const gjk_pose pose = GJK_POSE_IDENTITY;
  CHECK(gjk_scene_update(&scene, reports, 64, &progress) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_update_begin(&scene, &count) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_teleport(&scene, a, &pose) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_remove(&scene, a) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_move(&scene, a, &pose) == GJK_OK && gjk_scene_teleport(&scene, d, &pose) == GJK_OK);
  scene.bindings.motion = &gjk_scene_motion;
  CHECK(gjk_scene_sweep_count(&scene, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_sweep(&scene, 0, 0) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_update_begin(&scene, &count) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, a, GJK_MOTION_KEPT) == GJK_ERROR_BUSY);
  CHECK(gjk_scene_test_pairs(&scene, 0, count) == GJK_OK);
  CHECK(gjk_scene_sweep_count(&scene, NULL) == GJK_ERROR_NULL && gjk_scene_sweep_count(NULL, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_sweep_count(&scene, &count) == GJK_OK && count == 3);
  CHECK(gjk_scene_sweep(&scene, 2, 1) == GJK_ERROR_RANGE && gjk_scene_sweep(&scene, 0, 4) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_sweep(&scene, 0, 3) == GJK_OK && gjk_scene_sweep(&scene, 0, 3) == GJK_OK);
  impacts();
  // A removed body gives its record back.
  CHECK(gjk_scene_remove(&scene, a) == GJK_OK && gjk_scene_set_motion(&scene, d, GJK_MOTION_KEPT) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, d, GJK_MOTION_NOT_KEPT) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, d, GJK_MOTION_NOT_KEPT) == GJK_OK && gjk_scene_check(&scene) == GJK_OK);
}

// A scene that keeps no motion takes the bytes that it took before there was any; each kept one 44.
static void check_bytes(void) {
  gjk_scene_config c = room;
  c.motions = 0;
  const size_t none = gjk_scene_bytes(&c);
  CHECK(none == 296 + 8 * (60 + 144 + 40) + 28 * 48 + 4);
  c.motions = 5;
  CHECK(gjk_scene_bytes(&c) == none + 5 * 44);
  c.motions = GJK_SCENE_BODIES_MAX + 1;
  CHECK(gjk_scene_bytes(&c) == 0);
}

// The ball's surface is 3/4 units before the plate's, whose half thickness is 4 LSB, of a way of 8 units.
static void check_fractions(void) {
  start();
  const gjk_body_id wall = put(2, GJK_BODY_STATIC, 0, 0), a = put_fast(1, -ONE, 0);
  CHECK(impacts() == 0);
  scene_move_to(&scene, a, 7 * ONE, 0);
  CHECK(impacts() == 1);
  const gjk_q30 exact = (gjk_q30)((INT64_C(1) << 30) * (3 * ONE / 4 - 4) / (8 * ONE));
  CHECK(reports[0].fraction <= exact && reports[0].fraction > exact - GJK_Q30_ONE / (4 * ONE) - 2);
  CHECK(reports[0].a.slot == a.slot && reports[0].b.slot == wall.slot && reports[0].manifold == NULL);
  CHECK(impacts() == 0);  // it stands beyond
  scene_move_to(&scene, a, -ONE, 0);
  CHECK(impacts() == 1);
  // A teleport goes nowhere; a move after it starts there.
  scene_teleport_to(&scene, a, 7 * ONE, 0);
  CHECK(impacts() == 0);
  scene_teleport_to(&scene, a, -ONE, 0);
  scene_move_to(&scene, a, -2 * ONE, 0);
  CHECK(impacts() == 0);
  scene_teleport_to(&scene, a, -ONE, 0);
  scene_move_to(&scene, a, ONE, 0);
  CHECK(impacts() == 1);
  // What is put into the wall and leaves it on the other side is seen, though no update saw it there.
  scene_teleport_to(&scene, a, 0, 0);
  scene_move_to(&scene, a, 3 * ONE, 0);
  CHECK(impacts() == 1 && reports[0].fraction == 0);
  // What an update saw there is no impact when it leaves.
  scene_teleport_to(&scene, a, 0, 0);
  CHECK(impacts() == 0);
  scene_move_to(&scene, a, 3 * ONE, 0);
  CHECK(impacts() == 0);
  // It moves there and back between updates: it stands.
  scene_move_to(&scene, a, -3 * ONE, 0);
  scene_move_to(&scene, a, 3 * ONE, 0);
  CHECK(impacts() == 0);
  // A wall of a few LSB, a way of 30,000 units.
  scene_teleport_to(&scene, a, -20000 * ONE, 0);
  scene_move_to(&scene, a, 10000 * ONE, 0);
  CHECK(impacts() == 1);
}

static bool refuse(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b) {
  (void)user;
  (void)user_a;
  (void)user_b;
  CHECK(a.slot < b.slot);
  return false;
}

static void check_filters(void) {
  start();
  const gjk_body_id a = put_fast(1, -ONE, 0), wall = put(2, GJK_BODY_STATIC, 0, 0);
  impacts();
  CHECK(gjk_scene_set_filter(&scene, a, 1, 2) == GJK_OK);
  scene_move_to(&scene, a, ONE, 0);
  CHECK(impacts() == 0);
  CHECK(gjk_scene_set_filter(&scene, a, 1, 1) == GJK_OK);
  scene.bindings.predicate = refuse;
  scene_move_to(&scene, a, -ONE, 0);
  CHECK(impacts() == 0);
  scene.bindings.predicate = NULL;
  scene_move_to(&scene, a, ONE, 0);
  CHECK(impacts() == 1 && reports[0].b.slot == wall.slot);
  // A sleeping body is met, and one that sleeps sweeps nothing.
  const gjk_body_id sleeper = put_fast(1, 5 * ONE, 0), mover = put(1, GJK_BODY_KINEMATIC, 9 * ONE, 0);
  CHECK(gjk_scene_sleep(&scene, sleeper) == GJK_OK);
  impacts();
  scene_move_to(&scene, a, 20 * ONE, 0);
  CHECK(impacts() == 1 && reports[0].b.slot == sleeper.slot && reports[0].a.slot == a.slot);
  CHECK(gjk_scene_set_motion(&scene, mover, GJK_MOTION_KEPT) == GJK_OK);
  scene_move_to(&scene, mover, ONE, 0);
  CHECK(impacts() == 0);
  CHECK(gjk_scene_wake(&scene, sleeper) == GJK_OK);
  scene_move_to(&scene, mover, 9 * ONE, 0);
  CHECK(impacts() == 1 && reports[0].a.slot == sleeper.slot && reports[0].b.slot == mover.slot);
}

// Two that pass through each other between two updates: both report it at the same fraction, in the order of slots. If one
// is only kept, the other reports it; if it is neither, it stands where it is, and is missed.
static void check_meeting(void) {
  start();
  const gjk_body_id a = put_fast(1, -4 * ONE, 0), b = put_fast(1, 4 * ONE, 0);
  impacts();
  scene_move_to(&scene, a, 4 * ONE, 0);
  scene_move_to(&scene, b, -4 * ONE, 0);
  CHECK(impacts() == 2 && reports[0].a.slot == a.slot && reports[1].a.slot == b.slot);
  CHECK(reports[0].fraction == reports[1].fraction &&
        abs(reports[0].fraction - 7 * (GJK_Q30_ONE / 16) / 1) < GJK_Q30_ONE / 16);
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_KEPT) == GJK_OK);
  scene_move_to(&scene, a, -4 * ONE, 0);
  scene_move_to(&scene, b, 4 * ONE, 0);
  CHECK(impacts() == 1 && reports[0].a.slot == a.slot && reports[0].b.slot == b.slot);
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_NOT_KEPT) == GJK_OK);
  scene_move_to(&scene, a, 3 * ONE, 0);
  scene_move_to(&scene, b, -8 * ONE, 0);
  CHECK(impacts() == 0);
  // Side by side at the same speed they never meet, however fast: that is relative motion.
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_FAST) == GJK_OK);
  scene_teleport_to(&scene, a, 0, 0);
  scene_teleport_to(&scene, b, ONE, 0);
  impacts();
  scene_move_to(&scene, a, 500 * ONE, 90 * ONE);
  scene_move_to(&scene, b, 501 * ONE, 90 * ONE);
  CHECK(impacts() == 0);
}

// A stick that turns half round in a tick hits what it has nowhere near at either end.
static void check_turning(void) {
  start();
  const gjk_body_id a = put_fast(3, 0, 0), post = put(1, GJK_BODY_STATIC, ONE / 2, ONE / 2 + ONE / 4);
  gjk_pose pose = GJK_POSE_IDENTITY;
  impacts();
  const gjk_quat along_x = {0, 759250125, 0, 759250125};
  CHECK(gjk_quat_normalize(&along_x, &pose.rotation) == GJK_OK);
  CHECK(gjk_scene_teleport(&scene, a, &pose) == GJK_OK);
  CHECK(impacts() == 0);
  const gjk_quat turn = {0, 0, GJK_Q30_ONE, 1 << 20};
  gjk_quat unit;
  CHECK(gjk_quat_normalize(&turn, &unit) == GJK_OK);
  CHECK(gjk_quat_compose(&unit, &pose.rotation, &pose.rotation) == GJK_OK);
  CHECK(gjk_scene_move(&scene, a, &pose) == GJK_OK);
  CHECK(impacts() == 1 && reports[0].b.slot == post.slot && reports[0].fraction > 0 &&
        reports[0].fraction < GJK_Q30_ONE);
}

// The hash holds where bodies were; small buffers and rolled back copies repeat the reports.
static void check_state(void) {
  static uint32_t copy[WORDS];
  gjk_scene other;
  gjk_report single[4];
  gjk_progress progress;
  start();
  const gjk_body_id a = put_fast(1, -ONE, 0), wall = put(2, GJK_BODY_STATIC, 0, 0), b = put_fast(1, -ONE, 2 * ONE);
  impacts();
  scene_move_to(&scene, a, ONE, 0);
  scene_move_to(&scene, b, ONE, 2 * ONE);
  const uint64_t before = scene_hash(&scene);
  memcpy(copy, block, sizeof block);
  scene_teleport_to(&scene, a, ONE, 0);
  CHECK(scene_hash(&scene) != before);
  memcpy(block, copy, sizeof block);
  CHECK(scene_hash(&scene) == before);
  CHECK(gjk_scene_set_motion(&scene, a, GJK_MOTION_KEPT) == GJK_OK);
  CHECK(scene_hash(&scene) != before);
  memcpy(block, copy, sizeof block);
  CHECK(gjk_scene_seal(&scene) == GJK_OK);
  memcpy(copy, block, sizeof block);
  CHECK(impacts() == 2 && reports[0].b.slot == wall.slot);
  CHECK(gjk_scene_open(&other, copy, sizeof copy, kinds, 4, &bindings) == GJK_OK);
  uint32_t found = 0, turn = 0;
  do {  // one test or report a call, every other call none
    CHECK(gjk_scene_update_slice(&other, turn % 2, single, turn / 2 % 2, &progress) == GJK_OK);
    CHECK(gjk_scene_check(&other) == GJK_OK);
    if (progress.reports > 0 && single[0].event == GJK_EVENT_IMPACT) {
      CHECK(found < 2 && single[0].a.slot == reports[found].a.slot && single[0].fraction == reports[found].fraction);
      found++;
    }
    turn++;
  } while ((progress.pairs_left > 0 || progress.reports_left > 0) && turn < 100);
  CHECK(found == 2 && turn > 6);
  CHECK(scene_hash(&other) == scene_hash(&scene));
}

#define BROKEN(place, value)                             \
  do {                                                   \
    memcpy(block, sound, sizeof block);                  \
    place = value;                                       \
    CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT); \
  } while (false)

static void check_corrupt(void) {
  start();
  const gjk_body_id a = put_fast(1, -ONE, 0), b = put_fast(1, 4 * ONE, 0);
  put(2, GJK_BODY_STATIC, 0, 0);
  impacts();
  CHECK(gjk_scene_view_of(&scene, &v) == GJK_OK);
  memcpy(sound, block, sizeof block);
  BROKEN(v.header->kept, 1);
  BROKEN(v.header->kept, 3);
  BROKEN(v.header->kept, 4);
  BROKEN(v.header->kept_at, v.header->kept_at + 4);
  BROKEN(v.header->words_at, v.header->words_at - 4);
  BROKEN(v.header->caches_at, v.header->caches_at + 4);
  BROKEN(v.header->config.pair_words, 1);
  BROKEN(v.bodies[a.slot].kind_detail, GJK_BODY_DYNAMIC | GJK_DETAIL_SENSOR << 4);
  BROKEN(v.header->config.motions, 2);
  BROKEN(v.kept[0].slot, b.slot);
  BROKEN(v.kept[1].slot, a.slot);
  BROKEN(v.kept[1].slot, 2);
  BROKEN(v.kept[1].slot, 8);
  BROKEN(v.kept[0].last.rotation.w, 5);
  BROKEN(v.bodies[a.slot].flags, GJK_SCENE_FAST);
  BROKEN(v.bodies[a.slot].flags, 0);
  BROKEN(v.bodies[2].flags, GJK_SCENE_KEPT);
  memcpy(block, sound, sizeof block);
  scene_move_to(&scene, a, ONE, 0);
  uint32_t pairs;
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK && gjk_scene_sweep(&scene, 0, 2) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  memcpy(sound, block, sizeof block);
  BROKEN(v.kept[0].other, 8);
  BROKEN(v.header->next_test, v.header->queued + 3);
  memcpy(block, sound, sizeof block);
  v.kept[1].other = GJK_SCENE_NONE;
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  // A stick that has turned, and is not posed yet, has one half axis.
  gjk_scene_config wide = room;
  wide.box_margin = 8 * ONE;
  CHECK(gjk_scene_init(&scene, &wide, block, sizeof block, kinds, 4, &bindings) == GJK_OK);
  CHECK(gjk_scene_view_of(&scene, &v) == GJK_OK);
  const gjk_body_id stick_id = put(3, GJK_BODY_DYNAMIC, 0, 0);
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.rotation.w = 0;
  pose.rotation.x = GJK_Q30_ONE;
  CHECK(gjk_scene_move(&scene, stick_id, &pose) == GJK_OK && gjk_scene_check(&scene) == GJK_OK);
  CHECK((v.parts[v.bodies[stick_id.slot].first].state & GJK_SCENE_UNPOSED) != 0);
  memcpy(sound, block, sizeof block);
  BROKEN(v.parts[v.bodies[stick_id.slot].first].frame[1].y, 1);
  BROKEN(v.parts[v.bodies[stick_id.slot].first].frame[2].x, -1);
}

// Where a body was at the last update, until the next one; a teleport begins anew.
static void check_last_pose(void) {
  gjk_pose last = GJK_POSE_IDENTITY;
  start();
  const gjk_body_id a = put(1, GJK_BODY_KINEMATIC, ONE, 0), b = put(1, GJK_BODY_DYNAMIC, 9 * ONE, 0), nobody = {7, 1};
  CHECK(gjk_scene_last_pose(&scene, a, &last) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_scene_set_motion(&scene, b, GJK_MOTION_KEPT) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, a, GJK_MOTION_KEPT) == GJK_OK);
  CHECK(gjk_scene_last_pose(&scene, a, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_last_pose(NULL, a, &last) == GJK_ERROR_NULL);
  CHECK(gjk_scene_last_pose(&scene, nobody, &last) == GJK_ERROR_BODY_ID && last.position.x == 0);
  scene_move_to(&scene, a, 2 * ONE, 7);
  CHECK(gjk_scene_last_pose(&scene, a, &last) == GJK_OK && last.position.x == ONE && last.position.y == 0);
  (void)impacts();
  CHECK(gjk_scene_last_pose(&scene, a, &last) == GJK_OK && last.position.x == 2 * ONE && last.position.y == 7);
  scene_move_to(&scene, a, 3 * ONE, 0);
  scene_teleport_to(&scene, a, 4 * ONE, 5);
  CHECK(gjk_scene_last_pose(&scene, a, &last) == GJK_OK && last.position.x == 4 * ONE && last.position.y == 5);
  CHECK(gjk_scene_last_pose(&scene, b, &last) == GJK_OK && last.position.x == 9 * ONE);
}

int main(void) {
  check_last_pose();
  check_statuses();
  check_bytes();
  check_fractions();
  check_filters();
  check_meeting();
  check_turning();
  check_state();
  check_corrupt();
  return check_done("scene_fast_status");
}
