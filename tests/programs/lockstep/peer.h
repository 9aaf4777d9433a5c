// One side of a lockstep match. Plays ticks, exchanges inputs and compares hashes, without libc.
//
// The sides exchange lines; numbers are in base 16:
//         i TICK INPUT        this side's input
//         h TICK HASH         what this side's state is after the tick
//         b SLOT FIELD VALUE  after hashes that differ, from player 1: fields of its bodies
//         p A PART B PART D   and its near pairs with their distances
//         e                   end
#ifndef PEER_H
#define PEER_H

#include "scene/match.h"

typedef struct peer_link {
  void (*write)(const char *text);
  int (*read)(void);  // the next character; negative: none will come
} peer_link;

typedef struct peer_options {
  unsigned player;  // 0 judges
  uint32_t ticks;
  uint32_t diverge;  // from this tick on, as soon as a pair has a distance, a body is nudged, once; 0: never
} peer_options;

typedef enum peer_result {
  PEER_SAME,
  PEER_DIFFERENT,
  PEER_BROKEN  // the other side is gone, or talks nonsense
} peer_result;

// say: gets what player 0 tells about the match.
peer_result peer_play(const peer_options *options, const peer_link *link, void (*say)(const char *text));

#endif
