// Ellipses and custom shapes: distances and depths against circles and polygons that stand for them, low ceilings, bounds.
#include "filled.h"
#include "gjk2/chain.h"
#include "placed2.h"
#include "plane.h"
#include "whorl2.h"

#define SEED 2005
#define TRIALS check_trials(20000)

// A custom circle: size.x is the radius.
static void support_disc(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  const gjk_q16 radius = *(const gjk_q16 *)user;
  const long double n = hypotl(direction->x, direction->y);
  out->x = (gjk_q16)truncl((long double)direction->x / n * radius);
  out->y = (gjk_q16)truncl((long double)direction->y / n * radius);
}

static struct {
  unsigned long apart, together, capacity;
  int32_t distance, depth;
  unsigned iterations;
} tally;

static int32_t off(int32_t x, int32_t y) {
  return x > y ? x - y : y - x;
}

static void larger(int32_t *most, int32_t x) {
  *most = x > *most ? x : *most;
}

// An ellipse or custom shape that is a circle, against the circle itself: every answer within its error.
static void check_circle(random_state *r, plane_body *pair, plane_body *exact, int32_t size) {
  static gjk_q16 radius;
  radius = random_range(r, 1, size);
  const gjk2_shape circle = GJK2_CIRCLE(radius), ellipse = GJK2_ELLIPSE(radius, radius),
                   custom = GJK2_CUSTOM(support_disc, &radius, radius);
  exact->shape = circle;
  exact->pose = pair[1].pose;
  pair[1].shape = random_below(r, 2) == 0 ? ellipse : custom;
  plane_place(exact, false);
  plane_place(&pair[1], false);
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider, *c = &exact->collider;
  gjk2_distance_result out, truth;
  gjk2_decision yes;
  CHECK(gjk2_signed_distance(a, c, NULL, &truth) == GJK_OK);
  gjk_status status = gjk2_distance(a, b, NULL, &out);
  CHECK(status == GJK_OK);
  tally.iterations = out.iterations > tally.iterations ? out.iterations : tally.iterations;
  const int32_t gap = truth.distance > 0 ? truth.distance : 0;
  CHECK_MSG(off(out.distance, gap) <= 3, "%d, truth %d", out.distance, truth.distance);
  larger(&tally.distance, off(out.distance, gap));
  CHECK(gjk2_intersect(a, b, NULL, &yes) == GJK_OK);
  CHECK(yes.yes == (truth.distance <= 0) || off(truth.distance, 0) <= 2);
  CHECK(yes.certificate.proof == GJK2_PROOF_NONE || yes.certificate.proof == GJK2_PROOF_CIRCLES);
  CHECK(gjk2_check_distance(a, b, &out) == GJK_ERROR_UNSUPPORTED);
  status = gjk2_signed_distance(a, b, NULL, &out);
  CHECK(status == GJK_OK || status == GJK_ERROR_CAPACITY);
  const int32_t slack = out.intersecting && truth.distance < 0 ? 0 : 2;  // decisions are right to within 2 LSB
  CHECK_MSG(out.lower <= truth.distance + slack && out.upper >= truth.distance - slack, "%d to %d, truth %d", out.lower,
            out.upper, truth.distance);
  if (status == GJK_ERROR_CAPACITY) {
    CHECK(out.distance == out.lower);
    tally.capacity++;
    return;
  }
  CHECK_MSG(out.upper - out.lower <= 6, "%d to %d", out.lower, out.upper);
  CHECK_MSG(off(out.distance, truth.distance) <= 3, "%d, truth %d", out.distance, truth.distance);
  larger(&tally.depth, off(out.distance, truth.distance));
  tally.apart += truth.distance > 0;
  tally.together += truth.distance <= 0;
  // The points: as far apart as the distance, along the normal; a depth's to within the bounds.
  const long double x = (long double)out.point_b.x - out.point_a.x, y = (long double)out.point_b.y - out.point_a.y;
  const long double along = (x * out.normal.x + y * out.normal.y) / 1073741824.0L;
  CHECK_MSG(fabsl(along - out.distance) <= 8 + ldexpl(a->radius, -24), "%Lf, %d", along, out.distance);
}

// Bounds at every effort hold, and what an effort leaves open is said so.
static void check_efforts(random_state *r, const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_distance_result full, part;
  gjk2_within_result within;
  CHECK(gjk2_distance(a, b, NULL, &full) == GJK_OK);
  const gjk_q16 asked = random_range(r, 0, full.distance / 2 + 1000);
  for (uint8_t n = 1; n < 12; n++) {
    const gjk2_effort effort = {n, 0};
    CHECK(gjk2_distance_until(a, b, &effort, NULL, &part) == GJK_OK);
    CHECK(part.iterations <= n);
    CHECK_MSG(part.lower <= full.distance + 4 && part.upper >= full.distance - 4, "%d to %d, %d", part.lower,
              part.upper, full.distance);
    CHECK(gjk2_within_until(a, b, asked, n, NULL, &within) == GJK_OK);
    CHECK(within.answer == GJK2_ANSWER_OPEN || (within.answer == GJK2_ANSWER_YES) == (full.distance <= asked) ||
          off(full.distance, asked) <= 3);
  }
}

