// Checks answers: in exact integers where the shapes allow it, else against the accurate oracle.
#ifndef CASE_CERTIFY_H
#define CASE_CERTIFY_H

#include "answer.h"

typedef enum certify_verdict {
  CERTIFY_PROVEN,       // by the library's check of the certificate and by the exact oracle's
  CERTIFY_UNCERTIFIED,  // a curved surface: no exact check exists, but the accurate oracle agrees
  CERTIFY_WRONG
} certify_verdict;

enum { CERTIFY_WHY_MAX = 160 };

// Checks an answer whose status is not of a refused shape; a and b were built from pair. why: the reason for
// any verdict but CERTIFY_PROVEN. An answer of the reference is compared with the library's, once that is
// proven.
certify_verdict certify_answer(const case_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                               const case_answer *answer, char why[CERTIFY_WHY_MAX]);

#endif
