// The depth of a pair with a curved shape: bounds from chords of A - B and lines that touch it.
//
// Four support points, along plus and minus x and y, split the boundary of A - B into four arcs. A chord of an arc lies
// inside A - B, so lines that touch the arc are no nearer to the origin than the chord or the lines at the arc's ends.
//
//   1. Take a chord. If its distance is within the tolerance of the best line so far, its arc is settled.
//   2. Support scan across the chord: x is the boundary's farthest point. The line through x is a candidate.
//   3. If x gains next to nothing, the chord lies in the surface, and its arc is settled. Otherwise go on with the chords
//      to x and from x.
//   4. If all arcs are settled, the least distance of a settled chord is a lower bound. Begin again with a quarter of
//      the tolerance, until the bounds are an LSB apart.
//
// Each pass begins anew, so it remembers only the ends of the few chords that await their turn. A chord for which there
// is no room is left out, and found again.
#ifndef GJK2_SRC_CURVED_DEPTH_H
#define GJK2_SRC_CURVED_DEPTH_H

#include "gjk2_edges.h"

// Sets edge to the line of least distance, with height and length across the direction s->d, and to two vertices whose
// edge holds the origin's foot on it; *lower to a lower bound of the distance, LSB. *iterations counts support scans.
// False: GJK2_DEPTH_ITERATIONS_MAX scans have not settled it; the bounds hold. Pre: the origin lies in A - B.
bool gjk2_curved_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations);

#endif
