// A campaign of seeded random casts of polytopes: every decision and every fraction is the oracle's.
//
//   test_cast_certificates [SEED [CASTS [FAMILY]]]    default: seed 1, 40,000 casts over all families
#include "check.h"
#include "exact/cast_claim.h"
#include "generate/cast.h"
#include "gjk/gjk.h"
#include "same.h"

#define CASTS check_trials(40000)
#define FAILURES_SHOWN 5

// So many casts apart, a cast is also checked with forged claims, or by moving the shapes.
#define FORGE_EVERY 2
#define MOVE_EVERY 2

// The oracle is asked about pairs of at most so many vertices.
#define VERTICES 20

#define PROOFS (GJK_CAST_PROOF_FACET + 1)

typedef struct campaign {
  const generate_cast_family *family;
  case_pair pair;
  case_collider a, b, ray;
  exact_cast cast, other;
  random_state random;
  unsigned long casts, hits, inside, ties, ends, outside, forged, refused, failures, most;
  unsigned long proofs[PROOFS];
  unsigned long entered[2];  // rays into boxes: by the slabs, by a search
  char why[160];
} campaign;

#include "campaign.h"

static gjk_vec3 vec3(int64_t x, int64_t y, int64_t z) {
  return (gjk_vec3){(gjk_q16)x, (gjk_q16)y, (gjk_q16)z};
}

// From where it stands by a part of a way; the part is k of n.
static gjk_vec3 part_of(const gjk_vec3 *from, const exact_point *way, int k, int n) {
  return vec3(from->x + way->x[0] / n * k, from->y + way->x[1] / n * k, from->z + way->x[2] / n * k);
}

// Has the oracle time for them?
static bool is_few(const gjk_collider *a, const gjk_collider *b) {
  return exact_vertex_count(a) + exact_vertex_count(b) <= VERTICES;
}

// Asks the library, and compares with the oracle, or for many vertices with the certificate alone. False: the cast is
// refused.
static bool ask(campaign *c, const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, exact_cast *cast,
                const char *what, gjk_cast_result *out) {
  const gjk_status status = gjk_cast(a, b, path, out);
  if (!exact_cast_is_in_range(a, b, path, cast)) {
    expect(c, status == GJK_ERROR_RANGE, "out of range");
    return false;
  }
  expect(c, status == GJK_OK, gjk_status_name(status));
  if (status != GJK_OK) {
    return false;
  }
  if (is_few(a, b)) {
    expect(c, exact_cast_set(a, b, path, cast), "the oracle knows it");
    expect(c, exact_check_cast(cast, out, c->why, sizeof c->why), what);
  }
  expect(c, exact_check_cast_certificate(a, b, path, out, c->why, sizeof c->why), what);
  const gjk_status proven = gjk_check_cast(a, b, path, out);
  expect(c, proven == GJK_OK, "gjk_check_cast");
  return true;
}

// A claim that differs from the truth must be refused.
static void forge(campaign *c, const gjk_cast_path *path, const gjk_cast_result *claim, const char *what) {
  const gjk_status status = gjk_check_cast(&c->a.collider, &c->b.collider, path, claim);
  expect(c, status == GJK_ERROR_UNPROVEN, what);
  c->forged++;
  c->refused += status == GJK_ERROR_UNPROVEN;
}

static void forge_hit(campaign *c, const gjk_cast_path *path, const gjk_cast_result *right) {
  gjk_cast_result wrong = *right;
  wrong.fraction++;
  forge(c, path, &wrong, "forged: fraction too large");
  wrong = *right;
  wrong.fraction--;
  forge(c, path, &wrong, "forged: fraction too small");
  wrong = *right;
  wrong.inside = !right->inside;
  forge(c, path, &wrong, "forged: inside");
  if (!right->inside) {
    wrong = *right;
    wrong.normal.x = -right->normal.x;
    wrong.normal.y = -right->normal.y;
    wrong.normal.z = -right->normal.z;
    forge(c, path, &wrong, "forged: normal flipped");
  }
  wrong = *right;
  wrong.rest_b.x += random_below(&c->random, 2) == 0 ? 5 : -5;
  forge(c, path, &wrong, "forged: place of rest moved");
  wrong = *right;
  wrong.rest_a.z += random_below(&c->random, 2) == 0 ? 5 : -5;
  forge(c, path, &wrong, "forged: A's place of rest moved");
}

