// Checks the tool's answers: in exact integers where the shapes allow it, else against the accurate oracle.
#ifndef QUERY_CERTIFY_H
#define QUERY_CERTIFY_H

#include "answer.h"

typedef struct certify_state {
  unsigned long certified, uncertified, wrong;  // answers so far
} certify_state;

// Checks an answer, counts it, and prints nothing when it is certified, else ' uncertified: WHY' or ' WRONG: WHY'.
// A pair that the library refuses has no answer to check.
void certify_answer(FILE *file, certify_state *state, const query_options *options, const case_pair *pair,
                    case_collider *a, case_collider *b, const query_answer *answer);

#endif
