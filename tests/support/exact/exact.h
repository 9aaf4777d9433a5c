// The exact oracle: judges answers about polytopes from their certificates alone, in integers of its own.
//
// It shares no code with the library. Of a collider it reads only what gjk/collider.h and gjk/certificate.h promise:
// centre, frame, buffer, radii. A check that refuses writes its reason to why, n bytes.
#ifndef EXACT_H
#define EXACT_H

#include <stddef.h>

#include "feature.h"
#include "gjk/gjk.h"

// How many vertices a posed point, segment, triangle, box or baked hull has; 0 for any other collider.
unsigned exact_vertex_count(const gjk_collider *collider);

// A vertex in the world. Pre: number < exact_vertex_count(collider).
exact_point exact_vertex(const gjk_collider *collider, unsigned number);

// Are the centres more than 16384 units apart? There the contract allows errors, and so do the checks:
//
// distance                                     2^-28 of itself
// decision                                     2^-28 of the centres' distance
// points, and the distance along the normal    2^-27 of the centres' distance
bool exact_is_far(const gjk_collider *a, const gjk_collider *b);

// Do decision and distance follow from the certificate?
bool exact_check_gap(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                     size_t n);

// Does each witness point lie within 1 LSB of its shape, is their gap within 2 LSB of the distance, the normal within
// 2^-28? Pre: exact_check_gap holds.
bool exact_check_points(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                        size_t n);

// exact_check_gap and exact_check_points.
bool exact_check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *result, char *why,
                          size_t n);

// Does the answer to gjk_within(a, b, distance) follow from the certificate? distance 0: the answer to gjk_intersect.
bool exact_check_decision(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, const gjk_decision *decision,
                          char *why, size_t n);

// The feature that a certificate names, for a look at its weights and determinants. False: it does not name 1 to 3.
bool exact_named_feature(const gjk_collider *a, const gjk_collider *b, const gjk_certificate *certificate,
                         exact_feature *out);

// What brute force over all simplices of the Minkowski difference finds, for shapes of few vertices; no certificate is
// read.
typedef struct exact_truth {
  bool enclosing;         // the cores share a point
  exact_feature nearest;  // otherwise the nearest feature of A - B
} exact_truth;

// Most vertices of A - B: all subsets of 3 of them are tried.
#define EXACT_BRUTE_MAX 64

// Pre: the product of the vertex counts is at most EXACT_BRUTE_MAX, and not 0.
void exact_brute(const gjk_collider *a, const gjk_collider *b, exact_truth *out);

// The same of A - B and all places of B on a way against A: what it finds tells whether they come near on the way.
// Pre: twice the product of the vertex counts is at most EXACT_BRUTE_MAX; |way| < 2^33 per axis.
void exact_brute_way(const gjk_collider *a, const gjk_collider *b, const exact_point *way, exact_truth *out);

// Are the shapes at most distance apart?
bool exact_truth_within(const exact_truth *truth, const gjk_collider *a, const gjk_collider *b, gjk_q16 distance);

// The distance of the shapes, correctly rounded; 0 if they share a point. It does not saturate: it is below 2^34.
int64_t exact_truth_distance(const exact_truth *truth, const gjk_collider *a, const gjk_collider *b);

#endif
