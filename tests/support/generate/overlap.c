// Families of pairs that overlap.
#include "overlap.h"

#include <math.h>
#include <string.h>

#include "contact.h"
#include "place.h"
#include "polytope.h"

static gjk_q16 at_least(gjk_q16 a, gjk_q16 b) {
  return a > b ? a : b;
}

// Makes two polytopes of about one scale, the second up to 8 times smaller. Returns the smaller one's reach.
static gjk_q16 make(random_state *random, case_kind a, case_kind b, case_pair *pair) {
  const gjk_q16 reach = generate_reach(random), other = at_least(reach >> random_below(random, 4), 3);
  generate_polytope(random, a, reach, &pair->a);
  generate_polytope(random, b, other, &pair->b);
  return other;
}

static case_kind solid(random_state *random) {
  return random_below(random, 2) == 0 ? CASE_BOX : CASE_HULL;
}

static void round_off(random_state *random, gjk_q16 most, case_shape *shape) {
  const gjk_q16 room = GJK_RADIUS_MAX - GENERATE_REACH_MAX - 8;
  shape->convex_radius = random_range(random, 0, most < room ? most : room);
}

// A depth from 1 LSB to most; every order of magnitude is equally likely.
static gjk_q16 any_depth(random_state *random, gjk_q16 most) {
  return (gjk_q16)exp(generate_unit(random) * log((double)at_least(most, 2)));
}

static void sink(random_state *random, gjk_q16 most, case_pair *pair) {
  generate_apart(random, 1.1, pair);
  generate_near(random, -any_depth(random, most), pair);
}

static void shallow_boxes(random_state *random, case_pair *pair) {
  sink(random, make(random, CASE_BOX, CASE_BOX, pair) / 4, pair);
}

static void shallow_hulls(random_state *random, case_pair *pair) {
  sink(random, make(random, CASE_HULL, CASE_HULL, pair) / 4, pair);
}

// Points, segments and triangles inside boxes and hulls.
static void shallow_thin(random_state *random, case_pair *pair) {
  const case_kind thin = (case_kind)random_below(random, CASE_TRIANGLE + 1);
  sink(random, make(random, solid(random), thin, pair) / 4, pair);
}

// Only the parts within the convex radii overlap, or the cores as well.
static void shallow_rounded(random_state *random, case_pair *pair) {
  const gjk_q16 reach = make(random, generate_kind(random), generate_kind(random), pair);
  round_off(random, reach, &pair->a);
  round_off(random, reach, &pair->b);
  sink(random, reach / 2, pair);
}

// Shapes and offsets of a few LSB.
static void deep_tiny(random_state *random, case_pair *pair) {
  generate_polytope(random, solid(random), random_range(random, 3, 12), &pair->a);
  generate_polytope(random, generate_kind(random), random_range(random, 3, 12), &pair->b);
  pair->a.convex_radius = random_range(random, 0, 2);
  pair->b.convex_radius = random_range(random, 0, 2);
  generate_apart(random, 0.4 * generate_unit(random), pair);
}

static void deep(random_state *random, case_pair *pair) {
  generate_apart(random, 0.3 * generate_unit(random), pair);
}

static void deep_boxes(random_state *random, case_pair *pair) {
  make(random, CASE_BOX, CASE_BOX, pair);
  deep(random, pair);
}

static void deep_hulls(random_state *random, case_pair *pair) {
  make(random, CASE_HULL, CASE_HULL, pair);
  deep(random, pair);
}

static void deep_mixed(random_state *random, case_pair *pair) {
  make(random, CASE_BOX, CASE_HULL, pair);
  deep(random, pair);
}

static void deep_rounded(random_state *random, case_pair *pair) {
  const gjk_q16 reach = make(random, solid(random), generate_kind(random), pair);
  round_off(random, reach, &pair->a);
  round_off(random, reach, &pair->b);
  deep(random, pair);
}

// The centres of the bounding boxes coincide, or almost. For symmetric shapes each direction then ties with its
// opposite.
static void concentric(random_state *random, case_pair *pair) {
  make(random, solid(random), generate_kind(random), pair);
  generate_apart(random, 0, pair);
  pair->b.pose.position.x += random_range(random, -1, 1);
}

static void nested(random_state *random, case_pair *pair) {
  const gjk_q16 reach = generate_reach(random) / 2 + 64;
  generate_polytope(random, solid(random), reach, &pair->a);
  generate_polytope(random, generate_kind(random), reach / 16, &pair->b);
  generate_apart(random, generate_unit(random) / 4, pair);
}

static void slivers(random_state *random, case_pair *pair) {
  const gjk_q16 reach = at_least(generate_reach(random), 65536);
  generate_sliver(random, solid(random), reach, &pair->a);
  generate_sliver(random, solid(random), reach, &pair->b);
  generate_apart(random, 0.02 * generate_unit(random), pair);
}

// Crossing sheets: A - B has an inside, though the sheets have none.
static void sheets(random_state *random, case_pair *pair) {
  static const case_kind thin[3] = {CASE_SEGMENT, CASE_TRIANGLE, CASE_TRIANGLE};
  make(random, CASE_TRIANGLE, thin[random_below(random, 3)], pair);
  deep(random, pair);
}

