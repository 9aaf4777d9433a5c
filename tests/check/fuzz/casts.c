// Makes a pair of shapes, ways and a forged claim from bytes. Every cast of polytopes must be the oracle's, the check of
// casts must refuse what is false, and other answers must agree with each other. With GJK_FUZZ_PRINT set, the case is
// printed first, for the query tool.
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "exact/cast_claim.h"

// The oracle takes a part of a millisecond for so many vertices.
#define VERTICES 14

static case_pair pair;
static case_collider a, b;
static exact_cast exact;
static char why[160];

static void expect(bool holds, const char *what) {
  if (!holds) {
    case_print(stderr, &pair);
    fprintf(stderr, "fuzz: %s\n", why);
    fuzz_fail(what);
  }
}

// A way, as the bytes say or short.
static void fuzz_way(fuzz_bytes *bytes, case_shape *shape) {
  const uint8_t how = fuzz_u8(bytes);
  gjk_vec3 to = fuzz_vec3(bytes);
  if ((how & 1u) != 0) {
    to.x = (int32_t)(((int64_t)shape->pose.position.x + to.x % 65536) % INT32_MAX);
    to.y = (int32_t)(((int64_t)shape->pose.position.y + to.y % 65536) % INT32_MAX);
    to.z = (int32_t)(((int64_t)shape->pose.position.z + to.z % 65536) % INT32_MAX);
  }
  if ((how & 6u) != 0) {
    case_shape_move_to(shape, &to);
  }
}

// Overwrites a part of a claim.
static void forge(fuzz_bytes *bytes, gjk_cast_result *claim) {
  for (unsigned n = fuzz_u8(bytes) % 4u; n > 0; n--) {
    const int32_t value = fuzz_i32(bytes);
    switch (fuzz_u8(bytes) % 10u) {
      case 0: claim->hit = !claim->hit; break;
      case 1: claim->inside = !claim->inside; break;
      case 2: claim->fraction = claim->fraction + value % 4; break;
      case 3: claim->fraction = value; break;
      case 4: claim->rest_b.x += value % 4; break;
      case 5: claim->normal.y = value; break;
      case 6: claim->certificate.proof = (uint8_t)(value & 7); break;
      case 7: claim->certificate.count = (uint8_t)(value & 3); break;
      case 8: claim->certificate.a[value & 1] = (uint16_t)((value >> 8) % 32); break;
      default: claim->certificate.direction.z = value; break;
    }
  }
}

// What the check accepts of a polytope's cast must be so: hit or miss, and the fraction.
static void check_claim(fuzz_bytes *bytes, const gjk_cast_path *path, const gjk_cast_result *right) {
  gjk_cast_result claim = *right;
  forge(bytes, &claim);
  if (gjk_check_cast(&a.collider, &b.collider, path, &claim) == GJK_OK) {
    const exact_cast_truth *truth = &exact.truth;
    const bool same = claim.hit == truth->hit && (!claim.hit || claim.fraction == truth->fraction);
    expect(same, "gjk_check_cast accepts a false claim");
  }
}

// At their places of rest the shapes are at least the margin apart.
static void check_rest(const gjk_cast_path *path, const gjk_cast_result *r, bool round) {
  gjk_collider at_a = a.collider, at_b = b.collider;
  gjk_distance_result gap;
  if (r->inside) {
    return;
  }
  expect(gjk_collider_move(&at_a, &r->rest_a) == GJK_OK && gjk_collider_move(&at_b, &r->rest_b) == GJK_OK,
         "a place of rest is refused");
  if (gjk_distance(&at_a, &at_b, NULL, &gap) == GJK_OK && !round && path->margin > 0) {
    snprintf(why, sizeof why, "the gap at rest is %ld", (long)gap.distance);
    // Far apart, the margin is met to within 2 LSB, and the gap is measured to within 2^-28.
    const gjk_q16 off = exact_is_far(&at_a, &at_b) ? 2 + (path->margin >> 28) : 0;
    expect(gap.distance >= path->margin - off, "too near at rest");
    why[0] = '\0';
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  fuzz_pair(&bytes, &pair);
  fuzz_way(&bytes, &pair.a);
  fuzz_way(&bytes, &pair.b);
  const uint8_t how = fuzz_u8(&bytes);
  const gjk_q16 margin = (how & 3u) == 0 ? (fuzz_i32(&bytes) & INT32_MAX) >> (how >> 3) : 0;
  if ((how & 4u) == 0) {
    pair.a.convex_radius = pair.b.convex_radius = 0;
  }
  if (getenv("GJK_FUZZ_PRINT") != NULL) {
    case_print(stdout, &pair);
    fflush(stdout);
  }
  if (!case_pair_build(&pair, false, &a, &b)) {
    return 0;
  }
  why[0] = '\0';
  const gjk_cast_path path = case_path(&pair, margin), back = {.to_a = path.to_b, .to_b = path.to_a, .margin = margin};
  const unsigned count_a = exact_vertex_count(&a.collider), count_b = exact_vertex_count(&b.collider);
  const bool polytopes = count_a > 0 && count_b > 0;
  gjk_cast_result r = {0}, reversed = {0};
  const gjk_status status = gjk_cast(&a.collider, &b.collider, &path, &r);
  if (!exact_cast_is_in_range(&a.collider, &b.collider, &path, &exact)) {
    expect(status == GJK_ERROR_RANGE, "out of range");
    return 0;
  }
  expect(status == GJK_OK || (!polytopes && status == GJK_ERROR_ITERATION_LIMIT), "status of gjk_cast");
  if (status != GJK_OK) {
    return 0;
  }
  expect(!r.hit || (r.fraction >= 0 && r.fraction <= GJK_Q30_ONE), "the fraction's range");
  if (r.hit) {
    check_rest(&path, &r, !polytopes);
  }
  if (!polytopes) {
    return 0;
  }
  // Between centres that are too far apart for a decision to be exact, each way around is right for a margin of its own.
  const bool exactly = gjk_check_cast(&a.collider, &b.collider, &path, &r) != GJK_ERROR_UNSUPPORTED;
  expect(gjk_cast(&b.collider, &a.collider, &back, &reversed) == GJK_OK && (reversed.hit == r.hit || !exactly),
         "reversed");
  const bool few = count_a + count_b <= VERTICES || (count_a == 8 && count_b == 8);
  if (few && exact_cast_set(&a.collider, &b.collider, &path, &exact)) {
    expect(exact_check_cast(&exact, &r, why, sizeof why), "gjk_cast");
    expect(gjk_check_cast(&a.collider, &b.collider, &path, &r) == GJK_OK, "gjk_check_cast");
    expect(!r.hit || reversed.fraction == r.fraction, "reversed, the fraction");
    check_claim(&bytes, &path, &r);
  }
  return 0;
}
