// Support points of polytopes: from the rounded direction, and refined along the exact one. No vertex may lie farther.
// Normals are nearly across an axis or an edge, where the rounded direction hides the better vertex.
#include <string.h>

#include "check.h"
#include "exact/exact.h"
#include "generate/generate.h"
#include "generate/polytope.h"
#include "src/arith/gjk_coarse.h"
#include "src/shape/gjk_shape_class.h"

#define SEED 1717
#define TRIALS ((int)check_trials(100000))

static gjk_vec3 difference(const exact_point *a, const exact_point *b) {
  return (gjk_vec3){(int32_t)(a->x[0] - b->x[0]), (int32_t)(a->x[1] - b->x[1]), (int32_t)(a->x[2] - b->x[2])};
}

// A normal of up to 61 bits that is across an edge of the collider, or almost.
static gjk_long3 level_normal(random_state *random, const gjk_collider *c) {
  const unsigned count = exact_vertex_count(c);
  const exact_point p = exact_vertex(c, random_below(random, count)), q = exact_vertex(c, random_below(random, count));
  const gjk_vec3 edge = difference(&p, &q), other = generate_vector(random, 1 << 29);
  gjk_long3 n;
  gjk_cross(&edge, &other, &n);
  n.x += random_range(random, -1, 1);
  n.y += random_range(random, -1, 1);
  n.z += random_range(random, -1, 1);
  return n;
}

// Is the vertex the farthest along sign * n, by the integers of the exact oracle?
static bool is_farthest(const gjk_collider *c, const gjk_long3 *n, int sign, unsigned vertex) {
  const exact_int direction[3] = {exact_from(sign * n->x), exact_from(sign * n->y), exact_from(sign * n->z)};
  const exact_point best = exact_vertex(c, vertex);
  for (unsigned i = 0; i < exact_vertex_count(c); i++) {
    const exact_point p = exact_vertex(c, i);
    exact_int sum = exact_from(0);
    for (int k = 0; k < 3; k++) {
      const exact_int step = exact_from(p.x[k] - best.x[k]), product = exact_mul(&step, &direction[k]);
      sum = exact_add(&sum, &product);
    }
    if (sum.sign > 0) {
      return false;
    }
  }
  return true;
}

// The support point along sign * n, found as gjk_iteration.c finds it. moved: whether refining found a better one.
static unsigned support(const gjk_collider *c, const gjk_long3 *n, bool negated, bool *moved) {
  gjk_search_direction rounded;
  gjk_direction exact = {0};
  gjk_support found;
  gjk_search_direction_of(n, &rounded);
  exact.n = n;
  exact.spanning = 3;
  exact.opposite = negated;
  const gjk_vec3 d = negated ? gjk_negate(rounded.d) : rounded.d;
  c->shape->type->support(c, &d, &found);
  *moved = !rounded.exact && c->shape->type->refine(c, &d, &exact, &found);
  gjk_vec3 offset;
  CHECK(c->shape->type->vertex(c, found.vertex, &offset));
  CHECK(memcmp(&offset, &found.offset, sizeof offset) == 0);
  return found.vertex;
}

static void test_supports(void) {
  random_state random = random_seed(check_seed(SEED));
  case_shape shape = {0};
  case_collider c = {0}, lazy = {0};
  unsigned long refined[CASE_HULL + 1] = {0};
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const case_kind kind = generate_kind(&random);
    generate_polytope(&random, kind, i % 2 == 0 ? GENERATE_REACH_MAX / 2 : generate_reach(&random), &shape);
    if (random_below(&random, 2) == 0 && kind == CASE_HULL && shape.count > 12) {
      case_shape_set_count(&shape, 12);
    }
    shape.pose.rotation = generate_rotation(&random);
    if (case_collider_build(&c, &shape, false) != GJK_OK || case_collider_build(&lazy, &shape, true) != GJK_OK) {
      continue;
    }
    const gjk_long3 n = level_normal(&random, &c.collider);
    if ((n.x | n.y | n.z) == 0) {
      continue;
    }
    const bool negated = random_below(&random, 2) == 0;
    bool moved;
    const unsigned found = support(&c.collider, &n, negated, &moved);
    CHECK_MSG(is_farthest(&c.collider, &n, negated ? -1 : 1, found), "kind %d", (int)kind);
    refined[kind] += moved;
    const unsigned late = support(&lazy.collider, &n, negated, &moved);
    CHECK_MSG(is_farthest(&c.collider, &n, negated ? -1 : 1, late), "%s", "lazy");
  }
  printf("refined: %lu segments, %lu triangles, %lu boxes, %lu hulls\n", refined[CASE_SEGMENT], refined[CASE_TRIANGLE],
         refined[CASE_BOX], refined[CASE_HULL]);
  for (int kind = CASE_SEGMENT; kind <= CASE_HULL; kind++) {
    CHECK_MSG(TRIALS < 10000 || refined[kind] > 10, "kind %d: %lu", kind, refined[kind]);
  }
  case_shape_free(&shape);
  case_collider_free(&c);
  case_collider_free(&lazy);
}

// Coarse products against the exact ones, where their error is largest.
static void test_coarse(void) {
  random_state random = random_seed(check_seed(SEED) + 1);
  int64_t largest = 0;
  for (int i = 0; i < TRIALS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    const unsigned bits = 1 + random_below(&random, 29), d_bits = 1 + random_below(&random, 30);
    const int32_t v_most = (INT32_C(1) << bits) - 1, d_most = (INT32_C(1) << d_bits) - 1;
    gjk_vec3 v = {v_most, v_most, v_most}, d = {d_most, d_most, d_most};
    if (i % 2 == 0) {
      v.x = random_range(&random, -v_most, v_most);
      v.y = random_range(&random, -v_most, v_most);
      d.z = random_range(&random, -d_most, d_most);
    }
    const gjk_coarse c = gjk_coarse_direction(&d, bits);
    const int64_t exact = gjk_dot(&v, &d) >> (c.vertex_shift + c.shift), error = exact - gjk_coarse_dot(&c, &v);
    CHECK_MSG(error <= GJK_COARSE_ERROR, "%ld off", (long)error);
    CHECK_MSG(error >= -GJK_COARSE_ERROR, "%ld off", (long)error);
    largest = error > largest ? error : largest;
  }
  printf("coarse products: up to %ld off, %ld allowed\n", (long)largest, (long)GJK_COARSE_ERROR);
  CHECK(largest > GJK_COARSE_ERROR * 9 / 10);
}

int main(void) {
  test_supports();
  test_coarse();
  return check_done("support");
}
