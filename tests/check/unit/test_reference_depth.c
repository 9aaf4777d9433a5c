// The reference's depths, in double and in float, judged by exact answers: how often and by how much EPA is wrong in
// the arithmetic of other libraries.
#include <math.h>

#include "check.h"
#include "exact/depth.h"
#include "generate/overlap.h"
#include "gjk/penetration.h"
#include "reference/reference.h"

#define SEED 8123
#define PAIRS_PER_FAMILY 1500
#define CELLS GJK_EPA_CELLS(4096)

typedef void signed_function(const case_pair *pair, const case_collider *a, const case_collider *b,
                             reference_result *out);

typedef struct precision {
  const char *name;
  signed_function *query;
  double grain;  // what its rounding may make of a length, in parts of the shapes' radii
} precision;

static const precision precisions[] = {
    {.name = "double", .query = reference_signed_posed},
    {.name = "float", .query = reference_float_signed_posed, .grain = 1.0 / (1 << 20)}};
#define PRECISIONS (sizeof precisions / sizeof precisions[0])

typedef struct tally {
  unsigned overlapping;  // pairs that overlap in truth
  unsigned decisions;    // taken otherwise
  unsigned depths;       // more than 1 LSB off, and more than the grain explains
  unsigned stuck;        // pairs that a move by its depth, 1 LSB more than it says, does not part
  double error;          // largest, LSB
} tally;

static gjk_epa_cell cells[CELLS];

static gjk_q30 to_q30(double value) {
  return (gjk_q30)lround(value * GJK_Q30_ONE);
}

// The reference's answer in the form of the library's, so that its move can be tried.
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

// Brute force is the judge where it can tell; elsewhere the library's depths, which test_penetration judges.
static bool find_truth(const gjk_collider *a, const gjk_collider *b, gjk_penetration_result *out) {
  static const gjk_workspace workspace = {cells, CELLS};
  exact_overlap overlap;
  return gjk_penetration(a, b, NULL, &workspace, out) == GJK_OK &&
         (!out->intersecting || exact_depth_work(a, b) > 1000 || !exact_overlap_find(a, b, &overlap) ||
          overlap.depth == out->depth);
}

// How far the shape reaches along sign n. Pre: |n| = 1.
static double reach_along(const gjk_collider *c, const double n[3], double sign) {
  double most = -INFINITY;
  for (unsigned i = 0; i < exact_vertex_count(c); i++) {
    const exact_point v = exact_vertex(c, i);
    most = fmax(most, sign * ((double)v.x[0] * n[0] + (double)v.x[1] * n[1] + (double)v.x[2] * n[2]));
  }
  return most + c->shape->convex_radius;
}

// The depth along the reference's normal, whatever depth it says: it takes cores as thin as a few hundred LSB for touching.
static double depth_along(const gjk_collider *a, const gjk_collider *b, const reference_result *found) {
  const double *u = found->normal, length = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  const double n[3] = {u[0] / length, u[1] / length, u[2] / length};
  return reach_along(a, n, 1) + reach_along(b, n, -1);
}

static void judge(const case_pair *pair, const case_collider *a, const case_collider *b, double depth,
                  const precision *in, tally *t) {
  reference_result found;
  in->query(pair, a, b, &found);
  t->overlapping++;
  if (!found.intersecting) {
    t->decisions++;
    return;
  }
  const double grain = in->grain * ((double)a->collider.radius + b->collider.radius), error = -found.distance - depth;
  // depth - 1 < exact depth <= depth. The depth along any direction, so also the reference's, is at least the exact
  // depth.
  const double along = depth_along(&a->collider, &b->collider, &found);
  CHECK_MSG(along > depth - 1.01, "%s: depth %.0f, but %s knows of %.3f", pair->id, depth, in->name, along);
  const double off = error > 0 ? error : error < -1 ? -1 - error : 0;
  t->depths += !(off <= 1 + grain);
  t->error = off > t->error ? off : t->error;
  t->stuck += !parts(&a->collider, &b->collider, &found);
}

static void judge_pair(const case_pair *pair, case_collider *a, case_collider *b, tally *t) {
  gjk_penetration_result truth;
  const bool proven = case_pair_build(pair, false, a, b) && find_truth(&a->collider, &b->collider, &truth);
  CHECK_MSG(proven, "%s", pair->id);
  for (unsigned i = 0; i < PRECISIONS && proven && truth.intersecting; i++) {
    judge(pair, a, b, truth.depth, &precisions[i], &t[i]);
  }
}

static void print_tally(const char *family, const precision *in, const tally *t) {
  printf("%-20s of %5u that overlap %-6s says apart %4u; %5u depths off, at most %9.4g LSB; %5u moves do not part\n",
         family, t->overlapping, in->name, t->decisions, t->depths, t->error, t->stuck);
}

static void run_table(const generate_family *families, unsigned count, tally *all) {
  static case_pair pair;
  static case_collider a, b;
  for (unsigned i = 0; i < count; i++) {
    tally t[PRECISIONS] = {{0, 0, 0, 0, 0}};
    for (uint64_t k = 0; k < PAIRS_PER_FAMILY; k++) {
      generate_pair(&families[i], check_seed(SEED) + k, &pair);
      judge_pair(&pair, &a, &b, t);
    }
    for (unsigned n = 0; n < PRECISIONS; n++) {
      print_tally(families[i].name, &precisions[n], &t[n]);
      all[n].overlapping += t[n].overlapping;
      all[n].decisions += t[n].decisions;
      all[n].depths += t[n].depths;
      all[n].stuck += t[n].stuck;
      all[n].error = fmax(all[n].error, t[n].error);
    }
  }
  case_pair_release(&pair, &a, &b);
}

int main(void) {
  tally all[PRECISIONS] = {{0, 0, 0, 0, 0}};
  run_table(generate_overlaps, generate_overlap_count, all);
  run_table(generate_families, generate_family_count, all);
  for (unsigned n = 0; n < PRECISIONS; n++) {
    print_tally("all families", &precisions[n], &all[n]);
    // The reference must mostly be right, or it would check nothing.
    CHECK(all[n].overlapping > PAIRS_PER_FAMILY * generate_overlap_count / 2);
    CHECK_MSG((all[n].decisions + all[n].depths) * 4 < all[n].overlapping, "%s", precisions[n].name);
  }
  return check_done("reference-depth");
}
