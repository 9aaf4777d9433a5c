// The smallest programs of the plane, see size.c.
#ifndef SIZE_PLANE_H
#define SIZE_PLANE_H

#include "gjk2/gjk2.h"
#include "gjk2/scene.h"

void size_main(void);

#ifdef SIZE_PLANE_SCENE
uint32_t size_block[700];
gjk2_manifold size_manifold;
gjk2_report_function *size_report;

void size_main(void) {
  static const gjk2_shape box = GJK2_BOX(3, 4), ball = GJK2_CIRCLE(6);
  static const gjk2_shape *const shapes[] = {&box, &ball};
  static const gjk2_part part = {.shape = 0};
  static const gjk2_scene_config config = {.bodies = 8, .parts = 8, .pairs = 16, .detail = GJK_DETAIL_CONTACTS};
  static const gjk2_body_setup setup = {.pose = GJK2_POSE_IDENTITY, .parts = &part, .part_count = 1};
  static gjk2_scene_bindings bindings;
  gjk2_scene scene;
  gjk_body_id body;
  bindings.details = &gjk2_scene_contacts;
  bindings.manifolds = &size_manifold;
  gjk2_scene_init(&scene, &config, size_block, sizeof size_block, shapes, 2, &bindings);
  gjk2_scene_add(&scene, &setup, &body);
  gjk2_scene_move(&scene, body, &setup.pose);
  gjk2_scene_update_each(&scene, size_report, NULL);
}
#else

gjk2_collider size_a, size_b, size_c;
gjk2_decision size_yes;
gjk2_distance_result size_gap;
gjk2_penetration_result size_depth;
gjk2_manifold size_manifold;
gjk2_cast_path size_path;
gjk2_cast_result size_cast;
gjk2_motion size_motion;
gjk2_impact_setup size_setup;
gjk2_impact_result size_impact;

void size_main(void) {
  static const gjk2_vec vertices[] = {{0, 0}, {9, 0}, {0, 9}};
#ifdef SIZE_PLANE_INTERSECT
  static const gjk2_shape box = GJK2_BOX(3, 4), polygon = GJK2_POLYGON(vertices, 3);
#else
  static const gjk2_shape box = GJK2_ROUNDED_BOX(3, 4, 5), polygon = GJK2_ROUNDED_POLYGON(vertices, 3, 1);
  static const gjk2_shape capsule = GJK2_CAPSULE(1, 2);
  size_c.shape = &capsule;
#endif
#ifdef SIZE_POSED
  static const gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk2_collider_init(&size_a, &box, NULL, 0);
  gjk2_collider_init(&size_b, &polygon, NULL, 0);
  gjk2_collider_pose(&size_a, &pose);
  gjk2_collider_pose(&size_b, &pose);
#else
  size_a.shape = &box;
  size_b.shape = &polygon;
#endif
#if defined(SIZE_PLANE_INTERSECT)
  gjk2_intersect(&size_a, &size_b, NULL, &size_yes);
#elif defined(SIZE_PLANE_DISTANCE)
  gjk2_distance(&size_a, &size_b, NULL, &size_gap);
#elif defined(SIZE_PLANE_CAST)
  gjk2_cast(&size_a, &size_b, &size_path, &size_cast);
#elif defined(SIZE_PLANE_IMPACT)
  gjk2_time_of_impact(&size_a, &size_motion, &size_b, &size_motion, &size_setup, &size_impact);
#else
  gjk2_within(&size_a, &size_b, 1, NULL, &size_yes);
  gjk2_distance(&size_a, &size_b, NULL, &size_gap);
  gjk2_penetration(&size_a, &size_b, NULL, &size_depth);
  gjk2_signed_distance(&size_a, &size_b, NULL, &size_gap);
  gjk2_contacts(&size_a, &size_b, 1, 2, NULL, &size_manifold);
#endif
}

#endif
#endif
