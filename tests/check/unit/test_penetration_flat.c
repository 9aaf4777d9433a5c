// Depths of very flat and of deeply nested curved pairs. Iterations and memory have a ceiling; bounds that are close
// enough are an answer; and no answer depends on more memory.
#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk/penetration.h"
#include "parts_answers.h"
#include "reference/accurate.h"
#include "reference/random_shape.h"

#define SEED 20261122
#define PAIRS ((int)check_trials(600))
#define MANY 40000

static gjk_epa_cell cells[MANY];
static case_pair pair;
static case_collider a, b;

typedef struct tally {
  unsigned long answers, bounds, smaller;
  unsigned iterations;
} tally;

// Pairs that take 4,000 to 60,000 iterations without the rules for flat and nested pairs, many of them up to CAPACITY
// though the bounds tell the depth.
static const struct known {
  case_kind kind_a, kind_b;
  gjk_vec3 size_a, size_b, at;  // B's position; A is at the origin
  gjk_quat turn;                // A's, of any length; B is not turned
} known[] = {
    {CASE_ELLIPSOID, CASE_ELLIPSOID, {65536, 65536, 64}, {65536, 65536, 64}, {0, 0, 3}, {0, 0, 0, 1}},
    {CASE_ELLIPSOID, CASE_ELLIPSOID, {65536, 65536, 65536}, {65536, 65536, 65536}, {0, 0, 0}, {0, 0, 0, 1}},
    {CASE_ELLIPSOID,
     CASE_ELLIPSOID,
     {262888, 262888, 129},
     {33554432, 33554432, 33554433},
     {-157433, -206437, -36861},
     {0, 0, 0, 1}},
    {CASE_ELLIPSOID,
     CASE_ELLIPSOID,
     {262888, 262888, 129},
     {33554432, 33554432, 33554433},
     {-157433, -206437, -36861},
     {3, 5, -2, 8}},
    {CASE_CYLINDER, CASE_ELLIPSOID, {709, 709, 1}, {67108864, 4194305, 4194305}, {142, 265, 289}, {0, 0, 0, 1}},
    {CASE_ELLIPSOID, CASE_CONE, {8389183, 8389183, 8389184}, {4096, 4096, 1}, {147735, 1694695, 756766}, {0, 0, 0, 1}},
    {CASE_CONE, CASE_CONE, {67109818, 67109818, 1}, {67109818, 67109818, 1}, {99, -20, 0}, {0, 0, 0, 1}},
    {CASE_CYLINDER,
     CASE_CYLINDER,
     {67109818, 67109818, 70000000},
     {67109818, 67109818, 70000000},
     {0, 0, 0},
     {0, 0, 0, 1}},
};

// Makes a shape of the kind; half of them are as flat as an LSB allows.
static void random_flat(random_state *random, case_kind kind, case_shape *shape) {
  const gjk_q16 wide = (INT32_C(1) << (8 + random_below(random, 19))) + (gjk_q16)random_below(random, 1000);
  const gjk_q16 flat = 1 + (gjk_q16)((uint32_t)wide >> random_below(random, 26));
  random_shape(random, kind, 1000, shape);
  shape->size.x = wide;
  shape->size.y = (kind == CASE_ELLIPSOID || kind == CASE_BOX) && random_below(random, 3) == 0 ? flat : wide;
  shape->size.z = flat;
  shape->convex_radius = 0;
}

static void random_pair(random_state *random) {
  const case_kind kind_a = CASE_CYLINDER + (case_kind)random_below(random, 3);
  const case_kind kind_b = random_below(random, 3) == 0 ? CASE_BOX : CASE_CYLINDER + (case_kind)random_below(random, 3);
  random_flat(random, kind_a, &pair.a);
  random_flat(random, kind_b, &pair.b);
  if (random_below(random, 2) == 0) {
    pair.b.size = pair.a.size;
  }
  if (random_below(random, 2) == 0) {
    pair.b.pose.rotation = pair.a.pose.rotation;
  }
  const gjk_q16 reach = random_below(random, 2) == 0 ? pair.a.size.z : pair.a.size.x;
  const gjk_vec3 origin = {0, 0, 0};
  pair.a.pose.position = origin;
  pair.b.pose.position = random_below(random, 4) == 0 ? origin : random_vector(random, random_unit(random) * reach);
}

static gjk_status ask(uint32_t count, gjk_penetration_result *out) {
  const gjk_workspace workspace = {cells, count};
  memset(out, 0, sizeof *out);
  return gjk_penetration(&a.collider, &b.collider, NULL, &workspace, out);
}

