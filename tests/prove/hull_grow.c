// src/hull/gjk_hull_grow.h from a tetrahedron, CASE points of any coordinates in all: the parts of the workspace, and the
// triangles that are left. The points' numbers mean nothing here, so the tetrahedron is that of the first four.
#include "hull_any.h"

int main(void) {
  static const uint16_t corner[4] = {0, 1, 2, 3};
  static gjk_vec3 points[CASE];
  static uint32_t workspace[GJK_HULL_WORKSPACE(CASE) / sizeof(uint32_t)];
  gjk_hull_work w = gjk_hull_work_of(points, workspace, CASE);
  any_points(points, CASE);
  for (uint16_t i = 0; i < CASE; i++) {
    w.order[i] = i;
    w.next[i] = any_uint16();
    w.of[i] = (uint32_t)any_int32();
  }
  (void)gjk_hull_fits(points, CASE);
  gjk_hull_grow(&w, corner);
  //@ assert w.triangles >= 4 && w.triangles <= 2 * CASE - 4;
  for (uint32_t i = 0; i < w.triangles; i++) {
    if ((w.triangle[i].flags & GJK_HULL_SEEN) == 0) {
      check_triangle(&w.triangle[i], CASE, w.triangles);
    }
  }
  return 0;
}
