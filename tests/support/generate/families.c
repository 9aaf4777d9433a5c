// The families of random pairs.
#include <stdio.h>

#include "contact.h"
#include "generate.h"
#include "place.h"
#include "polytope.h"

static gjk_q16 random_gap(random_state *random) {
  return random_range(random, -3, 3);
}

static gjk_q16 at_most(gjk_q16 a, int64_t b) {
  return a < b ? a : (gjk_q16)b;
}

// Makes two polytopes of about one scale, the second up to 32 times smaller.
static void make(random_state *random, case_kind a, case_kind b, gjk_q16 reach, case_pair *pair) {
  const gjk_q16 other = reach >> random_below(random, 6);
  generate_polytope(random, a, reach, &pair->a);
  generate_polytope(random, b, other > 3 ? other : 3, &pair->b);
}

static void round_off(random_state *random, gjk_q16 reach, case_shape *shape) {
  shape->convex_radius = random_range(random, 0, at_most(reach, GJK_RADIUS_MAX - generate_bound(reach) - 8));
}

// Places the centres in the middle of the range in which the gap changes its sign.
static void anywhere(random_state *random, case_pair *pair) {
  generate_apart(random, 1.2 * generate_unit(random), pair);
}

static void touching(random_state *random, case_pair *pair) {
  generate_apart(random, 1.1, pair);
  generate_near(random, random_gap(random), pair);
}

static void boxes(random_state *random, case_pair *pair) {
  make(random, CASE_BOX, CASE_BOX, generate_reach(random), pair);
  anywhere(random, pair);
}

static void hulls(random_state *random, case_pair *pair) {
  make(random, CASE_HULL, CASE_HULL, generate_reach(random), pair);
  anywhere(random, pair);
}

static void kinds(random_state *random, case_pair *pair) {
  make(random, generate_kind(random), generate_kind(random), generate_reach(random), pair);
  anywhere(random, pair);
}

static void rounded(random_state *random, case_pair *pair) {
  const gjk_q16 reach = generate_reach(random);
  make(random, generate_kind(random), generate_kind(random), reach, pair);
  round_off(random, reach, &pair->a);
  round_off(random, reach, &pair->b);
  anywhere(random, pair);
}

// Shapes and offsets of a few LSB, so that most signs are zeros.
static void tiny(random_state *random, case_pair *pair) {
  const gjk_q16 reach = random_range(random, 3, 12);
  make(random, generate_kind(random), generate_kind(random), reach, pair);
  pair->a.convex_radius = random_range(random, 0, 2);
  pair->b.convex_radius = random_range(random, 0, 2);
  anywhere(random, pair);
}

// Shapes anywhere in the world, with gaps of up to 2^33 LSB.
static void far_apart(random_state *random, case_pair *pair) {
  gjk_vec3 *a = &pair->a.pose.position, *b = &pair->b.pose.position;
  const int32_t limit =
      (INT32_MAX - GENERATE_REACH_MAX) >> random_below(random, 5);  // a hull's centre is off its origin
  make(random, generate_kind(random), generate_kind(random), generate_reach(random), pair);
  generate_apart(random, 1, pair);
  const gjk_vec3 p = {random_range(random, -limit, limit), random_range(random, -limit, limit),
                      random_range(random, -limit, limit)};
  *a = p;
  b->x = random_range(random, -limit, limit);
  b->y = random_range(random, -limit, limit);
  b->z = random_range(random, -limit, limit);
}

static void nested(random_state *random, case_pair *pair) {
  const gjk_q16 reach = generate_reach(random) / 2 + 64;
  generate_polytope(random, CASE_BOX, reach, &pair->a);
  generate_polytope(random, generate_kind(random), reach / 16, &pair->b);
  generate_apart(random, generate_unit(random) / 20, pair);
}

static void near_boxes(random_state *random, case_pair *pair) {
  make(random, CASE_BOX, CASE_BOX, generate_reach(random), pair);
  touching(random, pair);
}

static void near_hulls(random_state *random, case_pair *pair) {
  make(random, CASE_HULL, CASE_HULL, generate_reach(random), pair);
  touching(random, pair);
}

static void near_rounded(random_state *random, case_pair *pair) {
  const gjk_q16 reach = generate_reach(random);
  make(random, generate_kind(random), generate_kind(random), reach, pair);
  round_off(random, reach, &pair->a);
  round_off(random, reach, &pair->b);
  touching(random, pair);
}

