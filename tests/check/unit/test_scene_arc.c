// Fast bodies of several parts that turn: the parts run along arcs, which nothing may pass through between two updates.
//
// A hammer, a head at the end of a shaft, and posts around it. What an arc meets is known from the poses in between: where
// gjk_within says at one of them that two parts touch, an impact must have been reported, not later. And what is farther
// away at all poses than the poses are apart, and the error of an arc, is no impact.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "gjk/scene.h"
#define TEST_NAME "scene_arc"
#define SPACE 1
#endif

#include "placed.h"
#include "scene_bodies.h"

#define SEED 7795
#define TRIALS check_trials(400)
#define STEPS 512
#define ONE GJK_Q16_ONE

#if SPACE
#define VECTOR(x, y, z) \
  { x, y, z }
static const gjk_shape head = GJK_BOX(ONE / 4, ONE / 4, ONE / 4), shaft = GJK_CAPSULE(ONE / 32, ONE);
static const gjk_shape post = GJK_SPHERE(ONE / 2), nail = GJK_SEGMENT(2 * ONE);
#else
#define VECTOR(x, y, z) \
  { x, y }
static const gjk_shape head = GJK2_BOX(ONE / 4, ONE / 4), shaft = GJK2_CAPSULE(ONE / 32, ONE);
static const gjk_shape post = GJK2_CIRCLE(ONE / 16), nail = GJK2_SEGMENT(ONE / 4);
#endif

static const gjk_shape *const shapes[] = {&head, &shaft, &post, &nail};
static gjk_scene scene;
static uint32_t block[800];
static unsigned long hit, missed, close;

static gjk_pose random_pose(random_state *random, int32_t reach, int32_t turn) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_vec3 p = VECTOR(random_range(random, -reach, reach), random_range(random, -reach, reach),
                            random_range(random, -reach, reach));
  pose.position = p;
#if SPACE
  const gjk_quat any = {random_range(random, -turn, turn), random_range(random, -turn, turn),
                        random_range(random, -turn, turn), 1000};
#else
  const gjk_quat any = {1000, random_range(random, -turn, turn)};
#endif
  CHECK(gjk_quat_normalize(&any, &pose.rotation) == GJK_OK);
  return pose;
}

// The part's collider at a pose of its body.
static void collider_at(const gjk_part *part, const gjk_pose *body, gjk_collider *c) {
  gjk_pose pose = *body;
  memset(c, 0, sizeof *c);
  if (part->own_pose) {
    CHECK(gjk_pose_compose(body, &part->pose, &pose) == GJK_OK);
  }
  *c = posed(shapes[part->shape], &pose);
}

static bool near(const gjk_part *part, const gjk_pose *body, const gjk_collider *other, gjk_q16 reach) {
  gjk_collider c;
  gjk_decision decision;
  collider_at(part, body, &c);
  CHECK(gjk_within(&c, other, reach, NULL, &decision) == GJK_OK);
  return decision.yes;
}

static void check_swing(random_state *random) {
  const gjk_scene_config config = {.bodies = 2, .parts = 3, .own_poses = 2, .pairs = 3, .motions = 1};
  const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  const gjk_vec3 end = VECTOR(2 * ONE, random_range(random, -ONE / 4, ONE / 4), 0);
  gjk_part parts[2] = {{0, true, GJK_POSE_IDENTITY}, {1, true, GJK_POSE_IDENTITY}};
  const gjk_part thing = {(uint16_t)(2 + random_below(random, 2)), false, GJK_POSE_IDENTITY};
  parts[0].pose.position = end;
  parts[1].pose = random_pose(random, ONE / 2, 500);
  const gjk_pose from = random_pose(random, ONE / 4, 3000), at = random_pose(random, SPACE ? 2 * ONE : 3 * ONE, 1000);
  gjk_pose to = random_pose(random, ONE, 3000);
  gjk_report reports[8];
  gjk_progress progress;
  gjk_collider other;
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 4, &bindings) == GJK_OK);
  const gjk_body_id hammer = scene_add_parts(&scene, parts, 2, GJK_BODY_DYNAMIC, &from);
  scene_add_parts(&scene, &thing, 1, GJK_BODY_STATIC, &at);
  CHECK(gjk_scene_set_motion(&scene, hammer, GJK_MOTION_FAST) == GJK_OK);
  CHECK(gjk_scene_update(&scene, reports, 8, &progress) == GJK_OK);
  if (progress.reports > 0) {
    return;  // they touch at the start
  }
  CHECK(gjk_scene_move(&scene, hammer, &to) == GJK_OK);
  CHECK(gjk_scene_update(&scene, reports, 8, &progress) == GJK_OK);
  const gjk_report *impact = NULL;
  for (uint32_t i = 0; i < progress.reports; i++) {
    impact = reports[i].event == GJK_EVENT_IMPACT ? &reports[i] : impact;
  }
  gjk_motion motion = {0};
  motion.from = from;
  motion.to = to;
  collider_at(&thing, &at, &other);
  int first = STEPS + 1;
  bool ever_close = false;
  for (int i = 0; i <= STEPS && first > STEPS; i++) {
    gjk_pose pose;
    CHECK(gjk_motion_pose(&motion, i * (GJK_Q30_ONE / STEPS), &pose) == GJK_OK);
    for (int k = 0; k < 2; k++) {
      first = first > STEPS && near(&parts[k], &pose, &other, 0) ? i : first;
      ever_close = ever_close || near(&parts[k], &pose, &other, ONE / 16);
    }
  }
  if (first <= STEPS) {
    // Poses are rounded: a point of the hammer goes by at least an LSB in so much of the way.
    CHECK_MSG(impact != NULL && impact->fraction <= first * (GJK_Q30_ONE / STEPS) + 65536, "first at %d", first);
    hit++;
  } else if (!ever_close) {
    CHECK(impact == NULL);
    missed++;
  } else {
    close++;
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    check_swing(&random);
  }
  printf("%lu hit, %lu missed, %lu close\n", hit, missed, close);
  CHECK((hit > 20 && missed > 50) || !check_is_full());
  return check_done(TEST_NAME);
}
