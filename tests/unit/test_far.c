// Far pairs: the distance is within 2^-27 of itself also where all its errors add up. Centres just beyond 2^30 LSB apart
// along a diagonal, all coordinates odd, so that each is rounded by an LSB in the halved frame, and the largest roundings,
// which leave half the distance of the centres: found by the fuzzer, when 2^-28 was promised.
//
// In 2^-28 of the gap, which is at least 2^29: the rounded vertex 2^29 sqrt(3) 2^-29 = 0.87, the unit vector
// (sqrt(3) + 3/2) 2^-31 of up to twice the gap, 0.81, and the last rounding 0.25, together below 2.
#include <math.h>
#include <string.h>

#include "../check.h"
#include "../random.h"
#include "gjk/gjk.h"

#define SEED 5
#define PAIRS ((int)check_trials(200000))

static gjk_collider placed(const gjk_shape *shape, gjk_vec3 at) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider c;
  memset(&c, 0, sizeof c);
  pose.position = at;
  CHECK(gjk_collider_init(&c, shape, NULL, 0) == GJK_OK && gjk_collider_pose(&c, &pose) == GJK_OK);
  return c;
}

static gjk_vec3 odd_vector(random_state *random) {
  const long double x = random_range(random, 500, 1500), y = random_range(random, 500, 1500);
  const long double z = random_range(random, 500, 1500);
  const long double length = ldexpl(1 + random_range(random, 1, 1000) / 1e6L, 30) / sqrtl(x * x + y * y + z * z);
  const int32_t sign = random_below(random, 2) == 0 ? 1 : -1;
  const gjk_vec3 v = {sign * ((int32_t)(x * length) | 1), sign * ((int32_t)(y * length) | 1),
                      sign * ((int32_t)(z * length) | 1)};
  return v;
}

int main(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_RADIUS_MAX);
  const gjk_vec3 origin = {0, 0, 0};
  const gjk_collider a = placed(&ball, origin);
  random_state random = random_seed(SEED);
  long double worst = 0;
  for (int i = 0; i < PAIRS; i++) {
    const gjk_vec3 v = odd_vector(&random);
    const gjk_collider b = placed(&ball, v);
    const long double x = v.x, y = v.y, z = v.z;
    const long double gap = sqrtl(x * x + y * y + z * z) - 2.0L * GJK_RADIUS_MAX;
    gjk_distance_result r;
    CHECK(gjk_distance(&a, &b, NULL, &r) == GJK_OK && !r.intersecting);
    const long double error = fabsl((long double)r.distance - gap) / gap;
    worst = fmaxl(worst, error);
    CHECK_MSG(error <= ldexpl(1, -27), "pair %d of seed %d: %.3Lf 2^-27", i, SEED, ldexpl(error, 27));
  }
  printf("largest error %.3Lf 2^-27 of the gap\n", ldexpl(worst, 27));
  CHECK(worst > ldexpl(1, -28));
  return check_done("far");
}
