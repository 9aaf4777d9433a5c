// Bodies of many parts whose data name parts that are not there: fields of holes alone, meshes with numbers of no vertex,
// nodes with numbers of no part. And arguments that are missing or not as they must be. Each query says so by its status, and
// leaves its outputs as they were.
#include <string.h>

#include "check.h"
#include "filled.h"
#include "gjk/gjk.h"
#include "placed.h"

static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};

// The queries that ask a part whatever its place is. moving: what the last one says, which begins with the shape.
static void check_refusals(const gjk_parts *a, gjk_status moving) {
  const gjk_collider b = posed(&ball, &still.from);
  const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN, 0};
  gjk_distance_result distance;
  gjk_impact_result impact;
  gjk_parts_room room;
  gjk_collider c;
  uint32_t part = 77;
  memset(&distance, POISON, sizeof distance);
  memset(&impact, POISON, sizeof impact);
  CHECK(gjk_parts_place(a, 0, &room, &c) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_distance(a, &b, &part, &distance) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_time_of_impact(a, &still, &b, &still, &setup, &part, &impact) == moving);
  CHECK(part == 77 && is_untouched(&distance, sizeof distance) && is_untouched(&impact, sizeof impact));
}

static void test_holes(void) {
  const int16_t heights[6] = {GJK_HEIGHT_HOLE, 3, GJK_HEIGHT_HOLE, GJK_HEIGHT_HOLE, GJK_HEIGHT_HOLE, 5};
  const gjk_height_field field = GJK_HEIGHT_FIELD(heights, 3, 2, GJK_Q16(1.0), GJK_Q16(1.0), 100);
  const gjk_parts holes = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  const gjk_compound_part one = {&ball, GJK_POSE_IDENTITY};
  gjk_compound_node node;
  gjk_compound compound;
  gjk_parts_pair pair = {77, 77};
  gjk_distance_result distance;
  gjk_decision decision;
  gjk_penetration_result depth;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts balls = GJK_PARTS_OF_COMPOUND(&compound);
  CHECK(gjk_height_field_check(&field) == GJK_ERROR_EMPTY && gjk_parts_count(&holes) == 4);
  check_refusals(&holes, GJK_ERROR_RANGE);
  memset(&distance, POISON, sizeof distance);
  CHECK(gjk_parts_both_distance(&balls, &holes, &pair, &distance) == GJK_ERROR_EMPTY);
  CHECK(is_untouched(&distance, sizeof distance) && pair.a == 77 && pair.b == 77);
  CHECK(gjk_parts_both_distance(&holes, &balls, &pair, &distance) == GJK_ERROR_RANGE);
  CHECK(is_untouched(&distance, sizeof distance) && pair.a == 77 && pair.b == 77);
  CHECK(gjk_parts_both_within(&balls, &holes, 0, &pair, &decision) == GJK_OK && !decision.yes);
  CHECK(pair.a == GJK_PARTS_NONE && pair.b == GJK_PARTS_NONE);
  CHECK(gjk_parts_both_penetration(&balls, &holes, NULL, &pair, &depth) == GJK_OK && !depth.intersecting);
  CHECK(pair.a == GJK_PARTS_NONE && pair.b == GJK_PARTS_NONE);
}

