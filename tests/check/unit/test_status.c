// Bad input to colliders, queries and checks: every status, and outputs that stay as they were.
#include <string.h>

#include "check.h"
#include "filled.h"
#include "gjk/gjk.h"

#define ONE GJK_Q16_ONE

static const gjk_shape cube = GJK_BOX(ONE, ONE, ONE);
static const gjk_pose origin = GJK_POSE_IDENTITY;

static void support_origin(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  static const gjk_vec3 zero = {0, 0, 0};
  (void)user;
  (void)direction;
  *out = zero;
}

// The status of gjk_collider_init for a shape. A refusal must leave the collider as it was.
static gjk_status init_status(const gjk_shape *shape, gjk_vec3 *buffer, uint16_t capacity) {
  gjk_collider collider;
  memset(&collider, POISON, sizeof collider);
  const gjk_status status = gjk_collider_init(&collider, shape, buffer, capacity);
  CHECK_MSG(status == GJK_OK || is_untouched(&collider, sizeof collider), "%s", gjk_status_name(status));
  return status;
}

static gjk_status shape_status(gjk_shape shape) {
  return init_status(&shape, NULL, 0);
}

static void test_names(void) {
  static const struct {
    gjk_status status;
    const char *name;
  } names[] = {{GJK_OK, "GJK_OK"},
               {GJK_ERROR_NULL, "GJK_ERROR_NULL"},
               {GJK_ERROR_SIZE, "GJK_ERROR_SIZE"},
               {GJK_ERROR_NEGATIVE, "GJK_ERROR_NEGATIVE"},
               {GJK_ERROR_EMPTY, "GJK_ERROR_EMPTY"},
               {GJK_ERROR_CAPACITY, "GJK_ERROR_CAPACITY"},
               {GJK_ERROR_OVERLAP, "GJK_ERROR_OVERLAP"},
               {GJK_ERROR_ROTATION, "GJK_ERROR_ROTATION"},
               {GJK_ERROR_RANGE, "GJK_ERROR_RANGE"},
               {GJK_ERROR_UNINITIALISED, "GJK_ERROR_UNINITIALISED"},
               {GJK_ERROR_ITERATION_LIMIT, "GJK_ERROR_ITERATION_LIMIT"},
               {GJK_ERROR_UNPROVEN, "GJK_ERROR_UNPROVEN"},
               {GJK_ERROR_UNSUPPORTED, "GJK_ERROR_UNSUPPORTED"},
               {GJK_ERROR_BODY_ID, "GJK_ERROR_BODY_ID"},
               {GJK_ERROR_BUSY, "GJK_ERROR_BUSY"},
               {GJK_ERROR_CORRUPT, "GJK_ERROR_CORRUPT"}};
  const int count = (int)(sizeof names / sizeof names[0]);
  for (int i = 0; i < count; i++) {
    CHECK_MSG((int)names[i].status == -i, "%s", names[i].name);
    CHECK_MSG(strcmp(gjk_status_name(names[i].status), names[i].name) == 0, "%s", names[i].name);
  }
  CHECK(strcmp(gjk_status_name((gjk_status)-count), "GJK_ERROR_UNKNOWN") == 0);
  CHECK(strcmp(gjk_status_name((gjk_status)1), "GJK_ERROR_UNKNOWN") == 0);
}

// The preprocessor can compare versions.
static void test_versions(void) {
#if GJK_VERSION_MAJOR < 0 || GJK_VERSION_MINOR < 0 || GJK_VERSION_PATCH < 0 || GJK_BITS_VERSION < 1
  CHECK(false);
#endif
  const int32_t part[3] = {GJK_VERSION_MAJOR, GJK_VERSION_MINOR, GJK_VERSION_PATCH};
  for (int i = 0; i < 3; i++) {
    CHECK_MSG(part[i] >= 0, "part %d", i);
    CHECK_MSG(part[i] < 1000, "part %d", i);
  }
  // Release 0.0.0 is none, and neither is version 0 of the bits.
  CHECK(part[0] + part[1] + part[2] > 0);
  CHECK(GJK_BITS_VERSION >= 1);
}

