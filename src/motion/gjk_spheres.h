// Do bounding spheres meet on a way? Cheap, and never wrong where it says no.
#ifndef GJK_SRC_SPHERES_H
#define GJK_SRC_SPHERES_H

#include "gjk_way.h"

// Are the colliders' bounding spheres surely more than radius apart on the whole way? If not, the line of the way
// passes the difference of the centres within R + 2^-20 R + 2^9 LSB, where R is the sum of the spheres' radii and
// radius.
//   radius   added to core radii, LSB; from 0 to below 2^32
bool gjk_spheres_part(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, int64_t radius);

#endif
