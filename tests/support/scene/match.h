// A small lockstep game: two players' inputs and nothing else decide it. The same on every target, no libc.
//
// What touches bounces, so every report acts on all that follows. A match is one plain value: copy it to save it.
#ifndef MATCH_H
#define MATCH_H

#include "gjk/gjk.h"
#include "gjk/scene.h"

#define MATCH_BODIES 24
#define MATCH_PAIRS 160
#define MATCH_WORDS ((276 + MATCH_BODIES * (60 + 2 * 144 + 2 * 40 + 32) + MATCH_PAIRS * 48 + 4) / 4)

typedef struct match_body {
  gjk_body_id handle;
  gjk_vec3 step;
  gjk_quat turn;
} match_body;

typedef struct match {
  uint32_t tick;
  match_body bodies[MATCH_BODIES];
  uint32_t block[MATCH_WORDS];
} match;

// Both of the players' bits: move by x, y or z (1, 2, 4; with 8: back), 16 turn, 32 change a shape, 64 remove or add a
// body, 128 stop or wake one.
typedef uint8_t match_input;

// False: something that must not happen did.
bool match_start(match *m);
bool match_tick(match *m, match_input first, match_input second);

// The hash of the scene, and of what the game keeps besides. 0: failed.
uint64_t match_hash(match *m);

// The scene of a match, wherever that is now.
bool match_scene(match *m, gjk_scene *out);

#endif
