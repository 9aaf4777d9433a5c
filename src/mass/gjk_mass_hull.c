// The mass properties of a hull of points, from the triangles that the builder has left in its workspace.
#include "../hull/gjk_hull_facets.h"
#include "gjk_moments.h"

// In a plane: triangles from the outline's first corner. w->of holds the numbers of its corners in their order, w->next
// each point's number. There are no triangles then, so their places keep which point has a number.
static void add_outline(gjk_hull_work *w, uint32_t corners, gjk_moments *m) {
  for (uint32_t point = 0; point < w->distinct; point++) {
    if (w->next[point] != GJK_HULL_NO_POINT) {
      w->triangle[w->next[point]].vertex[0] = (uint16_t)point;
    }
  }
  const gjk_vec3 *corner[3];
  unsigned axis = 3;
  for (uint32_t i = 1; i + 1 < corners; i++) {
    corner[0] = gjk_hull_point(w, w->triangle[w->of[0]].vertex[0]);
    corner[1] = gjk_hull_point(w, w->triangle[w->of[i]].vertex[0]);
    corner[2] = gjk_hull_point(w, w->triangle[w->of[i + 1]].vertex[0]);
    axis = axis < 3 ? axis : gjk_longest_axis(corner[0], corner[1], corner[2]);
    gjk_moments_add_flat(m, axis, corner);  // corners of an outline are not in line
  }
}

static void add_triangles(const gjk_hull_work *w, gjk_moments *m) {
  for (uint32_t at = 0; at < w->triangles; at++) {
    const gjk_hull_triangle *t = &w->triangle[at];
    if ((t->flags & GJK_HULL_SEEN) == 0) {
      const gjk_vec3 *corner[3];
      for (int i = 0; i < 3; i++) {
        corner[i] = gjk_hull_point(w, t->vertex[i]);
      }
      (void)gjk_moments_add_tetrahedron(m, corner);  // no vertex is above a triangle
    }
  }
}

gjk_status gjk_mass_of_hull(const gjk_hull *hull, gjk_mass *out) {
  if (hull == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_hull_work w;
  gjk_hull_work_of_hull(hull, &w);
  if (hull->dimension < 2) {
    gjk_moments_of_segment(gjk_hull_point(&w, 0), gjk_hull_point(&w, w.distinct - 1), out);
    return GJK_OK;
  }
  gjk_moments m;
  gjk_moments_start(&m, gjk_hull_point(&w, 0));
  if (hull->dimension == 3) {
    add_triangles(&w, &m);
  } else {
    add_outline(&w, hull->vertices, &m);
  }
  gjk_moments_finish(&m, hull->dimension + 1u, out);
  return GJK_OK;
}
