// Proves src/depth/gjk_epa_hull.h on cells of any content. CASE 0 starts from any workspace. CASE 1 and 2 ask and add
// to a hull of any vertices, whose faces name some of these and each other, with one cell and with two for a vertex.
// There is room for up to two cells of the horizon.
#include "src/depth/gjk_epa_hull.h"

#include "facets.h"

#define VERTICES 4
#define FACES 4
#define CELLS (2 * VERTICES + 2 + FACES + 4)

static void any_cells(gjk_epa_hull *p) {
  for (uint16_t i = 0; i < VERTICES; i++) {
    gjk_epa_cell *cell = &p->cells[i * p->stride];
    cell->vertex.w = any_vec3(ANY_W);
    cell->vertex.a = any_uint16();
    cell->vertex.b = any_uint16();
    if (p->stride == 2) {
      cell[1].vertex.w = any_vec3(ANY_OFFSET);
    }
  }
  for (uint16_t i = 0; i < FACES; i++) {
    gjk_epa_face *face = gjk_epa_hull_face(p, i);
    for (int k = 0; k < 3; k++) {
      face->corner[k] = (uint16_t)(p->stride * any_between(0, VERTICES - 1));
      face->neighbour[k] = (uint16_t)any_between(0, FACES - 1);
    }
    face->height_key = (uint32_t)any_int32();
  }
}

// What src/depth/gjk_epa.c reads.
static void check_polytope(const gjk_epa_hull *p, bool curved) {
  const uint16_t lowest = gjk_epa_hull_lowest(p);
  gjk_vertex v;
  gjk_long3 n;
  gjk_search_direction d;
  //@ assert p->used >= 4 && p->faces >= 4;
  //@ assert lowest < p->faces;
  for (uint16_t i = 0; i < p->faces; i++) {
    const gjk_epa_face *face = gjk_epa_hull_face(p, i);
    check_size(face->height_key, UINT32_MAX);
    for (int k = 0; k < 3; k++) {
      //@ assert face->corner[k] < p->used && face->neighbour[k] < p->faces;
    }
    gjk_epa_hull_normal(p, face->corner, &n);
    gjk_epa_hull_plane(p, i, &n, &d);
  }
  for (uint16_t i = 0; i < p->used; i = (uint16_t)(i + p->stride)) {
    gjk_epa_hull_load(p, i, &v);
    check_corner(&v, curved);
  }
}

static void start(bool curved, uint32_t count) {
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {any_bool() ? cells : NULL, count};
  gjk_simplex s;
  gjk_epa_hull p;
  gjk_simplex_clear(&s);
  for (int i = 0; i < 4; i++) {
    any_corner(&s.slot[i], curved);
  }
  s.count = 4;
  if (gjk_epa_hull_start(&p, any_bool() ? &workspace : NULL, &s, curved)) {
    check_polytope(&p, curved);
  }
}

static void add(bool curved, uint32_t count) {
  gjk_epa_cell cells[CELLS];
  const uint8_t stride = curved ? 2 : 1;
  gjk_epa_hull p = {cells, &cells[count - 1], count, (uint16_t)(VERTICES * stride), FACES, stride};
  gjk_vertex v;
  any_cells(&p);
  check_polytope(&p, curved);
  any_corner(&v, curved);
  if (gjk_epa_hull_add(&p, (uint16_t)any_between(0, FACES - 1), &v)) {
    //@ split p.faces;
    check_polytope(&p, curved);
  }
}

int main(void) {
#if CASE == 0
  for (uint32_t count = 0; count <= CELLS; count++) {
    start(false, count);
    start(true, count);
  }
#else
  const uint32_t used = (VERTICES + 1) * CASE + FACES;
  for (uint32_t count = used; count <= used + 4; count++) {
    add(CASE == 2, count);
  }
#endif
  return 0;
}
