// One side of a match on the level: it exchanges inputs, and compares hashes each tick, without libc.
//
// The sides exchange lines; numbers are in base 16:
//         i TICK KEYS   this side's input
//         h TICK HASH   what this side's level is after the tick
#ifndef PLAY_H
#define PLAY_H

#include "level.h"

typedef struct play_link {
  void (*write)(const char *text);
  int (*read)(void);  // the next character; negative: none will come
} play_link;

// A player holds keys for so many ticks.
typedef struct play_run {
  uint16_t ticks;
  uint8_t keys;
} play_run;

typedef struct play_options {
  unsigned player;
  uint32_t ticks;
  const play_run *run;  // this player's input; after the last run it holds no key
  unsigned runs;
  void (*after)(const flat_world *w, uint32_t tick);  // called after each tick; NULL: none
} play_options;

typedef enum play_result {
  PLAY_SAME,
  PLAY_DIFFERENT,
  PLAY_BROKEN  // the other side is gone, or talks nonsense
} play_result;

// Plays. *ticks: after how many ticks it ended.
play_result play_match(const play_options *options, const play_link *link, flat_world *w, uint32_t *ticks);

#endif
