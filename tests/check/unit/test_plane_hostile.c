// What must never matter, and what must never happen: small efforts, ties, tiny polygons turned by many angles, far apart and
// at the ends of the world, refused arguments.
#include "plane.h"

#define SEED 2008
#define TRIALS check_trials(20000)
#define EFFORTS check_trials(10000)
#define FAR_PAIRS check_trials(20000)

static struct {
  unsigned long open, far, saturated;
  long double far_error;
} tally;

static void random_cache(random_state *r, gjk2_cache *cache) {
  const uint32_t most = random_below(r, 2) == 0 ? 5 : 70000;
  cache->direction[0] = (int16_t)random_range(r, -40, 40);
  cache->direction[1] = (int16_t)random_range(r, -32768, 32767);
  cache->count = (uint16_t)random_below(r, 4);
  for (int i = 0; i < 2; i++) {
    cache->a[i] = (uint16_t)random_below(r, most);
    cache->b[i] = (uint16_t)random_below(r, most);
  }
}

// Tiny polygons at many angles: what posing does to their order is of no account.
static void check_tiny(random_state *r, plane_body *pair) {
  static plane_truth truth;
  gjk2_penetration_result out;
  for (int i = 0; i < 2; i++) {
    const int32_t size = random_range(r, 1, 6);
    uint16_t count = (uint16_t)random_range(r, 3, 12);
    for (int k = 0; k < count; k++) {
      pair[i].vertices[k] = plane_random_vec(r, size);
    }
    CHECK(gjk2_polygon_order(pair[i].vertices, count, pair[i].vertices, &count) == GJK_OK);
    pair[i].shape = (gjk2_shape)GJK2_POLYGON(pair[i].vertices, count);
    pair[i].pose.position.x = i * random_range(r, -6, 6);
    pair[i].pose.position.y = 0;
  }
  for (int turn = 0; turn < 16; turn++) {
    for (int i = 0; i < 2; i++) {
      CHECK(gjk2_rotation_from_angle(turn * 25736 + random_range(r, -9, 9), &pair[i].pose.rotation) == GJK_OK);
      plane_place(&pair[i], turn % 2 == 0);
    }
    plane_truth_of(&pair[0].collider, &pair[1].collider, &truth);
    CHECK(gjk2_penetration(&pair[0].collider, &pair[1].collider, NULL, &out) == GJK_OK);
    CHECK(out.intersecting == truth.overlap);
    if (out.intersecting) {
      CHECK(plane_compare_depth(&truth, out.depth) <= 0 && plane_compare_depth(&truth, out.depth - 1) > 0);
      CHECK(gjk2_check_penetration(&pair[0].collider, &pair[1].collider, &out) == GJK_OK);
    }
  }
}

// One to three iterations, and an error allowed: bounds of the exact answer; the same with any cache.
static void check_efforts(random_state *r, const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_distance_result full, part = {0}, again = {0};
  gjk2_within_result within;
  gjk2_cache cache;
  CHECK(gjk2_distance(a, b, NULL, &full) == GJK_OK);
  for (uint8_t n = 1; n <= 6; n++) {
    const gjk2_effort effort = {n < 4 ? n : 0, n < 4 ? 0 : (gjk_q16)(1 << (4 * n - 8))};
    random_cache(r, &cache);
    CHECK(gjk2_distance_until(a, b, &effort, NULL, &part) == GJK_OK);
    CHECK(gjk2_distance_until(a, b, &effort, &cache, &again) == GJK_OK);
    CHECK(part.lower == again.lower && part.upper == again.upper && part.iterations == again.iterations);
    CHECK(part.lower <= full.distance && part.upper >= full.distance);
    CHECK(n > 3 || part.iterations <= n);
    CHECK(n < 4 || part.upper - part.lower <= effort.error);
    CHECK(!part.intersecting || full.intersecting);
    if (!part.intersecting) {
      const long double x = (long double)part.point_b.x - part.point_a.x,
                        y = (long double)part.point_b.y - part.point_a.y;
      // Of shapes that overlap the feature may lie within the convex radii: then the points say nothing.
      CHECK(part.upper == 0 || fabsl(hypotl(x, y) - part.distance) <= 2.5L);
      CHECK(part.distance <= part.upper && part.distance >= part.upper - 1);
      tally.open += part.lower != part.upper;
    }
    const gjk_q16 asked = random_range(r, 0, full.distance < 1 << 30 ? 2 * full.distance : 1 << 30);
    CHECK(gjk2_within_until(a, b, asked, n < 4 ? n : 0, &cache, &within) == GJK_OK);
    const gjk2_answer truth = full.distance < asked ? GJK2_ANSWER_YES : GJK2_ANSWER_NO;
    CHECK(within.answer == truth || full.distance == asked || (n < 4 && within.answer == GJK2_ANSWER_OPEN));
    CHECK(within.answer == GJK2_ANSWER_OPEN || gjk2_check_decision(a, b, asked, &within.decision) == GJK_OK);
  }
}

