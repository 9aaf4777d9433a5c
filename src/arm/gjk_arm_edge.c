// A whole edge: spans of it are halved until every pair is proven apart on each, or a touch is found.
//
//   1. The spans are nodes of a binary tree, looked at from left to right, parents before their children. Both ends of
//      a span have the links' frames, which all pairs share.
//   2. Each pair that is open is searched (gjk_arm_span.c). Apart by more than margin, bend and slack: it is proven on
//      the whole span, and stays so on the spans inside.
//   3. A pair that is close is tested at the span's right end: exactly, by gjk_within. Within margin and tolerance is a
//      touch. Where any touch will do, pairs at the ends of long spans are looked at even if the span is not close. At the
//      left end a pair is tested where the edge begins, and where a touch is known, which ends the search for
//      an earlier one. Spans beyond the first known touch are not looked at.
//   4. A span with an open pair is halved: on with its left half. Else on with the next span to the right.
//   5. A touch is known, and lower is near enough, or the next span begins there: the answer. At the right end: FREE.
//
// All between two tests is in the arm, so it may be interrupted after any.
#include "gjk_arm_edge.h"

#include "gjk/intersect.h"
#include "gjk_arm_body.h"
#include "gjk_arm_bound.h"
#include "gjk_arm_span.h"

// The level of a pair that is open; where a pair was tested for a touch that never was.
#define ARM_OPEN 255
#define ARM_NEVER UINT32_MAX

// Where any touch will do, ends of spans are looked at down to this depth: on random edges each costs less than it saves.
#define ARM_PROBED 2

static gjk_status arm_check_setup(const gjk_arm_setup *setup) {
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  return setup->margin <= GJK_ARM_MARGIN_MAX && setup->tolerance >= GJK_ARM_TOLERANCE_MIN &&
                 setup->tolerance <= GJK_ARM_MARGIN_MAX && setup->resolution >= 0 && setup->resolution <= GJK_Q30_ONE
             ? GJK_OK
             : GJK_ERROR_RANGE;
}

gjk_status gjk_arm_check_edge_arguments(const gjk_arm *arm, const int32_t *from, const int32_t *to,
                                        const gjk_arm_setup *setup) {
  if (arm == NULL || setup == NULL) {
    return GJK_ERROR_NULL;
  }
  if (!gjk_arm_is_ready(arm)) {
    return GJK_ERROR_UNINITIALISED;
  }
  return arm->value_count > 0 && (from == NULL || to == NULL) ? GJK_ERROR_NULL : arm_check_setup(setup);
}

// The steps of a span of the present depth.
static uint32_t span_steps(const gjk_arm *arm) {
  return GJK_ARM_STEPS >> arm->depth;
}

static uint32_t span_start(const gjk_arm *arm) {
  return arm->place * span_steps(arm);  // below GJK_ARM_STEPS
}

// At least half of |b - a|, LSB: its norm is convex, and linear between (1, 0, 0), (1, 1, 0) and (1, 1, 1). It is up to 8 %
// too large. Components of b - a are below 2^28.
static int32_t half_above(const gjk_vec3 *a, const gjk_vec3 *b) {
  const uint32_t x = gjk_magnitude32(b->x - a->x), y = gjk_magnitude32(b->y - a->y), z = gjk_magnitude32(b->z - a->z);
  const uint32_t low = x < y ? x : y, high = x < y ? y : x, most = z > high ? z : high, rest = z > high ? high : z;
  const uint32_t middle = rest > low ? rest : low, least = rest > low ? low : rest;
  // sqrt(2) - 1 and sqrt(3) - sqrt(2), in parts of 1024, rounded up
  return (int32_t)((most + 1) / 2 + (uint32_t)((middle * UINT64_C(425) + least * UINT64_C(326)) >> 11) + 1);
}