// With less memory the answer is the same, or none with bounds that hold.
static void check_smaller(const gjk_penetration_result *full, gjk_status status, tally *t) {
  static const uint32_t counts[] = {0, 11, 12, 20, 60, 200, 600, 2000, GJK_EPA_CURVED_CELLS - 1};
  for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
    gjk_penetration_result less;
    const gjk_status found = ask(counts[i], &less);
    if (found == GJK_OK) {
      CHECK_MSG(status == GJK_OK, "%s, %lu cells", pair.id, (unsigned long)counts[i]);
      CHECK_MSG(same_penetration(&less, full), "%s, %lu cells", pair.id, (unsigned long)counts[i]);
    } else {
      CHECK_MSG(found == GJK_ERROR_CAPACITY, "%s, %lu cells: %d", pair.id, (unsigned long)counts[i], found);
      CHECK_MSG(less.lower <= full->upper, "%s, %lu cells: bounds", pair.id, (unsigned long)counts[i]);
      CHECK_MSG(less.upper >= full->lower, "%s, %lu cells: bounds", pair.id, (unsigned long)counts[i]);
      t->smaller++;
    }
  }
}

static void check_pair(tally *t) {
  gjk_penetration_result full, more;
  CHECK(case_collider_build(&a, &pair.a, false) == GJK_OK);
  CHECK(case_collider_build(&b, &pair.b, false) == GJK_OK);
  const unsigned long failed = check_failed;
  const gjk_status status = ask(GJK_EPA_CURVED_CELLS, &full);
  CHECK_MSG(status == GJK_OK || status == GJK_ERROR_CAPACITY, "%s: %d", pair.id, status);
  CHECK_MSG(full.iterations <= GJK_ITERATIONS_MAX + 4 + GJK_EPA_CURVED_ITERATIONS_MAX, "%s: %u iterations", pair.id,
            full.iterations);
  CHECK_MSG(ask(MANY, &more) == status, "%s: more cells, another answer", pair.id);
  CHECK_MSG(same_penetration(&full, &more), "%s: more cells, another answer", pair.id);
  t->iterations = full.iterations > t->iterations ? full.iterations : t->iterations;
  if (full.intersecting) {
    accurate_result truth;
    accurate_signed(&pair, &a, &b, &truth);
    CHECK_MSG(full.lower <= 1 - truth.lower, "%s: bounds %ld to %ld, depth %.2Lf to %.2Lf", pair.id, (long)full.lower,
              (long)full.upper, -truth.upper, -truth.lower);
    CHECK_MSG(full.upper >= -truth.upper, "%s: bounds %ld to %ld, depth %.2Lf to %.2Lf", pair.id, (long)full.lower,
              (long)full.upper, -truth.upper, -truth.lower);
    const bool tight = full.upper - full.lower <= 6;
    CHECK_MSG(status != GJK_OK || tight, "%s: %ld to %ld is no answer", pair.id, (long)full.lower, (long)full.upper);
    if (status == GJK_OK) {
      CHECK_MSG(full.depth <= 4 - truth.lower, "%s: depth %ld, not %.2Lf to %.2Lf", pair.id, (long)full.depth,
                -truth.upper, -truth.lower);
      CHECK_MSG(full.depth >= -truth.upper - 3, "%s: depth %ld, not %.2Lf to %.2Lf", pair.id, (long)full.depth,
                -truth.upper, -truth.lower);
    }
    check_smaller(&full, status, t);
  }
  t->answers += status == GJK_OK;
  t->bounds += status != GJK_OK;
  if (check_failed > failed && failed < 5) {
    case_print(stdout, &pair);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  const gjk_pose identity = GJK_POSE_IDENTITY;
  tally t = {0, 0, 0, 0}, of_known = {0, 0, 0, 0};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const struct known *k = &known[i];
    random_shape(&random, k->kind_a, 1000, &pair.a);
    random_shape(&random, k->kind_b, 1000, &pair.b);
    pair.a.size = k->size_a;
    pair.b.size = k->size_b;
    pair.a.convex_radius = pair.b.convex_radius = 0;
    memset(&pair.a.pose.position, 0, sizeof pair.a.pose.position);
    pair.b.pose.position = k->at;
    CHECK(gjk_quat_normalize(&k->turn, &pair.a.pose.rotation) == GJK_OK);
    pair.b.pose.rotation = identity.rotation;
    snprintf(pair.id, sizeof pair.id, "known-%lu", (unsigned long)i);
    check_pair(&of_known);
  }
  for (int i = 0; i < PAIRS; i++) {
    random_pair(&random);
    snprintf(pair.id, sizeof pair.id, "flat-%d-%d", SEED, i);
    check_pair(&t);
  }
  printf("known pairs: %lu answers, %lu bounds; random: %lu and %lu, %u iterations at most; %lu with less memory\n",
         of_known.answers, of_known.bounds, t.answers, t.bounds, t.iterations, t.smaller);
  CHECK(PAIRS < 100 || t.answers > (unsigned long)PAIRS * 9 / 10);
  CHECK(of_known.bounds > 0);
  CHECK(t.smaller > (unsigned long)PAIRS);
  case_pair_release(&pair, &a, &b);
  return check_done("penetration_flat");
}
