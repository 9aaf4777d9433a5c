// A world that is also saved, restored and carried to other memory, and checked at every update.
#ifndef SESSION_H
#define SESSION_H

#include "world.h"

typedef struct session {
  world now, saved;
  void *save;  // the block as it was saved, sealed or not
  size_t bytes;
  unsigned long updates, restores, begun;
} session;

// An empty world, which is also the one that is saved. False: out of memory, or the scene could not be made. s:
// zeroed, or ended; the counts go on.
bool session_start(session *s, const world_options *options);
void session_end(session *s);

// Random options.
world_options session_options(random_state *random);

// An update, in random slices: false when its reports are not the expected ones, or the scene does not pass its check.
bool session_update(session *s, random_state *random);

void session_keep(session *s);

// Goes on in another block: a copy of this one, or of the one that was kept. False: it could not be opened.
bool session_move(session *s, bool back);

#endif
