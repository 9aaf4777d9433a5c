// Fast bodies that touch a concave one at the start of their way: what they touch is no impact, also where rounding decides
// or a triangle has its corners in a line; and a wall is, however near it was, wherever the body's part is.
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"
#include "scene/concave_game.h"

#define SEED UINT64_C(0x53746172)
#define TOUCHES 6000
#define WALLS 800
#define ONE GJK_Q16_ONE

static struct { unsigned long touching, lines; } tally;

static game m;
static game_scene s;

// Two triangles of any size and tilt; in some the second has its corners in a line.
static gjk_vec3 vertices[4];
static gjk_mesh_node nodes[2];

static void make_leaves(random_state *random, gjk_mesh *mesh) {
  const int32_t size = 1 << random_range(random, 8, 27);
  gjk_mesh_triangle triangles[2] = {{{0, 1, 2}}, {{0, 2, 3}}};
  static gjk_mesh_triangle kept[2];
  for (unsigned i = 0; i < 4; i++) {
    vertices[i] = (gjk_vec3){random_range(random, -size / 2, size / 2), random_range(random, -size / 2, size / 2),
                             random_range(random, -size / 2, size / 2)};
  }
  if (random_below(random, 4) == 0) {
    const gjk_vec3 *a = &vertices[0], *b = &vertices[2];
    vertices[3] = (gjk_vec3){2 * b->x - a->x, 2 * b->y - a->y, 2 * b->z - a->z};
  }
  memcpy(kept, triangles, sizeof kept);
  CHECK(gjk_mesh_build(vertices, 4, kept, 2, random_below(random, 2) != 0, nodes, 2, mesh) == GJK_OK);
}

// Moves a body to where it touches the mesh, or nearly. False: it does not.
static bool bring_together(const gjk_parts *parts, gjk_collider *b, gjk_pose *pose, const gjk_vec3 *way) {
  const gjk_vec3 to = {pose->position.x - 2 * way->x, pose->position.y - 2 * way->y, pose->position.z - 2 * way->z};
  const gjk_cast_path path = {NULL, &to, 0};
  gjk_cast_result result;
  gjk_decision decision;
  if (gjk_parts_cast(parts, b, &path, NULL, &result) != GJK_OK || !result.hit || result.inside) {
    return false;
  }
  pose->position = result.rest_b;
  decision.yes = false;
  for (unsigned n = 0; n < 12 && !decision.yes; n++) {  // LSB by LSB
    CHECK(gjk_collider_pose(b, pose) == GJK_OK);
    CHECK(gjk_parts_intersect(parts, b, NULL, &decision) == GJK_OK);
    pose->position.x -= decision.yes ? 0 : way->x > 0 ? 1 : -1;
    pose->position.y -= decision.yes || n % 2 == 0 ? 0 : way->y > 0 ? 1 : -1;
    pose->position.z -= decision.yes || n % 3 == 0 ? 0 : way->z > 0 ? 1 : -1;
  }
  return decision.yes;
}

// A body that touches a triangle by less than an LSB was not in front of it: it does not meet it at the start.
static void check_touch(random_state *random) {
  gjk_mesh mesh;
  gjk_cast_result cast;
  gjk_impact_result impact;
  gjk_mesh_report report;
  make_leaves(random, &mesh);
  gjk_parts parts = GJK_PARTS_OF_MESH(&mesh);
  parts.pose.rotation = random_rotation(random);
  const int32_t wide = mesh.upper.x - mesh.lower.x, size = random_below(random, 2) != 0 && wide > 64 && wide < 1 << 26
                                                               ? wide
                                                               : 1 << random_range(random, 6, 20);
  const gjk_shape shapes[3] = {GJK_BOX(size / 2, size / 2, size / 2), GJK_SPHERE(size / 2),
                               GJK_ROUNDED_BOX(size / 3, size / 4, size / 5, size / 8)};
  const gjk_vec3 way = random_vector(random, 1.0 * wide + 3.0 * size);
  gjk_pose pose = {way, random_rotation(random)};
  gjk_collider b = {0};
  CHECK(gjk_collider_init(&b, &shapes[random_below(random, 3)], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&b, &pose) == GJK_OK);
  if (!bring_together(&parts, &b, &pose, &way)) {
    return;
  }
  const gjk_vec3 off = random_vector(random, 2.0 * size);
  const gjk_vec3 to = {pose.position.x + off.x, pose.position.y + off.y, pose.position.z + off.z};
  const gjk_cast_path path = {NULL, &to, 0};
  CHECK(gjk_parts_cast_ahead(&parts, &b, &path, NULL, &cast) == GJK_OK && !(cast.hit && cast.inside));
  const gjk_motion stands = {parts.pose, parts.pose, {0, 0, 0}},
                   moves = {pose, {to, random_rotation(random)}, {0, 0, 0}};
  const gjk_impact_setup setup = {0, 144, 0};
  CHECK(gjk_parts_impact_ahead(&parts, &stands, &b, &moves, &setup, NULL, &impact) == GJK_OK);
  CHECK(gjk_mesh_check(&mesh, &report) == GJK_OK);
  tally.touching++;
  tally.lines += report.fault == GJK_MESH_DEGENERATE;
}

