// What the parts of a cast in the plane share: reporting a hit, and casts that need a bracket.
#ifndef GJK2_SRC_CAST_REPORT_H
#define GJK2_SRC_CAST_REPORT_H

#include "gjk2/distance.h"
#include "gjk2_way.h"

// What B meets of A at contact: the edge from p to q of A - B, or the vertex p alone.
typedef struct gjk2_contact_place {
  const gjk2_span *p, *q;  // the same where it is a vertex
  gjk_q30 weight;          // of q
  gjk2_vec n;              // from A to B, across the edge; |n| < 2^31
} gjk2_contact_place;

// Writes a miss.
void gjk2_cast_miss(const gjk2_way *way, gjk2_cast_proof proof, gjk2_cast_result *out);

// Writes a hit at the start. gap: the shapes' distance there, or NULL where they intersect.
void gjk2_cast_inside(const gjk2_way *way, const gjk2_distance_result *gap, gjk2_cast_result *out);

// Writes a hit later on the way.
void gjk2_cast_hit(const gjk2_way *way, const gjk2_contact_place *place, const gjk2_portion *portion,
                   gjk2_cast_result *out);

// A cast with a rounded or curved shape, or with a margin. early, late: of gjk2_way_may_meet.
// Statuses: OK or ITERATION_LIMIT.
gjk_status gjk2_advance(gjk2_way *way, gjk_q16 margin, bool early, bool late, gjk2_cast_result *out);

// The same, along the edge from p to q of A - B.
// Pre: polygons; B is to the right of the edge, which is nearest at the start, and which the way hits.
gjk_status gjk2_advance_to_edge(gjk2_way *way, gjk_q16 margin, const gjk2_span *p, const gjk2_span *q,
                                gjk2_cast_result *out);

// Both colliders at a fraction, to the nearest LSB, so that B's place against A is off by at most half of one. Returns
// A's: at_a, or where it stands A itself.
const gjk2_collider *gjk2_cast_places(const gjk2_way *way, gjk_q30 fraction, gjk2_collider *at_a, gjk2_collider *at_b);

// Where the origin is, seen from a vertex, when B has gone a fraction of its way.
gjk2_long gjk2_cast_place_from(const gjk2_way *way, gjk2_vec o, gjk_q30 fraction);

typedef enum gjk2_bound { GJK2_BOUND_AT, GJK2_BOUND_BEYOND, GJK2_BOUND_AWAY } gjk2_bound;

// By how much the whole way closes the gap along n, and an LSB of gap, at the same scale.
typedef struct gjk2_rate {
  int64_t closing, length;
} gjk2_rate;

// AT: the fraction before which no contact comes, since no vertex of A - B lies beyond n . w = most.
// BEYOND: not on the way. AWAY: the way does not lead against n; then *rate is not set. rate: NULL: not wanted.
// near: what |n|, shifted to from 2^29 to 2^30, is likely close to, or 0. Pre: n != 0, |n| < 2^30 + 4.
gjk2_bound gjk2_cast_bound(const gjk2_way *way, gjk2_vec n, int64_t most, int64_t radius, uint32_t near,
                           gjk_q30 *fraction, gjk2_rate *rate);

// The part of the edge from p to q at which the foot of the place at a fraction lies, Q30; before p: below 0, beyond q:
// above GJK_Q30_ONE.
int64_t gjk2_cast_foot(const gjk2_way *way, gjk2_vec p, gjk2_vec q, gjk_q30 fraction);

#endif