// Positions anywhere: distances to 2^-28, points as far apart, no false touch.
static void check_far(random_state *r, plane_body *pair) {
  static plane_truth truth;
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  for (int i = 0; i < 2; i++) {
    plane_random_shape(r, INT32_C(1) << random_below(r, 27), &pair[i]);
    pair[i].pose.rotation = plane_random_rotation(r);
    pair[i].pose.position.x = 0;
    pair[i].pose.position.y = 0;
    plane_place(&pair[i], true);
    pair[i].pose.position = (gjk2_vec){random_below(r, 4) == 0   ? INT32_MAX
                                       : random_below(r, 3) == 0 ? INT32_MIN
                                                                 : (int32_t)random_u32(r),
                                       random_below(r, 4) == 0 ? INT32_MIN : (int32_t)random_u32(r)};
    if (gjk2_collider_pose(&pair[i].collider, &pair[i].pose) != GJK_OK) {
      return;
    }
  }
  const int64_t radii = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  plane_truth_of(a, b, &truth);
  long double least = INFINITY;
  for (int i = 0; i < truth.count; i++) {
    const plane_point p = truth.hull[i], q = truth.hull[(i + 1) % truth.count];
    const long double x = q.x - p.x, y = q.y - p.y, length = x * x + y * y;
    long double t = length > 0 ? -(p.x * x + p.y * y) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    const long double distance = hypotl(p.x + t * x, p.y + t * y);
    least = distance < least ? distance : least;
  }
  least -= radii;
  gjk2_distance_result out;
  gjk2_penetration_result depth;
  gjk2_decision yes;
  const bool near =
      hypotl((long double)a->centre.x - b->centre.x, (long double)a->centre.y - b->centre.y) <= 1073741824.0L;
  CHECK(gjk2_distance(a, b, NULL, &out) == GJK_OK);
  CHECK(gjk2_intersect(a, b, NULL, &yes) == GJK_OK && yes.yes == out.intersecting);
  if (near) {
    CHECK(gjk2_check_distance(a, b, &out) == GJK_OK);
    CHECK(gjk2_penetration(a, b, NULL, &depth) == GJK_OK);
    CHECK(gjk2_check_penetration(a, b, &depth) == GJK_OK);
    return;
  }
  tally.far++;
  CHECK(!out.intersecting);
  CHECK(gjk2_check_distance(a, b, &out) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk2_check_decision(a, b, 0, &yes) == GJK_OK);
  if (out.distance == GJK2_DISTANCE_MAX) {
    CHECK(out.saturated && least >= 2147483640.0L);
  } else {
    const long double error = fabsl(out.distance - least) / (least + (long double)radii);
    CHECK_MSG(ldexpl(error, 28) <= 1, "%Lf of 2^-28", ldexpl(error, 28));
    tally.far_error = error > tally.far_error ? error : tally.far_error;
  }
  tally.saturated += out.saturated;
  const gjk_q16 asked = random_range(r, 0, INT32_MAX);
  CHECK(gjk2_within(a, b, asked, NULL, &yes) == GJK_OK);
  CHECK(yes.yes == (least <= asked) || fabsl(asked - least) <= ldexpl(least + (long double)radii, -27));
  CHECK(gjk2_signed_distance(a, b, NULL, &out) == GJK_OK && !out.intersecting);
}