// The shapes of the game: a mesh, and another one as all but the first.
static void set_shapes(const gjk_vec3 *corners, uint32_t corner_count, gjk_mesh_triangle *triangles, uint32_t count,
                       const gjk_shape *other) {
  static gjk_mesh mesh;
  static gjk_concave concave;
  static gjk_shape ground;
  CHECK(gjk_mesh_build(corners, corner_count, triangles, count, false, nodes, 2, &mesh) == GJK_OK);
  const gjk_parts parts = GJK_PARTS_OF_MESH(&mesh);
  CHECK(gjk_concave_init(&parts, &concave, &ground) == GJK_OK);
  for (unsigned i = 0; i < GAME_SHAPES; i++) {
    m.shapes[i] = i == 0 ? &ground : other;
  }
}

// A crate that lies on ground with a triangle whose corners are in a line slides and turns there, and meets nothing.
static void check_line(bool turns) {
  static const gjk_vec3 corners[7] = {{-8 * ONE, -8 * ONE, 0},
                                      {8 * ONE, -8 * ONE, 0},
                                      {8 * ONE, 8 * ONE, 0},
                                      {-8 * ONE, 8 * ONE, 0},
                                      {0, 0, 0},
                                      {ONE, 0, 0},
                                      {2 * ONE, 0, 0}};
  static const gjk_shape crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2);
  gjk_mesh_triangle triangles[3] = {{{0, 1, 2}}, {{0, 2, 3}}, {{4, 5, 6}}};
  memset(m.body, 0, sizeof m.body);
  set_shapes(corners, 7, triangles, 3, &crate);
  const gjk_scene_config config = game_config(&m, 10, 0, 0, 0);
  const gjk_part part[2] = {{0, false, GJK_POSE_IDENTITY}, {1, false, GJK_POSE_IDENTITY}};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part[0], 1, GJK_BODY_STATIC, 0, 1, 1, 0, 0};
  CHECK(game_start(&m, &config, &s) == GJK_OK && gjk_scene_add(&s.scene, &setup, &s.id[0]) == GJK_OK);
  setup.parts = &part[1];
  setup.kind = GJK_BODY_DYNAMIC;
  setup.pose.position = (gjk_vec3){ONE, 0, ONE / 2 - 10};
  CHECK(gjk_scene_add(&s.scene, &setup, &s.id[1]) == GJK_OK);
  CHECK(gjk_scene_set_motion(&s.scene, s.id[1], GJK_MOTION_FAST) == GJK_OK);
  for (int32_t t = 0; t < 4; t++) {
    const gjk_vec3 up = {0, 0, ONE};
    CHECK(game_update(&s, UINT32_MAX, GAME_REPORTS) == GJK_OK);
    CHECK_MSG(s.reports == 1 && s.report[0].event != GJK_EVENT_IMPACT, "%u reports", s.reports);
    setup.pose.position.x += ONE / 10;
    CHECK(!turns || gjk_quat_from_axis_angle(&up, 1000 * (t + 1), &setup.pose.rotation) == GJK_OK);
    CHECK(gjk_scene_move(&s.scene, s.id[1], &setup.pose) == GJK_OK);
  }
  game_end(&s);
}

