// Arms among compounds, meshes and height fields: every answer is that of an arm whose obstacles are the pieces one by one.
// Edges against the truth in double, slices of 1 to 3 tests, forged certificates, bodies at fault.
#include "gjk/arm.h"

#include <string.h>

#include "arm/arm_truth.h"
#include "check.h"
#include "fnv.h"
#include "gjk/compound.h"
#include "gjk/height_field.h"
#include "gjk/mesh.h"
#include "parts_answers.h"
#include "placed.h"
#include "random_vec.h"

#define TRIALS 600
#define LINKS 4
#define PARTS 4
#define BODIES 3
#define SIDE 8           // of a field, and of a mesh
#define PIECES_MAX 98    // of a body: 2 (SIDE - 1)^2
#define COMPOUND_MAX 20  // parts
#define PROOFS_MAX 60000

typedef struct body {
  gjk_compound_part parts[COMPOUND_MAX];
  gjk_shape shapes[COMPOUND_MAX];
  gjk_vec3 points[COMPOUND_MAX][8];
  gjk_compound_node nodes[GJK_COMPOUND_NODES(COMPOUND_MAX)];
  gjk_compound compound;
  gjk_vec3 vertices[SIDE * SIDE];
  gjk_mesh_triangle triangles[PIECES_MAX];
  gjk_mesh_node mesh_nodes[GJK_MESH_NODES(PIECES_MAX)];
  gjk_mesh mesh;
  int16_t heights[SIDE * SIDE];
  gjk_height_field field;
} body;

static struct {
  gjk_arm_link links[LINKS];
  gjk_arm_part parts[PARTS];
  gjk_shape shapes[PARTS];
  gjk_vec3 points[PARTS][8];
  gjk_arm_model model;
  body data[BODIES];
  gjk_parts bodies[BODIES];
  unsigned body_count;
  gjk_shape ball;
  gjk_collider still;
  // Two arms: [0] has the bodies, [1] their pieces as obstacles.
  gjk_arm arm[2];
  gjk_arm_link_room link_room[2][LINKS];
  gjk_arm_part_room part_room[2][PARTS];
  gjk_arm_pair pairs[2][GJK_ARM_PAIRS(PARTS, BODIES *PIECES_MAX + 1)];
  gjk_collider pieces[BODIES * PIECES_MAX + 1];
  gjk_parts_room rooms[BODIES * PIECES_MAX];
  unsigned first[BODIES + 1];  // of a body's pieces among the obstacles of arm 1
  bool is_curved;
  int32_t from[LINKS], to[LINKS];
} m;

static gjk_pose any_pose(random_state *random, int32_t most) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_vec3 axis = random_in_cube(random, 99);
  pose.position = random_in_cube(random, most);
  if (random_below(random, 3) > 0) {
    (void)gjk_quat_from_axis_angle(&axis, random_range(random, -300000, 300000), &pose.rotation);
  }
  return pose;
}

static gjk_shape any_shape(random_state *random, int32_t size, gjk_vec3 points[8], bool curved) {
  const int32_t x = random_range(random, size / 4, size), y = random_range(random, size / 8, size / 2);
  for (unsigned i = 0; i < 8; i++) {
    points[i] = random_in_cube(random, size);
  }
  const gjk_shape shapes[] = {GJK_HULL(points, 8), GJK_BOX(x, y, y), GJK_CAPSULE(y, x), GJK_SPHERE(x),
                              GJK_CYLINDER(y, x)};
  return shapes[random_below(random, curved ? 5 : 4)];
}

static gjk_parts any_compound(random_state *random, body *b, int32_t size, bool curved) {
  const unsigned count = 1 + random_below(random, COMPOUND_MAX);
  for (unsigned i = 0; i < count; i++) {
    b->shapes[i] = any_shape(random, size / 3, b->points[i], curved);
    b->parts[i].shape = &b->shapes[i];
    b->parts[i].pose = any_pose(random, 2 * size);
  }
  CHECK(gjk_compound_build(b->parts, (uint16_t)count, b->nodes, GJK_COMPOUND_NODES(COMPOUND_MAX), &b->compound) ==
        GJK_OK);
  return (gjk_parts)GJK_PARTS_OF_COMPOUND(&b->compound);
}

