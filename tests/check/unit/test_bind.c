// Shapes, parts and counts by functions are those of the macros; what a function refuses, it leaves as it was.
#include <string.h>

#include "check.h"
#include "gjk/bind.h"
#include "gjk/concave.h"
#include "gjk/hull.h"
#include "gjk/penetration.h"
#include "gjk2/bind.h"
#include "gjk2/collider.h"

static const gjk_vec3 corners[] = {{0, 0, 0}, {65536, 0, 0}, {0, 65536, 0}, {0, 0, 65536}};
static const gjk2_vec flat_corners[] = {{0, 0}, {65536, 0}, {0, 65536}, {65536, 65536}};
static const uint16_t face_corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
static const uint16_t face_ends[] = {3, 6, 9, 12};
static const gjk_hull_faces faces = {face_corners, face_ends, 4};

static void support(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  (void)user;
  out->x = direction->x < 0 ? -100 : 100;
}

static void flat_support(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  (void)user;
  out->x = direction->x < 0 ? -100 : 100;
}

// Every field, and so every byte but those of padding.
static bool is_same(const gjk_shape *a, const gjk_shape *b) {
  return a->type == b->type && a->vertices == b->vertices && a->support == b->support && a->user == b->user &&
         memcmp(&a->size, &b->size, sizeof a->size) == 0 && a->convex_radius == b->convex_radius &&
         a->count == b->count && a->faces == b->faces;
}

static bool is_same_flat(const gjk2_shape *a, const gjk2_shape *b) {
  return a->type == b->type && a->vertices == b->vertices && a->support == b->support && a->user == b->user &&
         memcmp(&a->size, &b->size, sizeof a->size) == 0 && a->convex_radius == b->convex_radius &&
         a->count == b->count;
}

// MADE(call, macro): the call makes what the macro makes. The last argument of the call is &made.
#define MADE(call, ...)                     \
  do {                                      \
    const gjk_shape expected = __VA_ARGS__; \
    gjk_shape made;                         \
    memset(&made, 0xA5, sizeof made);       \
    CHECK(call == GJK_OK);                  \
    CHECK(is_same(&made, &expected));       \
  } while (0)

#define MADE_FLAT(call, ...)                 \
  do {                                       \
    const gjk2_shape expected = __VA_ARGS__; \
    gjk2_shape made;                         \
    memset(&made, 0xA5, sizeof made);        \
    CHECK(call == GJK_OK);                   \
    CHECK(is_same_flat(&made, &expected));   \
  } while (0)

static void shapes(void) {
  MADE(gjk_shape_point(0, &made), GJK_POINT);
  MADE(gjk_shape_point(7, &made), GJK_SPHERE(7));
  MADE(gjk_shape_segment(5, 0, &made), GJK_SEGMENT(5));
  MADE(gjk_shape_segment(5, 7, &made), GJK_CAPSULE(7, 5));
  MADE(gjk_shape_triangle(corners, 7, &made), GJK_ROUNDED_TRIANGLE(corners, 7));
  MADE(gjk_shape_box(1, 2, 3, 0, &made), GJK_BOX(1, 2, 3));
  MADE(gjk_shape_box(1, 2, 3, 7, &made), GJK_ROUNDED_BOX(1, 2, 3, 7));
  MADE(gjk_shape_hull(corners, 4, NULL, 7, &made), GJK_ROUNDED_HULL(corners, 4, 7));
  MADE(gjk_shape_hull(corners, 4, &faces, 7, &made), GJK_ROUNDED_HULL_WITH_FACES(corners, 4, &faces, 7));
  MADE(gjk_shape_cylinder(3, 5, 7, &made), GJK_ROUNDED_CYLINDER(3, 5, 7));
  MADE(gjk_shape_cone(3, 5, 7, &made), GJK_ROUNDED_CONE(3, 5, 7));
  MADE(gjk_shape_ellipsoid(3, 4, 5, 7, &made), GJK_ROUNDED_ELLIPSOID(3, 4, 5, 7));
  MADE(gjk_shape_custom(support, corners, 200, 7, &made), GJK_ROUNDED_CUSTOM(support, corners, 200, 7));
}

// A table of level 0 with every vertex in every cell.
static void shape_with_table(void) {
  static uint16_t vertex[GJK_TABLE_CELLS(0) * 4], end[GJK_TABLE_CELLS(0)];
  static const gjk_hull_table table = {vertex, end, 0};
  for (unsigned i = 0; i < GJK_TABLE_CELLS(0) * 4; i++) {
    vertex[i] = (uint16_t)(i % 4);
    end[i / 4] = (uint16_t)(i + 1);
  }
  MADE(gjk_shape_hull_with_table(corners, 4, &faces, &table, 7, &made),
       GJK_ROUNDED_HULL_WITH_TABLE(corners, 4, &faces, &table, 7));
}

