// The disc base that cylinder and cone share. Their size is {radius, radius, half height}.
#ifndef GJK_SRC_DISC_BASE_H
#define GJK_SRC_DISC_BASE_H

#include "gjk_curved.h"

// measure of both classes: the farthest points from the centre lie on the rim.
gjk_status gjk_disc_base_measure(const gjk_shape *shape, gjk_extent *out);

// Sets x and y of the rim's point that is farthest along d, in fine units; of the disc's centre when d is along z.
void gjk_rim(gjk_q16 radius, const gjk_vec3 *d, gjk_fine_point *point);

#endif
