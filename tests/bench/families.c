// The families of pairs that are measured.
#include <stdlib.h>
#include <string.h>

#include "../generate/generate.h"
#include "../generate/place.h"
#include "../generate/polytope.h"
#include "workload.h"

const int bench_gaps[] = {-1000, -100, -10, -3, -2, -1, 0, 1, 2, 3, 10, 100, 1000};
const size_t bench_gap_count = sizeof bench_gaps / sizeof bench_gaps[0];

// A point between 0.8 and 1 unit from the origin.
static gjk_vec3 shell_point(random_state *random) {
  return generate_vector(random, (0.8 + 0.2 * generate_unit(random)) * GJK_Q16_ONE);
}

// A box of 0.2 to 1 unit, or a hull of so many points.
static void make_shape(random_state *random, unsigned vertices, bool box, case_shape *out) {
  case_shape_reset(out);
  out->kind = box ? CASE_BOX : CASE_HULL;
  if (box) {
    out->size.x = random_range(random, GJK_Q16(0.2), GJK_Q16(1.0));
    out->size.y = random_range(random, GJK_Q16(0.2), GJK_Q16(1.0));
    out->size.z = random_range(random, GJK_Q16(0.2), GJK_Q16(1.0));
  } else {
    case_shape_set_count(out, vertices);
    for (unsigned i = 0; i < vertices; i++) {
      out->vertices[i] = shell_point(random);
    }
  }
  out->pose.rotation = generate_rotation(random);
}

static gjk_vec3 moved(gjk_vec3 a, gjk_vec3 by) {
  const gjk_vec3 sum = {a.x + by.x, a.y + by.y, a.z + by.z};
  return sum;
}

static void place_apart(random_state *random, case_pair *pair) {
  const double apart = (0.5 + 3 * generate_unit(random)) * GJK_Q16_ONE;
  pair->a.pose.position = generate_vector(random, GJK_Q16(3.0));
  pair->b.pose.position = moved(pair->a.pose.position, generate_vector(random, apart));
}

static void make_boxes(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)placed;
  make_shape(random, family->vertices, true, &pair->a);
  make_shape(random, family->vertices, true, &pair->b);
  place_apart(random, pair);
}

static void make_hulls(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)placed;
  make_shape(random, family->vertices, false, &pair->a);
  make_shape(random, family->vertices, false, &pair->b);
  place_apart(random, pair);
}

// Boxes and hulls in turn, about as far apart as one of bench_gaps says.
static void make_near(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  *placed = bench_gaps[random_below(random, (uint32_t)bench_gap_count)];
  make_shape(random, 8 + random_below(random, 25), random_below(random, 2) == 0, &pair->a);
  make_shape(random, 8 + random_below(random, 25), random_below(random, 2) == 0, &pair->b);
  pair->a.pose.position = generate_vector(random, GJK_Q16(3.0));
  generate_near(random, *placed, pair);
}

static gjk_q16 either_side(random_state *random, gjk_q16 low, gjk_q16 high) {
  const gjk_q16 x = random_range(random, low, high);
  return random_below(random, 2) == 0 ? -x : x;
}

// The same, with each coordinate of the place 16,000 to 30,000 units from the origin.
static void make_far(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  const gjk_vec3 by = {either_side(random, GJK_Q16(16000), GJK_Q16(30000)),
                       either_side(random, GJK_Q16(16000), GJK_Q16(30000)),
                       either_side(random, GJK_Q16(16000), GJK_Q16(30000))};
  make_near(family, random, pair, placed);
  pair->a.pose.position = moved(pair->a.pose.position, by);
  pair->b.pose.position = moved(pair->b.pose.position, by);
}

static void make_generated(const char *name, random_state *random, case_pair *pair) {
  for (unsigned i = 0; i < generate_family_count; i++) {
    if (strcmp(generate_families[i].name, name) == 0) {
      generate_pair(&generate_families[i], random_u64(random), pair);
      return;
    }
  }
  abort();
}

static void make_slivers(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_generated("slivers", random, pair);
}

static void make_smallest(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  static const char *const names[] = {"smallest-face-vertex", "smallest-face-face", "smallest-edge-edge"};
  (void)family;
  (void)placed;
  make_generated(names[random_below(random, 3)], random, pair);
}

const bench_family bench_families[] = {
    {"boxes", "boxes with half extents of 0.2 to 1 unit; centres 0.5 to 3.5 units apart", 8, make_boxes},
    {"hulls-8", "hulls of 8 points 0.8 to 1 unit from their middle; centres 0.5 to 3.5 units apart", 8, make_hulls},
    {"hulls-32", "the same with 32 points", 32, make_hulls},
    {"hulls-128", "the same with 128 points", 128, make_hulls},
    {"hulls-512", "the same with 512 points", 512, make_hulls},
    {"near", "such boxes and hulls (8 to 32 points) placed at gaps of -1000 to 1000 LSB", 0, make_near},
    {"far", "the same 16000 to 30000 units from the origin along each axis", 0, make_far},
    {"slivers", "boxes and hulls 10000 times longer than thick; 1 to 4000 units; within 3 LSB of touching", 0,
     make_slivers},
    {"smallest", "contacts of hulls of up to 4000 units whose deciding determinant is -1 or 0 or 1", 0, make_smallest},
};
const size_t bench_family_count = sizeof bench_families / sizeof bench_families[0];
