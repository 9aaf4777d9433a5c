// Two concave bodies of which one is fast, against gjk/parts.h. And a ground with a wall, both of one mesh: a body that lies
// on the ground runs into the wall however fast it is, and into nothing else. test_concave_ways.c asks many bodies.
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"
#include "scene/concave_world.h"

#define SEED UINT64_C(0x46617374)
#define ONE GJK_Q16_ONE
#define TRIALS 400
#define REPORTS 100
#define SIDE 16

static struct { unsigned long walls, free, both, passed; } tally;

static concave_world w;
static const gjk_shape *shapes[2];
static uint32_t block[20000];
static gjk_scene scene;
static gjk_report reports[REPORTS];

static void start(void) {
  const gjk_scene_config config = {4, 4, 0, 100, 3000, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 4};
  const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, &bindings) == GJK_OK);
}

static gjk_body_id add_one(uint16_t shape, const gjk_pose *pose, uint8_t kind, uint32_t category, uint32_t mask) {
  const gjk_part part = {shape, false, GJK_POSE_IDENTITY};
  const gjk_body_setup setup = {*pose, &part, 1, kind, 0, category, mask, 0, 0};
  gjk_body_id id = {0, 0};
  CHECK(gjk_scene_add(&scene, &setup, &id) == GJK_OK);
  return id;
}

static gjk_body_id add(uint16_t shape, const gjk_pose *pose) {
  return add_one(shape, pose, GJK_BODY_STATIC, 1, 2);
}

static uint32_t update(void) {
  gjk_progress progress;
  CHECK(gjk_scene_update(&scene, reports, REPORTS, &progress) == GJK_OK && progress.reports_left == 0);
  return progress.reports;
}

static gjk_pose any_pose(random_state *random, int32_t size, double far) {
  gjk_pose pose;
  pose.position = random_vector(random, far * size * random_unit(random));
  pose.rotation = random_rotation(random);
  return pose;
}

// Movers are no pairs of each other.
static gjk_body_id add_mover(uint16_t shape, const gjk_pose *pose) {
  const gjk_body_id id = add_one(shape, pose, GJK_BODY_DYNAMIC, 2, 1);
  CHECK(gjk_scene_set_motion(&scene, id, GJK_MOTION_FAST) == GJK_OK);
  return id;
}

// How near two bodies of many parts are at a fraction of their ways.
static gjk_q16 gap_of(const gjk_parts parts[2], const gjk_motion motion[2], gjk_q30 x) {
  gjk_parts at[2] = {parts[0], parts[1]};
  gjk_distance_result gap;
  CHECK(gjk_motion_pose(&motion[0], x, &at[0].pose) == GJK_OK && gjk_motion_pose(&motion[1], x, &at[1].pose) == GJK_OK);
  CHECK(gjk_parts_both_distance(&at[0], &at[1], NULL, &gap) == GJK_OK);
  return gap.intersecting ? 0 : gap.distance;
}

