// A campaign of seeded random pairs, most of them overlapping. Every depth is checked in exact integers, and so is that
// moving B by it parts the shapes. Many depths are checked by brute force as well.
//
//   test_penetration [SEED [PERCENT [FAMILY]]]    default: seed 1, 100 percent of the pairs, all families
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "exact/depth.h"
#include "generate/overlap.h"
#include "generate/place.h"
#include "gjk/gjk.h"
#include "parts_answers.h"

// Pairs of each family of overlaps, and of each other family. At least OVERLAPPING_LEAST of all must overlap.
#define OVERLAPS 23000
#define OTHERS 8000
#define OVERLAPPING_LEAST 400000

#define FAILURES_SHOWN 5
#define CELLS GJK_EPA_CELLS(4096)

// So many pairs apart, a pair is also checked by the library, with right and wrong answers, and by brute force; asked
// again with caches, swapped and elsewhere; with its vertices shuffled; and with every size of workspace.
#define CHECK_EVERY 4
#define BRUTE_EVERY 4
#define BRUTE_DIRECTIONS 2000
#define AGAIN_EVERY 8
#define SHUFFLE_EVERY 16
#define WORKSPACE_EVERY 32

typedef struct campaign {
  const generate_family *family;
  case_pair pair, changed;
  case_collider a, b, other_a, other_b;
  gjk_penetration_result found, cold;
  gjk_cache own, kept;  // of this pair; of the one before, rubbish for this one
  random_state random;
  unsigned long pairs, intersecting, touching, brute, refused, failures;
  unsigned iterations;
  uint32_t cells;  // largest workspace that was needed
  unsigned long proofs[GJK_PROOF_PLANE + 1];
  char why[200];
} campaign;

static gjk_epa_cell cells[CELLS];
static const gjk_workspace roomy = {cells, CELLS};

#include "campaign.h"

// Whatever changes in the way to an answer, `intersecting` and the depth may not change.
static void expect_same(campaign *c, const gjk_collider *a, const gjk_collider *b, gjk_cache *cache, const char *what) {
  gjk_penetration_result r;
  const gjk_status status = gjk_penetration(a, b, cache, &roomy, &r);
  expect(c, status == GJK_OK, what);
  if (status == GJK_OK) {
    expect(c, r.intersecting == c->found.intersecting && (!r.intersecting || r.depth == c->found.depth), what);
    expect(c, exact_check_penetration(a, b, &r, c->why, sizeof c->why), what);
  }
}

static void check_caches(campaign *c) {
  gjk_cache random = generate_cache(&c->random);
  expect_same(c, &c->a.collider, &c->b.collider, &c->own, "own cache");
  expect_same(c, &c->a.collider, &c->b.collider, &c->kept, "cache of another pair");
  expect_same(c, &c->a.collider, &c->b.collider, &random, "cache of random bits");
  c->kept = c->own;
}

static bool move(gjk_collider *collider, const exact_point *t) {
  const int64_t x = collider->position.x + t->x[0], y = collider->position.y + t->x[1],
                z = collider->position.z + t->x[2];
  const gjk_vec3 p = {(gjk_q16)x, (gjk_q16)y, (gjk_q16)z};
  return x == p.x && y == p.y && z == p.z && gjk_collider_move(collider, &p) == GJK_OK;
}

static exact_point step_of(random_state *random, int32_t most) {
  return (exact_point){
      {random_range(random, -most, most), random_range(random, -most, most), random_range(random, -most, most)}};
}

static void check_elsewhere(campaign *c) {
  gjk_collider a = c->a.collider, b = c->b.collider;
  const exact_point t = step_of(&c->random, INT32_MAX >> random_below(&c->random, 12));
  expect_same(c, &b, &a, NULL, "A and B swapped");
  if (move(&a, &t) && move(&b, &t)) {
    expect_same(c, &a, &b, NULL, "both moved");
  }
}