// A rough ground, as a mesh of some size.
static gjk_parts any_mesh(random_state *random, body *b, int32_t size) {
  const unsigned side = 2 + random_below(random, SIDE - 1);
  const int32_t step = 4 * size / (int32_t)side;
  uint32_t count = 0;
  for (unsigned i = 0; i < side * side; i++) {
    b->vertices[i].x = ((int32_t)(i % side) - (int32_t)side / 2) * step;
    b->vertices[i].y = ((int32_t)(i / side) - (int32_t)side / 2) * step;
    b->vertices[i].z = random_range(random, -step / 2, step / 2);
  }
  for (unsigned y = 0; y + 1 < side; y++) {
    for (unsigned x = 0; x + 1 < side; x++) {
      const uint32_t at = y * side + x;
      const gjk_mesh_triangle two[2] = {{{at, at + 1, at + side}}, {{at + 1, at + side + 1, at + side}}};
      b->triangles[count++] = two[0];
      b->triangles[count++] = two[1];
    }
  }
  CHECK(gjk_mesh_build(b->vertices, side * side, b->triangles, count, random_below(random, 2) == 0, b->mesh_nodes,
                       GJK_MESH_NODES(PIECES_MAX), &b->mesh) == GJK_OK);
  return (gjk_parts)GJK_PARTS_OF_MESH(&b->mesh);
}

// A field, some of whose cells are holes.
static gjk_parts any_field(random_state *random, body *b, int32_t size) {
  const unsigned columns = 2 + random_below(random, SIDE - 1), rows = 2 + random_below(random, SIDE - 1);
  for (unsigned i = 0; i < columns * rows; i++) {
    b->heights[i] = random_below(random, 20) == 0 ? GJK_HEIGHT_HOLE : (int16_t)random_range(random, -300, 300);
  }
  b->heights[0] = b->heights[1] = b->heights[columns] = b->heights[columns + 1] = 0;
  b->field = (gjk_height_field){b->heights, (uint16_t)columns, (uint16_t)rows, size / 2, size / 2, size / 512 + 1};
  return (gjk_parts)GJK_PARTS_OF_HEIGHT_FIELD(&b->field);
}

static void make_links(random_state *random, int32_t size) {
  const unsigned links = 1 + random_below(random, LINKS);
  for (unsigned i = 0; i < links; i++) {
    gjk_arm_link *link = &m.links[i];
    link->parent = (uint8_t)(i == 0 ? GJK_ARM_BASE : i - 1);
    link->kind = random_below(random, 4) > 0 ? GJK_ARM_REVOLUTE : GJK_ARM_PRISMATIC;
    link->fixed = any_pose(random, size);
    link->axis = random_in_cube(random, 1000);
    link->axis.x = (link->axis.y | link->axis.z) == 0 ? 1 : link->axis.x;
    link->lower = INT32_MIN;
    link->upper = INT32_MAX;
    const int32_t far = link->kind == GJK_ARM_PRISMATIC ? size : 130000;
    m.from[i] = random_range(random, -far, far);
    m.to[i] = random_below(random, 4) == 0 ? m.from[i] : random_range(random, -far, far);
  }
  const gjk_arm_model model = {m.links, m.parts, NULL, (uint8_t)links, (uint16_t)(1 + random_below(random, PARTS))};
  m.model = model;
  for (unsigned i = 0; i < model.part_count; i++) {
    const gjk_pose identity = GJK_POSE_IDENTITY;
    m.shapes[i] = any_shape(random, size / 3, m.points[i], m.is_curved);
    m.parts[i].shape = &m.shapes[i];
    m.parts[i].pose = random_below(random, 2) == 0 ? identity : any_pose(random, size / 3);
    m.parts[i].link = (uint8_t)random_below(random, links);
  }
}

