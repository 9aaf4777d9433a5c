// What the parts of the exact oracle share while they judge one answer.
#ifndef EXACT_JUDGE_H
#define EXACT_JUDGE_H

#include "exact.h"

typedef struct judge {
  const gjk_collider *a, *b;
  unsigned count_a, count_b;           // vertices
  int64_t radius;                      // the roundings and the asked distance
  bool far;                            // centres more than 16384 units apart
  int64_t decision_slack;              // LSB that a far decision may be off: 2^-28 of the centres' distance
  int64_t point_slack;                 // LSB that far points may be off, and the distance along the normal: 2^-27 of it
  unsigned count;                      // pairs of the certificate
  exact_point at_a[4], at_b[4], w[4];  // their vertices in the world and in A - B
  exact_feature feature;
  char *why;
  size_t size;
} judge;

// Writes the reason and returns false.
bool judge_refuse(judge *j, const char *format, ...);

bool judge_start(judge *j, const gjk_collider *a, const gjk_collider *b, int64_t distance, char *why, size_t n);

// The named pairs, of which there may be 1 to most.
bool judge_load(judge *j, const gjk_certificate *certificate, unsigned most);

// Does no vertex of the collider lie before base against direction, times sign?
bool judge_none_before(const gjk_collider *c, unsigned count, const exact_point *base, const exact_vector *direction,
                       int sign);

// Is the named feature nearest to the origin, its nearest point inside it? Sets feature.
bool judge_nearest(judge *j, const gjk_certificate *certificate);

// Is the normal within 2^-28 of the direction's, none of its components across or against that one's?
bool judge_normal(judge *j, const exact_vector *direction, const gjk_unit3 *normal);

// Is the point at most limit from the hull of up to three vertices?
bool judge_at(const exact_point *point, const exact_point *vertices, unsigned count, int64_t limit);

// A coordinate at the end of the world: the point may have been cut off there.
bool judge_is_cut(const gjk_vec3 *point);

exact_vector judge_opposite(const exact_vector *v);

// A part of an LSB, for bounds of far distances.
#define JUDGE_FINE 256

// Does every vertex of A - B lie farther than radius behind the origin along direction? The same for a radius in fine parts.
bool judge_clears(const judge *j, const exact_vector *direction, int64_t radius);
bool judge_clears_fine(const judge *j, const exact_vector *direction, int64_t radius);

// A far pair: does the plane of the feature separate, to within the slack of a decision? Is the distance, which that plane bounds
// from below and the feature from above, within 2^-28 of itself?
bool judge_far_apart(judge *j, const gjk_certificate *certificate);
bool judge_far_distance(judge *j, const gjk_distance_result *result);

#endif
