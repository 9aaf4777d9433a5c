// Checks an answer of the plane in exact integer arithmetic, without looking at how it was found.
//
// OK means that every field the query sets is as accurate as its header states (gjk2/intersect.h, gjk2/distance.h,
// gjk2/penetration.h), with these exceptions:
//
// iterations   is not checked.
// certificate  Only the fields that its proof uses are checked, and none if the bounding circles are apart.
// saturated    A point with a coordinate at an end of Q16.16 is not checked if the nearest features reach that end.
//
// A right answer that no query gives, such as one with another nearest feature, may be UNPROVEN.
#ifndef GJK2_CHECK_H
#define GJK2_CHECK_H

#include "gjk2/distance.h"
#include "gjk2/intersect.h"
#include "gjk2/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

// Is decision the answer to gjk2_within(a, b, distance), or with distance 0 to gjk2_intersect(a, b)?
//
// a, b       the colliders, read only, posed as they were for the query.
// distance   Q16.16, at least 0.
// decision   read only.
// Cost       visits every vertex of both shapes once.
//
// OK                             proven.
// UNPROVEN                       not proven.
// UNSUPPORTED                    a curved shape, for which there is no exact proof, or centres more than 16384 units
//                                apart. If the bounding circles are apart, the status is OK or UNPROVEN instead.
// NULL, UNINITIALISED, NEGATIVE  nothing was checked.
gjk_status gjk2_check_decision(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance,
                               const gjk2_decision *decision);

// Is result the answer to gjk2_distance(a, b) after GJK_OK, or an exact one of gjk2_distance_until?
//
// Statuses  as in gjk2_check_decision, without NEGATIVE. UNSUPPORTED also if the bounding circles are apart.
// Cost      visits every vertex of both shapes once; a few thousand instructions for points and normal.
gjk_status gjk2_check_distance(const gjk2_collider *a, const gjk2_collider *b, const gjk2_distance_result *result);

// Is result the answer to gjk2_penetration(a, b) after GJK_OK? An answer with CAPACITY has no certificate.
//
// Overlap   of cores is proven by a decision of the check's own, whose certificate is checked like any other.
// Move      B moved by depth along normal must be apart from A. The certificate's line proves it.
// Least     No other direction may be shorter. Measuring every edge of A - B again proves it.
// Statuses  as in gjk2_check_decision, without NEGATIVE.
// Cost      that of gjk2_check_decision and of gjk2_penetration.
gjk_status gjk2_check_penetration(const gjk2_collider *a, const gjk2_collider *b,
                                  const gjk2_penetration_result *result);

#ifdef __cplusplus
}
#endif

#endif
