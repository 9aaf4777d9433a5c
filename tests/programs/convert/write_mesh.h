// What gjk-convert writes of surfaces.
#ifndef WRITE_MESH_H
#define WRITE_MESH_H

#include "gjk/mesh.h"
#include "mesh.h"

// A surface for gjk/mesh.h, in memory of its own.
typedef struct built_mesh {
  gjk_mesh mesh;
  gjk_mesh_triangle *triangles;
  gjk_mesh_node *nodes;
  gjk_mesh_report report;  // what gjk_mesh_check says of it
} built_mesh;

// Builds the surface. Pre: m is welded, and outlives it. False: the problem says why; there is nothing to free then.
bool built_mesh_of(built_mesh *s, const mesh *m, bool two_sided, char *problem, size_t room);

void built_mesh_free(built_mesh *s);

// A line: triangles=T vertices=V convex=A flat=B concave=C open=D fault=F watertight=yes|no.
void write_mesh_info(const built_mesh *s, bool watertight);

// Constants for flash: vertices, triangles, nodes and the mesh.
void write_mesh_source(const built_mesh *s, const char *name);

// What a gjk_mesh_fault is, in a few words.
const char *built_mesh_fault(unsigned fault);

#endif
