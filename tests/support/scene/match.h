// A small lockstep game for tests: the inputs of two players decide all that happens, the same on every target, without
// libc.
//
// Bodies that touch bounce, so one wrong report changes the rest of the match. A match is a plain value: a copy of it
// is a save.
#ifndef MATCH_H
#define MATCH_H

#include "gjk/gjk.h"
#include "gjk/scene.h"

#define MATCH_BODIES 24
#define MATCH_PAIRS 160
#define MATCH_WORDS ((296 + MATCH_BODIES * (60 + 2 * 144 + 2 * 40 + 32) + MATCH_PAIRS * 48 + 4) / 4)

typedef struct match_body {
  gjk_body_id id;
  gjk_vec3 step;
  gjk_quat turn;
} match_body;

typedef struct match {
  uint32_t tick;
  match_body bodies[MATCH_BODIES];
  uint32_t block[MATCH_WORDS];
} match;

// One player's input in a tick, bits: 1, 2, 4 move along x, y, z; 8 makes that a move back; 16 turns; 32 changes a
// shape; 64 removes or adds a body; 128 puts one to sleep or wakes it.
typedef uint8_t match_input;

// False: a call had a status that it must not have.
bool match_start(match *m);
bool match_tick(match *m, match_input first, match_input second);

// A hash of the scene and of all that the game keeps besides. 0: it failed.
uint64_t match_hash(match *m);

// Attaches to the scene of a match. It must be done anew for every copy, as the block is in the match.
bool match_scene(match *m, gjk_scene *out);

#endif