// Points, segments and triangles near boxes and hulls.
static void near_thin(random_state *random, case_pair *pair) {
  const case_kind thin = (case_kind)random_below(random, CASE_TRIANGLE + 1);
  make(random, random_below(random, 2) == 0 ? CASE_BOX : CASE_HULL, thin, generate_reach(random), pair);
  touching(random, pair);
}

static void near_outermost(random_state *random, case_pair *pair) {
  make(random, random_below(random, 2) == 0 ? CASE_BOX : CASE_HULL, CASE_HULL, generate_reach(random), pair);
  touching(random, pair);
  generate_outermost(random, pair);
}

static void slivers(random_state *random, case_pair *pair) {
  static const case_kind solid[2] = {CASE_BOX, CASE_HULL};
  const gjk_q16 reach = at_most(GENERATE_REACH_MAX, (int64_t)generate_reach(random) + 65536);
  generate_sliver(random, solid[random_below(random, 2)], reach, &pair->a);
  generate_sliver(random, solid[random_below(random, 2)], reach, &pair->b);
  touching(random, pair);
}

static void sliver_triangles(random_state *random, case_pair *pair) {
  const gjk_q16 reach = at_most(GENERATE_REACH_MAX, (int64_t)generate_reach(random) + 65536);
  generate_sliver(random, CASE_TRIANGLE, reach, &pair->a);
  generate_sliver(random, random_below(random, 2) == 0 ? CASE_TRIANGLE : CASE_BOX, reach, &pair->b);
  touching(random, pair);
}

const generate_family generate_families[] = {
    {.name = "boxes", .generate = boxes, .least = 30, .most = 75},
    {.name = "hulls", .generate = hulls, .least = 30, .most = 75},
    {.name = "kinds", .generate = kinds, .least = 10, .most = 60},
    {.name = "rounded", .generate = rounded, .least = 30, .most = 80},
    {.name = "tiny", .generate = tiny, .least = 20, .most = 80},
    {.name = "far-apart", .generate = far_apart, .most = 5},
    {.name = "nested", .generate = nested, .least = 95, .most = 100},
    {.name = "near-boxes", .generate = near_boxes, .least = 30, .most = 70, .near = 5},
    {.name = "near-hulls", .generate = near_hulls, .least = 30, .most = 70, .near = 5},
    {.name = "near-rounded", .generate = near_rounded, .least = 30, .most = 70, .near = 5},
    {.name = "near-thin", .generate = near_thin, .least = 20, .most = 70, .near = 5},
    {.name = "near-outermost", .generate = near_outermost, .least = 30, .most = 70, .near = 5},
    {.name = "slivers", .generate = slivers, .least = 20, .most = 70, .near = 5},
    {.name = "sliver-triangles", .generate = sliver_triangles, .most = 60, .near = 5},
    {.name = "stacked", .generate = generate_stacked, .least = 30, .most = 80},
    {.name = "stacked-hulls", .generate = generate_stacked_hulls, .least = 30, .most = 80},
    {.name = "shared-feature", .generate = generate_shared_feature, .least = 20, .most = 80},
    {.name = "lattice", .generate = generate_lattice, .least = 20, .most = 80},
    {.name = "flat", .generate = generate_flat, .least = 10, .most = 80},
    {.name = "tilted", .generate = generate_tilted, .least = 60, .most = 100},
    {.name = "level-radius", .generate = generate_level_radius, .least = 30, .most = 70, .near = 2},
    {.name = "smallest-face-vertex", .generate = generate_smallest_face_vertex, .least = 30, .most = 75, .near = 1},
    {.name = "smallest-face-face", .generate = generate_smallest_face_face, .least = 30, .most = 75, .near = 1},
    {.name = "smallest-edge-edge", .generate = generate_smallest_edge_edge, .least = 30, .most = 75, .near = 1},
    {.name = "smallest-rounded", .generate = generate_smallest_rounded, .least = 15, .most = 40, .near = 1},
};
const unsigned generate_family_count = sizeof generate_families / sizeof generate_families[0];

void generate_pair(const generate_family *family, uint64_t seed, case_pair *pair) {
  random_state random = random_seed(seed);
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  family->generate(&random, pair);
  snprintf(pair->id, sizeof pair->id, "%s-%llu", family->name, (unsigned long long)seed);
}

gjk_cache generate_cache(random_state *random) {
  gjk_cache cache;
  for (int i = 0; i < 4; i++) {
    cache.direction[i % 3] = (int16_t)random_u32(random);
    cache.a[i] = (uint16_t)(random_u32(random) >> random_below(random, 17));
    cache.b[i] = (uint16_t)(random_u32(random) >> random_below(random, 17));
  }
  cache.count = (uint16_t)random_below(random, 6);
  return cache;
}
