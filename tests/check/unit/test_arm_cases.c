// One revolute joint whose closest approach is known exactly; limits, ceilings, several turns, far bases; statuses of every
// bad input; paths.
#include "gjk/arm.h"

#include <string.h>

#include "check.h"
#include "gjk/compound.h"
#include "placed.h"
#include "whorl.h"

#define LINKS 3
#define PARTS 3

static const gjk_vec3 tip[1] = {{GJK_Q16(1.0), 0, 0}};
static const gjk_vec3 rod[2] = {{0, 0, 0}, {GJK_Q16(100.0), 0, 0}};
static const gjk_vec3 far_rod[2] = {{0, 0, 0}, {GJK_Q16(2000.0), 0, 0}};
static const gjk_shape point = GJK_HULL(tip, 1), long_rod = GJK_HULL(rod, 2), longest_rod = GJK_HULL(far_rod, 2);
static const gjk_shape wall = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_pose identity = GJK_POSE_IDENTITY;

static struct {
  gjk_arm_link links[LINKS];
  gjk_arm_part parts[PARTS];
  gjk_arm_model model;
  gjk_arm_link_room link_room[LINKS];
  gjk_arm_part_room part_room[PARTS];
  gjk_arm_pair pairs[GJK_ARM_PAIRS(PARTS, 2)];
  gjk_arm_memory memory;
  gjk_arm arm;
  gjk_collider obstacles[2];
} m;

static const gjk_arm_setup plain = {0, GJK_ARM_TOLERANCE_MIN, 0};

// A single link that turns about z, with a shape on it.
static void make_single(const gjk_shape *shape) {
  const gjk_arm_link link = {GJK_ARM_BASE, GJK_ARM_REVOLUTE, GJK_POSE_IDENTITY, {0, 0, 1}, -100000, 100000};
  const gjk_arm_part part = {shape, GJK_POSE_IDENTITY, 0};
  const gjk_arm_model model = {m.links, m.parts, NULL, 1, 1};
  const gjk_arm_memory memory = {m.link_room, m.part_room, m.pairs, GJK_ARM_PAIRS(PARTS, 2)};
  memset(m.link_room, 0xA5, sizeof m.link_room);  // memory of any content
  memset(m.part_room, 0xA5, sizeof m.part_room);
  memset(m.pairs, 0xA5, sizeof m.pairs);
  m.links[0] = link;
  m.parts[0] = part;
  m.model = model;
  m.memory = memory;
}

static gjk_status init(void) {
  return gjk_arm_init(&m.arm, &m.model, &identity, &m.memory);
}

static void put_wall(const gjk_shape *shape, gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  const gjk_pose pose = {{x, y, z}, {0, 0, 0, GJK_Q30_ONE}};
  m.obstacles[0] = posed(shape, &pose);
  CHECK(gjk_arm_obstacles(&m.arm, m.obstacles, 1) == GJK_OK);
}

static gjk_arm_edge_result run(int32_t from, int32_t to, const gjk_arm_setup *setup) {
  gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
  CHECK(gjk_arm_edge_start(&m.arm, &from, &to, setup, NULL, NULL) == GJK_OK);
  CHECK(gjk_arm_edge_run(&m.arm, 100000, &result) == GJK_OK);
  return result;
}

