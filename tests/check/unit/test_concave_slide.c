// Move and slide over concave bodies: stairs of a mesh, bumps of a height field, a doorway of a compound. No joint stops a
// walker, steps count as high as they are, nothing sinks in; and at random as among the same parts as bodies of their own.
#include <stdlib.h>
#include <string.h>

#include "ceilings.h"
#include "check.h"
#include "gjk/gjk.h"
#include "gjk/slide.h"
#include "placed.h"
#include "reference/random_shape.h"
#include "scene_bodies.h"

#define SEED UINT64_C(0x536C6964)
#define ROOMS check_trials(60)
#define WALKS 50
#define ONE GJK_Q16_ONE
#define SKIN 328  // 0.005 units
#define WIDE 9    // vertices across the stairs
#define LONG 40   // most along them
#define SIDE 25
#define PIECES 700
#define GATES 3

static const gjk_shape man = GJK_CAPSULE(GJK_Q16(0.3), GJK_Q16(0.5)), robot = GJK_BOX(ONE / 3, ONE / 4, ONE / 2);
static const gjk_shape post = GJK_BOX(ONE / 4, ONE / 2, ONE), lintel = GJK_BOX(ONE / 4, GJK_Q16(1.5), ONE / 4);
#define AT(x, y, z)        \
  {                        \
    {x, y, z}, {           \
      0, 0, 0, GJK_Q30_ONE \
    }                      \
  }
static const gjk_compound_part gate_parts[] = {
    {&post, AT(0, -ONE, ONE)}, {&post, AT(0, ONE, ONE)}, {&lintel, AT(0, 0, 2 * ONE + ONE / 4)}};

// A ground: a mesh, or a field.
static gjk_vec3 vertices[LONG * WIDE];
static gjk_mesh_triangle triangles[2 * LONG * WIDE];
static gjk_mesh_node mesh_nodes[LONG * WIDE];
static gjk_mesh mesh;
static int16_t heights[SIDE * SIDE];
static const gjk_height_field field = GJK_HEIGHT_FIELD(heights, SIDE, SIDE, ONE / 2, ONE / 2, 64);
static gjk_compound_node gate_nodes[GJK_COMPOUND_NODES(3)];
static gjk_compound gate;
static gjk_concave concave[2];
static gjk_shape concave_shape[2];  // of the ground, of the gate

// The scene, and one of the same parts, each as a body.
static gjk_scene scene, apart;
static uint32_t block[4000], apart_block[60000];
static gjk_shape piece[PIECES];
static gjk_vec3 corners[PIECES][3];
static const gjk_shape *piece_shapes[PIECES];
static gjk_pose piece_poses[PIECES];
static uint16_t pieces;

static struct {
  unsigned long walks, slid, stood, climbed, full, same, other;
  unsigned casts;
} tally;

// Stairs: ground from x = -8, then steps of a height and 1 unit deep from x = 0 on. In joints half a unit apart.
static gjk_parts make_stairs(gjk_q16 height, unsigned steps) {
  gjk_vec3 profile[LONG];
  unsigned along = 0, count = 0;
  for (int i = -16; i < 0; i++) {
    profile[along++] = (gjk_vec3){i * (ONE / 2), 0, 0};
  }
  for (unsigned k = 0; k <= steps; k++) {
    const int32_t x = (int32_t)k * ONE, z = (int32_t)k * height;
    profile[along++] = (gjk_vec3){x, 0, z};
    if (k < steps) {
      profile[along++] = (gjk_vec3){x, 0, z + height};
    }
  }
  profile[along++] = (gjk_vec3){((int32_t)steps + 4) * ONE, 0, (int32_t)steps * height};
  CHECK(along <= LONG);
  for (unsigned i = 0; i < along; i++) {
    for (unsigned j = 0; j < WIDE; j++) {
      vertices[i * WIDE + j] = profile[i];
      vertices[i * WIDE + j].y = ((int32_t)j - WIDE / 2) * ONE;
    }
  }
  for (uint32_t i = 0; i + 1 < along; i++) {
    for (uint32_t j = 0; j + 1 < WIDE; j++) {
      const uint32_t a = i * WIDE + j, b = a + WIDE, c = b + 1, d = a + 1;
      triangles[count++] = (gjk_mesh_triangle){{a, b, c}};
      triangles[count++] = (gjk_mesh_triangle){{a, c, d}};
    }
  }
  CHECK(gjk_mesh_build(vertices, along * WIDE, triangles, count, false, mesh_nodes, GJK_MESH_NODES(count), &mesh) ==
        GJK_OK);
  return (gjk_parts)GJK_PARTS_OF_MESH(&mesh);
}

