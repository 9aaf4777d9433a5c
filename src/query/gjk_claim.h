// Checks of what an answer claims beyond its certificate: are its points and its normal as accurate as the contract
// says?
#ifndef GJK_SRC_CLAIM_H
#define GJK_SRC_CLAIM_H

#include "../gjk/gjk_iteration.h"

// The direction from the simplex's feature to the origin, exact; or where it is longer, scaled down to 2^61 at most per
// component and off by less than 1.
// Pre: the feature is one by gjk_simplex_set.
void gjk_claim_direction(const gjk_simplex *s, gjk_long3 *out);

// Is the normal within 2^-28 of the direction, and each of its components 0 or of the direction's sign? Pre: components
// of direction are below 2^62 in size.
bool gjk_claim_normal(const gjk_long3 *direction, const gjk_unit3 *normal);

// Is the point within 1 LSB of the named vertices' hull, widened by the shape's convex radius? Pre: 1 <= count <= 3.
bool gjk_claim_point(const gjk_collider *c, const uint16_t *named, unsigned count, const gjk_vec3 *point);

// May a coordinate of the point have been saturated? Then it is at an end of Q16.16, and a named vertex, with the
// convex radius, reaches that end.
bool gjk_claim_saturated(const gjk_collider *c, const uint16_t *named, unsigned count, const gjk_vec3 *point);

// Is the distance of the points a and b within 2 LSB of the feature's distance less radius? Pre: distance is that,
// rounded to the nearest LSB; distance and radius are not negative and within the frame's reach.
bool gjk_claim_gap(const gjk_iteration *it, gjk_q16 distance, int64_t radius, const gjk_vec3 *a, const gjk_vec3 *b);

// Is a - b equal to depth normal, to within 3 LSB and 2^-28 of depth? Pre: 0 <= depth; the normal is proven.
bool gjk_claim_overlap(gjk_q16 depth, const gjk_unit3 *normal, const gjk_vec3 *a, const gjk_vec3 *b);

#endif
