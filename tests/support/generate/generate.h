// Families of random pairs of polytopes, easy and hard, for tests in exact integers.
#ifndef GENERATE_H
#define GENERATE_H

#include "case/case.h"
#include "random.h"

typedef struct generate_family {
  const char *name;
  void (*generate)(random_state *random, case_pair *pair);
  unsigned least, most;  // percent of the pairs that intersect; outside of these the family misses its purpose
  int32_t near;          // LSB: at least 9 in 10 of the pairs apart are at most so far apart; 0: any distance
} generate_family;

extern const generate_family generate_families[];
extern const unsigned generate_family_count;

// Makes the pair of a family that seed stands for; its id is the family's name and the seed. pair: its memory is used
// again.
void generate_pair(const generate_family *family, uint64_t seed, case_pair *pair);

// A cache of random bits, small numbers more often than not.
gjk_cache generate_cache(random_state *random);

// What is known of a pair of generate_smallest by its making. B lies above A by a gap. The gap misses the threshold of
// level / 2 LSB by about 1 / |normal|, as little as the lattice allows, or meets it: the deciding determinant is -1, 0
// or 1.
typedef struct generate_height {
  int64_t level;  // half LSB
  int side;       // the sign of gap - level / 2
  unsigned bits;  // the length of the normal has so many
} generate_height;

typedef enum generate_contact {
  GENERATE_FACE_VERTEX,  // a face of A below a vertex of B
  GENERATE_FACE_FACE,    // a face of A below a parallel face of B
  GENERATE_EDGE_EDGE     // an edge of A below a crossing edge of B
} generate_contact;

// Makes such a pair. thick: both shapes have an inside behind the contact, so that a gap below 0 is an overlap. level:
// 0 to 40.
void generate_smallest(random_state *random, generate_contact contact, int64_t level, bool thick, case_pair *pair,
                       generate_height *height);

#endif
