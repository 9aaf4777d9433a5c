// The expanding polytope: a convex hull of vertices of A - B around the origin, with exact visibility, in the caller's
// cells. Vertices grow from the first cell on, faces from the last one down; what lies between holds the horizon while
// a vertex is added.
#ifndef GJK_SRC_EPA_HULL_H
#define GJK_SRC_EPA_HULL_H

#include "gjk/penetration.h"
#include "gjk_facet.h"

typedef struct gjk_epa_hull {
  gjk_epa_cell *cells;
  uint32_t count;  // of cells
  uint16_t vertices, faces;
  uint8_t stride;  // cells per vertex: 2 with its offset in A's frame, for shapes without vertex numbers
} gjk_epa_hull;

// The height key of settled and of unused faces.
#define GJK_HEIGHT_KEY_SETTLED (GJK_HEIGHT_KEY_MAX + 1)

// Starts from the four vertices of a tetrahedron with the origin in it. False: too few cells.
bool gjk_epa_hull_start(gjk_epa_hull *p, const gjk_workspace *workspace, const gjk_simplex *tetrahedron, bool curved);

// The lowest face; if all are settled, any.
uint16_t gjk_epa_hull_lowest(const gjk_epa_hull *p);

static inline gjk_epa_face *gjk_epa_hull_face(const gjk_epa_hull *p, uint16_t face) {
  return &p->cells[p->count - 1 - face].face;
}

static inline const gjk_vec3 *gjk_epa_hull_vertex(const gjk_epa_hull *p, uint16_t vertex) {
  return &p->cells[(uint32_t)vertex * p->stride].vertex.w;
}

// Fills in a vertex; its offset only when the stride is 2.
void gjk_epa_hull_load(const gjk_epa_hull *p, uint16_t vertex, gjk_vertex *out);

// The outward normal, at most 2^62 in size.
void gjk_epa_hull_normal(const gjk_epa_hull *p, const uint16_t corner[3], gjk_long3 *n);

// Adds a vertex that lies strictly beyond face; whatever faces it sees make way. False: too few cells, and the faces
// must not be used any more.
bool gjk_epa_hull_add(gjk_epa_hull *p, uint16_t face, const gjk_vertex *vertex);

#endif