// Bumps of at most about 30 degrees.
static gjk_parts make_bumps(random_state *random) {
  for (unsigned i = 0; i < SIDE * SIDE; i++) {
    heights[i] = (int16_t)random_range(random, 0, 250);
  }
  return (gjk_parts)GJK_PARTS_OF_HEIGHT_FIELD(&field);
}

static void start_scene(const gjk_parts *ground) {
  static const gjk_shape *const shapes[] = {&concave_shape[0], &concave_shape[1]};
  static const gjk_pose at = GJK_POSE_IDENTITY;
  const gjk_scene_config config = {.bodies = 1 + GATES, .parts = 1 + GATES, .pairs = 1};
  const gjk_parts of_gate = GJK_PARTS_OF_COMPOUND(&gate);
  CHECK(gjk_compound_build(gate_parts, 3, gate_nodes, GJK_COMPOUND_NODES(3), &gate) == GJK_OK);
  CHECK(gjk_concave_init(ground, &concave[0], &concave_shape[0]) == GJK_OK);
  CHECK(gjk_concave_init(&of_gate, &concave[1], &concave_shape[1]) == GJK_OK);
  CHECK(gjk_scene_bytes(&config) <= sizeof block);
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  (void)scene_add_shape(&scene, 0, GJK_BODY_STATIC, &at);
}

// Each part of a body becomes a piece.
static void cut(const gjk_parts *parts) {
  gjk_parts_room room;
  gjk_collider c = {0};
  for (uint32_t i = 0; i < gjk_parts_count(parts); i++, pieces++) {
    static const gjk_pose identity = GJK_POSE_IDENTITY;
    CHECK(pieces < PIECES && gjk_parts_place(parts, i, &room, &c) == GJK_OK);
    piece_shapes[pieces] = &piece[pieces];
    if (parts->data == &gate) {
      piece[pieces] = *gate_parts[i].shape;
      CHECK(gjk_pose_compose(&parts->pose, &gate_parts[i].pose, &piece_poses[pieces]) == GJK_OK);
      continue;
    }
    for (unsigned k = 0; k < 3; k++) {
      corners[pieces][k] = (gjk_vec3){c.centre.x + c.frame[k].x, c.centre.y + c.frame[k].y, c.centre.z + c.frame[k].z};
    }
    piece[pieces] = (gjk_shape)GJK_TRIANGLE(corners[pieces]);
    piece_poses[pieces] = identity;
  }
}

static void set_walker(gjk_collider *c, const gjk_shape *shape, gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  const gjk_pose pose = AT(x, y, z);
  *c = posed(shape, &pose);
}

static gjk_slide_setup usual(void) {
  gjk_slide_setup s = {0};
  s.up.z = GJK_Q30_ONE;
  s.slope = GJK_Q30_ONE / 2;  // 60 degrees
  s.skin = SKIN;
  s.step = ONE / 3;
  s.reach = ONE / 8;
  return s;
}

static gjk_slide_result walk(const gjk_collider *c, gjk_q16 x, gjk_q16 y, gjk_q16 z, const gjk_slide_setup *setup) {
  const gjk_vec3 to = {x, y, z};
  gjk_slide_result r;
  CHECK(gjk_slide(&scene, c, &to, setup, &r) == GJK_OK);
  CHECK(r.casts <= GJK_SLIDE_CASTS && r.count <= GJK_SLIDE_PLANES);
  tally.casts = r.casts > tally.casts ? r.casts : tally.casts;
  return r;
}

static bool is_near(gjk_q16 x, int64_t y, int64_t error) {
  return x >= y - error && x <= y + error;
}

static bool touches(const gjk_collider *c) {
  uint32_t count = 0;
  CHECK(gjk_scene_query_within(&scene, c, 0, NULL, NULL, NULL, 0, &count) == GJK_OK);
  return count > 0;
}