static void flat_shapes(void) {
  MADE_FLAT(gjk2_shape_point(0, &made), GJK2_POINT);
  MADE_FLAT(gjk2_shape_point(7, &made), GJK2_CIRCLE(7));
  MADE_FLAT(gjk2_shape_segment(5, 7, &made), GJK2_CAPSULE(7, 5));
  MADE_FLAT(gjk2_shape_triangle(flat_corners, 7, &made), GJK2_ROUNDED_TRIANGLE(flat_corners, 7));
  MADE_FLAT(gjk2_shape_box(1, 2, 7, &made), GJK2_ROUNDED_BOX(1, 2, 7));
  MADE_FLAT(gjk2_shape_polygon(flat_corners, 4, 7, &made), GJK2_ROUNDED_POLYGON(flat_corners, 4, 7));
  MADE_FLAT(gjk2_shape_ellipse(3, 4, 7, &made), GJK2_ROUNDED_ELLIPSE(3, 4, 7));
  MADE_FLAT(gjk2_shape_custom(flat_support, corners, 200, 7, &made),
            GJK2_ROUNDED_CUSTOM(flat_support, corners, 200, 7));
}

// REFUSED(type, call, status): refused with that status, and not a byte of made is written.
#define REFUSED(type, call, status)              \
  do {                                           \
    type made, before;                           \
    memset(&before, 0xA5, sizeof before);        \
    memset(&made, 0xA5, sizeof made);            \
    CHECK(call == (status));                     \
    CHECK(!memcmp(&made, &before, sizeof made)); \
  } while (0)

