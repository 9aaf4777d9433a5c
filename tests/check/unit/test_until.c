// gjk_distance_until: its bounds hold, get narrower and end in the exact answer, on every family and on curved shapes.
#include <math.h>
#include <string.h>

#include "check.h"
#include "generate/generate.h"
#include "placed.h"
#include "random_vec.h"
#include "reference/random_shape.h"

#define SEED 77000
#define PAIRS_PER_FAMILY 150
#define CURVED_PAIRS 1500
#define SLENDER_PAIRS ((int)check_trials(4000))
#define SLENDER_SEED 58
#define FAR (INT32_C(1) << 29)

typedef struct tally {
  unsigned long open, exact, by_error, proven_together;
} tally;

static double gap_of(const gjk_vec3 *a, const gjk_vec3 *b) {
  const double x = (double)a->x - b->x, y = (double)a->y - b->y, z = (double)a->z - b->z;
  return sqrt(x * x + y * y + z * z);
}

// Is `part` the answer of the full query, or are its bounds true? slack: how far, in LSB, the full answer may be off.
static bool is_honest(const gjk_distance_result *full, const gjk_distance_result *part, int32_t slack) {
  if (part->certificate.proof != GJK_PROOF_NONE || part->lower == part->upper) {
    return part->intersecting == full->intersecting && part->distance == full->distance;
  }
  return !part->intersecting && part->distance <= part->upper && part->distance >= part->upper - 1 &&
         part->lower <= part->upper && part->lower <= full->distance + slack && part->upper >= full->distance - slack;
}

// The points must be as far apart as the distance says. At distance 0 and far apart that is not asked, as rounding
// weighs more there.
static bool points_fit(const gjk_distance_result *part) {
  return part->intersecting || part->saturated || part->upper == 0 || part->upper > FAR ||
         fabs(gap_of(&part->point_a, &part->point_b) - part->distance) <= 2;
}

static bool at_end(const gjk_vec3 *p) {
  return p->x == INT32_MAX || p->x == INT32_MIN || p->y == INT32_MAX || p->y == INT32_MIN || p->z == INT32_MAX ||
         p->z == INT32_MIN;
}

// May a number of the answer have saturated?
static bool is_cut(const gjk_distance_result *r) {
  return r->upper == GJK_DISTANCE_MAX || at_end(&r->point_a) || at_end(&r->point_b);
}

static void check_iterations(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *full,
                             int32_t slack, const char *id, tally *t) {
  gjk_distance_result part, before = {0};
  before.upper = GJK_DISTANCE_MAX;
  for (uint8_t iterations = 1; iterations < full->iterations + 2; iterations++) {
    const gjk_effort effort = {iterations, 0};
    memset(&part, 1, sizeof part);
    const gjk_status status = gjk_distance_until(a, b, &effort, NULL, &part);
    CHECK_MSG(status == GJK_OK, "%s after %d", id, iterations);
    CHECK_MSG(!part.saturated || is_cut(&part), "%s after %d", id, iterations);
    CHECK_MSG(part.iterations <= iterations, "%s after %d", id, iterations);
    CHECK_MSG(is_honest(full, &part, slack), "%s after %d", id, iterations);
    CHECK_MSG(points_fit(&part), "%s after %d", id, iterations);
    CHECK_MSG(part.lower >= before.lower, "%s after %d: wider", id, iterations);
    CHECK_MSG(part.upper <= before.upper, "%s after %d: wider", id, iterations);
    const bool done = part.iterations < iterations || part.certificate.proof != GJK_PROOF_NONE;
    t->open += !done;
    t->exact += done;
    t->proven_together += !done && part.upper == 0;
    before = part;
    before.lower -= slack;
    before.upper = before.upper > GJK_DISTANCE_MAX - slack ? before.upper : before.upper + slack;
  }
  CHECK_MSG(part.intersecting == full->intersecting, "%s: all iterations", id);
  CHECK_MSG(part.distance == full->distance, "%s: all iterations", id);
  CHECK_MSG(memcmp(&part.point_a, &full->point_a, sizeof part.point_a) * !full->intersecting == 0, "%s: all iterations",
            id);
}

