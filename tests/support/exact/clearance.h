// Is the gap of two moving bodies above a margin on their way, also between the fractions at which it is measured? A gap can
// change by no more than the bodies' farthest points move against each other.
#ifndef EXACT_CLEARANCE_H
#define EXACT_CLEARANCE_H

#include "gjk/impact.h"
#include "gjk2/impact.h"

typedef enum clearance_outcome {
  CLEARANCE_PROVEN,
  CLEARANCE_OPEN,    // it takes more than the most distances, or one is not to be had
  CLEARANCE_TOUCHED  // a measured gap is too small
} clearance_outcome;

typedef struct clearance {
  bool (*gap)(void *user, gjk_q30 fraction, int64_t *out);  // the gap as posed there, LSB; false: none
  void *user;
  double speed;    // by how much the gap may change on the whole way, LSB
  double least;    // measured gaps must not be below, LSB
  double between;  // gaps in between must be above, LSB
  unsigned most;   // distances
  unsigned measured;
  gjk_q30 at;  // of the last gap measured
  int64_t last;
} clearance;

// From fraction 0 to limit; the gap at limit itself need not be least.
clearance_outcome clearance_search(clearance *c, gjk_q30 limit);

// How far points of one body may move against points of the other, LSB; and how far a body's points are from its position.
double clearance_speed(const gjk_motion *a, double reach_a, const gjk_motion *b, double reach_b);
double clearance_reach(const gjk_collider *c);
double clearance2_speed(const gjk2_motion *a, double reach_a, const gjk2_motion *b, double reach_b);
double clearance2_reach(const gjk2_collider *c);

#endif
