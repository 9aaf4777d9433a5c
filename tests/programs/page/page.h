// What the page's script calls: gjk-query's answers, pairs on a lattice, the golden hashes, the pile of two panes.
//
// Texts end with a 0. A text that is returned stays until the next call.
#ifndef PAGE_H
#define PAGE_H

#include <stdint.h>

typedef enum page_ask {
  PAGE_DISTANCE,
  PAGE_INTERSECT,
  PAGE_WITHIN,
  PAGE_PENETRATION,
  PAGE_CONTACTS,
  PAGE_CAST,
  PAGE_RAY,
  PAGE_IMPACT
} page_ask;

// What is printed below an answer, and who answers.
enum {
  PAGE_TRACE = 1,      // each iteration, as gjk-query --trace
  PAGE_PROOF = 2,      // the certificate, and whether the library's check proves the answer
  PAGE_POSED = 4,      // the vertices as posed, raw integers of the world
  PAGE_REFERENCE = 8,  // the reference in double answers, as gjk-query --reference
  PAGE_CASE = 16       // the case itself, raw integers
};

// Answers every case in a text as gjk-query does. number: the margin or the distance that is asked about, Q16.16.
const char *page_answer(const char *cases, int ask, int32_t number, unsigned flags);

// What gjk-query would have written to standard error.
const char *page_messages(void);

// 1 if the hash over so many pairs (golden.h, plane_golden.h) is the one of all platforms; 0 else.
int page_golden(void);
int page_golden_plane(void);

// The hash of page_golden as text, base 16.
const char *page_golden_text(void);

#endif