// A certificate with another vertex, proof or direction may hold only if the claim is still true: it always is here, so
// nothing is expected but that the check ends, and accepts nothing else than UNPROVEN or OK.
static void disturb(campaign *c, const gjk_cast_path *path, const gjk_cast_result *right) {
  gjk_cast_result other = *right;
  gjk_cast_certificate *certificate = &other.certificate;
  switch (random_below(&c->random, 4)) {
    case 0: certificate->a[random_below(&c->random, 3)] ^= (uint16_t)(1u << random_below(&c->random, 16)); break;
    case 1: certificate->proof = (uint8_t)random_below(&c->random, 8); break;
    case 2: certificate->count = (uint8_t)random_below(&c->random, 6); break;
    default: certificate->direction.y ^= 1 << random_below(&c->random, 31); break;
  }
  const gjk_status status = gjk_check_cast(&c->a.collider, &c->b.collider, path, &other);
  const bool ends = status == GJK_OK || status == GJK_ERROR_UNPROVEN || status == GJK_ERROR_UNSUPPORTED;
  expect(c, ends, "a disturbed certificate");
  // What is false stays false, whatever the certificate.
  other.hit = !right->hit;
  other.fraction = random_range(&c->random, 0, GJK_Q30_ONE);
  expect(c, gjk_check_cast(&c->a.collider, &c->b.collider, path, &other) != GJK_OK, "a forged claim, disturbed");
}

static void check_forged(campaign *c, const gjk_cast_path *path, const gjk_cast_result *right) {
  gjk_cast_result wrong = *right;
  if (right->hit) {
    forge_hit(c, path, right);
  } else {
    wrong.fraction = 0;
    wrong.inside = false;
  }
  wrong.hit = !right->hit;
  forge(c, path, &wrong, "forged: hit or miss");
  disturb(c, path, right);
}

// A against B, which moves the other way.
static void check_reversed(campaign *c, const gjk_cast_path *path, const gjk_cast_result *r) {
  const gjk_cast_path back = {.to_a = path->to_b, .to_b = path->to_a, .margin = path->margin};
  gjk_cast_result found;
  if (ask(c, &c->b.collider, &c->a.collider, &back, &c->other, "reversed", &found)) {
    expect(c, found.hit == r->hit && (!r->hit || (found.inside == r->inside && found.fraction == r->fraction)),
           "reversed, another answer");
  }
}

// The same way of B against A, by another share of both.
static void check_shared(campaign *c, const gjk_cast_path *path, const gjk_cast_result *r) {
  const gjk_vec3 *p = &c->a.collider.position, *q = path->to_b != NULL ? path->to_b : &c->b.collider.position;
  const gjk_vec3 *s = path->to_a != NULL ? path->to_a : p;
  const int32_t x = random_range(&c->random, -100000, 100000), y = random_range(&c->random, -9, 9);
  const int64_t end[6] = {(int64_t)s->x + x, (int64_t)s->y + y, (int64_t)s->z - x,
                          (int64_t)q->x + x, (int64_t)q->y + y, (int64_t)q->z - x};
  for (int i = 0; i < 6; i++) {
    if (end[i] > INT32_MAX || end[i] < INT32_MIN) {
      return;
    }
  }
  const gjk_vec3 to_a = vec3(end[0], end[1], end[2]), to_b = vec3(end[3], end[4], end[5]);
  const gjk_cast_path moved = {.to_a = &to_a, .to_b = &to_b};
  gjk_cast_result found;
  if (ask(c, &c->a.collider, &c->b.collider, &moved, &c->other, "both move", &found)) {
    expect(c, found.hit == r->hit && (!r->hit || (found.inside == r->inside && found.fraction == r->fraction)),
           "both move, another answer");
  }
}