// A ground and a wall across it, at any rotation, and a body that lies on the ground, up to 60 LSB before the wall. Wherever
// its part is, and however it turns, it does not pass.
static void check_wall(random_state *random, unsigned long trial) {
  static const gjk_vec3 corners[8] = {{-10 * ONE, -10 * ONE, 0},    {10 * ONE, -10 * ONE, 0},
                                      {10 * ONE, 10 * ONE, 0},      {-10 * ONE, 10 * ONE, 0},
                                      {3 * ONE, -10 * ONE, -ONE},   {3 * ONE, 10 * ONE, -ONE},
                                      {3 * ONE, 10 * ONE, 4 * ONE}, {3 * ONE, -10 * ONE, 4 * ONE}};
  static const gjk_shape kinds[4] = {GJK_SPHERE(ONE / 2), GJK_BOX(ONE / 2, ONE / 2, ONE / 2),
                                     GJK_ROUNDED_BOX(ONE / 4, ONE / 4, ONE / 4, ONE / 4),
                                     GJK_CYLINDER(ONE / 2, ONE / 2)};
  const bool own = trial % 2 != 0, turns = own || random_below(random, 2) != 0;
  const int32_t arm = own ? 2 * ONE : 0, gap = random_range(random, 3, 60);
  gjk_mesh_triangle triangles[4] = {{{0, 1, 2}}, {{0, 2, 3}}, {{4, 7, 6}}, {{4, 6, 5}}};
  set_shapes(corners, 8, triangles, 4, &kinds[trial / 2 % 4]);
  const gjk_scene_config config = game_config(&m, 10, 0, 0, 0);
  const gjk_part part[2] = {{0, false, GJK_POSE_IDENTITY}, {1, own, {{arm, 0, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part[0], 1, GJK_BODY_STATIC, 0, 1, 1, 0, 0};
  const gjk_pose all = {{0, 0, 0}, random_rotation(random)};
  gjk_pose at = {{5 * ONE / 2 - gap - arm, 0, ONE / 2 - random_range(random, 3, 200)}, {0, 0, 0, GJK_Q30_ONE}};
  setup.pose = all;
  CHECK(game_start(&m, &config, &s) == GJK_OK && gjk_scene_add(&s.scene, &setup, &s.id[0]) == GJK_OK);
  setup.parts = &part[1];
  setup.kind = GJK_BODY_DYNAMIC;
  CHECK(gjk_pose_compose(&all, &at, &setup.pose) == GJK_OK);
  CHECK(gjk_scene_add(&s.scene, &setup, &s.id[1]) == GJK_OK);
  CHECK(gjk_scene_set_motion(&s.scene, s.id[1], GJK_MOTION_FAST) == GJK_OK);
  CHECK(game_update(&s, UINT32_MAX, GAME_REPORTS) == GJK_OK && s.reports == 1);
  const gjk_vec3 up = {0, 0, ONE};
  at.position.x += 3 * ONE;
  CHECK(!turns || gjk_quat_from_axis_angle(&up, ONE / 2, &at.rotation) == GJK_OK);
  CHECK(gjk_pose_compose(&all, &at, &setup.pose) == GJK_OK);
  CHECK(gjk_scene_move(&s.scene, s.id[1], &setup.pose) == GJK_OK);
  CHECK(game_update(&s, UINT32_MAX, GAME_REPORTS) == GJK_OK);
  CHECK_MSG(s.reports > 0 && s.report[s.reports - 1].event == GJK_EVENT_IMPACT, "passes the wall, gap %d, %s, %s",
            (int)gap, own ? "own pose" : "no own pose", turns ? "turns" : "does not turn");
  game_end(&s);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < check_trials(TOUCHES); i++) {
    random_state random = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    check_touch(&random);
  }
  for (unsigned long i = 0; i < check_trials(WALLS); i++) {
    random_state random = random_seed(seed + 1000000 + i);
    check_trial(1000000 + i, NULL, NULL);
    check_wall(&random, i);
  }
  check_line(false);
  check_line(true);
  printf("%lu bodies that touch, %lu of meshes with a line\n", tally.touching, tally.lines);
  CHECK(!check_is_full() || (tally.touching > TOUCHES / 2 && tally.lines > TOUCHES / 20));
  return check_done("concave_start");
}
