// Prints, for seeded random pairs, the status and the bounds of the distance: test_limit.sh compares a build with a low
// ceiling on rounds with one that has the usual ceiling.
#include <stdio.h>

#include "gjk/gjk.h"
#include "random.h"

#define PAIRS 4000
#define VERTICES 24

static gjk_vec3 vertices[2][VERTICES];

static void make(random_state *random, int i, int32_t size, gjk_shape *shape, gjk_collider *collider) {
  const gjk_shape kinds[] = {GJK_HULL(vertices[i], VERTICES), GJK_BOX(size, size / 2 + 1, size / 3 + 1),
                             GJK_CYLINDER(size / 2 + 1, size), GJK_ELLIPSOID(size, size / 2 + 1, size / 5 + 1),
                             GJK_CAPSULE(size / 4 + 1, size)};
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  *shape = kinds[random_below(random, 5)];
  for (int k = 0; k < VERTICES; k++) {
    vertices[i][k].x = random_range(random, -size, size);
    vertices[i][k].y = random_range(random, -size, size);
    vertices[i][k].z = random_range(random, -size, size);
  }
  gjk_quat_normalize(&q, &pose.rotation);
  pose.position.x = random_range(random, -3 * size, 3 * size);
  pose.position.y = random_range(random, -3 * size, 3 * size);
  pose.position.z = random_range(random, -3 * size, 3 * size);
  collider->state = 0;
  gjk_collider_init(collider, shape, NULL, 0);
  gjk_collider_pose(collider, &pose);
}

int main(void) {
  random_state random = random_seed(7);
  for (int i = 0; i < PAIRS; i++) {
    const int32_t size = INT32_C(1) << (4 + random_below(&random, 22));
    gjk_shape shapes[2];
    gjk_collider a, b;
    gjk_distance_result result = {0};
    gjk_decision decision = {0};
    make(&random, 0, size, &shapes[0], &a);
    make(&random, 1, size, &shapes[1], &b);
    const gjk_status status = gjk_distance(&a, &b, NULL, &result);
    const gjk_effort full = {0, 0};
    gjk_distance_result until = {0};
    // Round by round it ends where the whole does, with bounds at least as narrow.
    if (gjk_distance_until(&a, &b, &full, NULL, &until) != status || until.iterations != result.iterations ||
        until.lower < result.lower || until.upper > result.upper) {
      printf("pair %d round by round: %ld %ld\n", i, (long)until.lower, (long)until.upper);
      return 1;
    }
    const gjk_status decided = gjk_intersect(&a, &b, NULL, &decision);
    printf("%d %d %ld %ld %d %d %d\n", i, (int)status, (long)result.lower, (long)result.upper, result.iterations,
           (int)decided, decision.yes);
  }
  return 0;
}