// The way in two parts: it hits on one of them exactly if it hits.
static void check_split(campaign *c) {
  gjk_collider a = c->a.collider, b = c->b.collider;
  const int n = 2 + (int)random_below(&c->random, 3), k = 1 + (int)random_below(&c->random, (uint32_t)n - 1);
  const gjk_vec3 to_a = part_of(&a.position, &c->cast.way_a, n, n), to_b = part_of(&b.position, &c->cast.way_b, n, n);
  const gjk_vec3 half_a = part_of(&a.position, &c->cast.way_a, k, n),
                 half_b = part_of(&b.position, &c->cast.way_b, k, n);
  const gjk_cast_path whole = {.to_a = &to_a, .to_b = &to_b}, first = {.to_a = &half_a, .to_b = &half_b};
  gjk_cast_result all, one, two;
  if (!ask(c, &a, &b, &whole, &c->other, "the whole way", &all) ||
      !ask(c, &a, &b, &first, &c->other, "the first part", &one) || gjk_collider_move(&a, &half_a) != GJK_OK ||
      gjk_collider_move(&b, &half_b) != GJK_OK || !ask(c, &a, &b, &whole, &c->other, "the second part", &two)) {
    return;
  }
  expect(c, all.hit == (one.hit || two.hit), "a way in two parts");
  expect(c, !one.hit || one.inside == all.inside, "inside, in parts");
}

// Distances tell the same at the place of rest, and at the whole positions before and after contact on the way.
static void check_places(campaign *c, const gjk_cast_result *r) {
  gjk_collider a = c->a.collider, b = c->b.collider;
  gjk_penetration_result depth;
  static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
  static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(64)};
  if (!r->hit || r->inside) {
    return;
  }
  expect(c, gjk_collider_move(&a, &r->rest_a) == GJK_OK && gjk_collider_move(&b, &r->rest_b) == GJK_OK,
         "they can be put at rest");
  if (gjk_penetration(&a, &b, NULL, &workspace, &depth) == GJK_OK) {
    expect(c, !depth.intersecting || depth.depth == 0, "a depth at rest");
  }
}

// A way along an axis, of so many LSB: the first whole step that touches is the fraction's, rounded up.
static void check_axis(campaign *c) {
  gjk_collider b = c->b.collider;
  const unsigned axis = random_below(&c->random, 3);
  const int32_t length = (int32_t)(1u << random_below(&c->random, 26)) + random_range(&c->random, 0, 3);
  const int32_t along = random_below(&c->random, 2) == 0 ? length : -length;
  const exact_point way = {{axis == 0 ? along : 0, axis == 1 ? along : 0, axis == 2 ? along : 0}};
  const gjk_vec3 to = part_of(&b.position, &way, 1, 1);
  const gjk_cast_path path = {.to_b = &to};
  gjk_cast_result r;
  const bool wraps = along > 0 ? to.x < b.position.x || to.y < b.position.y || to.z < b.position.z
                               : to.x > b.position.x || to.y > b.position.y || to.z > b.position.z;
  if (wraps || !is_few(&c->a.collider, &b) || !ask(c, &c->a.collider, &b, &path, &c->other, "along an axis", &r) ||
      !r.hit || r.inside) {
    return;
  }
  // The exact place: floor and whether it is whole.
  const exact_point from = {{0, 0, 0}};
  const exact_cast_truth *truth = &c->other.truth;
  const int64_t below = exact_cast_floor(truth, &from, &way, (int)axis);
  const bool whole = exact_cast_compare(truth, &from, &way, (int)axis, below) == 0;
  for (int64_t step = -1; step <= 1; step++) {  // before, at, and after the contact, in the direction of the way
    const int64_t toward = along > 0 ? 1 : -1, base = along > 0 || whole ? below : below + 1;
    const int64_t x = base + toward * step;
    const exact_point by = {{axis == 0 ? x : 0, axis == 1 ? x : 0, axis == 2 ? x : 0}};
    const gjk_vec3 at = part_of(&c->b.collider.position, &by, 1, 1);
    gjk_decision d;
    if (x * toward < 0 || x * toward > length || gjk_collider_move(&b, &at) != GJK_OK ||
        gjk_intersect(&c->a.collider, &b, NULL, &d) != GJK_OK) {
      continue;
    }
    const int side = exact_difference_side(&c->other.difference, &by, &from, 0, 1);
    expect(c, d.yes == (side >= 0), "gjk_intersect beside the contact");
    expect(c, step > 0 || (step == 0 && whole) || !d.yes, "contact before the fraction");
  }
}