static void test_null_shapes(void) {
  const gjk_shape no_class = {NULL, NULL, NULL, NULL, {0, 0, 0}, 0, 0, NULL};
  const gjk_shape hull = GJK_HULL(NULL, 4), triangle = GJK_TRIANGLE(NULL), custom = GJK_CUSTOM(NULL, NULL, ONE);
  CHECK(gjk_collider_init(NULL, &cube, NULL, 0) == GJK_ERROR_NULL);
  CHECK(init_status(NULL, NULL, 0) == GJK_ERROR_NULL);
  CHECK(init_status(&no_class, NULL, 0) == GJK_ERROR_NULL);
  CHECK(init_status(&hull, NULL, 0) == GJK_ERROR_NULL);
  CHECK(init_status(&triangle, NULL, 0) == GJK_ERROR_NULL);
  CHECK(init_status(&custom, NULL, 0) == GJK_ERROR_NULL);
}

static void test_negative_sizes(void) {
  static const gjk_vec3 corners[4] = {{0, 0, 0}, {ONE, 0, 0}, {0, ONE, 0}, {0, 0, ONE}};
  const gjk_shape shapes[] = {GJK_SPHERE(-1),
                              GJK_SEGMENT(-1),
                              GJK_CAPSULE(-1, ONE),
                              GJK_CAPSULE(ONE, -1),
                              GJK_ROUNDED_TRIANGLE(corners, -1),
                              GJK_BOX(-1, ONE, ONE),
                              GJK_BOX(ONE, -1, ONE),
                              GJK_BOX(ONE, ONE, INT32_MIN),
                              GJK_ROUNDED_BOX(ONE, ONE, ONE, INT32_MIN),
                              GJK_ROUNDED_HULL(corners, 4, -1),
                              GJK_CYLINDER(-1, ONE),
                              GJK_CYLINDER(ONE, -1),
                              GJK_ROUNDED_CYLINDER(ONE, ONE, -1),
                              GJK_CONE(-1, ONE),
                              GJK_CONE(ONE, -1),
                              GJK_ROUNDED_CONE(ONE, ONE, -1),
                              GJK_ELLIPSOID(-1, ONE, ONE),
                              GJK_ELLIPSOID(ONE, -1, ONE),
                              GJK_ELLIPSOID(ONE, ONE, -1),
                              GJK_ROUNDED_ELLIPSOID(ONE, ONE, ONE, -1),
                              GJK_CUSTOM(support_origin, NULL, -1),
                              GJK_ROUNDED_CUSTOM(support_origin, NULL, ONE, -1)};
  for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
    CHECK_MSG(shape_status(shapes[i]) == GJK_ERROR_NEGATIVE, "shape %lu", (unsigned long)i);
  }
}

static void test_empty(void) {
  static const gjk_vec3 corners[1] = {{0, 0, 0}};
  const gjk_shape empty = GJK_HULL(corners, 0), single = GJK_HULL(corners, 1);
  CHECK(shape_status(empty) == GJK_ERROR_EMPTY);
  CHECK(shape_status(single) == GJK_OK);
  // A shape of size 0 is a point.
  const gjk_shape ellipsoid = GJK_ELLIPSOID(0, 0, 0), cylinder = GJK_CYLINDER(0, 0), box = GJK_BOX(0, 0, 0);
  CHECK(shape_status(ellipsoid) == GJK_OK);
  CHECK(shape_status(cylinder) == GJK_OK);
  CHECK(shape_status(box) == GJK_OK);
}

// A triangle whose count is not 3 must be refused: measuring it would read count vertices, posing it 3.
static void test_triangles(void) {
  static const gjk_vec3 corners[4] = {{0, 0, 0}, {ONE, 0, 0}, {0, ONE, 0}, {0, 0, ONE}};
  gjk_shape triangle = GJK_TRIANGLE(corners);
  CHECK(shape_status(triangle) == GJK_OK);
  for (int count = 0; count < 5; count++) {
    triangle.count = (uint16_t)count;
    CHECK_MSG(shape_status(triangle) == (count == 3 ? GJK_OK : GJK_ERROR_RANGE), "%d vertices", count);
  }
  triangle.count = UINT16_MAX;
  CHECK(shape_status(triangle) == GJK_ERROR_RANGE);
  triangle.vertices = NULL;
  CHECK(shape_status(triangle) == GJK_ERROR_NULL);
}

