// A pair of space with B at every point of a lattice: what the library, double and float answer there.
#ifndef PAGE_LATTICE_H
#define PAGE_LATTICE_H

#include <stdint.h>

#include "reference/reference.h"

#define PAGE_LATTICE_MAX 128

// The bits of a cell: the method says that the shapes intersect; the certificate proves what the library says.
enum { PAGE_SAYS_GJK = 1, PAGE_SAYS_DOUBLE = 2, PAGE_SAYS_FLOAT = 4, PAGE_PROVEN = 8 };

// The reference in double counts a squared distance below this share of the largest squared vertex as 0.
extern double lattice_tolerance;

void lattice_reference_query_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                                   reference_result *out);

// Takes the first case of a text. 0: it is none of space, or the library refuses a shape.
int page_lattice_open(const char *cases);

// Moves B from where its case has it by steps of the lattice: start + i u + k v, i and k from 0 to count - 1.
typedef struct page_steps {
  int32_t start[3], u[3], v[3];
} page_steps;

// Returns the cells, row by row of k. Pre: page_lattice_open was 1; count is at most PAGE_LATTICE_MAX; no step leaves int32.
const uint8_t *page_lattice(const page_steps *steps, unsigned count, double tolerance);

#endif