// A point in place of B: the ray's answer is the cast's.
static void check_ray(campaign *c) {
  static const gjk_shape point = GJK_POINT;
  const gjk_vec3 *from = &c->pair.b.pose.position, *to = c->pair.b.moves ? &c->pair.b.end.position : from;
  const gjk_cast_path path = {.to_b = to};
  gjk_cast_result ray, cast;
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position = *from;
  expect(c,
         gjk_collider_init(&c->ray.collider, &point, NULL, 0) == GJK_OK &&
             gjk_collider_pose(&c->ray.collider, &pose) == GJK_OK,
         "a point");
  const bool in_range = ask(c, &c->a.collider, &c->ray.collider, &path, &c->other, "a point's cast", &cast);
  const gjk_status status = gjk_cast_ray(&c->a.collider, from, to, &ray);
  expect(c, status == (in_range ? GJK_OK : GJK_ERROR_RANGE), "status of a ray");
  if (!in_range || status != GJK_OK) {
    return;
  }
  const gjk_collider *a = &c->a.collider, *b = &c->ray.collider;
  expect(c, !is_few(a, b) || exact_check_cast(&c->other, &ray, c->why, sizeof c->why), "a ray");
  expect(c, exact_check_cast_certificate(a, b, &path, &ray, c->why, sizeof c->why), "a ray's certificate");
  if (a->shape->type == &gjk_class_box && ray.hit && !ray.inside) {
    c->entered[ray.iterations == 0 ? 0 : 1]++;
  }
  expect(c,
         ray.hit == cast.hit && (!ray.hit || (ray.fraction == cast.fraction && same_vec3(&ray.rest_b, &cast.rest_b))),
         "a ray and a cast");
}

static void count(campaign *c, const gjk_cast_result *r) {
  const exact_cast_truth *truth = &c->cast.truth;
  c->casts++;
  c->hits += r->hit;
  c->inside += r->hit && r->inside;
  if (is_few(&c->a.collider, &c->b.collider)) {
    c->ties += truth->hit && !truth->inside && truth->entries > 1;
    c->ends += truth->hit && truth->ends;
  }
  c->most = r->iterations > c->most ? r->iterations : c->most;
  if (r->certificate.proof < PROOFS) {
    c->proofs[r->certificate.proof]++;
  }
}

