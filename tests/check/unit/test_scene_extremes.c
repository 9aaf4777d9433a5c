// Scenes at their limits: slots that are used up, tens of thousands of parts, hulls beyond the numbers that a pair keeps,
// bodies farther apart than a plane is tried for, half turns, opposite quaternions; what a pair that is gone says.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "random.h"
#include "scene_bodies.h"
#include "src/scene/gjk_scene_block.h"

#define ONE GJK_Q16_ONE
#define WORDS 6000
#define CORNERS 300
#define PARTS 33000

static gjk_vec3 corners[CORNERS];
static const gjk_shape crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2), bar = GJK_BOX(4 * ONE, ONE / 8, ONE / 8);
static const gjk_shape round_hull = GJK_HULL(corners, CORNERS);
static const gjk_shape walls[3] = {GJK_BOX(2 * ONE, INT32_C(1) << 27, 2 * ONE),
                                   GJK_BOX(2 * ONE, 2 * ONE, INT32_C(1) << 27),
                                   GJK_BOX(INT32_C(1) << 27, 2 * ONE, 2 * ONE)};
static const gjk_shape ball = GJK_SPHERE(ONE / 2);
static const gjk_shape *const shapes[] = {&crate, &bar, &walls[0], &round_hull, &walls[1], &walls[2], &ball};
static const gjk_scene_config usual = {4, 4, 0, 6, GJK_Q16(0.1), GJK_DETAIL_DISTANCE, 0, 0, 0, 0, 0};

static uint32_t block[WORDS];
static gjk_scene scene;

static void start(const gjk_scene_config *config) {
  CHECK(gjk_scene_init(&scene, config, block, sizeof block, shapes, 7, NULL) == GJK_OK);
}

// The axis that bodies are put along; the next one is y.
static int first_axis;

static gjk_vec3 position_of(gjk_q16 x, gjk_q16 y) {
  const gjk_vec3 at[3] = {{x, y, 0}, {0, x, y}, {y, 0, x}};
  return at[first_axis];
}

static gjk_body_id add(uint16_t shape, gjk_q16 x, gjk_q16 y, gjk_q16 margin) {
  const gjk_part part = {shape, false, GJK_POSE_IDENTITY};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, margin};
  gjk_body_id body = {0, 0};
  setup.pose.position = position_of(x, y);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  return body;
}

static void move(gjk_body_id body, gjk_q16 x, gjk_q16 y) {
  gjk_body_state state;
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  state.pose.position = position_of(x, y);
  CHECK(gjk_scene_teleport(&scene, body, &state.pose) == GJK_OK);
}

static gjk_scene_stats update(gjk_report *reports, uint32_t *count) {
  gjk_scene_stats stats = {0};
  *count = scene_update(&scene, reports, 8);
  CHECK(gjk_scene_get_stats(&scene, &stats) == GJK_OK);
  return stats;
}

// The last generation of a slot is not followed by the first one: it stays empty.
static void test_used_up_slot(void) {
  start(&usual);
  gjk_body_id body = add(0, 0, 0, 0);
  CHECK(body.slot == 0);
  gjk_scene_body *const record =
      (gjk_scene_body *)(void *)((char *)block + ((gjk_scene_header *)(void *)block)->bodies.at);
  record->generation = UINT32_MAX;
  CHECK(gjk_scene_remove(&scene, body) == GJK_ERROR_BODY_ID);
  body.generation = UINT32_MAX;
  CHECK(gjk_scene_remove(&scene, body) == GJK_OK);
  CHECK(record->generation == 0);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  const uint64_t before = scene_hash(&scene);
  CHECK(gjk_scene_remove(&scene, body) == GJK_ERROR_BODY_ID);
  const gjk_body_id next = add(0, 0, 0, 0);
  CHECK(next.slot == 1);
  CHECK(next.generation == 1);
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  CHECK(gjk_scene_add_at(&scene, 0, &setup, &body) == GJK_ERROR_BODY_ID);
  CHECK(scene_hash(&scene) != before);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  CHECK(body.slot == 2);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  CHECK(body.slot == 3);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_ERROR_CAPACITY);
}