static void check_errors(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *full, int32_t slack,
                         const char *id, tally *t) {
  const gjk_effort unlimited = {0, 0};
  gjk_distance_result whole;
  CHECK_MSG(gjk_distance_until(a, b, &unlimited, NULL, &whole) == GJK_OK, "%s, no limit", id);
  CHECK_MSG(whole.distance == full->distance, "%s, no limit", id);
  CHECK_MSG(whole.iterations == full->iterations, "%s, no limit", id);
  CHECK_MSG(whole.certificate.proof == full->certificate.proof, "%s, no limit", id);
  for (unsigned bits = 0; bits < 29; bits += 4) {
    const gjk_q16 error = INT32_C(1) << bits;
    const gjk_effort effort = {0, error};
    gjk_distance_result part;
    CHECK_MSG(gjk_distance_until(a, b, &effort, NULL, &part) == GJK_OK, "%s, error %ld", id, (long)error);
    CHECK_MSG(is_honest(full, &part, slack), "%s, error %ld", id, (long)error);
    CHECK_MSG(points_fit(&part), "%s, error %ld", id, (long)error);
    CHECK_MSG(part.upper - part.lower <= error, "%s, error %ld", id, (long)error);
    CHECK_MSG(part.iterations <= full->iterations, "%s, error %ld", id, (long)error);
    t->by_error += part.upper > part.lower;
  }
}

static void check_pair(const case_pair *pair, case_collider *a, case_collider *b, int32_t slack, tally *t) {
  gjk_distance_result full = {0};
  if (!case_pair_build(pair, false, a, b) || gjk_distance(&a->collider, &b->collider, NULL, &full) != GJK_OK) {
    CHECK_MSG(false, "%s", pair->id);
    return;
  }
  const unsigned long failed = check_failed;
  check_iterations(&a->collider, &b->collider, &full, slack, pair->id, t);
  check_errors(&a->collider, &b->collider, &full, slack, pair->id, t);
  if (check_failed > failed && failed < 5) {
    case_print(stdout, pair);
  }
}

// Triangles with sides of some 2,000 units, but one corner is near another, or near the middle of the opposite side.
static void random_slender(random_state *random, gjk_vec3 corner[3]) {
  const gjk_q16 reach = GJK_Q16(2000.0);
  const gjk_q16 width = INT32_C(1) << random_below(random, 22);
  for (int i = 0; i < 2; i++) {
    corner[i] = random_in_cube(random, reach);
  }
  const bool middle = random_below(random, 2) == 0;
  corner[2].x = (middle ? (corner[0].x + corner[1].x) / 2 : corner[0].x) + random_range(random, -width, width);
  corner[2].y = (middle ? (corner[0].y + corner[1].y) / 2 : corner[0].y) + random_range(random, -width, width);
  corner[2].z = (middle ? (corner[0].z + corner[1].z) / 2 : corner[0].z) + random_range(random, -width, width);
}

// The distance of a point from a shape, rounded to LSB.
static gjk_q16 off_shape(const gjk_vec3 *point, const gjk_collider *shape) {
  static const gjk_shape dot = GJK_POINT;
  const gjk_collider at = placed(&dot, *point);
  gjk_distance_result result;
  CHECK(gjk_distance(&at, shape, NULL, &result) == GJK_OK);
  return result.distance;
}

