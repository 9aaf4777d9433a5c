// The reference: the same queries in floating point, as a good library answers them. It is right unless the shapes
// almost touch.
//
// It shares no code with the library: GJK by signed volumes (solver.h) and EPA (epa.h), in double. reference_float.c is
// the same in float. It is what the library is compared with in tests, benchmarks and the README.
#ifndef REFERENCE_H
#define REFERENCE_H

#include "case/case.h"

// Lengths in LSB, points in the world frame.
typedef struct reference_result {
  bool intersecting;
  double distance;    // 0 when intersecting
  double a[3], b[3];  // nearest points; not set when intersecting
  double normal[3];   // unit, from A to B; not set when intersecting
  int iterations;
} reference_result;

// The distance of the shapes as posed by the library, so that only the query differs: polytopes by their integer
// vertices, lazy hulls and curved shapes by their rotation matrix. Pre: a and b were built from pair.
void reference_query_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                           reference_result *out);
void reference_float_query_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                                 reference_result *out);

// reference_query_posed, and the depth if the shapes overlap: then distance is minus the depth, and a, b and normal are
// those that gjk_penetration would report.
void reference_signed_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                            reference_result *out);
void reference_float_signed_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                                  reference_result *out);

// What a cast finds. Lengths in LSB.
typedef struct reference_cast_result {
  bool hit;
  double fraction;   // of the way, where the gap is the margin; of a miss where it is least, as far as is known
  double gap;        // there, less the margin
  double normal[3];  // unit, from A to B; 0 where the cores share a point
  int rounds;        // distances measured
  int iterations;
} reference_cast_result;

// B moves by way against A until the gap is the margin: Newton's iteration, a distance and its plane a round. Shapes as
// posed by the library, as of reference_query_posed.
void reference_cast_posed(const case_pair *pair, const case_collider *a, const case_collider *b, const double way[3],
                          double margin, reference_cast_result *out);
void reference_float_cast_posed(const case_pair *pair, const case_collider *a, const case_collider *b,
                                const double way[3], double margin, reference_cast_result *out);

#endif
