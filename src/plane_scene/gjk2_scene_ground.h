// Ground as a part of a scene: its times of impact.
#ifndef GJK2_SRC_SCENE_GROUND_H
#define GJK2_SRC_SCENE_GROUND_H

#include "gjk2/impact.h"

// The query for the time of impact of two convex shapes: gjk2_time_of_impact. The caller names it, so that ground does
// not link it.
typedef gjk_status gjk2_impact_query(const gjk2_collider *a, const gjk2_motion *motion_a, const gjk2_collider *b,
                                     const gjk2_motion *motion_b, const gjk2_impact_setup *setup,
                                     gjk2_impact_result *out);

// Where two parts first touch on their ways, one of which is ground; hit, overlap and lower are set. ahead: only
// segments count that the whole body is in front of, by more than the tolerance, where these motions begin. NULL: every
// segment counts.
gjk_status gjk2_scene_ground_impact(const gjk2_collider c[2], const gjk2_motion motion[2], gjk_q16 margin,
                                    const gjk2_motion *ahead, gjk2_impact_query *query, gjk2_impact_result *out);

#endif
