// A low ceiling on iterations in the plane: ellipses that are circles, against the circles themselves, which no ceiling
// concerns. Wherever the ceiling is reached the status says so, the bounds hold the truth, and all else is as it was.
#include <stdio.h>
#include <string.h>

#include "gjk2/gjk2.h"
#include "random.h"

#define PAIRS 6000
#define UNTOUCHED 0x5A

static unsigned long settled, limited, useful, deep, wrong;

static void expect(bool condition, const char *what) {
  if (!condition) {
    printf("wrong: %s\n", what);
    wrong++;
  }
}

static bool is_untouched(const void *p, size_t bytes) {
  const unsigned char *at = (const unsigned char *)p;
  for (size_t i = 0; i < bytes; i++) {
    if (at[i] != UNTOUCHED) {
      return false;
    }
  }
  return true;
}

static void ask(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 truth) {
  gjk2_distance_result gap, line;
  gjk2_penetration_result depth;
  gjk2_decision yes;
  gjk2_manifold manifold;
  const int32_t slack = 3, positive = truth > 0 ? truth : 0;
  memset(&gap, UNTOUCHED, sizeof gap);
  memset(&line, UNTOUCHED, sizeof line);
  memset(&depth, UNTOUCHED, sizeof depth);
  memset(&manifold, UNTOUCHED, sizeof manifold);
  memset(&yes, UNTOUCHED, sizeof yes);
  const gjk_status status = gjk2_distance(a, b, NULL, &gap);
  expect(gap.lower <= positive + slack && gap.upper >= positive - slack, "bounds of the distance");
  if (status == GJK_OK) {
    settled++;
    expect(gap.distance - positive <= slack && positive - gap.distance <= slack, "distance");
  } else {
    expect(status == GJK_ERROR_ITERATION_LIMIT && gap.iterations == GJK_ITERATIONS_MAX, "status of the distance");
    expect(gap.certificate.proof == GJK2_PROOF_NONE && !gap.intersecting, "an open distance");
    limited++;
    useful += gap.lower > 0;
  }
  const gjk_status decided = gjk2_intersect(a, b, NULL, &yes);
  if (decided == GJK_OK) {
    expect(yes.yes == (truth <= 0) || (truth <= slack && truth >= -slack), "decision");
  } else {
    expect(decided == GJK_ERROR_ITERATION_LIMIT && is_untouched(&yes.yes, 1), "status of the decision");
  }
  const gjk_status signed_status = gjk2_signed_distance(a, b, NULL, &line);
  if (signed_status == GJK_ERROR_ITERATION_LIMIT) {
    expect(line.lower <= truth + slack && line.upper >= truth - slack, "bounds of the signed distance");
    expect(is_untouched(&line.distance, sizeof line.distance), "an open signed distance");
    deep += line.upper < 0;
  } else {
    expect(line.lower <= truth + slack && line.upper >= truth - slack, "signed distance");
  }
  const gjk_status measured = gjk2_penetration(a, b, NULL, &depth);
  expect(measured != GJK_ERROR_ITERATION_LIMIT || is_untouched(&depth, sizeof depth), "an open depth");
  const gjk_status met = gjk2_contacts(a, b, 100, 2, NULL, &manifold);
  expect((met == GJK_ERROR_ITERATION_LIMIT) == (signed_status == GJK_ERROR_ITERATION_LIMIT), "status of contacts");
  expect(met != GJK_ERROR_ITERATION_LIMIT || is_untouched(&manifold, sizeof manifold), "open contacts");
}

int main(void) {
  random_state random = random_seed(4711);
  for (int i = 0; i < PAIRS; i++) {
    const int32_t size = INT32_C(1) << random_below(&random, 24), radius = random_range(&random, 1, size);
    const gjk2_shape box = GJK2_ROUNDED_BOX(random_range(&random, 0, size), random_range(&random, 0, size), size / 8);
    const gjk2_shape ellipse = GJK2_ELLIPSE(radius, radius), circle = GJK2_CIRCLE(radius);
    gjk2_pose pose = GJK2_POSE_IDENTITY;
    gjk2_collider a, b, c;
    gjk2_distance_result truth;
    memset(&a, 0, sizeof a);
    memset(&b, 0, sizeof b);
    memset(&c, 0, sizeof c);
    gjk2_rotation_from_angle(random_range(&random, -200000, 200000), &pose.rotation);
    gjk2_collider_init(&a, &box, NULL, 0);
    gjk2_collider_pose(&a, &pose);
    pose.position.x = random_range(&random, -2 * size, 2 * size);
    pose.position.y = random_range(&random, -2 * size, 2 * size);
    gjk2_collider_init(&b, &ellipse, NULL, 0);
    gjk2_collider_pose(&b, &pose);
    gjk2_collider_init(&c, &circle, NULL, 0);
    gjk2_collider_pose(&c, &pose);
    expect(gjk2_signed_distance(&a, &c, NULL, &truth) == GJK_OK, "the circle itself");
    ask(&a, &b, truth.distance);
  }
  printf("settled %lu, limited %lu, bounded away %lu, proven deep %lu\n", settled, limited, useful, deep);
  if (GJK_ITERATIONS_MAX <= 3) {
    expect(limited > PAIRS / 20 && useful > limited / 8, "the mix of pairs");
  }
  return wrong == 0 ? 0 : 1;
}
