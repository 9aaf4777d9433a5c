// gjk2_scene_check: every word of a sound block in turn gets every one of many wrong values. What the check accepts does
// no harm: updates and queries end, and the check accepts what they leave. What it must refuse is refused.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk2/gjk2.h"
#include "random.h"
#include "src/plane_scene/gjk2_scene_names.h"
// The view of a block, under the plane's names.
#include "src/scene/gjk_scene_pairs.h"

#define ONE GJK_Q16_ONE
#define SEED 7710
#define BODIES 36

static const gjk2_vec corners[5] = {{-30000, -30000}, {30000, -30000}, {36000, 9000}, {0, 30000}, {-33000, 4000}};
static const gjk2_shape crate = GJK2_BOX(ONE / 2, ONE / 2), roof = GJK2_POLYGON(corners, 5);
static const gjk2_shape flag = GJK2_TRIANGLE(corners), egg = GJK2_ELLIPSE(ONE / 2, ONE / 3);
static const gjk2_shape *const shapes[] = {&crate, &roof, &flag, &egg, NULL};
static const gjk2_scene_config config = {40, 60, 5, 30, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 0, 0, 0, 0};

static gjk2_scene scene;
static uint32_t *block, *sound;  // of exactly the bytes that the scene needs
static size_t bytes;
static gjk2_scene_view v;
static unsigned refused, accepted;

