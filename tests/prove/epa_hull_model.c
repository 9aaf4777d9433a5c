// Stands in for src/depth/gjk_epa_hull.c under the queries: any answers, with cells that hold any vertices, and faces
// that name some of these.
#include "simplex_any.h"
#include "src/depth/gjk_epa_hull.h"

#define VERTICES 4
#define FACES 4

static void any_cells(gjk_epa_hull *p) {
  for (uint16_t i = 0; i < VERTICES; i++) {
    gjk_epa_cell *cell = &p->cells[i * p->stride];
    cell->vertex.w = any_vec3(ANY_W);
    cell->vertex.a = any_uint16();
    cell->vertex.b = any_uint16();
  }
  for (uint16_t i = 0; i < FACES; i++) {
    gjk_epa_face *face = gjk_epa_hull_face(p, i);
    for (int k = 0; k < 3; k++) {
      face->corner[k] = (uint16_t)(p->stride * any_between(0, VERTICES - 1));
    }
    face->height_key = (uint32_t)any_int32();
  }
}

bool gjk_epa_hull_start(gjk_epa_hull *p, const gjk_workspace *workspace, const gjk_simplex *tetrahedron, bool curved) {
  static gjk_epa_cell cells[2 * VERTICES + FACES];
  for (int i = 0; i < 4; i++) {
    check_vertex(&tetrahedron->slot[tetrahedron->order[i]]);
  }
  p->cells = cells;
  p->count = 2 * VERTICES + FACES;
  p->last = &cells[p->count - 1];
  p->stride = curved ? 2 : 1;
  p->used = (uint16_t)(VERTICES * p->stride);
  p->faces = FACES;
  any_cells(p);
  return any_bool();
}

uint16_t gjk_epa_hull_lowest(const gjk_epa_hull *p) {
  return (uint16_t)any_between(0, p->faces - 1);
}

void gjk_epa_hull_load(const gjk_epa_hull *p, uint16_t vertex, gjk_vertex *out) {
  //@ assert vertex < p->used;
  any_vertex(out);
}

void gjk_epa_hull_normal(const gjk_epa_hull *p, const uint16_t corner[3], gjk_long3 *n) {
  for (int i = 0; i < 3; i++) {
    check_size(corner[i], p->used - 1);
  }
  any_normal(n);
}

void gjk_epa_hull_plane(const gjk_epa_hull *p, uint16_t face, gjk_long3 *normal, gjk_search_direction *direction) {
  //@ assert face < p->faces;
  any_normal(normal);
  direction->d = any_direction(3);
  direction->exact = any_bool();
}

bool gjk_epa_hull_add(gjk_epa_hull *p, uint16_t face, const gjk_vertex *vertex) {
  //@ assert face < p->faces;
  check_vertex(vertex);
  any_cells(p);
  return any_bool();
}
