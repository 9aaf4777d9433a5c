// Checks answers: in exact integers where the shapes allow it, else against the accurate oracle.
#ifndef CASE_CERTIFY_H
#define CASE_CERTIFY_H

#include "answer.h"

typedef enum certify_verdict {
  CERTIFY_PROVEN,       // by an exact check
  CERTIFY_UNCERTIFIED,  // curved or very far apart: no exact check exists, but a comparison agrees
  CERTIFY_WRONG
} certify_verdict;

// Checks an answer whose status is not of a refused shape. *why explains any verdict but CERTIFY_PROVEN.
certify_verdict certify_answer(const case_question *question, const case_pair *pair, case_collider *a,
                               case_collider *b, const case_answer *answer, const char **why);

#endif
