// How two shapes of the plane meet: what the signed distance, the penetration and the contacts report of it.
//
// A meeting is the nearest feature of A - B if the cores are apart, or its nearest edge if they intersect. gjk2_meet
// measures it. Its points, which not every query needs, are found on demand.
#ifndef GJK2_SRC_MEETING_H
#define GJK2_SRC_MEETING_H

#include "gjk2_edges.h"

typedef struct gjk2_meeting {
  gjk2_search s;
  gjk2_edge edge;            // of cores that intersect
  const gjk2_vertex *p, *q;  // the feature: an edge, or p alone and q NULL
  gjk2_vec n;                // across the feature's line
  int64_t height;            // n . w of that line
  gjk2_length length;        // of n
  gjk2_unit across;          // n / |n|
  gjk2_unit normal;          // the same; of an overlap rounded outward (gjk2_outward.h)
  gjk_q16 distance;          // of the shapes; of an overlap minus the depth, rounded down
  gjk_q16 lower, upper;      // its bounds
  uint8_t proof;             // of an overlap
  bool overlaps;             // the shapes share a point
  bool saturated;            // distance is
} gjk2_meeting;

// Measures the pair. Writes the cache, which may be NULL, after OK and CAPACITY.
// OK, CAPACITY     everything.
// ITERATION_LIMIT  s alone.
gjk_status gjk2_meet(gjk2_meeting *m, const gjk2_collider *a, const gjk2_collider *b, gjk2_cache *cache);

// The point of each shape on the feature. Returns whether a coordinate has saturated.
bool gjk2_meeting_points(const gjk2_meeting *m, gjk2_vec *point_a, gjk2_vec *point_b);

// Names the overlap's feature.
void gjk2_meeting_certify(const gjk2_meeting *m, gjk2_certificate *out);

// The parts of gjk2_meet. Step 1: the cores by their edges; OPEN also where they are not asked.
gjk2_lie gjk2_meeting_edges(gjk2_meeting *m);
// Step 1 by GJK, from a direction that separates where the edges have found one.
gjk2_outcome gjk2_meeting_search(gjk2_meeting *m, gjk2_goal goal, gjk2_lie lie, const gjk2_cache *cache);
// Step 2: measures the nearest feature of the cores. False: it is beyond the convex radii; then only length is set.
bool gjk2_meeting_gap(gjk2_meeting *m);
// Step 3: measures the overlap of cores that intersect. lie: OVERLAP where the edge is known.
gjk_status gjk2_meeting_overlap(gjk2_meeting *m, gjk2_lie lie);

#endif