static void place_pieces(void) {
  unsigned count = 0;
  for (unsigned i = 0; i < m.body_count; i++) {
    m.first[i] = count;
    for (uint32_t k = 0; k < gjk_parts_count(&m.bodies[i]); k++, count++) {
      const gjk_status status = gjk_parts_place(&m.bodies[i], k, &m.rooms[count], &m.pieces[count]);
      if (status != GJK_OK) {  // a hole: a point where nothing is
        static const gjk_shape nothing = GJK_POINT;
        const gjk_pose away = {{INT32_MIN, INT32_MIN, INT32_MIN}, {0, 0, 0, GJK_Q30_ONE}};
        CHECK(status == GJK_ERROR_RANGE && gjk_collider_init(&m.pieces[count], &nothing, NULL, 0) == GJK_OK);
        CHECK(gjk_collider_pose(&m.pieces[count], &away) == GJK_OK);
      }
    }
  }
  m.first[m.body_count] = count;
}

// still: with an obstacle beside the bodies, which comes last among the obstacles of arm 1.
static void make_machine(random_state *random, bool still) {
  const int32_t size = INT32_C(1) << (14 + random_below(random, 5));
  const gjk_pose base = any_pose(random, random_below(random, 4) == 0 ? INT32_C(1) << 29 : size);
  m.is_curved = random_below(random, 6) == 0;
  make_links(random, size);
  m.body_count = 1 + random_below(random, BODIES);
  for (unsigned i = 0; i < m.body_count; i++) {
    const unsigned kind = random_below(random, 3);
    m.bodies[i] = kind == 0   ? any_compound(random, &m.data[i], size, m.is_curved)
                  : kind == 1 ? any_mesh(random, &m.data[i], size)
                              : any_field(random, &m.data[i], size);
    m.bodies[i].pose = any_pose(random, size);
    m.bodies[i].pose.position.x += base.position.x;
    m.bodies[i].pose.position.y += base.position.y;
    m.bodies[i].pose.position.z += base.position.z;
  }
  place_pieces();
  for (unsigned i = 0; i < 2; i++) {
    const gjk_arm_memory memory = {m.link_room[i], m.part_room[i], m.pairs[i],
                                   GJK_ARM_PAIRS(PARTS, BODIES * PIECES_MAX + 1)};
    CHECK(gjk_arm_init(&m.arm[i], &m.model, &base, &memory) == GJK_OK);
  }
  if (still) {
    const gjk_shape ball = GJK_SPHERE(size / 4);
    gjk_pose pose = any_pose(random, size);
    pose.position.x += base.position.x;
    m.ball = ball;
    m.still = posed(&m.ball, &pose);
    m.pieces[m.first[m.body_count]] = m.still;
    CHECK(gjk_arm_obstacles(&m.arm[0], &m.still, 1) == GJK_OK);
  }
  CHECK(gjk_arm_bodies(&m.arm[0], m.bodies, (uint16_t)m.body_count) == GJK_OK);
  CHECK(gjk_arm_obstacles(&m.arm[1], m.pieces, (uint16_t)(m.first[m.body_count] + (still ? 1u : 0u))) == GJK_OK);
}

// What arm 1 calls a pair of arm 0.
static gjk_arm_names in_pieces(const gjk_arm_names *names) {
  gjk_arm_names r = *names;
  if (names->obstacle) {
    r.other = (uint16_t)(names->piece == GJK_PARTS_NONE ? m.first[m.body_count] : m.first[names->other] + names->piece);
    r.piece = GJK_PARTS_NONE;
  }
  return r;
}

static bool equal_names(const gjk_arm_names *a, const gjk_arm_names *b) {
  return a->part == b->part && a->other == b->other && a->obstacle == b->obstacle && a->piece == b->piece;
}

static unsigned nears, bodies_near;

