// One case, one question, one answer: by the library or by the double-precision reference.
#ifndef QUERY_ANSWER_H
#define QUERY_ANSWER_H

#include "../case/case.h"

typedef enum query_question { QUERY_DISTANCE, QUERY_INTERSECT, QUERY_WITHIN } query_question;

typedef struct query_options {
  query_question question;
  gjk_q16 within;
  bool reference;  // the reference answers instead of the library
  bool certify;    // each answer is checked
} query_options;

typedef struct query_answer {
  gjk_status status;
  char refused;                  // 'A' or 'B': the shape that the status is about; 0: the pair
  gjk_distance_result distance;  // of QUERY_DISTANCE
  gjk_decision decision;         // of the other questions
} query_answer;

// Answers pair; a and b are built on the way, and kept for reuse.
void query_answer_case(const query_options *options, const case_pair *pair, case_collider *a, case_collider *b,
                       query_answer *answer);

// The tool's line for an answer, without the end of the line.
void query_answer_print(FILE *file, const query_options *options, const case_pair *pair, const query_answer *answer);

#endif