// Sets the links' frames at the span's end, and the chords of the parts' centres.
static void set_span_end(gjk_arm *arm) {
  gjk_arm_set_frames(arm, span_start(arm) + span_steps(arm), arm->first ^ 1u);
  for (unsigned i = 0; i < arm->model->part_count; i++) {
    gjk_arm_part_room *part = &arm->memory.parts[i];
    const gjk_vec3 *a = &part->at[0], *b = &part->at[1];
    part->middle.x = a->x + (b->x - a->x) / 2;
    part->middle.y = a->y + (b->y - a->y) / 2;
    part->middle.z = a->z + (b->z - a->z) / 2;
    part->half = half_above(a, b);
  }
}

gjk_status gjk_arm_edge_start(gjk_arm *arm, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                              gjk_arm_proof_function *proof, void *user) {
  gjk_status status = gjk_arm_check_edge_arguments(arm, from, to, setup);
  if (status == GJK_OK) {
    status = gjk_arm_set_edge(arm, from, to);
  }
  if (status != GJK_OK) {
    return status;
  }
  arm->setup.margin = setup->margin;
  arm->setup.tolerance = setup->tolerance;
  arm->setup.resolution = setup->resolution;
  arm->proof = proof;
  arm->user = user;
  arm->next = arm->place = arm->tests = 0;
  arm->depth = arm->first = 0;
  arm->open = arm->within = false;
  arm->fault = GJK_OK;
  arm->upper = GJK_ARM_STEPS;
  arm->touched = GJK_ARM_NO_PAIR;
  arm->gap = GJK_ARM_GAP_MAX;
  for (uint32_t i = 0; i < arm->pair_count; i++) {
    gjk_arm_pair *pair = &arm->memory.pairs[i];
    pair->level = ARM_OPEN;
    pair->done = ARM_NEVER;
    pair->piece = GJK_PARTS_NONE;
    pair->direction.x = pair->direction.y = pair->direction.z = 0;
  }
  gjk_arm_set_frames(arm, 0, 0);
  set_span_end(arm);
  arm->state = GJK_ARM_RUNNING;
  return GJK_OK;
}

bool gjk_arm_touches(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which) {
  gjk_collider part, other;
  gjk_decision decision;
  const gjk_collider *of_other = gjk_arm_place(arm, pair, which, &part, &other);
  // An open answer, of a curved pair, counts as near.
  return gjk_within(&part, of_other, arm->setup.margin + arm->setup.tolerance, NULL, &decision) != GJK_OK ||
         decision.yes;
}

// Step 3: tests a pair at a step, which is an end of the span.
static void test_touch(gjk_arm *arm, uint32_t number, uint32_t step, bool end) {
  const gjk_arm_pair *pair = &arm->memory.pairs[number];
  const unsigned which = arm->first ^ (end ? 1u : 0u);
  uint32_t piece = GJK_PARTS_NONE;
  bool near;
  if (step >= arm->upper && arm->touched != GJK_ARM_NO_PAIR) {
    return;
  }
  if (pair->frame == GJK_ARM_BODY) {
    const int64_t distance = (int64_t)arm->setup.margin + arm->setup.tolerance;
    near = arm->type->near(arm, pair, which, distance, &near, &piece) == GJK_ERROR_ITERATION_LIMIT || near;
  } else {
    near = gjk_arm_touches(arm, pair, which);
  }
  if (near) {
    arm->upper = step;
    arm->touched = number;
    arm->touched_piece = piece;
  }
}

void gjk_arm_prove(gjk_arm *arm, uint32_t number, uint32_t piece, int64_t gap, const gjk_unit3 *direction) {
  arm->gap = gap < arm->gap ? gap : arm->gap;
  if (arm->proof != NULL) {
    const gjk_q30 from = (gjk_q30)span_start(arm) * GJK_ARM_STEP_Q30;
    gjk_arm_proof proof;
    proof.from = from;
    proof.to = from + (gjk_q30)span_steps(arm) * GJK_ARM_STEP_Q30;
    proof.direction.x = direction->x;
    proof.direction.y = direction->y;
    proof.direction.z = direction->z;
    proof.pair = number;
    proof.piece = piece;
    arm->proof(arm->user, &proof);
  }
}