// Of the answers and proofs of the seed below: the same from every compiler.
#define SEED 3103
#define HASH UINT64_C(0xA20CCE2B249F4901)
static uint64_t hash = FNV_START;

static void add(int32_t number) {
  hash = fnv_word(hash, (uint32_t)number);
}

static void check_static(random_state *random, bool still) {
  gjk_arm_distance_result of_body, of_pieces;
  gjk_arm_names pair[2];
  bool near[2];
  const gjk_q16 most = random_below(random, 2) == 0 ? GJK_DISTANCE_MAX : random_range(random, 0, 100000);
  gjk_status status[2] = {gjk_arm_distance(&m.arm[0], m.from, most, &of_body),
                          gjk_arm_distance(&m.arm[1], m.from, most, &of_pieces)};
  const bool measured = status[0] == GJK_OK;
  CHECK(status[0] == status[1]);
  if (measured) {
    const gjk_arm_names names = in_pieces(&of_body.pair);
    add(of_body.distance.distance);
    add(of_body.pair.part * 65536 + names.other);
    CHECK(of_body.distance.distance == of_pieces.distance.distance);
    CHECK(still || of_body.distance.saturated ||
          (equal_names(&names, &of_pieces.pair) && same_distance(&of_body.distance, &of_pieces.distance)));
    gjk_q16 slope[2][LINKS];
    if (!still && !of_body.distance.intersecting && !of_body.distance.saturated) {
      CHECK(gjk_arm_gradient(&m.arm[0], m.from, &of_body, slope[0]) == GJK_OK);
      CHECK(gjk_arm_gradient(&m.arm[1], m.from, &of_pieces, slope[1]) == GJK_OK);
      CHECK(memcmp(slope[0], slope[1], m.arm[0].value_count * sizeof slope[0][0]) == 0);
    }
  }
  // At the distance itself, one below, and any.
  for (unsigned i = 0; i < 3; i++) {
    const gjk_q16 d = !measured || i == 2 ? random_range(random, 0, 100000)
                      : i == 0            ? of_body.distance.distance
                                          : of_body.distance.lower - 1;
    if (d < 0) {
      continue;
    }
    status[0] = gjk_arm_near(&m.arm[0], m.from, d, &near[0], &pair[0]);
    status[1] = gjk_arm_near(&m.arm[1], m.from, d, &near[1], &pair[1]);
    CHECK(status[0] == status[1] && near[0] == near[1]);
    if (near[0] && !still) {
      const gjk_arm_names names = in_pieces(&pair[0]);
      CHECK(equal_names(&names, &pair[1]));
    }
    nears += near[0] ? 1u : 0u;
    bodies_near += near[0] && pair[0].obstacle && pair[0].piece != GJK_PARTS_NONE ? 1u : 0u;
  }
}

static gjk_arm_proof proofs[PROOFS_MAX], again[PROOFS_MAX];
static uint32_t proof_count;
static gjk_arm_proof *taken = proofs;

static void take(void *user, const gjk_arm_proof *proof) {
  (void)user;
  if (proof_count < PROOFS_MAX) {
    memset(&taken[proof_count], 0, sizeof *proof);
    taken[proof_count] = *proof;
  }
  proof_count++;
}

static bool equal_results(const gjk_arm_edge_result *a, const gjk_arm_edge_result *b) {
  return a->answer == b->answer && a->lower == b->lower && a->upper == b->upper && a->tests == b->tests &&
         (a->answer != GJK_ARM_FREE || a->gap == b->gap) &&
         (a->answer != GJK_ARM_TOUCH || equal_names(&a->pair, &b->pair));
}

