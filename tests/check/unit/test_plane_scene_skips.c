// Skips of the plane to the last LSB: what a pair's record claims is so, motion and rotations are bounded, and pairs that
// are as far apart as their margins reach are told as a scene without skips and the query tell them.
#include <math.h>

#include "placed2.h"
#include "plane.h"
#include "src/plane_scene/gjk2_scene_names.h"
// The view of a block, under the plane's names.
#include "src/scene/gjk_scene_part.h"

#define SEED 7720
#define PATHS check_trials(1500)
#define TICKS 40u
#define TURNS check_trials(200000)

static const gjk2_scene_config quick_config = {2, 2, 2, 1, GJK_Q16(0.125), GJK_DETAIL_TOUCH, 0, 0, 0, 0};
static const gjk2_scene_config contacts_config = {2, 2, 2, 1, GJK_Q16(0.125), GJK_DETAIL_CONTACTS, 1, 0, 0, 0};
static const gjk2_scene_config plain_config = {2, 2, 2, 1, 0, GJK_DETAIL_TOUCH, 0, 1, 0, 0};
static uint32_t quick_block[300], plain_block[300];
static gjk2_scene quick, plain;  // with all skips, with none
static unsigned near_count, far_count, motion_count, boxes_count, direction_count, warm_count, claims[2], deep;

static void start(gjk2_scene *scene, const gjk2_scene_config *config, uint32_t *block, const gjk2_shape *const *shapes,
                  const gjk2_body_setup setup[2]) {
  static gjk2_manifold manifold;
  const gjk2_scene_bindings bindings = {.details = &gjk2_scene_contacts, .manifolds = &manifold};
  gjk_body_id id;
  CHECK(gjk2_scene_init(scene, config, block, sizeof quick_block, shapes, 2, &bindings) == GJK_OK);
  for (int i = 0; i < 2; i++) {
    CHECK(gjk2_scene_add(scene, &setup[i], &id) == GJK_OK);
  }
}

// Updates a scene. Is its pair near?
static bool update(gjk2_scene *scene) {
  gjk2_report report;
  gjk_progress progress;
  uint32_t cursor = 0;
  bool found = false;
  CHECK(gjk2_scene_update(scene, &report, 1, &progress) == GJK_OK);
  CHECK(gjk2_scene_next_near(scene, &cursor, &report, &found) == GJK_OK);
  return found;
}

// Is the gap of the record proven? The distance is rounded to the nearest, and a depth is not looked at.
static void check_gap(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin) {
  gjk2_scene_view v;
  gjk2_distance_result r;
  CHECK(gjk2_scene_view_of(&quick, &v) == GJK_OK);
  if (v.header->pairs.count == 0) {
    return;
  }
  const gjk2_scene_pair *pair = &v.pairs[0];
  CHECK(pair->gap >= 0);
  CHECK(gjk2_signed_distance(a, b, NULL, &r) == GJK_OK);
  const bool near = (pair->state & GJK_SCENE_PAIR_NEAR) != 0;
  const int64_t left = near ? (int64_t)margin - r.distance : (int64_t)r.distance - margin;
  CHECK_MSG(pair->gap <= left + 1, "%s: gap %d, left %lld", near ? "near" : "apart", (int)pair->gap, (long long)left);
  claims[near] += pair->gap > 0;
  deep += near && pair->gap > margin;
}

