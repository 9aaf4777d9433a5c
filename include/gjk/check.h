// Checks an answer's certificate in exact integer arithmetic, without looking at how it was found.
#ifndef GJK_CHECK_H
#define GJK_CHECK_H

#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk/penetration.h"

#ifdef __cplusplus
extern "C" {
#endif

// Does decision follow for gjk_within(a, b, distance) (0: gjk_intersect)? The colliders stand as they did.
//
// Statuses  OK: proven. UNPROVEN: not. UNSUPPORTED: a curved or user's shape, no exact proof exists. NULL,
//           UNINITIALISED, NEGATIVE.
// Cost      visits every vertex of both shapes once.
gjk_status gjk_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance,
                              const gjk_decision *decision);

// Is result the answer to gjk_distance(a, b)? Checks the decision and that the distance is correctly rounded.
// Centres more than 16384 units apart: UNSUPPORTED.
gjk_status gjk_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result);

// Does result follow from its certificate for gjk_penetration(a, b)? When they intersect: A and B moved apart by depth
// no longer do, and depth is exactly that plane's, rounded up. That no other direction is shorter takes more than a
// certificate to prove. An answer with CAPACITY has no certificate.
gjk_status gjk_check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result);

#ifdef __cplusplus
}
#endif

#endif