// The same in slices of so many tests; 0: of any number.
static void check_slices(random_state *random, const gjk_arm_setup *setup, uint32_t tests,
                         const gjk_arm_edge_result *whole, uint32_t count) {
  gjk_arm_edge_result part = {.answer = GJK_ARM_UNSETTLED};
  const bool silent = tests > 3;
  uint32_t before = 0;
  taken = again;
  proof_count = 0;
  CHECK(gjk_arm_edge_start(&m.arm[0], m.from, m.to, setup, silent ? NULL : take, NULL) == GJK_OK);
  while (part.answer == GJK_ARM_UNSETTLED && before < 1000000) {
    const uint32_t slice = tests > 0 ? tests : random_below(random, 40);
    CHECK(gjk_arm_edge_run(&m.arm[0], slice, &part) == GJK_OK);
    CHECK(part.tests - before <= slice);
    CHECK(part.answer != GJK_ARM_UNSETTLED || part.tests - before == slice);
    before = part.tests;
  }
  CHECK(equal_results(&part, whole));
  CHECK(silent || (proof_count == count && memcmp(proofs, again, count * sizeof proofs[0]) == 0));
  taken = proofs;
}

static unsigned long answers[3], touched_bodies, dropped, refused, samples_sum;

static bool is_refused(const gjk_arm_setup *setup, const gjk_arm_edge_result *said, uint32_t count) {
  const gjk_status status = gjk_check_edge(&m.arm[0], m.from, m.to, setup, said, proofs, count);
  CHECK(status == GJK_OK || status == GJK_ERROR_UNPROVEN);
  return status == GJK_ERROR_UNPROVEN;
}

// Has the run of proofs that this one is of a last step, and is its span needed?
static bool is_needed(uint32_t number, uint32_t count, const gjk_arm_edge_result *result) {
  const gjk_arm_proof *p = &proofs[number];
  for (uint32_t i = number; i < count && proofs[i].pair == p->pair && proofs[i].from == p->from; i++) {
    if (proofs[i].to == p->to && proofs[i].piece == GJK_PARTS_NONE) {
      return p->from < result->lower;
    }
  }
  return false;
}

// The box around a part at both ends of a span, by the truth's poses.
static void box_at_ends(const gjk_arm_proof *p, unsigned part, gjk_aabb *out) {
  for (unsigned end = 0; end < 2; end++) {
    gjk_pose link, pose;
    gjk_aabb box;
    arm_truth_pose(&m.arm[0], m.from, m.to, (end == 0 ? p->from : p->to) / (double)GJK_Q30_ONE, m.parts[part].link,
                   &link);
    CHECK(gjk_pose_compose(&link, &m.parts[part].pose, &pose) == GJK_OK);
    const gjk_collider c = posed(m.parts[part].shape, &pose);
    CHECK(gjk_collider_aabb(&c, &box) == GJK_OK);
    if (end == 0) {
      *out = box;
    }
    out->lower.x = box.lower.x < out->lower.x ? box.lower.x : out->lower.x;
    out->lower.y = box.lower.y < out->lower.y ? box.lower.y : out->lower.y;
    out->lower.z = box.lower.z < out->lower.z ? box.lower.z : out->lower.z;
    out->upper.x = box.upper.x > out->upper.x ? box.upper.x : out->upper.x;
    out->upper.y = box.upper.y > out->upper.y ? box.upper.y : out->upper.y;
    out->upper.z = box.upper.z > out->upper.z ? box.upper.z : out->upper.z;
  }
}

// Is the piece of a proof so near, by boxes of a body that is not turned, that the proof may not be left out?
static bool is_near(const gjk_arm_proof *p, const gjk_arm_setup *setup, const gjk_arm_edge_result *result) {
  const gjk_arm_pair *pair = &m.pairs[0][p->pair];
  const double share = (p->to - p->from) / (double)GJK_Q30_ONE;
  const double wanted =
      (result->answer == GJK_ARM_FREE ? result->gap : setup->margin) - 20 + (double)pair->bend / 8 * share * share;
  gjk_aabb of_part = {{0, 0, 0}, {0, 0, 0}}, of_piece;
  box_at_ends(p, pair->part, &of_part);
  CHECK(gjk_collider_aabb(&m.pieces[m.first[pair->other] + p->piece], &of_piece) == GJK_OK);
  return m.bodies[pair->other].pose.rotation.w == GJK_Q30_ONE && of_piece.lower.x - wanted < of_part.upper.x &&
         of_part.lower.x - wanted < of_piece.upper.x && of_piece.lower.y - wanted < of_part.upper.y &&
         of_part.lower.y - wanted < of_piece.upper.y && of_piece.lower.z - wanted < of_part.upper.z &&
         of_part.lower.z - wanted < of_piece.upper.z;
}