// Two concave bodies, one of which turns and moves; the other may, or is put elsewhere at once: the first impact is that of gjk/parts.h, and before it,
// or without one, they are apart.
static void check_both(random_state *random) {
  const int32_t size = 1 << random_range(random, 10, 16);
  concave_world_make(&w, random, size);
  const unsigned a = (unsigned)random_below(random, CONCAVE_BODIES), b = random_below(random, 2) != 0 ? 2u : a;
  const bool moves = random_below(random, 2) != 0;
  gjk_motion motion[2];
  gjk_body_id id[2];
  for (unsigned k = 0; k < 2; k++) {
    shapes[k] = &w.body[k == 0 ? a : b].shape;
    motion[k] = (gjk_motion){any_pose(random, size, 24), any_pose(random, size, 24), {0, 0, 0}};
    motion[k].to = k == 0 || moves ? motion[k].to : motion[k].from;
  }
  const gjk_parts parts[2] = {w.body[a].parts, w.body[b].parts};
  start();
  const bool fast = random_below(random, 2) != 0;
  for (unsigned k = 0; k < 2; k++) {
    id[k] = add_one((uint16_t)k, &motion[k].from, GJK_BODY_DYNAMIC, 1, 1);
    CHECK((k == 1 && !fast) || gjk_scene_set_motion(&scene, id[k], GJK_MOTION_FAST) == GJK_OK);
  }
  const bool near = update() > 0;
  for (unsigned k = 0; k < 2; k++) {
    CHECK(gjk_scene_move(&scene, id[k], &motion[k].to) == GJK_OK);
  }
  motion[1].from = fast ? motion[1].from : motion[1].to;
  const uint32_t count = update();
  gjk_q30 fraction = -1;
  for (uint32_t n = 0; n < count; n++) {
    if (reports[n].event == GJK_EVENT_IMPACT) {
      CHECK(fraction < 0 || fraction == (gjk_q30)reports[n].fraction);
      fraction = (gjk_q30)reports[n].fraction;
    }
  }
  const bool first = gjk_parts_count(&parts[0]) >= gjk_parts_count(&parts[1]);
  const gjk_impact_setup setup = {0, GJK_PARTS_BOTH_TOLERANCE_MIN, 0};
  gjk_impact_result expected;
  CHECK(gjk_parts_both_time_of_impact(&parts[first ? 0 : 1], &motion[first ? 0 : 1], &parts[first ? 1 : 0],
                                      &motion[first ? 1 : 0], &setup, NULL, &expected) == GJK_OK);
  if (near || gap_of(parts, motion, 0) == 0) {  // those are free to go on from where they touch
    concave_world_free(&w);
    return;
  }
  CHECK_MSG(expected.hit == (fraction >= 0) && (fraction < 0 || fraction == expected.lower), "%d, expected %d",
            (int)fraction, expected.hit ? (int)expected.lower : -1);
  const gjk_q30 end = fraction < 0 ? GJK_Q30_ONE : fraction;
  for (int n = 0; n <= 32; n++) {
    const gjk_q30 x = (gjk_q30)((int64_t)end * n / 32);
    CHECK_MSG(n == 32 || gap_of(parts, motion, x) > 0, "together at %d, before %d", (int)x, (int)end);
  }
  const gjk_q16 left = fraction < 0 ? 0 : gap_of(parts, motion, expected.upper);
  CHECK_MSG(left <= setup.tolerance + 2, "gap %d", (int)left);
  tally.both += fraction >= 0;
  tally.passed += fraction < 0;
  concave_world_free(&w);
}

// A ground of SIDE by SIDE units, and across it, where it says, a wall of two triangles that face the other way.
static gjk_mesh ground;
static gjk_vec3 vertices[(SIDE + 1) * (SIDE + 1) + 4];
static gjk_mesh_triangle triangles[2 * SIDE * SIDE + 2];
static gjk_mesh_node nodes[GJK_MESH_NODES(2 * SIDE * SIDE + 2) + 4];

static void make_ground(random_state *random, bool wall, bool two_sided) {
  uint32_t n = 0, t = 0;
  for (int j = 0; j <= SIDE; j++) {
    for (int i = 0; i <= SIDE; i++) {
      vertices[n++] = (gjk_vec3){(i - SIDE / 2) * ONE, (j - SIDE / 2) * ONE, 0};
    }
  }
  for (uint32_t j = 0; j < SIDE; j++) {
    for (uint32_t i = 0; i < SIDE; i++) {
      const uint32_t a = j * (SIDE + 1) + i;
      const bool other = random_below(random, 2) != 0;
      triangles[t++] = (gjk_mesh_triangle){{a, a + 1, other ? a + SIDE + 2 : a + SIDE + 1}};
      triangles[t++] = (gjk_mesh_triangle){{other ? a : a + 1, a + SIDE + 2, a + SIDE + 1}};
    }
  }
  if (wall) {
    for (int k = 0; k < 4; k++) {
      vertices[n++] = (gjk_vec3){3 * ONE, (k == 0 || k == 3 ? -1 : 1) * SIDE / 2 * ONE, k < 2 ? -ONE : 4 * ONE};
    }
    triangles[t++] = (gjk_mesh_triangle){{n - 4, n - 1, n - 2}};
    triangles[t++] = (gjk_mesh_triangle){{n - 4, n - 2, n - 3}};
  }
  CHECK(gjk_mesh_build(vertices, n, triangles, t, two_sided, nodes, sizeof nodes / sizeof nodes[0], &ground) == GJK_OK);
}

