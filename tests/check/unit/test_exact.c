// The exact oracle itself: its integers against those of the compiler, its geometry against cases worked out by hand.
#include <string.h>

#include "check.h"
#include "exact/exact.h"
#include "random.h"

__extension__ typedef __int128 wide;
__extension__ typedef unsigned __int128 unsigned_wide;

#define SEED 20011
#define ITERATIONS 100000

// A number of 0 to 63 bits, either sign; often all ones or a power of two.
static int64_t random_int64(random_state *random) {
  const unsigned bits = random_below(random, 64);
  int64_t value = bits == 0 ? 0 : (int64_t)(random_u64(random) >> (64 - bits));
  switch (random_below(random, 4)) {
    case 0: value = (int64_t)((UINT64_C(1) << bits) - 1); break;
    case 1: value = bits == 63 ? INT64_MIN : (int64_t)(UINT64_C(1) << bits); break;
    default: break;
  }
  return random_below(random, 2) == 0 && value != INT64_MIN ? -value : value;
}

static bool equals(const exact_int *a, wide value) {
  const unsigned_wide magnitude = value < 0 ? (unsigned_wide)0 - (unsigned_wide)value : (unsigned_wide)value;
  unsigned_wide sum = 0;
  for (unsigned i = a->count; i-- > 0;) {
    sum = sum << 32 | a->limb[i];
  }
  const int sign = value < 0 ? -1 : value > 0;
  return a->count <= 4 && a->sign == sign && sum == magnitude && (a->count == 0 || a->limb[a->count - 1] != 0);
}

static bool same(const exact_int *a, const exact_int *b) {
  return exact_compare(a, b) == 0 && a->sign == b->sign && a->count == b->count &&
         memcmp(a->limb, b->limb, a->count * sizeof a->limb[0]) == 0;
}

static void test_small_integers(random_state *random) {
  for (int i = 0; i < ITERATIONS; i++) {
    const int64_t p = random_int64(random), q = random_int64(random), r = random_int64(random);
    const exact_int a = exact_from(p), b = exact_from(q), c = exact_from(r);
    const exact_int product = exact_mul(&a, &b), sum = exact_add(&a, &b), difference = exact_sub(&a, &b);
    const wide halves = (wide)(p / 2) * q + (wide)(r / 2) * r;
    const exact_int p2 = exact_from(p / 2), r2 = exact_from(r / 2);
    const exact_int first = exact_mul(&p2, &b), second = exact_mul(&r2, &c), both = exact_add(&first, &second);
    CHECK_MSG(equals(&a, p), "%lld %lld %lld", (long long)p, (long long)q, (long long)r);
    CHECK_MSG(equals(&product, (wide)p * q), "%lld %lld %lld", (long long)p, (long long)q, (long long)r);
    CHECK_MSG(equals(&sum, (wide)p + q), "%lld %lld %lld", (long long)p, (long long)q, (long long)r);
    CHECK_MSG(equals(&difference, (wide)p - q), "%lld %lld %lld", (long long)p, (long long)q, (long long)r);
    CHECK_MSG(equals(&both, halves), "%lld %lld %lld", (long long)p, (long long)q, (long long)r);
    CHECK_MSG(exact_compare(&a, &b) == (p > q) - (p < q), "%lld %lld", (long long)p, (long long)q);
    const exact_int opposite = exact_negate(product);
    CHECK_MSG(exact_compare(&product, &first) == ((wide)p * q > (wide)(p / 2) * q) - ((wide)p * q < (wide)(p / 2) * q),
              "%lld %lld", (long long)p, (long long)q);
    CHECK_MSG(equals(&opposite, -((wide)p * q)), "%lld %lld", (long long)p, (long long)q);
  }
}