// The library's check must refuse what the oracle refuses, and a depth that is too small.
static void check_refusals(campaign *c) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_penetration_result wrong = c->found;
  expect(c, gjk_check_penetration(a, b, &wrong) == GJK_OK, "gjk_check_penetration");
  if (!wrong.intersecting || exact_is_far(a, b)) {
    return;
  }
  const gjk_q16 by = random_below(&c->random, 2) == 0 ? 1 : -1;
  wrong.depth += by;
  wrong.lower += by;
  wrong.upper += by;
  expect(c, gjk_check_penetration(a, b, &wrong) == GJK_ERROR_UNPROVEN, "a wrong depth");
  wrong = c->found;
  wrong.intersecting = false;
  expect(c, gjk_check_penetration(a, b, &wrong) == GJK_ERROR_UNPROVEN, "not intersecting");
  if (c->found.certificate.proof == GJK_PROOF_PLANE) {  // there the direction alone is the library's proof
    return;
  }
  wrong = c->found;
  wrong.certificate.a[random_below(&c->random, 3)] ^= (uint16_t)(1u << random_below(&c->random, 4));
  const bool valid = exact_check_depth(a, b, &wrong, c->why, sizeof c->why);
  const gjk_status status = gjk_check_penetration(a, b, &wrong);
  expect(c, status == GJK_ERROR_UNPROVEN || (valid && status == GJK_OK), "a vertex renamed");
  c->refused += status == GJK_ERROR_UNPROVEN;
}

static int64_t magnitude(int64_t x) {
  return x < 0 ? -x : x;
}

// The signed distance is that of gjk_distance, or minus the depth. If a shape moves by an LSB, the true one changes by
// at most 1. A gap is rounded to the nearest, a depth up, so two answers are at most 2 apart.
static void check_signed(campaign *c) {
  const gjk_collider *a = &c->a.collider;
  gjk_collider b = c->b.collider;
  exact_point t = {{0, 0, 0}};
  gjk_distance_result here, there, apart;
  if (exact_is_far(a, &b)) {
    return;
  }
  const bool answered =
      gjk_signed_distance(a, &b, NULL, &roomy, &here) == GJK_OK && gjk_distance(a, &b, NULL, &apart) == GJK_OK;
  expect(c, answered, "status of the signed distance");
  expect(c, answered && here.intersecting == c->found.intersecting, "signed distance: intersecting");
  expect(c, answered && here.distance == (here.intersecting ? -c->found.depth : apart.distance), "signed distance");
  t.x[random_below(&c->random, 3)] = random_below(&c->random, 2) == 0 ? 1 : -1;
  if (answered && move(&b, &t)) {
    const gjk_status status = gjk_signed_distance(a, &b, NULL, &roomy, &there);
    expect(c, status == GJK_OK && magnitude((int64_t)there.distance - here.distance) <= 2,
           "signed distance after a step");
  }
}

// Asks the other queries about B moved by the depth.
static void check_parted(campaign *c) {
  gjk_collider b = c->b.collider;
  const exact_point t = exact_move(&c->found);
  gjk_decision touch;
  gjk_penetration_result again;
  if (!move(&b, &t)) {
    return;
  }
  const bool answered = gjk_intersect(&c->a.collider, &b, NULL, &touch) == GJK_OK &&
                        gjk_penetration(&c->a.collider, &b, NULL, &roomy, &again) == GJK_OK;
  expect(c, answered && touch.yes == again.intersecting && (!touch.yes || again.depth == 0), "moved by the depth");
}

static void shuffle(random_state *random, case_shape *shape) {
  for (size_t i = shape->count; i > 1; i--) {
    const size_t k = random_below(random, (uint32_t)i);
    const gjk_vec3 kept = shape->vertices[i - 1];
    shape->vertices[i - 1] = shape->vertices[k];
    shape->vertices[k] = kept;
  }
}

// The same shapes written as hulls, with their vertices in any order.
static void check_shuffled(campaign *c) {
  case_shape_copy(&c->changed.a, &c->pair.a);
  case_shape_copy(&c->changed.b, &c->pair.b);
  generate_bake(&c->changed.a);
  generate_bake(&c->changed.b);
  shuffle(&c->random, &c->changed.a);
  shuffle(&c->random, &c->changed.b);
  // The centre of the box around the rounded vertices may lie beyond int32_t.
  if (case_pair_build(&c->changed, false, &c->other_a, &c->other_b)) {
    expect_same(c, &c->other_a.collider, &c->other_b.collider, NULL, "vertices shuffled");
  }
}