static void check_path(random_state *random) {
  static plane_body body[2];
  const gjk_q16 margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, 9000);
  plane_random_pair(random, 40000, 60000, body);
  const gjk2_shape *const shapes[2] = {&body[0].shape, &body[1].shape};
  const gjk2_part part[2] = {{0, false, GJK2_POSE_IDENTITY}, {1, false, GJK2_POSE_IDENTITY}};
  gjk2_body_setup setup[2];
  for (int i = 0; i < 2; i++) {
    setup[i] = (gjk2_body_setup){body[i].pose, &part[i], 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, margin};
  }
  start(&quick, random_below(random, 2) == 0 ? &quick_config : &contacts_config, quick_block, shapes, setup);
  start(&plain, &plain_config, plain_block, shapes, setup);
  const gjk_body_id moving = {1, 1};
  for (unsigned i = 0; i < TICKS; i++) {
    gjk2_collider a, b;
    gjk2_distance_result r;
    gjk2_decision decision;
    gjk_scene_stats stats;
    const bool near = update(&quick), plainly = update(&plain);
    CHECK(gjk2_scene_collider(&quick, (gjk_body_id){0, 1}, 0, &a) == GJK_OK);
    CHECK(gjk2_scene_collider(&quick, moving, 0, &b) == GJK_OK);
    CHECK(gjk2_within(&a, &b, 2 * margin, NULL, &decision) == GJK_OK);
    CHECK_MSG(near == decision.yes && plainly == near, "tick %u: %d %d %d", i, near, plainly, decision.yes);
    check_gap(&a, &b, 2 * margin);
    near_count += near;
    far_count += !near;
    CHECK(gjk2_scene_get_stats(&quick, &stats) == GJK_OK);
    motion_count += stats.motion;
    boxes_count += stats.boxes;
    direction_count += stats.direction;
    warm_count += stats.warm;
    // To the margins but for a few LSB, a little on, or anywhere near; perhaps turned.
    gjk2_pose pose = setup[1].pose;
    const uint32_t how = random_below(random, 4);
    CHECK(gjk2_distance(&a, &b, NULL, &r) == GJK_OK);
    if (how == 0 && !r.intersecting && !r.saturated) {
      const int64_t by = 2 * (int64_t)margin - r.distance + random_range(random, -20, 20);
      pose.position.x += (gjk_q16)(by * r.normal.x / GJK_Q30_ONE);
      pose.position.y += (gjk_q16)(by * r.normal.y / GJK_Q30_ONE);
    } else {
      const int32_t step = how == 1 ? 30000 : 200;
      pose.position.x += random_range(random, -step, step);
      pose.position.y += random_range(random, -step, step);
    }
    if (random_below(random, 3) == 0) {
      const gjk2_rotation turn = {20000, random_range(random, -300, 300)};
      gjk2_rotation unit;
      CHECK(gjk2_rotation_normalize(&turn, &unit) == GJK_OK);
      CHECK(gjk2_rotation_compose(&unit, &pose.rotation, &pose.rotation) == GJK_OK);
    }
    if (gjk2_scene_move(&quick, moving, &pose) == GJK_OK) {
      CHECK(gjk2_scene_move(&plain, moving, &pose) == GJK_OK);
      setup[1].pose = pose;
    }
  }
}

// How far rotations move points, against the real numbers.
static void check_turns(random_state *random) {
  double least = 9;
  for (unsigned i = 0; i < TURNS; i++) {
    gjk2_rotation a = plane_random_rotation(random), b = plane_random_rotation(random);
    if (random_below(random, 2) == 0) {
      const gjk2_rotation turn = {1 << 30, random_range(random, -(1 << random_below(random, 30)), 1 << 20)};
      CHECK(gjk2_rotation_normalize(&turn, &b) == GJK_OK);
      CHECK(gjk2_rotation_compose(&a, &b, &b) == GJK_OK);
    }
    a.c += random_range(random, -4000, 4000);  // within the tolerance
    b.s += random_range(random, -4000, 4000);
    const uint32_t bound = gjk2_scene_rotation_bound(&a, &b);
    const double la = hypot(a.c, a.s), lb = hypot(b.c, b.s);
    const double moved = ldexp(hypot(a.c / la - b.c / lb, a.s / la - b.s / lb), 30);
    CHECK_MSG(bound >= moved, "turn %u: %u, %f", i, bound, moved);
    const double loose = (bound - 2) / (moved + 8000);
    CHECK_MSG(loose <= 1.15, "turn %u: %u, %f", i, bound, moved);
    least = loose < least ? loose : least;
  }
  const gjk2_rotation half = {-GJK_Q30_ONE, 0}, none = {GJK_Q30_ONE, 0};
  CHECK(gjk2_scene_rotation_bound(&none, &none) == 0);
  CHECK(gjk2_scene_rotation_bound(&none, &half) >= UINT32_C(1) << 31);
}