// What a cast rounds up to a joint of triangles may tilt a rounded walker's normal by 0.6 degrees.
#define TILT (GJK_Q30_ONE / 16384)

// Over flat joints in small and in large steps, along them, across and askew: as far as wanted, and no plane but the floor.
static void check_joints(const gjk_shape *shape, gjk_q16 half) {
  static const gjk_q16 ways[][2] = {{6 * ONE, 0}, {0, ONE}, {6 * ONE, ONE}, {ONE, 3 * ONE / 2}, {40000, 700}};
  const gjk_slide_setup setup = usual();
  gjk_collider c;
  for (unsigned k = 0; k < sizeof ways / sizeof ways[0]; k++) {
    for (int ticks = 1; ticks <= 64; ticks *= 4) {
      gjk_q16 x = -7 * ONE - 3 * (int)k, y = -ONE;
      set_walker(&c, shape, x, y, half + SKIN);
      for (int i = 1; i <= ticks; i++) {
        x += ways[k][0] / ticks;
        y += ways[k][1] / ticks;
        const gjk_slide_result r = walk(&c, x, y, c.position.z - ONE / 20, &setup);
        CHECK(!r.stuck && r.on_ground && !r.stepped && r.count >= 1 && r.count <= 2);
        CHECK(r.plane[0].normal.z > GJK_Q30_ONE - TILT && r.ground.normal.z > GJK_Q30_ONE - TILT);
        CHECK_MSG(is_near(r.position.x, x, 8) && is_near(r.position.y, y, 8) && is_near(r.position.z, half + SKIN, 8),
                  "way %u, %d of %d: %ld %ld", k, i, ticks, (long)(r.position.x - x), (long)(r.position.y - y));
        CHECK(gjk_collider_move(&c, &r.position) == GJK_OK);
        x = r.position.x;
        y = r.position.y;
      }
    }
  }
}

// Up stairs whose steps are lower than a walker's, and not where they are higher; and down again.
static void check_stairs(const gjk_shape *shape, gjk_q16 half_width, gjk_q16 half, gjk_q16 height) {
  const unsigned steps = 6;
  gjk_slide_setup setup = usual();
  gjk_collider c;
  unsigned climbed = 0;
  const gjk_parts stairs = make_stairs(height, steps);
  start_scene(&stairs);
  check_joints(shape, half);
  setup.step = height - ONE / 5;  // round feet climb a little more
  set_walker(&c, shape, -2 * ONE, 0, half + SKIN);
  gjk_slide_result r = walk(&c, 3 * ONE, 0, half, &setup);
  CHECK(!r.stepped && r.on_ground && !r.stuck && is_near(r.position.x, -half_width - SKIN, 8));
  CHECK(is_near(r.position.z, half + SKIN, 8));
  setup.step = height + 8 * SKIN;
  setup.snap = true;
  setup.reach = setup.step;
  for (int i = 0; i < 100 && c.position.x < 9 * ONE; i++) {
    r = walk(&c, c.position.x + ONE / 8, c.position.y + 11, c.position.z - ONE / 50, &setup);
    CHECK_MSG(!r.stuck && r.on_ground && r.position.x > c.position.x + ONE / 64, "tick %d at %ld", i,
              (long)c.position.x);
    climbed += r.stepped;
    CHECK(gjk_collider_move(&c, &r.position) == GJK_OK && !touches(&c));
  }
  CHECK_MSG(climbed >= steps && c.position.x >= 9 * ONE, "%u steps up, to %ld", climbed, (long)c.position.x);
  CHECK(is_near(c.position.z, half + (int)steps * height + SKIN, 8));
  for (int i = 0; i < 200 && c.position.x > -5 * ONE; i++) {
    r = walk(&c, c.position.x - ONE / 8, c.position.y, c.position.z, &setup);
    CHECK(!r.stuck && r.on_ground && r.position.x < c.position.x - ONE / 64);
    CHECK(gjk_collider_move(&c, &r.position) == GJK_OK && !touches(&c));
  }
  CHECK(c.position.x <= -5 * ONE && is_near(c.position.z, half + SKIN, 8));
}

