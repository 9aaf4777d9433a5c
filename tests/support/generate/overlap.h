// Families of pairs that overlap, from 1 LSB deep to concentric.
#ifndef GENERATE_OVERLAP_H
#define GENERATE_OVERLAP_H

#include "generate.h"

// As generate_families; near is not used.
extern const generate_family generate_overlaps[];
extern const unsigned generate_overlap_count;

#endif
