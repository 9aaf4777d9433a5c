// The exact oracle of casts in space: where a polytope that moves in a straight line first touches another.
//
// It finds the planes that bound A - B by brute force, reads no certificate, and shares no code with the library.
// B moved by x shares a point with A exactly if x is in A - B, so a cast asks where a segment enters A - B.
#ifndef EXACT_CAST_H
#define EXACT_CAST_H

#include <stddef.h>

#include "exact.h"

__extension__ typedef __int128 exact_wide;

// The half space normal . x <= height; A - B lies in it and touches its border.
typedef struct exact_half_space {
  exact_wide normal[3];  // below 2^90
  exact_wide height;     // below 2^124
} exact_half_space;

// A - B: the points that all half spaces hold. Zeroed before the first use; may be made again.
typedef struct exact_difference {
  unsigned dimension;     // of A - B, 0 to 3
  size_t count;           // of half spaces; among them are those of all facets
  exact_half_space *all;  // owned
  size_t capacity;
} exact_difference;

// exact_difference_find is for pairs whose vertices have at most so many differences, of A and of B.
#define EXACT_DIFFERENCE_EDGES 800

// False: a shape has no vertices to read, or there are too many. Convex radii are left out.
bool exact_difference_find(const gjk_collider *a, const gjk_collider *b, exact_difference *out);
void exact_difference_free(exact_difference *difference);

// Where is the point from + (numerator / denominator) way? 1: inside; 0: on the border, where everything is of a flat
// A - B; -1: outside.
// Pre: |from|, |way| < 2^33 per axis; 0 <= numerator <= denominator, 0 < denominator <= 2^30.
int exact_difference_side(const exact_difference *difference, const exact_point *from, const exact_point *way,
                          int64_t numerator, int64_t denominator);

typedef struct exact_cast_truth {
  bool hit;
  bool inside;                        // A - B holds from: the fraction is 0
  bool ends;                          // the way ends on the border of A - B, or enters there
  exact_wide numerator, denominator;  // of the fraction at which the way enters, not reduced; denominator > 0
  gjk_q30 fraction;                   // of 2^30, rounded down
  size_t entry;                       // the half space that it enters by, if it is not inside
  size_t entries;                     // how many half spaces it enters by at that fraction
} exact_cast_truth;

// Where does the segment from 'from' to from + way first share a point with A - B? Pre: |from|, |way| < 2^33 per axis.
void exact_cast_find(const exact_difference *difference, const exact_point *from, const exact_point *way,
                     exact_cast_truth *out);

// The component axis of from + fraction way, rounded to the nearest integer below.
int64_t exact_cast_floor(const exact_cast_truth *truth, const exact_point *from, const exact_point *way, int axis);

// The sign of component axis of (from + fraction way) - whole.
int exact_cast_compare(const exact_cast_truth *truth, const exact_point *from, const exact_point *way, int axis,
                       int64_t whole);

// Can normal, a unit vector in Q2.30, be that of the place where the way enters? It must be a unit within 2^-28, lead
// against the way, and no point of A - B may lie beyond the plane across it through that place, but for 2^-28 of the
// way between the two.
bool exact_cast_is_normal(const gjk_collider *a, const gjk_collider *b, const exact_cast_truth *truth,
                          const exact_point *way, const gjk_unit3 *normal);

// numerator / denominator in 2^-30, rounded down. Pre: 0 <= numerator <= denominator < 2^126, 0 < denominator.
gjk_q30 exact_fraction_floor(exact_wide numerator, exact_wide denominator);

// The sign of p q - r s. Pre: |each| < 2^126.
int exact_compare_products(exact_wide p, exact_wide q, exact_wide r, exact_wide s);

exact_int exact_from_wide(exact_wide value);

#endif
