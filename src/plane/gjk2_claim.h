// Checks of what an answer of the plane claims beyond its certificate: are its points and its normal as accurate as the
// contract says?
#ifndef GJK2_SRC_CLAIM_H
#define GJK2_SRC_CLAIM_H

#include "gjk2_search.h"

// The largest offset . d of the collider's vertices, visited one by one. Pre: components of d are at most 3 2^29 in size.
int64_t gjk2_claim_farthest(const gjk2_collider *c, gjk2_vec d);

// Is the normal within 2^-28 of n / |n|, and each of its components 0 or of the direction's sign? Pre: n != 0,
// components at most 3 2^29 in size.
bool gjk2_claim_normal(gjk2_vec n, const gjk2_unit *normal);

// Is the point within 1 LSB of the named vertices' hull, widened by the shape's convex radius? Pre: count is 1 or 2, and
// the vertices exist.
bool gjk2_claim_point(const gjk2_collider *c, const uint16_t *named, unsigned count, const gjk2_vec *point);

// May a coordinate of the point have been saturated? Then it is at an end of Q16.16, and a named vertex, with the
// convex radius, reaches that end.
bool gjk2_claim_saturated(const gjk2_collider *c, const uint16_t *named, unsigned count, const gjk2_vec *point);

// Is the distance of the points a and b within 2 LSB of that of the feature less the convex radii? Pre: the feature's d
// and base are set, and that rounds to distance, which is not negative.
bool gjk2_claim_gap(const gjk2_search *s, gjk_q16 distance, const gjk2_vec *a, const gjk2_vec *b);

// Is a - b equal to depth normal, to within 3 LSB and 2^-28 of depth? Pre: 0 <= depth; the normal is proven.
bool gjk2_claim_overlap(gjk_q16 depth, const gjk2_unit *normal, const gjk2_vec *a, const gjk2_vec *b);

#endif
