// A pile of crates and balls in the plane, on each of two sides that exchange only inputs.
#ifndef PAGE_PILE_H
#define PAGE_PILE_H

#include <stdint.h>

// The trough around the pile, in units: from x = 0 between walls, on a floor at y = 0.
#define PAGE_PILE_WIDTH 14
#define PAGE_PILE_HEIGHT 14

// Starts a side, 0 or 1, with so many bodies, at most 200.
void page_pile_start(int side, unsigned bodies);

// An input: what lies around a place is pushed up and away from it. Q16.16.
void page_pile_push(int side, int32_t x, int32_t y);

// Goes on by one tick, and returns the hash of what then is.
uint64_t page_pile_tick(int side);

// Flips the lowest bit of a body's x.
void page_pile_flip(int side, unsigned body);

// Of each body: 1 for a ball, else 0; its half width and half height; x, y; cosine and sine, Q2.30.
const int32_t *page_pile_bodies(int side);

// A side's whole state, to be copied for a rollback and copied back to the same place.
void *page_pile_state(int side);
uint32_t page_pile_bytes(void);

#endif
