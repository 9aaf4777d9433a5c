// Checks answers in the plane: in exact integers where both shapes are polygons, else against the reference in double.
#ifndef CASE_CERTIFY2_H
#define CASE_CERTIFY2_H

#include "answer2.h"
#include "certify.h"

// As certify_answer. An answer of the reference is compared with that of the exact oracle.
// Pre: answer->refused is 0; a and b were built from pair.
certify_verdict certify2_answer(const case_question *question, const case2_pair *pair, case2_collider *a,
                                case2_collider *b, const case2_answer *answer, char why[CERTIFY_WHY_MAX]);

#endif