// Where any touch will do, the ends of long spans are looked at even if the span is not close: edges that touch mostly do so
// there. Is a pair perhaps within near at the end of the span?
static bool may_touch_at_end(const gjk_arm *arm, const gjk_arm_pair *pair, int64_t near) {
  const gjk_arm_search search = {near + pair->slack, near + pair->slack};
  gjk_arm_view view;
  gjk_unit3 kept = {0, 0, 0}, direction;
  int64_t gap;
  if (pair->frame == GJK_ARM_BODY) {
    return true;  // a look at all pieces costs no less than the test
  }
  gjk_arm_look(arm, pair, gjk_arm_obstacle(arm, pair), arm->first ^ 1u, arm->first ^ 1u, &view);
  return gjk_arm_separate(&view, &search, &kept, &direction, &gap) == GJK_ARM_CLOSE;
}

// Step 2 for a pair of an obstacle or two parts.
static gjk_arm_found search_arm_pair(gjk_arm *arm, uint32_t number, int64_t bend) {
  gjk_arm_pair *pair = &arm->memory.pairs[number];
  const gjk_collider *obstacle = gjk_arm_obstacle(arm, pair);
  const int64_t off = bend + pair->slack, margin = arm->setup.margin;
  const gjk_arm_search search = {margin + off, margin + arm->setup.tolerance};
  gjk_arm_view view;
  gjk_unit3 direction;
  int64_t gap;
  arm->tests++;
  if (bend < 0) {
    return GJK_ARM_OPEN;
  }
  // A gap above the least so far need not be measured; a proof names its direction.
  if (arm->proof == NULL && obstacle != NULL && gjk_arm_spheres_apart(arm, pair, obstacle, arm->gap + off)) {
    return GJK_ARM_APART;
  }
  gjk_arm_look(arm, pair, obstacle, arm->first, arm->first ^ 1u, &view);
  const gjk_arm_found found = gjk_arm_separate(&view, &search, &pair->direction, &direction, &gap);
  if (found == GJK_ARM_APART) {
    gjk_arm_prove(arm, number, GJK_PARTS_NONE, gjk_sar64(gap, 30) - off, &direction);
  }
  return found;
}

// Steps 2 and 3 for a pair that is open, by at most left tests. False: it is not done.
static bool test_span(gjk_arm *arm, uint32_t number, uint32_t left) {
  gjk_arm_pair *pair = &arm->memory.pairs[number];
  const uint32_t start = span_start(arm), end = start + span_steps(arm);
  const int64_t bend = gjk_arm_bend(pair, arm->depth), near = (int64_t)arm->setup.margin + arm->setup.tolerance;
  gjk_arm_found found = pair->frame == GJK_ARM_BODY && bend >= 0 ? arm->type->span(arm, number, bend, left)
                                                                 : search_arm_pair(arm, number, bend);
  if (found == GJK_ARM_MORE || arm->state != GJK_ARM_RUNNING) {
    return false;
  }
  if (found == GJK_ARM_APART) {
    pair->level = arm->depth;
    return true;
  }
  arm->open = true;
  if (found == GJK_ARM_OPEN && arm->setup.resolution == GJK_Q30_ONE && arm->depth <= ARM_PROBED && bend >= 0 &&
      may_touch_at_end(arm, pair, near)) {
    found = GJK_ARM_CLOSE;
  }
  if (found == GJK_ARM_CLOSE || bend < 0) {
    if ((start == 0 && pair->done == ARM_NEVER) || arm->touched != GJK_ARM_NO_PAIR) {
      test_touch(arm, number, start, false);
    }
    if (pair->done != end) {
      test_touch(arm, number, end, true);
      pair->done = end;
    }
  }
  return true;
}

// Step 4: the left half of the span.
static void halve(gjk_arm *arm) {
  arm->depth++;
  arm->place *= 2;
  set_span_end(arm);
}