// A doorway: through it, against a post, along the front into it, and up only as far as the lintel.
static void check_gate(const gjk_shape *shape, gjk_q16 half_width, gjk_q16 half) {
  static const gjk_pose at = AT(-4 * ONE, 0, 0);
  gjk_slide_setup setup = usual();
  gjk_collider c;
  const gjk_parts floor = make_stairs(ONE, 1);
  start_scene(&floor);
  (void)scene_add_shape(&scene, 1, GJK_BODY_STATIC, &at);
  set_walker(&c, shape, -6 * ONE, 0, half + SKIN);
  gjk_slide_result r = walk(&c, -2 * ONE, 0, half, &setup);
  CHECK(!r.stuck && r.on_ground && is_near(r.position.x, -2 * ONE, 4) && is_near(r.position.y, 0, 4));
  set_walker(&c, shape, -6 * ONE, ONE, half + SKIN);
  r = walk(&c, -2 * ONE, ONE, half, &setup);
  CHECK(!r.stepped && r.on_ground && is_near(r.position.x, -4 * ONE - ONE / 4 - half_width - SKIN, 8));
  CHECK(is_near(r.position.y, ONE, 8));
  r = walk(&c, -2 * ONE, 0, half, &setup);  // the front turns it aside
  CHECK(r.on_ground && is_near(r.position.x, -4 * ONE - ONE / 4 - half_width - SKIN, 8) && is_near(r.position.y, 0, 8));
  CHECK(is_near(r.position.z, half + SKIN, 8));
  CHECK(gjk_collider_move(&c, &r.position) == GJK_OK);
  r = walk(&c, -2 * ONE, 0, half, &setup);
  CHECK(r.on_ground && is_near(r.position.x, -2 * ONE, 4));
  set_walker(&c, shape, -4 * ONE, 0, half + SKIN);
  r = walk(&c, -4 * ONE, 0, 5 * ONE, &setup);
  CHECK(!r.on_ground && r.count >= 1 && is_near(r.position.z, 2 * ONE - half - SKIN, 8));
}

static gjk_q16 ground_at(gjk_q16 x, gjk_q16 y) {
  const int32_t step = ONE / 2, i = x / step, j = y / step, u = x - i * step, v = y - j * step;
  const int32_t a = heights[j * SIDE + i], b = heights[j * SIDE + i + 1], c = heights[(j + 1) * SIDE + i + 1],
                d = heights[(j + 1) * SIDE + i];
  return (gjk_q16)(64 * (a + ((int64_t)u * (u > v ? b - a : c - d) + (int64_t)v * (u > v ? c - b : d - a)) / step));
}

// Over bumps, from one end to the other.
static void check_bumps(random_state *random, const gjk_shape *shape) {
  gjk_slide_setup setup = usual();
  gjk_collider c;
  const gjk_parts bumps = make_bumps(random);
  start_scene(&bumps);
  setup.snap = true;
  set_walker(&c, shape, ONE, random_range(random, 4 * ONE, 7 * ONE), 3 * ONE);
  gjk_slide_result r = walk(&c, ONE, c.position.y, 0, &setup);
  CHECK(r.on_ground && gjk_collider_move(&c, &r.position) == GJK_OK);
  int ticks = 0;
  for (; ticks < 300 && c.position.x < 11 * ONE; ticks++) {
    r = walk(&c, c.position.x + ONE / 16, c.position.y, c.position.z, &setup);
    CHECK(!r.stuck && r.on_ground && gjk_collider_move(&c, &r.position) == GJK_OK && !touches(&c));
    CHECK(c.position.z > ground_at(c.position.x, c.position.y) + ONE / 2);
  }
  CHECK_MSG(ticks < 240, "%d ticks to %ld", ticks, (long)c.position.x);
}

