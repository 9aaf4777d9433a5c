// The exact oracle: judges answers about polytopes from their certificates alone, in integers of its own.
//
// It shares no code with the library and reads of a collider only what gjk/collider.h and gjk/certificate.h
// promise: centre, frame, buffer, radii. Every check takes room for the reason of a refusal, why of n bytes.
#ifndef EXACT_H
#define EXACT_H

#include <stddef.h>

#include "feature.h"
#include "gjk/gjk.h"

// The vertices of a posed point, segment, triangle, box or baked hull; 0 for any other collider.
unsigned exact_vertex_count(const gjk_collider *collider);

// In the world. Pre: number below the count.
exact_point exact_vertex(const gjk_collider *collider, unsigned number);

// Are the centres more than 16384 units apart? There the checks apply the contract as it is: a distance within 2^-28 of
// itself, a decision within 2^-28 of the centres' distance, points and the distance along the normal within 2^-27 of it.
bool exact_is_far(const gjk_collider *a, const gjk_collider *b);

// Do decision and distance follow from the certificate?
bool exact_check_gap(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                     size_t n);

// Witness points within 1 LSB of their shapes, their gap within 2 LSB of the distance, normal within 2^-28.
// Pre: exact_check_gap holds.
bool exact_check_points(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                        size_t n);

// Both of them.
bool exact_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                          size_t n);

// Does the answer to gjk_within(a, b, distance) (0: gjk_intersect) follow from the certificate?
bool exact_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, const gjk_decision *decision,
                          char *why, size_t n);

// The certificate's feature, for looking at its weights and determinants; false: it names none of 1 to 3 pairs.
bool exact_named_feature(const gjk_collider *a, const gjk_collider *b, const gjk_certificate *certificate,
                         exact_feature *out);

// Brute force over all simplices of the Minkowski difference, no certificate: for shapes of few vertices.
typedef struct exact_truth {
  bool enclosing;         // the cores share a point
  exact_feature nearest;  // otherwise the nearest feature of A - B
} exact_truth;

// Pairs of vertices that are worth it: all 3-subsets of them are tried.
#define EXACT_BRUTE_MAX 64

// Pre: the product of the vertex counts is at most EXACT_BRUTE_MAX, and not 0.
void exact_brute(const gjk_collider *a, const gjk_collider *b, exact_truth *out);

// Are the shapes at most distance apart?
bool exact_truth_within(const exact_truth *truth, const gjk_collider *a, const gjk_collider *b, gjk_q16 distance);

// The correctly rounded distance, 0 when they share a point. Not saturated: below 2^34.
int64_t exact_truth_distance(const exact_truth *truth, const gjk_collider *a, const gjk_collider *b);

#endif