static void check_wall(random_state *random, unsigned long trial) {
  static const gjk_shape kinds[] = {GJK_BOX(ONE / 2, ONE / 2, ONE / 2), GJK_SPHERE(ONE / 2),
                                    GJK_ROUNDED_BOX(ONE / 3, ONE / 3, ONE / 3, ONE / 6)};
  const bool wall = trial % 2 == 0, turns = random_below(random, 2) != 0;
  const unsigned kind = (unsigned)random_below(random, 3);
  gjk_concave concave;
  gjk_shape shape;
  make_ground(random, wall, random_below(random, 2) != 0);
  const gjk_parts parts = GJK_PARTS_OF_MESH(&ground);
  CHECK(gjk_concave_init(&parts, &concave, &shape) == GJK_OK);
  shapes[0] = &shape;
  shapes[1] = &kinds[kind];
  start();
  const gjk_vec3 up = {0, 0, ONE};
  gjk_pose ground_pose = GJK_POSE_IDENTITY, from = GJK_POSE_IDENTITY, to;
  const gjk_body_id id = add(0, &ground_pose);
  from.position = (gjk_vec3){random_range(random, -5 * ONE, ONE), random_range(random, -3 * ONE, 3 * ONE),
                             ONE / 2 - random_range(random, 3, 300)};
  CHECK(gjk_quat_from_axis_angle(&up, random_range(random, -200000, 200000), &from.rotation) == GJK_OK);
  to = from;
  to.position.x = 3 * ONE + random_range(random, ONE, 4 * ONE);  // beyond the wall
  to.position.y += random_range(random, -ONE, ONE);
  if (turns) {
    gjk_quat turn;
    CHECK(gjk_quat_from_axis_angle(&up, random_range(random, -100000, 100000), &turn) == GJK_OK);
    CHECK(gjk_quat_compose(&turn, &from.rotation, &to.rotation) == GJK_OK);
  }
  const gjk_body_id body = add_mover(1, &from);
  CHECK(update() == 1 && reports[0].event == GJK_EVENT_BEGIN);
  CHECK(gjk_scene_move(&scene, body, &to) == GJK_OK);
  const uint32_t count = update();
  unsigned impacts = 0;
  for (uint32_t i = 0; i < count; i++) {
    if (reports[i].event == GJK_EVENT_IMPACT) {
      impacts++;
      CHECK(reports[i].b.slot == id.slot);
      const double at =
          (double)from.position.x + (double)(to.position.x - from.position.x) * reports[i].fraction / GJK_Q30_ONE;
      CHECK_MSG(at > 3.0 * ONE - 0.9 * ONE && at < 3.0 * ONE - 0.45 * ONE, "met at %f", at / ONE);
    }
  }
  CHECK_MSG(impacts == (wall ? 1u : 0u), "%u impacts, kind %u, %s", impacts, kind, turns ? "turns" : "does not turn");
  tally.walls += wall;
  tally.free += !wall;
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state random = random_seed(seed + 2000 + i);
    check_trial(2000 + i, NULL, NULL);
    check_both(&random);
  }
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state random = random_seed(seed + 1000 + i);
    check_trial(1000 + i, NULL, NULL);
    check_wall(&random, i);
  }
  printf("%lu walls met, %lu ways free; two concave ones: %lu met, %lu not\n", tally.walls, tally.free, tally.both,
         tally.passed);
  CHECK(tally.both > 40 && tally.passed > 40);
  return check_done("concave_fast");
}