// The plane of a large feature is known only to several LSB. If its distance were taken for that of the points, the
// answer would be off by up to 10 LSB.
static void test_slender_triangles(void) {
  random_state random = random_seed(SLENDER_SEED);
  unsigned long open = 0;
  double worst = 0;
  for (int i = 0; i < SLENDER_PAIRS; i++) {
    gjk_vec3 corners[2][3];
    random_slender(&random, corners[0]);
    random_slender(&random, corners[1]);
    const gjk_shape shape_a = GJK_TRIANGLE(corners[0]), shape_b = GJK_TRIANGLE(corners[1]);
    const gjk_collider a = placed_at(&shape_a, 0, 0, 0), b = placed(&shape_b, random_vector(&random, GJK_Q16(2000.0)));
    for (uint8_t iterations = 1; iterations <= 5; iterations++) {
      const gjk_effort effort = {iterations, 0};
      gjk_distance_result part;
      CHECK(gjk_distance_until(&a, &b, &effort, NULL, &part) == GJK_OK);
      if (part.intersecting) {
        continue;
      }
      const double off = fabs(gap_of(&part.point_a, &part.point_b) - part.distance);
      CHECK_MSG(off <= 2, "pair %d, seed %d, after %d: points %.2f LSB off", i, SLENDER_SEED, iterations, off);
      CHECK_MSG(off_shape(&part.point_a, &a) <= 1, "pair %d, seed %d, after %d: A's point", i, SLENDER_SEED,
                iterations);
      CHECK_MSG(off_shape(&part.point_b, &b) <= 1, "pair %d, seed %d, after %d: B's point", i, SLENDER_SEED,
                iterations);
      open += part.certificate.proof == GJK_PROOF_NONE;
      worst = off > worst ? off : worst;
    }
  }
  printf("slender triangles: %lu answers before the last iteration, points at most %.2f LSB off\n", open, worst);
  CHECK(open > (unsigned long)SLENDER_PAIRS);
}

static void test_statuses(void) {
  static const gjk_shape ball = GJK_SPHERE(5);
  const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider a = {0}, b = {0};
  gjk_distance_result out, poison;
  gjk_effort effort = {0, -1};
  memset(&poison, 0xA5, sizeof poison);
  out = poison;
  gjk_collider_init(&a, &ball, NULL, 0);
  gjk_collider_pose(&a, &pose);
  CHECK(gjk_distance_until(&a, &b, &effort, NULL, &out) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_distance_until(&a, NULL, &effort, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk_distance_until(&a, &a, NULL, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk_distance_until(&a, &a, &effort, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_distance_until(&a, &a, &effort, NULL, &out) == GJK_ERROR_NEGATIVE);
  CHECK(memcmp(&out, &poison, sizeof out) == 0);
  effort.error = 0;
  effort.iterations = 1;
  CHECK(gjk_distance_until(&a, &a, &effort, NULL, &out) == GJK_OK);
  CHECK(out.intersecting);
  CHECK(out.distance == 0);
  // As many iterations as the ceiling, or more, are no limit.
  effort.iterations = UINT8_MAX;
  CHECK(gjk_distance_until(&a, &a, &effort, NULL, &out) == GJK_OK);
  CHECK(out.intersecting);
}

int main(void) {
  case_pair pair = {0};
  case_collider a = {0}, b = {0};
  tally t = {0, 0, 0, 0}, curved = {0, 0, 0, 0};
  test_statuses();
  test_slender_triangles();
  for (unsigned f = 0; f < generate_family_count; f++) {
    for (uint64_t seed = 0; seed < PAIRS_PER_FAMILY; seed++) {
      generate_pair(&generate_families[f], check_seed(SEED) + seed, &pair);
      check_pair(&pair, &a, &b, 0, &t);
    }
  }
  random_state random = random_seed(check_seed(SEED) + 4711);
  for (int i = 0; i < CURVED_PAIRS; i++) {
    const gjk_q16 reach = random_reach(&random);
    random_shape(&random, CASE_CYLINDER + (case_kind)random_below(&random, 3), reach, &pair.a);
    random_shape(&random, (case_kind)random_below(&random, CASE_ELLIPSOID + 1), reach, &pair.b);
    pair.b.pose.position = random_vector(&random, 2 * random_unit(&random) * reach);
    snprintf(pair.id, sizeof pair.id, "curved-%d", i);
    check_pair(&pair, &a, &b, 4, &curved);
  }
  printf("iterations that leave the gap open: %lu and %lu, exact %lu and %lu; stopped by the error %lu and %lu\n",
         t.open, curved.open, t.exact, curved.exact, t.by_error, curved.by_error);
  CHECK(t.open > 2000);
  CHECK(t.exact > 2000);
  CHECK(t.by_error > 1000);
  CHECK(curved.open > 2000);
  CHECK(curved.exact > 1000);
  CHECK(curved.by_error > 1000);
  case_pair_release(&pair, &a, &b);
  return check_done("until");
}
