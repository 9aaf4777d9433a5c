// The reference: the same queries in floating point, as a good library answers them; right away from touching.
//
// An implementation of its own (GJK by signed volumes, solver.h), in double; reference_float.c is the same in float.
#ifndef REFERENCE_H
#define REFERENCE_H

#include "case/case.h"

// Lengths in LSB, world frame.
typedef struct reference_result {
  bool intersecting;
  double distance;    // 0 when intersecting
  double a[3], b[3];  // nearest points; not set when intersecting
  double normal[3];   // unit, from A to B; not set when intersecting
  int iterations;
} reference_result;

// The shapes at their poses in the reals.
void reference_query(const case_pair *pair, reference_result *out);

// The integers that posing has made of the polytopes, so that only the query differs from the library's; lazy hulls
// and curved shapes by their rotation rows. a and b are built from the shapes of pair.
void reference_query_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                           reference_result *out);

void reference_float_query(const case_pair *pair, reference_result *out);
void reference_float_query_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                                 reference_result *out);

// The same, and when intersecting the depth by an expanding polytope (expanding.h): distance is minus the depth; a, b
// and normal are set as of gjk_penetration.
void reference_signed_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                            reference_result *out);
void reference_float_signed_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                                  reference_result *out);

#endif
