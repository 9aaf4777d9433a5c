// Checks an answer in exact integer arithmetic, without looking at how it was found.
//
// OK means that every field the query sets is as accurate as its header states (gjk/intersect.h, gjk/distance.h,
// gjk/penetration.h), with these exceptions:
//
// iterations   is not checked.
// certificate  Only the fields that its proof uses are checked, and none if the bounding spheres are apart.
// lower        of overlapping cores equals depth. A certificate proves depth to be enough, not to be the least.
// saturated    A point with a coordinate at an end of Q16.16 is not checked if the nearest features reach that end.
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

// Is decision the answer to gjk_within(a, b, distance), or with distance 0 to gjk_intersect(a, b)?
//
// a, b       the colliders, read only, posed as they were for the query.
// distance   Q16.16, at least 0.
// decision   read only.
// Cost       visits every vertex of both shapes once.
//
// OK                             proven.
// UNPROVEN                       not proven.
// UNSUPPORTED                    a curved shape, for which there is no exact proof, or centres more than 16384 units
//                                apart. If the bounding spheres are apart, the status is OK or UNPROVEN instead.
// NULL, UNINITIALISED, NEGATIVE  nothing was checked.
gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision);

// Is result the answer to gjk_distance(a, b) after GJK_OK, or an exact one of gjk_distance_until?
//
// Statuses  as in gjk_check_decision, without NEGATIVE. UNSUPPORTED also if the bounding spheres are apart.
// Cost      visits every vertex of both shapes once; a few thousand instructions for points and normal.
gjk_status gjk_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result);

// Is result the answer to gjk_penetration(a, b) after GJK_OK? An answer with CAPACITY has no certificate.
//
// Overlap   is proven by a decision of the check's own, whose certificate is checked like any other.
// Move      B moved by depth along normal must be apart from A. With convex radii another such decision proves it,
//           without them the certificate's plane.
// Statuses  as in gjk_check_decision, without NEGATIVE.
// Cost      that of gjk_check_decision, and of one or two gjk_within.
gjk_status gjk_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result);

#ifdef __cplusplus
}
#endif

#endif
