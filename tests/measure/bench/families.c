// Makes the families of pairs that the benchmark measures.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "generate/generate.h"
#include "generate/overlap.h"
#include "generate/place.h"
#include "generate/polytope.h"
#include "generate/prism.h"
#include "workload.h"

const int bench_depths[] = {1, 2, 3, 10, 30, 100, 300, 1000, 3000, 10000, 1000000};
const size_t bench_depth_count = sizeof bench_depths / sizeof bench_depths[0];

const int bench_gaps[] = {-1000, -100, -10, -3, -2, -1, 0, 1, 2, 3, 10, 100, 1000};
const size_t bench_gap_count = sizeof bench_gaps / sizeof bench_gaps[0];

// A point 0.8 to 1 unit from the origin.
static gjk_vec3 shell_point(random_state *random) {
  return generate_vector(random, (0.8 + 0.2 * generate_unit(random)) * GJK_Q16_ONE);
}

// A box with half extents of 0.2 to 1 unit, or a hull of so many points.
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

// Boxes and hulls in turn, placed at one of bench_gaps.
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

// Such pairs, 16,000 to 30,000 units from the origin along each axis.
static void make_far(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  const gjk_vec3 by = {either_side(random, GJK_Q16(16000), GJK_Q16(30000)),
                       either_side(random, GJK_Q16(16000), GJK_Q16(30000)),
                       either_side(random, GJK_Q16(16000), GJK_Q16(30000))};
  make_near(family, random, pair, placed);
  pair->a.pose.position = moved(pair->a.pose.position, by);
  pair->b.pose.position = moved(pair->b.pose.position, by);
}

static void make_generated(const generate_family *families, unsigned count, const char *name, random_state *random,
                           case_pair *pair) {
  for (unsigned i = 0; i < count; i++) {
    if (strcmp(families[i].name, name) == 0) {
      generate_pair(&families[i], random_u64(random), pair);
      return;
    }
  }
  abort();
}

static void make_touching(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  static const char *const names[] = {"near-boxes", "near-hulls"};
  (void)family;
  (void)placed;
  make_generated(generate_families, generate_family_count, names[random_below(random, 2)], random, pair);
}

static void make_stacked(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  static const char *const names[] = {"stacked", "stacked-hulls"};
  (void)family;
  (void)placed;
  make_generated(generate_families, generate_family_count, names[random_below(random, 2)], random, pair);
}

static void make_slivers(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_generated(generate_families, generate_family_count, "slivers", random, pair);
}

static void make_smallest(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  static const char *const names[] = {"smallest-face-vertex", "smallest-face-face", "smallest-edge-edge"};
  (void)family;
  (void)placed;
  make_generated(generate_families, generate_family_count, names[random_below(random, 3)], random, pair);
}

// Shapes whose centres are up to a unit apart.
static void place_together(random_state *random, case_pair *pair) {
  pair->a.pose.position = generate_vector(random, GJK_Q16(3.0));
  pair->b.pose.position = moved(pair->a.pose.position, generate_vector(random, generate_unit(random) * GJK_Q16_ONE));
}

static void make_overlap(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)placed;
  make_shape(random, family->vertices, bench_boxes_only(family), &pair->a);
  make_shape(random, family->vertices, bench_boxes_only(family), &pair->b);
  place_together(random, pair);
}

static void make_mixed(random_state *random, case_pair *pair) {
  make_shape(random, 8 + random_below(random, 25), random_below(random, 2) == 0, &pair->a);
  make_shape(random, 8 + random_below(random, 25), random_below(random, 2) == 0, &pair->b);
  pair->a.pose.position = generate_vector(random, GJK_Q16(3.0));
}

static void make_shallow(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_mixed(random, pair);
  generate_near(random, -random_range(random, 1, 3), pair);
}

// A depth from 1 LSB to half a unit; every order of magnitude is equally likely.
static void make_depths(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_mixed(random, pair);
  generate_near(random, -(gjk_q16)exp(generate_unit(random) * log(GJK_Q16(0.5))), pair);
}

static void make_concentric(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_mixed(random, pair);
  pair->b.pose.position = pair->a.pose.position;
  pair->b.pose.position.x += random_range(random, -1, 1);
}

static void make_crosses(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_generated(generate_overlaps, generate_overlap_count, "sliver-crosses", random, pair);
}

static void make_rounded(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)family;
  (void)placed;
  make_mixed(random, pair);
  pair->a.convex_radius = random_range(random, GJK_Q16(0.05), GJK_Q16(0.3));
  pair->b.convex_radius = random_range(random, GJK_Q16(0.05), GJK_Q16(0.3));
  generate_near(random, -random_range(random, 1, GJK_Q16(0.5)), pair);
}

