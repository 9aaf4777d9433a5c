// When do two shapes of the plane that move and turn first touch?
#ifndef GJK2_IMPACT_H
#define GJK2_IMPACT_H

#include "gjk2/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How a shape moves from one pose to another, while the fraction of the way runs from 0 to 1.
//
// The position moves in a straight line, and the rotation turns at a steady rate. If spin is not 0, it turns by spin.
// Otherwise it takes the shortest arc from from.rotation to to.rotation.
typedef struct gjk2_motion {
  gjk2_pose from;  // where the motion begins
  gjk2_pose to;    // where the motion ends; if spin is not 0, the rotation is not read
  gjk_angle spin;  // angle of the whole way, Q16.16 radians; any size, several turns included
} gjk2_motion;

// The pose at a fraction of the way, Q2.30 from 0 to GJK_Q30_ONE (RANGE). ROTATION: see gjk2/pose.h.
gjk_status gjk2_motion_pose(const gjk2_motion *motion, gjk_q30 fraction, gjk2_pose *out);

// How exactly to find an impact.
typedef struct gjk2_impact_setup {
  gjk_q16 margin;      // the gap at which the shapes count as touching
  gjk_q16 tolerance;   // allowed on top of the margin, at least GJK2_IMPACT_TOLERANCE_MIN (RANGE)
  uint8_t iterations;  // the most distances measured; 0: GJK_ITERATIONS_MAX
} gjk2_impact_setup;

// Lengths Q16.16, points in the world frame, fractions Q2.30.
typedef struct gjk2_impact_result {
  bool hit;            // the gap at upper is at most margin + tolerance
  bool overlap;        // the gap at the start is at most margin; lower and upper are 0
  gjk_q30 lower;       // proven, rounding of posing included: before this fraction the gap is above margin
  gjk_q30 upper;       // hit: where the gap is at most margin + tolerance; miss: GJK_Q30_ONE, like lower
  gjk_q16 distance;    // gap of the shapes as posed at upper; after a miss not set, nor are the next three
  gjk2_vec point_a;    // nearest point of A there; where the shapes overlap not set, nor are the next two
  gjk2_vec point_b;    // nearest point of B there
  gjk2_unit normal;    // from A to B, Q2.30
  gjk2_pose pose_a;    // pose of A at lower, where the shapes are apart unless overlap is set
  gjk2_pose pose_b;    // pose of B at lower
  uint8_t iterations;  // distances measured
} gjk2_impact_result;

// The least tolerance, 8 LSB. It covers the rounding of poses.
#define GJK2_IMPACT_TOLERANCE_MIN ((gjk_q16)8)

// The first fraction at which two moving shapes are as near as the margin, between proven bounds.
//
// a, b    colliders bound by gjk2_collider_init, posed or not, with or without a buffer. Read only.
// Exact   lower is proven for the real motion of the real shapes. That covers all rounding of posing, sine and
//         distance, below 8 LSB for shapes within 4096 units of their origins. So colliders posed before lower may come
//         up to 8 LSB nearer than the margin. upper is measured. Shapes farther from their origins may need a larger
//         tolerance. So may motions that move a point by more than the tolerance in 2^-30 of the way. Otherwise
//         ITERATION_LIMIT is possible.
// Cost    mostly 2 to 6 steps, each a distance of lazy shapes.
// After   Mirtich 1996, conservative advancement; here on exact distances, with bounds of how far a point may move.
// Statuses  ITERATION_LIMIT: a ceiling is reached, that of the setup or of a curved shape's distance
//           (GJK_ITERATIONS_MAX). lower is proven as always. hit is false, and upper is GJK_Q30_ONE. distance, points
//           and normal are not set. NULL, UNINITIALISED, NEGATIVE (margin), RANGE (tolerance; a centre leaves int32),
//           ROTATION: nothing is written.
gjk_status gjk2_time_of_impact(const gjk2_collider *a, const gjk2_motion *motion_a, const gjk2_collider *b,
                               const gjk2_motion *motion_b, const gjk2_impact_setup *setup, gjk2_impact_result *out);

#ifdef __cplusplus
}
#endif

#endif
