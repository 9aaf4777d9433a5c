// src/hull/gjk_hull_facets.h and what src/hull/gjk_hull_write.c writes, on any triangles that there may be: CASE is the
// dimension of the points. Room for any number of corners up to 40, of faces up to 16.
#include "hull_any.h"

static gjk_vec3 points[ANY_POINTS];
static uint32_t workspace[GJK_HULL_WORKSPACE(ANY_POINTS) / sizeof(uint32_t)];

static void write(const gjk_hull *hull) {
  gjk_vec3 vertices[ANY_POINTS];
  uint16_t corner[40], end[16];
  gjk_hull_faces faces;
  gjk_hull_volume volume;
  (void)gjk_hull_vertices(hull, any_bool() ? vertices : NULL, (uint16_t)any_between(0, ANY_POINTS));
  (void)gjk_hull_write_faces(hull, any_bool() ? corner : NULL, (uint16_t)any_between(0, 40), any_bool() ? end : NULL,
                             (uint16_t)any_between(0, 16), any_bool() ? &faces : NULL);
  (void)gjk_hull_get_volume(hull, any_bool() ? &volume : NULL);
}

int main(void) {
  gjk_hull_work w = gjk_hull_work_of(points, workspace, ANY_POINTS);
  gjk_hull hull = {0};
  const uint32_t distinct = (uint32_t)any_between(CASE + 1, ANY_POINTS);
  hull.dimension = CASE;
  hull.points = points;
  hull.workspace = workspace;
  hull.count = ANY_POINTS;
  hull.distinct = w.distinct = distinct;
  any_points(points, ANY_POINTS);
  for (int i = 0; i < ANY_POINTS; i++) {
    w.order[i] = any_number(ANY_POINTS);
  }
#if CASE == 3
  hull.triangles = w.triangles = 2 * ANY_POINTS - 4;
  for (int i = 0; i < 2 * ANY_POINTS - 4; i++) {
    any_triangle(&w.triangle[i], distinct, w.triangles);
  }
  gjk_hull_join(&w, &hull);
#else
  hull.vertices = (uint16_t)any_between(CASE + 1, CASE < 2 ? CASE + 1 : ANY_POINTS);
  for (int i = 0; i < ANY_POINTS; i++) {
    w.next[i] = any_bool() ? GJK_HULL_NO_POINT : any_number(hull.vertices);
    w.of[i] = any_number(hull.vertices);
  }
#endif
  write(any_bool() ? &hull : NULL);
  return 0;
}
