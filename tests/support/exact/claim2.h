// Judges the library's answers in the plane: by the oracle's own answer (exact2.h), and by their certificates.
//
// Of a collider it reads only what gjk2/collider.h promises. A check that refuses writes its reason to why, n bytes.
#ifndef EXACT_CLAIM2_H
#define EXACT_CLAIM2_H

#include <stddef.h>

#include "exact2.h"
#include "gjk2/gjk2.h"

// A posed collider as points, and its radius.
typedef struct exact2_posed {
  exact2_shape shape;     // its points numbered as in gjk2/certificate.h
  exact2_shape hull;      // the corners alone
  exact2_point *point;    // of shape: owned
  exact2_hull *own_hull;  // of hull: owned
} exact2_posed;

// False: a curved shape or a lazy polygon, which have no vertices to read. out is freed with exact2_posed_free.
bool exact2_posed_set(const gjk2_collider *collider, exact2_posed *out);
void exact2_posed_free(exact2_posed *posed);

// Are the centres more than 16384 units apart? There the contract allows errors, and so do the checks.
bool exact2_is_far(const gjk2_collider *a, const gjk2_collider *b);

// A pair, and what is true of it.
typedef struct exact2_pair {
  exact2_posed a, b;
  bool far;
  exact2_truth truth;
} exact2_pair;

// False: a shape has no vertices to read; nothing is to be freed.
bool exact2_pair_set(const gjk2_collider *a, const gjk2_collider *b, exact2_pair *out);
void exact2_pair_free(exact2_pair *pair);

// Is it the answer to gjk2_distance after GJK_OK: decision, distance, points, normal, certificate?
bool exact2_check_distance(const exact2_pair *pair, const gjk2_distance_result *result, char *why, size_t n);

// To gjk2_within, or with distance 0 to gjk2_intersect?
bool exact2_check_decision(const exact2_pair *pair, gjk_q16 distance, const gjk2_decision *decision, char *why,
                           size_t n);

// To gjk2_penetration after GJK_OK: decision, depth, the move that parts the shapes, points, certificate?
bool exact2_check_penetration(const exact2_pair *pair, const gjk2_penetration_result *result, char *why, size_t n);

#endif
