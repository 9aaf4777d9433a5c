// When do two shapes that move and turn first touch?
#ifndef GJK_IMPACT_H
#define GJK_IMPACT_H

#include "gjk/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How a shape moves from one pose to another, while the fraction of the way runs from 0 to 1.
//
// The position moves in a straight line, and the rotation turns at a steady rate. If spin is not 0, it turns by spin
// about a fixed axis of the world. Otherwise it takes the shortest arc from from.rotation to to.rotation.
typedef struct gjk_motion {
  gjk_pose from;  // where the motion begins
  gjk_pose to;    // where the motion ends; if spin is not 0, the rotation is not read
  gjk_vec3 spin;  // axis times angle of the whole way, Q16.16 radians; any size, several turns included
} gjk_motion;

// The pose at a fraction of the way.
//
// fraction  Q2.30, from 0 to GJK_Q30_ONE (RANGE).
// out       equals from at 0, and without spin equals to at GJK_Q30_ONE.
// Errors    against the motion in real numbers: position within 1/2 LSB per coordinate. The rotation is off by less
//           than 2^-26 radians after any number of turns, which is below 1 LSB at 1024 units from the position.
// Statuses  NULL, RANGE, ROTATION (see gjk/pose.h).
gjk_status gjk_motion_pose(const gjk_motion *motion, gjk_q30 fraction, gjk_pose *out);

// How exactly to find an impact. Lengths Q16.16.
typedef struct gjk_impact_setup {
  gjk_q16 margin;      // the gap at which the shapes count as touching: 0 to GJK_IMPACT_MARGIN_MAX
  gjk_q16 tolerance;   // allowed on top of the margin, at least GJK_IMPACT_TOLERANCE_MIN
  uint8_t iterations;  // the most distances measured; 0: GJK_ITERATIONS_MAX
} gjk_impact_setup;

// Lengths Q16.16, points in the world frame, fractions Q2.30.
typedef struct gjk_impact_result {
  bool hit;            // the gap at upper is at most margin + tolerance
  bool overlap;        // a hit at the start, where the gap is at most margin
  gjk_q30 lower;       // proven: at every fraction before this one the gap is above margin
  gjk_q30 upper;       // hit: where the gap is at most margin + tolerance, currently equal to lower; else GJK_Q30_ONE
  gjk_q16 distance;    // hit: the gap at upper
  gjk_vec3 point_a;    // hit without intersection: nearest point of A at upper, set with point_b and normal
  gjk_vec3 point_b;    // nearest point of B at upper
  gjk_unit3 normal;    // from A to B, Q2.30
  gjk_pose pose_a;     // pose of A at lower, where the shapes are apart unless overlap is set
  gjk_pose pose_b;     // pose of B at lower
  uint8_t iterations;  // distances measured
} gjk_impact_result;

// The least tolerance, 16 LSB, and the largest margin, 8192 units. The tolerance covers the rounding of poses.
//
// 16 LSB are enough while the farthest points of both shapes are together at most 256 units from the positions of their
// poses. Beyond that, add 2^-23 of the excess, and 2^-26 of the margin.
#define GJK_IMPACT_TOLERANCE_MIN ((gjk_q16)16)
#define GJK_IMPACT_MARGIN_MAX ((gjk_q16)536870912)

// The first fraction at which two moving shapes are as near as the margin, between proven bounds.
//
// a, b    colliders bound by gjk_collider_init, posed or not, with or without a buffer. Read only; may be the same one.
// out     the caller's; distance, points and normal are set only by a hit.
// Proven  at every fraction before lower, the gap of colliders posed by gjk_motion_pose and gjk_collider_pose is above
//         the margin. So is that of the shapes on their motions in real numbers, between such fractions too. After a
//         miss this holds for the whole way, its end included.
// Curved  cylinder, cone, ellipsoid, custom: as exact as gjk_distance.
// Cost    each iteration takes a distance, two poses and up to about ten support scans of both shapes.
// After   Mirtich 1996, conservative advancement; here on exact distances, with second-order bounds along a direction
//         that is fixed or turns with one of the shapes.
//
// What is valid in out after each status; all else is as it was:
//
// OK               everything, as above.
// ITERATION_LIMIT  everything but distance, points and normal. hit and overlap are false, upper is GJK_Q30_ONE. lower
//                  is proven as always. With setup->iterations 0 there are two causes. The gap may stay just above
//                  margin + tolerance for long or often. Or a shape may move by the tolerance within 2^-30 of the way.
// NULL, UNINITIALISED, ROTATION, NEGATIVE (margin), RANGE (margin, tolerance, a centre that may leave int32)  nothing.
gjk_status gjk_time_of_impact(const gjk_collider *a, const gjk_motion *motion_a, const gjk_collider *b,
                              const gjk_motion *motion_b, const gjk_impact_setup *setup, gjk_impact_result *out);

#ifdef __cplusplus
}
#endif

#endif
