// AABBs of colliders: exact for polytopes, at most 2 LSB too large for curved shapes, saturated at the ends of int32_t.

#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"
#include "generate/polytope.h"
#include "placed.h"
#include "reference/accurate.h"
#include "reference/random_shape.h"

#define SEED 611
#define TRIALS ((int)check_trials(20000))

static gjk_q16 cut_off(int64_t x) {
  return (gjk_q16)(x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : x);
}

static bool same(const gjk_vec3 *a, const gjk_vec3 *b) {
  return a->x == b->x && a->y == b->y && a->z == b->z;
}

// The box of a collider's vertices, in the exact oracle's arithmetic.
static gjk_aabb box_of_vertices(const gjk_collider *c) {
  const int64_t radius = c->shape->convex_radius;
  int64_t low[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, high[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
  for (unsigned i = 0; i < exact_vertex_count(c); i++) {
    const exact_point p = exact_vertex(c, i);
    const int64_t at[3] = {p.x[0], p.x[1], p.x[2]};
    for (int k = 0; k < 3; k++) {
      low[k] = at[k] < low[k] ? at[k] : low[k];
      high[k] = at[k] > high[k] ? at[k] : high[k];
    }
  }
  return (gjk_aabb){{cut_off(low[0] - radius), cut_off(low[1] - radius), cut_off(low[2] - radius)},
                    {cut_off(high[0] + radius), cut_off(high[1] + radius), cut_off(high[2] + radius)}};
}

static void test_polytopes(void) {
  random_state random = random_seed(check_seed(SEED));
  case_shape shape = {0};
  case_collider c = {0};
  unsigned long cut = 0;
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    generate_polytope(&random, generate_kind(&random), generate_reach(&random), &shape);
    const bool outermost = i % 4 == 0;
    shape.convex_radius = i % 3 == 0 ? random_range(&random, 0, 65536) : 0;
    shape.pose.rotation = generate_rotation(&random);
    shape.pose.position.x = random_range(&random, outermost ? INT32_MAX - 65536 * 4 : -65536, INT32_MAX - 65536 * 4);
    shape.pose.position.y = random_range(&random, INT32_MIN / 2, INT32_MAX / 2);
    shape.pose.position.z = random_range(&random, INT32_MIN + 65536 * 4, outermost ? INT32_MIN + 65536 * 8 : 65536);
    if (case_collider_build(&c, &shape, false) != GJK_OK) {
      continue;
    }
    CHECK(c.collider.core_radius >> c.collider.bits == 0);
    CHECK(c.collider.core_radius >> (c.collider.bits - 1) == 1);
    gjk_aabb box;
    const gjk_aabb expected = box_of_vertices(&c.collider);
    CHECK(gjk_collider_aabb(&c.collider, &box) == GJK_OK);
    CHECK(same(&box.lower, &expected.lower));
    CHECK(same(&box.upper, &expected.upper));
    cut += box.upper.x == INT32_MAX || box.lower.z == INT32_MIN;
  }
  printf("%lu boxes cut off\n", cut);
  CHECK(cut > (unsigned long)TRIALS / 50);
  case_shape_free(&shape);
  case_collider_free(&c);
}

// Curved shapes at the identity rotation, whose box is known: their half extents.
static void test_curved(void) {
  static const struct {
    gjk_shape shape;
    gjk_vec3 half;
  } known[] = {{GJK_CYLINDER(1000, 3000), {1000, 1000, 3000}},
               {GJK_ROUNDED_CYLINDER(65536, 1, 500), {66036, 66036, 501}},
               {GJK_CONE(7000, 400), {7000, 7000, 400}},
               {GJK_ELLIPSOID(10, 2000, 300000), {10, 2000, 300000}},
               {GJK_ROUNDED_ELLIPSOID(10, 20, 30, 40), {50, 60, 70}}};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const gjk_pose pose = {{-5, 77, 900}, {0, 0, 0, GJK_Q30_ONE}};
    const gjk_vec3 h = known[i].half, p = pose.position;
    gjk_aabb box;
    const gjk_collider c = posed(&known[i].shape, &pose);
    CHECK(gjk_collider_aabb(&c, &box) == GJK_OK);
    const gjk_q16 excess[6] = {p.x - h.x - box.lower.x, p.y - h.y - box.lower.y, p.z - h.z - box.lower.z,
                               box.upper.x - p.x - h.x, box.upper.y - p.y - h.y, box.upper.z - p.z - h.z};
    for (int k = 0; k < 6; k++) {
      CHECK_MSG(excess[k] >= 0, "shape %lu, side %d: %ld", (unsigned long)i, k, (long)excess[k]);
      CHECK_MSG(excess[k] <= 2, "shape %lu, side %d: %ld", (unsigned long)i, k, (long)excess[k]);
    }
  }
}

int main(void) {
  test_polytopes();
  test_curved();
  return check_done("aabb");
}