// A point sweeps a circle of radius 1 and comes nearest to a wall at the middle of the edge, where its place is an integer.
// A gap of up to margin and slack is never free, and one beyond margin and tolerance always is, to the LSB. Between them
// either answer is right.
static void check_grazing(const gjk_vec3 *base) {
  const gjk_pose pose = {*base, {0, 0, 0, GJK_Q30_ONE}};
  const int slack = 5;  // of this pair, as src/arm/gjk_arm_bound.c counts it
  unsigned between = 0;
  make_single(&point);
  CHECK(gjk_arm_init(&m.arm, &m.model, &pose, &m.memory) == GJK_OK);
  for (int margin = 0; margin < 3000; margin += 997) {
    for (int tolerance = 48; tolerance < 200; tolerance += 37) {
      const gjk_arm_setup setup = {margin, tolerance, 0};
      const int gaps[] = {
          margin - 1, margin, margin + 1, margin + slack, margin + tolerance - 1, margin + tolerance + 1};
      for (unsigned i = 0; i < sizeof gaps / sizeof gaps[0]; i++) {
        put_wall(&wall, base->x + GJK_Q16(1.5) + gaps[i], base->y, base->z);
        for (int32_t angle = 0; angle < 80000; angle = 3 * angle + 1) {
          const gjk_arm_edge_result there = run(-angle, angle, &setup), back = run(angle, -angle, &setup);
          CHECK(i > 3 || (there.answer == GJK_ARM_TOUCH && back.answer == GJK_ARM_TOUCH));
          CHECK(i != 5 || (there.answer == GJK_ARM_FREE && back.answer == GJK_ARM_FREE && there.gap >= margin));
          between += i == 4 && there.answer == GJK_ARM_FREE ? 1u : 0u;
        }
      }
    }
  }
  CHECK(between > 0);
  CHECK(m.arm.memory.pairs[0].slack == slack);
  // A rod of 2000 units: its rotation of one joint and the base may be off by 3 2^-26 2000 units, 5 LSB.
  make_single(&longest_rod);
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
  put_wall(&wall, 0, 0, GJK_Q16(9.0));
  (void)run(0, 1, &plain);
  CHECK(m.arm.memory.pairs[0].slack == slack + 5);
}

// A rod 100 units long that is infinitely thin, and turns by several turns: it meets the wall where the angle is known.
static void check_turns(void) {
  make_single(&long_rod);
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
  put_wall(&wall, 0, GJK_Q16(90.0), 0);
  // The wall's lower edge begins at y = 89.5: the rod meets its corner at x = 0.5 at atan(89.5 / 0.5) = 1.5652099 rad.
  gjk_arm_edge_result result = run(0, GJK_ANGLE(18.849556), &plain);  // three turns
  CHECK(result.answer == GJK_ARM_TOUCH && result.pair.obstacle && result.pair.part == 0);
  const double angle = result.upper / 1073741824.0 * 18.849556;
  const double first = result.lower / 1073741824.0 * 18.849556;
  CHECK(first < 1.5652099 && angle > 1.5652099 - 1e-5 && angle < 1.5652099 + 2e-5);
  CHECK(result.upper - result.lower <= 2048);
  CHECK(result.outside);  // three turns are beyond the limit
  put_wall(&wall, 0, GJK_Q16(90.0), GJK_Q16(0.51));
  result = run(0, GJK_ANGLE(18.849556), &plain);
  CHECK(result.answer == GJK_ARM_FREE && result.gap > 300 && result.gap <= GJK_Q16(0.01) + 1);
  // Backwards, to a limit and from it.
  put_wall(&wall, 0, GJK_Q16(90.0), 0);
  result = run(GJK_ANGLE(1.0), 100000, &plain);
  CHECK(result.answer == GJK_ARM_FREE && !result.outside);
  result = run(GJK_ANGLE(1.0), 100001, &plain);
  CHECK(result.outside);
}

// A ball goes out along a boom that turns a little: r = 10 t at an angle of 0.01 t. It runs below the chord of its ends, which
// passes over the wall: both joints together bend the path, not the turn alone.
static void check_boom(void) {
  static const gjk_shape ball = GJK_SPHERE(1);
  const gjk_arm_link boom = {0, GJK_ARM_PRISMATIC, GJK_POSE_IDENTITY, {1, 0, 0}, 0, GJK_Q16(10.0)};
  const int32_t from[2] = {0, 0}, to[2] = {GJK_ANGLE(0.01), GJK_Q16(10.0)};
  make_single(&ball);
  m.links[1] = boom;
  m.parts[0].link = 1;
  m.model.link_count = 2;
  CHECK(init() == GJK_OK);
  // Over the wall, from x = 4.5 to 5.5, the path is 0.02025 to 0.03025 high, the chord 0.045 or more.
  for (unsigned back = 0; back < 2; back++) {
    for (unsigned low = 0; low < 2; low++) {
      gjk_arm_edge_result result;
      put_wall(&wall, GJK_Q16(5.0), low ? GJK_Q16(0.018 - 0.5) : GJK_Q16(0.022 - 0.5), 0);
      CHECK(gjk_arm_edge_start(&m.arm, back ? to : from, back ? from : to, &plain, NULL, NULL) == GJK_OK);
      CHECK(gjk_arm_edge_run(&m.arm, 100000, &result) == GJK_OK);
      CHECK(result.answer == (low ? GJK_ARM_FREE : GJK_ARM_TOUCH) && (low || result.pair.other == 0));
    }
  }
}

