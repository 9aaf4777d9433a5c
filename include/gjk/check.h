// Checks an answer in exact integer arithmetic, without looking at how it was found.
//
// OK means that every field that the query sets (gjk/intersect.h, gjk/distance.h, gjk/penetration.h) is as accurate as
// stated there, but for:
//
// iterations     not checked.
// certificate    not looked at where the bounding spheres are apart, which settles the answer; elsewhere the fields that
//                its proof uses.
// lower          of a penetration whose cores overlap: it equals depth, which is enough, exactly; that no other direction
//                is shorter takes more than a certificate to prove.
// cut off        where the nearest features reach the end of Q16.16, a point with a coordinate there is not checked.
//
// A right answer that no query gives, such as one with another nearest feature, may be UNPROVEN.
#ifndef GJK_CHECK_H
#define GJK_CHECK_H

#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

// Is decision the answer to gjk_within(a, b, distance) (0: gjk_intersect)? The colliders stand as they did.
//
// Statuses  OK: proven. UNPROVEN: not. UNSUPPORTED: a curved or user's shape, no exact proof exists; or centres more than
//           16384 units apart. Either may be OK where the bounding spheres are apart. NULL, UNINITIALISED, NEGATIVE.
// Cost      visits every vertex of both shapes once.
gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision);

// Is result the answer to gjk_distance(a, b), after GJK_OK? One of gjk_distance_until is while it is exact.
//
// Statuses  as above, without NEGATIVE.
// Cost      visits every vertex of both shapes once; a few thousand instructions for points and normal.
gjk_status gjk_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result);

// Is result the answer to gjk_penetration(a, b), after GJK_OK? One with CAPACITY has no certificate.
//
// Overlap   a decision of the check's own proves it, whose certificate is checked like any other. So is that of shapes with
//           roundings when B has moved by depth along normal; without, the certificate's plane tells that they are parted.
// Statuses  as above.
// Cost      of one decision more, or two.
gjk_status gjk_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result);

#ifdef __cplusplus
}
#endif

#endif
