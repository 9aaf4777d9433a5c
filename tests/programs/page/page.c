// Answers cases as gjk-query does, and runs the golden hashes.
#include "page.h"

#include <stdio.h>
#include <string.h>

#include "../query/motion.h"
#include "../query/trace.h"
#include "case/answer2.h"
#include "case/parse.h"
#include "proof.h"
#include "tests/check/target/golden.h"
#include "tests/check/target/plane_golden.h"

static char written[1 << 22], messages[1 << 16];
static case_reader reader;
static case_pair pair;
static case2_pair pair2;
static case_collider a, b;
static case2_collider a2, b2;
static trace steps;

static void rewind_to(FILE *file, char *text, size_t size) {
  file->text = text;
  file->at = 0;
  file->size = size - 1;
}

static const char *text_of(FILE *file) {
  file->text[file->at < file->size ? file->at : file->size] = '\0';
  return file->text;
}

static case_question question_of(int ask, int32_t number, unsigned flags) {
  static const case_ask asks[] = {CASE_DISTANCE, CASE_INTERSECT, CASE_WITHIN, CASE_PENETRATION, CASE_PENETRATION};
  const case_question question = {.ask = ask <= PAGE_CONTACTS ? asks[ask] : CASE_DISTANCE,
                                  .within = number,
                                  .reference = (flags & PAGE_REFERENCE) != 0,
                                  .contacts = ask == PAGE_CONTACTS,
                                  .margin = number};
  return question;
}

static motion_question motion_of(int ask, int32_t number) {
  const motion_question motion = {.ask = ask == PAGE_CAST     ? MOTION_CAST
                                         : ask == PAGE_RAY    ? MOTION_RAY
                                         : ask == PAGE_IMPACT ? MOTION_IMPACT
                                                              : MOTION_NONE,
                                  .margin = number};
  return motion;
}

// In space.
static void answer_pair(int ask, int32_t number, unsigned flags) {
  const case_question question = question_of(ask, number, flags);
  const motion_question motion = motion_of(ask, number);
  bool refused;
  if (motion.ask != MOTION_NONE) {
    motion_answer answer;
    motion_find(&motion, &pair, &a, &b, &answer);
    motion_print(stdout, &motion, &pair, &answer);
    fputc('\n', stdout);
    refused = answer.refused != 0;
  } else {
    case_answer answer;
    case_answer_find(&question, &pair, &a, &b, &answer);
    case_answer_print(stdout, &question, &pair, &answer);
    fputc('\n', stdout);
    case_contacts_print(stdout, &answer);
    refused = answer.refused != 0;
    if (!refused && (flags & PAGE_TRACE) != 0) {
      trace_space(&question, &a.collider, &b.collider, &steps);
      trace_print(stdout, &steps);
    }
    if (!refused && (flags & PAGE_PROOF) != 0) {
      proof_space(stdout, &question, &answer, &a.collider, &b.collider);
    }
  }
  if (!refused && (flags & PAGE_POSED) != 0) {
    proof_posed(stdout, 'A', &a.collider);
    proof_posed(stdout, 'B', &b.collider);
  }
  if ((flags & PAGE_CASE) != 0) {
    case_print(stdout, &pair);
  }
}

// In the plane.
static void answer_pair2(int ask, int32_t number, unsigned flags) {
  const case_question question = question_of(ask, number, flags);
  const motion_question motion = motion_of(ask, number);
  bool refused;
  if (motion.ask != MOTION_NONE) {
    motion2_answer answer;
    motion2_find(&motion, &pair2, &a2, &b2, &answer);
    motion2_print(stdout, &motion, &pair2, &answer);
    fputc('\n', stdout);
    refused = answer.refused != 0;
  } else {
    case2_answer answer;
    case2_answer_find(&question, &pair2, &a2, &b2, &answer);
    case2_answer_print(stdout, &question, &pair2, &answer);
    fputc('\n', stdout);
    case2_contacts_print(stdout, &answer);
    refused = answer.refused != 0;
    if (!refused && (flags & PAGE_TRACE) != 0) {
      trace_plane(&question, &a2.collider, &b2.collider, &steps);
      trace_print(stdout, &steps);
    }
    if (!refused && (flags & PAGE_PROOF) != 0) {
      proof_plane(stdout, &question, &answer, &a2.collider, &b2.collider);
    }
  }
  if (!refused && (flags & PAGE_POSED) != 0) {
    proof_posed2(stdout, 'A', &a2.collider);
    proof_posed2(stdout, 'B', &b2.collider);
  }
  if ((flags & PAGE_CASE) != 0) {
    case2_print(stdout, &pair2);
  }
}

const char *page_answer(const char *cases, int ask, int32_t number, unsigned flags) {
  FILE in = {(char *)(uintptr_t)cases, 0, strlen(cases)};
  case_found found;
  rewind_to(stdout, written, sizeof written);
  rewind_to(stderr, messages, sizeof messages);
  case_reader_open(&reader, &in, "standard input");
  while ((found = case_reader_next_any(&reader, &pair, &pair2)) != CASE_FOUND_NONE) {
    if (found == CASE_FOUND_PLANE) {
      answer_pair2(ask, number, flags);
    } else {
      answer_pair(ask, number, flags);
    }
  }
  return text_of(stdout);
}

const char *page_messages(void) {
  return messages[0] == '\0' && stderr->text == NULL ? messages : text_of(stderr);
}

static uint64_t golden;

int page_golden(void) {
  golden = golden_hash(GOLDEN_PAIRS);
  return golden == GOLDEN_HASH;
}

int page_golden_plane(void) {
  return plane_golden_hash(PLANE_GOLDEN_PAIRS) == PLANE_GOLDEN_HASH;
}

const char *page_golden_text(void) {
  static char text[17];
  for (unsigned i = 0; i < 16; i++) {
    text[i] = "0123456789abcdef"[golden >> (60 - 4 * i) & 15];
  }
  return text;
}