// Something exactly as far as asked for is found, and nothing beyond.
static void check_most(void) {
  const int32_t at = 0;
  gjk_arm_distance_result nearest;
  make_single(&point);
  CHECK(init() == GJK_OK);
  for (gjk_q16 gap = 1; gap < GJK_Q16(3.0); gap = 3 * gap + 1) {
    put_wall(&wall, GJK_Q16(1.5) + gap, 0, 0);
    for (gjk_q16 most = gap < 16 ? 0 : gap - 16; most < gap + 16; most++) {
      CHECK(gjk_arm_distance(&m.arm, &at, most, &nearest) == (most < gap ? GJK_ERROR_EMPTY : GJK_OK));
      CHECK(most < gap || nearest.distance.distance == gap);
    }
  }
}

// No motion: the static answer. And ceilings of 1, 2 and 3 tests.
static void check_ceilings(void) {
  make_single(&long_rod);
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
  put_wall(&wall, 0, GJK_Q16(90.0), 0);
  CHECK(run(5, 5, &plain).answer == GJK_ARM_FREE);
  gjk_arm_edge_result result = run(GJK_ANGLE(1.5707963), GJK_ANGLE(1.5707963), &plain);
  CHECK(result.answer == GJK_ARM_TOUCH && result.lower == 0 && result.upper == 0);
  const int32_t from = 0, to = GJK_ANGLE(1.565);
  for (uint32_t tests = 0; tests < 4; tests++) {
    CHECK(gjk_arm_edge_start(&m.arm, &from, &to, &plain, NULL, NULL) == GJK_OK);
    CHECK(gjk_arm_edge_run(&m.arm, tests, &result) == GJK_OK);
    CHECK(result.answer == GJK_ARM_UNSETTLED && result.tests == tests && result.upper == GJK_Q30_ONE);
    CHECK(gjk_check_edge(&m.arm, &from, &to, &plain, &result, NULL, 0) ==
          (result.lower == 0 ? GJK_OK : GJK_ERROR_UNPROVEN));
    CHECK(gjk_arm_edge_run(&m.arm, tests, &result) == GJK_ERROR_UNINITIALISED);  // the check gave it up
  }
}

static gjk_arm_proof proof[64];
static uint32_t proof_count;

static void take(void *user, const gjk_arm_proof *taken) {
  (void)user;
  CHECK(proof_count < 64);
  proof[proof_count++] = *taken;
}

// Obstacles so far away that differences leave 2^30, some ends or centres of them and some not: free, and proven.
static void check_far(void) {
  const int32_t from = 0, to = GJK_ANGLE(3.0);
  gjk_arm_edge_result result;
  make_single(&long_rod);
  for (int side = -1; side <= 1; side += 2) {
    const gjk_pose base = {{side * -(INT32_C(1) << 30), 5, side * 77}, {0, 0, 0, GJK_Q30_ONE}};
    CHECK(gjk_arm_init(&m.arm, &m.model, &base, &m.memory) == GJK_OK);
    for (int32_t k = -8; k <= 8; k++) {
      for (unsigned axis = 0; axis < 2; axis++) {
        const gjk_q16 at = k * GJK_Q16(25.0);
        put_wall(&wall, side * at, axis == 0 ? 0 : (INT32_C(1) << 30) - at, 0);
        proof_count = 0;
        CHECK(gjk_arm_edge_start(&m.arm, &from, &to, &plain, take, NULL) == GJK_OK);
        CHECK(gjk_arm_edge_run(&m.arm, 1000, &result) == GJK_OK && result.answer == GJK_ARM_FREE);
        CHECK(gjk_check_edge(&m.arm, &from, &to, &plain, &result, proof, proof_count) == GJK_OK);
        proof[0].direction = (gjk_unit3){-side * 644245094, 858993459, 0};  // 0.6 and 0.8
        CHECK(k < 8 || axis > 0 ||  // so far away only directions along axes count
              gjk_check_edge(&m.arm, &from, &to, &plain, &result, proof, proof_count) == GJK_ERROR_UNPROVEN);
      }
    }
  }
}

