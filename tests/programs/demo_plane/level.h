// A level for two players: hills, platforms, a rock, and things to push. It is all one state: the same inputs give the
// same level, tick for tick, on every machine.
#ifndef LEVEL_H
#define LEVEL_H

#include "flat_solver.h"

#define LEVEL_WIDTH 32
#define LEVEL_HEIGHT 8
#define LEVEL_PLAYERS 2

// The keys of a player's input.
#define LEVEL_LEFT 1u
#define LEVEL_RIGHT 2u
#define LEVEL_JUMP 4u

// Starts anew. The players are the first bodies.
void level_start(flat_world *w);

void level_tick(flat_world *w, const uint8_t keys[LEVEL_PLAYERS]);

// A hash of the poses and velocities of all bodies.
uint64_t level_hash(const flat_world *w);

#endif
