// The time of impact of two shapes that move and turn.
//
//   1. Pose both at x and measure their distance. If it is at most margin plus tolerance, exactly: a hit. The first x
//      is where the bodies' spheres meet; if they do not: a miss.
//   2. Take the normal as a direction. It turns with the shape that has more vertices in the nearest feature; where those
//      are two edges it turns as the normal across both does at x; else it stands still.
//   3. The next x is where the separation along it is no longer proven to be above the margin plus the slack of
//      roundings (gjk_impact_separation.h). At the end of the way: a miss. Otherwise go on from 1.
//
// So until x no posed shapes come within the margin. A distance above margin plus tolerance is a separation above
// margin plus slack, since the tolerance is larger than the slack. So each round advances.
//
// The slack, by body, from the shapes as posed at x by their motion in real numbers to those posed at any later
// fraction, along any direction; lengths in LSB, with r for the distance of the farthest point, convex radius included,
// from the pose's position:
//   posing, twice            vertices sqrt(3) 3/4 each; of half axes sqrt(3)/2 for each; curved 0.89, and 2 of the distance
//   position, once           sqrt(3)/2
//   quaternion, twice        r 32 2^-30           gjk_motion.h
//   matrix of half axes      r 3 2^-30
//   directions               r 27 2^-30           gjk_turning_join, twice, and into the frame of a hull
//   the same of |p_b - p_a|  r 48 2^-30           where the direction turns it is at most 4 times both r
//   normal                   r 4 2^-30
//   composed rotation, twice r 4 2^-30           where the body carries the shape at a pose of its own
//   composed position, twice sqrt(3) each        the same; 4 sqrt(3) where that is more than 8192 units away (gjk/pose.h)
//   all with r               < 2^-23 r
// and for the pair 1/2 of the distance, 1/8 of separations in Q8, and 2^-26 of the margin for the lengths of directions.
#include "gjk_impact.h"
#include "../arith/gjk_memory.h"
#include "../arith/gjk_root.h"
#include "../query/gjk_distance.h"
#include "../shape/gjk_shape_class.h"
#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk_impact_separation.h"

// A query: both bodies, and how near is a hit.
typedef struct impact_query {
  gjk_movers pair;
  int64_t wanted;   // the gap that is wanted, Q8: margin and slack
  int64_t radii;    // both convex radii, LSB
  int64_t touched;  // the gap of a hit: margin and tolerance, LSB
  gjk_q30 x;
  gjk_composer *compose;
} impact_query;

// Is position within int32 with reach around it?
static bool fits_around(gjk_q16 position, int64_t reach) {
  return position - reach >= INT32_MIN && position + reach <= INT32_MAX;
}

// Does the centre stay within int32 on the way, whatever the rotation? away: its distance from the pose's position.
static bool stays_in_range(const gjk_vec3 *from, const gjk_vec3 *to, int64_t away) {
  return fits_around(from->x, away) && fits_around(from->y, away) && fits_around(from->z, away) &&
         fits_around(to->x, away) && fits_around(to->y, away) && fits_around(to->z, away);
}

