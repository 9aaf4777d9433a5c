// Writes an answered scene as a C file for demo_scene.h.
#ifndef SOURCE_H
#define SOURCE_H

#include "scene.h"

// False, with a message on standard error, if a hull is too large for the tables.
bool source_write(FILE *file, const scene *s);

#endif