// Parts of a compound that have changed since it was built: one that is no rotation, one out of the compound's reach.
static void test_changed_parts(void) {
  gjk_compound_part part = {&ball, GJK_POSE_IDENTITY};
  const gjk_vec3 at = {GJK_Q16(3.0), 0, 0}, far = {INT32_MAX, 0, 0};
  const gjk_collider b = posed(&ball, &still.from);
  const gjk_motion moving = {{at, {0, 0, 0, GJK_Q30_ONE}}, GJK_POSE_IDENTITY, {0, 0, 0}};
  const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN, 0};
  gjk_compound_node node;
  gjk_compound compound;
  CHECK(gjk_compound_build(&part, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  for (int k = 0; k < 2; k++) {
    gjk_impact_result impact;
    gjk_distance_result distance;
    uint32_t number = 77;
    memset(&impact, POISON, sizeof impact);
    part.pose.position = k == 0 ? part.pose.position : far;
    part.pose.rotation.w = k == 0 ? GJK_Q30_ONE / 2 : GJK_Q30_ONE;
    const gjk_status status = k == 0 ? GJK_ERROR_ROTATION : GJK_ERROR_RANGE;
    CHECK(gjk_parts_distance(&body, &b, &number, &distance) == (k == 0 ? status : GJK_OK));
    number = 77;
    CHECK(gjk_parts_time_of_impact(&body, &moving, &b, &still, &setup, &number, &impact) == status);
    CHECK(number == 77 && is_untouched(&impact, sizeof impact));
  }
}

static void test_nodes(void) {
  const gjk_compound_part parts[2] = {{&ball, GJK_POSE_IDENTITY}, {&ball, GJK_POSE_IDENTITY}};
  gjk_compound_node nodes[2];
  gjk_compound compound;
  CHECK(gjk_compound_build(parts, 2, nodes, 2, &compound) == GJK_OK);
  compound.count = 1;  // so the second node's part is beyond the end
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  const gjk_collider b = posed(&ball, &still.from);
  const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN, 0};
  gjk_impact_result impact;
  gjk_distance_result distance;
  uint32_t part = 77;
  memset(&impact, POISON, sizeof impact);
  memset(&distance, POISON, sizeof distance);
  CHECK(gjk_parts_time_of_impact(&body, &still, &b, &still, &setup, &part, &impact) == GJK_ERROR_RANGE);
  CHECK(part == 77 && is_untouched(&impact, sizeof impact));
  const gjk_vec3 apart = {GJK_Q16(3.0), 0, 0};
  gjk_collider far = posed(&ball, &still.from);
  CHECK(gjk_collider_move(&far, &apart) == GJK_OK);
  CHECK(gjk_parts_distance(&body, &far, &part, &distance) == GJK_ERROR_RANGE);
  CHECK(part == 77 && is_untouched(&distance, sizeof distance));
}

static void test_numbers(void) {
  gjk_vec3 corner[3] = {{0, 0, 0}, {GJK_Q16(1.0), 0, 0}, {0, GJK_Q16(1.0), 0}};
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node node;
  gjk_mesh mesh;
  gjk_mesh_report report;
  CHECK(gjk_mesh_build(corner, 3, &triangle, 1, true, &node, 1, &mesh) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_MESH(&mesh);
  corner[1].x = GJK_MESH_COORDINATE_MAX + 1;
  check_refusals(&body, GJK_ERROR_SIZE);
  corner[1].x = GJK_Q16(1.0);
  triangle.corner[1] = 3;
  CHECK(gjk_mesh_check(&mesh, &report) == GJK_OK && report.fault == GJK_MESH_NUMBER_FAULT && report.edge == 1);
  check_refusals(&body, GJK_ERROR_RANGE);
}

// The arguments of a query that it may refuse, each a pointer, and queries that take some of them.
enum { A, BODY_B, B, MOTION_A, MOTION_B, SETUP, PATH, FROM, TO, MANIFOLDS, COUNT, OUT, ARGUMENTS };

// What they write.
static union {
  gjk_collider collider;
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result depth;
  gjk_cast_result cast;
  gjk_impact_result impact;
} out;
static union {
  gjk_parts_room room;
  gjk_parts_manifold manifold;
} room;
static gjk_parts_pair numbers;
static uint32_t count;

#define ASK(name, ...)                            \
  static gjk_status ask_##name(void *const p[]) { \
    return gjk_parts_##name(__VA_ARGS__);         \
  }
ASK(place, p[A], 0, p[MANIFOLDS], p[OUT])
ASK(intersect, p[A], p[B], &numbers.a, p[OUT])
ASK(within, p[A], p[B], 5, &numbers.a, p[OUT])
ASK(distance, p[A], p[B], &numbers.a, p[OUT])
ASK(penetration, p[A], p[B], NULL, &numbers.a, p[OUT])
ASK(contacts, p[A], p[B], 0, 4, NULL, p[MANIFOLDS], 1, p[COUNT])
ASK(manifolds, p[A], p[B], 0, 4, NULL, p[MANIFOLDS], 1, p[COUNT])
ASK(cast, p[A], p[B], p[PATH], &numbers.a, p[OUT])
ASK(cast_ahead, p[A], p[B], p[PATH], &numbers.a, p[OUT])
ASK(cast_ray, p[A], p[FROM], p[TO], &numbers.a, p[OUT])
ASK(time_of_impact, p[A], p[MOTION_A], p[B], p[MOTION_B], p[SETUP], &numbers.a, p[OUT])
ASK(impact_ahead, p[A], p[MOTION_A], p[B], p[MOTION_B], p[SETUP], &numbers.a, p[OUT])
ASK(both_within, p[A], p[BODY_B], 5, &numbers, p[OUT])
ASK(both_distance, p[A], p[BODY_B], &numbers, p[OUT])
ASK(both_penetration, p[A], p[BODY_B], NULL, &numbers, p[OUT])
ASK(both_contacts, p[A], p[BODY_B], 0, 4, NULL, p[MANIFOLDS], 1, p[COUNT])
ASK(both_manifolds, p[A], p[BODY_B], 0, 4, NULL, p[MANIFOLDS], 1, p[COUNT])
ASK(both_cast, p[A], p[BODY_B], p[PATH], &numbers, p[OUT])
ASK(both_time_of_impact, p[A], p[MOTION_A], p[BODY_B], p[MOTION_B], p[SETUP], &numbers, p[OUT])

