// The time of impact of bodies of many parts.
//
// 1. The region: where A does not turn, it is what a sphere about B's position covers on its way. Else it is the box that B
//    is in as seen from A, at any rotation.
// 2. Ask the part that the class guesses to be near, which checks B and the setup, then those in the region.
// 3. Where parts have reached their ceiling, go through what is left of the region again, as gjk_parts_first.c does.
#include "../arith/gjk_memory.h"
#include "../arith/gjk_root.h"
#include "../motion/gjk_impact.h"
#include "../motion/gjk_motion.h"
#include "gjk_parts_first.h"

// A query, and the first impact so far.
typedef struct impact_search {
  gjk_parts body;  // A at the start
  gjk_parts_frame frame;
  gjk_region region;
  const gjk_motion *motion[2];
  const gjk_collider *b;
  const gjk_impact_setup *setup;
  gjk_impact_result result[2];
  unsigned best;
  uint32_t part;
  gjk_status status;
  bool limited;
} impact_search;

// How far a point of B is from its pose's position at most.
//   each square at most 2^62, their root below 2^32; radius below 2^28
static int64_t reach_of_b(const gjk_collider *b) {
  const gjk_vec3 *away = &b->local_centre;
  const uint64_t squared = (uint64_t)gjk_mul32(away->x, away->x) + (uint64_t)gjk_mul32(away->y, away->y) +
                           (uint64_t)gjk_mul32(away->z, away->z);
  return (int64_t)gjk_isqrt64(squared) + b->radius + 8;
}

// The least tolerance for parts within reach of the body's position, Q8 (gjk_impact.c): what the first 256 units of both
// together take, 2^-23 of the rest, and of composed positions far away 4 sqrt(3), not sqrt(3), twice.
static int64_t least_tolerance(uint32_t reach, int64_t of_b, gjk_q16 margin) {
  const int64_t excess = (int64_t)reach + of_b - (INT64_C(256) << 16);
  return (int64_t)GJK_PARTS_TOLERANCE_MIN * 256 + (excess > 0 ? gjk_sar64(excess, 15) + 2 : 0) +
         (reach > UINT32_C(1) << 28 ? 11 * 256 : 0) + gjk_sar64(margin, 18);
}

static gjk_status check_impact_of_parts(const impact_search *s) {
  const gjk_impact_setup *setup = s->setup;
  if (s->b->state != GJK_STATE_INITIALISED && s->b->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const uint32_t reach = s->body.type->reach(s->body.data);
  return setup->margin > GJK_IMPACT_MARGIN_MAX ||
                 setup->tolerance * INT64_C(256) < least_tolerance(reach, reach_of_b(s->b), setup->margin) ||
                 !gjk_parts_has_room(&s->body, &s->motion[0]->to.position)
             ? GJK_ERROR_RANGE
             : GJK_OK;
}

// The larger of the sizes of two numbers, which are below 2^33 in size.
static int64_t larger_size(int64_t x, int64_t y) {
  const int64_t a = (int64_t)gjk_magnitude64(x), b = (int64_t)gjk_magnitude64(y);
  return a > b ? a : b;
}

// Step 1. The sum of the sizes of B's place against A, along each axis, is at least how far away it is.
static gjk_status start_impact_region(impact_search *s) {
  const gjk_motion *a = s->motion[0], *b = s->motion[1];
  const gjk_vec3 *a0 = &a->from.position, *a1 = &a->to.position, *b0 = &b->from.position, *b1 = &b->to.position;
  const int64_t x0 = (int64_t)b0->x - a0->x, y0 = (int64_t)b0->y - a0->y, z0 = (int64_t)b0->z - a0->z;
  const int64_t x1 = (int64_t)b1->x - a1->x, y1 = (int64_t)b1->y - a1->y, z1 = (int64_t)b1->z - a1->z;
  const int64_t near = reach_of_b(s->b) + s->setup->margin + s->setup->tolerance + GJK_PARTS_EARLY;
  const gjk_long3 way = {x1 - x0, y1 - y0, z1 - z0};
  gjk_turning turning;
  gjk_aabb box;
  const gjk_status status = gjk_turning_start(a, &turning);
  if (status != GJK_OK) {
    return status;
  }
  box.lower = *b0;
  box.upper = *b0;
  if (turning.half_turns == 0 &&
      (gjk_magnitude64(way.x) | gjk_magnitude64(way.y) | gjk_magnitude64(way.z)) >> 32 == 0) {
    gjk_region_start(&s->region, s->frame.rows, a0, &box, &way);
    gjk_region_grow(&s->region, near);
    return GJK_OK;
  }
  box.lower = *a0;
  box.upper = *a0;
  gjk_region_start(&s->region, s->frame.rows, a0, &box, NULL);
  gjk_region_grow(&s->region, near + larger_size(x0, x1) + larger_size(y0, y1) + larger_size(z0, z1));
  return GJK_OK;
}

// Does a trial come before the best so far? As is_sooner of gjk_parts_first.c.
static bool is_earlier(const impact_search *s, const gjk_impact_result *trial, gjk_status status, uint32_t part) {
  const gjk_q30 best = s->result[s->best].lower;
  if (s->part == GJK_PARTS_NONE || trial->lower != best) {
    return s->part == GJK_PARTS_NONE || trial->lower < best;
  }
  if (status != s->status) {
    return status == GJK_OK;
  }
  if (trial->overlap != s->result[s->best].overlap) {
    return trial->overlap;
  }
  return part < s->part;
}

static void cut_impact_region(impact_search *s) {
  const gjk_q30 fraction = s->result[s->best].lower;
  if (s->part != GJK_PARTS_NONE && s->region.moves) {
    gjk_region_cut(&s->region, fraction < GJK_Q30_ONE ? fraction + 1 : fraction);
  }
}

// Asks one part. bound: takes it if it has reached its ceiling; else if it is hit.
static gjk_status ask_impact(impact_search *s, uint32_t part, bool bound) {
  gjk_parts_room room;
  gjk_parts_local local;
  gjk_collider c;
  gjk_impact_result *trial = &s->result[1 - s->best];
  gjk_status status = s->body.type->local(s->body.data, part, &room, &local);
  status = status == GJK_OK ? gjk_collider_init(&c, local.shape, NULL, 0) : status;
  if (status != GJK_OK) {
    return status;
  }
  const gjk_carried of[2] = {{&c, s->motion[0], local.own, s->body.type->reach(s->body.data)},
                             {s->b, s->motion[1], NULL, 0}};
  status = gjk_impact_of_carried(of, s->setup, trial);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return status;
  }
  const bool limited = status != GJK_OK;
  s->limited = s->limited || limited;
  if (limited == bound && (limited || trial->hit) && is_earlier(s, trial, status, part)) {
    s->best = 1 - s->best;
    s->part = part;
    s->status = status;
    if (!bound) {
      cut_impact_region(s);
    }
  }
  return GJK_OK;
}