// (a + b)(a - b) = a a - b b and (a + b) c = a c + b c, for numbers of up to 240 bits.
static void test_large_integers(random_state *random) {
  for (int i = 0; i < ITERATIONS / 4; i++) {
    exact_int x[3];
    for (int k = 0; k < 3; k++) {
      const exact_int p = exact_from(random_int64(random)), q = exact_from(random_int64(random));
      const exact_int r = exact_from(random_int64(random)), s = exact_from(random_int64(random));
      const exact_int pq = exact_mul(&p, &q), rs = exact_mul(&r, &s), pqrs = exact_mul(&pq, &rs);
      x[k] = exact_add(&pqrs, &r);
    }
    const exact_int *a = &x[0], *b = &x[1], *c = &x[2];
    const exact_int sum = exact_add(a, b), difference = exact_sub(a, b), product = exact_mul(&sum, &difference);
    const exact_int aa = exact_mul(a, a), bb = exact_mul(b, b), squares = exact_sub(&aa, &bb);
    const exact_int ac = exact_mul(a, c), bc = exact_mul(b, c), separate = exact_add(&ac, &bc);
    const exact_int together = exact_mul(&sum, c), back = exact_sub(&sum, b), reversed = exact_mul(c, a);
    CHECK(same(&product, &squares));
    CHECK(same(&separate, &together));
    CHECK(same(&back, a));
    CHECK(same(&ac, &reversed));
    CHECK(exact_compare(&sum, a) == b->sign);
    CHECK(exact_compare(a, &sum) == -b->sign);
    const double quotient = aa.sign == 0 ? 1 : exact_to_double(&aa) / (exact_to_double(a) * exact_to_double(a));
    CHECK(quotient > 1 - 1e-14);
    CHECK(quotient < 1 + 1e-14);
  }
}

// A collider made by hand, as the library would pose it.
typedef struct hand_made {
  gjk_shape shape;
  gjk_collider collider;
  gjk_vec3 vertices[4];
} hand_made;

static void make_hull(hand_made *out, const int32_t (*vertices)[3], unsigned count, gjk_q16 convex_radius) {
  const gjk_shape shape = GJK_ROUNDED_HULL(out->vertices, (uint16_t)count, convex_radius);
  memset(&out->collider, 0, sizeof out->collider);
  out->shape = shape;
  for (unsigned i = 0; i < count; i++) {
    out->vertices[i] = (gjk_vec3){vertices[i][0], vertices[i][1], vertices[i][2]};
  }
  out->collider.shape = &out->shape;
  out->collider.buffer = out->vertices;
  out->collider.core_radius = 1000;
  out->collider.radius = 1000 + convex_radius;
}

static gjk_certificate name_pairs(gjk_proof proof, const uint16_t *a, const uint16_t *b, unsigned count) {
  gjk_certificate c;
  memset(&c, 0, sizeof c);
  c.proof = (uint8_t)proof;
  c.count = (uint8_t)count;
  memcpy(c.a, a, count * sizeof *a);
  memcpy(c.b, b, count * sizeof *b);
  return c;
}

static const int32_t triangle[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {2, 2, -10}};
static const uint16_t first_three[4] = {0, 1, 2, 3}, all_first[4] = {0, 0, 0, 0};

