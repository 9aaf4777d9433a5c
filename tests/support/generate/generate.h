// Families of random pairs of polytopes, easy and hard, all exact integers once posed.
#ifndef GENERATE_H
#define GENERATE_H

#include "case/case.h"
#include "random.h"

typedef struct generate_family {
  const char *name;
  void (*generate)(random_state *random, case_pair *pair);
  // Percent of the pairs that intersect: outside of these the family no longer tests what it is for.
  unsigned least, most;
  // LSB: nearly all pairs that are apart are at most so far apart; 0: it doesn't matter.
  int32_t near;
} generate_family;

extern const generate_family generate_families[];
extern const unsigned generate_family_count;

// The pair number seed of a family, the same whenever this build is asked; its id is the family's name and the seed.
// pair: storage is reused.
void generate_pair(const generate_family *family, uint64_t seed, case_pair *pair);

// Bits at random, small numbers more often than not.
gjk_cache generate_cache(random_state *random);

// A pair whose answer is known from how it was made, by a determinant as small as the lattice allows: B lies above A
// by the gap, and level / 2 LSB is a threshold that the gap misses by about 1 / |normal|, or meets.
typedef struct generate_height {
  int64_t level;  // half LSB
  int side;       // sign of gap - level / 2
  unsigned bits;  // of the length of the normal
} generate_height;

typedef enum generate_contact {
  GENERATE_FACE_VERTEX,  // a face of A below a vertex of B
  GENERATE_FACE_FACE,    // and below a parallel face
  GENERATE_EDGE_EDGE     // an edge of A below a crossing edge of B
} generate_contact;

// thick: both have an inside behind the contact, so that a gap below 0 is an overlap. level: 0 to 40.
void generate_smallest(random_state *random, generate_contact contact, int64_t level, bool thick, case_pair *pair,
                       generate_height *height);

#endif
