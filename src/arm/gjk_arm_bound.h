// How far a motion of joints bends, and what its roundings add up to: see gjk_arm_bound.c.
#ifndef GJK_SRC_ARM_BOUND_H
#define GJK_SRC_ARM_BOUND_H

#include "gjk_arm_frames.h"

// Sets the edge of an arm: from and to. Bounds each pair's motion, and tells whether values are outside their limits.
// RANGE: the machine may leave its range; then only link rooms are set.
gjk_status gjk_arm_set_edge(gjk_arm *arm, const int32_t *from, const int32_t *to);

// The same for a single configuration, without the pairs: also checks the arguments of a static question, and sets the
// frames of number 0.
gjk_status gjk_arm_stand(gjk_arm *arm, const int32_t *values, const void *out);

// Lists the pairs anew, for these numbers of obstacles and bodies. False: there is no room for them, and nothing is
// changed.
bool gjk_arm_list(gjk_arm *arm, uint16_t obstacles, uint16_t bodies);

// By how much a pair bends on a span of 2^-depth of the edge, rounded up, LSB; -1: by more than 2^28.
int64_t gjk_arm_bend(const gjk_arm_pair *pair, unsigned depth);

#endif
