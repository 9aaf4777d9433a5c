// The hull of EPA: a closed convex polytope of vertices of A - B around the origin, with triangles for faces. It lives
// in the cells of the caller's workspace: vertices from the first cell on, faces from the last one down. The cells
// between them hold the horizon while a vertex is added. A vertex's number is that of its first cell.
#ifndef GJK_SRC_EPA_HULL_H
#define GJK_SRC_EPA_HULL_H

#include "gjk/penetration.h"
#include "gjk_facet.h"

// The plane of a face: its outward normal, at most 2^62 in size, exact and rounded.
typedef struct gjk_epa_plane {
  gjk_long3 normal;
  gjk_search_direction direction;
} gjk_epa_plane;

// Where memory is plentiful, the planes of this many faces are kept. Those of other faces are computed again.
#if GJK_64_BIT
#define GJK_EPA_PLANES 64
#else
#define GJK_EPA_PLANES 0
#endif

typedef struct gjk_epa_hull {
  gjk_epa_cell *cells, *last;
  uint32_t count;  // of cells
  uint16_t used;   // cells of vertices
  uint16_t faces;
  uint8_t stride;  // cells per vertex: 1; of a curved pair 2, the second with the offset of A's point
#if GJK_EPA_PLANES
  gjk_epa_plane plane[GJK_EPA_PLANES];
#endif
} gjk_epa_hull;

// The height key of a face that is settled, or left inside the hull.
#define GJK_HEIGHT_KEY_SETTLED (GJK_HEIGHT_KEY_MAX + 1)

// Starts from a tetrahedron that holds the origin; its fourth vertex lies beyond the others along their normal. False:
// too few cells.
bool gjk_epa_hull_start(gjk_epa_hull *p, const gjk_workspace *workspace, const gjk_simplex *tetrahedron, bool curved);

// The face with the lowest height key; if all are settled, any.
uint16_t gjk_epa_hull_lowest(const gjk_epa_hull *p);

static inline gjk_epa_face *gjk_epa_hull_face(const gjk_epa_hull *p, uint16_t face) {
  return &(p->last - face)->face;
}

static inline const gjk_vec3 *gjk_epa_hull_vertex(const gjk_epa_hull *p, uint16_t vertex) {
  return &p->cells[vertex].vertex.w;
}

// Fills in a vertex; a.offset only when the stride is 2.
void gjk_epa_hull_load(const gjk_epa_hull *p, uint16_t vertex, gjk_vertex *out);

// The outward normal of a face with these corners, at most 2^62 in size.
void gjk_epa_hull_normal(const gjk_epa_hull *p, const uint16_t corner[3], gjk_long3 *n);

// The plane of a face.
void gjk_epa_hull_plane(const gjk_epa_hull *p, uint16_t face, gjk_long3 *normal, gjk_search_direction *direction);

// Adds a vertex that lies strictly beyond face, in place of all faces that it sees. False: too few cells; height keys
// are not valid then.
bool gjk_epa_hull_add(gjk_epa_hull *p, uint16_t face, const gjk_vertex *vertex);

#endif
