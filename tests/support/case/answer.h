// Answers one question about one case: by the library, or by the reference in double.
#ifndef CASE_ANSWER_H
#define CASE_ANSWER_H

#include "case.h"
#include "gjk/contacts.h"

typedef enum case_ask { CASE_DISTANCE, CASE_INTERSECT, CASE_WITHIN, CASE_PENETRATION } case_ask;

typedef struct case_question {
  case_ask ask;
  gjk_q16 within;      // of CASE_WITHIN: the distance that is asked about
  bool reference;      // the reference answers instead of the library
  bool contacts;       // with CASE_PENETRATION: the manifold as well; the reference has none
  gjk_q16 margin;      // of contacts
  uint8_t iterations;  // of CASE_WITHIN: stop after so many; 0: as many as it takes
} case_question;

typedef struct case_answer {
  gjk_status status;
  char refused;                        // 'A' or 'B': status is about that shape; 0: about the pair
  gjk_distance_result distance;        // of CASE_DISTANCE; of CASE_PENETRATION if the shapes are apart
  gjk_decision decision;               // of CASE_INTERSECT and CASE_WITHIN
  bool open;                           // of CASE_WITHIN: question.iterations were too few to tell
  gjk_penetration_result penetration;  // of CASE_PENETRATION
  gjk_manifold manifold;               // if contacts were asked for; else its count is 0
} case_answer;

// Answers question about pair. Builds a and b from its shapes; both may be used again afterwards.
void case_answer_find(const case_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                      case_answer *answer);

// Prints an answer as the query tool does: one line, without its line feed.
void case_answer_print(FILE *file, const case_question *question, const case_pair *pair, const case_answer *answer);

// What a status says about a case, in words.
const char *case_status_detail(gjk_status status);

// Prints the contacts of an answer, one line each.
void case_contacts_print(FILE *file, const case_answer *answer);

#endif
