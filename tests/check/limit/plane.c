// A low ceiling on iterations in the plane: ellipses that are circles, against the circles themselves, which no ceiling
// concerns. Wherever the ceiling is reached the status says so, the bounds hold the truth, and all else is as it was.
#include <stdio.h>
#include <string.h>

#include "filled.h"
#include "gjk2/gjk2.h"
#include "gjk2/ground.h"
#include "random.h"

#define PAIRS 6000

static unsigned long settled, limited, useful, deep, open_lines, open_gaps, open_contacts, open_depths, wrong;

static void expect(bool condition, const char *what) {
  if (!condition) {
    printf("wrong: %s\n", what);
    wrong++;
  }
}

static void ask(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 truth) {
  gjk2_distance_result gap, line;
  gjk2_penetration_result depth;
  gjk2_decision yes;
  gjk2_manifold manifold;
  const int32_t slack = 3, positive = truth > 0 ? truth : 0;
  memset(&gap, POISON, sizeof gap);
  memset(&line, POISON, sizeof line);
  memset(&depth, POISON, sizeof depth);
  memset(&manifold, POISON, sizeof manifold);
  memset(&yes, POISON, sizeof yes);
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

// Chains: what does not settle is not told, and what is told is as of the circle.
static void ask_chain(random_state *random, int32_t size, const gjk2_collider *ellipse, const gjk2_collider *circle) {
  const gjk2_vec origin = {0, 0};
  gjk2_vec line[4];
  gjk2_chain chain;
  gjk2_chain_contact contacts[8];
  gjk2_distance_result gap, truth;
  bool yes[2];
  uint16_t segment, count = 77;
  memset(&chain, 0, sizeof chain);
  memset(&gap, POISON, sizeof gap);
  memset(yes, POISON, sizeof yes);
  memset(&segment, POISON, sizeof segment);
  for (int i = 0; i < 4; i++) {
    line[i].x = random_range(random, -2 * size, 2 * size);
    line[i].y = random_range(random, -2 * size, 2 * size);
  }
  if (gjk2_chain_init(&chain, line, 4, &origin) != GJK_OK) {
    return;
  }
  const gjk_status decided = gjk2_chain_intersect(&chain, ellipse, NULL, &yes[0], &segment);
  if (decided != GJK_OK) {
    expect(decided == GJK_ERROR_ITERATION_LIMIT && is_untouched(&yes[0], 1), "an open decision of a chain");
    expect(is_untouched(&segment, sizeof segment), "its segment");
    open_lines++;
  }
  expect(gjk2_chain_distance(&chain, circle, NULL, &truth, &segment) == GJK_OK, "the circle's distance from a chain");
  memset(&segment, POISON, sizeof segment);
  const gjk_status measured = gjk2_chain_distance(&chain, ellipse, NULL, &gap, &segment);
  if (measured == GJK_OK) {
    expect(gap.distance - truth.distance <= 3 && truth.distance - gap.distance <= 3, "distance from a chain");
    expect(decided != GJK_OK || yes[0] == (truth.distance == 0) || truth.distance <= 3, "decision of a chain");
  } else {
    expect(measured == GJK_ERROR_ITERATION_LIMIT && is_untouched(&gap, sizeof gap), "an open distance from a chain");
    expect(is_untouched(&segment, sizeof segment), "its segment");
    open_gaps++;
  }
  const gjk_status met = gjk2_chain_contacts(&chain, ellipse, NULL, size / 4, contacts, 8, &count);
  expect(met == GJK_OK || (met == GJK_ERROR_ITERATION_LIMIT && count == 77), "contacts with a chain");
  open_contacts += met != GJK_OK;
}

// Ground in a scene: where the depth of an ellipse is not found, what is reported is not above that of the circle. What is
// found may differ where an LSB decides which segments count.
static void ask_ground(random_state *random, int32_t size) {
  static uint32_t block[GJK2_SCENE_BYTES(3, 3, 2) / 4];
  static const gjk2_scene_config config = {.bodies = 3, .parts = 3, .pairs = 2, .detail = GJK_DETAIL_DEPTH};
  static const gjk2_scene_bindings bindings = {.details = &gjk2_scene_depth};
  const int32_t radius = random_range(random, 1, size);
  gjk2_vec line[4];
  const gjk2_polyline chain = {line, 4, NULL};
  const gjk2_shape circle = GJK2_CIRCLE(radius), ellipse = GJK2_ELLIPSE(radius, radius);
  gjk2_ground ground;
  gjk2_shape shape;
  const gjk2_shape *const shapes[3] = {&shape, &circle, &ellipse};
  gjk2_body_setup setup = {GJK2_POSE_IDENTITY, NULL, 1, GJK_BODY_STATIC, 0, 1, 2, 0, 0};
  gjk2_scene scene;
  gjk_body_id id;
  gjk2_report reports[2];
  gjk_progress progress;
  gjk_scene_stats stats;
  for (int i = 0; i < 4; i++) {
    line[i].x = random_range(random, -2 * size, 2 * size);
    line[i].y = random_range(random, -2 * size, 2 * size);
  }
  expect(gjk2_ground_of_chain(&chain, &ground, &shape) == GJK_OK, "ground");
  expect(gjk2_scene_init(&scene, &config, block, sizeof block, shapes, 3, &bindings) == GJK_OK, "a scene of ground");
  const int32_t height = random_range(random, -size, 2 * size);
  for (uint16_t i = 0; i < 3; i++) {
    const gjk2_part part = {.shape = i};
    setup.parts = &part;
    expect(gjk2_scene_add(&scene, &setup, &id) == GJK_OK, "a body of it");
    setup.pose.position.y = height;
    setup.kind = GJK_BODY_DYNAMIC;
    setup.category = 2;
    setup.mask = 1;
  }
  expect(gjk2_scene_update(&scene, reports, 2, &progress) == GJK_OK, "its update");
  expect(gjk2_scene_get_stats(&scene, &stats) == GJK_OK, "its statistics");
  if (progress.reports == 2 && stats.unsettled > 0) {
    expect(reports[1].distance <= reports[0].distance + 3, "an open depth of ground");
    open_depths += reports[1].distance < reports[0].distance - 3;
  }
}

int main(void) {
  random_state random = random_seed(4711), of_ground = random_seed(4712);
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
    ask_chain(&random, size, &b, &c);
    ask_ground(&of_ground, size);
  }
  printf("settled %lu, limited %lu, bounded away %lu, proven deep %lu; chains: %lu, %lu, %lu; ground: %lu\n", settled,
         limited, useful, deep, open_lines, open_gaps, open_contacts, open_depths);
  if (GJK_ITERATIONS_MAX <= 3) {
    expect(limited > PAIRS / 20 && useful > limited / 8, "the mix of pairs");
    expect(open_lines > 0 && open_gaps > PAIRS / 20 && open_contacts > 0, "the mix of chains");
  }
  if (GJK_ITERATIONS_MAX <= 2) {
    expect(open_depths > PAIRS / 60, "the mix of ground");
  }
  return wrong == 0 ? 0 : 1;
}
