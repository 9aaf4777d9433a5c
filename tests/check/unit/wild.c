// A custom shape whose support function breaks all its promises. Queries of all kinds must end without undefined
// behaviour, and the shape must stay within its bound. test_wild.sh builds it with a port that has no asserts.
#include <stdlib.h>

#include "check.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "random_vec.h"

#define SEED 20250718
#define TRIALS ((int)check_trials(4000))
#define CELLS GJK_EPA_CELLS(64)

typedef enum wildness {
  WILD_EXTREMES,  // INT32_MIN, INT32_MAX and 0, at random
  WILD_RANDOM,    // any int32
  WILD_NEAR,      // up to twice the bound per component
  WILD_CUBE,      // the corners of the bound's cube: outside its ball
  WILD_SILENT,    // nothing is written
  WILD_KINDS
} wildness;

typedef struct wild {
  wildness kind;
  gjk_q16 bound;
  random_state *random;
} wild;

static int32_t wild_component(const wild *w, int32_t along) {
  switch (w->kind) {
    case WILD_EXTREMES: {
      static const int32_t extreme[3] = {INT32_MIN, 0, INT32_MAX};
      return extreme[random_below(w->random, 3)];
    }
    case WILD_RANDOM: return random_range(w->random, INT32_MIN, INT32_MAX);
    case WILD_NEAR: return random_range(w->random, -2 * w->bound, 2 * w->bound);
    default: return along < 0 ? -w->bound : w->bound;
  }
}

static void wild_support(const void *user, const gjk_vec3 *direction, gjk_vec3 *out) {
  const wild *w = (const wild *)user;
  if (w->kind != WILD_SILENT) {
    out->x = wild_component(w, direction->x);
    out->y = wild_component(w, direction->y);
    out->z = wild_component(w, direction->z);
  }
}

static gjk_q16 random_bound(random_state *random) {
  return random_below(random, 4) == 0 ? GJK_RADIUS_MAX
                                      : random_range(random, 0, INT32_C(1) << random_below(random, 28));
}

static gjk_collider anywhere(random_state *random, const gjk_shape *shape, gjk_q16 reach) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1000)};
  gjk_quat_normalize(&q, &pose.rotation);
  pose.position = random_in_cube(random, reach);
  return posed(shape, &pose);
}

// Random support points are no shape, so a search among them may reach its ceiling.
static bool ends(gjk_status status) {
  return status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT || status == GJK_ERROR_CAPACITY;
}

static void ask_all(const gjk_collider *a, const gjk_collider *b, int trial) {
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  const gjk_effort effort = {3, 0};
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result depth;
  gjk_manifold manifold;
  gjk_aabb box;
  CHECK_MSG(ends(gjk_intersect(a, b, NULL, &decision)), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(ends(gjk_within(a, b, 1000, NULL, &decision)), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(ends(gjk_distance(a, b, NULL, &distance)), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(ends(gjk_distance_until(a, b, &effort, NULL, &distance)), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(ends(gjk_penetration(a, b, NULL, &workspace, &depth)), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(ends(gjk_signed_distance(a, b, NULL, &workspace, &distance)), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(ends(gjk_contacts(a, b, 1000, 4, NULL, &workspace, &manifold)), "trial %d, seed %d", trial, SEED);
  CHECK(gjk_collider_aabb(a, &box) == GJK_OK);
  const int64_t most = (int64_t)a->shape->size.x + a->shape->convex_radius + 4;
  CHECK_MSG((int64_t)box.upper.x - a->centre.x <= most, "trial %d, seed %d: a box beyond the bound", trial, SEED);
  CHECK_MSG((int64_t)a->centre.x - box.lower.x <= most, "trial %d, seed %d: a box beyond the bound", trial, SEED);
}

// The corners of the cube are pulled back onto the ball, so they lie as far out as the points of a ball along the
// diagonal.
static void test_pulled_back(void) {
  random_state random = random_seed(SEED);
  const gjk_q16 bounds[] = {1, 3, 1000, GJK_Q16_ONE, GJK_RADIUS_MAX};
  for (size_t i = 0; i < sizeof bounds / sizeof bounds[0]; i++) {
    const wild w = {WILD_CUBE, bounds[i], &random};
    const gjk_shape own = GJK_CUSTOM(wild_support, &w, bounds[i]), ball = GJK_SPHERE(bounds[i]), dot = GJK_POINT;
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_distance_result found, expected;
    const gjk_collider of_own = posed(&own, &pose), of_ball = posed(&ball, &pose);
    pose.position.x = pose.position.y = pose.position.z = GJK_RADIUS_MAX + bounds[i];
    const gjk_collider of_dot = posed(&dot, &pose);
    CHECK(gjk_distance(&of_own, &of_dot, NULL, &found) == GJK_OK);
    CHECK(gjk_distance(&of_ball, &of_dot, NULL, &expected) == GJK_OK);
    CHECK_MSG(labs((long)found.distance - expected.distance) <= 2, "bound %ld: %ld, not %ld", (long)bounds[i],
              (long)found.distance, (long)expected.distance);
  }
}

int main(void) {
  random_state random = random_seed(SEED);
  for (int trial = 0; trial < TRIALS; trial++) {
    wild w = {(wildness)random_below(&random, WILD_KINDS), random_bound(&random), &random}, v = w;
    v.bound = random_bound(&random);
    const gjk_q16 room = GJK_RADIUS_MAX - w.bound;
    const gjk_shape one = GJK_ROUNDED_CUSTOM(wild_support, &w, w.bound, random_range(&random, 0, room));
    const gjk_shape two = GJK_CUSTOM(wild_support, &v, v.bound);
    const gjk_shape box = GJK_BOX(w.bound / 2, w.bound / 3, 1), barrel = GJK_CYLINDER(w.bound / 2, w.bound / 3);
    const gjk_shape *const others[] = {&two, &box, &barrel, &one};
    const gjk_q16 reach = random_below(&random, 2) == 0 ? w.bound / 4 : INT32_C(1) << random_below(&random, 31);
    const gjk_collider a = anywhere(&random, &one, reach);
    const gjk_collider b = anywhere(&random, others[random_below(&random, 4)], reach);
    ask_all(&a, &b, trial);
  }
  test_pulled_back();
  return check_done("wild");
}
