// Convex parts that enclose a solid.
#ifndef DECOMPOSE_H
#define DECOMPOSE_H

#include "enclose.h"
#include "excess.h"

typedef struct decompose_options {
  long double excess;  // wanted, LSB; below 0: exact where there are few notches, else a 64th of the longest side
  unsigned parts;      // wanted at most; 0: any number
} decompose_options;

typedef struct decomposition {
  part *part;
  size_t parts;
  excess_bounds excess;           // both 0: none, proven exactly
  long double wanted;             // what the options ask of the excess, or its default; LSB
  bool enclosed;                  // proven exactly
  size_t notches;                 // edges of the solid where it is not convex
  char problem[ENCLOSE_PROBLEM];  // if not enclosed
} decomposition;

void decompose(const solid *s, const decompose_options *options, decomposition *out);

void decompose_free(decomposition *d);

#endif
