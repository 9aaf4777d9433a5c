// Triangle meshes for tests: grounds, closed bodies, soups.
#ifndef GENERATE_SURFACE_H
#define GENERATE_SURFACE_H

#include "gjk/mesh.h"
#include "random.h"

typedef enum surface_kind {
  SURFACE_FLAT,   // a grid in a plane, level or tilted
  SURFACE_BENT,   // a grid of gentle waves
  SURFACE_ROUGH,  // a grid of random heights
  SURFACE_CUBE,   // a cube of many triangles, closed
  SURFACE_BALL,   // an octahedron whose faces are cut and moved outwards, closed
  SURFACE_SOUP,   // triangles anywhere, some of them thin, in a line, or repeated
  SURFACE_KINDS
} surface_kind;

extern const char *const surface_names[SURFACE_KINDS];

typedef struct surface {
  surface_kind kind;
  gjk_vec3 *vertices;
  gjk_mesh_triangle *triangles;
  gjk_mesh_node *nodes;
  uint32_t vertex_count, triangle_count, node_count;
  gjk_mesh mesh;
} surface;

// Makes a surface of about so many triangles, of a size along each edge, LSB, and builds its mesh. The arrays are exactly
// as long as the mesh says.
void surface_make(random_state *random, surface_kind kind, uint32_t triangles, int32_t step, bool two_sided,
                  surface *out);

void surface_free(surface *s);

#endif
