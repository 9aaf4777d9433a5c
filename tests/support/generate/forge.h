// Forged answers: true ones of this or another pair with fields changed, certificates swapped or made up, and all the
// values that would go with them.
#ifndef GENERATE_FORGE_H
#define GENERATE_FORGE_H

#include "generate.h"

typedef enum forge_kind { FORGE_DECISION, FORGE_DISTANCE, FORGE_PENETRATION } forge_kind;

#define FORGE_KINDS 3

// An answer of a kind; of a decision asked is the distance that it is about.
typedef struct forge_claim {
  forge_kind kind;
  gjk_q16 asked;
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result penetration;
} forge_claim;

// A pair of polytopes with at most so many pairs of vertices, from 1 on, not far from the origin, apart or together; many of them flat,
// or next to touching.
void forge_pair(random_state *random, unsigned most, case_pair *pair);

// The library's answer. False: it has none.
bool forge_true(const gjk_collider *a, const gjk_collider *b, forge_kind kind, gjk_q16 asked, forge_claim *out);

// Sets every value as if the certificate held: a lie that is consistent.
void forge_fit(const gjk_collider *a, const gjk_collider *b, forge_claim *claim);

// Changes one field, by little or much.
void forge_edit(uint32_t field, uint32_t how, int32_t value, forge_claim *claim);

// A forged answer about the pair, b somewhere else lending its own and other giving that of another pair.
void forge(random_state *random, const gjk_collider *a, const gjk_collider *b, const forge_claim *other,
           forge_claim *out);

// What the library's check says.
gjk_status forge_check(const gjk_collider *a, const gjk_collider *b, const forge_claim *claim);

void forge_print(FILE *file, const forge_claim *claim);

#endif
