// The smallest programs with the library, whose linked sizes are figures to keep: what to link is chosen by macros.
//   SIZE_BOXES   gjk_intersect on boxes; else gjk_distance on hulls, boxes and their rounded forms
//   SIZE_DEPTH, SIZE_CONTACTS  gjk_penetration, gjk_contacts on these as well
//   SIZE_CAST, SIZE_IMPACT     gjk_cast, gjk_time_of_impact on these as well
//   SIZE_RAY     gjk_cast_ray on these, without gjk_distance
//   SIZE_CURVED  gjk_distance on cylinders, cones and ellipsoids as well
//   SIZE_POSED   initialises and poses the colliders, too
//   SIZE_SCENE   instead of all that: a scene with contacts, of boxes and spheres
//   SIZE_GROUND  of that scene: a mesh as well
//   SIZE_PLANE_INTERSECT  instead: gjk2_intersect on boxes and polygons
//   SIZE_PLANE_DISTANCE   instead: gjk2_distance on these, segments, points and their rounded forms
//   SIZE_PLANE_ALL        instead: every query of the plane but the checks, on these
//   SIZE_PLANE_CAST       instead: gjk2_cast on these
//   SIZE_PLANE_IMPACT     instead: gjk2_time_of_impact on these
//   SIZE_PLANE_SCENE      instead: a scene of the plane with contacts, of boxes and circles
#if defined(SIZE_PLANE_INTERSECT) || defined(SIZE_PLANE_DISTANCE) || defined(SIZE_PLANE_ALL) || \
    defined(SIZE_PLANE_CAST) || defined(SIZE_PLANE_IMPACT) || defined(SIZE_PLANE_SCENE)
#include "size_plane.h"
#else
#include "gjk/gjk.h"
#include "gjk/scene.h"

void size_main(void);

#ifdef SIZE_SCENE
uint32_t size_block[1000];
gjk_manifold size_manifold;
gjk_report_function *size_report;

void size_main(void) {
  static const gjk_shape box = GJK_BOX(3, 4, 5), ball = GJK_SPHERE(6);
#ifdef SIZE_GROUND
  static const gjk_mesh mesh;
  static const gjk_concave concave = {GJK_PARTS_OF_MESH(&mesh), {0, 0, 0}};
  static const gjk_shape ground = GJK_CONCAVE(&concave, 1, 1, 1);
  static const gjk_shape *const shapes[] = {&box, &ball, &ground};
#else
  static const gjk_shape *const shapes[] = {&box, &ball};
#endif
  static const gjk_part part = {.shape = 0};
  static const gjk_scene_config config = {.bodies = 8, .parts = 8, .pairs = 16, .detail = GJK_DETAIL_CONTACTS};
  static const gjk_body_setup setup = {.pose = GJK_POSE_IDENTITY, .parts = &part, .part_count = 1};
  static gjk_scene_bindings bindings;
  gjk_scene scene;
  gjk_body_id body;
  bindings.details = &gjk_scene_contacts;
  bindings.manifolds = &size_manifold;
  gjk_scene_init(&scene, &config, size_block, sizeof size_block, shapes, 2, &bindings);
  gjk_scene_add(&scene, &setup, &body);
  gjk_scene_move(&scene, body, &setup.pose);
  gjk_scene_update_each(&scene, size_report, NULL);
}
#else

gjk_collider size_a, size_b;

#if defined(SIZE_CAST) || defined(SIZE_RAY)
static const gjk_vec3 size_to;
const gjk_cast_path size_path = {&size_to, &size_to, 0};
gjk_cast_result size_cast;
#endif

#ifdef SIZE_IMPACT
gjk_motion size_motion;
gjk_impact_setup size_setup;
gjk_impact_result size_impact;
#endif

#if defined(SIZE_DEPTH) || defined(SIZE_CONTACTS)
gjk_epa_cell size_cells[GJK_EPA_CELLS(20)];
gjk_workspace size_workspace;
gjk_penetration_result size_depth;
gjk_manifold size_manifold;
#endif

#ifdef SIZE_CURVED
const gjk_shape *size_shapes[3];
#endif

#ifdef SIZE_BOXES
gjk_decision size_answer;
#else
gjk_distance_result size_answer;
#endif

void size_main(void) {
  static const gjk_shape box = GJK_ROUNDED_BOX(3, 4, 5, 6);
#ifdef SIZE_BOXES
  static const gjk_shape other = GJK_BOX(1, 2, 3);
#else
  static const gjk_vec3 vertices[] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}};
  static const gjk_shape other = GJK_ROUNDED_HULL(vertices, 4, 1);
#endif
#ifdef SIZE_CURVED
  static const gjk_shape cylinder = GJK_CYLINDER(1, 2), cone = GJK_CONE(1, 2), ellipsoid = GJK_ELLIPSOID(1, 2, 3);
  size_shapes[0] = &cylinder;
  size_shapes[1] = &cone;
  size_shapes[2] = &ellipsoid;
#endif
#ifdef SIZE_POSED
  static const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider_init(&size_a, &box, NULL, 0);
  gjk_collider_init(&size_b, &other, NULL, 0);
  gjk_collider_pose(&size_a, &pose);
  gjk_collider_pose(&size_b, &pose);
#else
  size_a.shape = &box;
  size_b.shape = &other;
#endif
#ifdef SIZE_BOXES
  gjk_intersect(&size_a, &size_b, NULL, &size_answer);
#elif defined(SIZE_RAY)
  gjk_cast_ray(&size_a, &size_to, &size_to, &size_cast);
#else
  gjk_distance(&size_a, &size_b, NULL, &size_answer);
#endif
#ifdef SIZE_CAST
  gjk_cast(&size_a, &size_b, &size_path, &size_cast);
#endif
#if defined(SIZE_DEPTH) || defined(SIZE_CONTACTS)
  size_workspace.cells = size_cells;
  size_workspace.count = GJK_EPA_CELLS(20);
#endif
#ifdef SIZE_DEPTH
  gjk_penetration(&size_a, &size_b, NULL, &size_workspace, &size_depth);
#endif
#ifdef SIZE_CONTACTS
  gjk_contacts(&size_a, &size_b, 1, 4, NULL, &size_workspace, &size_manifold);
#endif
#ifdef SIZE_IMPACT
  gjk_time_of_impact(&size_a, &size_motion, &size_b, &size_motion, &size_setup, &size_impact);
#endif
}

#endif
#endif