// Binds a body to its motion. The copy of its collider has a buffer of its own or none: the caller's stays as it is. *m
// must then stay where it is.
static gjk_status start_mover(gjk_mover *m, const gjk_carried *of) {
  const gjk_collider *c = of->collider;
  const gjk_motion *motion = of->motion;
  if (c->state != GJK_STATE_INITIALISED && c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  m->motion = motion;
  m->own = of->own;
  m->collider.shape = c->shape;
  m->collider.buffer = gjk_is_buffered(c->shape->type) && c->count <= GJK_MOVER_VERTICES ? m->baked : NULL;
  m->collider.local_centre = c->local_centre;
  m->collider.core_radius = c->core_radius;
  m->collider.radius = c->radius;
  m->collider.state = GJK_STATE_INITIALISED;
  m->collider.count = c->count;
  m->collider.bits = c->bits;
  const gjk_vec3 *away = &c->local_centre;
  // Each square at most 2^62, the root at most sqrt(3) 2^31; core_radius < 2^28:  reach < 2^32
  const uint32_t root = gjk_isqrt64((uint64_t)gjk_mul32(away->x, away->x) + (uint64_t)gjk_mul32(away->y, away->y) +
                                    (uint64_t)gjk_mul32(away->z, away->z));
  const uint32_t far = of->own != NULL ? of->arm : root > 0 ? root + 2 : 0;
  m->reach = far + (uint32_t)c->core_radius;
  const gjk_status status = gjk_turning_start(motion, &m->turning);
  return status == GJK_OK && !stays_in_range(&motion->from.position, &motion->to.position, far) ? GJK_ERROR_RANGE
                                                                                                : status;
}

// sqrt(3)/2, Q8, rounded up.
#define HALF_DIAGONAL 222

// What a composed position may be off, twice, Q8; near: up to 8192 units from the body's.
static int64_t composing_slack(const gjk_pose *own) {
  const gjk_vec3 *at = &own->position;
  const uint32_t near = UINT32_C(1) << 28;  // a length of at most sqrt(3) 4096 units
  const bool is_near =
      gjk_magnitude32(at->x) <= near && gjk_magnitude32(at->y) <= near && gjk_magnitude32(at->z) <= near;
  return is_near ? 4 * HALF_DIAGONAL : 16 * HALF_DIAGONAL;
}

// A body's part of the slack, Q8.
static int64_t impact_slack(const gjk_mover *m) {
  const gjk_shape *shape = m->collider.shape;
  const int64_t r = (int64_t)m->reach + shape->convex_radius;
  const int64_t posing = gjk_is_curved(shape)       ? 228 + 2 * 256
                         : gjk_has_half_axes(shape) ? HALF_DIAGONAL * m->collider.count
                                                    : HALF_DIAGONAL * 3 / 2;
  return 2 * posing + HALF_DIAGONAL + gjk_sar64(r, 15) + 1 + (m->own != NULL ? composing_slack(m->own) : 0);
}

static gjk_status start_impact(impact_query *of, const gjk_impact_setup *setup) {
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const int64_t slack =
      impact_slack(&of->pair.mover[0]) + impact_slack(&of->pair.mover[1]) + 128 + 32 + gjk_sar64(setup->margin, 18) + 1;
  if (setup->tolerance < GJK_IMPACT_TOLERANCE_MIN || setup->margin > GJK_IMPACT_MARGIN_MAX ||
      setup->tolerance * INT64_C(256) < slack + 256) {
    return GJK_ERROR_RANGE;
  }
  of->radii =
      (int64_t)of->pair.mover[0].collider.shape->convex_radius + of->pair.mover[1].collider.shape->convex_radius;
  of->wanted = (int64_t)setup->margin * 256 + slack;
  of->touched = (int64_t)setup->margin + setup->tolerance;
  of->x = 0;
  return GJK_OK;
}

// Poses a body's collider for a pose of the body. It fails for a body of parts that are not as they were built.
// Out of line, as next_x, so that their stack is not that of distances too.
GJK_OUT_OF_LINE static gjk_status pose_mover(gjk_mover *m, gjk_composer *compose, const gjk_pose *body) {
  gjk_pose own;
  gjk_set(&body->position, &m->place);
  const gjk_status status = m->own != NULL ? compose(body, m->own, &own) : GJK_OK;
  return status == GJK_OK ? gjk_collider_pose(&m->collider, m->own != NULL ? &own : body) : status;
}

// Has the body, once posed, the same pose at a fraction? At the end of the way it has that of the motion, to the bit.
static bool stands(const gjk_mover *m, gjk_q30 fraction) {
  const gjk_vec3 *from = &m->motion->from.position, *to = &m->motion->to.position;
  return m->collider.state == GJK_STATE_POSED && fraction != GJK_Q30_ONE && m->turning.half_turns == 0 &&
         from->x == to->x && from->y == to->y && from->z == to->z;
}

// How many different vertices of one shape are in a feature. Those of curved shapes count as one.
static unsigned vertices_in(const uint16_t *number, unsigned count) {
  unsigned different = count > 0 ? 1 : 0;
  for (unsigned i = 1; i < count; i++) {
    bool seen = false;
    for (unsigned j = 0; j < i; j++) {
      seen = seen || number[i] == number[j];
    }
    different += seen ? 0 : 1;
  }
  return different;
}

// Step 2: with the shape that has more vertices in the nearest feature, or as the normal of two edges. out: room for that.
static const gjk_turning *carrier_of(const impact_query *of, const gjk_distance_result *gap, gjk_turning *out) {
  const gjk_turning *of_a = &of->pair.mover[0].turning, *of_b = &of->pair.mover[1].turning;
  const gjk_certificate *nearest = &gap->certificate;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return NULL;
  }
  const unsigned a = vertices_in(nearest->a, nearest->count), b = vertices_in(nearest->b, nearest->count);
  if (a != b) {
    return a > b ? of_a : of_b;
  }
  return a == 2 && gjk_turning_of_edges(of->pair.mover, nearest, &gap->normal, out) ? out : NULL;
}

// The pose of a body at a fraction. measured: a distance follows, so its collider is posed as well.
static gjk_status pose_mover_at(impact_query *of, gjk_mover *m, bool measured, gjk_pose *body) {
  if (stands(m, of->x)) {
    return GJK_OK;
  }
  gjk_turning_pose(m->motion, &m->turning, of->x, body);
  return measured ? pose_mover(m, of->compose, body) : GJK_OK;
}

static gjk_status pose_both(impact_query *of, bool measured, gjk_impact_result *out) {
  const gjk_status status = pose_mover_at(of, &of->pair.mover[0], measured, &out->pose_a);
  return status == GJK_OK ? pose_mover_at(of, &of->pair.mover[1], measured, &out->pose_b) : status;
}