// A room of a ground and gates anywhere, and the same of pieces. The walker starts free.
static bool make_room(random_state *random, gjk_collider *c) {
  static gjk_pose at = GJK_POSE_IDENTITY;
  const bool has_stairs = random_below(random, 2) == 0;
  const gjk_parts ground = has_stairs ? make_stairs(random_range(random, ONE / 8, ONE / 2), 3) : make_bumps(random);
  const gjk_q16 from = has_stairs ? -6 * ONE : 2 * ONE, to = has_stairs ? 4 * ONE : 10 * ONE;
  start_scene(&ground);
  pieces = 0;
  if (has_stairs) {
    cut(&ground);
  }
  for (unsigned i = 0; i < GATES; i++) {
    gjk_parts body = GJK_PARTS_OF_COMPOUND(&gate);
    at.position = (gjk_vec3){random_range(random, from, to), random_range(random, from / 2, to / 2), 0};
    at.rotation = random_rotation(random);
    (void)scene_add_shape(&scene, 1, GJK_BODY_STATIC, &at);
    body.pose = at;
    cut(&body);
  }
  if (has_stairs) {
    const gjk_scene_config config = {.bodies = pieces, .parts = pieces, .pairs = 1};
    CHECK(gjk_scene_bytes(&config) <= sizeof apart_block);
    CHECK(gjk_scene_init(&apart, &config, apart_block, sizeof apart_block, piece_shapes, pieces, NULL) == GJK_OK);
    for (uint16_t i = 0; i < pieces; i++) {
      (void)scene_add_shape(&apart, i, GJK_BODY_STATIC, &piece_poses[i]);
    }
  }
  set_walker(c, random_below(random, 2) == 0 ? &man : &robot, random_range(random, from, to),
             random_range(random, from / 2, to / 2), random_range(random, ONE, 4 * ONE));
  tally.full += touches(c);
  return has_stairs;
}

static void check_walks(random_state *random) {
  gjk_collider c;
  gjk_slide_setup setup = usual();
  const bool has_twin = make_room(random, &c);
  setup.step = random_below(random, 2) == 0 ? 0 : ONE / 2;
  setup.snap = random_below(random, 2) == 0;
  for (int i = 0; i < WALKS && !touches(&c); i++) {
    const gjk_q16 size = random_below(random, 8) == 0 ? 4 * ONE : ONE / 3;
    const gjk_vec3 *at = &c.position,
                   to = {at->x + random_range(random, -size, size), at->y + random_range(random, -size, size),
                         at->z - (random_below(random, 4) == 0 ? random_range(random, -size, size) : ONE / 20)};
    gjk_slide_result r, of_pieces;
    const gjk_status status = gjk_slide(&scene, &c, &to, &setup, &r);
    CHECK(status == GJK_OK || (status == GJK_ERROR_ITERATION_LIMIT && CEILINGS_OPEN_CASTS));
    CHECK(!r.stuck || status != GJK_OK);
    CHECK(r.casts <= GJK_SLIDE_CASTS && r.count <= GJK_SLIDE_PLANES);
    tally.casts = r.casts > tally.casts ? r.casts : tally.casts;
    if (has_twin && gjk_slide(&apart, &c, &to, &setup, &of_pieces) == status) {
      const bool same = memcmp(&r.position, &of_pieces.position, sizeof r.position) == 0;
      tally.same += same;
      tally.other += !same;
    }
    CHECK(gjk_collider_move(&c, &r.position) == GJK_OK);
    CHECK_MSG(!touches(&c), "walk %d ends in something", i);
    tally.walks++;
    tally.slid += r.count > 0;
    tally.stood += r.on_ground;
    tally.climbed += r.stepped;
    if (c.position.z < -ONE || abs(c.position.x) > 12 * ONE) {  // over an edge of the ground
      break;
    }
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  if (!CEILINGS_OPEN_CASTS) {
    check_stairs(&robot, ONE / 3, ONE / 2, ONE / 4);
    check_stairs(&man, GJK_Q16(0.3), GJK_Q16(0.8), ONE / 2);
    check_gate(&robot, ONE / 3, ONE / 2);
    check_gate(&man, GJK_Q16(0.3), GJK_Q16(0.8));
    for (unsigned i = 0; i < 6; i++) {
      check_bumps(&random, i % 2 == 0 ? &man : &robot);
    }
  }
  for (unsigned i = 0; i < ROOMS; i++) {
    check_trial(i, NULL, NULL);
    check_walks(&random);
  }
  printf("%lu walks, %lu slid, %lu stood, %lu climbed, %lu rooms full; %lu as pieces, %lu not; at most %u casts\n",
         tally.walks, tally.slid, tally.stood, tally.climbed, tally.full, tally.same, tally.other, tally.casts);
  CHECK(tally.other == 0);
  CHECK((tally.slid > 60 && tally.stood > 60 && tally.climbed > 2 && tally.same > 200) || CEILINGS_OPEN_CASTS ||
        !check_is_full());
  return check_done("concave_slide");
}
