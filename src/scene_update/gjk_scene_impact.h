// Parts on their way: how far they reach, and where two of them first touch.
#ifndef GJK_SRC_SCENE_IMPACT_H
#define GJK_SRC_SCENE_IMPACT_H

#include "../scene/gjk_scene_part.h"

// One body on its way.
typedef struct gjk_scene_mover {
  gjk_pose from, to;
  bool moves, turns;
} gjk_scene_mover;

// An answer about two parts.
typedef struct gjk_scene_impact {
  bool hit;
  bool at_start;      // they touch there
  bool unproven;      // the query has reached a limit: counts as hit
  uint32_t fraction;  // of the way, Q30 rounded down
} gjk_scene_impact;

// How far a point of a part is from the origin of its body at most, rounding of poses included. Below 2^34.
int64_t gjk_scene_reach_of(const gjk_scene_view *v, const gjk_scene_part *p);

// Does a part turn with its body? A point at its origin, with a convex radius or without, does not.
bool gjk_scene_turns_with(const gjk_scene_view *v, const gjk_scene_mover *m, const gjk_scene_part *p);

// A part's collider at the start. If its body does not move, that is where it is now.
void gjk_scene_at_start(const gjk_scene_view *v, const gjk_scene_mover *m, const gjk_scene_part *p, gjk_collider *c);

// Where part p[0] of body m[0] and part p[1] of m[1] first touch on their ways.
void gjk_scene_find_impact(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2],
                           gjk_scene_impact *out);

// The same, but a touch at the start does not count. Then only another part of a concave body can be in the way (ahead
// in gjk_scene_concave).
void gjk_scene_find_impact_ahead(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2],
                                 gjk_scene_impact *out);

#endif