// Motion bounds how far each vertex of a part moves, whatever its origin and pose in the body.
static void check_motion(random_state *random) {
  static plane_body body[2];
  plane_random_pair(random, 40000, 60000, body);
  const gjk2_shape *const shapes[2] = {&body[0].shape, &body[1].shape};
  gjk2_part part = {0, random_below(random, 2) == 0, GJK2_POSE_IDENTITY};
  gjk2_scene scene;
  gjk_body_id id;
  part.pose.rotation = plane_random_rotation(random);
  part.pose.position = plane_random_vec(random, 100000);
  gjk2_body_setup setup = {body[0].pose, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  setup.pose.position = plane_random_vec(random, 100000);
  CHECK(gjk2_scene_init(&scene, &quick_config, quick_block, sizeof quick_block, shapes, 2, NULL) == GJK_OK);
  CHECK(gjk2_scene_add(&scene, &setup, &id) == GJK_OK);
  gjk_progress progress;
  CHECK(gjk2_scene_update(&scene, NULL, 0, &progress) == GJK_OK);
  gjk2_collider before, after;
  gjk2_scene_view v;
  CHECK(gjk2_scene_collider(&scene, id, 0, &before) == GJK_OK);
  for (unsigned i = 0; i < 4; i++) {
    const gjk2_rotation turn = {20000, random_range(random, -9000, 9000)};
    gjk2_rotation unit;
    gjk2_aabb box;
    CHECK(gjk2_rotation_normalize(&turn, &unit) == GJK_OK);
    CHECK(gjk2_rotation_compose(&unit, &setup.pose.rotation, &setup.pose.rotation) == GJK_OK);
    setup.pose.position.x += random_range(random, -900, 900);
    setup.pose.position.y += random_range(random, -900, 900);
    CHECK(gjk2_scene_move(&scene, id, &setup.pose) == GJK_OK);
    CHECK(gjk2_scene_collider(&scene, id, 0, &after) == GJK_OK);
    CHECK(gjk2_scene_view_of(&scene, &v) == GJK_OK);
    const gjk2_scene_part *p = &v.parts[v.bodies[0].first];
    CHECK(gjk2_collider_aabb(&after, &box) == GJK_OK);
    CHECK(gjk2_aabb_inside(&box, &p->exact) && gjk2_aabb_inside(&box, &p->enlarged));
    for (uint16_t k = 0; k < after.count; k++) {
      gjk2_vec from, to;
      CHECK(before.shape->type->vertex(&before, k, &from));
      CHECK(after.shape->type->vertex(&after, k, &to));
      const double moved = hypot((double)after.centre.x + to.x - before.centre.x - from.x,
                                 (double)after.centre.y + to.y - before.centre.y - from.y);
      CHECK_MSG(p->motion >= moved, "vertex %u: %u, %f", k, (unsigned)p->motion, moved);
    }
  }
  CHECK(gjk2_scene_check(&scene) == GJK_OK);
}

// Margins that reach so far that centres are 2^29 apart along an axis, or an LSB less: the pair is near. It claims no
// gap where the decision's feature cannot be measured.
static void check_far_centres(void) {
  const gjk2_shape wall = GJK2_BOX(INT32_C(1) << 27, GJK_Q16(2));
  const gjk2_shape *const shapes[2] = {&wall, &wall};
  const gjk2_part part[2] = {{.shape = 0}, {.shape = 1}};
  for (int less = 0; less < 2; less++) {
    gjk2_body_setup setup[2];
    gjk2_collider c[2];
    for (int i = 0; i < 2; i++) {
      const gjk2_body_setup usual = {GJK2_POSE_IDENTITY, &part[i], 1, GJK_BODY_DYNAMIC, 0, 1, 1, 0, GJK2_RADIUS_MAX};
      setup[i] = usual;
      setup[i].pose.position.x = i == 0 ? -(INT32_C(1) << 28) : (INT32_C(1) << 28) - less;
      setup[i].pose.position.y = i == 0 ? 0 : INT32_C(3) << 27;
      c[i] = posed2(&wall, &setup[i].pose);
    }
    start(&quick, &quick_config, quick_block, shapes, setup);
    start(&plain, &plain_config, plain_block, shapes, setup);
    CHECK(update(&quick) && update(&plain));
    check_gap(&c[0], &c[1], 2 * GJK2_RADIUS_MAX);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  check_turns(&random);
  check_far_centres();
  for (unsigned i = 0; i < PATHS; i++) {
    check_trial(i, NULL, NULL);
    check_path(&random);
    check_motion(&random);
  }
  printf(
      "%u near, %u apart; %u by motion, %u by boxes, %u by direction, %u warm; gaps claimed: %u near, %u apart, %u by "
      "a depth\n",
      near_count, far_count, motion_count, boxes_count, direction_count, warm_count, claims[1], claims[0], deep);
  CHECK(near_count > PATHS && far_count > PATHS && motion_count > PATHS && boxes_count > PATHS / 4 &&
        direction_count > PATHS / 4 && warm_count > PATHS && claims[0] > PATHS && claims[1] > PATHS && deep > PATHS);
  return check_done("plane_scene_skips");
}
