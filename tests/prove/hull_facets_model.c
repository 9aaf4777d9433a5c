// Stands in for src/hull/gjk_hull_facets.c under the builder: any counts.
#include "hull_any.h"

void gjk_hull_join(gjk_hull_work *w, gjk_hull *out) {
  for (uint32_t i = 0; i < w->triangles; i++) {
    if ((w->triangle[i].flags & GJK_HULL_SEEN) == 0) {
      check_triangle(&w->triangle[i], w->distinct, w->triangles);
    }
  }
  out->vertices = (uint16_t)any_between(4, (int32_t)w->distinct);
  out->corners = (uint32_t)any_between(12, 4 * (int32_t)w->distinct);
  out->edges = out->corners / 2;
  out->faces = (uint32_t)any_between(4, 2 * (int32_t)w->distinct);
  out->most_corners = any_uint16();
}