// The largest sizes are accepted; one LSB more is not. Diagonals use 1/sqrt(3) and 1/sqrt(2) of the limit, rounded
// down.
static void test_sizes(void) {
  const gjk_q16 limit = GJK_RADIUS_MAX, third = 154943445, half = 189766190;
  static const gjk_vec3 line[2] = {{-GJK_RADIUS_MAX, 0, 0}, {GJK_RADIUS_MAX, 0, 0}};
  static const gjk_vec3 longer[2] = {{-GJK_RADIUS_MAX, 0, 0}, {GJK_RADIUS_MAX + 1, 0, 0}};
  static const gjk_vec3 whole[2] = {{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};
  static const gjk_vec3 large[3] = {{0, 0, 0}, {2 * GJK_RADIUS_MAX, 0, 0}, {0, 2 * GJK_RADIUS_MAX, 0}};
  static const gjk_vec3 far_out[2] = {{INT32_MAX, INT32_MAX, 0}, {INT32_MAX - 2 * GJK_RADIUS_MAX, INT32_MAX, 0}};
  const gjk_shape largest[] = {GJK_SPHERE(limit),          GJK_SEGMENT(limit),
                               GJK_CAPSULE(limit - 5, 5),  GJK_BOX(third, third, third),
                               GJK_CYLINDER(half, half),   GJK_CONE(half, half),
                               GJK_ELLIPSOID(limit, 1, 1), GJK_HULL(line, 2),
                               GJK_HULL(far_out, 2),       GJK_CUSTOM(support_origin, NULL, limit)};
  const gjk_shape beyond[] = {GJK_SPHERE(limit + 1),
                              GJK_SPHERE(INT32_MAX),
                              GJK_SEGMENT(limit + 1),
                              GJK_CAPSULE(limit - 5, 6),
                              GJK_CAPSULE(INT32_MAX, INT32_MAX),
                              GJK_BOX(third + 1, third + 1, third + 1),
                              GJK_BOX(INT32_MAX, INT32_MAX, INT32_MAX),
                              GJK_ROUNDED_BOX(third, third, third, 2),
                              GJK_CYLINDER(half + 1, half + 1),
                              GJK_CYLINDER(INT32_MAX, INT32_MAX),
                              GJK_CONE(half + 1, half + 1),
                              GJK_ELLIPSOID(1, limit + 1, 1),
                              GJK_ELLIPSOID(INT32_MAX, INT32_MAX, INT32_MAX),
                              GJK_HULL(longer, 2),
                              GJK_HULL(whole, 2),
                              GJK_TRIANGLE(large),
                              GJK_ROUNDED_HULL(line, 2, 1),
                              GJK_CUSTOM(support_origin, NULL, limit + 1)};
  for (size_t i = 0; i < sizeof largest / sizeof largest[0]; i++) {
    CHECK_MSG(shape_status(largest[i]) == GJK_OK, "shape %lu", (unsigned long)i);
  }
  for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
    CHECK_MSG(shape_status(beyond[i]) == GJK_ERROR_SIZE, "shape %lu", (unsigned long)i);
  }
}

static void test_buffers(void) {
  static gjk_vec3 memory[12];
  union {
    gjk_collider collider;
    gjk_vec3 vertices[40];
  } shared;
  const gjk_shape hull = GJK_HULL(&memory[4], 4);
  CHECK(init_status(&hull, memory, 3) == GJK_ERROR_CAPACITY);
  CHECK(init_status(&hull, memory, 0) == GJK_ERROR_CAPACITY);
  CHECK(init_status(&hull, memory, 4) == GJK_OK);
  CHECK(init_status(&hull, &memory[8], 4) == GJK_OK);
  CHECK(init_status(&hull, &memory[4], 4) == GJK_ERROR_OVERLAP);
  CHECK(init_status(&hull, &memory[1], 4) == GJK_ERROR_OVERLAP);
  CHECK(init_status(&hull, &memory[7], 4) == GJK_ERROR_OVERLAP);
  memset(&shared, POISON, sizeof shared);
  CHECK(gjk_collider_init(&shared.collider, &hull, shared.vertices, 4) == GJK_ERROR_OVERLAP);
  CHECK(gjk_collider_init(&shared.collider, &hull, &shared.vertices[1], 4) == GJK_ERROR_OVERLAP);
  CHECK(is_untouched(&shared, sizeof shared));
  CHECK(gjk_collider_init(&shared.collider, &hull, &shared.vertices[36], 4) == GJK_OK);
}

static gjk_collider posed(const gjk_shape *shape) {
  gjk_collider collider;
  memset(&collider, 0, sizeof collider);
  CHECK(gjk_collider_init(&collider, shape, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&collider, &origin) == GJK_OK);
  return collider;
}

static bool same(const gjk_collider *a, const gjk_collider *b) {
  return memcmp(a, b, sizeof *a) == 0;
}