// A ball that goes a little way from another one almost straight to a third. Whether the gap there is measured, as it always is
// for a proof, does not change the answer.
static void check_same_gap(void) {
  static const gjk_shape ball = GJK_SPHERE(1000);
  const gjk_vec3 aslant = {100, 10, 10};
  make_single(&ball);
  m.links[0].kind = GJK_ARM_PRISMATIC;
  m.links[0].axis = aslant;
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
  for (int32_t to = 2; to < 40; to++) {
    for (int gap = 36; gap < 44; gap++) {
      const int32_t from = 0;
      gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
      gjk_pose pose;
      CHECK(gjk_arm_poses(&m.arm, &to, &pose) == GJK_OK);
      pose.position.x += 2000 + gap;
      m.obstacles[1] = posed(&ball, &pose);
      put_wall(&ball, -2040, 0, 0);
      CHECK(gjk_arm_obstacles(&m.arm, m.obstacles, 2) == GJK_OK);
      const gjk_q16 unproven = run(from, to, &plain).gap;
      proof_count = 0;
      CHECK(gjk_arm_edge_start(&m.arm, &from, &to, &plain, take, NULL) == GJK_OK);
      CHECK(gjk_arm_edge_run(&m.arm, 100, &result) == GJK_OK && result.gap == unproven && proof_count == 2);
    }
  }
}

// A ball that goes straight through a wall. A direction that parts them at one end of the edge alone proves nothing: of an
// obstacle, and of a body of one piece.
static void check_one_end(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.25));
  static const gjk_compound_part piece = {&wall, GJK_POSE_IDENTITY};
  const int32_t from = GJK_Q16(-10.0), to = GJK_Q16(10.0);
  gjk_compound_node node;
  gjk_compound compound;
  gjk_arm_edge_result said = {.answer = GJK_ARM_FREE, .lower = GJK_Q30_ONE, .upper = GJK_Q30_ONE};
  make_single(&ball);
  m.links[0].kind = GJK_ARM_PRISMATIC;
  CHECK(gjk_compound_build(&piece, 1, &node, 1, &compound) == GJK_OK);
  gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  for (unsigned k = 0; k < 2; k++) {
    CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
    if (k == 0) {
      put_wall(&wall, 0, 0, 0);
    } else {
      CHECK(gjk_arm_bodies(&m.arm, &body, 1) == GJK_OK);
    }
    for (int side = -1; side <= 1; side++) {
      gjk_arm_proof steps[2] = {{0, GJK_Q30_ONE, {0, 0, side * GJK_Q30_ONE}, 0, k == 0 ? GJK_PARTS_NONE : 0},
                                {0, GJK_Q30_ONE, {0, 0, 0}, 0, GJK_PARTS_NONE}};
      const int32_t stay = side < 0 ? from : to;
      steps[0].direction.x = side == 0 ? GJK_Q30_ONE : 0;
      CHECK(gjk_check_edge(&m.arm, &from, &to, &plain, &said, steps, k + 1) == GJK_ERROR_UNPROVEN);
      CHECK(gjk_check_edge(&m.arm, &stay, &stay, &plain, &said, steps, k + 1) ==
            (side == 0 ? GJK_ERROR_UNPROVEN : GJK_OK));
      steps[0].direction.z += side;  // just beyond 1
      CHECK(gjk_check_edge(&m.arm, &stay, &stay, &plain, &said, steps, k + 1) == GJK_ERROR_UNPROVEN);
      steps[0].direction.z -= side;
      body.pose.rotation.w = 0;  // a body that has become none
      CHECK(gjk_check_edge(&m.arm, &stay, &stay, &plain, &said, steps, k + 1) ==
            (side == 0 || k == 1 ? GJK_ERROR_UNPROVEN : GJK_OK));
      body.pose.rotation.w = GJK_Q30_ONE;
    }
  }
}

