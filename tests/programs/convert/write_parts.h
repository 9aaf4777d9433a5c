// What gjk-convert writes of convex parts.
#ifndef WRITE_PARTS_H
#define WRITE_PARTS_H

#include "decompose.h"

// A line: parts=P excess=E enclosed=yes|no.
void write_parts_info(const decomposition *d);

// Is each part narrow enough for a shape? False: a message is written.
bool write_parts_fit(const decomposition *d);

// Constants for flash: a hull with faces for each part, and an array of them.
void write_parts_source(const solid *s, const decomposition *d, const char *name);

// Cases for gjk-query: each part beside the first one.
void write_parts_case(const solid *s, const decomposition *d, const char *name);

// An SVG of the parts as they are, and moved apart. False: the file cannot be written.
bool write_parts_picture(const solid *s, const decomposition *d, const char *file);

#endif