static void refusals(void) {
  const uint16_t beyond[] = {0, 1, 4}, ends[] = {3};
  const gjk_hull_faces bad_faces = {beyond, ends, 1};
  const gjk_hull_table bad_table = {beyond, ends, GJK_TABLE_LEVEL_MAX + 1};
  REFUSED(gjk_shape, gjk_shape_point(-1, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk_shape, gjk_shape_point(GJK_RADIUS_MAX + 1, &made), GJK_ERROR_SIZE);
  REFUSED(gjk_shape, gjk_shape_segment(-1, 0, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk_shape, gjk_shape_triangle(NULL, 0, &made), GJK_ERROR_NULL);
  REFUSED(gjk_shape, gjk_shape_box(1, -1, 1, 0, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk_shape, gjk_shape_box(1, GJK_RADIUS_MAX, 1, 1, &made), GJK_ERROR_SIZE);
  REFUSED(gjk_shape, gjk_shape_hull(NULL, 4, NULL, 0, &made), GJK_ERROR_NULL);
  REFUSED(gjk_shape, gjk_shape_hull(corners, 0, NULL, 0, &made), GJK_ERROR_EMPTY);
  REFUSED(gjk_shape, gjk_shape_hull(corners, 4, &bad_faces, 0, &made), GJK_ERROR_RANGE);
  REFUSED(gjk_shape, gjk_shape_hull_with_table(corners, 4, NULL, NULL, 0, &made), GJK_ERROR_NULL);
  REFUSED(gjk_shape, gjk_shape_hull_with_table(corners, 4, NULL, &bad_table, 0, &made), GJK_ERROR_RANGE);
  REFUSED(gjk_shape, gjk_shape_cylinder(-1, 1, 0, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk_shape, gjk_shape_cone(1, -1, 0, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk_shape, gjk_shape_ellipsoid(1, 1, -1, 0, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk_shape, gjk_shape_custom(NULL, NULL, 1, 0, &made), GJK_ERROR_NULL);
  CHECK(gjk_shape_point(1, NULL) == GJK_ERROR_NULL);
  REFUSED(gjk2_shape, gjk2_shape_point(-1, &made), GJK_ERROR_NEGATIVE);
  REFUSED(gjk2_shape, gjk2_shape_box(1, GJK_RADIUS_MAX, 1, &made), GJK_ERROR_SIZE);
  REFUSED(gjk2_shape, gjk2_shape_polygon(flat_corners, 0, 0, &made), GJK_ERROR_EMPTY);
  REFUSED(gjk2_shape, gjk2_shape_custom(NULL, NULL, 1, 0, &made), GJK_ERROR_NULL);
  CHECK(gjk2_shape_point(1, NULL) == GJK_ERROR_NULL);
}

static bool is_same_parts(const gjk_parts *a, const gjk_parts *b) {
  return a->type == b->type && a->data == b->data && memcmp(&a->pose, &b->pose, sizeof a->pose) == 0;
}

static void parts(void) {
  static const gjk_compound compound;
  static const gjk_mesh mesh;
  static const gjk_height_field field;
  const gjk_parts of_compound = GJK_PARTS_OF_COMPOUND(&compound);
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&mesh);
  const gjk_parts of_field = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  gjk_parts out;
  CHECK(gjk_parts_of_compound(&compound, &out) == GJK_OK && is_same_parts(&out, &of_compound));
  CHECK(gjk_parts_of_mesh(&mesh, &out) == GJK_OK && is_same_parts(&out, &of_mesh));
  CHECK(gjk_parts_of_height_field(&field, &out) == GJK_OK && is_same_parts(&out, &of_field));
  REFUSED(gjk_parts, gjk_parts_of_compound(NULL, &made), GJK_ERROR_NULL);
  CHECK(gjk_parts_of_mesh(&mesh, NULL) == GJK_ERROR_NULL);
}

static void scenes(void) {
  gjk_scene_bindings out;
  gjk2_scene_bindings flat;
  memset(&out, 0xA5, sizeof out);
  memset(&flat, 0xA5, sizeof flat);
  CHECK(gjk_scene_bind_all(&out) == GJK_OK && out.details == &gjk_scene_contacts && out.motion == &gjk_scene_motion);
  CHECK(out.predicate == NULL && out.user == NULL && out.workspace == NULL && out.manifolds == NULL);
  CHECK(!out.keeps_manifolds);
  CHECK(gjk2_scene_bind_all(&flat) == GJK_OK && flat.details == &gjk2_scene_contacts);
  CHECK(flat.motion == &gjk2_scene_motion && flat.predicate == NULL && flat.user == NULL && flat.manifolds == NULL);
  CHECK(!flat.keeps_manifolds);
  CHECK(gjk_scene_bind_all(NULL) == GJK_ERROR_NULL && gjk2_scene_bind_all(NULL) == GJK_ERROR_NULL);
}

static void counts(void) {
  CHECK(gjk_compound_nodes(8) == GJK_COMPOUND_NODES(8));
  CHECK(gjk_compound_nodes(9) == GJK_COMPOUND_NODES(9));
  CHECK(gjk_compound_nodes(GJK_COMPOUND_PARTS_MAX) == GJK_COMPOUND_NODES(GJK_COMPOUND_PARTS_MAX));
  CHECK(gjk_compound_nodes(GJK_COMPOUND_PARTS_MAX + 1) == 0);
  for (uint32_t triangles = 1; triangles < 100; triangles++) {
    CHECK(gjk_mesh_nodes(triangles) == GJK_MESH_NODES(triangles));
  }
  CHECK(gjk_mesh_nodes(0) == 0);
  CHECK(gjk_mesh_nodes(GJK_MESH_TRIANGLES_MAX) == GJK_MESH_NODES(GJK_MESH_TRIANGLES_MAX));
  CHECK(gjk_mesh_nodes(GJK_MESH_TRIANGLES_MAX + 1) == 0);
  CHECK(gjk_table_cells(0) == 24 && gjk_table_cells(GJK_TABLE_LEVEL_MAX) == 6144);
  CHECK(gjk_table_cells(GJK_TABLE_LEVEL_MAX + 1) == 0);
  CHECK(gjk_hull_workspace(GJK_HULL_POINTS_MAX) == GJK_HULL_WORKSPACE(GJK_HULL_POINTS_MAX));
  CHECK(gjk_hull_workspace(GJK_HULL_POINTS_MAX + UINT32_C(1)) == 0);
  CHECK(gjk_hull_simplify_workspace(1000) == GJK_HULL_SIMPLIFY_WORKSPACE(1000));
  CHECK(gjk_hull_simplify_workspace(GJK_HULL_POINTS_MAX) == GJK_HULL_SIMPLIFY_WORKSPACE(GJK_HULL_POINTS_MAX));
  CHECK(gjk_hull_simplify_workspace(GJK_HULL_POINTS_MAX + UINT32_C(1)) == 0);
}

static void names(void) {
  int64_t value = 77;
  CHECK(gjk_size_of("gjk_collider") == sizeof(gjk_collider));
  CHECK(gjk_size_of("gjk2_collider") == sizeof(gjk2_collider));
  CHECK(gjk_size_of("gjk_collide") == 0 && gjk_size_of("gjk_colliders") == 0);
  CHECK(gjk_size_of("gjk_body_id") == sizeof(gjk_body_id));  // the first of all
  CHECK(gjk_size_of("Gjk_collider") == 0 && gjk_constant("gJK_ERROR_RANGE", &value) == GJK_ERROR_RANGE && value == 77);
  CHECK(gjk_size_of("") == 0 && gjk_size_of(NULL) == 0);
  CHECK(gjk_constant("GJK_ERROR_RANG", &value) == GJK_ERROR_RANGE && value == 77);
  CHECK(gjk_constant("", &value) == GJK_ERROR_RANGE && value == 77);
  CHECK(gjk_constant(NULL, &value) == GJK_ERROR_NULL && value == 77);
  CHECK(gjk_constant("GJK_OK", NULL) == GJK_ERROR_NULL);
  CHECK(gjk_constant("GJK_ERROR_RANGE", &value) == GJK_OK && value == GJK_ERROR_RANGE);
  CHECK(gjk_constant("GJK_CONCAVE_REACH", &value) == GJK_OK && value == GJK_CONCAVE_REACH);  // the first of all
  CHECK(gjk_constant("GJK_PARTS_NONE", &value) == GJK_OK && value == UINT32_MAX);
}

int main(void) {
  shapes();
  shape_with_table();
  flat_shapes();
  refusals();
  parts();
  scenes();
  counts();
  names();
  return check_done("bind");
}