// A ball goes along each axis, there and back, up to a body's one piece or away from it: what touches only at one end of the
// way is found, on each side.
static void check_sides_of_bodies(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.25));
  const int32_t from = 0;
  make_single(&ball);
  m.links[0].kind = GJK_ARM_PRISMATIC;
  CHECK(init() == GJK_OK);
  for (unsigned axis = 0; axis < 3; axis++) {
    for (int side = -1; side <= 1; side += 2) {
      gjk_compound_part piece = {&wall, GJK_POSE_IDENTITY};
      gjk_compound_node node;
      gjk_compound compound;
      gjk_q16 *at = axis == 0 ? &piece.pose.position.x : axis == 1 ? &piece.pose.position.y : &piece.pose.position.z;
      *at = side * GJK_Q16(10.0);
      CHECK(gjk_compound_build(&piece, 1, &node, 1, &compound) == GJK_OK);
      const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
      m.links[0].axis = (gjk_vec3){axis == 0, axis == 1, axis == 2};
      CHECK(init() == GJK_OK && gjk_arm_bodies(&m.arm, &body, 1) == GJK_OK);
      for (int end = -1; end <= 1; end += 2) {
        const int32_t to = end * GJK_Q16(9.5);
        CHECK(run(from, to, &plain).answer == (end == side ? GJK_ARM_TOUCH : GJK_ARM_FREE));
        CHECK(run(to, from, &plain).answer == (end == side ? GJK_ARM_TOUCH : GJK_ARM_FREE));
      }
    }
  }
}

// A ball beside a shape that no search settles, which is an obstacle or the first piece of a body. It may be near, which
// is all that is known unless the wall that comes next is. Its distance counts by its lower bound.
static void check_open(bool of_body, bool touched) {
  const gjk_compound_part pieces[2] = {
      {&whorl, GJK_POSE_IDENTITY},
      {&wall, {{whorl_point.x, touched ? 0 : GJK_Q16(20.0), whorl_point.z}, {0, 0, 0, GJK_Q30_ONE}}}};
  const gjk_collider ball = placed(&whorl_ball, whorl_point);
  const int32_t q = 0;
  gjk_compound_node nodes[2];
  gjk_compound compound;
  gjk_distance_result alone;
  gjk_arm_distance_result nearest;
  gjk_arm_edge_result edge;
  gjk_arm_names pair;
  bool near = false;
  make_single(&whorl_ball);
  m.parts[0].pose.position = whorl_point;
  CHECK(gjk_compound_build(pieces, 2, nodes, 2, &compound) == GJK_OK);
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  CHECK(init() == GJK_OK);
  for (unsigned i = 0; i < 2; i++) {
    m.obstacles[i] = posed(pieces[i].shape, &pieces[i].pose);
  }
  CHECK(gjk_distance(&m.obstacles[0], &ball, NULL, &alone) == GJK_ERROR_ITERATION_LIMIT);
  CHECK((of_body ? gjk_arm_bodies(&m.arm, &body, 1) : gjk_arm_obstacles(&m.arm, m.obstacles, 2)) == GJK_OK);
  CHECK(gjk_arm_near(&m.arm, &q, 0, &near, &pair) == (touched ? GJK_OK : GJK_ERROR_ITERATION_LIMIT) && near);
  CHECK(pair.obstacle && pair.other == (touched && !of_body) && pair.piece == (of_body ? touched : GJK_PARTS_NONE));
  CHECK(gjk_arm_distance(&m.arm, &q, GJK_DISTANCE_MAX, &nearest) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(nearest.pair.other == 0 && nearest.distance.lower == alone.lower && nearest.distance.upper == alone.upper);
  CHECK(gjk_arm_edge_start(&m.arm, &q, &q, &plain, NULL, NULL) == GJK_OK);
  const gjk_status settled = gjk_arm_edge_run(&m.arm, 100000, &edge);
  CHECK(touched || (settled == GJK_ERROR_ITERATION_LIMIT && edge.answer == GJK_ARM_UNSETTLED && edge.lower == 0));
}

// A part that is moved along one axis of its link alone is where its pose says. And no room for pairs is needed without pairs.
static void check_offsets(void) {
  for (unsigned axis = 0; axis < 3; axis++) {
    make_single(&point);
    m.parts[0].pose.position.x = axis == 0 ? GJK_Q16(1.0) : 0;
    m.parts[0].pose.position.y = axis == 1 ? GJK_Q16(1.0) : 0;
    m.parts[0].pose.position.z = axis == 2 ? GJK_Q16(1.0) : 0;
    CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
    put_wall(&wall, axis == 0 ? GJK_Q16(2.0) : GJK_Q16(1.0), axis == 1 ? GJK_Q16(1.0) : 0,
             axis == 2 ? GJK_Q16(1.0) : 0);
    CHECK(run(-100, 100, &plain).answer == GJK_ARM_TOUCH);
  }
  m.memory.pairs = NULL;
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_ERROR_NULL);
  m.memory.pair_capacity = 0;
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
}

