// The round base that cylinder and cone share: size = {radius, radius, half height}.
#ifndef GJK_SRC_DISC_BASE_H
#define GJK_SRC_DISC_BASE_H

#include "gjk_curved.h"

gjk_status gjk_disc_base_measure(const gjk_shape *shape, gjk_extent *out);

// Sets x and y of the point of the circle that is farthest along d; the circle's centre when d is along z.
void gjk_rim(gjk_q16 radius, const gjk_vec3 *d, gjk_fine_point *point);

#endif
