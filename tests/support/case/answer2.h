// Answers one question about one case of the plane: by the library, or by the reference in double.
#ifndef CASE_ANSWER2_H
#define CASE_ANSWER2_H

#include "answer.h"
#include "case2.h"

typedef struct case2_answer {
  gjk_status status;
  char refused;                         // 'A' or 'B': status is about that shape; 0: about the pair
  gjk2_distance_result distance;        // of CASE_DISTANCE; of CASE_PENETRATION if the shapes are apart
  gjk2_decision decision;               // of CASE_INTERSECT and CASE_WITHIN
  bool open;                            // of CASE_WITHIN: question.iterations were too few to tell
  gjk2_penetration_result penetration;  // of CASE_PENETRATION
  gjk2_manifold manifold;               // if contacts were asked for; else its count is 0
} case2_answer;

// Answers question about pair. Builds a and b from its shapes; both may be used again afterwards.
void case2_answer_find(const case_question *question, const case2_pair *pair, case2_collider *a, case2_collider *b,
                       case2_answer *answer);

// Prints an answer as the query tool does: one line, without its line feed.
void case2_answer_print(FILE *file, const case_question *question, const case2_pair *pair, const case2_answer *answer);

// Prints the contacts of an answer, one line each.
void case2_contacts_print(FILE *file, const case2_answer *answer);

#endif
