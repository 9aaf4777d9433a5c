// Judges what an answer claims, field by field, by brute force. The certificate of the answer is not read.
//
// Each function returns false only for a claim that is certainly wrong. A claim that rounding alone may make wrong,
// such as the depth along a rounded normal, passes.
#ifndef EXACT_CLAIM_H
#define EXACT_CLAIM_H

#include "exact.h"

typedef struct exact_claims {
  const gjk_collider *a, *b;
  exact_truth truth;
  char *why;  // gets the reason of a refusal
  size_t size;
} exact_claims;

// Finds the truth of a pair by exact_brute. why: room for the reason of a refusal, size bytes.
// Pre: that of exact_brute; no coordinate is near the ends of Q16.16.
void exact_claims_open(const gjk_collider *a, const gjk_collider *b, char *why, size_t size, exact_claims *out);

// Judges a decision of gjk_within(a, b, distance).
bool exact_claims_decision(const exact_claims *c, gjk_q16 distance, const gjk_decision *decision);

// Judges an answer of gjk_distance after GJK_OK.
bool exact_claims_distance(const exact_claims *c, const gjk_distance_result *result);

// Judges an answer of gjk_penetration after GJK_OK, but not whether a shorter way out exists: exact_depth tells that.
bool exact_claims_penetration(const exact_claims *c, const gjk_penetration_result *result);

#endif