// A proof is changed: it must be refused.
static void forge_proof(uint32_t number, uint32_t count, const gjk_arm_setup *setup,
                        const gjk_arm_edge_result *result) {
  gjk_arm_proof *p = &proofs[number];
  const gjk_arm_proof honest = *p;
  const bool of_body = m.pairs[0][p->pair].frame == 254, last = p->piece == GJK_PARTS_NONE;
  if (!of_body) {
    return;
  }
  if (last || is_near(p, setup, result)) {
    const bool needed = is_needed(number, count, result);
    memmove(p, p + 1, (count - number - 1) * sizeof *p);
    CHECK(is_refused(setup, result, count - 1) || !needed);
    dropped += needed && !last ? 1u : 0u;
    memmove(p + 1, p, (count - number - 1) * sizeof *p);
    *p = honest;
  }
  if (!last) {
    p->piece = gjk_parts_count(&m.bodies[m.pairs[0][p->pair].other]);
    CHECK(is_refused(setup, result, count));
    *p = honest;
    p->direction.x = -p->direction.x;
    p->direction.y = -p->direction.y;
    p->direction.z = -p->direction.z;
    CHECK(is_refused(setup, result, count));
    *p = honest;
    p->direction.x /= 2;
    p->direction.y /= 2;
    p->direction.z /= 2;
    CHECK(is_refused(setup, result, count));
    *p = honest;
    p->to = GJK_Q30_ONE + 1024;
    CHECK(is_refused(setup, result, count));
    *p = honest;
    refused++;
  }
}

// The answer is changed.
static void forge_answer(uint32_t count, const gjk_arm_setup *setup, const gjk_arm_edge_result *result) {
  gjk_arm_edge_result said = *result;
  if (result->answer == GJK_ARM_FREE) {
    const double there = arm_truth_gap(&m.arm[1], m.from, m.to, 0, 1e9);
    said.gap = (gjk_q16)(there + 2 * ARM_TRUTH_ERROR < 1e9 ? there + 2 * ARM_TRUTH_ERROR : 1e9);
    CHECK(is_refused(setup, &said, count) || m.arm[1].pair_count == 0 || there > 9e8);
    return;
  }
  said.answer = GJK_ARM_FREE;
  said.gap = setup->margin;
  said.lower = said.upper = GJK_Q30_ONE;
  CHECK(result->lower == GJK_Q30_ONE || is_refused(setup, &said, count));
  if (result->pair.obstacle && result->pair.piece != GJK_PARTS_NONE) {
    const uint32_t pieces = gjk_parts_count(&m.bodies[result->pair.other]);
    said = *result;
    said.pair.piece = (result->pair.piece + 1) % pieces;
    const gjk_arm_names names = in_pieces(&said.pair);
    const double gap = arm_truth_pair(&m.arm[1], m.from, m.to, result->upper / (double)GJK_Q30_ONE, &names);
    CHECK(gap < setup->margin + setup->tolerance + ARM_TRUTH_ERROR || is_refused(setup, &said, count));
    said.pair.piece = pieces;
    CHECK(is_refused(setup, &said, count));
    said.pair.piece = GJK_PARTS_NONE;
    CHECK(is_refused(setup, &said, count) || m.arm[0].obstacle_count > 0);
  }
}