static gjk_body_id add(gjk_q16 x, uint16_t parts, uint16_t shape) {
  const gjk2_part part[3] = {{shape, false, GJK2_POSE_IDENTITY},
                             {0, true, {{0, 3 * ONE}, {GJK_Q30_ONE, 0}}},
                             {1, true, {{0, 6 * ONE}, {GJK_Q30_ONE, 0}}}};
  gjk2_body_setup setup = {GJK2_POSE_IDENTITY, part, parts, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_body_id body = {0, 0};
  setup.pose.position.x = x;
  CHECK(gjk2_rotation_from_angle(x, &setup.pose.rotation) == GJK_OK);
  CHECK(gjk2_scene_add(&scene, &setup, &body) == GJK_OK);
  return body;
}

static void ignore_report(void *user, const gjk2_report *report) {
  (void)user;
  (void)report;
}

static void teleport(gjk_body_id body, gjk_q16 x) {
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  pose.position.x = x;
  CHECK(gjk2_scene_teleport(&scene, body, &pose) == GJK_OK);
}

static void keep(void) {
  CHECK(gjk2_scene_check(&scene) == GJK_OK);
  CHECK(gjk2_scene_view_of(&scene, &v) == GJK_OK);
  memcpy(sound, block, bytes);
}

// Bodies in slots 0 to 35: three that touch, one of three parts, the others alone; every pool has a record that was given
// back. Slot 34 is free again, slots from 36 on never were taken. One pair is gone, some bodies turned since.
static void build(void) {
  gjk_body_id bodies[BODIES];
  CHECK(gjk2_scene_init(&scene, &config, block, bytes, shapes, 5, NULL) == GJK_OK);
  for (int i = 0; i < BODIES; i++) {
    bodies[i] = add(i < 4 ? i * (ONE / 2) : 10 * i * ONE, i == 5 || i == 34 ? 3 : 1, (uint16_t)(i % 4));
  }
  teleport(bodies[35], 9 * 10 * ONE);  // a pair for one update
  CHECK(gjk2_scene_update_each(&scene, ignore_report, NULL) == GJK_OK);
  teleport(bodies[35], -99 * ONE);
  CHECK(gjk2_scene_remove(&scene, bodies[34]) == GJK_OK);
  CHECK(gjk2_scene_update_each(&scene, ignore_report, NULL) == GJK_OK);
}

// The same, and between updates: a pair that is gone, bodies that moved and turned.
static void stir(void) {
  gjk_body_id body;
  gjk2_body_state state;
  CHECK(gjk2_scene_body_at(&scene, 0, &body) == GJK_OK);
  CHECK(gjk2_scene_remove(&scene, body) == GJK_OK);
  for (uint32_t i = 1; i < 8; i++) {
    const gjk2_rotation turn = {GJK_Q30_ONE, 3000000};
    CHECK(gjk2_scene_body_at(&scene, i, &body) == GJK_OK);
    CHECK(gjk2_scene_get(&scene, body, &state) == GJK_OK);
    CHECK(gjk2_rotation_compose(&state.pose.rotation, &turn, &state.pose.rotation) == GJK_OK);
    CHECK(gjk2_scene_move(&scene, body, &state.pose) == GJK_OK);
  }
}

// Uses a block that the check accepted in every way.
static void use(void) {
  const gjk2_aabb all = {{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}};
  const gjk2_vec from = {-1000 * ONE, 0}, to = {1000 * ONE, ONE / 4};
  gjk_scene_hit hits[8];
  uint32_t count;
  uint64_t hash;
  gjk_body_id body;
  CHECK(gjk2_scene_query_box(&scene, &all, NULL, hits, 8, &count) == GJK_OK);
  CHECK(gjk2_scene_query_ray(&scene, &from, &to, NULL, hits, 8, &count) == GJK_OK);
  const gjk_status status = gjk2_scene_update_each(&scene, ignore_report, NULL);
  CHECK(status == GJK_OK || status == GJK_ERROR_UNSUPPORTED || status == GJK_ERROR_CAPACITY);
  if (status == GJK_OK) {
    CHECK(gjk2_scene_hash(&scene, &hash) == GJK_OK);
    for (uint32_t slot = 0; slot < config.bodies; slot += 7) {
      CHECK(gjk2_scene_body_at(&scene, slot, &body) == GJK_OK);
      CHECK(body.generation == 0 || gjk2_scene_remove(&scene, body) == GJK_OK);
    }
    CHECK(gjk2_scene_update_each(&scene, ignore_report, NULL) == GJK_OK);
    CHECK(gjk2_scene_check(&scene) == GJK_OK);
  }
}

static void try_word(size_t at, uint32_t value) {
  if (sound[at] == value) {
    return;
  }
  memcpy(block, sound, bytes);
  block[at] = value;
  const gjk_status status = gjk2_scene_check(&scene);
  CHECK_MSG(status == GJK_OK || status == GJK_ERROR_CORRUPT || status == GJK_ERROR_RANGE ||
                (status == GJK_ERROR_CAPACITY && at == 3),  // fewer bytes than a header has
            "word %zu", at);
  if (status != GJK_OK) {
    refused++;
    return;
  }
  accepted++;
  use();
}

static void try_all(random_state *random) {
  for (size_t at = 0; at < bytes / 4; at++) {
    const uint32_t is = sound[at];
    check_trial(at, NULL, NULL);
    const uint32_t values[] = {is ^ 1u,
                               is ^ 2u,
                               is ^ UINT32_C(0x80000000),
                               is ^ UINT32_C(0x01000000),
                               is ^ UINT32_C(0x00010000),
                               is + 1,
                               is - 1,
                               0,
                               UINT32_MAX,
                               UINT32_C(0xFFFFFF),
                               is ^ UINT32_C(0x04000000),
                               is ^ UINT32_C(0x10000000),
                               is | 0x8000,
                               is & 0xFF00FF00,
                               random_u32(random),
                               is ^ 1u << random_below(random, 32)};
    for (unsigned i = 0; i < sizeof values / sizeof values[0]; i++) {
      try_word(at, values[i]);
    }
  }
}

#define REFUSED(...)                                                              \
  do {                                                                            \
    memcpy(block, sound, bytes);                                                  \
    __VA_ARGS__;                                                                  \
    CHECK_MSG(gjk2_scene_check(&scene) == GJK_ERROR_CORRUPT, "%s", #__VA_ARGS__); \
  } while (0)

#define ACCEPTED(...)                                                  \
  do {                                                                 \
    memcpy(block, sound, bytes);                                       \
    __VA_ARGS__;                                                       \
    CHECK_MSG(gjk2_scene_check(&scene) == GJK_OK, "%s", #__VA_ARGS__); \
  } while (0)

static gjk2_scene_part *part_of(uint32_t slot) {
  return &v.parts[v.bodies[slot].first];
}

// What the plane stores otherwise than space, before any part is unposed.
static void test_fields(void) {
  const uint32_t pair = part_of(1)->pairs / 2;
  const uint32_t own = v.parts[part_of(5)->next].own_pose;
  REFUSED(part_of(4)->frame[0].x++);  // a box: half axes
  REFUSED(part_of(4)->frame[1].y++);
  REFUSED(part_of(9)->frame[0].x++);  // a polygon: rotation and centre
  REFUSED(part_of(9)->frame[1].y++);
  REFUSED(part_of(6)->frame[0].x++);  // a triangle: 0 and centre
  REFUSED(part_of(6)->frame[1].y++);
  REFUSED(part_of(7)->frame[0].x++);  // an ellipse: rotation and 0
  REFUSED(part_of(7)->frame[1].y++);
  REFUSED(part_of(9)->fraction_x ^= 1);
  REFUSED(part_of(9)->fraction_y ^= 1);
  REFUSED(part_of(9)->core_radius++);
  REFUSED(part_of(4)->state ^= GJK2_SCENE_ORDERED);
  REFUSED(part_of(9)->state ^= GJK2_SCENE_ORDERED);
  REFUSED(part_of(7)->state ^= GJK2_SCENE_ORDERED);
  REFUSED(part_of(4)->state |= GJK_SCENE_UNPOSED; v.bodies[4].rotation.c = 5);
  REFUSED(part_of(1)->state |= GJK_SCENE_UNPOSED);  // it has pairs, and did not move
  ACCEPTED(part_of(9)->state |= GJK_SCENE_UNPOSED);
  REFUSED(part_of(9)->state = (part_of(9)->state | GJK_SCENE_UNPOSED) ^ GJK2_SCENE_ORDERED);
  REFUSED(v.own_poses[own].pose.position.y = INT32_MAX);
  REFUSED(v.own_poses[own].pose.rotation.s = GJK_Q30_ONE);
  REFUSED(v.bodies[4].rotation.c = 5);
  REFUSED(v.bodies[4].margin = -1);
  REFUSED(v.bodies[4].first = GJK2_SCENE_NONE);
  REFUSED(gjk2_scene_set_next(&v.pairs[pair], 0, 0));
  REFUSED(gjk2_scene_set_previous(&v.pairs[pair], 1, 2));
  REFUSED(gjk2_scene_set_end(&v.pairs[pair], 0, v.header->parts.fresh));
  REFUSED(v.pairs[pair].state |= 3u << GJK_SCENE_PAIR_CACHED | 1u << 7);
  REFUSED(v.pairs[pair].gap = -1);
  REFUSED(v.nodes[v.header->root].height ^= 1);
  REFUSED(v.nodes[v.header->root].parent = 0);
}

// Opens what the check accepts, sealed afresh, and goes on with it: bodies on their way, whose update is half done.
static void try_kept(random_state *random) {
  static const gjk2_scene_config moving = {4, 4, 0, 8, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 4};
  static const gjk2_scene_bindings bindings = {.motion = &gjk2_scene_motion};
  gjk_progress progress;
  const gjk2_pose ahead = {{2 * ONE, 0}, {GJK_Q30_ONE, 0}};
  CHECK(gjk2_scene_init(&scene, &moving, block, bytes, shapes, 5, &bindings) == GJK_OK);
  for (int i = 0; i < 4; i++) {
    const gjk_body_id body = add(i * (ONE / 2), 1, 0);
    CHECK(gjk2_scene_set_motion(&scene, body, i < 2 ? GJK_MOTION_FAST : GJK_MOTION_KEPT) == GJK_OK);
    CHECK(gjk2_scene_move(&scene, body, &ahead) == GJK_OK);
  }
  CHECK(gjk2_scene_update_slice(&scene, 7, NULL, 0, &progress) == GJK_OK);  // 6 pairs, a fast body
  CHECK(progress.pairs_left == 3);
  keep();
  REFUSED(v.kept[1].other = v.header->parts.fresh);
  REFUSED(v.kept[1].other = 0);
  REFUSED(v.kept[1].other = 0; v.kept[1].state = GJK_SCENE_SWEPT; v.parts[0].state = 0);
  ACCEPTED(v.kept[1].other = 0; v.kept[1].state = GJK_SCENE_SWEPT);
  const uint32_t words = v.header->bytes / 4;
  unsigned opened = 0;
  for (uint32_t at = 0; at < words; at++) {
    check_trial(at, NULL, NULL);
    for (unsigned bit = 0; bit < 32; bit += 1 + random_below(random, 3)) {
      gjk2_scene forged = scene;
      memcpy(block, sound, bytes);
      block[at] ^= UINT32_C(1) << bit;
      if (gjk2_scene_attach(&forged, block, bytes, shapes, 5, &bindings) == GJK_OK &&
          gjk2_scene_seal(&forged) == GJK_OK &&
          gjk2_scene_open(&forged, block, bytes, shapes, 5, &bindings) == GJK_OK) {
        const gjk_status status = gjk2_scene_update_each(&forged, ignore_report, NULL);
        CHECK(status == GJK_OK || status == GJK_ERROR_UNSUPPORTED);
        opened++;
      }
    }
  }
  printf("with motions: %u opened\n", opened);
  CHECK(opened > words / 4);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  bytes = gjk2_scene_bytes(&config);
  block = malloc(bytes);
  sound = malloc(bytes);
  CHECK(block != NULL && sound != NULL);
  build();
  keep();
  test_fields();
  try_all(&random);
  printf("between updates: %u refused, %u accepted\n", refused, accepted);
  CHECK(refused > 8000 && accepted > 1000);
  build();
  stir();
  keep();
  try_all(&random);
  printf("with changes: %u refused, %u accepted\n", refused, accepted);
  build();
  stir();
  gjk_progress progress;
  CHECK(gjk2_scene_update_slice(&scene, 1, NULL, 0, &progress) == GJK_OK);
  CHECK(progress.pairs_left > 0);
  keep();
  try_all(&random);
  printf("while testing: %u refused, %u accepted\n", refused, accepted);
  CHECK(gjk2_scene_update_slice(&scene, 99, NULL, 0, &progress) == GJK_OK || progress.reports_left > 0);
  try_kept(&random);
  free(block);
  free(sound);
  return check_done("plane_scene_check");
}
