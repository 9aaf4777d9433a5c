// What an edge and its check have in common.
#ifndef GJK_SRC_ARM_EDGE_H
#define GJK_SRC_ARM_EDGE_H

#include "gjk_arm_frames.h"

// Checks the arguments that both share, except for the range of the machine.
gjk_status gjk_arm_check_edge_arguments(const gjk_arm *arm, const int32_t *from, const int32_t *to,
                                        const gjk_arm_setup *setup);

// Does a pair, not of a body, come within margin plus tolerance, posed at the frames with number which?
bool gjk_arm_touches(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which);

// Reports a proof of the present span: of a pair, of a piece of a body, or the last one of a body.
void gjk_arm_prove(gjk_arm *arm, uint32_t number, uint32_t piece, int64_t gap, const gjk_unit3 *direction);

// Is each component as small as those of a unit vector?
bool gjk_arm_is_direction(const gjk_unit3 *n);

#endif