static void check_cast(campaign *c) {
  gjk_cast_result r = {0};
  const gjk_status of_a = case_collider_build(&c->a, &c->pair.a, false),
                   of_b = case_collider_build(&c->b, &c->pair.b, false);
  const bool built = of_a == GJK_OK && of_b == GJK_OK;
  expect(c, built || of_a == GJK_ERROR_RANGE || of_b == GJK_ERROR_RANGE, "the pair can be posed");
  const gjk_cast_path path = case_path(&c->pair, 0);
  if (!built || !ask(c, &c->a.collider, &c->b.collider, &path, &c->cast, "cast", &r)) {
    c->outside++;
    return;
  }
  count(c, &r);
  check_places(c, &r);
  if (c->casts % FORGE_EVERY == 0) {
    check_forged(c, &path, &r);
    check_reversed(c, &path, &r);
  } else if (c->casts / FORGE_EVERY % MOVE_EVERY == 0) {
    check_shared(c, &path, &r);
    check_split(c);
  } else {
    check_axis(c);
    check_ray(c);
  }
}

static void run_family(campaign *c, uint64_t seed, unsigned long casts) {
  const generate_cast_family *family = c->family;
  c->random = random_seed(seed);
  c->casts = c->hits = c->inside = c->ties = c->ends = c->outside = c->failures = c->most = 0;
  for (unsigned long i = 0; i < casts && c->failures < FAILURES_SHOWN; i++) {
    generate_cast(family, (seed << 32) + i, &c->pair);
    check_cast(c);
  }
  const double all = c->casts > 0 ? (double)c->casts : 1, share = 100 * (double)c->hits / all;
  printf(
      "%-16s %6lu casts, %5.1f %% hit, %5.1f %% at the start, %5.1f %% by several planes, %5.1f %% touch the border, "
      "%2lu iterations at most, %lu out of range\n",
      family->name, c->casts, share, 100 * (double)c->inside / all, 100 * (double)c->ties / all,
      100 * (double)c->ends / all, c->most, c->outside);
  fflush(stdout);
  if (casts >= 500) {
    CHECK_MSG(share >= family->least && share <= family->most, "%s: %.1f %% hit", family->name, share);
    CHECK_MSG(100 * (double)c->inside / all >= family->inside, "%s: %lu inside", family->name, c->inside);
    CHECK_MSG(c->outside * 10 <= casts, "%s: %lu out of range", family->name, c->outside);
    // Where they are together at the start, or stand, no plane is entered.
    CHECK_MSG(family->many || family->inside >= 20 || c->ties * 20 >= c->casts, "%s: %lu by several planes",
              family->name, c->ties);
  }
}

static void check_proofs(const campaign *c, unsigned long casts) {
  static const char *const names[PROOFS] = {"none", "spheres", "beside", "short", "inside", "facet"};
  for (unsigned i = 1; i < PROOFS; i++) {
    printf("%lu times %s\n", c->proofs[i], names[i]);
    CHECK_MSG(c->proofs[i] > casts / 1000, "%s: %lu", names[i], c->proofs[i]);
  }
  CHECK(c->proofs[0] == 0);
  // A build for size searches always. Elsewhere a search answers ties and boxes far away alone.
  printf("%lu rays enter a box by its slabs, %lu after a search\n", c->entered[0], c->entered[1]);
  CHECK(c->entered[0] == 0 || c->entered[0] > casts / 1000);
  CHECK(c->entered[1] > casts / 1000);
}

int main(int argc, char **argv) {
  static campaign c;
  const campaign_request asked = campaign_requested(argc, argv, CASTS, generate_cast_family_count);
  unsigned long total = 0;
  for (unsigned i = 0; i < generate_cast_family_count; i++) {
    c.family = &generate_cast_families[i];
    if (campaign_includes(&asked, c.family->name)) {
      run_family(&c, asked.seed, asked.each);
      total += c.casts;
      CHECK(c.casts + c.outside >= asked.each || c.failures > 0);
    }
  }
  printf("%lu casts, %lu of %lu forged claims refused\n", total, c.refused, c.forged);
  if (asked.name == NULL && asked.count >= 10000) {
    CHECK(c.refused > total / 4);
    check_proofs(&c, total);
  }
  case_pair_release(&c.pair, &c.a, &c.b);
  exact_cast_free(&c.cast);
  exact_cast_free(&c.other);
  return check_done("cast_certificates");
}
