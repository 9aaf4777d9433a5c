// The expanding polytope: a convex hull of vertices of A - B around the origin, with exact visibility, in the caller's
// cells. Vertices grow from the first cell on, faces from the last one down; what lies between holds the horizon while a
// vertex is added.
#ifndef GJK_SRC_POLYTOPE_H
#define GJK_SRC_POLYTOPE_H

#include "facet.h"
#include "gjk/penetration.h"

typedef struct gjk_polytope {
  gjk_cell *cells;
  uint32_t count;  // of cells
  uint16_t vertices, faces;
  uint8_t stride;  // cells per vertex: 2 with its offset in A's frame, for shapes without vertex numbers
} gjk_polytope;

// The rank of settled and of unused faces.
#define GJK_RANK_SETTLED (GJK_RANK_MAX + 1)

// Starts from the four vertices of a tetrahedron with the origin in it. False: too few cells.
bool gjk_polytope_start(gjk_polytope *p, const gjk_workspace *workspace, const gjk_simplex *tetrahedron, bool curved);

// The lowest face; if all are settled, any.
uint16_t gjk_polytope_lowest(const gjk_polytope *p);

static inline struct gjk_cell_face *gjk_polytope_face(const gjk_polytope *p, uint16_t face) {
  return &p->cells[p->count - 1 - face].face;
}

static inline const gjk_vec3 *gjk_polytope_vertex(const gjk_polytope *p, uint16_t vertex) {
  return &p->cells[(uint32_t)vertex * p->stride].vertex.w;
}

// Fills in a vertex; its offset only when the stride is 2.
void gjk_polytope_load(const gjk_polytope *p, uint16_t vertex, gjk_vertex *out);

// The outward normal, at most 2^62 in size.
void gjk_polytope_normal(const gjk_polytope *p, const uint16_t corner[3], gjk_long3 *n);

// Adds a vertex that lies strictly beyond face; whatever faces it sees make way. False: too few cells, and the faces
// must not be used any more.
bool gjk_polytope_add(gjk_polytope *p, uint16_t face, const gjk_vertex *vertex);

#endif