// The README's figures: a body with one shape takes 244 bytes and a bit of its slot, a pair 48.
static void test_sizes(void) {
  const gjk_scene_config few = {.bodies = 1000, .parts = 1000, .pairs = 1000};
  gjk_scene_config more = few;
  more.bodies = more.parts = 2000;
  CHECK(gjk_scene_bytes(&more) - gjk_scene_bytes(&few) > 244000);
  CHECK(gjk_scene_bytes(&more) - gjk_scene_bytes(&few) <= 245000);
  more = few;
  more.pairs = 2000;
  CHECK(gjk_scene_bytes(&more) - gjk_scene_bytes(&few) == 48000);
}

// Part numbers go up to 65535, also in the report of a pair that is gone.
static void test_many_parts(void) {
  static const gjk_scene_config large = {2, PARTS + 1, PARTS, 4, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  const size_t bytes = gjk_scene_bytes(&large);
  void *memory = malloc(bytes);
  gjk_part *parts = malloc(PARTS * sizeof *parts);
  gjk_body_id many, one;
  gjk_report reports[8];
  uint32_t count;
  for (int i = 0; i < PARTS; i++) {
    const gjk_part part = {0, true, GJK_POSE_IDENTITY};
    parts[i] = part;
    parts[i].pose.position.x = 8000 * (i % 1000);
    parts[i].pose.position.y = 8000 * (i / 1000);
  }
  parts[32767].pose.position.z = 10 * ONE;
  parts[32768].pose.position.z = 20 * ONE;
  CHECK(gjk_scene_init(&scene, &large, memory, bytes, shapes, 4, NULL) == GJK_OK);
  gjk_body_setup setup = {GJK_POSE_IDENTITY, parts, PARTS, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  CHECK(gjk_scene_add(&scene, &setup, &many) == GJK_OK);
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  setup.parts = &part;
  setup.part_count = 1;
  setup.pose.position.x = 8000 * 767;
  setup.pose.position.y = 8000 * 32;
  setup.pose.position.z = 10 * ONE;
  for (int near = 32767; near <= 32768; near++) {
    setup.pose.position.x = parts[near].pose.position.x;
    setup.pose.position.z = parts[near].pose.position.z;
    CHECK(gjk_scene_add(&scene, &setup, &one) == GJK_OK);
    update(reports, &count);
    CHECK(count == 1);
    CHECK(reports[0].event == GJK_EVENT_BEGIN);
    CHECK(reports[0].part_a == near);
    CHECK(reports[0].part_b == 0);
    CHECK(gjk_scene_remove(&scene, one) == GJK_OK);
    update(reports, &count);
    CHECK(count == 1);
    CHECK(reports[0].event == GJK_EVENT_END);
    CHECK(reports[0].part_a == near);
    CHECK(reports[0].part_b == 0);
    CHECK(reports[0].b.generation == one.generation);
  }
  free(parts);
  free(memory);
}

// A pair keeps vertices below 256 alone; what it asks from others is the same.
static void test_large_hulls(void) {
  for (int i = 0; i < CORNERS; i++) {  // a tower whose far corners come last
    corners[i].x = i % 2 == 0 ? -ONE : ONE;
    corners[i].y = i / 2 % 2 == 0 ? -ONE : ONE;
    corners[i].z = i * 100;
  }
  // The last ones reach out to -x and +x.
  corners[298].x = -3 * ONE;
  corners[299].x = 3 * ONE;
  gjk_report reports[8];
  uint32_t count;
  for (int side = 0; side < 4; side++) {  // which of the two is a hull with far corners
    start(&usual);
    const gjk_body_id a = add(side % 2 != 0 ? 3 : 0, 0, 0, ONE), b = add(side / 2 != 0 ? 3 : 0, 8 * ONE, 0, ONE);
    gjk_collider one, two;
    gjk_distance_result r;
    gjk_decision d;
    for (int step = 0; step < 40; step++) {
      move(b, 8 * ONE - step * 7001, step * 100);
      update(reports, &count);
      CHECK(gjk_scene_collider(&scene, a, 0, &one) == GJK_OK);
      CHECK(gjk_scene_collider(&scene, b, 0, &two) == GJK_OK);
      CHECK(gjk_distance(&one, &two, NULL, &r) == GJK_OK);
      CHECK(gjk_within(&one, &two, 2 * ONE, NULL, &d) == GJK_OK);
      uint32_t cursor = 0;
      gjk_report near;
      bool found;
      CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK);
      CHECK(found == d.yes);
      CHECK(!found || near.distance == r.distance);
    }
  }
}

// Margins that reach so far that centres are more than 2^29 apart along an axis: no plane is tried there. The boxes'
// gaps are within the margins along each axis, the bounding spheres meet.
static void test_far_apart(void) {
  const gjk_q16 x = (INT32_C(1) << 29) + 1, y = INT32_C(3) << 27, left = -x / 2, low = -y / 2;
  gjk_scene_config config = usual;
  gjk_report reports[8];
  uint32_t count;
  config.detail = GJK_DETAIL_TOUCH;
  for (int i = 0; i < 6; i++) {
    const int n = i % 2;
    start(&config);
    first_axis = i / 2;
    const uint16_t wall = (uint16_t)(first_axis == 0 ? 2 : 3 + first_axis);
    const gjk_body_id a = add(wall, left, low, GJK_RADIUS_MAX), b = add(wall, left + x - n, low + y, GJK_RADIUS_MAX);
    gjk_scene_stats stats = update(reports, &count);
    CHECK(count == 0);
    CHECK(stats.cold == 1);
    move(b, left + x - n, low + y - 1);
    stats = update(reports, &count);
    CHECK(count == 0);
    CHECK(stats.warm == 1);  // no gap is known
    move(a, left + 2, low);
    stats = update(reports, &count);
    CHECK(count == 0);
    CHECK(stats.direction == 1);  // now the last direction settles it
    move(b, left + x + n, low);
    update(reports, &count);
    CHECK(count == 1);
    CHECK(reports[0].event == GJK_EVENT_BEGIN);
    // Near by about 2^17: the query tells that, unless the centres are too far apart. Then the spheres inside tell it.
    move(b, left + x + n, low + 1);
    stats = update(reports, &count);
    CHECK(count == 0);
    CHECK((n == 0 ? stats.motion : stats.boxes) == 1);
  }
  first_axis = 0;
}

static void turn(gjk_body_id body, gjk_quat rotation) {
  gjk_body_state state;
  CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
  state.pose.rotation = rotation;
  CHECK(gjk_scene_move(&scene, body, &state.pose) == GJK_OK);
}

// How far a turn moves points: by opposite quaternions no farther than by equal ones; by a half turn, anywhere.
static void test_turns(void) {
  gjk_report reports[8];
  uint32_t count;
  const gjk_vec3 axis = {0, 0, ONE};
  gjk_quat little, quarter, half;
  CHECK(gjk_quat_from_axis_angle(&axis, 1, &little) == GJK_OK);
  CHECK(gjk_quat_from_axis_angle(&axis, GJK_ANGLE(1.5707963), &quarter) == GJK_OK);
  CHECK(gjk_quat_from_axis_angle(&axis, GJK_ANGLE(3.1415927), &half) == GJK_OK);
  const gjk_quat opposite = {-little.x, -little.y, -little.z, -little.w}, *const turns[] = {&little, &opposite};
  for (int i = 0; i < 2; i++) {
    start(&usual);
    add(0, 0, GJK_Q16(2.675), 2 * ONE);
    const gjk_body_id b = add(1, 0, 0, 0);  // 2.05 below a box with a margin of 2
    CHECK(update(reports, &count).boxes == 1);
    CHECK(count == 0);
    turn(b, *turns[i]);
    CHECK(update(reports, &count).motion == 1);
    CHECK(count == 0);
  }
  // About any axis, from any rotation.
  const gjk_quat generic[2] = {{GJK_Q30_ONE / 2, GJK_Q30_ONE / 2, GJK_Q30_ONE / 2, GJK_Q30_ONE / 2},
                               {-GJK_Q30_ONE / 2, GJK_Q30_ONE / 2, -GJK_Q30_ONE / 2, GJK_Q30_ONE / 2}};
  for (int i = 0; i < 8; i++) {
    start(&usual);
    add(0, 0, 6 * ONE, GJK_Q16(1.4));
    const gjk_body_id b = add(1, 0, 0, 0);  // at most 4.01 long
    turn(b, generic[i % 2]);
    CHECK(update(reports, &count).boxes == 1);
    CHECK(count == 0);
    gjk_quat next = generic[i % 2];
    gjk_q30 *const component[4] = {&next.x, &next.y, &next.z, &next.w};
    *component[i / 2] += 300;
    *component[(i / 2 + 1) % 4] += (*component[i / 2] > 0) == (*component[(i / 2 + 1) % 4] > 0) ? -300 : 300;
    turn(b, next);
    CHECK(update(reports, &count).motion == 1);
    CHECK(count == 0);
  }
  // The opposite of nearly the same rotation is nearly the same, whatever the signs of its components.
  static const gjk_scene_config roomy = {4, 4, 0, 6, 8 * ONE, GJK_DETAIL_DISTANCE, 0, 0, 0, 0, 0};
  random_state random = random_seed(check_seed(41));
  for (int i = 0; i < 500; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    gjk_quat q = {random_range(&random, -9, 9), random_range(&random, -9, 9), random_range(&random, -9, 9),
                  random_range(&random, -9, 9)};
    if (gjk_quat_normalize(&q, &q) != GJK_OK) {
      continue;
    }
    start(&roomy);
    add(0, 0, 6 * ONE, GJK_Q16(1.4));
    const gjk_body_id b = add(1, 0, 0, 0);
    turn(b, q);
    CHECK(update(reports, &count).boxes == 1);
    CHECK(count == 0);
    const gjk_quat near = {q.x + 50, q.y - 40, q.z + 30, q.w - 20}, far = {-near.x, -near.y, -near.z, -near.w};
    turn(b, i % 2 != 0 ? near : far);
    CHECK(update(reports, &count).motion == 1);
    CHECK(count == 0);
    // Other than by a turn of more than the gap.
    gjk_quat other = {q.w, q.z, -q.y, -q.x};  // at a right angle to q: a half turn from it
    turn(b, other);
    CHECK(update(reports, &count).motion == 0);
    CHECK(count == 0);
  }
  // The bar reaches across the crate's margin when it stands upright, and does not when it has turned by a half.
  start(&usual);
  add(0, 0, GJK_Q16(2.675), 2 * ONE);
  const gjk_body_id b = add(1, 0, 0, 0);
  update(reports, &count);
  turn(b, half);
  gjk_scene_stats stats = update(reports, &count);
  CHECK(count == 0);
  CHECK(stats.boxes == 1);
  turn(b, quarter);
  update(reports, &count);
  CHECK(count == 1);
  CHECK(reports[0].event == GJK_EVENT_BEGIN);
}

// A body that moves along one axis alone has moved.
static void test_one_axis(void) {
  start(&usual);
  const gjk_body_id body = add(0, 0, 0, 0);
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_q16 *const field[7] = {&pose.position.x, &pose.position.y, &pose.position.z, &pose.rotation.x,
                             &pose.rotation.y, &pose.rotation.z, &pose.rotation.w};
  for (int i = 0; i < 7; i++) {
    gjk_body_state state;
    *field[i] += i < 3 ? 5 : 1;
    CHECK(gjk_scene_move(&scene, body, &pose) == GJK_OK);
    CHECK(gjk_scene_get(&scene, body, &state) == GJK_OK);
    CHECK(memcmp(&state.pose, &pose, sizeof pose) == 0);
  }
}

// Pairs of a removed body until their end is reported.
static void test_gone(void) {
  gjk_report reports[8], near;
  uint32_t count, cursor = 0;
  bool found;
  start(&usual);
  const gjk_body_id a = add(0, 0, 0, ONE), b = add(0, 2 * ONE, 0, 0);
  update(reports, &count);
  CHECK(count == 1);
  CHECK(reports[0].event == GJK_EVENT_BEGIN);
  CHECK(reports[0].distance == ONE);
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK);
  CHECK(found);
  CHECK(near.event == GJK_EVENT_PERSIST);
  CHECK(near.distance == ONE);
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK);
  CHECK(!found);
  CHECK(gjk_scene_remove(&scene, b) == GJK_OK);
  cursor = 0;
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK);
  CHECK(found);
  CHECK(near.event == GJK_EVENT_END);
  CHECK(near.distance == 0);
  CHECK(near.a.slot == a.slot);
  CHECK(near.a.generation == a.generation);
  CHECK(near.b.slot == b.slot);
  CHECK(near.b.generation == b.generation);
  CHECK(near.detail == GJK_DETAIL_DISTANCE);
  update(reports, &count);
  CHECK(count == 1);
  CHECK(reports[0].event == GJK_EVENT_END);
  CHECK(reports[0].distance == 0);
  cursor = 0;
  CHECK(gjk_scene_next_near(&scene, &cursor, &near, &found) == GJK_OK);
  CHECK(!found);
}

