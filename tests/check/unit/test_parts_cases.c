// Bodies of many parts, case by case: contacts over a seam, statuses of two bodies, what is ahead of a surface on either
// side.
#include <string.h>

#include "check.h"
#include "filled.h"
#include "gjk/gjk.h"
#include "parts_answers.h"
#include "placed.h"
#include "src/parts/gjk_parts_class.h"
#include "whorl.h"

static const gjk_shape crate = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));

static gjk_collider at_height(const gjk_shape *shape, gjk_q16 z) {
  const gjk_vec3 at = {0, 0, z};
  return placed(shape, at);
}

// Two crates side by side make a floor. A third one in the middle above has one manifold, of contacts with both, also where
// the other way about.
static void test_seam(void) {
  gjk_compound_part parts[2] = {{&crate, GJK_POSE_IDENTITY}, {&crate, GJK_POSE_IDENTITY}};
  gjk_compound_node nodes[2];
  gjk_compound floor;
  parts[0].pose.position.x = -GJK_Q16(1);
  parts[1].pose.position.x = GJK_Q16(1);
  CHECK(gjk_compound_build(parts, 2, nodes, 2, &floor) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&floor);
  const gjk_collider above = at_height(&crate, GJK_Q16(2));
  gjk_parts_manifold each[2];
  gjk_manifold joined[4];
  uint32_t separate;
  unsigned count;
  CHECK(gjk_parts_contacts(&body, &above, 100, 4, NULL, each, 2, &separate) == GJK_OK && separate == 2);
  CHECK(gjk_parts_manifolds(&body, &above, 100, 4, NULL, joined, 4, &count) == GJK_OK && count == 1);
  CHECK(joined[0].normal.z == GJK_Q30_ONE && joined[0].count == 4);
  gjk_manifold one;
  CHECK(gjk_parts_manifolds(&body, &above, 100, 1, NULL, &one, 1, &count) == GJK_OK && count == 1 && one.count == 1);
  gjk_q16 least = 0, most = 0;
  for (unsigned i = 0; i < joined[0].count; i++) {
    const gjk_contact *p = &joined[0].contact[i];
    CHECK(p->distance == 0 && p->point_a.z == GJK_Q16(1) &&
          (p->point_a.y == GJK_Q16(1) || p->point_a.y == -GJK_Q16(1)));
    least = p->point_a.x < least ? p->point_a.x : least;
    most = p->point_a.x > most ? p->point_a.x : most;
  }
  CHECK(least == -GJK_Q16(1) && most == GJK_Q16(1));
  // One manifold more where a third part touches from the side.
  gjk_compound_part three[3] = {parts[0], parts[1], {&crate, GJK_POSE_IDENTITY}};
  gjk_compound_node room[3];
  three[2].pose.position.x = GJK_Q16(2);
  three[2].pose.position.z = GJK_Q16(2);
  CHECK(gjk_compound_build(three, 3, room, 3, &floor) == GJK_OK);
  CHECK(gjk_parts_manifolds(&body, &above, 100, 4, NULL, joined, 4, &count) == GJK_OK && count == 2);
}

// Such a floor of parts 90 and 264, whose numbers give a contact of each the same id: the ids of a manifold differ.
static void test_ids(void) {
  static gjk_compound_part parts[265];
  static gjk_compound_node nodes[GJK_COMPOUND_NODES(265)];
  const gjk_compound_part below = {&crate, {{0, 0, -GJK_Q16(99)}, {0, 0, 0, GJK_Q30_ONE}}};
  const gjk_collider above = at_height(&crate, GJK_Q16(2));
  gjk_compound floor;
  gjk_manifold joined;
  unsigned count;
  for (unsigned i = 0; i < 265; i++) {
    parts[i] = below;
  }
  parts[90].pose.position.z = parts[264].pose.position.z = 0;
  parts[90].pose.position.x = -GJK_Q16(1);
  parts[264].pose.position.x = GJK_Q16(1);
  CHECK(gjk_compound_build(parts, 265, nodes, GJK_COMPOUND_NODES(265), &floor) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&floor);
  CHECK(gjk_parts_manifolds(&body, &above, 100, GJK_CONTACTS_MAX, NULL, &joined, 1, &count) == GJK_OK);
  CHECK(count == 1 && joined.count == 6);
  for (unsigned i = 0; i < joined.count; i++) {
    for (unsigned k = 0; k < i; k++) {
      CHECK(joined.contact[i].id != joined.contact[k].id);
    }
  }
}

