// Firmware: instructions of contacts, distances and rays with gentle hills as a mesh of 10,082 triangles, and as a height field.
#include "count.h"
#include "gjk/height_field.h"
#include "gjk/mesh.h"
#include "gjk/pose.h"
#include "gjk/surface.h"
#include "random.h"

#define SIDE 71  // cells along x and y, of one unit
#define BODIES 64
#define STEP GJK_Q16_ONE
#define HEIGHT_STEP 64

static gjk_vec3 vertices[(SIDE + 1) * (SIDE + 1)];
static gjk_mesh_triangle triangles[2 * SIDE * SIDE];
static gjk_mesh_node nodes[GJK_MESH_NODES(2 * SIDE * SIDE)];
static int16_t heights[(SIDE + 1) * (SIDE + 1)];
static gjk_mesh mesh;
static const gjk_height_field field = GJK_HEIGHT_FIELD(heights, SIDE + 1, SIDE + 1, STEP, STEP, HEIGHT_STEP);

// A wave without floating point: from 0 up to 255 and down again, smooth, of period 32.
static int32_t wave(unsigned i) {
  const int32_t x = (int32_t)(i % 32) - 16;
  return x < 0 ? 4 * -x * (16 + x) : -4 * x * (16 - x);
}

// False: it could not be built.
COUNTED bool make(void) {
  uint32_t count = 0;
  for (unsigned j = 0; j <= SIDE; j++) {
    for (unsigned i = 0; i <= SIDE; i++) {
      const unsigned at = j * (SIDE + 1) + i;
      heights[at] = (int16_t)(2 * (wave(i) + wave(j + 5)));
      vertices[at].x = (gjk_q16)i * STEP;
      vertices[at].y = (gjk_q16)j * STEP;
      vertices[at].z = heights[at] * HEIGHT_STEP;
    }
  }
  for (uint32_t j = 0; j < SIDE; j++) {
    for (uint32_t i = 0; i < SIDE; i++) {
      const uint32_t a = j * (SIDE + 1) + i, b = a + 1, c = a + SIDE + 2, d = a + SIDE + 1;
      const uint32_t corner[6] = {a, b, c, a, c, d};
      for (unsigned k = 0; k < 6; k++) {
        triangles[count + k / 3].corner[k % 3] = corner[k];
      }
      count += 2;
    }
  }
  return gjk_mesh_build(vertices, (SIDE + 1) * (SIDE + 1), triangles, count, false, nodes,
                        GJK_MESH_NODES(2 * SIDE * SIDE), &mesh) == GJK_OK;
}

// A box or a ball, about half a unit in half extent; rests on the ground at place i.
typedef enum mesh_bench_kind { MESH_BENCH_BOX, MESH_BENCH_FLUSH, MESH_BENCH_BALL, MESH_BENCH_KINDS } mesh_bench_kind;

COUNTED void place(mesh_bench_kind kind, unsigned i, gjk_collider *body) {
  static const gjk_shape box = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5)), ball = GJK_SPHERE(GJK_Q16(0.5));
  static const gjk_quat turned = {GJK_Q30(0.05), GJK_Q30(0.03), GJK_Q30(0.3), GJK_Q30(0.952)};
  random_state random = random_seed(1500 + i);
  gjk_pose pose = GJK_POSE_IDENTITY;
  if (kind != MESH_BENCH_FLUSH) {
    (void)gjk_quat_normalize(&turned, &pose.rotation);
  }
  pose.position.x = random_range(&random, 3 * STEP, (SIDE - 3) * STEP);
  pose.position.y = random_range(&random, 3 * STEP, (SIDE - 3) * STEP);
  const gjk_parts ground = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  gjk_distance_result result;
  (void)gjk_collider_init(body, kind == MESH_BENCH_BALL ? &ball : &box, NULL, 0);
  pose.position.z = 4 * STEP;
  for (int step = 0; step < 3; step++) {  // down onto the ground
    (void)gjk_collider_pose(body, &pose);
    if (gjk_parts_distance(&ground, body, NULL, &result) == GJK_OK && !result.intersecting) {
      pose.position.z -= result.distance;
    }
  }
  pose.position.z -= 200;
  (void)gjk_collider_pose(body, &pose);
}

// The manifolds of the body with the mesh, or with the height field.
COUNTED unsigned contacts(const gjk_collider *body, bool of_field) {
  static gjk_surface_contact found[32];
  static gjk_epa_cell cells[200];
  const gjk_workspace workspace = {cells, 200};
  uint16_t count = 0;
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&mesh), of_heights = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  (void)gjk_surface_contacts(of_field ? &of_heights : &of_mesh, body, GJK_Q16(0.01), 4, &workspace, found, 32, &count);
  return count;
}

COUNTED gjk_q16 distance(const gjk_collider *body, bool of_field) {
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&mesh), of_heights = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  gjk_distance_result result;
  return gjk_parts_distance(of_field ? &of_heights : &of_mesh, body, NULL, &result) == GJK_OK ? result.distance : -1;
}

// A ray from the body's place up to 16 units along the ground, which falls by 4. Does it hit?
COUNTED bool ray(const gjk_collider *body, bool of_field) {
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&mesh), of_heights = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  const gjk_vec3 *from = &body->position;
  const gjk_vec3 to = {from->x < SIDE / 2 * STEP ? from->x + 15 * STEP : from->x - 15 * STEP, from->y + 5 * STEP,
                       from->z - 4 * STEP};
  gjk_cast_result result;
  uint32_t part;
  return gjk_parts_cast_ray(of_field ? &of_heights : &of_mesh, from, &to, &part, &result) == GJK_OK && result.hit;
}

static void print_line(const char *name, bool of_field, uint32_t total, uint32_t most, unsigned manifolds,
                       uint32_t above, uint32_t along, unsigned hits) {
  board_print(name);
  board_print(of_field ? " on a height field: " : " on a mesh: ");
  print_decimal(board_print, total / BODIES);
  board_print(" instructions for contacts, at most ");
  print_decimal(board_print, most);
  board_print(", ");
  print_decimal(board_print, manifolds * 10 / BODIES);
  board_print(" tenths of a manifold; 1 unit above, distance ");
  print_decimal(board_print, above / BODIES);
  board_print(", ray ");
  print_decimal(board_print, along / BODIES);
  board_print(", which hit ");
  print_decimal(board_print, hits);
  board_print("\n");
}

int firmware_main(void) {
  static const char *const name[MESH_BENCH_KINDS] = {"turned box", "level box", "ball"};
  if (!count_prepare() || !make()) {
    return 1;
  }
  for (int surface = 0; surface < 2; surface++) {
    for (int kind = 0; kind < MESH_BENCH_KINDS; kind++) {
      count_tally t = {0, 0, 0};
      uint32_t above = 0, along = 0;
      unsigned manifolds = 0, hits = 0;
      for (unsigned i = 0; i < BODIES; i++) {
        gjk_collider body;
        place((mesh_bench_kind)kind, i, &body);
        uint32_t start = board_ticks();
        manifolds += contacts(&body, surface != 0);
        count_add(&t, count_since(start));
        gjk_vec3 up = {body.position.x, body.position.y, body.position.z + GJK_Q16_ONE};
        (void)gjk_collider_move(&body, &up);
        start = board_ticks();
        (void)distance(&body, surface != 0);
        above += count_since(start);
        start = board_ticks();
        hits += ray(&body, surface != 0);
        along += count_since(start);
      }
      print_line(name[kind], surface != 0, t.sum, t.worst, manifolds, above, along, hits);
    }
  }
  return 0;
}