static void check_edge(random_state *random) {
  const gjk_arm_setup setup = {random_below(random, 2) == 0 ? 0 : random_range(random, 0, 3000),
                               GJK_ARM_TOLERANCE_MIN + (gjk_q16)random_below(random, 3) * 200,
                               random_below(random, 2) == 0 ? GJK_Q30_ONE : 1 << 22};
  gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
  unsigned samples = 0;
  proof_count = 0;
  CHECK(gjk_arm_edge_start(&m.arm[0], m.from, m.to, &setup, take, NULL) == GJK_OK);
  CHECK(gjk_arm_edge_run(&m.arm[0], 1000000, &result) == GJK_OK);
  const uint32_t count = proof_count;
  const double lower = result.lower / (double)GJK_Q30_ONE, close = (double)setup.margin + setup.tolerance;
  answers[result.answer]++;
  add((int32_t)result.answer);
  add(result.lower);
  add(result.answer == GJK_ARM_FREE ? result.gap : result.upper);
  add((int32_t)result.tests);
  for (uint32_t i = 0; i < count && i < PROOFS_MAX; i++) {
    add(proofs[i].to);
    add(proofs[i].direction.x ^ proofs[i].direction.y ^ proofs[i].direction.z);
    add((int32_t)(proofs[i].pair ^ proofs[i].piece));
  }
  CHECK(count <= PROOFS_MAX);
  if (result.answer == GJK_ARM_FREE) {
    CHECK(result.gap >= setup.margin);
    CHECK(arm_truth_edge(&m.arm[1], m.from, m.to, 0, 1, result.gap - 1.0, &samples) != ARM_TRUTH_TOUCH);
  } else {
    const gjk_arm_names names = in_pieces(&result.pair);
    CHECK(result.answer == GJK_ARM_TOUCH);
    CHECK(arm_truth_pair(&m.arm[1], m.from, m.to, result.upper / (double)GJK_Q30_ONE, &names) <=
          close + ARM_TRUTH_ERROR);
    CHECK(result.lower <= result.upper && result.upper - result.lower <= setup.resolution + 1024);
    CHECK(lower == 0 || arm_truth_edge(&m.arm[1], m.from, m.to, 0, lower, setup.margin, &samples) != ARM_TRUTH_TOUCH);
    touched_bodies += result.pair.obstacle && result.pair.piece != GJK_PARTS_NONE ? 1u : 0u;
  }
  samples_sum += samples;
  if (count > PROOFS_MAX) {
    return;
  }
  for (uint32_t tests = 0; tests <= 3; tests++) {
    check_slices(random, &setup, tests, &result, count);
  }
  check_slices(random, &setup, 100000, &result, count);
  CHECK(!is_refused(&setup, &result, count));
  forge_answer(count, &setup, &result);
  for (unsigned i = 0; i < 6 && count > 0; i++) {
    forge_proof(random_below(random, count), count, &setup, &result);
  }
}

