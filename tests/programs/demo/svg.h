// Pieces of SVG that every picture needs.
#ifndef SVG_H
#define SVG_H

#include <stddef.h>
#include <stdio.h>

// Pixels of the page, y downwards.
typedef struct point2 {
  double x, y;
} point2;

// The value of a 'points' attribute.
void svg_points(FILE *file, const point2 *point, size_t count);

// Text, with the characters that mean something to XML escaped.
void svg_text(FILE *file, const char *text);

#endif
