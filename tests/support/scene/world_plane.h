// What a world has of the plane: shapes, rotations, queries.
#ifndef WORLD_PLANE_H
#define WORLD_PLANE_H

#include "plane_names.h"
#include "world.h"

#define WORLD_TOLERANCE GJK2_IMPACT_TOLERANCE_MIN

// Tells world.c that it is the plane's.
#define WORLD_OF_PLANE

static const gjk2_vec wedge[5] = {{-30000, -30000}, {30000, -30000}, {36000, 9000}, {0, 30000}, {-33000, 4000}};
static const gjk2_vec pebble[10] = {{40000, 1000},  {-38000, 5000}, {3000, 41000},   {2000, -39000},  {100, 200},
                                    {-300, -37000}, {25000, 25000}, {-24000, 22000}, {21000, -26000}, {-22000, -23000}};
static const gjk2_vec sail[3] = {{-50000, 0}, {50000, 10000}, {0, 60000}};

static const gjk2_shape ball = GJK2_CIRCLE(GJK_Q16(0.5)), speck = GJK2_POINT, stick = GJK2_SEGMENT(GJK_Q16(0.75));
static const gjk2_shape capsule = GJK2_CAPSULE(GJK_Q16(0.25), GJK_Q16(0.5));
static const gjk2_shape crate = GJK2_BOX(GJK_Q16(0.5), GJK_Q16(0.5)), plank = GJK2_BOX(GJK_Q16(1.0), GJK_Q16(0.125));
static const gjk2_shape soap = GJK2_ROUNDED_BOX(GJK_Q16(0.25), GJK_Q16(0.5), GJK_Q16(0.125));
static const gjk2_shape roof = GJK2_POLYGON(wedge, 5), stone = GJK2_ROUNDED_POLYGON(pebble, 10, GJK_Q16(0.0625));
static const gjk2_shape flag = GJK2_TRIANGLE(sail), egg = GJK2_ELLIPSE(GJK_Q16(0.5), GJK_Q16(0.375));
static const gjk2_shape pill = GJK2_ROUNDED_ELLIPSE(GJK_Q16(0.25), GJK_Q16(0.5), GJK_Q16(0.125));

const gjk2_shape *const world_shapes[WORLD_SHAPES] = {&crate, &ball,  &plank, &roof,  &capsule, &stone,
                                                      &soap,  &stick, &flag,  &speck, &pill,    &egg};

uint32_t world_cells(void) {
  return WORLD_CELLS;
}

static void world_set_cells(gjk2_scene_config *config) {
  (void)config;
}

gjk2_scene_bindings world_bindings(const world_options *options) {
  const gjk2_scene_bindings bindings = {.predicate = options->predicate ? world_predicate : NULL,
                                        .details = &gjk2_scene_contacts,
                                        .manifolds = world_manifolds,
                                        .motion = options->motions ? &gjk2_scene_motion : NULL};
  return bindings;
}

static gjk2_vec random_point(random_state *random, int32_t reach) {
  gjk2_vec p;
  p.x = random_range(random, -reach, reach);
  p.y = random_range(random, -reach, reach);
  return p;
}

static gjk2_rotation random_rotation(random_state *random, int32_t turn) {
  gjk2_rotation r = {GJK_Q30_ONE, 0};
  if (random_below(random, 4) != 0) {
    const gjk2_rotation any = {1000, random_range(random, -turn, turn)};
    gjk2_rotation_normalize(&any, &r);
  }
  return r;
}

static int32_t add_cut(int32_t a, int32_t b) {
  const int64_t sum = (int64_t)a + b;
  return sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (int32_t)sum;
}

static gjk2_vec add_cut_all(gjk2_vec p, gjk2_vec step) {
  const gjk2_vec sum = {add_cut(p.x, step.x), add_cut(p.y, step.y)};
  return sum;
}

static bool spheres_apart(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin) {
  const int64_t x = (int64_t)a->centre.x - b->centre.x, y = (int64_t)a->centre.y - b->centre.y;
  const int64_t r = (int64_t)a->radius + b->radius + margin + 8;
  const bool far = x > r || x < -r || y > r || y < -r;
  return far || x * x + y * y > r * r;
}

static bool is_curved(const gjk2_collider *c) {
  return c->shape == &pill || c->shape == &egg;
}

// Are the boxes farther apart than the margin along an axis?
static bool boxes_apart(const gjk2_collider *a, const gjk2_collider *b, int64_t margin) {
  gjk2_aabb x, y;
  gjk2_collider_aabb(a, &x);
  gjk2_collider_aabb(b, &y);
  return x.lower.x - margin > y.upper.x || y.lower.x - margin > x.upper.x || x.lower.y - margin > y.upper.y ||
         y.lower.y - margin > x.upper.y;
}

static gjk_status signed_distance(const gjk2_collider *a, const gjk2_collider *b, gjk2_distance_result *out) {
  return gjk2_signed_distance(a, b, NULL, out);
}

static void contacts(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 margin, gjk2_manifold *out) {
  gjk2_contacts(a, b, margin, 2, NULL, out);
}

#endif