// How many arguments a query takes, and whether the poses of its bodies are read: else motions have them.
static const struct {
  gjk_status (*ask)(void *const p[]);
  unsigned takes;
  bool posed;
} queries[] = {{ask_place, 3, true},
               {ask_intersect, 3, true},
               {ask_within, 3, true},
               {ask_distance, 3, true},
               {ask_penetration, 3, true},
               {ask_contacts, 4, true},
               {ask_manifolds, 4, true},
               {ask_cast, 4, true},
               {ask_cast_ahead, 4, true},
               {ask_cast_ray, 4, true},
               {ask_time_of_impact, 6, false},
               {ask_impact_ahead, 6, false},
               {ask_both_within, 3, true},
               {ask_both_distance, 3, true},
               {ask_both_penetration, 3, true},
               {ask_both_contacts, 4, true},
               {ask_both_manifolds, 4, true},
               {ask_both_cast, 4, true},
               {ask_both_time_of_impact, 6, false}};

// Asks with an argument in place of the usual one. Returns whether the query refuses it: it answers, or leaves its outputs as
// they were and says why.
static bool refuses(unsigned query, void *const usual[], unsigned argument, void *instead, gjk_status expected) {
  void *p[ARGUMENTS];
  memcpy(p, usual, sizeof p);
  memset(&out, POISON, sizeof out);
  memset(&count, POISON, sizeof count);
  memset(&numbers, POISON, sizeof numbers);
  p[argument] = instead;
  const gjk_status status = queries[query].ask(p);
  if (status == GJK_OK) {
    return false;
  }
  CHECK_MSG(status == expected, "query %u, argument %u: %s", query, argument, gjk_status_name(status));
  CHECK_MSG(
      is_untouched(&out, sizeof out) && is_untouched(&count, sizeof count) && is_untouched(&numbers, sizeof numbers),
      "query %u, argument %u", query, argument);
  return true;
}

// Each argument that a query takes missing in turn, or not as it must be.
static void test_arguments(void) {
  const gjk_compound_part one = {&ball, GJK_POSE_IDENTITY};
  const gjk_compound nothing = {0};
  gjk_compound_node node;
  gjk_compound compound;
  gjk_collider b = posed(&ball, &still.from), never = {0};
  gjk_motion motion[2] = {still, still};
  gjk_impact_setup setup = {0, GJK_PARTS_BOTH_TOLERANCE_MIN, 0};
  gjk_cast_path path = {NULL, NULL, 0};
  gjk_vec3 at[2] = {{0, 0, 0}, {0, 0, 0}};
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  gjk_parts body[2] = {GJK_PARTS_OF_COMPOUND(&compound), GJK_PARTS_OF_COMPOUND(&compound)};
  void *const usual[ARGUMENTS] = {&body[0], &body[1], &b,     &motion[0], &motion[1], &setup,
                                  &path,    &at[0],   &at[1], &room,      &count,     &out};
  gjk_parts bad[5] = {body[0], body[0], body[0], body[0], body[0]};
  const gjk_status expected[5] = {GJK_ERROR_NULL, GJK_ERROR_NULL, GJK_ERROR_EMPTY, GJK_ERROR_ROTATION, GJK_ERROR_RANGE};
  const gjk_vec3 far = {INT32_MAX, 0, 0};
  gjk_cast_path paths[3] = {{NULL, NULL, -1}, {&far, NULL, 0}, {NULL, &far, 0}};
  bad[0].type = NULL;
  bad[1].data = NULL;
  bad[2].data = &nothing;
  bad[3].pose.rotation.w = 0;
  bad[4].pose.position.y = INT32_MAX;
  for (unsigned query = 0; query < sizeof queries / sizeof queries[0]; query++) {
    unsigned taken = 0;
    for (unsigned argument = 0; argument < ARGUMENTS; argument++) {
      taken += refuses(query, usual, argument, NULL, GJK_ERROR_NULL);
    }
    CHECK_MSG(taken == queries[query].takes, "query %u", query);
    const bool takes_body = refuses(query, usual, BODY_B, NULL, GJK_ERROR_NULL),
               takes_collider = refuses(query, usual, B, NULL, GJK_ERROR_NULL),
               takes_path = refuses(query, usual, PATH, NULL, GJK_ERROR_NULL);
    CHECK(refuses(query, usual, PATH, &paths[0], GJK_ERROR_NEGATIVE) == takes_path);
    CHECK(refuses(query, usual, PATH, &paths[1], GJK_ERROR_RANGE) == takes_path);
    CHECK(!takes_body || refuses(query, usual, PATH, &paths[2], GJK_ERROR_RANGE) == takes_path);
    CHECK(refuses(query, usual, B, &never, GJK_ERROR_UNINITIALISED) == takes_collider);
    for (unsigned i = 0; i < 5; i++) {
      const bool read = i < 3 || queries[query].posed;
      CHECK(refuses(query, usual, A, &bad[i], expected[i]) == read);
      CHECK(refuses(query, usual, BODY_B, &bad[i], expected[i]) == (takes_body && read));
    }
  }
}

