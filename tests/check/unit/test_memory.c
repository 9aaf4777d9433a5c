// Answers depend on the arguments alone. The contents of the stack, results and colliders before a call do not change a
// byte of them.
#include <string.h>

#include "case/case.h"
#include "check.h"
#include "gjk/gjk.h"
#include "gjk/scene.h"
#include "parts_answers.h"
#include "random.h"

#define ONE GJK_Q16_ONE
#define PLACES 12
#define CELLS GJK_EPA_CELLS(512)
#define SHAPES ((int)(sizeof shapes / sizeof shapes[0]))

static const gjk_vec3 corner[12] = {{-ONE, -ONE, -ONE}, {ONE, -ONE, -ONE}, {-ONE, ONE, -ONE}, {ONE, ONE, -ONE},
                                    {-ONE, -ONE, ONE},  {ONE, -ONE, ONE},  {-ONE, ONE, ONE},  {ONE, ONE, ONE},
                                    {2 * ONE, 7, 9},    {-2 * ONE, 3, 1},  {5, 2 * ONE, 99},  {50, 60, -2 * ONE}};
static const uint16_t cube_corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const uint16_t cube_ends[6] = {4, 8, 12, 16, 20, 24};
static const gjk_hull_faces cube_faces = {cube_corners, cube_ends, 6};
static const gjk_shape shapes[] = {GJK_POINT,
                                   GJK_SPHERE(ONE / 2),
                                   GJK_SEGMENT(ONE),
                                   GJK_CAPSULE(ONE / 3, ONE),
                                   GJK_TRIANGLE(corner),
                                   GJK_BOX(ONE, ONE / 2, ONE / 3),
                                   GJK_ROUNDED_BOX(ONE, ONE / 2, ONE / 3, 1000),
                                   GJK_HULL(corner, 12),
                                   GJK_HULL_WITH_FACES(corner, 8, &cube_faces),
                                   GJK_CYLINDER(ONE / 2, ONE),
                                   GJK_CONE(ONE / 2, ONE),
                                   GJK_ELLIPSOID(ONE, ONE / 2, ONE / 3)};

// All answers about a pair.
typedef struct answers {
  gjk_collider a, b;
  gjk_status status[10];
  gjk_decision touch, near;
  gjk_within_result within;
  gjk_distance_result distance, until, apart;
  gjk_penetration_result depth;
  gjk_manifold contacts;
  gjk_aabb bounds;
  gjk_cache cache;
} answers;

// Fills the stack that the next calls will use.
static void fill_stack(uint8_t pattern) {
  volatile uint8_t area[12000];
  for (unsigned i = 0; i < sizeof area; i++) {
    area[i] = pattern;
  }
}

static void (*volatile fill)(uint8_t) = fill_stack;

static void ask(const gjk_shape *a, const gjk_pose *at_a, const gjk_shape *b, const gjk_pose *at_b, uint8_t stack,
                answers *out) {
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  const gjk_effort effort = {2, 100};
  memset(cells, stack, sizeof cells);
  fill(stack);
  CHECK(gjk_collider_init(&out->a, a, NULL, 0) == GJK_OK);
  fill(stack);
  CHECK(gjk_collider_pose(&out->a, at_a) == GJK_OK);
  fill(stack);
  CHECK(gjk_collider_init(&out->b, b, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&out->b, at_b) == GJK_OK);
  fill(stack);
  out->status[0] = gjk_intersect(&out->a, &out->b, &out->cache, &out->touch);
  fill(stack);
  out->status[1] = gjk_within(&out->a, &out->b, 9000, &out->cache, &out->near);
  fill(stack);
  out->status[2] = gjk_distance(&out->a, &out->b, &out->cache, &out->distance);
  fill(stack);
  out->status[3] = gjk_distance_until(&out->a, &out->b, &effort, &out->cache, &out->until);
  fill(stack);
  out->status[4] = gjk_penetration(&out->a, &out->b, &out->cache, &workspace, &out->depth);
  fill(stack);
  out->status[5] = gjk_signed_distance(&out->a, &out->b, NULL, &workspace, &out->apart);
  fill(stack);
  out->status[6] = gjk_contacts(&out->a, &out->b, 9000, 4, NULL, &workspace, &out->contacts);
  fill(stack);
  out->status[7] = gjk_collider_aabb(&out->a, &out->bounds);
  fill(stack);
  out->status[8] = gjk_penetration(&out->a, &out->b, NULL, NULL, &out->depth);
  fill(stack);
  out->status[9] = gjk_within_until(&out->a, &out->b, 9000, 2, NULL, &out->within);
}

// set: whether points and normal are set.
static bool same_bounds(const gjk_distance_result *a, const gjk_distance_result *b, bool set) {
  return a->distance == b->distance && a->lower == b->lower && a->upper == b->upper &&
         a->intersecting == b->intersecting && a->saturated == b->saturated && a->iterations == b->iterations &&
         same_certificate(&a->certificate, &b->certificate) &&
         (!set || (same_vec3(&a->point_a, &b->point_a) && same_vec3(&a->point_b, &b->point_b) &&
                   same_unit3(&a->normal, &b->normal)));
}

