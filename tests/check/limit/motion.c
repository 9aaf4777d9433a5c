// Casts and times of impact: which fields each writes after each status, and what a low ceiling on iterations leaves.
// test_limit.sh builds it with low ceilings and with the usual one.
//
// Each question is asked twice, with outputs that are filled with different bytes. A valid field must then be the same
// in both, and one that is not valid after an error as it was. The tables repeat what the public headers say.
#include <stdio.h>
#include <string.h>

#include "filled.h"
#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "random.h"

#define PAIRS 2000
#define VERTICES 12

typedef struct field {
  const char *name;
  size_t offset, size;
} field;

#define FIELD(type, member) \
  { .name = #member, .offset = offsetof(type, member), .size = sizeof(((type *)0)->member) }

// Each field of a table is a bit of the masks below it, in the order of the table.
static const field of_cast[] = {FIELD(gjk_cast_result, hit),
                                FIELD(gjk_cast_result, iterations),
                                FIELD(gjk_cast_result, certificate.proof),
                                FIELD(gjk_cast_result, certificate.count),
                                FIELD(gjk_cast_result, inside),
                                FIELD(gjk_cast_result, fraction),
                                FIELD(gjk_cast_result, normal),
                                FIELD(gjk_cast_result, rest_a),
                                FIELD(gjk_cast_result, rest_b),
                                FIELD(gjk_cast_result, saturated),
                                FIELD(gjk_cast_result, point_a),
                                FIELD(gjk_cast_result, point_b)};
enum { MISS = 15, START = 1023, HIT = 4095 };

static const field of_impact[] = {
    FIELD(gjk_impact_result, hit),        FIELD(gjk_impact_result, overlap),  FIELD(gjk_impact_result, lower),
    FIELD(gjk_impact_result, upper),      FIELD(gjk_impact_result, pose_a),   FIELD(gjk_impact_result, pose_b),
    FIELD(gjk_impact_result, iterations), FIELD(gjk_impact_result, distance), FIELD(gjk_impact_result, point_a),
    FIELD(gjk_impact_result, point_b),    FIELD(gjk_impact_result, normal)};
enum { OPEN = 127, MEASURED = 255, IMPACT = 2047 };

#define COUNT(table) (sizeof(table) / sizeof((table)[0]))
#define STATUSES 16

static unsigned long seen[2][STATUSES], hits[2], useful;
static unsigned failures;

static void expect(bool holds, const char *what) {
  if (!holds) {
    printf("failed: %s\n", what);
    failures++;
  }
}

// out: two answers, the first filled with 0xA5 before, the other with 0x5A.
static void check_fields(const field *fields, size_t count, unsigned valid, gjk_status status, const void *const out[2],
                         size_t size) {
  for (size_t k = 0; k < count; k++) {
    const field *f = &fields[k];
    const char *p = (const char *)out[0] + f->offset, *q = (const char *)out[1] + f->offset;
    const bool untouched = is_filled(p, f->size, 0xA5) && is_filled(q, f->size, 0x5A);
    if ((valid >> k & 1u) != 0 ? memcmp(p, q, f->size) != 0 : status != GJK_OK && !untouched) {
      printf("failed: %s: %s\n", gjk_status_name(status), f->name);
      failures++;
    }
  }
  expect(valid != 0 || (is_filled(out[0], size, 0xA5) && is_filled(out[1], size, 0x5A)), "something is written");
}

static gjk_status ask_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path,
                           gjk_cast_result *first) {
  gjk_cast_result out[2];
  memset(&out[0], 0xA5, sizeof out[0]);
  memset(&out[1], 0x5A, sizeof out[1]);
  const gjk_status status = gjk_cast(a, b, path, &out[0]);
  expect(gjk_cast(a, b, path, &out[1]) == status, "the status of a cast");
  seen[0][-(int)status]++;
  const unsigned valid = status == GJK_ERROR_ITERATION_LIMIT ? HIT
                         : status != GJK_OK                  ? 0
                         : !out[0].hit                       ? MISS
                         : out[0].inside                     ? START
                                                             : HIT;
  const void *const both[2] = {&out[0], &out[1]};
  check_fields(of_cast, COUNT(of_cast), valid, status, both, sizeof out[0]);
  hits[0] += status == GJK_OK && out[0].hit;
  *first = out[0];
  return status;
}

static gjk_status ask_impact(const gjk_collider *a, const gjk_motion *motion_a, const gjk_collider *b,
                             const gjk_motion *motion_b, const gjk_impact_setup *setup, gjk_impact_result *first) {
  gjk_impact_result out[2];
  memset(&out[0], 0xA5, sizeof out[0]);
  memset(&out[1], 0x5A, sizeof out[1]);
  const gjk_status status = gjk_time_of_impact(a, motion_a, b, motion_b, setup, &out[0]);
  expect(gjk_time_of_impact(a, motion_a, b, motion_b, setup, &out[1]) == status, "the status of an impact");
  seen[1][-(int)status]++;
  const bool answered = status == GJK_OK, limited = status == GJK_ERROR_ITERATION_LIMIT;
  const unsigned valid = limited                                  ? OPEN
                         : !answered                              ? 0
                         : !out[0].hit                            ? OPEN
                         : out[0].overlap || out[0].distance == 0 ? MEASURED
                                                                  : IMPACT;
  const void *const both[2] = {&out[0], &out[1]};
  check_fields(of_impact, COUNT(of_impact), valid, status, both, sizeof out[0]);
  hits[1] += answered && out[0].hit;
  expect(!limited || (!out[0].hit && !out[0].overlap && out[0].upper == GJK_Q30_ONE), "an open impact");
  expect(!(limited || answered) || (out[0].lower >= 0 && out[0].lower <= out[0].upper), "bounds of an impact");
  *first = out[0];
  return status;
}

