// What an answer claims, field by field, against brute force: whatever its certificate says.
//
// "False" is certain; where a claim is a matter of rounding, such as a depth along a rounded normal, it gets the benefit.
#ifndef EXACT_CLAIM_H
#define EXACT_CLAIM_H

#include "exact.h"

typedef struct exact_claims {
  const gjk_collider *a, *b;
  exact_truth truth;
  char *why;
  size_t size;
} exact_claims;

// Pre: as exact_brute; no coordinate near the end of Q16.16. why: room for the reason of a refusal.
void exact_claims_open(const gjk_collider *a, const gjk_collider *b, char *why, size_t size, exact_claims *out);

bool exact_claims_decision(const exact_claims *c, gjk_q16 distance, const gjk_decision *decision);

// As after GJK_OK: an answer of gjk_distance.
bool exact_claims_distance(const exact_claims *c, const gjk_distance_result *result);

// That no direction is shorter is not judged: exact_depth's part.
bool exact_claims_penetration(const exact_claims *c, const gjk_penetration_result *result);

#endif