// With too few cells the bounds must hold and the move must part the shapes. No cell beyond the stated number may be
// written.
static void check_workspace(campaign *c, uint32_t count, gjk_status *status) {
  static const gjk_epa_cell guard = {{{0x5EED, 0x5EED, 0x5EED}, 0x5EED, 0x5EED}};
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  const gjk_workspace workspace = {cells, count};
  const gjk_penetration_result *truth = &c->cold;
  gjk_penetration_result r;
  cells[count] = guard;
  *status = gjk_penetration(a, b, NULL, count == 0 && random_below(&c->random, 2) == 0 ? NULL : &workspace, &r);
  snprintf(c->why, sizeof c->why, "%lu cells", (unsigned long)count);
  expect(c, memcmp(&cells[count], &guard, sizeof guard) == 0, "beyond the workspace");
  if (*status == GJK_ERROR_CAPACITY) {
    snprintf(c->why, sizeof c->why, "%lu cells: %ld to %ld, truth %ld", (unsigned long)count, (long)r.lower,
             (long)r.upper, (long)truth->depth);
    expect(c,
           r.intersecting && r.depth == r.upper && r.lower >= 0 && r.lower <= truth->depth && r.upper >= truth->depth,
           "bounds with too few cells");
    expect(c, exact_check_move(a, b, &r, c->why, sizeof c->why), "move with too few cells");
  } else {
    snprintf(c->why, sizeof c->why, "%lu cells: %s", (unsigned long)count, gjk_status_name(*status));
    expect(c, *status == GJK_OK && same_penetration(&r, truth), "with enough cells");
  }
}

// Asks with every size of workspace up to the first that suffices; of large workspaces, with some.
static void check_workspaces(campaign *c) {
  gjk_status status = gjk_penetration(&c->a.collider, &c->b.collider, NULL, &roomy, &c->cold);
  expect(c, status == GJK_OK, gjk_status_name(status));
  status = GJK_ERROR_CAPACITY;
  for (uint32_t count = 0; count < CELLS && status == GJK_ERROR_CAPACITY; count++) {
    check_workspace(c, count, &status);
    c->cells = count > c->cells ? count : c->cells;
    count += count > 200 ? random_below(&c->random, count / 8) : 0;
  }
  expect(c, status == GJK_OK, "no workspace suffices");
}

static void check_brute(campaign *c) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  const gjk_penetration_result *r = &c->found;
  exact_overlap truth;
  if (exact_is_far(a, b) || exact_depth_work(a, b) > BRUTE_DIRECTIONS || !exact_overlap_find(a, b, &truth)) {
    return;
  }
  expect(c, truth.intersecting == r->intersecting, "intersecting against brute force");
  if (truth.intersecting && r->intersecting) {
    snprintf(c->why, sizeof c->why, "%ld, truth %ld", (long)r->depth, (long)truth.depth);
    expect(c, truth.depth == r->depth && truth.touching == (r->depth == 0), "depth against brute force");
  }
  c->brute++;
}

static void check_answer(campaign *c) {
  const gjk_collider *a = &c->a.collider, *b = &c->b.collider;
  gjk_penetration_result *r = &c->found;
  gjk_decision touch;
  expect(c, exact_check_penetration(a, b, r, c->why, sizeof c->why), "penetration");
  expect(c, gjk_intersect(a, b, NULL, &touch) == GJK_OK && touch.yes == r->intersecting, "gjk_intersect");
  c->pairs++;
  c->intersecting += r->intersecting;
  c->touching += r->intersecting && r->depth == 0;
  c->iterations = r->iterations > c->iterations ? r->iterations : c->iterations;
  if (r->certificate.proof <= GJK_PROOF_PLANE) {
    c->proofs[r->certificate.proof]++;
  }
}

