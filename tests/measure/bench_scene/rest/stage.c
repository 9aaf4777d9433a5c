// Scenes of space: boxes that fall and rest, on a floor or a mesh.
#define SOLVER_BODIES_MAX 1100
#define SOLVER_PAIRS_MAX 9000

#include <stdlib.h>
#include <string.h>

#include "gjk/concave.h"
#include "random.h"
#include "rest.h"
#include "solver/solver.c"

#define ONE GJK_Q16_ONE
#define FLOOR 0
#define SIDE 1  // of the tray, along y
#define FRONT 2
#define CRATE 3

static const gjk_vec3 halves[REST_SHAPES] = {{100 * ONE, 100 * ONE, ONE},
                                             {ONE / 2, 8 * ONE, 8 * ONE},
                                             {8 * ONE, ONE / 2, 8 * ONE},
                                             {ONE / 2, ONE / 2, ONE / 2},
                                             {ONE / 2, ONE / 4, ONE / 4}};
static gjk_shape boxes[REST_SHAPES];

// The mesh: hills of 100 by 100 squares of a unit, two triangles each.
#define ACROSS 100
static gjk_vec3 vertices[(ACROSS + 1) * (ACROSS + 1)];
static gjk_mesh_triangle triangles[2 * ACROSS * ACROSS];
static gjk_mesh_node nodes[GJK_MESH_NODES(2 * ACROSS * ACROSS)];
static gjk_mesh mesh;
static gjk_concave concave;
static gjk_shape hills;
static gjk_parts ground;

// So high, in 1/8 units: waves of parabolas, 16 units long.
static int32_t height(int32_t x) {
  const int32_t at = x & 15, half = at & 7;
  return (at < 8 ? 1 : -1) * half * (8 - half) / 2;
}

static bool build_hills(rest_stage *s) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < (ACROSS + 1) * (ACROSS + 1); i++) {
    const int32_t x = (int32_t)(i % (ACROSS + 1)) - ACROSS / 2, y = (int32_t)(i / (ACROSS + 1)) - ACROSS / 2;
    const gjk_vec3 at = {x * ONE, y * ONE, (height(x + 160) + height(y + 165)) * (ONE / 8)};
    vertices[i] = at;
  }
  for (uint32_t i = 0; i < ACROSS * ACROSS; i++) {
    const uint32_t a = i / ACROSS * (ACROSS + 1) + i % ACROSS, b = a + ACROSS + 1;
    const gjk_mesh_triangle low = {{a, a + 1, b + 1}}, high = {{a, b + 1, b}};
    triangles[count++] = low;
    triangles[count++] = high;
  }
  const gjk_parts all = GJK_PARTS_OF_MESH(&mesh);
  ground = all;
  s->mesh = &mesh;
  s->shape[FLOOR] = &hills;
  return gjk_mesh_build(vertices, sizeof vertices / sizeof vertices[0], triangles, count, false, nodes,
                        sizeof nodes / sizeof nodes[0], &mesh) == GJK_OK &&
         gjk_concave_init(&ground, &concave, &hills) == GJK_OK;
}

static gjk_pose *add(rest_stage *s, uint8_t shape, bool fixed) {
  const gjk_pose none = GJK_POSE_IDENTITY;
  gjk_pose *pose = (gjk_pose *)s->poses + s->bodies;
  s->body[s->bodies].shape = shape;
  s->body[s->bodies].fixed = fixed;
  s->bodies++;
  *pose = none;
  return pose;
}

static void add_at(rest_stage *s, uint8_t shape, bool fixed, int32_t x, int32_t y, int32_t z) {
  gjk_pose *pose = add(s, shape, fixed);
  pose->position.x = x;
  pose->position.y = y;
  pose->position.z = z;
}

static void add_pyramid(rest_stage *s, int32_t base) {
  for (int32_t row = 0; row < base; row++) {
    for (int32_t i = 0; i < base - row; i++) {
      add_at(s, CRATE, false, (2 * i + row - base) * (ONE * 21 / 40), 0, ONE / 2 + row * ONE);
    }
  }
}

static void add_wall(rest_stage *s) {
  for (int32_t row = 0; row < 20; row++) {
    for (int32_t i = 0; i < 20; i++) {
      add_at(s, CRATE + 1, false, (2 * i + row % 2 - 20) * (ONE * 41 / 80), 0, ONE / 4 + row * (ONE / 2));
    }
  }
}

