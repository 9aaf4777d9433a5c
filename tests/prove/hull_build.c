// gjk_hull_build on CASE points of any coordinates, or on none, any number of bytes that the workspace has, null
// pointers too. A workspace's size fits where size_t has 16 bits.
#include "hull_any.h"

int main(void) {
  const uint32_t most = GJK_HULL_WORKSPACE(GJK_HULL_POINTS_MAX);
  //@ assert most == 2621440;
  static gjk_vec3 points[CASE];
  static uint32_t workspace[GJK_HULL_WORKSPACE(CASE) / sizeof(uint32_t)];
  gjk_hull hull;
  any_points(points, CASE);
  const gjk_status status =
      gjk_hull_build(any_bool() ? points : NULL, any_bool() ? CASE : 0, any_bool() ? workspace : NULL,
                     (size_t)any_between(0, (int32_t)sizeof workspace), any_bool() ? &hull : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert hull.dimension <= 3 && hull.distinct >= 1 && hull.distinct <= CASE;
    //@ assert hull.vertices <= hull.distinct;
    //@ assert \initialized(&hull.faces) && \initialized(&hull.edges) && \initialized(&hull.corners);
    //@ assert \initialized(&hull.most_corners) && \initialized(&hull.triangles);
  }
  return 0;
}
