// Forges answers, for tests of the library's check: true answers with a field changed, answers of another pair, and
// answers whose certificate is swapped or made up while all values agree with it.
#ifndef GENERATE_FORGE_H
#define GENERATE_FORGE_H

#include "generate.h"

typedef enum forge_kind { FORGE_DECISION, FORGE_DISTANCE, FORGE_PENETRATION } forge_kind;

#define FORGE_KINDS 3

// An answer: that of decision, distance and penetration which kind says. asked: of a decision, the distance it is
// about.
typedef struct forge_claim {
  forge_kind kind;
  gjk_q16 asked;
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result penetration;
} forge_claim;

// Makes a pair of polytopes with 1 to most pairs of vertices, near the origin, apart or overlapping. Many are flat or
// almost touch.
void forge_pair(random_state *random, unsigned most, case_pair *pair);

// The library's own answer. False: it has none.
bool forge_true(const gjk_collider *a, const gjk_collider *b, forge_kind kind, gjk_q16 asked, forge_claim *out);

// Sets every value as it would be if the certificate held, so that the lie is consistent.
void forge_fit(const gjk_collider *a, const gjk_collider *b, forge_claim *claim);

// Changes one field of claim; field, how and value are any numbers.
void forge_edit(uint32_t field, uint32_t how, int32_t value, forge_claim *claim);

// Makes a forged answer about a and b. It may borrow from other, an answer about another pair, and from b at another
// place.
void forge(random_state *random, const gjk_collider *a, const gjk_collider *b, const forge_claim *other,
           forge_claim *out);

// The status of the library's check of claim.
gjk_status forge_check(const gjk_collider *a, const gjk_collider *b, const forge_claim *claim);

void forge_print(FILE *file, const forge_claim *claim);

#endif
