// How a shape of the plane moves and turns: its poses, and bounds of what moves how far.
#ifndef GJK2_SRC_SWEEP_H
#define GJK2_SRC_SWEEP_H

#include "../plane/gjk2_vector.h"
#include "gjk2/impact.h"

// A motion, prepared for many poses.
typedef struct gjk2_sweep {
  const gjk2_motion *motion;
  int64_t x, y;        // how far the position moves
  uint64_t rate_high;  // turns for each 2^-30 of the way, of the angle's size: units of 2^-64, and of 2^-96
  uint32_t rate_low;
  uint64_t angle;  // the angle's size over the whole way, radians Q24, rounded up; at most 2^39 + 1
  bool clockwise;
  int64_t deviation;  // of the rotation at the start: see gjk2_rotation.h
} gjk2_sweep;

// Statuses: ROTATION.
gjk_status gjk2_sweep_set(gjk2_sweep *sweep, const gjk2_motion *motion);

// The pose at a fraction. Its position is off by at most half an LSB per component, its rotation by less than 5.4 LSB of
// Q2.30, in length; from and to are exact. Pre: 0 <= fraction <= GJK_Q30_ONE.
void gjk2_sweep_pose(const gjk2_sweep *sweep, gjk_q30 fraction, gjk2_pose *out);

// The position alone.
void gjk2_sweep_place(const gjk2_sweep *sweep, gjk_q30 fraction, gjk2_vec *out);

#endif
