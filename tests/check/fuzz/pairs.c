// Makes a pair of shapes, queries and caches from bytes. Every answer about polytopes must pass the exact oracle, and
// the answers must agree. With GJK_FUZZ_PRINT set, the pair is printed first, as a case of the query tool.
#include <stdlib.h>

#include "bytes.h"
#include "exact/exact.h"
#include "generate/prism.h"
#include "overlap.h"

// Prisms have up to so many sides more than 3.
#define SIDES (GENERATE_SIDES_MAX - 2)

static case_pair pair;
static case_collider a, b;
static char why[160];

static void expect(bool holds, const char *what) {
  if (!holds) {
    case_print(stderr, &pair);
    fprintf(stderr, "fuzz: %s\n", why);
    fuzz_fail(what);
  }
}

static gjk_distance_result check_distance(gjk_cache *cache, bool certain) {
  gjk_distance_result r;
  expect(gjk_distance(&a.collider, &b.collider, cache, &r) == GJK_OK, "status of gjk_distance");
  if (certain) {
    expect(exact_check_distance(&a.collider, &b.collider, &r, why, sizeof why), "gjk_distance");
    const gjk_status status = gjk_check_distance(&a.collider, &b.collider, &r);
    expect(status == (exact_is_far(&a.collider, &b.collider) ? GJK_ERROR_UNSUPPORTED : GJK_OK), "gjk_check_distance");
  }
  return r;
}

static bool check_within(gjk_q16 distance, gjk_cache *cache, bool certain) {
  gjk_decision d;
  expect(gjk_within(&a.collider, &b.collider, distance, cache, &d) == GJK_OK, "status of gjk_within");
  if (certain) {
    expect(exact_check_decision(&a.collider, &b.collider, distance, &d, why, sizeof why), "gjk_within");
  }
  return d.yes;
}

// Checks shapes of few vertices by brute force.
static void check_truth(const gjk_distance_result *r) {
  if (!exact_is_far(&a.collider, &b.collider) &&
      exact_vertex_count(&a.collider) * exact_vertex_count(&b.collider) <= 16) {
    exact_truth truth;
    exact_brute(&a.collider, &b.collider, &truth);
    expect(exact_truth_distance(&truth, &a.collider, &b.collider) == r->distance, "distance, by brute force");
    expect(exact_truth_within(&truth, &a.collider, &b.collider, 0) == r->intersecting, "decision, by brute force");
  }
}

// Makes some hulls prisms with faces.
static void make_prism(unsigned what, case_shape *shape) {
  const unsigned sides = what & 7u;
  if (shape->kind == CASE_HULL && sides > 0 && sides <= SIDES) {
    generate_prism(sides + 2, shape);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  fuzz_pair(&bytes, &pair);
  const uint8_t prisms = fuzz_u8(&bytes);
  make_prism(prisms, &pair.a);
  make_prism(prisms >> 4, &pair.b);
  if (getenv("GJK_FUZZ_PRINT") != NULL) {
    case_print(stdout, &pair);
    fflush(stdout);
  }
  if (!case_pair_build(&pair, false, &a, &b)) {
    return 0;
  }
  why[0] = '\0';
  const bool certain = exact_vertex_count(&a.collider) > 0 && exact_vertex_count(&b.collider) > 0;
  const gjk_q16 asked = fuzz_i32(&bytes) & INT32_MAX;
  gjk_cache cache = fuzz_cache(&bytes), other = fuzz_cache(&bytes);
  const gjk_distance_result cold = check_distance(NULL, certain), warm = check_distance(&cache, certain);
  expect(cold.intersecting == warm.intersecting && cold.distance == warm.distance, "distance with a cache");
  expect(check_within(asked, NULL, certain) == check_within(asked, &other, certain), "gjk_within with a cache");
  expect(check_within(0, NULL, certain) == cold.intersecting || !certain, "gjk_within 0");
  check_within(cold.distance, &cache, certain);
  const char *wrong = fuzz_check_overlap(&a.collider, &b.collider, &cold, &bytes, why, sizeof why);
  expect(wrong == NULL, wrong);
  if (certain) {
    check_truth(&cold);
    if (case_collider_build(&b, &pair.b, true) == GJK_OK) {
      const gjk_distance_result lazy = check_distance(NULL, false);
      expect(lazy.distance == cold.distance && lazy.intersecting == cold.intersecting, "lazy");
    }
  }
  return 0;
}
