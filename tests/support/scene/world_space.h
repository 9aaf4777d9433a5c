// What a world has of space: shapes, rotations, queries. world.c includes it.
#ifndef WORLD_SPACE_H
#define WORLD_SPACE_H

#include <stdlib.h>

#include "world.h"

#define WORLD_TOLERANCE GJK_IMPACT_TOLERANCE_MIN

static const gjk_vec3 wedge[6] = {{-30000, -30000, -30000}, {30000, -30000, -30000}, {-30000, 30000, -30000},
                                  {30000, 30000, -30000},   {0, -30000, 30000},      {0, 30000, 30000}};
static const gjk_vec3 pebble[10] = {
    {40000, 0, 1000},    {-38000, 5000, 0},    {0, 41000, 3000},      {2000, -39000, 0},      {100, 200, 36000},
    {-300, 900, -37000}, {25000, 25000, 9000}, {-24000, 22000, 8000}, {21000, -26000, -7000}, {-22000, -23000, -9000}};
static const gjk_vec3 sail[3] = {{-50000, 0, 0}, {50000, 10000, 0}, {0, 60000, 20000}};

static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5)), speck = GJK_POINT, stick = GJK_SEGMENT(GJK_Q16(0.75));
static const gjk_shape capsule = GJK_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.5));
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape plank = GJK_BOX(GJK_Q16(1.0), GJK_Q16(0.25), GJK_Q16(0.125));
static const gjk_shape soap = GJK_ROUNDED_BOX(GJK_Q16(0.25), GJK_Q16(0.5), GJK_Q16(0.375), GJK_Q16(0.125));
static const gjk_shape roof = GJK_HULL(wedge, 6), stone = GJK_ROUNDED_HULL(pebble, 10, GJK_Q16(0.0625));
static const gjk_shape flag = GJK_TRIANGLE(sail), drum = GJK_CYLINDER(GJK_Q16(0.5), GJK_Q16(0.375));
static const gjk_shape egg = GJK_ELLIPSOID(GJK_Q16(0.5), GJK_Q16(0.375), GJK_Q16(0.625));

const gjk_shape *const world_shapes[WORLD_SHAPES] = {&crate, &ball,  &plank, &roof,  &capsule, &stone,
                                                     &soap,  &stick, &flag,  &speck, &drum,    &egg};

uint32_t world_cells(void) {
  const char *cells = getenv("GJK_TEST_CELLS");
  const unsigned long count = cells == NULL ? WORLD_CELLS : strtoul(cells, NULL, 10);
  return count < WORLD_CELLS ? (uint32_t)count : WORLD_CELLS;
}

static void world_set_cells(gjk_scene_config *config) {
  config->workspace_cells = world_cells();
}

gjk_scene_bindings world_bindings(const world_options *options) {
  static gjk_epa_cell cells[WORLD_CELLS + 100];  // more than are configured make no difference
  static const gjk_workspace workspace = {cells, WORLD_CELLS + 100};
  const gjk_scene_bindings bindings = {.predicate = options->predicate ? world_predicate : NULL,
                                       .details = &gjk_scene_contacts,
                                       .workspace = &workspace,
                                       .manifolds = world_manifolds,
                                       .motion = options->motions ? &gjk_scene_motion : NULL};
  return bindings;
}

static gjk_vec3 random_point(random_state *random, int32_t reach) {
  gjk_vec3 p;
  p.x = random_range(random, -reach, reach);
  p.y = random_range(random, -reach, reach);
  p.z = random_range(random, -reach, reach);
  return p;
}

static gjk_quat random_rotation(random_state *random, int32_t turn) {
  gjk_quat q = {0, 0, 0, GJK_Q30_ONE};
  if (random_below(random, 4) != 0) {
    const gjk_quat any = {random_range(random, -turn, turn), random_range(random, -turn, turn),
                          random_range(random, -turn, turn), 1000};
    gjk_quat_normalize(&any, &q);
  }
  return q;
}

static int32_t add_cut(int32_t a, int32_t b) {
  const int64_t sum = (int64_t)a + b;
  return sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (int32_t)sum;
}

static gjk_vec3 add_cut_all(gjk_vec3 p, gjk_vec3 step) {
  const gjk_vec3 sum = {add_cut(p.x, step.x), add_cut(p.y, step.y), add_cut(p.z, step.z)};
  return sum;
}

static bool spheres_apart(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin) {
  const int64_t x = (int64_t)a->centre.x - b->centre.x, y = (int64_t)a->centre.y - b->centre.y;
  const int64_t z = (int64_t)a->centre.z - b->centre.z, r = (int64_t)a->radius + b->radius + margin + 8;
  const bool far = x > r || x < -r || y > r || y < -r || z > r || z < -r;
  return far || x * x + y * y + z * z > r * r;
}

static bool is_curved(const gjk_collider *c) {
  return c->shape == &drum || c->shape == &egg;
}

// Are the boxes farther apart than the margin along an axis?
static bool boxes_apart(const gjk_collider *a, const gjk_collider *b, int64_t margin) {
  gjk_aabb x, y;
  gjk_collider_aabb(a, &x);
  gjk_collider_aabb(b, &y);
  return x.lower.x - margin > y.upper.x || y.lower.x - margin > x.upper.x || x.lower.y - margin > y.upper.y ||
         y.lower.y - margin > x.upper.y || x.lower.z - margin > y.upper.z || y.lower.z - margin > x.upper.z;
}

static gjk_status signed_distance(const gjk_collider *a, const gjk_collider *b, gjk_distance_result *out) {
  static gjk_epa_cell cells[WORLD_CELLS];
  const gjk_workspace workspace = {cells, world_cells()};
  return gjk_signed_distance(a, b, NULL, &workspace, out);
}

static void contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, gjk_manifold *out) {
  static gjk_epa_cell cells[WORLD_CELLS];
  const gjk_workspace workspace = {cells, world_cells()};
  gjk_contacts(a, b, margin, 4, NULL, &workspace, out);
}

#endif
