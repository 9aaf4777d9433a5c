// The same programs in the plane, see size_user.c.
#ifndef SIZE_USER_PLANE_H
#define SIZE_USER_PLANE_H

#include "board/board.h"
#include "gjk2/gjk2.h"
#include "gjk2/scene.h"

#if defined(USER_HULLS) || defined(USER_ALL)
static const gjk2_vec corners[] = {{0, 0}, {9, 0}, {0, 9}};
#endif

#if defined(USER_SPHERES)
static const gjk2_shape one = GJK2_CIRCLE(3), other = GJK2_CIRCLE(4);
#elif defined(USER_CAPSULES)
static const gjk2_shape one = GJK2_CIRCLE(3), other = GJK2_CAPSULE(3, 4);
#elif defined(USER_BOXES)
static const gjk2_shape one = GJK2_BOX(3, 4), other = GJK2_ROUNDED_BOX(1, 2, 4);
#elif defined(USER_HULLS)
static const gjk2_shape one = GJK2_POLYGON(corners, 3), other = GJK2_ROUNDED_BOX(1, 2, 4);
#else
static const gjk2_shape one = GJK2_POLYGON(corners, 3), other = GJK2_ELLIPSE(3, 4);
#endif

#ifdef USER_SCENE
static uint32_t block[GJK2_SCENE_BYTES(8, 8, 16) / 4];
static gjk2_manifold manifold;
static uint32_t heard;

static void hear(void *user, const gjk2_report *report) {
  (void)user;
  heard += report->manifold != NULL ? report->manifold->count : 1u;
}

int firmware_main(void) {
  static const gjk2_shape *const shapes[] = {&one, &other};
  static const gjk2_scene_config config = {.bodies = 8, .parts = 8, .pairs = 16, .detail = GJK_DETAIL_CONTACTS};
  static const gjk2_part parts[] = {{.shape = 0}, {.shape = 1}};
  const gjk2_scene_bindings bindings = {.details = &gjk2_scene_contacts, .manifolds = &manifold};
  gjk2_body_setup setup = {.pose = GJK2_POSE_IDENTITY, .parts = &parts[0], .part_count = 1, .category = 1, .mask = 1};
  gjk2_scene scene;
  gjk_body_id first, second;
  if (gjk2_scene_init(&scene, &config, block, sizeof block, shapes, 2, &bindings) != GJK_OK ||
      gjk2_scene_add(&scene, &setup, &first) != GJK_OK) {
    return 1;
  }
  setup.parts = &parts[1];
  setup.kind = GJK_BODY_DYNAMIC;
  return gjk2_scene_add(&scene, &setup, &second) != GJK_OK || gjk2_scene_move(&scene, second, &setup.pose) != GJK_OK ||
         gjk2_scene_update_each(&scene, hear, NULL) != GJK_OK || heard != 0;
}
#else

static gjk2_collider a, b;

static int ask(void) {
#if defined(USER_TOUCH)
  gjk2_decision out;
  return gjk2_within(&a, &b, 1, NULL, &out) + out.yes;
#elif defined(USER_DISTANCE)
  gjk2_distance_result out;
  return gjk2_distance(&a, &b, NULL, &out) + out.distance;
#elif defined(USER_DEPTH)
  gjk2_penetration_result out;
  return gjk2_penetration(&a, &b, NULL, &out) + out.intersecting;
#elif defined(USER_CONTACTS)
  static gjk2_manifold out;
  return gjk2_contacts(&a, &b, 1, 2, NULL, &out) + out.count;
#elif defined(USER_CAST)
  static const gjk2_vec to = {9, 9};
  const gjk2_cast_path path = {NULL, &to, 1};
  gjk2_cast_result out;
  return gjk2_cast(&a, &b, &path, &out) + out.hit;
#else
  static const gjk2_motion motion = {.from = GJK2_POSE_IDENTITY, .to = GJK2_POSE_IDENTITY};
  static const gjk2_impact_setup setup = {1, GJK2_IMPACT_TOLERANCE_MIN, 40};
  gjk2_impact_result out;
  return gjk2_time_of_impact(&a, &motion, &b, &motion, &setup, &out) + out.hit;
#endif
}

int firmware_main(void) {
  static const gjk2_pose pose = GJK2_POSE_IDENTITY;
  return gjk2_collider_init(&a, &one, NULL, 0) != GJK_OK || gjk2_collider_init(&b, &other, NULL, 0) != GJK_OK ||
         gjk2_collider_pose(&a, &pose) != GJK_OK || gjk2_collider_pose(&b, &pose) != GJK_OK || ask();
}
#endif
#endif
