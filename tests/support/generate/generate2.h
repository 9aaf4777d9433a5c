// Families of random pairs in the plane, easy and hard, for tests in exact integers.
#ifndef GENERATE2_H
#define GENERATE2_H

#include "case/case2.h"
#include "exact/exact2.h"
#include "random.h"

typedef struct generate2_family {
  const char *name;
  void (*generate)(random_state *random, case2_pair *pair);
  unsigned least, most;  // percent of the pairs that intersect; outside of these the family misses its purpose
  int32_t near;          // LSB: at least 9 in 10 of the pairs apart are at most so far apart; 0: any distance
} generate2_family;

extern const generate2_family generate2_families[];
extern const unsigned generate2_family_count;

// Makes the pair of a family that seed stands for; its id is the family's name and the seed. pair: its memory is used
// again.
void generate2_pair(const generate2_family *family, uint64_t seed, case2_pair *pair);

// Most vertices of a generated shape.
#define GENERATE2_VERTICES_MAX 256

// The points whose convex hull the core is, world frame; those of a turned shape within 1 LSB of where the library
// poses them. Returns their number. Pre: no ellipse; at most GENERATE2_VERTICES_MAX vertices.
unsigned generate2_points(const case2_shape *shape, exact2_point out[GENERATE2_VERTICES_MAX]);

#endif
