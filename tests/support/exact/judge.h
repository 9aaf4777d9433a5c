// What the parts of the exact oracle share while they judge one answer.
#ifndef EXACT_JUDGE_H
#define EXACT_JUDGE_H

#include "exact.h"

typedef struct judge {
  const gjk_collider *a, *b;
  unsigned count_a, count_b;           // vertices
  int64_t radius;                      // both convex radii and the asked distance
  bool far;                            // centres more than 16384 units apart
  int64_t decision_slack;              // LSB: a far decision may be off by 2^-28 of the centres' distance
  int64_t point_slack;                 // LSB: far points, and the distance along the normal, by 2^-27 of it
  unsigned count;                      // pairs of the certificate
  exact_point at_a[4], at_b[4], w[4];  // their vertices in the world and in A - B
  exact_feature feature;
  char *why;
  size_t size;
} judge;

// Writes the reason and returns false.
bool judge_refuse(judge *j, const char *format, ...);

// Begins to judge an answer about a and b; distance is the one that was asked about, or 0. Sets all but the
// certificate's part.
bool judge_start(judge *j, const gjk_collider *a, const gjk_collider *b, int64_t distance, char *why, size_t n);

// Loads the pairs of vertices that the certificate names. False: it names none, more than most, or one that does not
// exist.
bool judge_load(judge *j, const gjk_certificate *certificate, unsigned most);

// Is sign * direction . (v - base) >= 0 for every vertex v of the collider?
bool judge_none_before(const gjk_collider *c, unsigned count, const exact_point *base, const exact_vector *direction,
                       int sign);

// Is the named feature the one of A - B nearest to the origin, and does its nearest point lie inside it? Sets feature.
bool judge_nearest(judge *j, const gjk_certificate *certificate);

// Is normal within 2^-28 of direction / |direction|? A component may not have the opposite sign, nor be set where that
// one is 0.
bool judge_normal(judge *j, const exact_vector *direction, const gjk_unit3 *normal);

// Is point at most limit LSB from the convex hull of up to three vertices?
bool judge_at(const exact_point *point, const exact_point *vertices, unsigned count, int64_t limit);

// Is a coordinate at an end of Q16.16, so that it may have saturated?
bool judge_is_cut(const gjk_vec3 *point);

// -v.
exact_vector judge_opposite(const exact_vector *v);

// Bounds of far distances are counted in so many parts of an LSB.
#define JUDGE_FINE 256

// Does every vertex of A - B lie farther than radius behind the origin along direction? _fine: radius is in parts of an
// LSB.
bool judge_clears(const judge *j, const exact_vector *direction, int64_t radius);
bool judge_clears_fine(const judge *j, const exact_vector *direction, int64_t radius);

// Of a far pair: does the plane across the feature separate the shapes, to within decision_slack? And is the distance
// within 2^-28 of the true one, which that plane bounds from below and the feature from above?
bool judge_far_apart(judge *j, const gjk_certificate *certificate);
bool judge_far_distance(judge *j, const gjk_distance_result *result);

#endif
