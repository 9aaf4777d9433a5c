// The families of random pairs in the plane.
#include <stdio.h>

#include "shape2.h"
#include "smallest2.h"

static gjk_q16 at_most(int64_t a, int64_t b) {
  return (gjk_q16)(a < b ? a : b);
}

// Makes two shapes of about one scale, the second up to 32 times smaller.
static void make(random_state *random, case2_kind a, case2_kind b, gjk_q16 reach, case2_pair *pair) {
  const gjk_q16 other = reach >> random_below(random, 6);
  generate2_shape(random, a, reach, &pair->a);
  generate2_shape(random, b, other > 3 ? other : 3, &pair->b);
}

static void round_off(random_state *random, gjk_q16 reach, case2_shape *shape) {
  shape->convex_radius = random_range(random, 0, at_most(reach, GJK2_RADIUS_MAX / 8));
}

// Places the shapes in the middle of the range in which the gap changes its sign.
static void anywhere(random_state *random, case2_pair *pair) {
  generate2_apart(random, 1.15 * generate2_unit(random), pair);
}

static void touching(random_state *random, case2_pair *pair) {
  generate2_near(random, random_range(random, -3, 3), pair);
}

static void boxes(random_state *random, case2_pair *pair) {
  make(random, CASE2_BOX, CASE2_BOX, generate2_reach(random), pair);
  anywhere(random, pair);
}

static void polygons(random_state *random, case2_pair *pair) {
  make(random, CASE2_POLYGON, CASE2_POLYGON, generate2_reach(random), pair);
  anywhere(random, pair);
}

static void kinds(random_state *random, case2_pair *pair) {
  make(random, generate2_kind(random), generate2_kind(random), generate2_reach(random), pair);
  anywhere(random, pair);
}

static void make_rounded(random_state *random, case2_pair *pair) {
  const gjk_q16 reach = generate2_reach(random);
  make(random, generate2_kind(random), generate2_kind(random), reach, pair);
  round_off(random, reach, &pair->a);
  round_off(random, reach, &pair->b);
}

static void rounded(random_state *random, case2_pair *pair) {
  make_rounded(random, pair);
  anywhere(random, pair);
}

// Shapes and offsets of a few LSB, so that most signs are zeros.
static void tiny(random_state *random, case2_pair *pair) {
  const gjk_q16 reach = random_range(random, 3, 12);
  make(random, generate2_kind(random), generate2_kind(random), reach, pair);
  pair->a.convex_radius = random_range(random, 0, 2);
  pair->b.convex_radius = random_range(random, 0, 2);
  anywhere(random, pair);
}

// Shapes anywhere in the world, with gaps of up to 2^32.5 LSB.
static void far_apart(random_state *random, case2_pair *pair) {
  const int32_t limit = (INT32_MAX - GJK2_RADIUS_MAX) >> random_below(random, 5);
  make(random, generate2_kind(random), generate2_kind(random), generate2_reach(random), pair);
  generate2_apart(random, 1, pair);
  pair->a.pose.position.x = random_range(random, -limit, limit);
  pair->a.pose.position.y = random_range(random, -limit, limit);
  pair->b.pose.position.x = random_range(random, -limit, limit);
  pair->b.pose.position.y = random_range(random, -limit, limit);
}

static void nested(random_state *random, case2_pair *pair) {
  const gjk_q16 reach = generate2_reach(random) / 2 + 64;
  generate2_shape(random, CASE2_BOX, reach, &pair->a);
  generate2_shape(random, generate2_kind(random), reach / 20 + 1, &pair->b);
  generate2_apart(random, generate2_unit(random) / 30, pair);
}

static void near_boxes(random_state *random, case2_pair *pair) {
  make(random, CASE2_BOX, CASE2_BOX, generate2_reach(random), pair);
  touching(random, pair);
}

static void near_polygons(random_state *random, case2_pair *pair) {
  make(random, CASE2_POLYGON, CASE2_POLYGON, generate2_reach(random), pair);
  touching(random, pair);
}

static void near_rounded(random_state *random, case2_pair *pair) {
  make_rounded(random, pair);
  touching(random, pair);
}