// A path round a wall: free, free, touch.
static void check_path(void) {
  const int32_t path[] = {0, GJK_ANGLE(1.0), GJK_ANGLE(1.5), GJK_ANGLE(2.0), 0};
  gjk_arm_edge_result result;
  unsigned free = 9;
  make_single(&long_rod);
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, &m.memory) == GJK_OK);
  put_wall(&wall, 0, GJK_Q16(90.0), 0);
  CHECK(gjk_arm_path(&m.arm, path, 5, &plain, 100000, &free, &result) == GJK_OK);
  CHECK(free == 2 && result.answer == GJK_ARM_TOUCH);
  CHECK(gjk_arm_path(&m.arm, path, 3, &plain, 100000, &free, &result) == GJK_OK);
  CHECK(free == 2 && result.answer == GJK_ARM_FREE);
  CHECK(gjk_arm_path(&m.arm, path, 2, &plain, 100000, &free, &result) == GJK_OK && free == 1);
  CHECK(gjk_arm_path(&m.arm, path, 3, &plain, 0, &free, &result) == GJK_OK);
  CHECK(free == 0 && result.answer == GJK_ARM_UNSETTLED);
  CHECK(gjk_arm_path(&m.arm, path, 1, &plain, 1, &free, &result) == GJK_ERROR_EMPTY);
  CHECK(gjk_arm_path(&m.arm, NULL, 3, &plain, 1, &free, &result) == GJK_ERROR_NULL);
  CHECK(gjk_arm_path(&m.arm, path, 3, NULL, 1, &free, &result) == GJK_ERROR_NULL);
}

// Three links in a row, a part on each.
static void make_row(void) {
  const gjk_arm_model model = {m.links, m.parts, NULL, LINKS, PARTS};
  make_single(&point);
  m.model = model;
  for (unsigned i = 1; i < LINKS; i++) {
    m.links[i] = m.links[0];
    m.links[i].parent = (uint8_t)(i - 1);
    m.parts[i] = m.parts[0];
    m.parts[i].link = (uint8_t)i;
  }
}

