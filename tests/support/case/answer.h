// One case, one question, one answer: by the library or by the double-precision reference.
#ifndef CASE_ANSWER_H
#define CASE_ANSWER_H

#include "case.h"
#include "gjk/contacts.h"

typedef enum case_ask { CASE_DISTANCE, CASE_INTERSECT, CASE_WITHIN, CASE_PENETRATION } case_ask;

typedef struct case_question {
  case_ask ask;
  gjk_q16 within;
  bool reference;      // the reference answers instead of the library
  bool contacts;       // with CASE_PENETRATION: the manifold as well, not by the reference
  gjk_q16 margin;      // of contacts
  uint8_t iterations;  // with CASE_WITHIN: at most so many; 0: as many as it takes
} case_question;

typedef struct case_answer {
  gjk_status status;
  char refused;                        // 'A' or 'B': the shape that the status is about; 0: the pair
  gjk_distance_result distance;        // of CASE_DISTANCE, and of CASE_PENETRATION: when they are apart
  gjk_decision decision;               // of CASE_INTERSECT and CASE_WITHIN
  bool open;                           // of CASE_WITHIN: the iterations have not settled it
  gjk_penetration_result penetration;  // of CASE_PENETRATION
  gjk_manifold manifold;               // of contacts; the count is 0 otherwise
} case_answer;

// Answers pair; a and b are built on the way, and kept for reuse.
void case_answer_find(const case_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                      case_answer *answer);

// The query tool's line for an answer, without the end of the line.
void case_answer_print(FILE *file, const case_question *question, const case_pair *pair, const case_answer *answer);

// The lines of the contacts below it.
void case_contacts_print(FILE *file, const case_answer *answer);

#endif
