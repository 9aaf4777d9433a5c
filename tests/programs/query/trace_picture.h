// Draws traces as an SVG picture: a panel for each iteration, the shapes on its left, A - B and the origin on its right.
#ifndef QUERY_TRACE_PICTURE_H
#define QUERY_TRACE_PICTURE_H

#include "trace_body.h"

typedef struct trace_picture {
  FILE *panels;   // what was drawn so far
  double height;  // of it, pixels
} trace_picture;

// False: there is no room for temporary files.
bool trace_picture_open(trace_picture *p);

// Draws the trace of a case. answer: its line of text.
void trace_picture_add(trace_picture *p, const char *answer, const trace *t, const trace_bodies *bodies);

// Writes the picture and closes p. False: the file cannot be written.
bool trace_picture_close(trace_picture *p, const char *name);

#endif