static void check_models(void) {
  make_row();
  CHECK(init() == GJK_OK && m.arm.pair_count == 1 && gjk_arm_values(&m.model) == 3 && gjk_arm_values(NULL) == 0);
  m.links[1].parent = 2;  // joints in a circle
  CHECK(init() == GJK_ERROR_RANGE);
  m.links[1].parent = 1;
  CHECK(init() == GJK_ERROR_RANGE);
  make_row();
  m.links[2].kind = 3;
  CHECK(init() == GJK_ERROR_RANGE);
  m.links[2].kind = GJK_ARM_PRISMATIC;
  m.links[2].axis.z = 0;
  CHECK(init() == GJK_ERROR_ROTATION);
  m.links[2].kind = GJK_ARM_FIXED;
  CHECK(init() == GJK_OK && gjk_arm_values(&m.model) == 2);
  m.links[1].kind = GJK_ARM_FIXED;
  CHECK(init() == GJK_OK && m.arm.pair_count == 0);  // nothing moves between them
  m.links[1].fixed.rotation.w = 5;
  CHECK(init() == GJK_ERROR_ROTATION);
  make_row();
  m.parts[1].pose.rotation.w = 5;
  CHECK(init() == GJK_ERROR_ROTATION);
  make_row();
  m.parts[2].link = 3;
  CHECK(init() == GJK_ERROR_RANGE);
  make_row();
  m.parts[2].shape = NULL;
  CHECK(init() == GJK_ERROR_NULL);
  make_row();
  m.parts[2].pose.position.x = GJK_ARM_REACH_MAX;
  CHECK(init() == GJK_ERROR_RANGE);
  make_row();
  m.model.link_count = 0;
  CHECK(init() == GJK_ERROR_EMPTY);
  m.model.link_count = 33;
  CHECK(init() == GJK_ERROR_RANGE);
  make_row();
  m.model.part_count = 1025;
  CHECK(init() == GJK_ERROR_RANGE);
  make_row();
  m.memory.pair_capacity = 0;
  CHECK(init() == GJK_ERROR_CAPACITY);
  m.memory.pair_capacity = 1;
  CHECK(init() == GJK_OK);
  CHECK(gjk_collider_init(&m.obstacles[0], &wall, NULL, 0) == GJK_OK);
  CHECK(gjk_arm_obstacles(&m.arm, m.obstacles, 1) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_collider_pose(&m.obstacles[0], &identity) == GJK_OK);
  CHECK(gjk_arm_obstacles(&m.arm, m.obstacles, 1) == GJK_ERROR_CAPACITY);
  CHECK(gjk_arm_obstacles(&m.arm, NULL, 1) == GJK_ERROR_NULL && gjk_arm_obstacles(&m.arm, NULL, 0) == GJK_OK);
  const uint32_t never[3] = {4, 0, 0};
  m.model.never = never;
  CHECK(init() == GJK_OK && m.arm.pair_count == 0);
}