// The shapes touch at x, where they are posed.
static void write_impact_hit(const impact_query *of, gjk_q16 margin, const gjk_distance_result *gap,
                             gjk_impact_result *out) {
  out->hit = true;
  out->overlap = of->x == 0 && gap->distance <= margin;
  out->distance = gap->distance;
  if (!gap->intersecting) {
    out->point_a = gap->point_a;
    out->point_b = gap->point_b;
    out->normal = gap->normal;
  }
  out->lower = of->x;
  out->upper = of->x;
}

// Steps 2 and 3: the next x. exact: the gap is a distance, not only bounds of one.
GJK_OUT_OF_LINE static gjk_q30 next_x(const impact_query *of, const gjk_distance_result *gap, bool exact) {
  gjk_turning on;
  gjk_separation along;
  along.pair = &of->pair;
  along.n = gap->normal;
  along.start = of->x;
  along.carrier = carrier_of(of, gap, &on);
  along.fall = gjk_separation_fall(&along, &gap->point_a, &gap->point_b);
  // A distance is off by at most 2^-26 of itself. The normal of bounds is not that of the lower one: then s is measured.
  const int64_t lower = (int64_t)gap->lower * 256;
  const int64_t above = exact ? lower - gjk_sar64(lower, 26) - of->wanted : -1;
  return gjk_separation_holds(&along, above, of->wanted + of->radii * 256, (of->touched * 256 - of->wanted) / 4);
}

// Step 1: is the gap at most margin and tolerance? A distance equal to both may be rounded down from a larger gap.
static bool is_hit(const impact_query *of, const gjk_distance_result *gap) {
  gjk_decision near;
  if (gap->upper != of->touched) {
    return gap->upper < of->touched;
  }
  return gjk_within(&of->pair.mover[0].collider, &of->pair.mover[1].collider, gap->upper, NULL, &near) == GJK_OK &&
         near.yes;
}

// Step 1. Its certificate tells step 2 which of several features the search has ended at.
static gjk_status measure_gap_of(const impact_query *of, gjk_cache *cache, gjk_distance_result *out) {
  const gjk_collider *a = &of->pair.mover[0].collider, *b = &of->pair.mover[1].collider;
  return gjk_distance_with(a, b, GJK_DISTANCE_BY_SCANS, cache, out);
}

// Steps 1 to 3, at most `most` times.
static gjk_status advance_impact(impact_query *of, gjk_q16 margin, unsigned most, gjk_impact_result *out) {
  gjk_cache cache;
  gjk_zero(&cache, sizeof cache);
  gjk_movers_start(&of->pair);
  of->x = gjk_separation_of_spheres(&of->pair, of->wanted + of->radii * 256);
  out->hit = false;
  out->overlap = false;
  out->iterations = 0;
  for (unsigned i = 1; i <= most && of->x < GJK_Q30_ONE; i++) {
    gjk_distance_result gap;
    gjk_status status = pose_both(of, true, out);
    if (status != GJK_OK) {
      return status;
    }
    status = measure_gap_of(of, &cache, &gap);  // Step 1
    out->iterations = (uint8_t)i;
    if (is_hit(of, &gap)) {
      write_impact_hit(of, margin, &gap, out);
      return GJK_OK;
    }
    const gjk_q30 x = next_x(of, &gap, status == GJK_OK);
    const bool stuck = x == of->x;
    of->x = x;
    if (stuck) {
      break;
    }
  }
  (void)pose_both(of, false, out);
  out->lower = of->x;
  out->upper = GJK_Q30_ONE;
  return of->x == GJK_Q30_ONE ? GJK_OK : GJK_ERROR_ITERATION_LIMIT;
}

gjk_status gjk_impact_of_carried(const gjk_carried of[2], const gjk_impact_setup *setup, gjk_composer *compose,
                                 gjk_impact_result *out) {
  impact_query query;
  query.compose = compose;
  gjk_status status = start_mover(&query.pair.mover[0], &of[0]);
  status = status == GJK_OK ? start_mover(&query.pair.mover[1], &of[1]) : status;
  status = status == GJK_OK ? start_impact(&query, setup) : status;
  if (status != GJK_OK) {
    return status;
  }
  return advance_impact(&query, setup->margin, setup->iterations > 0 ? setup->iterations : GJK_ITERATIONS_MAX, out);
}

gjk_status gjk_time_of_impact(const gjk_collider *a, const gjk_motion *motion_a, const gjk_collider *b,
                              const gjk_motion *motion_b, const gjk_impact_setup *setup, gjk_impact_result *out) {
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_carried of[2] = {{a, motion_a, NULL, 0}, {b, motion_b, NULL, 0}};
  return gjk_impact_of_carried(of, setup, NULL, out);
}