static void check_pair(campaign *c) {
  memset(&c->own, 0, sizeof c->own);
  const bool built = case_pair_build(&c->pair, false, &c->a, &c->b);
  expect(c, built, "the pair can be posed");
  const gjk_status status =
      built ? gjk_penetration(&c->a.collider, &c->b.collider, &c->own, &roomy, &c->found) : GJK_ERROR_RANGE;
  expect(c, status == GJK_OK, gjk_status_name(status));
  if (status != GJK_OK) {
    return;
  }
  check_answer(c);
  if (c->pairs % CHECK_EVERY == 0) {
    check_refusals(c);
  }
  if (c->pairs % BRUTE_EVERY == 0) {
    check_brute(c);
  }
  if (c->pairs % AGAIN_EVERY == 0) {
    check_caches(c);
    check_elsewhere(c);
    check_signed(c);
  }
  if (c->pairs % SHUFFLE_EVERY == 0) {
    check_shuffled(c);
  }
  if (c->found.intersecting && c->pairs % AGAIN_EVERY == 0) {
    check_parted(c);
  }
  if (c->found.intersecting && c->pairs % WORKSPACE_EVERY == 0) {
    check_workspaces(c);
  }
}

// The share of intersecting pairs must stay between the limits of the family.
static void run_family(campaign *c, uint64_t seed, unsigned long pairs) {
  const generate_family *family = c->family;
  c->random = random_seed(seed);
  c->pairs = c->intersecting = c->touching = c->brute = c->failures = 0;
  c->iterations = 0;
  c->cells = 0;
  for (unsigned long i = 0; i < pairs && c->failures < FAILURES_SHOWN; i++) {
    generate_pair(family, (seed << 32) + i, &c->pair);
    check_pair(c);
  }
  const double share = 100.0 * (double)c->intersecting / (double)(c->pairs > 0 ? c->pairs : 1);
  printf("%-22s %6lu pairs, %5.1f %% intersect, %5lu touch, %4u scans and %5lu cells at most, %5lu by brute force\n",
         family->name, c->pairs, share, c->touching, c->iterations, (unsigned long)c->cells, c->brute);
  fflush(stdout);
  if (pairs >= 1000) {
    campaign_check_share(family->name, share, family->least, family->most);
  }
}

// Runs the families of a table, or the named one. Returns how many pairs overlapped.
static unsigned long run_table(campaign *c, const generate_family *families, unsigned count, const char *name,
                               uint64_t seed, unsigned long pairs, unsigned long *brute) {
  unsigned long intersecting = 0;
  for (unsigned i = 0; i < count; i++) {
    c->family = &families[i];
    if (name == NULL || strcmp(name, c->family->name) == 0) {
      run_family(c, seed, pairs);
      intersecting += c->intersecting;
      *brute += c->brute;
    }
  }
  return intersecting;
}

int main(int argc, char **argv) {
  static campaign c;
  const uint64_t seed = argc > 1 ? check_seeded(strtoull(argv[1], NULL, 10)) : check_seed(1);
  const unsigned long percent = argc > 2 ? strtoul(argv[2], NULL, 10) : check_trials(100);
  const char *name = argc > 3 ? argv[3] : NULL;
  unsigned long overlapping = 0, brute = 0;
  overlapping += run_table(&c, generate_overlaps, generate_overlap_count, name, seed, OVERLAPS * percent / 100, &brute);
  overlapping += run_table(&c, generate_families, generate_family_count, name, seed, OTHERS * percent / 100, &brute);
  printf("%lu overlapping pairs, %lu by brute force; proofs: %lu facet, %lu plane, %lu nearest, %lu apart\n",
         overlapping, brute, c.proofs[GJK_PROOF_FACET], c.proofs[GJK_PROOF_PLANE], c.proofs[GJK_PROOF_NEAREST],
         c.proofs[GJK_PROOF_SPHERES] + c.proofs[GJK_PROOF_DIRECTION]);
  if (name == NULL && percent >= 100) {
    CHECK(overlapping >= OVERLAPPING_LEAST);
    CHECK(brute > overlapping / 10);
    CHECK(c.refused > overlapping / 10);
    CHECK(c.proofs[GJK_PROOF_PLANE] > 400);
    CHECK(c.proofs[GJK_PROOF_NEAREST] > 4000);
  }
  case_pair_free(&c.pair);
  case_pair_release(&c.changed, &c.a, &c.b);
  case_collider_free(&c.other_a);
  case_collider_free(&c.other_b);
  return check_done("penetration");
}