// Near pairs are looked for among the records there are: what lies beyond the last one is none, whatever it holds.
static void test_near_pairs_alone(void) {
  static const gjk_scene_config one_pair = {2, 2, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  gjk_report reports[8];
  uint32_t count, cursor = 0;
  bool found;
  memset(block, 0xFF, sizeof block);
  start(&one_pair);
  add(0, 0, 0, 0);
  add(0, ONE / 2, 0, 0);
  update(reports, &count);
  CHECK(gjk_scene_next_near(&scene, &cursor, reports, &found) == GJK_OK);
  CHECK(found);
  CHECK(gjk_scene_next_near(&scene, &cursor, reports, &found) == GJK_OK);
  CHECK(!found);
}

// Two balls whose boxes meet at the corners: the spheres tell, without a query.
static void test_spheres(void) {
  gjk_report reports[8];
  uint32_t count;
  start(&usual);
  add(6, 0, 0, 0);
  add(6, GJK_Q16(0.8), GJK_Q16(0.8), 0);
  const gjk_scene_stats stats = update(reports, &count);
  CHECK(count == 0);
  CHECK(stats.boxes == 1);
}

static void count_report(void *user, const gjk_report *report) {
  ++*(int *)user;
  (void)report;
}

// An update without reports calls nobody, one with some each time.
static void test_each(void) {
  int calls = 0;
  start(&usual);
  CHECK(gjk_scene_update_each(&scene, count_report, &calls) == GJK_OK);
  CHECK(calls == 0);
  for (int i = 0; i < 4; i++) {
    add(0, 0, 0, 0);
  }
  CHECK(gjk_scene_update_each(&scene, count_report, &calls) == GJK_OK);
  CHECK(calls == 6);
  CHECK(gjk_scene_update_each(&scene, count_report, &calls) == GJK_OK);
  CHECK(calls == 6);
}

// Pairs that were tested are not tested again.
static bool count_call(void *user, gjk_body_id a, uint32_t user_a, gjk_body_id b, uint32_t user_b) {
  ++*(int *)user;
  (void)a, (void)b, (void)user_a, (void)user_b;
  return true;
}

static void test_tested_once(void) {
  gjk_report reports[8];
  uint32_t count, pairs;
  int calls = 0;
  const gjk_scene_bindings counting = {.predicate = count_call, .user = &calls};
  start(&usual);
  CHECK(gjk_scene_attach(&scene, block, sizeof block, shapes, 7, &counting) == GJK_OK);
  add(0, 0, 0, 0);
  add(0, 0, 0, 0);
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(pairs == 1);
  CHECK(gjk_scene_test_pairs(&scene, 0, 1) == GJK_OK);
  CHECK(calls == 1);
  CHECK(gjk_scene_test_pairs(&scene, 0, 1) == GJK_OK);
  CHECK(calls == 1);
  update(reports, &count);
  CHECK(calls == 1);
  CHECK(count == 1);
}

int main(void) {
  test_used_up_slot();
  test_sizes();
  test_many_parts();
  test_large_hulls();
  test_far_apart();
  test_turns();
  test_one_axis();
  test_gone();
  test_near_pairs_alone();
  test_spheres();
  test_each();
  test_tested_once();
  return check_done("scene_extremes");
}
