// When do two shapes that move and turn first touch?
#ifndef GJK_IMPACT_H
#define GJK_IMPACT_H

#include "gjk/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How a shape moves from one pose to another, as the fraction of the way runs from 0 to 1.
//
// The position moves in a straight line. The rotation turns at a steady rate. Where spin is not 0, it turns by spin
// about a fixed axis of the world, else along the shortest arc from from.rotation to to.rotation.
typedef struct gjk_motion {
  gjk_pose from;  // where it begins
  gjk_pose to;    // of its rotation nothing is read where spin is not 0
  gjk_vec3 spin;  // angle times axis over the whole way, Q16.16 radians, any size: several turns too
} gjk_motion;

// The pose at a fraction of the way.
//
// fraction  Q2.30, from 0 to GJK_Q30_ONE (RANGE).
// out       exactly from at 0, and without spin exactly to at GJK_Q30_ONE.
// Errors    against the motion in real numbers: each coordinate of the position 1/2 LSB. A rotation is off by less than
//           2^-26 radians, however many turns it has done: a point 1024 units from the position by less than 1 LSB.
// Statuses  NULL, RANGE, ROTATION (see gjk/pose.h).
gjk_status gjk_motion_pose(const gjk_motion *motion, gjk_q30 fraction, gjk_pose *out);

// How exactly an impact is wanted. Lengths Q16.16.
typedef struct gjk_impact_setup {
  gjk_q16 margin;      // the gap at which the shapes count as touching: 0 to GJK_IMPACT_MARGIN_MAX
  gjk_q16 tolerance;   // on top of it, at least GJK_IMPACT_TOLERANCE_MIN
  uint8_t iterations;  // the most distances measured; 0: GJK_ITERATIONS_MAX
} gjk_impact_setup;

// Lengths Q16.16, points in the world frame, fractions Q2.30.
typedef struct gjk_impact_result {
  bool hit;            // at upper the gap is at most margin + tolerance
  bool overlap;        // a hit at the start, whose distance there is at most margin
  gjk_q30 lower;       // at no fraction before this one do the shapes come as near as margin: proven
  gjk_q30 upper;       // of a hit: where the gap is at most margin + tolerance, now equal to lower; else GJK_Q30_ONE
  gjk_q16 distance;    // of a hit: the gap at upper
  gjk_vec3 point_a;    // of a hit without intersection: the nearest points there, and the normal from A to B
  gjk_vec3 point_b;    // the nearest point of B
  gjk_unit3 normal;    // from A to B
  gjk_pose pose_a;     // both poses at lower: there the shapes are apart, unless overlap is set
  gjk_pose pose_b;     // of B
  uint8_t iterations;  // distances measured
} gjk_impact_result;

// The least tolerance, 16 LSB, and the largest margin, 8192 units. The tolerance pays for the rounding of poses. It is
// enough for shapes whose farthest points are together at most 256 units from the positions of their poses. Beyond that
// 2^-23 of the excess comes on top; and 2^-26 of the margin.
#define GJK_IMPACT_TOLERANCE_MIN ((gjk_q16)16)
#define GJK_IMPACT_MARGIN_MAX ((gjk_q16)536870912)

// The first fraction at which two moving shapes are as near as the margin, between proven bounds.
//
// a, b    colliders that gjk_collider_init has bound to their shapes; posed or not, and with a buffer or without, makes
//         no difference. Read only; may be the same object.
// out     the caller's; distance, points and normal are set by a hit alone.
// Proven  at every fraction before lower, colliders posed by gjk_motion_pose and gjk_collider_pose are farther apart than
//         the margin; so are the shapes on their motions in real numbers, between those fractions too. A miss is the same
//         with lower at the end of the way, which is included then.
// Curved  cylinder, cone, ellipsoid, custom: as exactly as gjk_distance measures them.
// Cost    a distance, two poses and up to some ten support scans of both shapes an iteration.
// After   Mirtich 1996, conservative advancement; here on exact distances, with bounds to second order along a direction
//         that stands still or turns with one of the shapes.
//
// What is valid in out after each status; all else is as it was:
//
// OK               everything, as above.
// ITERATION_LIMIT  hit and overlap are false, upper is GJK_Q30_ONE; lower is proven as always, pose_a and pose_b are those
//                  at lower; iterations. Without setup->iterations: shapes that pass each other hardly farther away than
//                  margin + tolerance, for long or often, or so fast that they move by the tolerance in 2^-30 of the way.
// NULL, UNINITIALISED, ROTATION, NEGATIVE (margin), RANGE (margin, tolerance; a centre that may leave int32 on its way):
//                  nothing.
gjk_status gjk_time_of_impact(const gjk_collider *a, const gjk_motion *motion_a, const gjk_collider *b,
                              const gjk_motion *motion_b, const gjk_impact_setup *setup, gjk_impact_result *out);

#ifdef __cplusplus
}
#endif

#endif