static void check_refused(const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_collider raw = {0};
  gjk2_decision yes;
  gjk2_within_result within;
  gjk2_distance_result line;
  gjk2_penetration_result depth;
  const gjk2_effort effort = {0, -1};
  memset(&yes, 1, sizeof yes);
  memset(&line, 1, sizeof line);
  memset(&depth, 1, sizeof depth);
  memset(&within, 1, sizeof within);
  const gjk2_decision yes_before = yes;
  const gjk2_distance_result line_before = line;
  const gjk2_penetration_result depth_before = depth;
  const gjk2_within_result within_before = within;
  CHECK(gjk2_intersect(a, &raw, NULL, &yes) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_intersect(NULL, b, NULL, &yes) == GJK_ERROR_NULL);
  CHECK(gjk2_within(a, b, -1, NULL, &yes) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_within_until(a, b, -1, 0, NULL, &within) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_distance(a, NULL, NULL, &line) == GJK_ERROR_NULL);
  CHECK(gjk2_distance(&raw, b, NULL, &line) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_distance_until(a, b, NULL, NULL, &line) == GJK_ERROR_NULL);
  CHECK(gjk2_distance_until(a, b, &effort, NULL, &line) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_signed_distance(&raw, b, NULL, &line) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_penetration(&raw, b, NULL, &depth) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_penetration(a, b, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_check_decision(a, b, -1, &yes) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_check_distance(a, &raw, &line) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_check_penetration(a, b, NULL) == GJK_ERROR_NULL);
  CHECK(memcmp(&yes, &yes_before, sizeof yes) == 0 && memcmp(&line, &line_before, sizeof line) == 0);
  CHECK(memcmp(&depth, &depth_before, sizeof depth) == 0 && memcmp(&within, &within_before, sizeof within) == 0);
}

// Equal boxes in line, equal faces, and copies in the same place: exact ties.
static void check_ties(plane_body *pair) {
  const gjk2_shape box = GJK2_BOX(1000, 1000), ball = GJK2_CIRCLE(500), point = GJK2_POINT;
  gjk2_penetration_result out;
  for (int i = 0; i < 2; i++) {
    memset(&pair[i].pose, 0, sizeof pair[i].pose);
    pair[i].pose.rotation.c = GJK_Q30_ONE;
    pair[i].shape = box;
    plane_place(&pair[i], false);
  }
  for (int32_t x = -2001; x <= 2001; x += 1) {
    const gjk2_vec at = {x, x};
    const int32_t depth = 2000 - (x < 0 ? -x : x);
    CHECK(gjk2_collider_move(&pair[1].collider, &at) == GJK_OK);
    CHECK(gjk2_penetration(&pair[0].collider, &pair[1].collider, NULL, &out) == GJK_OK);
    CHECK(out.intersecting == (depth >= 0));
    CHECK(depth < 0 || out.depth == depth);
  }
  pair[0].shape = ball;
  pair[1].shape = ball;
  plane_place(&pair[0], false);
  plane_place(&pair[1], false);
  CHECK(gjk2_penetration(&pair[0].collider, &pair[1].collider, NULL, &out) == GJK_OK);
  CHECK(out.depth == 1000 && out.certificate.proof == GJK2_PROOF_LINE);
  CHECK(gjk2_check_penetration(&pair[0].collider, &pair[1].collider, &out) == GJK_OK);
  pair[1].shape = point;
  pair[0].shape = point;
  plane_place(&pair[0], false);
  plane_place(&pair[1], false);
  CHECK(gjk2_penetration(&pair[0].collider, &pair[1].collider, NULL, &out) == GJK_OK);
  CHECK(out.intersecting && out.depth == 0);
}

// Sizes that a segment or a point does not have, in a shape that no initialiser made, are not looked at.
static void check_stray_sizes(plane_body pair[2]) {
  const gjk2_shape shapes[2] = {GJK2_SEGMENT(5000), GJK2_CIRCLE(700)};
  for (int kind = 0; kind < 2; kind++) {
    gjk2_penetration_result out[2];
    gjk2_aabb box[2];
    for (int stray = 0; stray < 2; stray++) {
      const gjk2_shape segment = GJK2_SEGMENT(3000);
      pair[0].shape = shapes[kind];
      pair[0].shape.size.y = stray * 900;
      pair[0].shape.size.x += kind == 1 ? stray * 900 : 0;
      pair[1].shape = segment;
      const gjk2_pose at[2] = {{{0, 0}, {GJK_Q30_ONE, 0}}, {{100, 200}, {0, GJK_Q30_ONE}}};
      for (int i = 0; i < 2; i++) {
        pair[i].pose = at[i];
        plane_place(&pair[i], false);
      }
      CHECK(gjk2_collider_aabb(&pair[0].collider, &box[stray]) == GJK_OK);
      CHECK(gjk2_penetration(&pair[0].collider, &pair[1].collider, NULL, &out[stray]) == GJK_OK);
      CHECK(gjk2_check_penetration(&pair[0].collider, &pair[1].collider, &out[stray]) == GJK_OK);
    }
    CHECK(out[0].intersecting && out[0].depth > 0 && out[1].depth == out[0].depth);
    CHECK(box[0].lower.x == box[1].lower.x && box[0].lower.y == box[1].lower.y);
  }
}

int main(void) {
  static plane_body pair[2];
  const uint64_t seed = check_seed(SEED);
  check_ties(pair);
  check_stray_sizes(pair);
  check_refused(&pair[0].collider, &pair[1].collider);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, plane_print, pair);
    plane_any_pair(&r, 3, pair);
    if (i < EFFORTS) {
      check_efforts(&r, &pair[0].collider, &pair[1].collider);
    }
    check_tiny(&r, pair);
  }
  for (unsigned long i = 0; i < FAR_PAIRS; i++) {
    random_state r = random_seed(~(seed + i));
    check_trial(i, plane_print, pair);
    check_far(&r, pair);
  }
  printf("open %lu, far %lu, saturated %lu, off by %Lf of 2^-28\n", tally.open, tally.far, tally.saturated,
         ldexpl(tally.far_error, 28));
  CHECK(tally.open > EFFORTS / 4 && tally.far > FAR_PAIRS / 4 && tally.saturated > FAR_PAIRS / 50);
  return check_done("plane_hostile");
}
