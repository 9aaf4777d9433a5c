// Pairs of the plane whose deciding determinant is -1, 0 or 1, edges of 14 to 28 bits.
#ifndef GENERATE_SMALLEST2_H
#define GENERATE_SMALLEST2_H

#include "generate2.h"

// A vertex against an edge.
void generate2_smallest(random_state *random, case2_pair *pair);

// The same, edges of about so many bits, 14 to 27.
void generate2_smallest_bits(random_state *random, unsigned bits, case2_pair *pair);

// Parallel edges.
void generate2_smallest_edges(random_state *random, case2_pair *pair);

// A vertex against an edge, at a gap next to the sum of the radii.
void generate2_smallest_rounded(random_state *random, case2_pair *pair);

#endif
