// What an answer says beyond its certificate, its points and its normal: are they as accurate as the contract has it?
#ifndef GJK_SRC_CLAIM_H
#define GJK_SRC_CLAIM_H

#include "../gjk/gjk_iteration.h"

// The direction from the simplex's feature to the origin: exact, or where it is longer, scaled down to 2^61 at most per
// component and off by less than 1. Pre: the feature is one by gjk_simplex_set.
void gjk_claim_direction(const gjk_simplex *s, gjk_long3 *out);

// Is the normal within 2^-28 of the direction, each of its components 0 or of that one's sign? Pre: |direction| < 2^62 per
// component.
bool gjk_claim_normal(const gjk_long3 *direction, const gjk_unit3 *normal);

// Is the point within 1 LSB of the named vertices' hull, rounded as the shape is? Pre: they exist, 1 <= count <= 3.
bool gjk_claim_point(const gjk_collider *c, const uint16_t *named, unsigned count, const gjk_vec3 *point);

// May a coordinate of the point have been cut off at the end of Q16.16: is it there, and so is the named vertices' hull?
bool gjk_claim_saturated(const gjk_collider *c, const uint16_t *named, unsigned count, const gjk_vec3 *point);

// Is the distance of the points within 2 LSB of the feature's less radius? That is distance, correctly rounded.
// Pre: distance, radius not negative and within the frame's reach.
bool gjk_claim_gap(const gjk_iteration *it, gjk_q16 distance, int64_t radius, const gjk_vec3 *a, const gjk_vec3 *b);

// Is a - b depth along the normal, to within 3 LSB and 2^-28 of depth? Pre: 0 <= depth; the normal is a claim that holds.
bool gjk_claim_overlap(gjk_q16 depth, const gjk_unit3 *normal, const gjk_vec3 *a, const gjk_vec3 *b);

#endif
