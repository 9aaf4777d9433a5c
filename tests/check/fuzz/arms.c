// Arms of any make, some of it hostile, among obstacles and compounds: calls must end, keep to their memory and return a
// status that they may. Slices must not change an edge. Its certificate must pass; a damaged one may only pass with a
// claim that is true at both ends of the edge.
#include <stdlib.h>
#include <string.h>

#include "gjk/arm.h"
#include "gjk/compound.h"
#include "hostile.h"

#define LINKS 5
#define PARTS 4
#define OBSTACLES 2
#define BODIES 2
#define PIECES 4
#define PROOFS 3000
#define TESTS 3000  // of an edge

static fuzz_bytes bytes;

static gjk_shape shapes[PARTS + OBSTACLES + BODIES * PIECES];
static gjk_vec3 points[PARTS + OBSTACLES + BODIES * PIECES][6];
static gjk_arm_link links[LINKS];
static gjk_arm_part parts[PARTS];
static uint32_t never[LINKS];
static gjk_collider obstacles[OBSTACLES];
static gjk_compound_part pieces[BODIES][PIECES];
static gjk_compound_node nodes[BODIES][GJK_COMPOUND_NODES(PIECES)];
static gjk_compound compounds[BODIES];
static gjk_parts bodies[BODIES];
static gjk_arm arm;
static int32_t ends[2][LINKS];
static gjk_arm_proof proofs[PROOFS];
static uint32_t proof_count, seen;

static uint32_t below(uint32_t most) {
  return fuzz_u8(&bytes) % most;
}

// A number up to a power of 2 in size.
static int32_t within(unsigned bits) {
  return fuzz_i32(&bytes) >> (31 - bits);
}

// The same from 0 on.
static int32_t size_within(unsigned bits) {
  return (int32_t)((uint32_t)fuzz_i32(&bytes) >> (32 - bits));
}

static gjk_pose any_pose(unsigned bits) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = within(bits);
  pose.position.y = within(bits);
  pose.position.z = within(bits);
  if (below(2) == 0) {
    pose.rotation = hostile_quat(&bytes);
  }
  return pose;
}

static const gjk_shape *any_shape(unsigned number, unsigned bits) {
  const int32_t x = size_within(bits), y = size_within(bits);
  for (unsigned i = 0; i < 6; i++) {
    points[number][i].x = within(bits);
    points[number][i].y = within(bits);
    points[number][i].z = within(bits);
  }
  const gjk_shape all[] = {GJK_HULL(points[number], 6), GJK_BOX(x, y, y), GJK_SPHERE(x), GJK_CAPSULE(x, y),
                           GJK_CYLINDER(x, y)};
  shapes[number] = all[below(5)];
  return &shapes[number];
}

static unsigned make_model(gjk_arm_model *model, unsigned bits) {
  const unsigned count = 1 + below(LINKS), part_count = below(PARTS + 1);
  for (unsigned i = 0; i < count; i++) {
    links[i].parent = (uint8_t)(i == 0 || below(4) == 0 ? GJK_ARM_BASE : below(8) > 0 ? i - 1 : fuzz_u8(&bytes));
    links[i].kind = (uint8_t)(below(16) == 0 ? fuzz_u8(&bytes) : below(3));
    links[i].fixed = any_pose(bits);
    links[i].axis = fuzz_vec3(&bytes);
    links[i].lower = fuzz_i32(&bytes);
    links[i].upper = fuzz_i32(&bytes);
    never[i] = below(4) == 0 ? fuzz_u8(&bytes) : 0;
    for (unsigned end = 0; end < 2; end++) {
      ends[end][i] = below(16) == 0 ? fuzz_i32(&bytes) : within(links[i].kind == GJK_ARM_PRISMATIC ? bits : 17);
    }
  }
  for (unsigned i = 0; i < part_count; i++) {
    parts[i].shape = any_shape(i, bits);
    parts[i].pose = any_pose(bits);
    parts[i].link = (uint8_t)(below(16) == 0 ? fuzz_u8(&bytes) : below(count));
  }
  const gjk_arm_model made = {links, parts, below(2) == 0 ? NULL : never, (uint8_t)count, (uint16_t)part_count};
  *model = made;
  return below(16) == 0 ? below(40) : GJK_ARM_PAIRS(PARTS, OBSTACLES + BODIES);
}

