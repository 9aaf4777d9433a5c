// Times of impact of shapes that a body carries: their poses are where the body's pose takes them.
#ifndef GJK_SRC_IMPACT_H
#define GJK_SRC_IMPACT_H

#include "gjk/impact.h"
#include "gjk/pose.h"

// gjk_pose_compose, so that programs whose bodies carry no shapes do not link it.
typedef gjk_status gjk_composer(const gjk_pose *a, const gjk_pose *b, gjk_pose *out);

typedef struct gjk_carried {
  const gjk_collider *collider;
  const gjk_motion *motion;  // of the body
  const gjk_pose *own;       // the collider's in the body's frame; NULL: the body's. Its rotation is a unit.
  uint32_t arm;  // with own: how far the collider's position and centre are from the body's position at most
} gjk_carried;

// As gjk_time_of_impact; pose_a and pose_b of the result are the bodies'. RANGE also if the tolerance does not cover
// the rounding of poses composed with own. Pre: no pointer but own is NULL.
gjk_status gjk_impact_of_carried(const gjk_carried of[2], const gjk_impact_setup *setup, gjk_composer *compose,
                                 gjk_impact_result *out);

#endif
