// The time of impact of bodies of many parts.
//
// 1. The region: where A does not turn, it is what a sphere about B's position covers on its way. Else it is the box that B
//    is in as seen from A, at any rotation.
// 2. Ask the part that the class guesses to be near, which checks B and the setup, then those in the region.
// 3. Where parts have reached their ceiling, go through what is left of the region again, as gjk_parts_first.c does.
//
// Of two such bodies each part of B has a region of its own. What is left of it depends on the first hit of all.
#include "../arith/gjk_memory.h"
#include "../arith/gjk_root.h"
#include "../motion/gjk_impact.h"
#include "../motion/gjk_motion.h"
#include "gjk_parts_both.h"
#include "gjk_parts_first.h"

// A query, and the first impact so far.
typedef struct impact_search {
  gjk_parts body;  // A at the start
  gjk_parts_frame frame;
  gjk_region region;
  const gjk_motion *motion[2];
  const gjk_impact_setup *setup;
  bool turns[2];
  gjk_carried of[2];  // the part of A; B, or the part of it that is asked
  uint32_t number_b;  // of that part; else 0
  gjk_impact_result result[2];
  unsigned best;
  uint32_t part, part_of_b;
  gjk_q30 latest;  // what is left of the way: up to the first hit
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
  const gjk_collider *b = s->of[1].collider;
  if (b->state != GJK_STATE_INITIALISED && b->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const uint32_t reach = s->body.type->reach(s->body.data);
  return setup->margin > GJK_IMPACT_MARGIN_MAX ||
                 setup->tolerance * INT64_C(256) < least_tolerance(reach, reach_of_b(b), setup->margin) ||
                 !gjk_parts_has_room(&s->body, &s->motion[0]->to.position)
             ? GJK_ERROR_RANGE
             : GJK_OK;
}

static void set_carried(gjk_carried *body, const gjk_collider *c, const gjk_motion *motion, const gjk_pose *own,
                        uint32_t arm) {
  body->collider = c;
  body->motion = motion;
  body->own = own;
  body->arm = arm;
}

static gjk_status find_turning(impact_search *s, unsigned body) {
  gjk_turning turning;
  const gjk_status status = gjk_turning_start(s->motion[body], &turning);
  s->turns[body] = status == GJK_OK && turning.half_turns != 0;
  return status;
}

// The larger of the sizes of two numbers, which are below 2^33 in size.
GJK_ONE_COPY static int64_t larger_size(int64_t x, int64_t y) {
  const int64_t a = (int64_t)gjk_magnitude64(x), b = (int64_t)gjk_magnitude64(y);
  return a > b ? a : b;
}

GJK_ONE_COPY static void cut_impact_region(impact_search *s) {
  if (s->region.moves && s->latest < GJK_Q30_ONE) {
    gjk_region_cut(&s->region, s->latest);
  }
}

// Step 1. The sum of the sizes of B's place against A, along each axis, is at least how far away it is.
//
// box, around  a box, and how far around it B is: at the start, and as far as its way has carried the box later.
// reach_b      how far B's points are from the position of its pose, at most.
static void start_impact_region(impact_search *s, const gjk_aabb *box, int64_t around, int64_t reach_b) {
  const gjk_motion *a = s->motion[0], *b = s->motion[1];
  const gjk_vec3 *a0 = &a->from.position, *a1 = &a->to.position, *b0 = &b->from.position, *b1 = &b->to.position;
  const int64_t x0 = (int64_t)b0->x - a0->x, y0 = (int64_t)b0->y - a0->y, z0 = (int64_t)b0->z - a0->z;
  const int64_t x1 = (int64_t)b1->x - a1->x, y1 = (int64_t)b1->y - a1->y, z1 = (int64_t)b1->z - a1->z;
  const int64_t near = (int64_t)s->setup->margin + s->setup->tolerance + GJK_PARTS_EARLY;
  const gjk_long3 way = {x1 - x0, y1 - y0, z1 - z0};
  if (!s->turns[0] && (gjk_magnitude64(way.x) | gjk_magnitude64(way.y) | gjk_magnitude64(way.z)) >> 32 == 0) {
    gjk_region_start(&s->region, s->frame.rows, a0, box, &way);
    gjk_region_grow(&s->region, near + around);
  } else {
    const gjk_aabb at = {*a0, *a0};
    gjk_region_start(&s->region, s->frame.rows, a0, &at, NULL);
    gjk_region_grow(&s->region, near + reach_b + larger_size(x0, x1) + larger_size(y0, y1) + larger_size(z0, z1));
  }
  cut_impact_region(s);
}

// Does a trial come before the best so far? As is_sooner of gjk_parts_first.c.
static bool is_earlier(const impact_search *s, const gjk_impact_result *trial, gjk_status status, uint32_t part) {
  const gjk_impact_result *best = &s->result[s->best];
  if (s->part == GJK_PARTS_NONE) {
    return true;
  }
  if (trial->lower != best->lower) {
    return trial->lower < best->lower;
  }
  if (status != s->status) {
    return status == GJK_OK;
  }
  if (trial->overlap != best->overlap) {
    return trial->overlap;
  }
  return s->number_b != s->part_of_b ? s->number_b < s->part_of_b : part < s->part;
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
  set_carried(&s->of[0], &c, s->motion[0], local.own, s->body.type->reach(s->body.data));
  status = gjk_impact_of_carried(s->of, s->setup, gjk_pose_compose, trial);
  set_carried(&s->of[0], NULL, s->motion[0], NULL, 0);  // the part goes with this call
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return status;
  }
  const bool limited = status != GJK_OK;
  s->limited = s->limited || limited;
  if (limited == bound && (limited || trial->hit) && is_earlier(s, trial, status, part)) {
    s->best = 1 - s->best;
    s->part = part;
    s->part_of_b = s->number_b;
    s->status = status;
    if (!bound) {
      s->latest = trial->lower < GJK_Q30_ONE ? trial->lower + 1 : trial->lower;
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

// Starts a query. B is to be set.
GJK_ONE_COPY static void start_impact_search(impact_search *s, const gjk_parts *a, const gjk_motion *motion_a,
                                             const gjk_motion *motion_b, const gjk_impact_setup *setup) {
  s->body.type = a->type;
  s->body.data = a->data;
  gjk_copy(&s->body.pose, &motion_a->from, sizeof s->body.pose);
  s->motion[0] = motion_a;
  s->motion[1] = motion_b;
  s->setup = setup;
  s->number_b = 0;
  s->best = 0;
  s->part = GJK_PARTS_NONE;
  s->part_of_b = GJK_PARTS_NONE;
  s->latest = GJK_Q30_ONE;
  s->status = GJK_OK;
  s->limited = false;
}

static gjk_status report_impact_of_parts(const impact_search *s, gjk_impact_result *out) {
  if (s->part == GJK_PARTS_NONE) {
    report_miss_of_parts(s, out);
  } else {
    gjk_copy(out, &s->result[s->best], sizeof *out);
  }
  return s->status;
}

gjk_status gjk_parts_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                    const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                    gjk_impact_result *out) {
  impact_search s;
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  start_impact_search(&s, a, motion_a, motion_b, setup);
  set_carried(&s.of[1], b, motion_b, NULL, 0);
  gjk_status status = gjk_parts_frame_set(&s.frame, &s.body);
  status = status == GJK_OK ? check_impact_of_parts(&s) : status;
  status = status == GJK_OK ? find_turning(&s, 0) : status;
  if (status != GJK_OK) {
    return status;
  }
  const gjk_aabb at = {motion_b->from.position, motion_b->from.position};
  start_impact_region(&s, &at, reach_of_b(b), reach_of_b(b));
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
  return report_impact_of_parts(&s, out);
}

// As check_impact_of_parts, of two bodies. The slack of a pair of parts (gjk_impact.c) is at most 22 LSB and 2^-23 of what
// both reaches are there, which count a part's radius too: they are below 4 times the bodies'. 256 units: 8 LSB.
static gjk_status check_impact_of_both(const impact_search *s, const gjk_parts *b) {
  const gjk_impact_setup *setup = s->setup;
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const int64_t reach_a = s->body.type->reach(s->body.data), reach_b = b->type->reach(b->data);
  const int64_t excess = reach_a + reach_b - (INT64_C(256) << 16), far = INT64_C(1) << 28;
  const int64_t least = (int64_t)GJK_PARTS_BOTH_TOLERANCE_MIN * 256 + (excess > 0 ? gjk_sar64(excess, 13) + 1 : 0) +
                        (reach_a > far ? 11 * 256 : 0) + (reach_b > far ? 11 * 256 : 0) + gjk_sar64(setup->margin, 18);
  return setup->margin > GJK_IMPACT_MARGIN_MAX || setup->tolerance * INT64_C(256) < least ||
                 !gjk_parts_has_room(&s->body, &s->motion[0]->to.position) ||
                 !gjk_parts_has_room(b, &s->motion[1]->to.position)
             ? GJK_ERROR_RANGE
             : GJK_OK;
}

// How far the points of a part are from the position of its body's pose, at most.
//   as seen from there the centre is within the body's reach, at most 2^31:  squares at most 2^62
//   of a body whose reach is wrong they may wrap
static int64_t reach_of_part(const gjk_collider *c, const gjk_vec3 *position) {
  const uint64_t x = (uint64_t)((int64_t)c->centre.x - position->x), y = (uint64_t)((int64_t)c->centre.y - position->y),
                 z = (uint64_t)((int64_t)c->centre.z - position->z);
  return (int64_t)gjk_isqrt64(x * x + y * y + z * z) + c->radius + 8;
}

// Asks the pairs of one part of B. A part that does not turn stays in its box, as far as that has gone; one that turns stays
// around its body's position.
static gjk_status ask_part_of_b(impact_search *s, const gjk_parts_frame *of_b, bool bound) {
  gjk_parts_room room;
  gjk_parts_local local;
  gjk_collider c;
  gjk_aabb box;
  const gjk_parts *b = of_b->parts;
  const gjk_vec3 *at = &b->pose.position;
  gjk_status status = gjk_parts_place_in(of_b, s->number_b, &room, &c);
  if (gjk_parts_both_lacks(&status)) {
    return GJK_OK;
  }
  status = status == GJK_OK ? gjk_collider_aabb(&c, &box) : status;
  if (status != GJK_OK) {
    return status;
  }
  const int64_t reach = reach_of_part(&c, at);
  if (s->turns[1]) {
    box.lower = *at;
    box.upper = *at;
  }
  start_impact_region(s, &box, s->turns[1] ? reach : 0, reach);
  status = b->type->local(b->data, s->number_b, &room, &local);
  status = status == GJK_OK ? gjk_collider_init(&c, local.shape, NULL, 0) : status;
  if (status != GJK_OK) {
    return status;
  }
  set_carried(&s->of[1], &c, s->motion[1], local.own, b->type->reach(b->data));
  status = ask_region(s, GJK_PARTS_NONE, bound);
  set_carried(&s->of[1], NULL, s->motion[1], NULL, 0);  // the part goes with this call
  return status;
}

static gjk_status ask_parts_of_b(impact_search *s, const gjk_parts_frame *of_b, bool bound) {
  const uint32_t count = gjk_parts_count(of_b->parts);
  gjk_status status = GJK_OK;
  for (uint32_t i = 0; i < count && status == GJK_OK; i++) {
    s->number_b = i;
    status = ask_part_of_b(s, of_b, bound);
  }
  return status;
}

gjk_status gjk_parts_both_time_of_impact(const gjk_parts *a, const gjk_motion *motion_a, const gjk_parts *b,
                                         const gjk_motion *motion_b, const gjk_impact_setup *setup,
                                         gjk_parts_pair *parts, gjk_impact_result *out) {
  impact_search s;
  gjk_parts_frame of_b;
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_parts other;
  other.type = b->type;
  other.data = b->data;
  gjk_copy(&other.pose, &motion_b->from, sizeof other.pose);
  start_impact_search(&s, a, motion_a, motion_b, setup);
  gjk_status status = gjk_parts_frame_set(&s.frame, &s.body);
  status = status == GJK_OK ? gjk_parts_frame_set(&of_b, &other) : status;
  status = status == GJK_OK ? check_impact_of_both(&s, &other) : status;
  status = status == GJK_OK ? find_turning(&s, 0) : status;
  status = status == GJK_OK ? find_turning(&s, 1) : status;
  status = status == GJK_OK ? ask_parts_of_b(&s, &of_b, false) : status;
  if (status == GJK_OK && s.limited) {
    status = ask_parts_of_b(&s, &of_b, true);
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_parts_write_numbers(s.part, s.part_of_b, parts);
  return report_impact_of_parts(&s, out);
}