static void check_nulls(void) {
  const int32_t q[3] = {0, 0, 0};
  const gjk_pose drifted = {{0, 0, 0}, {0, 0, 0, GJK_Q30_ONE / 2}};
  gjk_arm_edge_result result;
  gjk_arm_distance_result nearest;
  gjk_pose poses[3];
  gjk_q16 gradient[3];
  gjk_arm none = {0};
  bool near;
  make_row();
  CHECK(gjk_arm_init(NULL, &m.model, &identity, &m.memory) == GJK_ERROR_NULL);
  CHECK(gjk_arm_init(&m.arm, NULL, &identity, &m.memory) == GJK_ERROR_NULL);
  CHECK(gjk_arm_init(&m.arm, &m.model, NULL, &m.memory) == GJK_ERROR_NULL);
  CHECK(gjk_arm_init(&m.arm, &m.model, &identity, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_arm_init(&m.arm, &m.model, &drifted, &m.memory) == GJK_ERROR_ROTATION);
  CHECK(gjk_arm_obstacles(&none, NULL, 0) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_arm_poses(&none, q, poses) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_arm_edge_start(&none, q, q, &plain, NULL, NULL) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_arm_edge_run(&none, 1, &result) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_arm_near(&none, q, 0, &near, NULL) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_arm_distance(&none, q, 0, &nearest) == GJK_ERROR_UNINITIALISED);
  CHECK(init() == GJK_OK);
  CHECK(gjk_arm_poses(&m.arm, NULL, poses) == GJK_ERROR_NULL && gjk_arm_poses(&m.arm, q, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_arm_edge_start(&m.arm, NULL, q, &plain, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_arm_edge_start(&m.arm, q, NULL, &plain, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_arm_edge_start(&m.arm, q, q, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_arm_edge_run(&m.arm, 1, &result) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_arm_edge_run(&m.arm, 1, NULL) == GJK_ERROR_NULL && gjk_arm_edge_run(NULL, 1, &result) == GJK_ERROR_NULL);
  CHECK(gjk_check_edge(&m.arm, q, q, &plain, NULL, NULL, 0) == GJK_ERROR_NULL);
  CHECK(gjk_check_edge(&m.arm, q, q, &plain, &result, NULL, 1) == GJK_ERROR_NULL);
  CHECK(gjk_arm_near(&m.arm, q, -1, &near, NULL) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_arm_distance(&m.arm, q, -1, &nearest) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_arm_gradient(&m.arm, q, NULL, gradient) == GJK_ERROR_NULL);
  CHECK(gjk_arm_distance(&m.arm, q, GJK_DISTANCE_MAX, &nearest) == GJK_OK && nearest.distance.intersecting);
  CHECK(gjk_arm_gradient(&m.arm, q, &nearest, gradient) == GJK_ERROR_RANGE);
  nearest.distance.intersecting = false;
  nearest.pair.part = 3;
  CHECK(gjk_arm_gradient(&m.arm, q, &nearest, gradient) == GJK_ERROR_RANGE);
}

static void check_ranges(void) {
  const int32_t q[3] = {0, 0, 0}, wild[3] = {GJK_ARM_TURN_MAX, 1, 0}, most[3] = {GJK_ARM_TURN_MAX, 0, 0};
  const gjk_arm_setup bad[] = {{-1, 48, 0}, {GJK_ARM_MARGIN_MAX + 1, 48, 0}, {0, 47, 0},
                               {0, 48, -1}, {0, 48, GJK_Q30_ONE + 1},        {0, GJK_ARM_MARGIN_MAX + 1, 0}};
  gjk_arm_distance_result nearest;
  gjk_pose poses[3], far = GJK_POSE_IDENTITY;
  make_row();
  CHECK(init() == GJK_OK);
  for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    CHECK(gjk_arm_edge_start(&m.arm, q, q, &bad[i], NULL, NULL) == (i == 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE));
  }
  CHECK(gjk_arm_edge_start(&m.arm, q, wild, &plain, NULL, NULL) == GJK_ERROR_RANGE);
  CHECK(gjk_arm_edge_start(&m.arm, q, most, &plain, NULL, NULL) == GJK_OK);
  m.links[1].kind = GJK_ARM_PRISMATIC;
  CHECK(init() == GJK_OK);
  const int32_t extended[3] = {0, GJK_ARM_REACH_MAX, 0};
  CHECK(gjk_arm_poses(&m.arm, extended, poses) == GJK_ERROR_RANGE);
  far.position.y = INT32_MAX - GJK_Q16(0.5);
  CHECK(gjk_arm_init(&m.arm, &m.model, &far, &m.memory) == GJK_OK);
  CHECK(gjk_arm_poses(&m.arm, q, poses) == GJK_ERROR_RANGE);
  far.position.y = INT32_MAX - GJK_Q16(3.5);
  CHECK(gjk_arm_init(&m.arm, &m.model, &far, &m.memory) == GJK_OK);
  CHECK(gjk_arm_poses(&m.arm, q, poses) == GJK_OK && poses[2].position.y == far.position.y);
  m.model.part_count = 1;
  CHECK(init() == GJK_OK && gjk_arm_distance(&m.arm, q, 5, &nearest) == GJK_ERROR_EMPTY);
}

int main(void) {
  const gjk_vec3 origin = {0, 0, 0}, far = {INT32_MAX - GJK_Q16(9.0), INT32_MIN + GJK_Q16(9.0), 12345};
  check_grazing(&origin);
  check_grazing(&far);
  check_turns();
  check_boom();
  check_most();
  check_ceilings();
  check_far();
  check_one_end();
  check_sides_of_bodies();
  check_same_gap();
  for (unsigned k = 0; k < 4; k++) {
    check_open(k / 2 != 0, k % 2 != 0);
  }
  check_offsets();
  check_path();
  check_models();
  check_nulls();
  check_ranges();
  return check_done("arm cases");
}
