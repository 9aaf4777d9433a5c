// What a scene refuses, and that a refused call changes nothing; capacity reached in every pool.
#include <stdint.h>
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "gjk/scene.h"
#include "gjk_allocate.h"
#include "scene_bodies.h"

static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5)), ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_shape broken = GJK_SPHERE(-1);
static const gjk_shape *const shapes[] = {&crate, &ball, &broken, NULL};
static const gjk_scene_config usual = {4, 6, 2, 3, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
static const gjk_pose identity = GJK_POSE_IDENTITY;
static const gjk_body_id nobody = {0, 0};

static uint32_t block[2000];
static gjk_scene scene;

static void start(const gjk_scene_config *config) {
  CHECK(gjk_scene_init(&scene, config, block, sizeof block, shapes, 4, NULL) == GJK_OK);
}

static gjk_body_setup setup_of(const gjk_part *parts, uint16_t count, int32_t x) {
  gjk_body_setup s = {GJK_POSE_IDENTITY, parts, count, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  s.pose.position.x = x;
  return s;
}

static gjk_status update(gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  return gjk_scene_update(&scene, reports, capacity, progress);
}

static size_t bytes_of(uint32_t bodies) {
  gjk_scene_config c = usual;
  c.bodies = bodies;
  return gjk_scene_bytes(&c);
}

static void check_configurations(void) {
  gjk_scene_config c = usual;
  CHECK(gjk_scene_bytes(&c) > 0);
  CHECK(gjk_scene_bytes(&c) <= sizeof block);
  CHECK(gjk_scene_bytes(NULL) == 0);
#define REFUSED(field, value, status)                                                    \
  do {                                                                                   \
    c = usual;                                                                           \
    c.field = (value);                                                                   \
    CHECK(gjk_scene_bytes(&c) == 0);                                                     \
    CHECK(gjk_scene_init(&scene, &c, block, sizeof block, shapes, 4, NULL) == (status)); \
  } while (0)
  REFUSED(bodies, 0, GJK_ERROR_RANGE);
  REFUSED(bodies, GJK_SCENE_BODIES_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(parts, 0, GJK_ERROR_RANGE);
  REFUSED(parts, UINT32_MAX, GJK_ERROR_RANGE);
  REFUSED(own_poses, GJK_SCENE_BODIES_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(pairs, 0, GJK_ERROR_RANGE);
  REFUSED(pairs, GJK_SCENE_PAIRS_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(box_margin, -1, GJK_ERROR_RANGE);
  REFUSED(box_margin, GJK_RADIUS_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(persist, 2, GJK_ERROR_RANGE);
  REFUSED(retest_all, 2, GJK_ERROR_RANGE);
  REFUSED(pair_words, GJK_SCENE_PAIR_WORDS_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(detail, GJK_DETAIL_SENSOR + 1, GJK_ERROR_RANGE);
#undef REFUSED
  static const gjk_scene_config most = {GJK_SCENE_BODIES_MAX,
                                        GJK_SCENE_BODIES_MAX,
                                        GJK_SCENE_BODIES_MAX,
                                        GJK_SCENE_PAIRS_MAX,
                                        GJK_RADIUS_MAX,
                                        GJK_DETAIL_CONTACTS,
                                        1,
                                        1,
                                        0,
                                        0,
                                        GJK_SCENE_BODIES_MAX};
  static const gjk_scene_config least = {1, 1, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  CHECK(gjk_scene_bytes(&most) > 0);
  CHECK(gjk_scene_bytes(&least) > 0);
  c = usual;
  const size_t bytes = gjk_scene_bytes(&c);
  CHECK(gjk_scene_init(&scene, &c, block, bytes - 1, shapes, 4, NULL) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_init(&scene, &c, (char *)block + 1, sizeof block - 4, shapes, 4, NULL) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_init(NULL, &c, block, bytes, shapes, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_init(&scene, NULL, block, bytes, shapes, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_init(&scene, &c, NULL, bytes, shapes, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_init(&scene, &c, block, bytes, NULL, 4, NULL) == GJK_ERROR_NULL);
  // The figures to keep: bytes of a body with one shape, and of a pair.
  gjk_scene_config more = usual;
  more.bodies += 32;
  more.parts += 32;
  const size_t per_body = (gjk_scene_bytes(&more) - bytes + 31) / 32;
  more = usual;
  more.pairs += 1;
  const size_t per_pair = gjk_scene_bytes(&more) - bytes;
  printf("%u bytes a body with one shape, %u a pair\n", (unsigned)per_body, (unsigned)per_pair);
  CHECK(per_body <= 256);
  CHECK(per_pair <= 48);
  // A word tells which of 32 slots are free.
  for (uint32_t n = 2; n < 100; n++) {
    CHECK(bytes_of(n + 1) - bytes_of(n) == bytes_of(2) - bytes_of(1) + (n % 32 == 0 ? 4 : 0));
  }
}

static void check_bad_setups(void) {
  gjk_part parts[7] = {{0, false, GJK_POSE_IDENTITY}, {1, true, GJK_POSE_IDENTITY}};
  const gjk_body_setup good = setup_of(parts, 2, 0);
  gjk_body_setup s;
  gjk_body_id body = nobody;
  start(&usual);
  const uint64_t before = scene_hash(&scene);
#define REFUSED(field, value, status)                    \
  do {                                                   \
    s = good;                                            \
    s.field = (value);                                   \
    CHECK(gjk_scene_add(&scene, &s, &body) == (status)); \
  } while (0)
  REFUSED(parts, NULL, GJK_ERROR_NULL);
  REFUSED(part_count, 0, GJK_ERROR_EMPTY);
  REFUSED(part_count, 7, GJK_ERROR_CAPACITY);
  REFUSED(kind, GJK_BODY_DYNAMIC + 1, GJK_ERROR_RANGE);
  REFUSED(detail, GJK_DETAIL_SENSOR + 1, GJK_ERROR_RANGE);
  REFUSED(margin, -1, GJK_ERROR_RANGE);
  REFUSED(margin, GJK_RADIUS_MAX + 1, GJK_ERROR_RANGE);
  REFUSED(pose.rotation.w, 5, GJK_ERROR_ROTATION);
  parts[1].shape = 4;
  REFUSED(user, 0, GJK_ERROR_RANGE);
  parts[1].shape = 3;
  REFUSED(user, 0, GJK_ERROR_NULL);
  parts[1].shape = 2;
  REFUSED(user, 0, GJK_ERROR_NEGATIVE);
  parts[1].shape = 1;
  parts[1].pose.position.x = 1;
  REFUSED(pose.position.x, INT32_MAX, GJK_ERROR_RANGE);
  parts[1].pose.rotation.w = 0;
  REFUSED(user, 0, GJK_ERROR_ROTATION);
  parts[1].pose = identity;
#undef REFUSED
  CHECK(gjk_scene_add(&scene, NULL, &body) == GJK_ERROR_NULL);
  CHECK(gjk_scene_add(&scene, &good, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_add_at(&scene, 4, &good, &body) == GJK_ERROR_CAPACITY);
  CHECK(scene_hash(&scene) == before);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(body.generation == 0);
  CHECK(gjk_scene_add(&scene, &good, &body) == GJK_OK);
  CHECK(body.slot == 0);
  CHECK(scene_hash(&scene) != before);
  CHECK(gjk_scene_add_at(&scene, 0, &good, &body) == GJK_ERROR_BODY_ID);
}

static void check_bad_changes(void) {
  const gjk_part parts[2] = {{0, false, GJK_POSE_IDENTITY}, {1, true, {{65536, 0, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  const gjk_body_setup s = setup_of(parts, 2, 0);
  gjk_body_id body;
  gjk_body_state state;
  gjk_collider collider;
  gjk_pose pose = identity;
  start(&usual);
  CHECK(gjk_scene_add(&scene, &s, &body) == GJK_OK);
  const uint64_t before = scene_hash(&scene);
  pose.rotation.w = 0;
  CHECK(gjk_scene_move(&scene, body, &pose) == GJK_ERROR_ROTATION);
  CHECK(gjk_scene_move(&scene, body, NULL) == GJK_ERROR_NULL);
  pose = identity;
  pose.position.x = INT32_MAX - 65535;  // only the second part leaves int32
  CHECK(gjk_scene_move(&scene, body, &pose) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_teleport(&scene, body, &pose) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_set_shape(&scene, body, 2, 0) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_set_shape(&scene, body, 0, 4) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_set_shape(&scene, body, 0, 3) == GJK_ERROR_NULL);
  CHECK(gjk_scene_set_shape(&scene, body, 0, 2) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_scene_collider(&scene, body, 2, &collider) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_get(&scene, body, NULL) == GJK_ERROR_NULL);
  CHECK(scene_hash(&scene) == before);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  CHECK(state.part_count == 2);
  CHECK(state.pose.position.x == 0);
  CHECK(gjk_scene_collider(&scene, body, 1, &collider) == GJK_OK);
  CHECK(collider.centre.x == 65536);
}

// Ids that were never given, or whose body is removed, are refused. A slot that is taken again has another generation.
static void check_handles(void) {
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup s = setup_of(&part, 1, 0);
  const gjk_body_id forged[] = {{0, 0}, {0, 2}, {0, 3}, {1, 1}, {4, 1}, {UINT32_MAX, UINT32_MAX}};
  gjk_body_id first, second;
  start(&usual);
  CHECK(gjk_scene_add(&scene, &s, &first) == GJK_OK);
  for (unsigned i = 0; i < sizeof forged / sizeof forged[0]; i++) {
    CHECK(gjk_scene_remove(&scene, forged[i]) == GJK_ERROR_BODY_ID);
  }
  CHECK(gjk_scene_remove(&scene, first) == GJK_OK);
  CHECK(gjk_scene_remove(&scene, first) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_add(&scene, &s, &second) == GJK_OK);
  CHECK(second.slot == first.slot);
  CHECK(gjk_scene_move(&scene, first, &identity) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_move(&scene, second, &identity) == GJK_OK);
  gjk_body_id at;
  CHECK(gjk_scene_body_at(&scene, 0, &at) == GJK_OK);
  CHECK(at.generation == second.generation);
  CHECK(gjk_scene_body_at(&scene, 1, &at) == GJK_OK);
  CHECK(at.generation == 0);
  CHECK(gjk_scene_body_at(&scene, 4, &at) == GJK_ERROR_RANGE);
}

static void check_pools(void) {
  const gjk_part plain = {0, false, GJK_POSE_IDENTITY}, placed = {1, true, GJK_POSE_IDENTITY};
  const gjk_part three[3] = {plain, plain, plain};
  gjk_body_id bodies[4], extra = nobody;
  for (int pool = 0; pool < 3; pool++) {  // bodies, parts, own poses
    start(&usual);
    const int fit = pool == 0 ? 4 : 2;
    extra = nobody;
    const gjk_body_setup s = pool == 1 ? setup_of(three, 3, 0) : setup_of(pool == 0 ? &plain : &placed, 1, 0);
    for (int i = 0; i < fit; i++) {
      CHECK(gjk_scene_add(&scene, &s, &bodies[i]) == GJK_OK);
    }
    const uint64_t before = scene_hash(&scene);
    CHECK(gjk_scene_add(&scene, &s, &extra) == GJK_ERROR_CAPACITY);
    CHECK(extra.generation == 0);
    CHECK(scene_hash(&scene) == before);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
    CHECK(gjk_scene_remove(&scene, bodies[1]) == GJK_OK);
    CHECK(gjk_scene_add(&scene, &s, &extra) == GJK_OK);
    CHECK(extra.slot == 1);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
  }
}

// Four crates in one place are six pairs, of which three fit.
static void check_pair_pool(void) {
  const gjk_part plain = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup s = setup_of(&plain, 1, 0);
  gjk_body_id bodies[4];
  gjk_report reports[8];
  gjk_progress progress;
  start(&usual);
  for (int i = 0; i < 4; i++) {
    CHECK(gjk_scene_add(&scene, &s, &bodies[i]) == GJK_OK);
  }
  const uint64_t before = scene_hash(&scene);
  for (int i = 0; i < 3; i++) {
    CHECK(update(reports, 8, &progress) == GJK_ERROR_CAPACITY);
    CHECK(scene_hash(&scene) == before);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
  }
  gjk_pose away = identity;
  away.position.x = GJK_Q16(9);
  CHECK(gjk_scene_move(&scene, bodies[3], &away) == GJK_OK);
  CHECK(update(reports, 8, &progress) == GJK_OK);
  CHECK(progress.reports == 3);
  // All move on together: as many pairs as before, and none of them begins or ends.
  for (int i = 0; i < 3; i++) {
    away.position.x = GJK_Q16(-9);
    CHECK(gjk_scene_move(&scene, bodies[i], &away) == GJK_OK);
  }
  CHECK(update(reports, 8, &progress) == GJK_OK);
  CHECK(progress.reports == 0);
  // Ends of removed bodies keep their records until they are reported.
  CHECK(gjk_scene_remove(&scene, bodies[0]) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(update(reports, 1, &progress) == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(progress.reports_left == 1);
  CHECK(reports[0].event == GJK_EVENT_END);
  CHECK(reports[0].a.slot == 0);
  CHECK(reports[0].a.generation == 1);
  CHECK(reports[0].b.slot == 1);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(update(reports, 1, &progress) == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(progress.reports_left == 0);
  CHECK(reports[0].event == GJK_EVENT_END);
  CHECK(reports[0].b.slot == 2);
}

static void check_busy(void) {
  const gjk_part plain = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup s = setup_of(&plain, 1, 0);
  gjk_body_id a, b, c;
  gjk_report report;
  gjk_progress progress;
  uint32_t pairs;
  uint64_t value;
  start(&usual);
  CHECK(gjk_scene_add(&scene, &s, &a) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &s, &b) == GJK_OK);
  CHECK(gjk_scene_test_pairs(&scene, 0, 0) == GJK_ERROR_RANGE);
  for (int phase = 0; phase < 2; phase++) {  // testing, reporting
    if (phase == 0) {
      CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
      CHECK(pairs == 1);
      CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
      CHECK(pairs == 1);
      CHECK(gjk_scene_test_pairs(&scene, 0, 2) == GJK_ERROR_RANGE);
      CHECK(gjk_scene_test_pairs(&scene, 1, 0) == GJK_ERROR_RANGE);
      CHECK(gjk_scene_test_pairs(&scene, 0, 0) == GJK_OK);
      CHECK(gjk_scene_test_pairs(&scene, 1, 1) == GJK_OK);
    } else {
      for (int again = 0; again < 2; again++) {
        memset(&progress, 0xA5, sizeof progress);
        CHECK(update(NULL, 0, &progress) == GJK_OK);
        CHECK(progress.reports == 0);
        CHECK(progress.reports_left == 1);
        CHECK(progress.pairs_left == 0);
      }
      CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_ERROR_BUSY);
    }
    CHECK(gjk_scene_add(&scene, &s, &c) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_remove(&scene, a) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_move(&scene, a, &identity) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_sleep(&scene, a) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_set_shape(&scene, a, 0, 1) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_refilter(&scene, a) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_hash(&scene, &value) == GJK_ERROR_BUSY);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
  }
  CHECK(update(NULL, 1, &progress) == GJK_ERROR_NULL);
  CHECK(update(&report, 1, NULL) == GJK_ERROR_NULL);
  CHECK(update(&report, 1, &progress) == GJK_OK);
  CHECK(progress.reports == 1);
  CHECK(report.event == GJK_EVENT_BEGIN);
  CHECK(gjk_scene_remove(&scene, a) == GJK_OK);
}

static void check_foreign(void) {
  const gjk_scene nothing = {0};
  gjk_scene_stats stats;
  start(&usual);
  CHECK(gjk_scene_get_stats(&nothing, &stats) == GJK_ERROR_NULL);
  CHECK(gjk_scene_get_stats(&scene, NULL) == GJK_ERROR_NULL);
  block[0] ^= 1;
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_ERROR_CORRUPT);
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  block[0] ^= 1;
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK);
}

// What a scene holds about a body is what it was given, and then what was changed, field by field.
static void check_state(void) {
  const gjk_part parts[2] = {{0, false, GJK_POSE_IDENTITY}, {1, true, {{65536, 0, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  gjk_body_setup s = {{{1, 2, 3}, {0, GJK_Q30_ONE, 0, 0}}, parts, 2, GJK_BODY_DYNAMIC, GJK_DETAIL_DISTANCE, 4, 5, 6, 7};
  gjk_body_id body;
  gjk_body_state state;
  start(&usual);
  memset(&state, 0x5A, sizeof state);
  CHECK(gjk_scene_add(&scene, &s, &body) == GJK_OK);
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  CHECK(memcmp(&state.pose, &s.pose, sizeof s.pose) == 0);
  CHECK(state.category == 4);
  CHECK(state.mask == 5);
  CHECK(state.user == 6);
  CHECK(state.margin == 7);
  CHECK(state.part_count == 2);
  CHECK(state.kind == GJK_BODY_DYNAMIC);
  CHECK(!state.asleep);
  CHECK(state.detail == GJK_DETAIL_DISTANCE);
  CHECK(gjk_scene_set_filter(&scene, body, 8, 9) == GJK_OK);
  CHECK(gjk_scene_set_user(&scene, body, 10) == GJK_OK);
  CHECK(gjk_scene_sleep(&scene, body) == GJK_OK);
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  CHECK(state.category == 8);
  CHECK(state.mask == 9);
  CHECK(state.user == 10);
  CHECK(state.asleep);
  CHECK(gjk_scene_wake(&scene, body) == GJK_OK);
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  CHECK(!state.asleep);
  CHECK(gjk_scene_sleep(&scene, body) == GJK_OK);
  CHECK(gjk_scene_move(&scene, body, &s.pose) == GJK_OK);
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  CHECK(!state.asleep);  // moved to where it is
  s.pose.position.y++;
  CHECK(gjk_scene_sleep(&scene, body) == GJK_OK);
  CHECK(gjk_scene_move(&scene, body, &s.pose) == GJK_OK);
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  CHECK(!state.asleep);
  CHECK(state.pose.position.y == 3);
  for (uint8_t kind = GJK_BODY_STATIC; kind < GJK_BODY_DYNAMIC; kind++) {
    s.kind = kind;
    start(&usual);
    CHECK(gjk_scene_add(&scene, &s, &body) == GJK_OK);
    CHECK(gjk_scene_sleep(&scene, body) == GJK_ERROR_RANGE);
    CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
    CHECK(state.kind == kind);
    CHECK(!state.asleep);
  }
}

static void count_report(void *user, const gjk_report *report) {
  ++*(int *)user;
  (void)report;
}

// Every call says NULL for a pointer that is missing, and CORRUPT for a block that is none, and changes nothing.
static void check_missing(void) {
  const gjk_part plain = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup s = setup_of(&plain, 1, 0);
  gjk_scene unbound, bare;
  gjk_body_id body, out = nobody;
  gjk_body_state state;
  gjk_collider collider;
  gjk_report report;
  gjk_progress progress;
  gjk_scene_stats stats;
  uint64_t value;
  uint32_t n = 0;
  int calls = 0;
  bool found;
  start(&usual);
  CHECK(gjk_scene_add(&scene, &s, &body) == GJK_OK);
  const uint64_t before = scene_hash(&scene);
  unbound = scene;
  unbound.block = NULL;
  bare = scene;
  bare.shapes = NULL;
  // The magic word, the version and the byte order.
  const uint32_t wrong[3] = {1, 1, UINT32_C(0x05030305)};
  for (int i = 0; i < 6; i++) {
    gjk_scene *const bad = i == 0 ? NULL : i == 1 ? &unbound : i == 2 ? &bare : &scene;
    const gjk_status status = i < 3 ? GJK_ERROR_NULL : GJK_ERROR_CORRUPT;
    if (i >= 3) {
      block[i - 3] ^= wrong[i - 3];
    }
    CHECK(gjk_scene_add(bad, &s, &out) == status);
    CHECK(gjk_scene_add_at(bad, 1, &s, &out) == status);
    CHECK(gjk_scene_remove(bad, body) == status);
    CHECK(gjk_scene_move(bad, body, &identity) == status);
    CHECK(gjk_scene_teleport(bad, body, &identity) == status);
    CHECK(gjk_scene_sleep(bad, body) == status);
    CHECK(gjk_scene_wake(bad, body) == status);
    CHECK(gjk_scene_set_shape(bad, body, 0, 1) == status);
    CHECK(gjk_scene_set_filter(bad, body, 5, 5) == status);
    CHECK(gjk_scene_set_user(bad, body, 5) == status);
    CHECK(gjk_scene_refilter(bad, body) == status);
    CHECK(gjk_scene_get(bad, body, &state) == status);
    CHECK(gjk_scene_body_at(bad, 0, &out) == status);
    CHECK(gjk_scene_collider(bad, body, 0, &collider) == status);
    CHECK(gjk_scene_update(bad, &report, 1, &progress) == status);
    CHECK(gjk_scene_update_begin(bad, &n) == status);
    CHECK(gjk_scene_update_each(bad, count_report, &calls) == status);
    CHECK(gjk_scene_test_pairs(bad, 0, 0) == status);
    CHECK(gjk_scene_next_near(bad, &n, &report, &found) == status);
    CHECK(gjk_scene_get_stats(bad, &stats) == status);
    CHECK(gjk_scene_hash(bad, &value) == status);
    CHECK(gjk_scene_seal(bad) == status);
    CHECK(gjk_scene_check(bad) == status);
    if (i >= 3) {
      block[i - 3] ^= wrong[i - 3];
    }
  }
  CHECK(gjk_scene_add_at(&scene, 1, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk_scene_add_at(&scene, 1, &s, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_body_at(&scene, 0, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_collider(&scene, body, 0, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_collider(&scene, nobody, 0, &collider) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_get(&scene, nobody, &state) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_sleep(&scene, nobody) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_wake(&scene, nobody) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_set_user(&scene, nobody, 1) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_set_filter(&scene, nobody, 1, 1) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_refilter(&scene, nobody) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_set_shape(&scene, nobody, 0, 0) == GJK_ERROR_BODY_ID);
  CHECK(gjk_scene_update_each(&scene, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_update_begin(&scene, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_next_near(&scene, NULL, &report, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_next_near(&scene, &n, NULL, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_next_near(&scene, &n, &report, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_hash(&scene, NULL) == GJK_ERROR_NULL);
  CHECK(scene_hash(&scene) == before);
  CHECK(calls == 0);
  // Attaching.
  const size_t bytes = gjk_scene_bytes(&usual);
  gjk_scene other = bare;
  CHECK(gjk_scene_attach(NULL, block, bytes, shapes, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_attach(&other, NULL, bytes, shapes, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_attach(&other, block, bytes, NULL, 4, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_attach(&other, (char *)block + 2, bytes, shapes, 4, NULL) == GJK_ERROR_RANGE);
  CHECK(other.shapes == NULL);
  CHECK(gjk_scene_attach(&other, block, bytes, shapes, 4, NULL) == GJK_OK);
  CHECK(other.shapes == shapes);
  CHECK(other.block == block);
  CHECK(other.shape_count == 4);
  CHECK(other.bindings.predicate == NULL);
  CHECK(other.bindings.details == NULL);
  CHECK(other.bindings.manifolds == NULL);
  CHECK(block[1] == GJK_SCENE_BLOCK_VERSION);
  // Bindings are copied, also from the handle itself.
  const gjk_scene_bindings given = {.user = &n, .details = &gjk_scene_contacts};
  CHECK(gjk_scene_attach(&other, block, bytes, shapes, 4, &given) == GJK_OK);
  CHECK(other.bindings.user == &n);
  CHECK(other.bindings.details == &gjk_scene_contacts);
  CHECK(gjk_scene_attach(&other, block, bytes, shapes, 4, &other.bindings) == GJK_OK);
  CHECK(other.bindings.user == &n);
  CHECK(other.bindings.details == &gjk_scene_contacts);
  CHECK(gjk_scene_attach(&other, block, bytes, shapes, 4, NULL) == GJK_OK);
  CHECK(other.bindings.user == NULL);
  CHECK(gjk_scene_open(NULL, block, bytes, shapes, 4, NULL) == GJK_ERROR_NULL);
}

// The block may come from the port's allocator.
static void check_allocated(void) {
  const size_t bytes = gjk_scene_bytes(&usual);
  void *memory = gjk_port_allocate(bytes);
  CHECK(memory != NULL);
  CHECK(gjk_scene_init(&scene, &usual, memory, bytes, shapes, 4, NULL) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  gjk_port_release(memory);
}

int main(void) {
  check_configurations();
  check_bad_setups();
  check_bad_changes();
  check_handles();
  check_pools();
  check_pair_pool();
  check_busy();
  check_foreign();
  check_missing();
  check_state();
  check_allocated();
  return check_done("scene_status");
}
