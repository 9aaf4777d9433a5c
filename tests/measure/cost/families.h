// The families of pairs that costs are measured on.
#ifndef COST_FAMILIES_H
#define COST_FAMILIES_H

#include <stdint.h>

#include "cost.h"

// How far apart the shapes of a pair are.
typedef enum cost_gap {
  COST_APART,        // 0.1 to 2 units
  COST_CLOSE,        // less than 0.1 units, not touching
  COST_EITHER_SIDE,  // less than 0.1 units apart, or less than 0.1 units deep, in turn
  COST_OVERLAPPING,
  // B rests on the top of A, moved aside by up to half of it:
  COST_FLUSH,   // up to 0.002 units deep
  COST_TURNED,  // the same, and turned by up to 0.002 in any direction
  COST_YAWED,   // and by any angle about the normal
  COST_LIFTED,  // as turned, up to 0.01 units apart
  COST_LEVEL    // as flush, A level, B by any angle about the vertical; a capsule lies
} cost_gap;

// vertices: of each hull.
typedef struct cost_family {
  const char *name;
  cost_query query;
  cost_kind a, b;
  unsigned vertices;
  cost_gap gap;
} cost_family;

extern const cost_family cost_families[];
extern const size_t cost_family_count;

// Makes count pairs of a family; a seed makes the same ones each time.
cost_pair *cost_pairs_make(const cost_family *family, uint64_t seed, size_t count);
void cost_pairs_free(cost_pair *pairs, size_t count);

#endif