// A part whose rotation was damaged after its compound was built, or a triangle that has grown since along one or two
// axes: each query that meets it says so, and writes nothing.
static void test_damaged(gjk_status expected, gjk_q16 x, gjk_q16 y) {
  gjk_compound_part one = {&ball, GJK_POSE_IDENTITY}, other = {&ball, GJK_POSE_IDENTITY};
  gjk_vec3 corner[3] = {{0, 0, 0}, {GJK_Q16(1.0), 0, 0}, {0, GJK_Q16(1.0), 0}};
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node leaf;
  gjk_mesh mesh;
  gjk_compound_node node[2];
  gjk_compound compound[2];
  gjk_collider b = posed(&ball, &still.from);
  gjk_motion motion[2] = {still, still};
  gjk_impact_setup setup = {0, GJK_PARTS_BOTH_TOLERANCE_MIN, 0};
  gjk_cast_path path = {NULL, NULL, 0};
  gjk_vec3 at[2] = {{0, 0, 0}, {0, 0, 0}};
  CHECK(gjk_compound_build(&one, 1, &node[0], 1, &compound[0]) == GJK_OK);
  CHECK(gjk_compound_build(&other, 1, &node[1], 1, &compound[1]) == GJK_OK);
  CHECK(gjk_mesh_build(corner, 3, &triangle, 1, true, &leaf, 1, &mesh) == GJK_OK);
  one.pose.rotation.w = GJK_Q30_ONE / 2;
  corner[1].x = x;
  corner[2].y = y;
  gjk_parts turned = GJK_PARTS_OF_COMPOUND(&compound[0]), grown = GJK_PARTS_OF_MESH(&mesh),
            bad = expected == GJK_ERROR_ROTATION ? turned : grown,
            good[2] = {GJK_PARTS_OF_COMPOUND(&compound[1]), GJK_PARTS_OF_COMPOUND(&compound[1])};
  void *const usual[ARGUMENTS] = {&good[0], &good[1], &b,     &motion[0], &motion[1], &setup,
                                  &path,    &at[0],   &at[1], &room,      &count,     &out};
  for (unsigned query = 0; query < sizeof queries / sizeof queries[0]; query++) {
    CHECK_MSG(refuses(query, usual, A, &bad, expected), "query %u", query);
    const bool takes_body = refuses(query, usual, BODY_B, NULL, GJK_ERROR_NULL);
    CHECK_MSG(refuses(query, usual, BODY_B, &bad, expected) == takes_body, "query %u of two bodies", query);
  }
  gjk_concave concave;
  gjk_shape shape;
  gjk_surface_contact contact;
  uint16_t contacts = 77;
  memset(&concave, POISON, sizeof concave);
  memset(&shape, POISON, sizeof shape);
  CHECK(gjk_concave_init(&bad, &concave, &shape) == expected);
  CHECK(is_untouched(&concave, sizeof concave) && is_untouched(&shape, sizeof shape));
  const gjk_status of_surface = expected == GJK_ERROR_SIZE ? expected : GJK_ERROR_UNSUPPORTED;
  CHECK(gjk_surface_contacts(&bad, &b, 0, 4, NULL, &contact, 1, &contacts) == of_surface && contacts == 77);
}

int main(void) {
  test_arguments();
  test_damaged(GJK_ERROR_ROTATION, 0, 0);
  test_damaged(GJK_ERROR_SIZE, INT32_C(1) << 29, GJK_Q16(1.0));
  test_damaged(GJK_ERROR_SIZE, 2 * GJK_RADIUS_MAX, 2 * GJK_RADIUS_MAX);
  test_holes();
  test_changed_parts();
  test_nodes();
  test_numbers();
  return check_done("parts forged");
}