// A hull or box and its copy: at a vertex of it, at a difference of two, or at the same place. Planes, edges and
// vertices coincide, and A - B is full of parallel edges. Turned, a hull may reach twice as far from the centre of its
// box.
static void same(random_state *random, case_pair *pair) {
  generate_polytope(random, solid(random), at_least(generate_reach(random) / 2, 3), &pair->a);
  pair->a.pose.rotation = generate_rotation(random);
  generate_bake(&pair->a);
  case_shape_copy(&pair->b, &pair->a);
  const uint32_t count = (uint32_t)pair->a.count;
  gjk_vec3 *p = &pair->b.pose.position;
  if (random_below(random, 4) > 0) {
    const gjk_vec3 v = pair->a.vertices[random_below(random, count)], w = pair->a.vertices[random_below(random, count)];
    const int halves = (int)random_below(random, 2) + 1;
    p->x += v.x / halves - w.x / halves;
    p->y += v.y / halves - w.y / halves;
    p->z += v.z / halves - w.z / halves;
  }
  if (random_below(random, 2) == 0) {
    p->x += random_range(random, -1, 1);
    p->y += random_range(random, -1, 1);
    p->z += random_range(random, -1, 1);
  }
}

// A cube in a cube with the same rotation, as hulls. The heights of all facets of A - B are within a few LSB of each
// other.
static void cubes(random_state *random, case_pair *pair) {
  const gjk_q16 half = at_least(generate_reach(random) / 2, 8);
  const gjk_quat rotation = generate_rotation(random);
  case_shape *shapes[2] = {&pair->a, &pair->b};
  for (int k = 0; k < 2; k++) {
    const gjk_q16 size = half - random_range(random, 0, half / 4);
    shapes[k]->kind = CASE_BOX;
    shapes[k]->size.x = size + random_range(random, -2, 2);
    shapes[k]->size.y = size + random_range(random, -2, 2);
    shapes[k]->size.z = size;
    shapes[k]->pose.rotation = rotation;
    generate_bake(shapes[k]);
  }
  pair->b.pose.position.x += random_range(random, -2, 2);
  pair->b.pose.position.y += random_range(random, -2, 2);
}

// Equal boxes with faces or edges flush along some axes, pushed into each other along the others.
static void flush_boxes(random_state *random, case_pair *pair) {
  const gjk_q16 unit = at_least(generate_reach(random) / 8, 2);
  case_shape *shapes[2] = {&pair->a, &pair->b};
  for (int k = 0; k < 2; k++) {
    shapes[k]->kind = CASE_BOX;
    shapes[k]->size.x = random_range(random, 1, 4) * unit;
    shapes[k]->size.y = random_range(random, 1, 4) * unit;
    shapes[k]->size.z = random_range(random, 1, 4) * unit;
  }
  gjk_vec3 *p = &pair->b.pose.position;
  p->x = random_range(random, -3, 3) * unit;
  p->y = random_range(random, -3, 3) * unit + random_range(random, -1, 1);
  p->z = random_range(random, -2, 2) * unit;
  if (random_below(random, 2) == 0) {
    generate_bake(&pair->a);
    generate_bake(&pair->b);
  }
}

// Hulls with some vertices twice, and with points of edges and faces as vertices.
static void duplicates(random_state *random, case_pair *pair) {
  generate_lattice(random, pair);
  case_shape *shapes[2] = {&pair->a, &pair->b};
  for (int k = 0; k < 2; k++) {
    case_shape *shape = shapes[k];
    const size_t count = shape->count;
    case_shape_set_count(shape, count + 4);
    for (size_t i = count; i < shape->count; i++) {
      shape->vertices[i] = shape->vertices[random_below(random, (uint32_t)count)];
    }
  }
  pair->b.pose.position.x /= 3;
  pair->b.pose.position.y /= 3;
  pair->b.pose.position.z /= 4;
}

static void outermost(random_state *random, case_pair *pair) {
  make(random, solid(random), CASE_HULL, pair);
  sink(random, 1000, pair);
  generate_outermost(random, pair);
}

const generate_family generate_overlaps[] = {
    {.name = "shallow-boxes", .generate = shallow_boxes, .least = 95, .most = 100},
    {.name = "shallow-hulls", .generate = shallow_hulls, .least = 95, .most = 100},
    {.name = "shallow-thin", .generate = shallow_thin, .least = 70, .most = 100},
    {.name = "shallow-rounded", .generate = shallow_rounded, .least = 90, .most = 100},
    {.name = "deep-tiny", .generate = deep_tiny, .least = 60, .most = 100},
    {.name = "deep-boxes", .generate = deep_boxes, .least = 95, .most = 100},
    {.name = "deep-hulls", .generate = deep_hulls, .least = 80, .most = 100},
    {.name = "deep-mixed", .generate = deep_mixed, .least = 90, .most = 100},
    {.name = "deep-rounded", .generate = deep_rounded, .least = 90, .most = 100},
    {.name = "concentric", .generate = concentric, .least = 90, .most = 100},
    {.name = "nested-deep", .generate = nested, .least = 80, .most = 100},
    {.name = "sliver-crosses", .generate = slivers, .least = 40, .most = 100},
    {.name = "sheets", .generate = sheets, .least = 20, .most = 90},
    {.name = "same", .generate = same, .least = 90, .most = 100},
    {.name = "cubes", .generate = cubes, .least = 100, .most = 100},
    {.name = "flush-boxes", .generate = flush_boxes, .least = 80, .most = 100},
    {.name = "duplicates", .generate = duplicates, .least = 50, .most = 100},
    {.name = "flat", .generate = generate_flat, .least = 10, .most = 80},
    {.name = "tilted", .generate = generate_tilted, .least = 60, .most = 100},
    {.name = "outermost", .generate = outermost, .least = 70, .most = 100},
};
const unsigned generate_overlap_count = sizeof generate_overlaps / sizeof generate_overlaps[0];
