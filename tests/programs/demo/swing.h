// The swing of the scene's arm: where it first hits something.
#ifndef SWING_H
#define SWING_H

#include "gjk/impact.h"
#include "scene.h"

// How far the arm turns about the vertical through the body "arm-base", radians: a quarter of a turn clockwise.
#define SWING_ANGLE (-1.5707963267948966)

// The arm swings as one: bodies whose names begin with "arm-", but not "arm-base", or "gripper-", and "part".
typedef struct scene_swing {
  bool found;   // something is hit; else nothing below is set
  size_t a, b;  // what hits, and what it hits
  gjk_impact_result impact;
  gjk_pose turn;  // from the world at the start to where the arm is at impact.lower
} scene_swing;

bool swing_moves(const scene_body *body);

// Swings the arm and finds its first impact. Pairs that overlap or touch at the start do not count, nor do curved bodies
// of the arm. Without a body "arm-base" nothing is found.
void swing_find(const scene *s, scene_swing *out);

// The pose of a body of the arm at the impact.
gjk_pose swing_pose(const scene_swing *swing, const gjk_pose *start);

// How far the arm has turned by then, degrees.
double swing_degrees(const scene_swing *swing);

#endif
