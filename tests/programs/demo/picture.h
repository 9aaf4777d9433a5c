// Writes an answered scene as an SVG picture: the bodies, the gaps between them, and the list of pairs.
#ifndef PICTURE_H
#define PICTURE_H

#include "swing.h"

// Text of a gap in millimetres, a unit being a metre.
void picture_gap_text(char text[24], gjk_q16 gap);

// swing: drawn where something is found.
void picture_write(FILE *file, const scene *s, const scene_swing *swing, const char *title);

#endif
