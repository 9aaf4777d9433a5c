// Many pairs in one call, for the Python module: two shapes at many poses each.
#include "gjk/gjk.h"

// The signed distance of pair i, between A at poses_a[i * step_a] and B at poses_b[i * step_b].
//
// step_a, step_b   1, or 0 where the shape stands.
// cells, count     a workspace for depths. NULL: depths are not looked for, and count as 0 upwards from minus infinity:
//                  lower is INT32_MIN, upper 0.
// lower, upper     proven bounds of each, LSB.
// Returns the first status that leaves a pair without bounds, and its number in failed.
gjk_status gjk_batch_signed_distance(const gjk_shape *a, const gjk_shape *b, const gjk_pose *poses_a, uint32_t step_a,
                                     const gjk_pose *poses_b, uint32_t step_b, uint32_t pairs, gjk_epa_cell *cells,
                                     uint32_t count, int32_t *lower, int32_t *upper, uint32_t *failed) {
  const gjk_workspace workspace = {cells, count};
  gjk_collider at = {0}, bt = {0};
  gjk_status status = gjk_collider_init(&at, a, NULL, 0);
  status = status == GJK_OK ? gjk_collider_init(&bt, b, NULL, 0) : status;
  *failed = 0;
  for (uint32_t i = 0; i < pairs && status == GJK_OK; i++) {
    gjk_distance_result gap;
    *failed = i;
    if (step_a != 0 || i == 0) {
      status = gjk_collider_pose(&at, &poses_a[(size_t)i * step_a]);
    }
    if (status == GJK_OK && (step_b != 0 || i == 0)) {
      status = gjk_collider_pose(&bt, &poses_b[(size_t)i * step_b]);
    }
    if (status != GJK_OK) {
      break;
    }
    status = cells != NULL ? gjk_signed_distance(&at, &bt, NULL, &workspace, &gap) : gjk_distance(&at, &bt, NULL, &gap);
    if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT || status == GJK_ERROR_CAPACITY) {
      lower[i] = cells == NULL && gap.intersecting ? INT32_MIN : gap.lower;
      upper[i] = gap.upper;
      status = GJK_OK;
    }
  }
  return status;
}

// Where the proofs of an edge are kept.
typedef struct batch_proofs {
  gjk_arm_proof *proofs;
  uint32_t count, capacity;
} batch_proofs;

static void batch_take(void *user, const gjk_arm_proof *proof) {
  batch_proofs *kept = user;
  if (kept->count < kept->capacity) {
    kept->proofs[kept->count] = *proof;
  }
  kept->count++;  // one for a test, of which there are at most 2^32 - 1
}

// Many edges, each from configuration i of from to that of to.
//
// tests             the most of an edge.
// proofs, capacity  a place for the proofs of an edge: each answer is then checked. NULL: none is.
// out               one for each edge.
// Returns the first status that leaves an edge without an answer or a proof, and its number in failed. CAPACITY: there
// are more proofs than places.
gjk_status gjk_batch_edges(gjk_arm *arm, const int32_t *from, const int32_t *to, uint32_t edges,
                           const gjk_arm_setup *setup, uint32_t tests, gjk_arm_proof *proofs, uint32_t capacity,
                           gjk_arm_edge_result *out, uint32_t *failed) {
  const size_t values = gjk_arm_values(arm->model);
  gjk_status status = GJK_OK;
  *failed = 0;
  for (uint32_t i = 0; i < edges && status == GJK_OK; i++) {
    batch_proofs kept = {proofs, 0, capacity};
    const int32_t *a = &from[i * values], *b = &to[i * values];
    *failed = i;
    status = gjk_arm_edge_start(arm, a, b, setup, proofs != NULL ? batch_take : NULL, &kept);
    status = status == GJK_OK ? gjk_arm_edge_run(arm, tests, &out[i]) : status;
    if (status == GJK_ERROR_ITERATION_LIMIT) {
      status = GJK_OK;  // the answer is UNSETTLED
    }
    if (status == GJK_OK && proofs != NULL) {
      status =
          kept.count > capacity ? GJK_ERROR_CAPACITY : gjk_check_edge(arm, a, b, setup, &out[i], proofs, kept.count);
    }
  }
  return status;
}
