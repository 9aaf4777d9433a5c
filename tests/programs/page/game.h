// The platform game of tests/programs/examples, and its drawing.
#ifndef PAGE_GAME_H
#define PAGE_GAME_H

#include <stdint.h>

// Starts the game anew. 1, or 0 if a call failed.
int page_game_start(void);

// The runner jumps at the next tick, if it stands.
void page_game_jump(void);

// Goes on by one tick. 1, or 0 if a call failed.
int page_game_tick(void);

// The hash of the scene and of the runner's place.
uint64_t page_game_hash(void);

// Draws ground, bodies and runner. Returns how many records are in page_game_records. What has no room there is left out.
uint32_t page_game_look(void);

// Of each line its gjk_draw_role, or 100 for the runner and 101 for ground; then x and y of both ends, Q16.16. Stays until
// the next look.
const int32_t *page_game_records(void);

#endif
