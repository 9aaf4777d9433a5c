// Checks answers: in exact integers where both shapes are polytopes, else against the accurate oracle.
#ifndef CASE_CERTIFY_H
#define CASE_CERTIFY_H

#include "answer.h"

typedef enum certify_verdict {
  CERTIFY_PROVEN,       // the library's check and the exact oracle both verified the certificate
  CERTIFY_UNCERTIFIED,  // a shape is curved, so there is no exact check; the accurate oracle agrees
  CERTIFY_WRONG
} certify_verdict;

enum { CERTIFY_WHY_MAX = 160 };

// Checks an answer. An answer of the reference is compared with the library's, which is proven first.
// Pre: answer->refused is 0; a and b were built from pair. why: gets the reason for any verdict but CERTIFY_PROVEN.
certify_verdict certify_answer(const case_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                               const case_answer *answer, char why[CERTIFY_WHY_MAX]);

#endif
