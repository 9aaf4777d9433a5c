// Answers questions about shapes that move: casts, rays and times of impact.
#ifndef QUERY_MOTION_H
#define QUERY_MOTION_H

#include "case/case.h"
#include "case/case2.h"
#include "case/certify.h"

typedef enum motion_ask { MOTION_NONE, MOTION_CAST, MOTION_RAY, MOTION_IMPACT } motion_ask;

typedef struct motion_question {
  motion_ask ask;
  gjk_q16 margin;     // the gap that counts as contact
  gjk_q16 tolerance;  // of an impact, on top of it; 0: the least
} motion_question;

// What was answered. refused as in case_answer; is_no_ray: B is no point, or A moves.
typedef struct motion_answer {
  gjk_status status;
  char refused;
  bool is_no_ray;
  gjk_cast_result cast;
  gjk_impact_result impact;
} motion_answer;

typedef struct motion2_answer {
  gjk_status status;
  char refused;
  bool is_no_ray;
  gjk2_cast_result cast;
  gjk2_impact_result impact;
} motion2_answer;

// Answers a case. Builds a and b from its shapes.
void motion_find(const motion_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                 motion_answer *answer);
void motion2_find(const motion_question *question, const case2_pair *pair, case2_collider *a, case2_collider *b,
                  motion2_answer *answer);

// Prints an answer: one line, without its line feed.
void motion_print(FILE *file, const motion_question *question, const case_pair *pair, const motion_answer *answer);
void motion2_print(FILE *file, const motion_question *question, const case2_pair *pair, const motion2_answer *answer);

// Checks an answer. Of polytopes without radius and margin a hit and its fraction are proven; a time of impact is
// compared with distances at many fractions.
// Pre: answer->refused is 0; a and b were built from pair. why: as in certify.h.
certify_verdict motion_certify(const motion_question *question, const case_pair *pair, case_collider *a,
                               case_collider *b, const motion_answer *answer, char why[CERTIFY_WHY_MAX]);
certify_verdict motion2_certify(const motion_question *question, const case2_pair *pair, case2_collider *a,
                                case2_collider *b, const motion2_answer *answer, char why[CERTIFY_WHY_MAX]);

#endif