// Statuses of bad bodies, and of pieces that turn out bad.
static void check_faults(random_state *random) {
  const gjk_arm_setup setup = {65536, GJK_ARM_TOLERANCE_MIN, 0};
  gjk_parts bad[2];
  gjk_arm none = {0};
  gjk_arm_edge_result result;
  gjk_arm_distance_result nearest;
  gjk_arm_names pair;
  gjk_pose poses[LINKS];
  bool near;
  do {
    make_machine(random, false);
  } while (m.arm[0].self_count > 0);
  gjk_arm *arm = &m.arm[0];
  const uint32_t pairs = arm->pair_count;
  bad[0] = bad[1] = any_compound(random, &m.data[0], 65536, false);
  CHECK(gjk_arm_bodies(NULL, bad, 1) == GJK_ERROR_NULL && gjk_arm_bodies(arm, NULL, 1) == GJK_ERROR_NULL);
  CHECK(gjk_arm_bodies(&none, bad, 1) == GJK_ERROR_UNINITIALISED);
  bad[1].pose.rotation.w = 3;
  CHECK(gjk_arm_bodies(arm, bad, 2) == GJK_ERROR_ROTATION);
  bad[1] = bad[0];
  bad[1].pose.position.x = INT32_MAX;
  CHECK(gjk_arm_bodies(arm, bad, 2) == GJK_ERROR_RANGE);
  bad[1].type = NULL;
  CHECK(gjk_arm_bodies(arm, bad, 2) == GJK_ERROR_NULL);
  m.data[1].compound = m.data[0].compound;
  m.data[1].compound.count = 0;
  bad[1] = bad[0];
  bad[1].data = &m.data[1].compound;
  CHECK(gjk_arm_bodies(arm, bad, 2) == GJK_ERROR_EMPTY);
  const uint32_t room = arm->memory.pair_capacity;
  arm->memory.pair_capacity = 0;
  CHECK(gjk_arm_bodies(arm, bad, 1) == GJK_ERROR_CAPACITY && arm->pair_count == pairs);
  arm->memory.pair_capacity = room < pairs ? room : pairs;
  CHECK(gjk_arm_bodies(arm, bad, UINT16_MAX) != GJK_OK && arm->pair_count == pairs);
  CHECK(gjk_arm_obstacles(arm, m.pieces, 1) == GJK_ERROR_CAPACITY && arm->pair_count == pairs);
  CHECK(gjk_arm_bodies(arm, NULL, 0) == GJK_OK && arm->pair_count == arm->self_count);
  // A part's shape is broken after the compound was built.
  CHECK(gjk_arm_poses(arm, m.from, poses) == GJK_OK);
  bad[0].pose.position = poses[m.parts[0].link].position;
  CHECK(gjk_arm_bodies(arm, bad, 1) == GJK_OK);
  for (unsigned i = 0; i < m.data[0].compound.count; i++) {
    m.data[0].shapes[i].convex_radius = -1;
  }
  CHECK(gjk_arm_near(arm, m.from, 65536, &near, &pair) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_arm_distance(arm, m.from, GJK_DISTANCE_MAX, &nearest) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_arm_edge_start(arm, m.from, m.to, &setup, NULL, NULL) == GJK_OK);
  CHECK(gjk_arm_edge_run(arm, 1000, &result) == GJK_ERROR_NEGATIVE && result.answer == GJK_ARM_UNSETTLED);
  CHECK(gjk_arm_edge_run(arm, 1000, &result) == GJK_ERROR_NEGATIVE && result.answer == GJK_ARM_UNSETTLED);
  bad[0].pose.rotation.w = 3;
  CHECK(gjk_arm_edge_start(arm, m.from, m.to, &setup, NULL, NULL) == GJK_OK);
  CHECK(gjk_arm_edge_run(arm, 1000, &result) == GJK_ERROR_ROTATION && result.answer == GJK_ARM_UNSETTLED);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  random_state random = random_seed(seed);
  const unsigned long trials = check_trials(TRIALS);
  const bool whole = trials == TRIALS && seed == SEED;
  for (unsigned long i = 0; i < trials; i++) {
    const bool still = i % 4 == 3;
    check_trial(i, NULL, NULL);
    bool near = true;
    for (unsigned tries = 0; near && tries < 30; tries++) {
      make_machine(&random, still);
      CHECK(gjk_arm_near(&m.arm[0], m.from, 0, &near, NULL) != GJK_ERROR_RANGE);
    }
    check_static(&random, still);
    check_edge(&random);
  }
  printf("%lu free, %lu touch, %lu of them bodies; %u near, %u of them bodies; %lu proofs forged, %lu left out\n",
         answers[GJK_ARM_FREE], answers[GJK_ARM_TOUCH], touched_bodies, nears, bodies_near, refused, dropped);
  CHECK(trials < 200 || (answers[GJK_ARM_FREE] > trials / 6 && touched_bodies > trials / 8 &&
                         bodies_near > trials / 3 && refused > trials / 2 && dropped > trials / 20));
  check_faults(&random);
  CHECK_MSG(!whole || hash == HASH, "0x%llX", (unsigned long long)hash);
  return check_done("arm bodies");
}
