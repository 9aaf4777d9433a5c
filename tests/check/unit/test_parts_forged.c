// Bodies of many parts whose data name parts that are not there: fields of holes alone, meshes with numbers of no vertex,
// nodes with numbers of no part. Each query says so by its status, and leaves its outputs as they were.
#include <string.h>

#include "check.h"
#include "filled.h"
#include "gjk/gjk.h"
#include "placed.h"

static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
static const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};

// The queries that ask a part whatever its place is.
static void check_refusals(const gjk_parts *a) {
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
  CHECK(gjk_parts_time_of_impact(a, &still, &b, &still, &setup, &part, &impact) == GJK_ERROR_RANGE);
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
  check_refusals(&holes);
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
  const gjk_vec3 corner[3] = {{0, 0, 0}, {GJK_Q16(1.0), 0, 0}, {0, GJK_Q16(1.0), 0}};
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node node;
  gjk_mesh mesh;
  gjk_mesh_report report;
  CHECK(gjk_mesh_build(corner, 3, &triangle, 1, true, &node, 1, &mesh) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_MESH(&mesh);
  triangle.corner[1] = 3;
  CHECK(gjk_mesh_check(&mesh, &report) == GJK_OK && report.fault == GJK_MESH_NUMBER_FAULT && report.edge == 1);
  check_refusals(&body);
}

int main(void) {
  test_holes();
  test_nodes();
  test_numbers();
  return check_done("parts forged");
}
