// A small lockstep game in the plane for tests, as match.h.
#ifndef PLANE_MATCH_H
#define PLANE_MATCH_H

#include "gjk2/gjk2.h"
#include "gjk2/scene.h"

#define MATCH_BODIES 24
#define MATCH_PAIRS 160
#define MATCH_WORDS ((292 + MATCH_BODIES * (44 + 2 * 88 + 2 * 28 + 20) + MATCH_PAIRS * 32 + 4) / 4)

typedef struct plane_match_body {
  gjk_body_id id;
  gjk2_vec step;
  gjk2_rotation turn;
} plane_match_body;

typedef struct plane_match {
  uint32_t tick;
  plane_match_body bodies[MATCH_BODIES];
  uint32_t block[MATCH_WORDS];
} plane_match;

// One player's input in a tick, bits: 1, 2 move along x, y; 8 makes that a move back; 16 turns; 32 changes a shape; 64
// removes or adds a body; 128 puts one to sleep or wakes it.
typedef uint8_t plane_match_input;

// False: a call had a status that it must not have.
bool plane_match_start(plane_match *m);
bool plane_match_tick(plane_match *m, plane_match_input first, plane_match_input second);

// A hash of the scene and of all that the game keeps besides. 0: it failed.
uint64_t plane_match_hash(plane_match *m);

// Attaches to the scene of a match. It must be done anew for every copy, as the block is in the match.
bool plane_match_scene(plane_match *m, gjk2_scene *out);

#endif