static bool same_answers(const answers *a, const answers *b) {
  return memcmp(a->status, b->status, sizeof a->status) == 0 && memcmp(&a->cache, &b->cache, sizeof a->cache) == 0 &&
         a->within.answer == b->within.answer &&
         (a->within.answer == GJK_ANSWER_OPEN ? a->within.decision.iterations == b->within.decision.iterations
                                              : same_decision(&a->within.decision, &b->within.decision)) &&
         same_decision(&a->touch, &b->touch) && same_decision(&a->near, &b->near) &&
         same_bounds(&a->distance, &b->distance, !a->distance.intersecting) &&
         same_bounds(&a->until, &b->until, !a->until.intersecting) && same_bounds(&a->apart, &b->apart, true) &&
         same_penetration(&a->depth, &b->depth) && same_manifold(&a->contacts, &b->contacts) &&
         memcmp(&a->bounds, &b->bounds, sizeof a->bounds) == 0;
}

static void check_pair(const gjk_shape *a, const gjk_shape *b, const gjk_pose *at_a, const gjk_pose *at_b) {
  static answers first, other;
  static const uint8_t patterns[] = {0x01, 0x7F, 0xA5};
  memset(&first, 0, sizeof first);
  ask(a, at_a, b, at_b, 0, &first);
  for (unsigned i = 0; i < sizeof patterns; i++) {
    memset(&other, patterns[i], sizeof other);
    memset(&other.cache, 0, sizeof other.cache);
    ask(a, at_a, b, at_b, patterns[i], &other);
    CHECK(same_answers(&first, &other));
  }
}

static void test_pairs(void) {
  random_state random = random_seed(check_seed(15));
  static case_posed posed;
  const gjk_pose origin = GJK_POSE_IDENTITY;
  for (int a = 0; a < SHAPES; a++) {
    for (int b = 0; b < SHAPES; b++) {
      for (int i = 0; i < PLACES; i++) {
        const gjk_quat q = {random_range(&random, -9, 9), random_range(&random, -9, 9), random_range(&random, -9, 9),
                            random_range(&random, 1, 9)};
        const gjk_q16 reach = ONE >> (i % 4);
        gjk_pose pose = origin;
        if (i % 3 != 0) {
          CHECK(gjk_quat_normalize(&q, &pose.rotation) == GJK_OK);
        }
        pose.position.x = i == 0 ? 0 : random_range(&random, -reach, reach) * (i > 8 ? 2 : 1);
        pose.position.y = i == 0 ? 0 : random_range(&random, -reach, reach) * (i > 8 ? 2 : 1);
        pose.position.z = i == 0 ? 0 : random_range(&random, -reach, reach) * (i > 8 ? 2 : 1);
        posed = (case_posed){shapes[a], shapes[b], origin, pose};
        check_trial((unsigned long)i, case_show_posed, &posed);
        check_pair(&shapes[a], &shapes[b], &origin, &pose);
      }
    }
  }
}

// The same history makes the same block of a scene, bit for bit.
static void play(uint32_t *block, size_t bytes, uint8_t stack) {
  static const gjk_shape *table[sizeof shapes / sizeof shapes[0]];
  static const gjk_scene_config config = {16, 24, 20, 200, GJK_Q16(0.2), GJK_DETAIL_DISTANCE, 1, 0, 0, 0, 0};
  gjk_scene scene;
  gjk_body_id bodies[SHAPES];
  gjk_report reports[200];
  gjk_progress progress;
  random_state random = random_seed(check_seed(15) + 1);
  for (int i = 0; i < SHAPES; i++) {
    table[i] = &shapes[i];
  }
  fill(stack);
  CHECK(gjk_scene_init(&scene, &config, block, bytes, table, (uint16_t)SHAPES, NULL) == GJK_OK);
  for (int i = 0; i < SHAPES; i++) {
    const gjk_part parts[2] = {{(uint16_t)i, i % 2 != 0, GJK_POSE_IDENTITY},
                               {(uint16_t)(SHAPES - 1 - i), true, GJK_POSE_IDENTITY}};
    const gjk_body_setup setup = {GJK_POSE_IDENTITY, parts, (uint16_t)(1 + i % 2), GJK_BODY_DYNAMIC, 0, 1, 1, 0, 500};
    fill(stack);
    CHECK(gjk_scene_add(&scene, &setup, &bodies[i]) == GJK_OK);
  }
  for (int tick = 0; tick < 40; tick++) {
    for (int k = 0; k < 4; k++) {
      gjk_pose pose = GJK_POSE_IDENTITY;
      const gjk_body_id body = bodies[random_below(&random, (uint32_t)SHAPES)];
      pose.position.x = random_range(&random, -2 * ONE, 2 * ONE);
      pose.position.y = random_range(&random, -2 * ONE, 2 * ONE);
      fill(stack);
      CHECK(gjk_scene_move(&scene, body, &pose) == GJK_OK);
      fill(stack);
      CHECK(gjk_scene_set_shape(&scene, body, 0, (uint16_t)random_below(&random, (uint32_t)SHAPES)) == GJK_OK);
    }
    fill(stack);
    CHECK(gjk_scene_update(&scene, reports, 200, &progress) == GJK_OK);
    CHECK(progress.reports_left == 0);
  }
  fill(stack);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(gjk_scene_seal(&scene) == GJK_OK);
}

static void test_scenes(void) {
  static uint32_t first[4000], second[4000];
  memset(second, 0xA5, sizeof second);
  play(first, sizeof first, 0);
  play(second, sizeof second, 0xA5);
  const gjk_scene_config config = {16, 24, 20, 200, GJK_Q16(0.2), GJK_DETAIL_DISTANCE, 1, 0, 0, 0, 0};
  CHECK(gjk_scene_bytes(&config) <= sizeof first);
  CHECK(memcmp(first, second, gjk_scene_bytes(&config)) == 0);
}

int main(void) {
  test_pairs();
  test_scenes();
  return check_done("memory");
}