// Asks the parts in the region but one.
static gjk_status ask_region(impact_search *s, uint32_t but, bool bound) {
  gjk_parts_walk walk;
  uint32_t part;
  gjk_status status = GJK_OK;
  gjk_parts_walk_start(&walk);
  while (status == GJK_OK && gjk_parts_next(&s->frame, &s->region, &walk, &part)) {  // ends: each part comes once
    if (part != but) {
      status = ask_impact(s, part, bound);
    }
  }
  return status;
}

static void report_miss_of_parts(const impact_search *s, gjk_impact_result *out) {
  out->hit = false;
  out->overlap = false;
  out->lower = GJK_Q30_ONE;
  out->upper = GJK_Q30_ONE;
  out->iterations = 0;
  (void)gjk_motion_pose(s->motion[0], GJK_Q30_ONE, &out->pose_a);  // both have been checked
  (void)gjk_motion_pose(s->motion[1], GJK_Q30_ONE, &out->pose_b);
}

gjk_status gjk_parts_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                    const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                    gjk_impact_result *out) {
  impact_search s;
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  s.body.type = a->type;
  s.body.data = a->data;
  gjk_copy(&s.body.pose, &motion_a->from, sizeof s.body.pose);
  s.motion[0] = motion_a;
  s.motion[1] = motion_b;
  s.b = b;
  s.setup = setup;
  s.best = 0;
  s.part = GJK_PARTS_NONE;
  s.status = GJK_OK;
  s.limited = false;
  gjk_status status = gjk_parts_frame_set(&s.frame, &s.body);
  status = status == GJK_OK ? check_impact_of_parts(&s) : status;
  status = status == GJK_OK ? start_impact_region(&s) : status;
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t guess = a->type->guess(a->data, &s.region);
  status = guess != GJK_PARTS_NONE ? ask_impact(&s, guess, false) : GJK_OK;  // Step 2
  status = status == GJK_OK ? ask_region(&s, guess, false) : status;
  if (status == GJK_OK && s.limited) {
    status = ask_region(&s, GJK_PARTS_NONE, true);  // Step 3
  }
  if (status != GJK_OK) {
    return status;
  }
  if (part != NULL) {
    *part = s.part;
  }
  if (s.part == GJK_PARTS_NONE) {
    report_miss_of_parts(&s, out);
  } else {
    gjk_copy(out, &s.result[s.best], sizeof *out);
  }
  return s.status;
}
