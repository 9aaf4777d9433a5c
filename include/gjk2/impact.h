// When do two shapes of the plane that move and turn first touch?
#ifndef GJK2_IMPACT_H
#define GJK2_IMPACT_H

#include "gjk2/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// How a shape moves from one pose to another, as the fraction of the way runs from 0 to 1.
//
// The position moves in a straight line. The rotation turns at a steady rate: by spin
// where spin is not 0, and else along the shortest arc from from.rotation to to.rotation.
typedef struct gjk2_motion {
  gjk2_pose from;  // where it begins
  gjk2_pose to;    // of its rotation nothing is read where spin is not 0
  gjk_angle spin;  // angle over the whole way, Q16.16 radians, any size: several turns too
} gjk2_motion;

// The pose at a fraction of the way, Q2.30 from 0 to GJK_Q30_ONE (RANGE). ROTATION: see gjk2/pose.h.
gjk_status gjk2_motion_pose(const gjk2_motion *motion, gjk_q30 fraction, gjk2_pose *out);

// How exactly an impact is wanted.
typedef struct gjk2_impact_setup {
  gjk_q16 margin;      // the gap at which the shapes count as touching
  gjk_q16 tolerance;   // on top of it, at least GJK2_IMPACT_TOLERANCE_MIN (RANGE)
  uint8_t iterations;  // the most distances measured; 0: GJK_ITERATIONS_MAX
} gjk2_impact_setup;

// Lengths Q16.16, points in the world frame, fractions Q2.30.
typedef struct gjk2_impact_result {
  bool hit;            // at upper the gap is at most margin + tolerance
  bool overlap;        // the gap is at most the margin at the start; lower and upper are 0
  gjk_q30 lower;       // before this fraction the gap is above the margin: proven, the rounding of posing included
  gjk_q30 upper;       // of a hit: at this fraction the gap is at most margin + tolerance; of a miss 2^30, as lower
  gjk_q16 distance;    // between the shapes as posed at upper; not set after a miss, like the next three
  gjk2_vec point_a;    // nearest points there, and the normal from A to B; not set where the shapes overlap
  gjk2_vec point_b;    // the nearest point of B
  gjk2_unit normal;    // from A to B
  gjk2_pose pose_a;    // both poses at lower: there the shapes are apart
  gjk2_pose pose_b;    // of B
  uint8_t iterations;  // distances measured
} gjk2_impact_result;

// The least tolerance, 8 LSB: it pays for the rounding of poses.
#define GJK2_IMPACT_TOLERANCE_MIN ((gjk_q16)8)

// The first fraction at which two moving shapes are as near as the margin, between proven bounds.
//
// a, b    colliders that gjk2_collider_init has bound to their shapes; posed or not, and with a buffer or without, makes
//         no difference. Read only.
// Exact   lower is proven against the real motion of the real shapes, what posing, sine and distance round included: below
//         8 LSB in all, for shapes within 4096 units of their origins. As posed before lower they may so come 8 LSB nearer
//         than the margin. upper is measured.
//         Shapes farther from their origins, and ways or turns of which 2^-30 moves a point by more than the tolerance,
//         may need a larger tolerance: otherwise ITERATION_LIMIT.
// Cost    a distance of lazy shapes for each of 2 to 6 steps, mostly.
// Method  conservative advancement (Mirtich 1996) on exact distances, with bounds of how far a point may move.
// Statuses  ITERATION_LIMIT: the ceiling is reached. lower is proven as always, pose_a and pose_b are those at lower;
//           hit is false, and upper 2^30. Also of curved shapes whose distance reaches GJK_ITERATIONS_MAX.
//           NULL, UNINITIALISED, NEGATIVE (margin), RANGE (tolerance; a centre leaves int32), ROTATION: nothing is written.
gjk_status gjk2_time_of_impact(const gjk2_collider *a, const gjk2_motion *motion_a, const gjk2_collider *b,
                               const gjk2_motion *motion_b, const gjk2_impact_setup *setup, gjk2_impact_result *out);

#ifdef __cplusplus
}
#endif

#endif
