// Checks the answer to an edge by its proofs, without a search.
//
//   1. Each proof: the span is dyadic and begins where the pair's last one ended; along the direction the pair is apart at
//      both ends by more than margin, bend and slack, and by no less than the gap that a FREE answer claims.
//   2. All pairs are proven up to lower, of a FREE answer to the end of the edge.
//   3. A TOUCH: at upper the named pair is within margin and tolerance.
#include "../arith/gjk_vector.h"
#include "gjk_arm_body.h"
#include "gjk_arm_bound.h"
#include "gjk_arm_edge.h"
#include "gjk_arm_span.h"

// The steps of both frames that are set; GJK_ARM_NO_PAIR: none.
typedef struct edge_frames {
  uint32_t step[2];
} edge_frames;

static void set_frame(gjk_arm *arm, edge_frames *frames, unsigned which, uint32_t step) {
  if (frames->step[which] != step) {
    gjk_arm_set_frames(arm, step, which);
    frames->step[which] = step;
  }
}

// Is the fraction, of Q30, a whole number of steps?
static bool to_step(gjk_q30 fraction, uint32_t *step) {
  *step = (uint32_t)fraction >> (30 - GJK_ARM_DEPTH_MAX);
  return fraction >= 0 && fraction <= GJK_Q30_ONE && ((uint32_t)fraction & (uint32_t)(GJK_ARM_STEP_Q30 - 1)) == 0;
}

// The depth of a dyadic span; false: it is none.
static bool depth_of(uint32_t from, uint32_t to, unsigned *depth) {
  *depth = 0;
  if (to <= from) {
    return false;
  }
  while (*depth < GJK_ARM_DEPTH_MAX && GJK_ARM_STEPS >> *depth > to - from) {
    (*depth)++;
  }
  return to - from == GJK_ARM_STEPS >> *depth && (from & (to - from - 1)) == 0;
}

bool gjk_arm_is_direction(const gjk_unit3 *n) {
  const gjk_vec3 v = {n->x, n->y, n->z};
  const int64_t most = INT64_C(1) << 60;
  const uint32_t one = (uint32_t)GJK_Q30_ONE;
  if (gjk_magnitude32(n->x) > one || gjk_magnitude32(n->y) > one || gjk_magnitude32(n->z) > one) {
    return false;
  }
  // As gjk_unit makes it: each component within 1, so the square within 2 sqrt(3) 2^30 and 3
  const int64_t off = gjk_dot(&v, &v) - most;  // below 3 2^60
  return off <= INT64_C(1) << 32 && off >= -(INT64_C(1) << 32);
}

// Step 1 for the first of count proofs, or those of one span of a body. How many it takes; 0: they are refused.
static uint32_t check_proof(gjk_arm *arm, edge_frames *frames, const gjk_arm_edge_result *result,
                            const gjk_arm_proof *proof, uint32_t count) {
  uint32_t from, to;
  unsigned depth;
  int64_t gap;
  gjk_arm_view view;
  if (proof->pair >= arm->pair_count || !to_step(proof->from, &from) || !to_step(proof->to, &to) ||
      !depth_of(from, to, &depth)) {
    return 0;
  }
  gjk_arm_pair *pair = &arm->memory.pairs[proof->pair];
  const int64_t bend = gjk_arm_bend(pair, depth);
  const gjk_q16 least = result->answer == GJK_ARM_FREE ? result->gap : 0;
  if (pair->done != from || bend < 0) {
    return 0;
  }
  set_frame(arm, frames, 0, from);
  set_frame(arm, frames, 1, to);
  if (pair->frame == GJK_ARM_BODY) {
    return arm->type->check(arm, proof, count, bend, least > arm->setup.margin ? least : arm->setup.margin);
  }
  gjk_arm_look(arm, pair, gjk_arm_obstacle(arm, pair), 0, 1, &view);
  if (!gjk_arm_is_direction(&proof->direction) || !gjk_arm_gap(&view, &proof->direction, &gap) ||
      gap <= gjk_shl64(arm->setup.margin + bend + pair->slack, 30)) {
    return 0;
  }
  pair->done = to;
  return gjk_sar64(gap, 30) - bend - pair->slack >= least ? 1 : 0;
}

// Step 3.
static bool check_touch(gjk_arm *arm, edge_frames *frames, const gjk_arm_edge_result *result, uint32_t upper) {
  set_frame(arm, frames, 0, upper);
  for (uint32_t i = 0; i < arm->pair_count; i++) {
    const gjk_arm_pair *pair = &arm->memory.pairs[i];
    gjk_arm_names names;
    gjk_arm_name(pair, result->pair.piece, &names);
    if (names.part == result->pair.part && names.other == result->pair.other &&
        names.obstacle == result->pair.obstacle && names.piece == result->pair.piece) {
      return pair->frame != GJK_ARM_BODY ? gjk_arm_touches(arm, pair, 0)
                                         : arm->type->touches(arm, pair, 0, result->pair.piece,
                                                              (int64_t)arm->setup.margin + arm->setup.tolerance);
    }
  }
  return false;
}

// The fractions that an answer may have.
static bool check_fractions(const gjk_arm_edge_result *result, uint32_t *lower, uint32_t *upper) {
  if (!to_step(result->lower, lower) || !to_step(result->upper, upper)) {
    return false;
  }
  switch (result->answer) {
    case GJK_ARM_FREE: return *lower == GJK_ARM_STEPS && *upper == GJK_ARM_STEPS;
    case GJK_ARM_TOUCH: return *lower <= *upper;
    case GJK_ARM_UNSETTLED: return *upper == GJK_ARM_STEPS;
  }
  return false;
}

gjk_status gjk_check_edge(gjk_arm *arm, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                          const gjk_arm_edge_result *result, const gjk_arm_proof *proofs, uint32_t count) {
  edge_frames frames = {{GJK_ARM_NO_PAIR, GJK_ARM_NO_PAIR}};
  uint32_t lower = 0, upper = 0;
  gjk_status status = gjk_arm_check_edge_arguments(arm, from, to, setup);
  if (status == GJK_OK && (result == NULL || (proofs == NULL && count > 0))) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    status = gjk_arm_set_edge(arm, from, to);
  }
  if (status != GJK_OK) {
    return status;
  }
  arm->setup = *setup;
  bool proven = check_fractions(result, &lower, &upper);
  for (uint32_t i = 0; i < arm->pair_count; i++) {
    arm->memory.pairs[i].done = 0;
  }
  for (uint32_t i = 0, used; proven && i < count; i += used) {
    used = check_proof(arm, &frames, result, &proofs[i], count - i);
    proven = used > 0;
  }
  for (uint32_t i = 0; proven && i < arm->pair_count; i++) {
    proven = arm->memory.pairs[i].done >= lower;
  }
  proven = proven && (result->answer != GJK_ARM_TOUCH || check_touch(arm, &frames, result, upper));
  return proven ? GJK_OK : GJK_ERROR_UNPROVEN;
}