// A ball beside a shape that no search settles, which may touch it: no query decides, and bounds hold what is left. Of
// contacts and of chains through the ball's middle there is no answer.
static void check_unsettled(void) {
  const gjk2_vec level[] = {{whorl_point.x, whorl_point.z}, {whorl_point.x + GJK_Q16(1), whorl_point.z}};
  const gjk2_shape circle = GJK2_CIRCLE(GJK_Q16(9.9992)),
                   round = GJK2_ROUNDED_CUSTOM(whorl2_support, NULL, GJK_Q16(60), GJK_Q16(9.9992));
  const gjk2_collider a = placed2(&whorl2, 0, 0), b = placed2(&circle, whorl_point.x, whorl_point.z),
                      c = placed2(&round, 0, 0);
  const gjk2_vec origin = {0, 0};
  gjk2_decision touch;
  gjk2_distance_result gap, deep;
  gjk2_penetration_result depth;
  gjk2_manifold m;
  gjk2_cast_result cast;
  gjk2_impact_result impact;
  gjk2_chain chain = {0};
  const gjk2_vec to = {0, whorl_point.z};
  const gjk2_cast_path path = {NULL, &to, 0};
  const gjk2_pose at_a = {origin, {GJK_Q30_ONE, 0}}, at_b = {{whorl_point.x, whorl_point.z}, {GJK_Q30_ONE, 0}};
  const gjk2_motion still = {at_a, at_a, 0}, rests = {at_b, at_b, 0};
  const gjk2_impact_setup setup = {0, GJK2_IMPACT_TOLERANCE_MIN, 0};
  uint16_t segment = 77;
  bool yes = true;
  memset(&depth, POISON, sizeof depth);
  memset(&m, POISON, sizeof m);
  CHECK(gjk2_intersect(&a, &b, NULL, &touch) == GJK_ERROR_ITERATION_LIMIT && touch.iterations == GJK_ITERATIONS_MAX);
  CHECK(gjk2_distance(&a, &b, NULL, &gap) == GJK_ERROR_ITERATION_LIMIT && gap.lower == 0 && gap.upper > 0);
  CHECK(gjk2_signed_distance(&a, &b, NULL, &deep) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(deep.lower <= 0 && deep.upper == gap.upper && deep.iterations == GJK_ITERATIONS_MAX);
  CHECK(gjk2_penetration(&a, &b, NULL, &depth) == GJK_ERROR_ITERATION_LIMIT && is_untouched(&depth, sizeof depth));
  CHECK(gjk2_contacts(&a, &b, 0, 2, NULL, &m) == GJK_ERROR_ITERATION_LIMIT && is_untouched(&m, sizeof m));
  memset(&cast, POISON, sizeof cast);
  CHECK(gjk2_cast(&a, &b, &path, &cast) == GJK_ERROR_ITERATION_LIMIT && is_untouched(&cast, sizeof cast));
  CHECK(gjk2_time_of_impact(&a, &still, &b, &rests, &setup, &impact) == GJK_ERROR_ITERATION_LIMIT);
  CHECK(!impact.hit && impact.lower == 0 && impact.upper == GJK_Q30_ONE);
  CHECK(gjk2_chain_init(&chain, level, 2, &origin) == GJK_OK);
  memset(&gap, POISON, sizeof gap);
  CHECK(gjk2_chain_intersect(&chain, &c, NULL, &yes, &segment) == GJK_ERROR_ITERATION_LIMIT && yes);
  CHECK(gjk2_chain_distance(&chain, &c, NULL, &gap, &segment) == GJK_ERROR_ITERATION_LIMIT && segment == 77);
  CHECK(is_untouched(&gap, sizeof gap));
}

int main(void) {
  static plane_body pair[2], exact;
  const int32_t sizes[] = {3, 40, 1000, 65536, 1 << 20};
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    const int32_t size = sizes[random_below(&r, 5)];
    check_trial(i, NULL, NULL);
    plane_random_pair(&r, size, (int32_t)((int64_t)size * random_range(&r, 0, 4) / 2), pair);
    check_circle(&r, pair, &exact, size);
    if (i % 4 == 0) {
      pair[0].shape = (gjk2_shape)GJK2_ROUNDED_ELLIPSE(random_range(&r, 0, size), random_range(&r, 0, size), 3);
      plane_place(&pair[0], false);
      check_efforts(&r, &pair[0].collider, &pair[1].collider);
    }
  }
  check_unsettled();
  printf("apart %lu, together %lu, capacity %lu; distance off %d, depth off %d, most iterations %u\n", tally.apart,
         tally.together, tally.capacity, tally.distance, tally.depth, tally.iterations);
  CHECK(tally.apart > TRIALS / 10 && tally.together > TRIALS / 10 && tally.capacity < TRIALS / 20);
  return check_done("plane_curved");
}
