// What a time of impact in the plane knows of two shapes on their motions.
#ifndef GJK2_SRC_IMPACT_H
#define GJK2_SRC_IMPACT_H

#include "../plane/gjk2_close.h"
#include "gjk2/impact.h"
#include "gjk2_sweep.h"

// Are gaps measured without a search? See gjk2_close.h.
#define GJK2_IMPACT_TOUCHES (GJK_64_BIT && !GJK_SMALL)

typedef struct gjk2_mover {
  gjk2_sweep sweep;
  gjk2_pose pose;
  gjk2_collider posed;
  int64_t reach;  // not below R
  int64_t arc;    // of the whole way, as far as the core reaches, LSB
  bool point;     // a circle's core: no rotation moves it, so pose has its position alone
} gjk2_mover;

typedef struct gjk2_impact {
  gjk2_mover a, b;
  const gjk2_impact_setup *setup;
  gjk2_search search;
  gjk2_distance_result gap;  // of nearest features distance, bounds and normal alone
#if GJK2_IMPACT_TOUCHES
  bool close;    // points, segments and boxes of two half axes in all: see gjk2_close.h
  bool touched;  // the gap was found without a search, which names the feature alone
#endif
  bool nearest;   // the search has found the nearest feature of polygons, in a near frame
  bool open;      // the gap is only bounded, and not along its normal
  int64_t error;  // LSB Q8
  int64_t half;   // the part of the way on which both turn by half a radian together
} gjk2_impact;

// angle times length, rounded up, LSB. Pre: angle at most 2^40, length at most 2^32.
static inline int64_t gjk2_impact_arc(uint64_t angle, int64_t length) {
  if (angle >> 30 == 0) {
    return (int64_t)((angle * (uint64_t)length) >> 24) + 1;
  }
  return (int64_t)((((angle >> 8) + 1) * (uint64_t)length) >> 16) + 1;
}

// Code chosen for size turns all cores alike.
static inline bool gjk2_impact_is_point(const gjk2_mover *m) {
  return !GJK_SMALL && m->point;
}

// room / rate as a fraction of the way, at most 2^-12 of itself too small; beyond the end: more than GJK_Q30_ONE.
// room: Q8, above 0; rate: LSB for the whole way, below 2^54.
int64_t gjk2_impact_step(int64_t room, int64_t rate);

// For how much more of the way the shapes are proven apart; 0: not at all.
int64_t gjk2_impact_advance(const gjk2_impact *s);

#endif