// A point 7 above the face of a tetrahedron: distance 7, its feature is the face.
static void test_face_by_hand(void) {
  static const int32_t point[1][3] = {{3, 3, 7}};
  char why[128];
  hand_made a, b;
  gjk_distance_result r = {0};
  make_hull(&a, triangle, 4, 0);
  make_hull(&b, point, 1, 0);
  r.distance = r.lower = r.upper = 7;
  r.point_a.x = r.point_a.y = r.point_b.x = r.point_b.y = 3;
  r.point_b.z = 7;
  r.normal.z = GJK_Q30_ONE;
  r.certificate = name_pairs(GJK_PROOF_NEAREST, first_three, all_first, 3);
  CHECK_MSG(exact_check_distance(&a.collider, &b.collider, &r, why, sizeof why), "%s", why);
  gjk_distance_result wrong = r;
  wrong.distance = wrong.lower = wrong.upper = 8;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong.distance = wrong.lower = wrong.upper = 6;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.lower = 6;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.certificate.a[1] = 3;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.certificate.b[2] = 1;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.certificate.count = 2;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.intersecting = true;
  wrong.distance = wrong.lower = wrong.upper = 0;
  CHECK(!exact_check_gap(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.point_a.z = 2;
  CHECK(!exact_check_points(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.point_b.x = 5;
  CHECK(!exact_check_points(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.normal.x = 6;
  CHECK(!exact_check_points(&a.collider, &b.collider, &wrong, why, sizeof why));
  wrong = r;
  wrong.normal.z = -GJK_Q30_ONE;
  CHECK(!exact_check_points(&a.collider, &b.collider, &wrong, why, sizeof why));
}

static bool decision_holds(const hand_made *a, const hand_made *b, gjk_q16 distance, bool yes,
                           const gjk_certificate *certificate) {
  char why[128];
  gjk_decision decision = {0};
  decision.yes = yes;
  decision.certificate = *certificate;
  return exact_check_decision(&a->collider, &b->collider, distance, &decision, why, sizeof why);
}

// The same pair with convex radii 2 and 3 is 2 apart. Each proof must hold exactly as far as it should.
static void test_proofs_by_hand(void) {
  static const int32_t point[1][3] = {{3, 3, 7}}, inside[1][3] = {{2, 2, -5}}, outside[1][3] = {{2, 2, -11}};
  hand_made a, b;
  make_hull(&a, triangle, 4, 2);
  make_hull(&b, point, 1, 3);
  gjk_certificate c = name_pairs(GJK_PROOF_NEAREST, first_three, all_first, 3);
  CHECK(decision_holds(&a, &b, 1, false, &c));
  CHECK(!decision_holds(&a, &b, 2, false, &c));
  c.proof = GJK_PROOF_NEAR;
  CHECK(decision_holds(&a, &b, 2, true, &c));
  CHECK(!decision_holds(&a, &b, 1, true, &c));
  CHECK(!decision_holds(&a, &b, 2, false, &c));
  c.proof = GJK_PROOF_DIRECTION;
  c.direction.z = 5;
  CHECK(decision_holds(&a, &b, 1, false, &c));
  CHECK(!decision_holds(&a, &b, 2, false, &c));
  c.direction.z = -5;
  CHECK(!decision_holds(&a, &b, 1, false, &c));
  c.proof = GJK_PROOF_SPHERES;
  CHECK(!decision_holds(&a, &b, 0, false, &c));
  a.collider.core_radius = 13;
  a.collider.radius = 15;
  b.collider.core_radius = 8;
  b.collider.radius = 11;
  b.collider.centre.x = 23;  // the sphere ends at 34, and at 15 for A: 26 - 7 stay clear
  CHECK(!decision_holds(&a, &b, 0, false, &c));
  b.vertices[0].y = 2;
  CHECK(!decision_holds(&a, &b, 0, false, &c));
  b.collider.centre.x = 27;
  CHECK(decision_holds(&a, &b, 0, false, &c));
  CHECK(!decision_holds(&a, &b, 1, false, &c));
  b.collider.centre.x = 0;
  c = name_pairs(GJK_PROOF_ENCLOSING, first_three, all_first, 4);
  make_hull(&b, inside, 1, 0);
  CHECK(decision_holds(&a, &b, 0, true, &c));
  CHECK(!decision_holds(&a, &b, 0, false, &c));
  c.count = 3;
  CHECK(!decision_holds(&a, &b, 0, true, &c));
  c.count = 4;
  make_hull(&b, outside, 1, 0);
  CHECK(!decision_holds(&a, &b, 0, true, &c));
}

// The origin in simplices of each size: inside, on their borders, and just outside.
static void test_enclosing(void) {
  static const struct {
    exact_point p[4];
    unsigned count;
    bool encloses;
  } cases[] = {
      {.p = {{{0, 0, 0}}}, .count = 1, .encloses = true},
      {.p = {{{0, 0, 1}}}, .count = 1, .encloses = false},
      {.p = {{{-1, -2, 3}}, {{2, 4, -6}}}, .count = 2, .encloses = true},
      {.p = {{{1, 2, 3}}, {{2, 4, 6}}}, .count = 2, .encloses = false},
      {.p = {{{-1, -2, 3}}, {{2, 4, -7}}}, .count = 2, .encloses = false},
      {.p = {{{1, 1, 0}}, {{-1, 1, 0}}, {{0, -1, 0}}}, .count = 3, .encloses = true},
      {.p = {{{1, 1, 0}}, {{-1, 1, 0}}, {{0, 1, 0}}}, .count = 3, .encloses = false},
      {.p = {{{1, 0, 0}}, {{-1, 0, 0}}, {{0, 5, 0}}}, .count = 3, .encloses = true},
      {.p = {{{1, 1, 1}}, {{-1, 1, 1}}, {{0, -1, 1}}}, .count = 3, .encloses = false},
      {.p = {{{4, 0, -1}}, {{-3, 3, -1}}, {{-3, -3, -1}}, {{0, 0, 5}}}, .count = 4, .encloses = true},
      {.p = {{{4, 0, 0}}, {{-3, 3, 0}}, {{-3, -3, 0}}, {{0, 0, 5}}}, .count = 4, .encloses = true},
      {.p = {{{4, 0, 1}}, {{-3, 3, 1}}, {{-3, -3, 1}}, {{0, 0, 5}}}, .count = 4, .encloses = false},
      {.p = {{{4, 0, 0}}, {{-3, 3, 0}}, {{-3, -3, 0}}, {{1, 1, 0}}}, .count = 4, .encloses = true},
      {.p = {{{4, 0, 0}}, {{3, 3, 0}}, {{3, -3, 0}}, {{5, 1, 0}}}, .count = 4, .encloses = false},
      {.p = {{{0, 0, 0}}, {{3, 3, 0}}, {{3, -3, 0}}, {{5, 1, 7}}}, .count = 4, .encloses = true},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    CHECK_MSG(exact_encloses(cases[i].p, cases[i].count) == cases[i].encloses, "case %lu", (unsigned long)i);
  }
}

// Squared distances that are small fractions: an edge at sqrt(1/3)..., a face at 5 / sqrt(3), a corner at 3.
static void test_features(void) {
  static const exact_point edge[2] = {{{1, 0, 0}}, {{0, 1, 0}}}, face[3] = {{{5, 0, 0}}, {{0, 5, 0}}, {{0, 0, 5}}};
  static const exact_point corner[3] = {{{1, 2, 2}}, {{5, 5, 5}}, {{7, 2, 9}}}, line[3] = {{{1, 2, 2}}, {{1, 2, 2}}};
  exact_feature f;
  exact_feature_nearest(edge, 2, &f);
  CHECK(exact_feature_compare(&f, 1) > 0);
  CHECK(exact_feature_compare(&f, 2) < 0);  // sqrt(1/2)
  exact_feature_nearest(face, 3, &f);
  CHECK(exact_feature_contains(&f, 3, true));
  CHECK(exact_feature_compare(&f, 5) > 0);
  CHECK(exact_feature_compare(&f, 6) < 0);  // 2.887
  exact_feature_nearest(corner, 3, &f);
  CHECK(exact_feature_compare(&f, 6) == 0);
  CHECK(!exact_feature_make(line, 2, &f));
  CHECK(exact_feature_make(corner, 3, &f));
  CHECK(!exact_feature_contains(&f, 3, false));
}

static void test_brute(void) {
  static const int32_t point[1][3] = {{3, 3, 7}}, touching[2][3] = {{0, 5, 9}, {20, 5, -9}},
                       inside[1][3] = {{2, 2, -3}};
  exact_truth truth;
  hand_made a, b;
  make_hull(&a, triangle, 4, 1);
  make_hull(&b, point, 1, 2);
  exact_brute(&a.collider, &b.collider, &truth);
  CHECK(!truth.enclosing);
  CHECK(exact_truth_distance(&truth, &a.collider, &b.collider) == 4);
  CHECK(exact_truth_within(&truth, &a.collider, &b.collider, 4));
  CHECK(!exact_truth_within(&truth, &a.collider, &b.collider, 3));
  make_hull(&b, inside, 1, 0);
  exact_brute(&a.collider, &b.collider, &truth);
  CHECK(truth.enclosing);
  CHECK(exact_truth_distance(&truth, &a.collider, &b.collider) == 0);
  make_hull(&b, touching, 2, 0);  // crosses z = 0 at x = 10, y = 5: outside of x + y <= 10 by 5 / sqrt(2) in the plane
  exact_brute(&a.collider, &b.collider, &truth);
  CHECK(!truth.enclosing);
  b.collider.centre.x = -5;  // at x = 5: on the border
  exact_brute(&a.collider, &b.collider, &truth);
  CHECK(truth.enclosing);
}

// The border between near and far lies between two integers, so it must be computed exactly: double is not enough.
static void test_far(void) {
  static const int32_t origin[1][3] = {{0, 0, 0}};
  hand_made a, b;
  make_hull(&a, origin, 1, 0);
  make_hull(&b, origin, 1, 0);
  b.collider.centre.x = INT32_C(1) << 30;
  CHECK(!exact_is_far(&a.collider, &b.collider));
  b.collider.centre.z = 2;
  CHECK(exact_is_far(&a.collider, &b.collider));
  CHECK(exact_is_far(&b.collider, &a.collider));
  b.collider.centre.x--;
  CHECK(!exact_is_far(&a.collider, &b.collider));
}

// Points 5 * 2^28 apart: a distance may be off by 2^-28 of that, 5, and so may a decision. Larger errors are refused.
static void test_far_bounds(void) {
  static const int32_t origin[1][3] = {{0, 0, 0}};
  const gjk_q16 apart = 5 * (INT32_C(1) << 28);
  hand_made a, b;
  char why[100];
  make_hull(&a, origin, 1, 0);
  make_hull(&b, origin, 1, 0);
  b.collider.centre.x = apart;
  for (int off = -8; off <= 8; off++) {
    gjk_distance_result r = {0};
    gjk_decision d = {0};
    r.distance = r.lower = r.upper = apart + off;
    r.certificate.proof = d.certificate.proof = GJK_PROOF_NEAREST;
    r.certificate.count = d.certificate.count = 1;
    const bool allowed = off >= -4 && off <= 4, refused = off < -5 || off > 5;
    const bool gap = exact_check_gap(&a.collider, &b.collider, &r, why, sizeof why);
    const bool no = exact_check_decision(&a.collider, &b.collider, apart + off, &d, why, sizeof why);
    d.yes = true;
    d.certificate.proof = GJK_PROOF_NEAR;
    const bool yes = exact_check_decision(&a.collider, &b.collider, apart + off, &d, why, sizeof why);
    CHECK_MSG(gap ? !refused : !allowed, "distance off by %d", off);
    CHECK_MSG(no ? off <= 5 : off > 4, "apart, off by %d", off);
    CHECK_MSG(yes ? off >= -5 : off < -4, "together, off by %d", off);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  test_small_integers(&random);
  test_large_integers(&random);
  test_enclosing();
  test_features();
  test_face_by_hand();
  test_proofs_by_hand();
  test_brute();
  test_far();
  test_far_bounds();
  return check_done("exact");
}
