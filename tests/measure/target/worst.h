// Searches for the most expensive pairs.
#ifndef WORST_H
#define WORST_H

#include "gjk/gjk.h"
#include "random.h"

#define WORST_VERTICES 64

typedef struct worst_body {
  gjk_shape shape;  // its vertices, if any, are those below
  gjk_pose pose;
  gjk_vec3 vertices[WORST_VERTICES];
} worst_body;

typedef struct worst_pair {
  worst_body body[2];
} worst_pair;

typedef enum worst_kind { WORST_BOXES, WORST_HULLS, WORST_ROUNDED, WORST_CURVED } worst_kind;

typedef struct worst_family {
  const char *name;  // shapes and query
  worst_kind kind;
  uint16_t vertices;  // of hulls, at most
  bool distance;      // else intersect
} worst_family;

extern const worst_family worst_families[];
extern const unsigned worst_family_count;

// A pair that a search has found. tests/build/worst-cases.awk makes C of tests/data/worst.txt.
typedef struct worst_case {
  const char *id;  // FAMILY-MEASURE, the measure one of iterations and instructions
  worst_pair pair;
} worst_case;

extern const worst_case worst_cases[];
extern const unsigned worst_case_count;

// The family that an id names.
const worst_family *worst_family_of(const char *id);

// Poses the pair; false if the library refuses it. Then asks the query without a cache, which is what is measured.
// Returns its iterations.
bool worst_pose(const worst_pair *pair);
const gjk_collider *worst_collider(int number);
unsigned worst_query(const worst_family *family);

// The cost that the search makes as large as it can; 0 for a refused pair.
typedef uint32_t worst_measure(const worst_family *family, const worst_pair *pair);

// Climbs from the known cases of the family and from random pairs, with so many measurements in total. Returns the
// largest cost, and its pair.
uint32_t worst_search(const worst_family *family, worst_measure *measure, uint64_t seed, uint32_t measurements,
                      worst_pair *most);

// Prints a pair as a case of tests/support/case/parse.h with the id FAMILY-MEASURE.
void worst_print(void (*print)(const char *text), const worst_family *family, const char *measure,
                 const worst_pair *pair);

#endif