// Crates in layers of a square, so far apart, turned anyhow.
static void add_rain(rest_stage *s, int32_t side, int32_t layers, int32_t apart, int32_t lowest) {
  random_state random = random_seed(11);
  for (int32_t i = 0; i < side * side * layers; i++) {
    const int32_t x = i % side, y = i / side % side, z = i / side / side;
    add_at(s, CRATE, false, (2 * x + 1 - side) * (apart / 2), (2 * y + 1 - side) * (apart / 2), lowest + z * apart);
    gjk_pose *pose = (gjk_pose *)s->poses + s->bodies - 1;
    const gjk_quat any = {random_range(&random, -999, 999), random_range(&random, -999, 999),
                          random_range(&random, -999, 999), 1000};
    (void)gjk_quat_normalize(&any, &pose->rotation);
  }
}

static void add_tray(rest_stage *s) {
  for (int sign = -1; sign <= 1; sign += 2) {
    add_at(s, SIDE, true, sign * 17 * ONE / 2, 0, 8 * ONE);
    add_at(s, FRONT, true, 0, sign * 17 * ONE / 2, 8 * ONE);
  }
}

bool rest_build(unsigned number, rest_stage *s) {
  static const struct {
    const char *name;
    unsigned before, iterations;
  } stages[] = {{"pyramid of base 20", 200, 60},    {"pyramid of base 40", 200, 60}, {"heap of 1000, falling", 45, 10},
                {"heap of 1000, at rest", 400, 10}, {"wall of 400", 200, 60},        {"200 on a mesh", 150, 20}};
  memset(s, 0, sizeof *s);
  if (number >= sizeof stages / sizeof stages[0]) {
    return false;
  }
  s->name = stages[number].name;
  s->before = stages[number].before;
  s->iterations = stages[number].iterations;
  s->poses = calloc((size_t)REST_BODIES * (REST_TICKS + 1), sizeof(gjk_pose));
  bool fine = s->poses != NULL;
  for (unsigned i = 0; i < 5; i++) {
    const gjk_shape box = {.type = &gjk_class_box, .size = halves[i]};
    boxes[i] = box;
    s->shape[i] = &boxes[i];
    s->half[i][0] = (float)halves[i].x / 65536;
    s->half[i][1] = (float)halves[i].y / 65536;
    s->half[i][2] = (float)halves[i].z / 65536;
  }
  add_at(s, FLOOR, true, 0, 0, number == 5 ? 0 : -ONE);
  switch (number) {
    case 0: add_pyramid(s, 20); break;
    case 1: add_pyramid(s, 40); break;
    case 2:
    case 3:
      add_tray(s);
      add_rain(s, 10, 10, ONE * 31 / 20, ONE);
      break;
    case 4: add_wall(s); break;
    default: fine = fine && build_hills(s); add_rain(s, 10, 2, ONE * 9 / 4, 3 * ONE);
  }
  return fine;
}

void rest_free(rest_stage *stage) {
  free(stage->poses);
}

// The ground is body 0, so it is a.
static unsigned find_on_ground(void *user, unsigned a, unsigned b, gjk_manifold *out, unsigned capacity) {
  solver_world *w = user;
  unsigned count = 0;
  if (a != 0) {
    return gjk_contacts(&w->body[a].collider, &w->body[b].collider, MARGIN, SOLVER_POINTS_MAX, NULL, &workspace, out) ==
               GJK_OK &&
           out->count > 0;
  }
  return gjk_parts_manifolds(&ground, &w->body[b].collider, MARGIN, SOLVER_POINTS_MAX, &workspace, out, capacity,
                             &count) == GJK_OK
             ? count
             : 0;
}

bool rest_record(rest_stage *s) {
  gjk_pose *poses = s->poses;
  solver_world *w = calloc(1, sizeof *w);
  solver_init(w, s->iterations);
  w->damping = 5;
  if (s->mesh != NULL) {
    w->manifolds = find_on_ground;
    w->user = w;
  }
  for (unsigned i = 0; i < s->bodies; i++) {
    const uint8_t shape = s->body[i].shape;
    solver_add(w, &boxes[shape], halves[shape], &poses[i], s->body[i].fixed);
  }
  if (s->mesh != NULL) {  // its box holds the hills
    w->body[0].box.lower.z = -9 * ONE;
    w->body[0].box.upper.z = 9 * ONE;
  }
  for (unsigned tick = 0; tick < s->before; tick++) {
    solver_step(w);
  }
  for (unsigned frame = 0; frame <= REST_TICKS; frame++) {
    for (unsigned i = 0; i < s->bodies; i++) {
      poses[frame * s->bodies + i] = w->body[i].pose;
    }
    solver_step(w);
  }
  const bool fits = w->pairs[w->now] < SOLVER_PAIRS_MAX;
  free(w);
  return fits;
}
