// gjk2_intersect, gjk2_within and gjk2_distance against brute force: every decision, every LSB of a distance.
#include "plane.h"

#define SEED 2001
#define TRIALS check_trials(60000)

static struct { unsigned long apart, together, iterations_most; } tally;

static void check_points(const plane_body *pair, const gjk2_distance_result *out, const plane_truth *truth) {
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  const long double from_a = plane_distance_from(a, &out->point_a) - a->shape->convex_radius;
  const long double from_b = plane_distance_from(b, &out->point_b) - b->shape->convex_radius;
  CHECK_MSG(from_a <= 1.0L, "%Lf", from_a);
  CHECK_MSG(from_b <= 1.0L, "%Lf", from_b);
  const long double x = (long double)out->point_b.x - out->point_a.x, y = (long double)out->point_b.y - out->point_a.y;
  CHECK_MSG(fabsl(hypotl(x, y) - out->distance) <= 2.5L, "%Lf, %d", hypotl(x, y), out->distance);
  // The normal: the support of A - B along it is as far below the origin as the distance of the cores.
  const long double n = hypotl(out->normal.x, out->normal.y);
  CHECK_MSG(fabsl(n - 1073741824.0L) <= 4, "%Lf", n);
  long double most = -INFINITY;
  for (int i = 0; i < truth->count; i++) {
    const long double along =
        (truth->hull[i].x * (long double)out->normal.x + truth->hull[i].y * (long double)out->normal.y) / n;
    most = along > most ? along : most;
  }
  const long double gap = (long double)out->distance + a->shape->convex_radius + b->shape->convex_radius;
  CHECK_MSG(-most >= gap - 0.51L - ldexpl(gap, -28) - ldexpl(a->radius + b->radius, -28), "%Lf %Lf", -most, gap);
}

static void check_pair(random_state *r, plane_body *pair) {
  static plane_truth truth;
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  const int64_t radii = (int64_t)a->shape->convex_radius + b->shape->convex_radius;
  plane_truth_of(a, b, &truth);
  const bool together = truth.overlap || (radii > 0 && plane_compare_distance(&truth, 2 * radii) <= 0);
  gjk2_decision decision;
  gjk2_distance_result out;
  CHECK(gjk2_intersect(a, b, NULL, &decision) == GJK_OK);
  CHECK(decision.yes == together);
  CHECK(gjk2_distance(a, b, NULL, &out) == GJK_OK);
  CHECK(out.intersecting == together);
  CHECK(out.iterations <= GJK2_ITERATIONS_OF(a->count, b->count));
  CHECK(decision.iterations <= GJK2_ITERATIONS_OF(a->count, b->count));
  tally.iterations_most = out.iterations > tally.iterations_most ? out.iterations : tally.iterations_most;
  tally.together += together;
  tally.apart += !together;
  CHECK(out.lower == out.distance && out.upper == out.distance && !out.saturated);
  if (together) {
    CHECK(out.distance == 0);
    return;
  }
  const int64_t twice = 2 * (out.distance + radii);
  CHECK_MSG(plane_compare_distance(&truth, twice - 1) >= 0, "%d too far", out.distance);
  CHECK_MSG(plane_compare_distance(&truth, twice + 1) < 0, "%d too near", out.distance);
  check_points(pair, &out, &truth);
  // Within: the distance rounded to the nearest LSB, one less and one more.
  for (gjk_q16 asked = out.distance - 1; asked <= out.distance + 1; asked++) {
    if (asked >= 0) {
      CHECK(gjk2_within(a, b, asked, NULL, &decision) == GJK_OK);
      CHECK(decision.yes == (plane_compare_distance(&truth, 2 * (asked + radii)) <= 0));
    }
  }
  const gjk_q16 asked = random_range(r, 0, 2 * out.distance);
  CHECK(gjk2_within(a, b, asked, NULL, &decision) == GJK_OK);
  CHECK(decision.yes == (plane_compare_distance(&truth, 2 * (asked + radii)) <= 0));
}

int main(void) {
  static plane_body pair[2];
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, plane_print, pair);
    plane_any_pair(&r, 4, pair);
    check_pair(&r, pair);
  }
  printf("apart %lu, together %lu, most iterations %lu\n", tally.apart, tally.together, tally.iterations_most);
  CHECK(tally.apart > TRIALS / 5 && tally.together > TRIALS / 5);
  return check_done("plane_distance");
}