// Points and segments near boxes and polygons.
static void near_thin(random_state *random, case2_pair *pair) {
  const case2_kind thin = (case2_kind)random_below(random, CASE2_SEGMENT + 1);
  make(random, random_below(random, 2) == 0 ? CASE2_BOX : CASE2_POLYGON, thin, generate2_reach(random), pair);
  touching(random, pair);
}

static void near_outermost(random_state *random, case2_pair *pair) {
  make(random, random_below(random, 2) == 0 ? CASE2_BOX : CASE2_POLYGON, CASE2_POLYGON, generate2_reach(random), pair);
  touching(random, pair);
  generate2_outermost(random, pair);
}

static void slivers(random_state *random, case2_pair *pair) {
  static const case2_kind solid[3] = {CASE2_BOX, CASE2_POLYGON, CASE2_TRIANGLE};
  const gjk_q16 reach = at_most(GENERATE2_REACH_MAX, (int64_t)generate2_reach(random) + 65536);
  generate2_sliver(random, solid[random_below(random, 3)], reach, &pair->a);
  generate2_sliver(random, solid[random_below(random, 3)], reach, &pair->b);
  touching(random, pair);
}

// Unturned boxes whose sides lie on each other, or miss by an LSB or two.
static void edge_to_edge(random_state *random, case2_pair *pair) {
  const bool beside = random_below(random, 2) == 0;
  make(random, CASE2_BOX, CASE2_BOX, generate2_reach(random), pair);
  const gjk2_vec a = pair->a.size, b = pair->b.size;
  const gjk_q16 gap = random_range(random, -2, 2);
  const gjk_q16 slide = beside ? random_range(random, -a.y - b.y - 2, a.y + b.y + 2) : random_range(random, -a.x, a.x);
  pair->a.pose.position = generate2_vector(random, (double)generate2_reach(random));
  pair->b.pose.position = pair->a.pose.position;
  pair->b.pose.position.x += beside ? a.x + b.x + gap : slide;
  pair->b.pose.position.y += beside ? slide : a.y + b.y + gap;
}

// Polygons that share an edge or a corner, exactly or almost.
static void shared_feature(random_state *random, case2_pair *pair) {
  const gjk_q16 reach = generate2_reach(random);
  generate2_shape(random, CASE2_POLYGON, reach, &pair->a);
  generate2_shape(random, CASE2_POLYGON, reach, &pair->b);
  generate2_order(&pair->a);
  generate2_order(&pair->b);
  case2_shape *a = &pair->a, *b = &pair->b;
  const gjk2_vec p = a->vertices[0], q = a->vertices[a->count > 1 ? 1 : 0], r = b->vertices[0];
  if (random_below(random, 2) == 0) {  // B is A, turned half around the middle of an edge
    case2_shape_set_count(b, a->count);
    for (size_t i = 0; i < a->count; i++) {
      b->vertices[i].x = p.x + q.x - a->vertices[i].x;
      b->vertices[i].y = p.y + q.y - a->vertices[i].y;
    }
    b->pose.position.x = random_range(random, -1, 1);
    b->pose.position.y = random_range(random, -1, 1);
  } else {
    b->pose.position.x = p.x - r.x + random_range(random, -1, 1);
    b->pose.position.y = p.y - r.y + random_range(random, -1, 1);
  }
}

static void lattice(random_state *random, case2_pair *pair) {
  const gjk_q16 step = 1 << random_below(random, 20);
  for (int side = 0; side < 2; side++) {
    case2_shape *shape = side == 0 ? &pair->a : &pair->b;
    shape->kind = CASE2_POLYGON;
    case2_shape_set_count(shape, 1 + random_below(random, 7));
    for (size_t i = 0; i < shape->count; i++) {
      shape->vertices[i].x = random_range(random, -6, 6) * step;
      shape->vertices[i].y = random_range(random, -6, 6) * step;
    }
    shape->pose.position.x = random_range(random, -6, 6) * step;
    shape->pose.position.y = random_range(random, -6, 6) * step;
  }
}