static gjk_vec3 vertices[2][VERTICES];
static gjk_shape shapes[2];

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  v.z = random_range(random, -size, size);
  return v;
}

static void make(random_state *random, int i, int32_t size, gjk_collider *collider, gjk_motion *motion) {
  static const gjk_motion rest = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  const gjk_shape kinds[] = {GJK_HULL(vertices[i], VERTICES),
                             GJK_BOX(size, size / 2 + 1, size / 3 + 1),
                             GJK_ROUNDED_BOX(size, size / 2 + 1, size / 3 + 1, size / 9),
                             GJK_CYLINDER(size / 2 + 1, size),
                             GJK_ELLIPSOID(size, size / 2 + 1, size / 5 + 1),
                             GJK_SPHERE(size)};
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  shapes[i] = kinds[random_below(random, 6)];
  for (int k = 0; k < VERTICES; k++) {
    vertices[i][k] = random_vector(random, size);
  }
  *motion = rest;
  (void)gjk_quat_normalize(&q, &motion->from.rotation);
  motion->from.position = random_vector(random, 3 * size);
  motion->to.position = random_vector(random, size);
  if (random_below(random, 2) == 0) {
    motion->spin = random_vector(random, 400000);
  }
  memset(collider, 0, sizeof *collider);
  (void)gjk_collider_init(collider, &shapes[i], NULL, 0);
  (void)gjk_collider_pose(collider, &motion->from);
}

// Bad questions, after which nothing may be written.
static void ask_wrongly(const gjk_collider *a, const gjk_motion *motion) {
  static const gjk_collider unposed;
  const gjk_vec3 *to = &motion->to.position;
  const gjk_cast_path path = {.to_b = to}, negative = {.to_b = to, .margin = -1};
  const gjk_impact_setup narrow = {.tolerance = GJK_IMPACT_TOLERANCE_MIN - 1};
  const gjk_impact_setup inward = {.margin = -1, .tolerance = GJK_IMPACT_TOLERANCE_MIN};
  gjk_motion turned = *motion;
  gjk_cast_result cast;
  gjk_impact_result impact;
  turned.from.rotation.x = turned.from.rotation.w = 0;
  turned.from.rotation.y = turned.from.rotation.z = 12345;
  expect(ask_cast(NULL, a, &path, &cast) == GJK_ERROR_NULL && ask_cast(a, a, NULL, &cast) == GJK_ERROR_NULL, "NULL");
  expect(ask_cast(a, &unposed, &path, &cast) == GJK_ERROR_UNINITIALISED, "a cast, not posed");
  expect(ask_cast(a, a, &negative, &cast) == GJK_ERROR_NEGATIVE, "a cast, negative");
  expect(ask_impact(a, motion, NULL, motion, &inward, &impact) == GJK_ERROR_NULL, "an impact, NULL");
  expect(ask_impact(a, motion, &unposed, motion, &inward, &impact) == GJK_ERROR_UNINITIALISED, "an impact, not bound");
  expect(ask_impact(a, motion, a, motion, &inward, &impact) == GJK_ERROR_NEGATIVE, "an impact, negative");
  expect(ask_impact(a, motion, a, motion, &narrow, &impact) == GJK_ERROR_RANGE, "an impact, its tolerance");
  const gjk_impact_setup setup = {.tolerance = GJK_IMPACT_TOLERANCE_MIN};
  expect(ask_impact(a, motion, a, &turned, &setup, &impact) == GJK_ERROR_ROTATION, "an impact, its rotation");
}

int main(void) {
  random_state random = random_seed(12);
  for (int i = 0; i < PAIRS && failures < 10; i++) {
    const int32_t size = INT32_C(1) << (5 + random_below(&random, 20));
    gjk_collider a, b;
    gjk_motion motion_a, motion_b;
    gjk_cast_result cast;
    gjk_impact_result first, full;
    make(&random, 0, size, &a, &motion_a);
    make(&random, 1, size, &b, &motion_b);
    const gjk_cast_path path = {.to_a = random_below(&random, 2) == 0 ? NULL : &motion_a.to.position,
                                .to_b = &motion_b.to.position,
                                .margin = random_below(&random, 2) == 0 ? 0 : size / 32};
    (void)ask_cast(&a, &b, &path, &cast);
    gjk_impact_setup setup = {.margin = path.margin, .tolerance = GJK_IMPACT_TOLERANCE_MIN + size / 4096};
    const gjk_status status = ask_impact(&a, &motion_a, &b, &motion_b, &setup, &full);
    setup.iterations = (uint8_t)(1 + random_below(&random, 4));
    const gjk_status early = ask_impact(&a, &motion_a, &b, &motion_b, &setup, &first);
    expect(status != GJK_OK || !full.hit || (early != GJK_OK && early != GJK_ERROR_ITERATION_LIMIT) ||
               first.lower <= full.upper,
           "a lower time beyond the impact");
    useful += early == GJK_ERROR_ITERATION_LIMIT && first.lower > 0;
    if (i % 16 == 0) {
      ask_wrongly(&a, &motion_a);
    }
  }
  static const char *const names[2] = {"gjk_cast", "gjk_time_of_impact"};
  for (size_t i = 0; i < 2; i++) {
    printf("%s %lu hits", names[i], hits[i]);
    for (int status = 0; status < STATUSES; status++) {
      if (seen[i][status] > 0) {
        printf(" %s %lu", gjk_status_name((gjk_status)-status), seen[i][status]);
      }
    }
    printf("\n");
  }
  expect(hits[0] > PAIRS / 8 && hits[1] > PAIRS / 8, "the mix of pairs");
  expect(useful > PAIRS / 10, "early impacts that are bounded away from the start");
  return failures > 0;
}
