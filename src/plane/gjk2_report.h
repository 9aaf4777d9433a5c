// What the distance and the penetration queries of the plane share.
#ifndef GJK2_SRC_REPORT_H
#define GJK2_SRC_REPORT_H

#include "gjk2/distance.h"
#include "gjk2_search.h"

// Bounds of the distance, or of minus the depth, in LSB, that the last iteration of an outcome LIMIT proves.
//   lower   no vertex of A - B lies before the line through the last support point
//   upper   that of the feature; *nearest: the same to the nearest LSB
// Returns ENCLOSING or NEAR when upper <= 0 settles the question after all, otherwise LIMIT. Sets s->d and s->base to
// the feature's. Pre: at least one iteration.
gjk2_outcome gjk2_distance_bounds(gjk2_search *s, int64_t *lower, int64_t *nearest, int64_t *upper);

// The distance of a nearest feature, from 0 on. length: of s->d. Sets *saturated where it is beyond Q16.16.
gjk_q16 gjk2_distance_of(const gjk2_search *s, const gjk2_length *length, bool *saturated);

// Reports the answer and keeps the cache, which may be NULL. Pre: the outcome is NEAREST, ENCLOSING or NEAR.
void gjk2_distance_report(const gjk2_search *s, gjk2_outcome outcome, gjk2_cache *cache, gjk2_distance_result *out);

// After a search for the distance ended with LIMIT: the outcome that settles the question after all, or LIMIT. Then out
// has bounds, and gjk2_distance_stop writes the points so far.
gjk2_outcome gjk2_distance_settle(gjk2_search *s, gjk2_distance_result *out);
void gjk2_distance_stop(const gjk2_search *s, gjk2_distance_result *out);

#endif
