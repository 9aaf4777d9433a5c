// Whole programs as a user counts them: two shapes that are posed, one query, and a board's start-up. What is in it is chosen by
// macros.
//   USER_SPHERES, USER_CAPSULES, USER_BOXES, USER_HULLS, USER_ALL  the shapes: spheres; a sphere and a capsule; boxes; a hull
//                         and a box; a hull and a cylinder
//   USER_TOUCH, USER_DISTANCE, USER_DEPTH, USER_CONTACTS, USER_CAST, USER_IMPACT  the query
//   USER_SCENE            instead of it a scene of such shapes with contacts
//   USER_PLANE            all that in the plane
#include "board/board.h"

#ifdef USER_PLANE
#include "scene/plane_names.h"

#define gjk_penetration_result gjk2_penetration_result
#undef GJK_IMPACT_TOLERANCE_MIN
#define GJK_IMPACT_TOLERANCE_MIN GJK2_IMPACT_TOLERANCE_MIN
#undef GJK_SCENE_BYTES
#define GJK_SCENE_BYTES GJK2_SCENE_BYTES
#define TO \
  { 9, 9 }
#define ask_depth(out) gjk2_penetration(&a, &b, NULL, out)
#define ask_contacts(out) gjk2_contacts(&a, &b, 1, 2, NULL, out)

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

#else
#include "gjk/gjk.h"
#include "gjk/scene.h"

#define TO \
  { 9, 9, 9 }
#define ask_depth(out) gjk_penetration(&a, &b, NULL, NULL, out)
#define ask_contacts(out) gjk_contacts(&a, &b, 1, 4, NULL, NULL, out)

#if defined(USER_HULLS) || defined(USER_ALL)
static const gjk_vec3 corners[] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}};
#endif
#if defined(USER_SPHERES)
static const gjk_shape one = GJK_SPHERE(3), other = GJK_SPHERE(4);
#elif defined(USER_CAPSULES)
static const gjk_shape one = GJK_SPHERE(3), other = GJK_CAPSULE(3, 4);
#elif defined(USER_BOXES)
static const gjk_shape one = GJK_BOX(3, 4, 5), other = GJK_ROUNDED_BOX(1, 2, 3, 4);
#elif defined(USER_HULLS)
static const gjk_shape one = GJK_HULL(corners, 4), other = GJK_ROUNDED_BOX(1, 2, 3, 4);
#else
static const gjk_shape one = GJK_HULL(corners, 4), other = GJK_CYLINDER(3, 4);
#endif
#endif

#ifdef USER_SCENE
static uint32_t block[GJK_SCENE_BYTES(8, 8, 16) / 4];
static gjk_manifold manifold;
static uint32_t heard;

static void hear(void *user, const gjk_report *report) {
  (void)user;
  heard += report->manifold != NULL ? report->manifold->count : 1u;
}

int firmware_main(void) {
  static const gjk_shape *const shapes[] = {&one, &other};
  static const gjk_scene_config config = {.bodies = 8, .parts = 8, .pairs = 16, .detail = GJK_DETAIL_CONTACTS};
  static const gjk_part parts[] = {{.shape = 0}, {.shape = 1}};
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts, .manifolds = &manifold};
  gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .parts = &parts[0], .part_count = 1, .category = 1, .mask = 1};
  gjk_scene scene;
  gjk_body_id first, second;
  if (gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, &bindings) != GJK_OK ||
      gjk_scene_add(&scene, &setup, &first) != GJK_OK) {
    return 1;
  }
  setup.parts = &parts[1];
  setup.kind = GJK_BODY_DYNAMIC;
  return gjk_scene_add(&scene, &setup, &second) != GJK_OK || gjk_scene_move(&scene, second, &setup.pose) != GJK_OK ||
         gjk_scene_update_each(&scene, hear, NULL) != GJK_OK || heard != 0;
}
#else

static gjk_collider a, b;

static int ask(void) {
#if defined(USER_TOUCH)
  gjk_decision out;
  return gjk_within(&a, &b, 1, NULL, &out) + out.yes;
#elif defined(USER_DISTANCE)
  gjk_distance_result out;
  return gjk_distance(&a, &b, NULL, &out) + out.distance;
#elif defined(USER_DEPTH)
  gjk_penetration_result out;
  return ask_depth(&out) + out.intersecting;
#elif defined(USER_CONTACTS)
  static gjk_manifold out;
  return ask_contacts(&out) + out.count;
#elif defined(USER_CAST)
  static const gjk_vec3 to = TO;
  const gjk_cast_path path = {NULL, &to, 1};
  gjk_cast_result out;
  return gjk_cast(&a, &b, &path, &out) + out.hit;
#else
  static const gjk_motion motion = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  static const gjk_impact_setup setup = {1, GJK_IMPACT_TOLERANCE_MIN, 40};
  gjk_impact_result out;
  return gjk_time_of_impact(&a, &motion, &b, &motion, &setup, &out) + out.hit;
#endif
}

int firmware_main(void) {
  static const gjk_pose pose = GJK_POSE_IDENTITY;
  return gjk_collider_init(&a, &one, NULL, 0) != GJK_OK || gjk_collider_init(&b, &other, NULL, 0) != GJK_OK ||
         gjk_collider_pose(&a, &pose) != GJK_OK || gjk_collider_pose(&b, &pose) != GJK_OK || ask();
}
#endif
