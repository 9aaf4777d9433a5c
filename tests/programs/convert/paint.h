// Draws convex parts as SVG: a parallel projection, shaded faces, a colour for each part.
#ifndef PAINT_H
#define PAINT_H

#include <stdio.h>

#include "decompose.h"

// Where the middle of the solid's box goes on the page, pixels per LSB, and by how much of their distance from the
// middle parts are moved apart.
typedef struct paint_view {
  double x, y, scale, apart;
} paint_view;

#define PAINT_INK "#1d2733"
#define PAINT_FAINT "#5b6673"

void paint_open(FILE *out, int width, int height);
bool paint_close(FILE *out);

// From a point in LSB, counted from the solid's origin, to the page. depth: greater nearer to the eye.
void paint_project(const paint_view *v, const solid *s, const double x[3], double page[2], double *depth);

void paint_parts(FILE *out, const paint_view *v, const solid *s, const decomposition *d);

// A convex part in one colour, '#rrggbb', of some opacity; moved by shift LSB.
void paint_part(FILE *out, const paint_view *v, const solid *s, const part *p, const double shift[3],
                const double colour[3], double opacity);

#endif
