// Points and triangles as files have them, in LSB.
#ifndef MESH_H
#define MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "gjk/format.h"

// Corners are numbers of points. Faces of more corners are cut into triangles (polygon.h).
typedef struct mesh {
  gjk_vec3 *point;
  uint32_t (*triangle)[3];
  uint32_t *face;  // which face of the file each triangle is of, counted from 1; NULL: of no file
  size_t points, triangles, faces, point_room, triangle_room;
  double most_rounding;  // the most that a coordinate moved when it was rounded, LSB
} mesh;

// What one number of a file is worth, and where a message says it went wrong.
typedef struct mesh_file {
  const char *name, *text;
  size_t bytes;
  double scale;        // LSB per number
  unsigned long line;  // 0: not of a line
  char problem[160];   // empty: none
  double (*place)[4];  // of a point x, y, z: rows of a x + b y + c z + d, in the file's unit; NULL: it stays
} mesh_file;

void mesh_free(mesh *m);

// Notes the first problem, as printf does. Returns false.
bool mesh_fail(mesh_file *file, const char *format, ...);

// Adds to the problem noted what it is in, counted from 0. Returns false.
bool mesh_fail_at(mesh_file *file, const char *what, long number);

// Adds a point, rounded to the nearest LSB. False: beyond int32, or not a number.
bool mesh_add_point(mesh *m, mesh_file *file, const double xyz[3]);

// Adds a polygon's triangles. False: a corner is no point so far, or there are less than 3.
bool mesh_add_polygon(mesh *m, mesh_file *file, const int64_t *corner, size_t corners);

// Makes points at one place one point. Triangles that lose their area by that are left out.
void mesh_weld(mesh *m);

// Has each edge of the triangles exactly one opposite? No triangles: no. Pre: welded.
bool mesh_is_watertight(const mesh *m);

// Reads a file by the end of its name: .obj, .stl, .ply, .off, or points, three integers a line, each one LSB.
bool mesh_read(mesh *m, mesh_file *file);

#endif
