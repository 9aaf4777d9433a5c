// Fewer points around a mesh's.
#include "simplify.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gjk/hull.h"
#include "memory.h"

bool simplify(mesh_file *file, mesh *m, int most, uint32_t *excess) {
  const size_t bytes = GJK_HULL_SIMPLIFY_WORKSPACE(m->points);
  void *workspace = solid_allocate(bytes, 1);
  gjk_vec3 *vertex = solid_allocate((size_t)most, sizeof vertex[0]);
  gjk_hull_simple simple = {0, 0};
  const gjk_status status =
      gjk_hull_simplify(m->point, (uint16_t)m->points, (uint16_t)most, workspace, bytes, vertex, &simple);
  if (status == GJK_OK) {  // no more vertices than points
    memcpy(m->point, vertex, simple.vertices * sizeof vertex[0]);
    m->points = simple.vertices;
    *excess = simple.excess;
  } else {
    fprintf(stderr, "%s: no room for so few vertices within 8190 units\n", file->name);
  }
  free(vertex);
  free(workspace);
  return status == GJK_OK;
}