// Segments, points and polygons in a line.
static void flat(random_state *random, case2_pair *pair) {
  const gjk_q16 reach = generate2_reach(random);
  const gjk2_vec along = generate2_vector(random, reach / 16.0 + 1);
  const size_t most = random_below(random, 8) == 0 ? 1 : 4;  // one in eight pairs: two points
  for (int side = 0; side < 2; side++) {
    case2_shape *shape = side == 0 ? &pair->a : &pair->b;
    shape->kind = CASE2_POLYGON;
    case2_shape_set_count(shape, 1 + random_below(random, (uint32_t)most));
    for (size_t i = 0; i < shape->count; i++) {
      const int32_t k = random_range(random, -5, 5);
      shape->vertices[i].x = k * along.x;
      shape->vertices[i].y = k * along.y;
    }
    const int32_t k = random_range(random, -7, 7);
    shape->pose.position.x = k * along.x + (random_below(random, 4) == 0 ? random_range(random, -1, 1) : 0);
    shape->pose.position.y = k * along.y;
  }
}

// Many vertices.
static void big(random_state *random, case2_pair *pair) {
  const gjk_q16 reach = at_most(GENERATE2_REACH_MAX, (int64_t)generate2_reach(random) + 1000);
  for (int side = 0; side < 2; side++) {
    case2_shape *shape = side == 0 ? &pair->a : &pair->b;
    shape->kind = CASE2_POLYGON;
    case2_shape_set_count(shape, 16 + random_below(random, 200));
    for (size_t i = 0; i < shape->count; i++) {
      shape->vertices[i] = generate2_vector(random, reach * (1 - 1e-3 * generate2_unit(random)));
    }
    if (random_below(random, 2) == 0) {
      generate2_order(shape);
    }
  }
  if (random_below(random, 2) == 0) {
    touching(random, pair);
  } else {
    generate2_apart(random, 0.7 + 0.6 * generate2_unit(random), pair);
  }
}

const generate2_family generate2_families[] = {
    {.name = "boxes", .generate = boxes, .least = 30, .most = 75},
    {.name = "polygons", .generate = polygons, .least = 30, .most = 75},
    {.name = "kinds", .generate = kinds, .least = 10, .most = 60},
    {.name = "rounded", .generate = rounded, .least = 30, .most = 80},
    {.name = "tiny", .generate = tiny, .least = 20, .most = 80},
    {.name = "far-apart", .generate = far_apart, .most = 5},
    {.name = "nested", .generate = nested, .least = 95, .most = 100},
    {.name = "near-boxes", .generate = near_boxes, .least = 30, .most = 70, .near = 5},
    {.name = "near-polygons", .generate = near_polygons, .least = 30, .most = 70, .near = 5},
    {.name = "near-rounded", .generate = near_rounded, .least = 30, .most = 70, .near = 5},
    {.name = "near-thin", .generate = near_thin, .least = 20, .most = 70, .near = 5},
    {.name = "near-outermost", .generate = near_outermost, .least = 30, .most = 70, .near = 5},
    {.name = "slivers", .generate = slivers, .least = 20, .most = 70, .near = 5},
    {.name = "edge-to-edge", .generate = edge_to_edge, .least = 30, .most = 80},
    {.name = "shared-feature", .generate = shared_feature, .least = 20, .most = 80},
    {.name = "lattice", .generate = lattice, .least = 20, .most = 80},
    {.name = "flat", .generate = flat, .least = 10, .most = 80},
    {.name = "big", .generate = big, .least = 30, .most = 80},
    {.name = "smallest", .generate = generate2_smallest, .least = 30, .most = 75, .near = 1},
    {.name = "smallest-edges", .generate = generate2_smallest_edges, .least = 30, .most = 75, .near = 1},
    {.name = "smallest-rounded", .generate = generate2_smallest_rounded, .least = 30, .most = 70, .near = 1},
};
const unsigned generate2_family_count = sizeof generate2_families / sizeof generate2_families[0];

void generate2_pair(const generate2_family *family, uint64_t seed, case2_pair *pair) {
  random_state random = random_seed(seed);
  case2_shape_reset(&pair->a);
  case2_shape_reset(&pair->b);
  family->generate(&random, pair);
  snprintf(pair->id, sizeof pair->id, "%s-%llu", family->name, (unsigned long long)seed);
}