// Obstacles and bodies, as many as are sound.
static void surround(unsigned bits) {
  const unsigned balls = below(OBSTACLES + 1), compound_count = below(BODIES + 1);
  uint16_t made = 0, built = 0;
  for (unsigned i = 0; i < balls; i++) {
    const gjk_pose pose = any_pose(bits + 1);
    made = (uint16_t)(made + (gjk_collider_init(&obstacles[made], any_shape(PARTS + i, bits), NULL, 0) == GJK_OK &&
                              gjk_collider_pose(&obstacles[made], &pose) == GJK_OK));
  }
  for (unsigned i = 0; i < compound_count; i++) {
    const unsigned count = 1 + below(PIECES);
    for (unsigned k = 0; k < count; k++) {
      pieces[i][k].shape = any_shape(PARTS + OBSTACLES + i * PIECES + k, bits);
      pieces[i][k].pose = any_pose(bits);
    }
    if (gjk_compound_build(pieces[i], (uint16_t)count, nodes[i], GJK_COMPOUND_NODES(PIECES), &compounds[i]) == GJK_OK) {
      const gjk_parts body = GJK_PARTS_OF_COMPOUND(&compounds[i]);
      bodies[built] = body;
      bodies[built++].pose = any_pose(bits + 1);
    }
  }
  hostile_check(gjk_arm_obstacles(&arm, obstacles, made), NULL, 0);
  hostile_check(gjk_arm_bodies(&arm, bodies, built), NULL, 0);
}

static void take(void *user, const gjk_arm_proof *proof) {
  (void)user;
  if (proof_count < PROOFS) {
    proofs[proof_count] = *proof;
  }
  proof_count++;
}

static void expect(bool condition, const char *what) {
  if (!condition) {
    fuzz_fail(what);
  }
}

// Nothing is within the margin at an end.
static void expect_free(const gjk_arm_setup *setup, const int32_t *values) {
  bool near = false;
  expect(gjk_arm_near(&arm, values, setup->margin, &near, NULL) != GJK_OK || !near, "an edge called free is not");
}

static bool same(const gjk_arm_edge_result *a, const gjk_arm_edge_result *b) {
  return a->answer == b->answer && a->lower == b->lower && a->upper == b->upper && a->tests == b->tests &&
         (a->answer != GJK_ARM_FREE || a->gap == b->gap) &&
         (a->answer != GJK_ARM_TOUCH || (a->pair.part == b->pair.part && a->pair.other == b->pair.other &&
                                         a->pair.obstacle == b->pair.obstacle && a->pair.piece == b->pair.piece));
}

static void forge(const gjk_arm_setup *setup, const gjk_arm_edge_result *honest) {
  gjk_arm_edge_result said = *honest;
  const unsigned changes = 1 + below(3);
  for (unsigned i = 0; i < changes && seen > 0; i++) {
    gjk_arm_proof *p = &proofs[(unsigned)(fuzz_u8(&bytes) | fuzz_u8(&bytes) << 8) % seen];
    int32_t *field[] = {&p->from, &p->to, &p->direction.x, &p->direction.y, &p->direction.z};
    const unsigned which = below(8);
    if (which < 5) {
      *field[which] = below(2) == 0 ? fuzz_i32(&bytes) : *field[which] ^ (INT32_C(1) << below(31));
    } else if (which == 5) {
      p->pair = below(2) == 0 ? (uint32_t)fuzz_i32(&bytes) : below(40);
    } else {
      p->piece = below(2) == 0 ? (uint32_t)fuzz_i32(&bytes) : below(5) - 1u;
    }
  }
  if (below(2) == 0) {
    said.answer = (gjk_arm_answer)below(4);
    said.lower = below(2) == 0 ? GJK_Q30_ONE : fuzz_i32(&bytes);
    said.upper = below(2) == 0 ? GJK_Q30_ONE : fuzz_i32(&bytes);
    said.gap = below(2) == 0 ? setup->margin : fuzz_i32(&bytes);
    said.pair.piece = below(2) == 0 ? said.pair.piece : below(5) - 1u;
  }
  const gjk_status status = gjk_check_edge(&arm, ends[0], ends[1], setup, &said, proofs, seen);
  expect(status == GJK_OK || status == GJK_ERROR_UNPROVEN, "the status of a check");
  if (status == GJK_OK && said.answer == GJK_ARM_FREE) {
    expect_free(setup, ends[0]);
    expect_free(setup, ends[1]);
  }
}

