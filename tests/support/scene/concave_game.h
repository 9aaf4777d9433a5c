// Games of scenes with concave bodies for tests: what is done to one scene in a tick is written down as moves, so that
// others can do the same, in other memory.
#ifndef CONCAVE_GAME_H
#define CONCAVE_GAME_H

#include "scene/concave_world.h"

#define GAME_BODIES 14
#define GAME_SCENES 4
#define GAME_REPORTS 600
#define GAME_MOVES 24

// Shapes: three concave ones of a concave_world, its movers, and those of concave_game.c.
#define GAME_TIES 5
#define GAME_SOLIDS 5
#define GAME_SHAPES (CONCAVE_BODIES + CONCAVE_MOVERS + GAME_TIES + GAME_SOLIDS)

typedef enum game_what {
  GAME_MOVE,
  GAME_TELEPORT,
  GAME_REMOVE,
  GAME_ADD,
  GAME_SHAPE,
  GAME_FILTER,
  GAME_SLEEP,
  GAME_WAKE,
  GAME_MOTION
} game_what;

// One thing that is done to a body. Of ADD: setup and part.
typedef struct game_move {
  game_what what;
  uint32_t slot;
  gjk_pose pose;
  uint16_t part, shape;
  uint32_t category;
  uint8_t motion;
  bool starts;    // the body's way starts anew,
  gjk_pose from;  // there
  gjk_body_setup setup;
  gjk_part parts[2];
} game_move;

// A scene, and what the test knows of it.
typedef struct game_scene {
  gjk_scene scene;
  gjk_body_id id[GAME_BODIES];  // generation 0: none
  uint32_t *block;
  size_t bytes;
  gjk_report report[GAME_REPORTS];
  gjk_manifold manifold[GAME_REPORTS];
  uint32_t reports;
} game_scene;

// What is in a slot, the same in every scene.
typedef struct game_body {
  bool there;
  gjk_body_setup setup;  // its pose is the present one
  gjk_part parts[2];
  bool asleep;
  uint8_t motion;
} game_body;

typedef struct game {
  concave_world world;
  int32_t size;             // of shapes, LSB
  gjk_vec3 middle;          // about which the bodies are
  bool lattice;             // places and rotations of ties
  uint8_t detail;           // of the configuration
  gjk_workspace workspace;  // of 0 cells or more
  const gjk_shape *shapes[GAME_SHAPES];
  game_body body[GAME_BODIES];
  game_move move[GAME_MOVES];
  unsigned moves;
} game;

// Makes the shapes of a game.
void game_make(game *m, random_state *random);
void game_free(game *m);

// Is a shape of the table concave, or a convex one without vertices?
bool game_is_concave(unsigned shape);
bool game_is_curved(unsigned shape);

// May two bodies be a pair, by kinds and filters?
bool game_may_meet(const game *m, uint32_t a, uint32_t b);

// A configuration: room for so many pairs, and for so many more bodies than there are.
gjk_scene_config game_config(const game *m, uint32_t pairs, uint32_t more, uint8_t retest, gjk_q16 box_margin);

// Makes a scene with that configuration in memory of its own, and its end.
gjk_status game_start(const game *m, const gjk_scene_config *config, game_scene *s);
void game_end(game_scene *s);

// Draws the moves of a tick, and makes them in the bodies of m. first: adds bodies alone.
void game_draw(game *m, random_state *random, bool first);

// Does the moves in a scene. Adds come in either order.
void game_play(const game *m, game_scene *s);

// Adds all bodies as they are now, and keeps their motions.
void game_rebuild(const game *m, game_scene *s);

// Updates: tests so many pairs in a call, and takes so many reports.
gjk_status game_update(game_scene *s, uint32_t tests, uint32_t room);

#endif
