// Far pairs: the distance is within 2^-28 of itself also where all its errors add up. Centres just beyond 2^30 LSB
// apart along a diagonal, coordinates all odd or any, so that those are rounded by an LSB in the halved frame, and the
// largest convex radii, which leave half the distance of the centres.
//
// The sum, in LSB, of which a gap of at least 2^29 allows 2. Each coordinate is within 1/2 of its mean error: sqrt(3) /
// 2 together. The distance and that mean are rounded by up to 1/2 each. Together: 1.87.
#include <math.h>

#include "check.h"
#include "generate/generate.h"
#include "placed.h"
#include "random_vec.h"
#include "reference/reference.h"

#define SEED 5
#define PAIRS ((int)check_trials(200000))

// A vector with components below 2^(bits - 1) in size.
static gjk_vec3 random_vector(random_state *random, int bits) {
  return random_in_cube(random, (int32_t)((INT64_C(1) << (bits - 1)) - 1));
}

static gjk_vec3 diagonal_vector(random_state *random) {
  const long double x = random_range(random, 500, 1500), y = random_range(random, 500, 1500);
  const long double z = random_range(random, 500, 1500);
  const long double length = ldexpl(1 + random_range(random, 1, 1000) / 1e6L, 30) / sqrtl(x * x + y * y + z * z);
  const int32_t sign = random_below(random, 2) == 0 ? 1 : -1;
  const int32_t odd = random_below(random, 2) == 0;
  return (gjk_vec3){sign * ((int32_t)(x * length) | odd), sign * ((int32_t)(y * length) | odd),
                    sign * ((int32_t)(z * length) | odd)};
}

static void test_balls(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_RADIUS_MAX);
  const gjk_vec3 origin = {0, 0, 0};
  const gjk_collider a = placed(&ball, origin);
  random_state random = random_seed(check_seed(SEED));
  long double worst = 0;
  for (int i = 0; i < PAIRS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const gjk_vec3 v = diagonal_vector(&random);
    const gjk_collider b = placed(&ball, v);
    const long double x = v.x, y = v.y, z = v.z;
    const long double gap = sqrtl(x * x + y * y + z * z) - 2.0L * GJK_RADIUS_MAX;
    gjk_distance_result r;
    CHECK(gjk_distance(&a, &b, NULL, &r) == GJK_OK);
    CHECK(!r.intersecting);
    const long double error = fabsl((long double)r.distance - gap) / gap;
    worst = fmaxl(worst, error);
    CHECK_MSG(error <= ldexpl(1, -28), "%.3Lf 2^-28", ldexpl(error, 28));
  }
  printf("largest error %.3Lf 2^-28 of the gap\n", ldexpl(worst, 28));
  CHECK(worst > ldexpl(1, -29));
}

// Polytopes of every family, more than 2^30 LSB apart. The reference in double measures such distances to about 2^-45.
static void test_polytopes(void) {
  random_state random = random_seed(check_seed(SEED) + 1);
  case_pair pair = {0};
  case_collider a = {0}, b = {0};
  unsigned far[4] = {0};  // by the frame's scale
  double worst = 0;
  for (unsigned i = 0; i < check_trials(20000); i++) {
    check_trial(i, NULL, NULL);
    generate_pair(&generate_families[i % generate_family_count], random_u32(&random), &pair);
    const int bits = 30 + (int)random_below(&random, 3);
    const gjk_vec3 at = random_vector(&random, bits), at2 = random_vector(&random, bits);
    pair.a.pose.position = at;
    pair.b.pose.position = at2;
    gjk_distance_result r;
    reference_result reference;
    if (!case_pair_build(&pair, false, &a, &b) || gjk_distance(&a.collider, &b.collider, NULL, &r) != GJK_OK ||
        r.distance < INT32_C(1) << 30 || r.saturated) {
      continue;
    }
    reference_query_posed(&pair, &a, &b, &reference);
    const double error = fabs(r.distance - reference.distance) / reference.distance;
    const bool right = error <= ldexp(1, -28);
    CHECK_MSG(right, "%s: %.3f 2^-28", pair.id, ldexp(error, 28));
    if (!right) {
      case_print(stdout, &pair);
    }
    worst = fmax(worst, error);
    far[bits - 29]++;
  }
  printf("polytopes: largest error %.3f 2^-28 of the gap; %u, %u, %u pairs\n", ldexp(worst, 28), far[1], far[2],
         far[3]);
  CHECK(far[1] > 0);
  CHECK(far[2] > 0);
  CHECK(far[3] > 0);
  case_pair_release(&pair, &a, &b);
}

int main(void) {
  test_balls();
  test_polytopes();
  return check_done("far");
}
