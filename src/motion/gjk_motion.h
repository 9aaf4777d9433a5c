// How a body moves and turns from one pose to another.
//
// The motion as it is meant, in real numbers, with q for q / |q|:
//   position   from + f (to - from)
//   rotation   first from, then by f times an angle about an axis that stands still in the world: of spin, or of the
//              shortest arc, to from^-1
//
// Rounded are, in units of 2^-30 of a quaternion's length:
//   axis                     each component 0.501:                    0.87
//   arc                      to from^-1:                              1.0     no more at any f, since sin(f x) <= sin(x)
//   angle of the arc         its sine 0.5, one step of Newton 1.5:    2.0
//   sine and cosine          1 each:                                  1.42
//   sine times axis          each component 0.5:                      0.87
//   product with from        each component 0.501:                    1.0
//   together                                                          < 7.2
// A quaternion that is off by so much turns by less than 14.4 2^-30 too far, so a point at a distance r from the pose's
// position is off by less than r 2^-26. The angle itself, of any number of turns, is off by less than 2^-44 radians.
#ifndef GJK_SRC_MOTION_H
#define GJK_SRC_MOTION_H

#include "../arith/gjk_vector.h"
#include "gjk/impact.h"

// The rotation of a motion.
typedef struct gjk_turning {
  uint64_t half_turns;  // half of the angle over the whole way, in units of 2^-48 turns; 0: nothing turns
  int64_t deviation;    // of the motion's first rotation (gjk_rotation.h)
  gjk_unit3 axis;
} gjk_turning;

// Half an angle of a turning, after a part of the way, as a part of a turn in units of 2^-64; whole turns drop out.
// Pre: 0 <= part <= GJK_Q30_ONE.
static inline uint64_t gjk_turning_after(const gjk_turning *turning, gjk_q30 part) {
  const uint32_t high = (uint32_t)(turning->half_turns >> 32), low = (uint32_t)(turning->half_turns & UINT32_MAX);
  return (gjk_umul32(high, (uint32_t)part) << 18) + (gjk_umul32(low, (uint32_t)part) >> 14);
}

// Measures the rotation of a motion. ROTATION: from or, without spin, to has no unit quaternion.
gjk_status gjk_turning_start(const gjk_motion *motion, gjk_turning *out);

// The pose at a fraction of the way. Pre: 0 <= fraction <= GJK_Q30_ONE, gjk_turning_start has set turning.
void gjk_turning_pose(const gjk_motion *motion, const gjk_turning *turning, gjk_q30 fraction, gjk_pose *out);

// A vector as a turning sees it.
typedef struct gjk_turned {
  gjk_vec3 along;   // its part along the axis
  gjk_vec3 off;     // the rest of it
  gjk_vec3 across;  // axis times vector
} gjk_turned;

// Splits v: each component is at most 2^30 in size, and the length 2^30 to within 2^-26.
void gjk_turning_split(const gjk_turning *turning, const gjk_unit3 *v, gjk_turned *out);

// *v = what was split, rotated by twice the half angle of a turning after part of the way, or back.
// The result is within 12 2^-30, length:
//   sine and cosine 1.42, what is along the axis 1.37 (1 - cos) <= 2.8, across 0.87, the result 0.87, the axis 5.3
void gjk_turning_join(const gjk_turning *turning, gjk_q30 part, bool back, const gjk_turned *split, gjk_unit3 *v);

#endif
