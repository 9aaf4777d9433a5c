// Families of random casts of polytopes, easy and hard, for tests in exact integers.
#ifndef GENERATE_CAST_H
#define GENERATE_CAST_H

#include "case/case.h"
#include "random.h"

// least, most, inside: percent of the casts that hit at least and at most, and that are together at the start at least;
// outside of these the family misses its purpose. many: of vertices, too many for the oracle.
typedef struct generate_cast_family {
  const char *name;
  void (*generate)(random_state *random, case_pair *pair);
  unsigned least, most, inside;
  bool many;
} generate_cast_family;

extern const generate_cast_family generate_cast_families[];
extern const unsigned generate_cast_family_count;

// Makes the cast of a family and a seed. B moves, A sometimes. pair is zeroed before the first call.
void generate_cast(const generate_cast_family *family, uint64_t seed, case_pair *pair);

#endif