// Makes the top of a prism smaller, down to half its size.
static void taper(random_state *random, case_shape *shape) {
  const int32_t share = random_range(random, 128, 256);
  for (size_t i = shape->count / 2; i < shape->count; i++) {
    shape->vertices[i].x = shape->vertices[i].x / 256 * share;
    shape->vertices[i].y = shape->vertices[i].y / 256 * share;
  }
}

// Stands B on A, spun, and tilted by up to a degree.
static void make_pressed(const bench_family *family, random_state *random, case_pair *pair, int *placed) {
  (void)placed;
  make_shape(random, 0, true, &pair->a);
  make_shape(random, 0, true, &pair->b);
  pair->a.pose.position = generate_vector(random, GJK_Q16(3.0));
  const gjk_vec3 at = {random_range(random, -pair->a.size.x / 2, pair->a.size.x / 2),
                       random_range(random, -pair->a.size.y / 2, pair->a.size.y / 2),
                       pair->a.size.z + pair->b.size.z - random_range(random, 0, GJK_Q16(0.05))};
  gjk_quat turn = {random_range(random, -6, 6), random_range(random, -6, 6), random_range(random, -1000, 1000), 1000};
  gjk_quat_normalize(&pair->a.pose.rotation, &pair->a.pose.rotation);
  gjk_quat_normalize(&turn, &turn);
  gjk_quat_compose(&pair->a.pose.rotation, &turn, &pair->b.pose.rotation);
  gjk_pose_apply(&pair->a.pose, &at, &pair->b.pose.position);
  if (!bench_boxes_only(family)) {
    generate_prism(4, &pair->a);
    generate_prism(4, &pair->b);
    taper(random, &pair->a);
    taper(random, &pair->b);
  }
}

#define GAP (BENCH_ASK(BENCH_DISTANCE) | BENCH_ASK(BENCH_INTERSECT))
#define DEPTH BENCH_ASK(BENCH_DEPTH)
#define CONTACTS BENCH_ASK(BENCH_CONTACTS)

const bench_family bench_families[] = {
    // name, what it is, queries, vertices, maker
    {"boxes", "boxes with half extents of 0.2 to 1 unit; centres 0.5 to 3.5 units apart", GAP, 8, make_boxes},
    {"hulls-8", "hulls of 8 points 0.8 to 1 unit from their middle; centres 0.5 to 3.5 units apart", GAP, 8,
     make_hulls},
    {"hulls-32", "the same with 32 points", GAP, 32, make_hulls},
    {"hulls-128", "the same with 128 points", GAP, 128, make_hulls},
    {"hulls-512", "the same with 512 points", GAP, 512, make_hulls},
    {"near", "such boxes and hulls (8 to 32 points) placed at gaps of -1000 to 1000 LSB", GAP, 0, make_near},
    {"far", "the same 16000 to 30000 units from the origin along each axis", GAP, 0, make_far},
    {"touching", "boxes and hulls of all sizes within 3 LSB of touching", BENCH_ASK(BENCH_INTERSECT), 0, make_touching},
    {"stacked", "boxes and hulls face to face; apart or overlapping by up to 2 LSB", BENCH_ASK(BENCH_INTERSECT), 0,
     make_stacked},
    {"slivers", "boxes and hulls 10000 times longer than thick; 1 to 4000 units; within 3 LSB of touching", GAP, 0,
     make_slivers},
    {"smallest", "contacts of hulls of up to 4000 units whose deciding determinant is -1 or 0 or 1", GAP, 0,
     make_smallest},
    {"overlap-boxes", "boxes like those above that overlap; centres up to 1 unit apart", DEPTH, 8, make_overlap},
    {"overlap-hulls-8", "hulls of 8 points that overlap; centres up to 1 unit apart", DEPTH, 8, make_overlap},
    {"overlap-hulls-32", "the same with 32 points", DEPTH, 32, make_overlap},
    {"overlap-hulls-128", "the same with 128 points", DEPTH, 128, make_overlap},
    {"shallow", "boxes and hulls of 8 to 32 points that are 1 to 3 LSB deep", DEPTH, 0, make_shallow},
    {"concentric", "the same with their centres an LSB or less apart", DEPTH, 0, make_concentric},
    {"rounded", "the same rounded by 0.05 to 0.3 units; up to 0.5 units deep", DEPTH, 0, make_rounded},
    {"crosses", "boxes and hulls 10000 times longer than thick that cross", DEPTH, 0, make_crosses},
    {"depths", "boxes and hulls of 8 to 32 points; depths from 1 LSB to 0.5 units; evenly over the orders of magnitude",
     DEPTH, 0, make_depths},
    {"pressed-boxes", "boxes face to face; spun; tilted by up to a degree; up to 0.05 units deep", CONTACTS, 8,
     make_pressed},
    {"pressed-hulls", "frusta of pyramids with faces; placed the same way", CONTACTS, 8, make_pressed},
};
const size_t bench_family_count = sizeof bench_families / sizeof bench_families[0];