// A refused pose leaves the collider where it was.
static void test_poses(void) {
  static const gjk_vec3 aside[2] = {{10, 10, -10}, {12, 12, -12}};
  static const gjk_shape hull = GJK_HULL(aside, 2);
  const gjk_pose flat = {{1, 2, 3}, {0, 0, 0, 0}}, stretched = {{1, 2, 3}, {0, 0, 0, GJK_Q30_ONE + 16384}};
  const gjk_pose beyond = {{INT32_MAX - 10, 0, 0}, {0, 0, 0, GJK_Q30_ONE}};
  const gjk_pose sideways = {{0, INT32_MAX - 10, 0}, {0, 0, 0, GJK_Q30_ONE}};
  const gjk_pose below = {{0, 0, INT32_MIN + 10}, {0, 0, 0, GJK_Q30_ONE}};
  const gjk_pose at_most = {{INT32_MAX - 11, 0, INT32_MIN + 11}, {0, 0, 0, GJK_Q30_ONE}};
  gjk_collider collider = posed(&hull);
  gjk_collider before;
  memcpy(&before, &collider, sizeof before);
  CHECK(gjk_collider_pose(NULL, &origin) == GJK_ERROR_NULL);
  CHECK(gjk_collider_pose(&collider, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_collider_pose(&collider, &flat) == GJK_ERROR_ROTATION);
  CHECK(gjk_collider_pose(&collider, &stretched) == GJK_ERROR_ROTATION);
  CHECK(gjk_collider_pose(&collider, &beyond) == GJK_ERROR_RANGE);
  CHECK(gjk_collider_pose(&collider, &below) == GJK_ERROR_RANGE);
  CHECK(gjk_collider_move(NULL, &beyond.position) == GJK_ERROR_NULL);
  CHECK(gjk_collider_move(&collider, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_collider_move(&collider, &beyond.position) == GJK_ERROR_RANGE);
  CHECK(gjk_collider_pose(&collider, &sideways) == GJK_ERROR_RANGE);
  CHECK(gjk_collider_move(&collider, &below.position) == GJK_ERROR_RANGE);
  CHECK(gjk_collider_move(&collider, &sideways.position) == GJK_ERROR_RANGE);
  CHECK(same(&collider, &before));
  CHECK(gjk_collider_move(&collider, &at_most.position) == GJK_OK);
  CHECK(collider.centre.x == INT32_MAX);
  CHECK(collider.centre.z == INT32_MIN);
  CHECK(gjk_collider_pose(&collider, &at_most) == GJK_OK);
  CHECK(collider.centre.x == INT32_MAX);
}

// Moves add up: each starts where the last one ended.
static void test_moves(void) {
  const gjk_vec3 there = {100, -200, 300}, on = {-7, 8, -9};
  gjk_collider collider = posed(&cube);
  CHECK(gjk_collider_move(&collider, &there) == GJK_OK);
  CHECK(gjk_collider_move(&collider, &on) == GJK_OK);
  CHECK(collider.centre.x == -7);
  CHECK(collider.centre.y == 8);
  CHECK(collider.centre.z == -9);
}

// Only hulls use a buffer.
static void test_unused_buffer(void) {
  static gjk_vec3 memory[4];
  static const gjk_vec3 corners[3] = {{0, 0, 0}, {ONE, 0, 0}, {0, ONE, 0}};
  const gjk_shape shapes[] = {
      GJK_POINT,          GJK_SEGMENT(ONE), GJK_BOX(1, 2, 3),       GJK_TRIANGLE(corners),
      GJK_CYLINDER(5, 5), GJK_CONE(5, 5),   GJK_ELLIPSOID(1, 2, 3), GJK_CUSTOM(support_origin, NULL, 5)};
  for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
    gjk_collider collider;
    memset(&collider, POISON, sizeof collider);
    CHECK(gjk_collider_init(&collider, &shapes[i], memory, 0) == GJK_OK);
    CHECK(collider.buffer == NULL);
    CHECK(gjk_collider_pose(&collider, &origin) == GJK_OK);
  }
}

// The outputs of every query, poisoned.
typedef struct outputs {
  gjk_aabb box;
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_cache cache;
} outputs;

// Every query must refuse the pair with the status and write nothing.
static void refuse(const gjk_collider *a, const gjk_collider *b, gjk_status status) {
  outputs out;
  gjk_decision decision;
  gjk_distance_result distance;
  memset(&out, POISON, sizeof out);
  memset(&decision, 0, sizeof decision);
  memset(&distance, 0, sizeof distance);
  CHECK(gjk_intersect(a, b, &out.cache, &out.decision) == status);
  CHECK(gjk_within(a, b, 5, &out.cache, &out.decision) == status);
  CHECK(gjk_distance(a, b, &out.cache, &out.distance) == status);
  CHECK(gjk_check_decision(a, b, 5, &decision) == status);
  CHECK(gjk_check_distance(a, b, &distance) == status);
  CHECK(is_untouched(&out, sizeof out));
}

static void test_unposed(void) {
  const gjk_collider good = posed(&cube);
  gjk_collider zeroed, rubbish, unposed, before;
  gjk_aabb box;
  memset(&zeroed, 0, sizeof zeroed);
  memset(&rubbish, POISON, sizeof rubbish);
  memset(&unposed, 0, sizeof unposed);
  CHECK(gjk_collider_init(&unposed, &cube, NULL, 0) == GJK_OK);
  gjk_collider *bad[3] = {&zeroed, &rubbish, &unposed};
  memset(&box, POISON, sizeof box);
  for (int i = 0; i < 3; i++) {
    memcpy(&before, bad[i], sizeof before);
    refuse(bad[i], &good, GJK_ERROR_UNINITIALISED);
    refuse(&good, bad[i], GJK_ERROR_UNINITIALISED);
    CHECK(gjk_collider_move(bad[i], &origin.position) == GJK_ERROR_UNINITIALISED);
    CHECK(gjk_collider_aabb(bad[i], &box) == GJK_ERROR_UNINITIALISED);
    CHECK(i == 2 || gjk_collider_pose(bad[i], &origin) == GJK_ERROR_UNINITIALISED);
    CHECK(same(bad[i], &before));
  }
  CHECK(gjk_collider_aabb(NULL, &box) == GJK_ERROR_NULL);
  CHECK(gjk_collider_aabb(&good, NULL) == GJK_ERROR_NULL);
  CHECK(is_untouched(&box, sizeof box));
}

static void test_query_arguments(void) {
  const gjk_collider good = posed(&cube);
  outputs out;
  gjk_decision decision;
  memset(&out, POISON, sizeof out);
  refuse(NULL, &good, GJK_ERROR_NULL);
  refuse(&good, NULL, GJK_ERROR_NULL);
  CHECK(gjk_intersect(&good, &good, &out.cache, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_within(&good, &good, 5, &out.cache, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_distance(&good, &good, &out.cache, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_check_decision(&good, &good, 5, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_check_distance(&good, &good, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_within(&good, &good, -1, &out.cache, &out.decision) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_within(&good, &good, INT32_MIN, &out.cache, &out.decision) == GJK_ERROR_NEGATIVE);
  CHECK(is_untouched(&out, sizeof out));
  CHECK(gjk_intersect(&good, &good, NULL, &decision) == GJK_OK);
  CHECK(decision.yes);
  CHECK(gjk_check_decision(&good, &good, 0, &decision) == GJK_OK);
  CHECK(gjk_check_decision(&good, &good, -1, &decision) == GJK_ERROR_NEGATIVE);
  decision.yes = false;
  CHECK(gjk_check_decision(&good, &good, 0, &decision) == GJK_ERROR_UNPROVEN);
}

// Exact checks are for polytopes that are not too far apart.
static void test_unsupported(void) {
  static const gjk_shape drum = GJK_CYLINDER(ONE, ONE);
  const gjk_vec3 far_off = {INT32_MAX, 0, 0};
  const gjk_collider good = posed(&cube), curved = posed(&drum);
  gjk_collider away = posed(&cube);
  gjk_decision decision;
  gjk_distance_result distance;
  CHECK(gjk_within(&good, &curved, 5, NULL, &decision) == GJK_OK);
  CHECK(gjk_distance(&good, &curved, NULL, &distance) == GJK_OK);
  CHECK(gjk_check_decision(&good, &curved, 5, &decision) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_check_distance(&good, &curved, &distance) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_collider_move(&away, &far_off) == GJK_OK);
  CHECK(gjk_distance(&good, &away, NULL, &distance) == GJK_OK);
  CHECK(gjk_check_distance(&good, &away, &distance) == GJK_ERROR_UNSUPPORTED);
}

int main(void) {
  test_names();
  test_versions();
  test_null_shapes();
  test_negative_sizes();
  test_empty();
  test_triangles();
  test_sizes();
  test_buffers();
  test_poses();
  test_moves();
  test_unused_buffer();
  test_unposed();
  test_query_arguments();
  test_unsupported();
  return check_done("status");
}
