// What an edge and its check have in common.
#ifndef GJK_SRC_ARM_EDGE_H
#define GJK_SRC_ARM_EDGE_H

#include "gjk_arm_frames.h"

// The statuses of the arguments that both have, but for the range of the machine.
gjk_status gjk_arm_check_edge_arguments(const gjk_arm *arm, const int32_t *from, const int32_t *to,
                                        const gjk_arm_setup *setup);

// Does a pair come within margin and tolerance, posed at the frames with number which?
bool gjk_arm_touches(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which);

#endif
