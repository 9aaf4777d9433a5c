// The gap between two shapes at a fraction of a cast's way, as a plane bounds it from below.
//
// The shapes move without turning, so each vertex w of A - B moves by -s t (gjk_way.h). So a plane across a direction
// that touches A - B at one fraction touches it, moved, at every other one, and bounds the gap there too.
#ifndef GJK_SRC_GAP_H
#define GJK_SRC_GAP_H

#include "../gjk/gjk_iteration.h"
#include "gjk_way.h"

typedef struct gjk_gap {
  const gjk_way *way;
  int64_t radius;    // LSB: the gap is the distance of the cores less the radius
  gjk_long3 start;   // centre_a - centre_b at the start
  gjk_unit3 normal;  // the plane's, from A to B
  int64_t above;     // the plane's gap, Q16 LSB: at most the gap, and as near to it as stated below
  gjk_vec3 rest;     // what the frame's delta leaves of centre_a - centre_b, Q30 LSB
  unsigned scale;    // way->t / 2^scale is int32
  unsigned used;     // iterations of all measurements
  gjk_iteration it;
} gjk_gap;

// Prepares the measurements of a pair, from a cold start.
void gjk_gap_start(gjk_gap *gap, const gjk_collider *a, const gjk_collider *b, const gjk_way *way, int64_t radius);

// Measures at a fraction, from 0 to GJK_Q30_ONE. Starts from the feature of the last measurement.
//
// NEAREST     normal and above are set. The gap exceeds above by at most
//               2^-4 LSB                    for a reach (gjk_frame.h) below 2^22 LSB, 1/2 below 2^26
//               1/2 LSB + 1 / (2 distance)  above that
//               2^-23 of the distance       far frames
//             If a shape is curved, above is that of the support points, which err by an LSB for each such shape.
// ENCLOSING   the cores share a point; nothing is set. If radius is above 0, only curved shapes can cause it.
// LIMIT       of a curved pair, and GJK_ITERATIONS_MAX iterations are used: normal and above are set, above a bound.
gjk_outcome gjk_gap_measure(gjk_gap *gap, gjk_q30 fraction);

// Moves the feature to a fraction without a search. Is it a triangle whose plane bounds polytopes, and does the triangle
// remain the nearest feature? Then the normal stays. False: above and the feature are invalid until the next
// measurement.
bool gjk_gap_follow(gjk_gap *gap, gjk_q30 fraction);

// Bounds on how much the plane's gap decreases over the whole way, Q30 in units of 2^scale LSB. Not above 0: the way
// leads away from the plane or along it.
typedef struct gjk_slope {
  int64_t low, high;  // below 2^62 in size
} gjk_slope;

gjk_slope gjk_gap_slope(const gjk_gap *gap);

// The point of A's core nearest to B, moved by A's convex radius along the normal, in LSB from A's centre.
gjk_vec3 gjk_gap_point(const gjk_gap *gap);

#endif
