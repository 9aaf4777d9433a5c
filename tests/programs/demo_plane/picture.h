// The picture of a match: the level, where bodies began, their paths, and the end.
#ifndef PICTURE_H
#define PICTURE_H

#include <stdio.h>

#include "level.h"

// Notes where the bodies are.
void picture_note(const flat_world *w, uint32_t tick);

// Draws the end, and what was noted. ticks: of the match; hash: of its end.
void picture_draw(FILE *file, const flat_world *w, uint32_t ticks, uint64_t hash);

#endif
