// An edge's truth in double: poses by real arithmetic, and sure verdicts from distances and a bound of the speed.
#ifndef ARM_TRUTH_H
#define ARM_TRUTH_H

#include "gjk/arm.h"

// How far distances of shapes posed by arm_truth_gap may be from those of the motion in real numbers, LSB: positions and
// vertices of both are rounded, 3 each, and curved ones are off by 2 each.
#define ARM_TRUTH_ERROR 10.0

typedef enum arm_truth {
  ARM_TRUTH_OPEN,   // too close to tell
  ARM_TRUTH_FREE,   // surely above least all the way
  ARM_TRUTH_TOUCH,  // surely below least somewhere
} arm_truth;

// The least gap of all tested pairs at a fraction of the edge, LSB, 0 where they overlap; those farther than most count as
// most. values: from + (to - from) fraction, not rounded.
double arm_truth_gap(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction, double most);

// The gap of one pair.
double arm_truth_pair(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction,
                      const gjk_arm_names *names);

// Does any pair come within least between two fractions? samples: how many gaps were measured.
arm_truth arm_truth_edge(const gjk_arm *arm, const int32_t *from, const int32_t *to, double start, double end,
                         double least, unsigned *samples);

// A pose in double.
typedef struct arm_truth_frame {
  double q[4];  // x, y, z, w
  double p[3];  // LSB
} arm_truth_frame;

// The frames of all links, by real arithmetic; and a vector turned by one.
void arm_truth_frames(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction,
                      arm_truth_frame out[GJK_ARM_LINKS_MAX]);
void arm_truth_turn(const double q[4], const double v[3], double out[3]);

// The pose of a link, by real arithmetic, rounded.
void arm_truth_pose(const gjk_arm *arm, const int32_t *from, const int32_t *to, double fraction, unsigned link,
                    gjk_pose *out);

#endif
