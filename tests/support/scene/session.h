// A world (world.h) that is also saved, restored and moved to other memory, and checked at every update.
#ifndef SESSION_H
#define SESSION_H

#include "world.h"

typedef struct session {
  world now, saved;
  void *save;  // the block of saved
  size_t bytes;
  unsigned long updates, restores, begun;
} session;

// Starts an empty world, and saves it. False: out of memory, or the scene could not be made. Pre: s is zeroed or ended;
// its counts go on.
bool session_start(session *s, const world_options *options);
void session_end(session *s);

// Random options.
world_options session_options(random_state *random);

// Updates in random slices. False: the reports are not the expected ones, or gjk_scene_check refuses the scene.
bool session_update(session *s, random_state *random);

// Makes one random change, among them all below. False: it failed. *what: which, for messages.
bool session_change(session *s, random_state *random, uint32_t *what);

// Saves the world.
void session_keep(session *s);

// Goes on in another block: a copy of the present one, or with back, of the saved one. False: it could not be opened.
bool session_move(session *s, bool back);

#endif
