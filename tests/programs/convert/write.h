// What gjk-convert writes to standard output.
#ifndef WRITE_H
#define WRITE_H

#include <stdbool.h>
#include <stddef.h>

#include "gjk/hull.h"

// A C identifier of a name. file: of a file's name, without folders and ending.
void write_name(char *out, size_t room, const char *name, bool file);

// A line: points=N vertices=V faces=F volume6=K watertight=yes|no.
void write_info(const gjk_hull *hull, size_t points, bool watertight);

// Does gjk_collider_init take a hull of these vertices? False: a message is written.
bool write_fits(const gjk_vec3 *vertex, unsigned count);

// Constants for flash: vertices, faces and a shape; level: of its table, -1: none. False: the hull is too wide, has more
// corners than gjk_hull_faces holds, or its table more numbers than 65535; a message is written.
bool write_source(const gjk_hull *hull, const char *name, int level);

// A case for gjk-query: the hull, and once more beside itself. False: it is too wide; a message is written.
bool write_case(const gjk_hull *hull, const char *name);

#endif
