// The double-precision reference's depths, judged by the exact answers: how often and how far the same method, in the
// arithmetic of other libraries, is wrong.
#include <math.h>

#include "../check.h"
#include "../exact/depth.h"
#include "../generate/overlap.h"
#include "../reference/reference.h"
#include "gjk/penetration.h"

#define SEED 8123
#define PAIRS_PER_FAMILY 1500
#define CELLS GJK_POLYTOPE_CELLS(4096)

typedef struct tally {
  unsigned overlapping;  // pairs that overlap in truth
  unsigned decisions;    // taken otherwise
  unsigned depths;       // more than 1 LSB off
  unsigned stuck;        // pairs that a move by double's depth, 1 LSB more than it says, does not part
  double error;          // largest, LSB
} tally;

static gjk_cell cells[CELLS];

static gjk_q30 to_q30(double value) {
  return (gjk_q30)lround(value * GJK_Q30_ONE);
}

// The reference's answer as an answer of the library's, for trying its move.
static bool parts(const gjk_collider *a, const gjk_collider *b, const reference_result *found) {
  gjk_penetration_result answer = {0};
  char why[128];
  answer.intersecting = true;
  answer.depth = (gjk_q16)ceil(-found->distance) + 1;
  answer.normal.x = to_q30(found->normal[0]);
  answer.normal.y = to_q30(found->normal[1]);
  answer.normal.z = to_q30(found->normal[2]);
  return exact_check_move(a, b, &answer, why, sizeof why);
}

static void judge_pair(const case_pair *pair, case_collider *a, case_collider *b, tally *t) {
  static const gjk_workspace workspace = {cells, CELLS};
  reference_result found;
  gjk_penetration_result truth;
  const bool proven = case_collider_build(a, &pair->a, false) == GJK_OK &&
                      case_collider_build(b, &pair->b, false) == GJK_OK &&
                      gjk_penetration(&a->collider, &b->collider, NULL, &workspace, &truth) == GJK_OK;
  CHECK_MSG(proven, "%s", pair->id);
  if (!proven || !truth.intersecting) {
    return;
  }
  reference_signed_posed(pair, a, b, &found);
  t->overlapping++;
  if (!found.intersecting) {
    t->decisions++;
    return;
  }
  exact_overlap overlap;
  const double depth = truth.depth, error = -found.distance - depth;
  // Where brute force can tell, it is the judge; the library's depths are judged by test_penetration.
  CHECK_MSG(exact_depth_work(&a->collider, &b->collider) > 1000 ||
                !exact_overlap_find(&a->collider, &b->collider, &overlap) || overlap.depth == truth.depth,
            "%s", pair->id);
  // truth - 1 < exact depth <= truth; and the depth along any direction, double's too, is at least the exact one.
  CHECK_MSG(error > -1.01, "%s: depth %.0f, but double knows of %.3f", pair->id, depth, -found.distance);
  const double off = error > 0 ? error : error < -1 ? -1 - error : 0;
  t->depths += !(off <= 1);
  t->error = off > t->error ? off : t->error;
  t->stuck += !parts(&a->collider, &b->collider, &found);
}

static void run_table(const generate_family *families, unsigned count, tally *all) {
  static case_pair pair;
  static case_collider a, b;
  for (unsigned i = 0; i < count; i++) {
    tally t = {0, 0, 0, 0, 0};
    for (uint64_t k = 0; k < PAIRS_PER_FAMILY; k++) {
      generate_pair(&families[i], SEED + k, &pair);
      judge_pair(&pair, &a, &b, &t);
    }
    printf(
        "%-20s of %4u that overlap double says apart %3u; %3u depths more than 1 LSB off, at most %.4g; %3u moves do "
        "not part\n",
        families[i].name, t.overlapping, t.decisions, t.depths, t.error, t.stuck);
    all->overlapping += t.overlapping;
    all->decisions += t.decisions;
    all->depths += t.depths;
    all->stuck += t.stuck;
  }
  case_pair_free(&pair);
  case_collider_free(&a);
  case_collider_free(&b);
}

int main(void) {
  tally all = {0, 0, 0, 0, 0};
  printf("seed %d\n", SEED);
  run_table(generate_overlaps, generate_overlap_count, &all);
  run_table(generate_families, generate_family_count, &all);
  printf("of %u that overlap double says apart %u, %u depths are more than 1 LSB off, %u moves do not part\n",
         all.overlapping, all.decisions, all.depths, all.stuck);
  // A reference that is mostly wrong would be no check.
  CHECK(all.overlapping > PAIRS_PER_FAMILY * generate_overlap_count / 2);
  CHECK((all.decisions + all.depths) * 4 < all.overlapping);
  return check_done("reference-depth");
}