static void check_edge(void) {
  const gjk_arm_setup setup = {below(16) == 0 ? fuzz_i32(&bytes) : size_within(12),
                               below(16) == 0 ? fuzz_i32(&bytes) : GJK_ARM_TOLERANCE_MIN + size_within(10),
                               below(2) == 0 ? GJK_Q30_ONE : fuzz_i32(&bytes)};
  gjk_arm_edge_result whole, part;
  const uint32_t slice = 1 + below(40);
  memset(&whole, HOSTILE_POISON, sizeof whole);
  memset(&part, HOSTILE_POISON, sizeof part);
  proof_count = 0;
  gjk_status status = gjk_arm_edge_start(&arm, ends[0], ends[1], &setup, take, NULL);
  hostile_check(status, NULL, 0);
  if (status != GJK_OK) {
    expect(gjk_check_edge(&arm, ends[0], ends[1], &setup, &whole, proofs, 0) == status, "another status of the check");
    return;
  }
  const gjk_status end = gjk_arm_edge_run(&arm, TESTS, &whole);
  expect(end == GJK_OK || end == GJK_ERROR_ITERATION_LIMIT, "the status of a run");
  seen = proof_count < PROOFS ? proof_count : PROOFS;
  expect(gjk_arm_edge_start(&arm, ends[0], ends[1], &setup, NULL, NULL) == GJK_OK, "a second start");
  for (uint32_t left = TESTS, now; left > 0; left -= now) {
    now = slice < left ? slice : left;
    status = gjk_arm_edge_run(&arm, now, &part);
  }
  expect(status == end && same(&whole, &part), "slices change an edge");
  if (proof_count <= PROOFS) {
    expect(gjk_check_edge(&arm, ends[0], ends[1], &setup, &whole, proofs, seen) == GJK_OK, "an honest certificate");
  }
  if (whole.answer == GJK_ARM_FREE) {
    expect_free(&setup, ends[0]);
    expect_free(&setup, ends[1]);
  }
  forge(&setup, &whole);
}

static void check_still(void) {
  gjk_arm_distance_result nearest;
  gjk_q16 slopes[LINKS];
  gjk_pose poses[LINKS];
  gjk_arm_names pair;
  bool near = false;
  const gjk_q16 most = below(2) == 0 ? GJK_DISTANCE_MAX : fuzz_i32(&bytes);
  hostile_check(gjk_arm_poses(&arm, ends[0], poses), NULL, 0);
  const gjk_status status = gjk_arm_distance(&arm, ends[0], most, &nearest);
  hostile_check(status, NULL, 0);
  // A distance is rounded, and cylinders are off by up to 2 LSB each.
  if (status == GJK_OK && nearest.distance.distance < INT32_C(1) << 29) {
    const gjk_status of_near = gjk_arm_near(&arm, ends[0], nearest.distance.distance + 4, &near, &pair);
    expect(near && (of_near == GJK_OK || of_near == GJK_ERROR_ITERATION_LIMIT), "the nearest pair is not near");
    hostile_check(gjk_arm_gradient(&arm, ends[0], &nearest, slopes), NULL, 0);
    nearest.pair.part = fuzz_u8(&bytes);
    nearest.pair.other = fuzz_u8(&bytes);
    hostile_check(gjk_arm_gradient(&arm, ends[0], &nearest, slopes), NULL, 0);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  gjk_arm_model model;
  bytes.at = data;
  bytes.end = data + size;
  const unsigned bits = 8 + below(16), pair_count = make_model(&model, bits);
  const gjk_pose base = any_pose(below(4) == 0 ? 31 : bits);
  // On the heap and no longer than needed, so that a sanitizer sees what is beyond.
  const gjk_arm_memory memory = {malloc(model.link_count * sizeof(gjk_arm_link_room)),
                                 malloc((model.part_count + 1u) * sizeof(gjk_arm_part_room)),
                                 malloc((pair_count + 1u) * sizeof(gjk_arm_pair)), pair_count};
  const gjk_status status = gjk_arm_init(&arm, &model, &base, &memory);
  hostile_check(status, NULL, 0);
  if (status == GJK_OK) {
    surround(bits);
    check_still();
    check_edge();
  }
  free(memory.links);
  free(memory.parts);
  free(memory.pairs);
  return 0;
}
