// Checks an answer of the plane in exact integer arithmetic, without looking at how it was found.
//
// OK means that every field that the query sets is as accurate as its header states (gjk2/intersect.h,
// gjk2/distance.h, gjk2/penetration.h), except:
//
// iterations   not checked.
// certificate  not looked at where the bounding circles are apart, which settles the answer. Elsewhere the fields that
//              its proof uses are.
// saturated    a point with a coordinate at an end of Q16.16 is not checked where the nearest features reach that end.
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
//                                apart. Where the bounding circles are apart, OK or UNPROVEN is given instead.
// NULL, UNINITIALISED, NEGATIVE  nothing was checked.
gjk_status gjk2_check_decision(const gjk2_collider *a, const gjk2_collider *b, gjk_q16 distance,
                               const gjk2_decision *decision);

// Is result the answer to gjk2_distance(a, b) after GJK_OK, or an exact one of gjk2_distance_until?
//
// Statuses  as of gjk2_check_decision, without NEGATIVE; UNSUPPORTED also where the bounding circles are apart.
// Cost      visits every vertex of both shapes once; a few thousand instructions for points and normal.
gjk_status gjk2_check_distance(const gjk2_collider *a, const gjk2_collider *b, const gjk2_distance_result *result);

// Is result the answer to gjk2_penetration(a, b) after GJK_OK? An answer with CAPACITY has no certificate.
//
// Overlap   of cores that overlap, proven by a decision of the check's own, whose certificate is checked like any other.
// Move      that B moved by depth along normal is apart from A is proven by the certificate's line.
// Least     that no other direction is shorter is proven by measuring every edge of A - B again.
// Statuses  as of gjk2_check_decision, without NEGATIVE.
// Cost      of gjk2_check_decision and of gjk2_penetration.
gjk_status gjk2_check_penetration(const gjk2_collider *a, const gjk2_collider *b,
                                  const gjk2_penetration_result *result);

#ifdef __cplusplus
}
#endif

#endif