// Step 4: the next span to the right. False: there is none. What was proven to the left is open again.
static bool go_right(gjk_arm *arm) {
  while (arm->place % 2 != 0) {  // at most GJK_ARM_DEPTH_MAX times: place < 2^depth
    arm->place /= 2;
    arm->depth--;
  }
  if (arm->depth == 0) {
    return false;
  }
  arm->place++;
  for (uint32_t i = 0; i < arm->pair_count; i++) {
    gjk_arm_pair *pair = &arm->memory.pairs[i];
    pair->level = pair->level >= arm->depth ? ARM_OPEN : pair->level;
  }
  arm->first ^= 1u;  // the end of the last span is the start of this one
  return true;
}

// Is a touch known, and what is proven near enough to it?
static bool is_found(const gjk_arm *arm) {
  return arm->touched != GJK_ARM_NO_PAIR &&
         (arm->upper <= span_start(arm) ||
          (gjk_q30)(arm->upper - span_start(arm)) * GJK_ARM_STEP_Q30 <= arm->setup.resolution);
}

// Steps 4 and 5, after all pairs of a span.
static void end_span(gjk_arm *arm) {
  const bool open = arm->open;
  arm->next = 0;
  arm->open = false;
  if (open && arm->depth == GJK_ARM_DEPTH_MAX) {
    arm->state = arm->touched != GJK_ARM_NO_PAIR ? GJK_ARM_SETTLED : GJK_ARM_STUCK;
  } else if (open) {
    halve(arm);
  } else if (!go_right(arm)) {
    arm->state = GJK_ARM_SETTLED;
    arm->place = 1;  // all of the edge is proven
  } else if (is_found(arm)) {
    arm->state = GJK_ARM_SETTLED;
  } else {
    set_span_end(arm);
  }
}

// Goes to the next open pair, over the ends of spans: of at most twice GJK_ARM_DEPTH_MAX.
static void skip_proven(gjk_arm *arm) {
  while (arm->state == GJK_ARM_RUNNING) {
    while (arm->next < arm->pair_count && arm->memory.pairs[arm->next].level != ARM_OPEN) {
      arm->next++;
    }
    if (arm->next < arm->pair_count) {
      return;
    }
    end_span(arm);
  }
}

static void arm_report(const gjk_arm *arm, gjk_arm_edge_result *out) {
  const bool touch = arm->touched != GJK_ARM_NO_PAIR, settled = arm->state == GJK_ARM_SETTLED;
  const gjk_arm_pair *pair = &arm->memory.pairs[touch ? arm->touched : 0];
  const uint32_t start = span_start(arm), upper = touch ? arm->upper : GJK_ARM_STEPS;
  out->answer = !settled ? GJK_ARM_UNSETTLED : touch ? GJK_ARM_TOUCH : GJK_ARM_FREE;
  out->lower = (gjk_q30)(start < upper ? start : upper) * GJK_ARM_STEP_Q30;
  out->upper = settled && touch ? (gjk_q30)upper * GJK_ARM_STEP_Q30 : GJK_Q30_ONE;
  out->tests = arm->tests;
  out->outside = arm->outside;
  if (out->answer == GJK_ARM_FREE) {
    out->gap = (gjk_q16)arm->gap;
  }
  if (out->answer == GJK_ARM_TOUCH) {
    gjk_arm_name(pair, arm->touched_piece, &out->pair);
  }
}

gjk_status gjk_arm_edge_run(gjk_arm *arm, uint32_t tests, gjk_arm_edge_result *out) {
  if (arm == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (!gjk_arm_is_ready(arm) || arm->state == GJK_ARM_READY) {
    return GJK_ERROR_UNINITIALISED;
  }
  const uint32_t before = arm->tests;
  skip_proven(arm);
  while (arm->state == GJK_ARM_RUNNING && arm->tests - before < tests) {
    arm->next += test_span(arm, arm->next, tests - (arm->tests - before)) ? 1u : 0u;
    if (arm->state == GJK_ARM_RUNNING && is_found(arm)) {
      arm->state = GJK_ARM_SETTLED;
    }
    skip_proven(arm);
  }
  arm_report(arm, out);
  if (arm->fault != GJK_OK) {
    return arm->fault;
  }
  return arm->state == GJK_ARM_STUCK ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}
