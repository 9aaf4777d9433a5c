// Fewer points around a mesh's.
#ifndef SIMPLIFY_H
#define SIMPLIFY_H

#include "mesh.h"

// Puts at most so many vertices around the points, in their place. *excess: how far they reach. False: a message is
// written.
bool simplify(mesh_file *file, mesh *m, int most, uint32_t *excess);

#endif