// A part on two others, or below two: of these the second one is turned, so that it meets with another face, and either may be
// the deeper one, which gives the features.
static void test_features(bool two_of_a, unsigned deeper) {
  gjk_compound_part two[2] = {{&crate, {{-GJK_Q16(1), 0, 0}, {0, 0, 0, GJK_Q30_ONE}}},
                              {&crate, {{GJK_Q16(1), 0, 0}, {GJK_Q30_ONE, 0, 0, 0}}}};
  const gjk_compound_part one = {&crate, GJK_POSE_IDENTITY};
  gjk_compound_node nodes[3];
  gjk_compound of_two, of_one;
  gjk_parts_manifold each[2];
  gjk_manifold joined[2];
  uint32_t separate;
  unsigned count;
  two[deeper].pose.position.z = two_of_a ? 10 : -10;
  CHECK(gjk_compound_build(two, 2, nodes, 2, &of_two) == GJK_OK);
  CHECK(gjk_compound_build(&one, 1, nodes + 2, 1, &of_one) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(two_of_a ? &of_two : &of_one);
  gjk_parts above = GJK_PARTS_OF_COMPOUND(two_of_a ? &of_one : &of_two);
  above.pose.position.z = GJK_Q16(2);
  CHECK(gjk_parts_both_contacts(&body, &above, 100, 4, NULL, each, 2, &separate) == GJK_OK && separate == 2);
  CHECK(gjk_parts_both_manifolds(&body, &above, 100, 4, NULL, joined, 2, &count) == GJK_OK && count == 1);
  const gjk_manifold *deep = &each[deeper].manifold, *other = &each[1 - deeper].manifold;
  CHECK(deep->feature_a != other->feature_a || deep->feature_b != other->feature_b);
  CHECK(joined[0].feature_a == deep->feature_a && joined[0].feature_b == deep->feature_b);
}

static void test_statuses_of_both(void) {
  const gjk_compound_part one = {&crate, GJK_POSE_IDENTITY};
  gjk_compound_node node;
  gjk_compound compound;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(&compound);
  gjk_parts b = GJK_PARTS_OF_COMPOUND(&compound), turned = GJK_PARTS_OF_COMPOUND(&compound);
  gjk_parts_pair pair = {77, 77};
  gjk_decision decision;
  b.pose.position.x = GJK_Q16(3);
  turned.pose.rotation.w = 0;
  CHECK(gjk_parts_both_within(&a, &b, -1, &pair, &decision) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_parts_both_within(&a, &turned, -1, &pair, &decision) == GJK_ERROR_ROTATION);
  CHECK(gjk_parts_both_within(&a, &turned, 0, &pair, &decision) == GJK_ERROR_ROTATION);
  CHECK(gjk_parts_both_within(&turned, &b, 0, &pair, &decision) == GJK_ERROR_ROTATION);
  CHECK(pair.a == 77 && pair.b == 77);
  CHECK(gjk_parts_both_within(&a, &b, GJK_Q16(1) - 1, &pair, &decision) == GJK_OK && !decision.yes);
  CHECK(pair.a == GJK_PARTS_NONE && pair.b == GJK_PARTS_NONE);
  CHECK(gjk_parts_both_within(&a, &b, GJK_Q16(1), &pair, &decision) == GJK_OK && decision.yes);
  CHECK(pair.a == 0 && pair.b == 0);
}

// One number out of its range at a time.
static void test_statuses_of_impacts(void) {
  const gjk_compound_part one = {&crate, GJK_POSE_IDENTITY};
  const gjk_impact_setup good = {0, GJK_PARTS_TOLERANCE_MIN, 0}, loose = {0, GJK_PARTS_TOLERANCE_MIN - 1, 0},
                         far = {GJK_IMPACT_MARGIN_MAX + 1, GJK_Q16(1), 0}, behind = {-1, GJK_Q16(1), 0};
  const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  gjk_motion out = still;
  gjk_compound_node node;
  gjk_compound compound;
  gjk_impact_result impact;
  uint32_t part = 77;
  const gjk_collider b = at_height(&ball, 0);
  out.to.position.x = INT32_MAX;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(&compound);
  CHECK(gjk_parts_time_of_impact(&a, &still, &b, &still, &loose, &part, &impact) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_time_of_impact(&a, &still, &b, &still, &far, &part, &impact) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_time_of_impact(&a, &still, &b, &still, &behind, &part, &impact) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_parts_time_of_impact(&a, &out, &b, &still, &good, &part, &impact) == GJK_ERROR_RANGE);
  CHECK(part == 77);
  CHECK(gjk_parts_time_of_impact(&a, &still, &b, &still, &good, &part, &impact) == GJK_OK && impact.overlap &&
        part == 0);
}

// A part on either side of 4096 units, and a ball of such a radius that the least tolerance is a little above a whole number.
static void test_tolerance_far_away(gjk_q16 away) {
  const gjk_compound_part one = {&crate, {{away, 0, 0}, {0, 0, 0, GJK_Q30_ONE}}};
  const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  gjk_compound_node node;
  gjk_compound compound;
  gjk_impact_result impact;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(&compound);
  const int32_t excess = (int32_t)a.type->reach(a.data) - GJK_Q16(256), step = INT32_C(1) << 23;
  const int32_t radius = step - excess % step + step / 64;  // excess and radius are a multiple of step and a 64th of it
  const gjk_shape big = GJK_SPHERE(radius);
  const gjk_collider b = at_height(&big, 0);
  const gjk_q16 whole = GJK_PARTS_TOLERANCE_MIN + (excess + radius) / step + (away > GJK_Q16(4096) ? 11 : 0);
  const gjk_impact_setup less = {0, whole, 0}, enough = {0, whole + 1, 0};
  CHECK(gjk_parts_time_of_impact(&a, &still, &b, &still, &less, NULL, &impact) == GJK_ERROR_RANGE);
  CHECK(gjk_parts_time_of_impact(&a, &still, &b, &still, &enough, NULL, &impact) == GJK_OK && !impact.hit);
}

// A ball on one side of a triangle that goes through its plane. side 1: it begins in front, -1: behind; gap: between ball and
// plane at the start. The first touch is where the gap is 0, or the margin.
static void check_ahead(bool two_sided, int side, gjk_q16 gap, gjk_q16 margin, bool expected) {
  const gjk_vec3 corner[3] = {{-GJK_Q16(20), -GJK_Q16(20), 0}, {GJK_Q16(20), -GJK_Q16(20), 0}, {0, GJK_Q16(20), 0}};
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node node;
  gjk_mesh mesh;
  CHECK(gjk_mesh_build(corner, 3, &triangle, 1, two_sided, &node, 1, &mesh) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_MESH(&mesh);
  const gjk_q16 from = side * (gap + GJK_Q16(0.5)), length = GJK_Q16(8);
  const gjk_collider b = at_height(&ball, from);
  const gjk_vec3 to = {0, 0, from - side * length};
  const gjk_cast_path path = {NULL, &to, margin};
  const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  gjk_motion way = still;
  const gjk_impact_setup setup = {margin, GJK_PARTS_TOLERANCE_MIN, 0};
  gjk_cast_result cast;
  gjk_impact_result impact;
  uint32_t part;
  way.from.position.z = from;
  way.to.position = to;
  CHECK(gjk_parts_cast_ahead(&body, &b, &path, &part, &cast) == GJK_OK);
  CHECK_MSG(cast.hit == expected && (part == 0) == expected, "sides %d, side %d, gap %ld, margin %ld", two_sided, side,
            (long)gap, (long)margin);
  if (expected) {
    // An LSB is 2048 of the way's parts.
    const int64_t due = (((int64_t)gap - margin) << 30) / length, off = cast.fraction - due;
    CHECK_MSG(off >= -2048 && off <= 0 && side * cast.normal.z >= GJK_Q30_ONE - 2, "%ld", (long)off);
  }
  CHECK(gjk_parts_impact_ahead(&body, &still, &b, &way, &setup, &part, &impact) == GJK_OK);
  CHECK_MSG(impact.hit == expected && (part == 0) == expected, "impact: sides %d, side %d, gap %ld, margin %ld",
            two_sided, side, (long)gap, (long)margin);
}

static void test_ahead(void) {
  for (int side = -1; side <= 1; side += 2) {
    check_ahead(true, side, GJK_Q16(3), 0, true);
    check_ahead(true, side, GJK_Q16(3), GJK_Q16(1), true);
    check_ahead(true, side, GJK_Q16(1), GJK_Q16(2), false);  // the margin reaches the plane
    check_ahead(true, side, -100, 0, false);                 // the ball does
    check_ahead(false, side, GJK_Q16(3), 0, side > 0);
    check_ahead(false, side, -100, 0, false);
  }
}

// A beam that lies above a triangle and stands on end at the end of its way, as a hull. With a buffer or without: the same
// answer, and the buffer holds the vertices of the beam as it is posed, before and after.
static void test_ahead_of_baked(void) {
  static const gjk_vec3 corner[3] = {
      {-GJK_Q16(20), -GJK_Q16(20), 0}, {GJK_Q16(20), -GJK_Q16(20), 0}, {0, GJK_Q16(20), 0}};
  static gjk_vec3 vertices[8];
  gjk_vec3 buffer[8], before[8];
  for (unsigned i = 0; i < 8; i++) {
    vertices[i].x = (i & 1u) != 0 ? GJK_Q16(3) : -GJK_Q16(3);
    vertices[i].y = (i & 2u) != 0 ? GJK_Q16(0.5) : -GJK_Q16(0.5);
    vertices[i].z = (i & 4u) != 0 ? GJK_Q16(0.5) : -GJK_Q16(0.5);
  }
  const gjk_shape beam = GJK_HULL(vertices, 8);
  const gjk_vec3 across = {0, GJK_Q16_ONE, 0};
  const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN, 0};
  const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  gjk_motion way = still;
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node node;
  gjk_mesh mesh;
  gjk_collider baked, lazy;
  gjk_impact_result of_baked, of_lazy;
  uint32_t part;
  CHECK(gjk_mesh_build(corner, 3, &triangle, 1, false, &node, 1, &mesh) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_MESH(&mesh);
  way.from.position.z = GJK_Q16(2);
  way.to.position.z = GJK_Q16(2);
  CHECK(gjk_quat_from_axis_angle(&across, GJK_ANGLE(1.5707963), &way.to.rotation) == GJK_OK);
  CHECK(gjk_collider_init(&baked, &beam, buffer, 8) == GJK_OK && gjk_collider_pose(&baked, &way.from) == GJK_OK);
  CHECK(gjk_collider_init(&lazy, &beam, NULL, 0) == GJK_OK);
  memcpy(before, buffer, sizeof before);
  CHECK(gjk_parts_impact_ahead(&body, &still, &baked, &way, &setup, &part, &of_baked) == GJK_OK);
  CHECK(of_baked.hit && !of_baked.overlap && part == 0);
  CHECK(memcmp(before, buffer, sizeof before) == 0);
  CHECK(gjk_parts_impact_ahead(&body, &still, &lazy, &way, &setup, &part, &of_lazy) == GJK_OK);
  CHECK(of_lazy.hit && part == 0 && of_lazy.lower == of_baked.lower && of_lazy.distance == of_baked.distance);
}

// A way that takes the centre of a collider beyond int32, along one axis, but not its position.
static void test_cast_out_of_range(gjk_vec3 axis) {
  static const gjk_vec3 corner[3] = {{900, 1000, 1000}, {1100, 1000, 1000}, {1000, 1100, 1100}};
  static const gjk_shape triangle = GJK_TRIANGLE(corner);
  const gjk_compound_part one = {&crate, GJK_POSE_IDENTITY};
  const gjk_q16 from = INT32_MAX - 1200, to = INT32_MAX - 200;
  const gjk_vec3 end = {axis.x * to, axis.y * to, axis.z * to};
  const gjk_cast_path path = {NULL, &end, 0};
  gjk_pose at = {{axis.x * from, axis.y * from, axis.z * from}, {0, 0, 0, GJK_Q30_ONE}};
  gjk_compound_node node;
  gjk_compound compound;
  gjk_cast_result cast;
  uint32_t part = 77;
  gjk_collider b = at_height(&triangle, 0);
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK && gjk_collider_pose(&b, &at) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  CHECK(gjk_parts_cast(&body, &b, &path, &part, &cast) == GJK_ERROR_RANGE && part == 77);
}

// A support that reaches farther with each call: not all casts of a part end, and then that of the body says so.
static void growing_support(const void *user, const gjk_vec3 *d, gjk_vec3 *out) {
  static int32_t calls;
  (void)user;
  const int32_t reach = 200 * (calls++ % 700);
  out->x = d->x > 0 ? reach : -reach;
  out->y = d->y > 0 ? reach : -reach;
  out->z = d->z > 0 ? reach : -reach;
}

static void test_cast_limited(void) {
  static const gjk_shape growing = GJK_CUSTOM(growing_support, NULL, 250000);
  const gjk_compound_part one = {&crate, GJK_POSE_IDENTITY};
  gjk_compound_node node;
  gjk_compound compound;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  body.pose.position.z = -2000000000;
  const gjk_collider b = at_height(&growing, 2000000000);
  gjk_cast_result out;
  uint32_t part;
  unsigned limited = 0;
  for (gjk_q16 k = 0; k < 80; k++) {
    const gjk_vec3 to = {0, 0, k / 8 * 100000000};
    const gjk_cast_path path = {NULL, &to, INT32_MAX - k % 8};
    const gjk_status status = gjk_parts_cast(&body, &b, &path, &part, &out);
    limited += status == GJK_ERROR_ITERATION_LIMIT && part == 0 && !out.hit;
  }
  CHECK(limited > 0);
}

// A shape that no search settles and a crate beside the point where it does not, in either order, as A against a ball
// there, or as B. The distance is that of the nearer part, and bounded by the part that has not settled if that may be
// nearer. beyond: the crate is nearer than both bounds, between them, or farther away.
static void test_distance_limited(int beyond, unsigned spiral, bool as_b) {
  const gjk_collider alone = at_height(&whorl, 0);
  gjk_collider c = at_height(&ball, 0);
  gjk_compound_part two[2] = {{&crate, GJK_POSE_IDENTITY}, {&crate, GJK_POSE_IDENTITY}};
  const gjk_compound_part one = {&ball, {whorl_point, {0, 0, 0, GJK_Q30_ONE}}};
  gjk_compound_node nodes[3];
  gjk_compound of_two, of_one;
  gjk_distance_result own, each[2], out;
  gjk_status status[2];
  gjk_parts_pair pair = {77, 77};
  two[spiral].shape = &whorl;
  CHECK(gjk_collider_pose(&c, &one.pose) == GJK_OK);
  CHECK(gjk_distance(&alone, &c, NULL, &own) == GJK_ERROR_ITERATION_LIMIT && own.lower + 10 < own.upper);
  two[1 - spiral].pose.position.x =
      whorl_point.x + GJK_Q16(1.5) + (own.lower + own.upper) / 2 + beyond * (own.upper - own.lower);
  two[1 - spiral].pose.position.z = whorl_point.z;
  CHECK(gjk_compound_build(two, 2, nodes, 2, &of_two) == GJK_OK);
  CHECK(gjk_compound_build(&one, 1, nodes + 2, 1, &of_one) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(as_b ? &of_one : &of_two),
                  b = GJK_PARTS_OF_COMPOUND(as_b ? &of_two : &of_one);
  for (unsigned i = 0; i < 2; i++) {
    gjk_parts_room room[2];
    gjk_collider of_a, of_b;
    CHECK(gjk_parts_place(&a, as_b ? 0 : i, &room[0], &of_a) == GJK_OK);
    CHECK(gjk_parts_place(&b, as_b ? i : 0, &room[1], &of_b) == GJK_OK);
    status[i] = gjk_distance(&of_a, &of_b, NULL, &each[i]);
  }
  CHECK(status[spiral] == GJK_ERROR_ITERATION_LIMIT && status[1 - spiral] == GJK_OK);
  const unsigned nearest = each[1].distance < each[0].distance ? 1 : 0;
  gjk_distance_result expected = each[nearest];
  if (each[spiral].lower < expected.lower) {
    expected.lower = each[spiral].lower;
    expected.certificate.proof = GJK_PROOF_NONE;
    expected.certificate.count = 0;
  }
  const gjk_status ends =
      nearest == spiral || each[spiral].lower < expected.distance ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
  CHECK(gjk_parts_both_distance(&a, &b, &pair, &out) == ends && same_distance(&out, &expected));
  CHECK(pair.a == (as_b ? 0 : nearest) && pair.b == (as_b ? nearest : 0));
  if (!as_b) {
    CHECK(gjk_parts_distance(&a, &c, &pair.a, &out) == ends && same_distance(&out, &expected) && pair.a == nearest);
  }
}

// All other queries of it and a ball that it may touch, or be a little apart from. A crate in the ball, or far from it,
// comes after it. What the crate does not answer has no answer, and is not written; the contacts are the crate's.
static void test_limited(bool touched) {
  const gjk_vec3 at = whorl_point, to = {0, 0, GJK_Q16(8)};
  const gjk_compound_part two[2] = {{&whorl, GJK_POSE_IDENTITY},
                                    {&crate, {{at.x, touched ? 0 : GJK_Q16(90), at.z}, {0, 0, 0, GJK_Q30_ONE}}}},
                          one = {&whorl_ball, {at, {0, 0, 0, GJK_Q30_ONE}}};
  const gjk_collider c = placed(&whorl_ball, at);
  const gjk_status ends = touched ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
  const uint32_t crates = touched ? 1 : 0;
  const gjk_cast_path path = {NULL, &to, 0};
  static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
  const gjk_workspace workspace = {cells, GJK_EPA_CELLS(64)};
  gjk_compound_node nodes[3];
  gjk_compound of_two, of_one;
  gjk_decision near[2];
  gjk_penetration_result depth[2];
  gjk_parts_manifold each[2];
  gjk_manifold joined[2];
  gjk_cast_result cast[2];
  gjk_impact_result impact[2];
  gjk_motion rests = {{at, {0, 0, 0, GJK_Q30_ONE}}, {at, {0, 0, 0, GJK_Q30_ONE}}, {0, 0, 0}}, still = rests;
  const gjk_impact_setup setup = {0, GJK_PARTS_BOTH_TOLERANCE_MIN, 0};
  gjk_parts_pair pair = {77, 77};
  uint32_t part = 77, count;
  unsigned normals;
  CHECK(gjk_compound_build(two, 2, nodes, 2, &of_two) == GJK_OK);
  CHECK(gjk_compound_build(&one, 1, nodes + 2, 1, &of_one) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(&of_two), b = GJK_PARTS_OF_COMPOUND(&of_one);
  memset(near, POISON, sizeof near);
  memset(depth, POISON, sizeof depth);
  CHECK(gjk_parts_intersect(&a, &c, &part, &near[0]) == ends && part == (touched ? 1 : 77));
  CHECK(gjk_parts_both_within(&a, &b, 0, &pair, &near[1]) == ends && pair.a == part && pair.b == (touched ? 0 : 77));
  CHECK(touched ? near[0].yes && near[1].yes : is_untouched(near, sizeof near));
  part = pair.a = pair.b = 77;
  CHECK(gjk_parts_penetration(&a, &c, &workspace, &part, &depth[0]) == GJK_ERROR_ITERATION_LIMIT && part == 77);
  CHECK(gjk_parts_both_penetration(&a, &b, &workspace, &pair, &depth[1]) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(is_untouched(depth, sizeof depth) && pair.a == 77 && pair.b == 77);
  CHECK(gjk_parts_contacts(&a, &c, 0, 4, &workspace, each, 2, &count) == GJK_ERROR_ITERATION_LIMIT && count == crates);
  CHECK(gjk_parts_both_contacts(&a, &b, 0, 4, &workspace, each, 2, &count) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(count == crates && (!touched || each[0].part == 1));
  CHECK(gjk_parts_manifolds(&a, &c, 0, 4, &workspace, joined, 2, &normals) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(normals == crates);
  CHECK(gjk_parts_cast(&a, &c, &path, &part, &cast[0]) == ends && part == crates);
  CHECK(gjk_parts_both_cast(&a, &b, &path, &pair, &cast[1]) == ends && pair.a == crates && pair.b == 0);
  still.from = still.to = a.pose;
  CHECK(gjk_parts_time_of_impact(&a, &still, &c, &rests, &setup, &part, &impact[0]) == ends && part == crates);
  rests = still;
  CHECK(gjk_parts_both_time_of_impact(&a, &still, &b, &rests, &setup, &pair, &impact[1]) == ends && pair.a == crates);
  for (unsigned i = 0; i < 2; i++) {
    CHECK(cast[i].hit == touched && cast[i].inside == touched && cast[i].fraction == 0);
    CHECK(impact[i].hit == touched && impact[i].overlap == touched && impact[i].lower == 0);
  }
}

// The same beside a corner of a field that has holes, which are left out.
static void test_limited_by_field(void) {
  const int16_t heights[6] = {0, -16, GJK_HEIGHT_HOLE, -16, -32, -48};
  const gjk_height_field field = GJK_HEIGHT_FIELD(heights, 3, 2, GJK_Q16(1), GJK_Q16(1), GJK_HEIGHT_FIELD_STEP_MAX);
  const gjk_compound_part one = {&whorl, GJK_POSE_IDENTITY};
  const gjk_collider alone = at_height(&whorl, 0);
  gjk_compound_node node;
  gjk_compound compound;
  gjk_distance_result out;
  gjk_surface_contact contact;
  gjk_parts_pair pair = {77, 77};
  uint32_t count = 77;
  uint16_t contacts = 77;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(&compound);
  gjk_parts b = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  b.pose.position = whorl_point;
  b.pose.rotation.x = GJK_Q30_ONE;  // its front faces the whorl
  b.pose.rotation.w = 0;
  CHECK(gjk_parts_both_distance(&a, &b, &pair, &out) == GJK_ERROR_ITERATION_LIMIT && pair.a == 0 && pair.b == 0);
  CHECK(out.lower < GJK_Q16(9.9992) && out.upper > GJK_Q16(10) && out.distance <= out.upper);
  CHECK(gjk_parts_both_contacts(&a, &b, 0, 4, NULL, NULL, 0, &count) == GJK_ERROR_ITERATION_LIMIT && count == 0);
  CHECK(gjk_surface_contacts(&b, &alone, GJK_Q16(11), 4, NULL, &contact, 1, &contacts) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(contacts == 0);
}

// A compound that is not as it was built: its reach is too small. Where a cast takes a part's centre beyond int32 it ends
// with RANGE. Nothing is read of what it has not answered, which memory checkers see, and nothing is written.
static void test_cast_beyond_reach(void) {
  static const gjk_vec3 corner[3] = {{900, -100, 0}, {1100, -100, 0}, {1000, 100, 0}};
  static const gjk_shape triangle = GJK_TRIANGLE(corner);
  const gjk_compound_part one = {&triangle, GJK_POSE_IDENTITY};
  gjk_compound_node node;
  gjk_compound compound;
  CHECK(gjk_compound_build(&one, 1, &node, 1, &compound) == GJK_OK);
  compound.reach = 0;
  gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  body.pose.position.x = INT32_MAX - 1200;
  gjk_pose at = GJK_POSE_IDENTITY;
  at.position.x = INT32_MAX - 1200;
  gjk_collider b = at_height(&ball, 0);
  CHECK(gjk_collider_pose(&b, &at) == GJK_OK);
  const gjk_vec3 to = {INT32_MAX - 200, 0, 0};
  const gjk_cast_path path = {&to, NULL, 0}, still = {NULL, NULL, 0};
  gjk_cast_result cast;
  uint32_t part = 77;
  memset(&cast, 5, sizeof cast);
  CHECK(gjk_parts_cast(&body, &b, &path, &part, &cast) == GJK_ERROR_RANGE);
  CHECK(part == 77 && cast.iterations == 5);
  CHECK(gjk_parts_cast(&body, &b, &still, &part, &cast) == GJK_OK && cast.hit && part == 0);
}

// The same of two bodies on their way: a part so far from its body that its square does not fit 64 bits.
static void test_impact_beyond_reach(void) {
  const gjk_compound_part far = {&ball,
                                 {{INT32_MAX - 65536, INT32_MAX - 65536, INT32_MAX - 65536}, {0, 0, 0, GJK_Q30_ONE}}},
                          near = {&crate, GJK_POSE_IDENTITY};
  const gjk_vec3 diagonal = {1, 1, 1}, along = {1, 0, 0};
  const gjk_impact_setup setup = {0, GJK_Q16(1), 0};
  const gjk_motion still = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  gjk_motion away = still;
  gjk_compound_node node[2];
  gjk_compound of_a, of_b;
  gjk_impact_result impact;
  gjk_parts_pair pair = {77, 77};
  CHECK(gjk_compound_build(&near, 1, &node[0], 1, &of_a) == GJK_OK);
  CHECK(gjk_compound_build(&far, 1, &node[1], 1, &of_b) == GJK_OK);
  const gjk_parts a = GJK_PARTS_OF_COMPOUND(&of_a), b = GJK_PARTS_OF_COMPOUND(&of_b);
  away.from.position.x = INT32_MIN;
  CHECK(gjk_quat_between(&diagonal, &along, &away.from.rotation) == GJK_OK);
  away.to = away.from;
  CHECK(gjk_parts_both_time_of_impact(&a, &still, &b, &away, &setup, &pair, &impact) == GJK_ERROR_RANGE);
  CHECK(pair.a == 77 && pair.b == 77);
  of_b.reach = 0;
  CHECK(gjk_parts_both_time_of_impact(&a, &still, &b, &away, &setup, &pair, &impact) == GJK_OK && !impact.hit);
}

int main(void) {
  test_seam();
  test_ids();
  for (unsigned i = 0; i < 4; i++) {
    test_features(i < 2, i % 2);
    for (int beyond = -1; beyond <= 1; beyond++) {
      test_distance_limited(beyond, i / 2, i % 2 != 0);
    }
  }
  test_statuses_of_both();
  test_statuses_of_impacts();
  test_tolerance_far_away(GJK_Q16(4000));
  test_tolerance_far_away(GJK_Q16(4100));
  test_ahead();
  test_ahead_of_baked();
  test_cast_limited();
  test_limited(false);
  test_limited(true);
  test_limited_by_field();
  test_cast_beyond_reach();
  for (unsigned i = 0; i < 3; i++) {
    const gjk_vec3 axis = {i == 0, i == 1, i == 2};
    test_cast_out_of_range(axis);
  }
  test_impact_beyond_reach();
  return check_done("parts cases");
}
