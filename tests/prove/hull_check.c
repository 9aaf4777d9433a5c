// gjk_hull_check on any vertices (4), corners of any number, null pointers too. CASE 0: up to two faces whose ends are any
// that lie in the list of 8 corners. CASE n: of 12 corners, n faces of 3, and one more of 5, or to the end of the list.
#include "any.h"
#include "gjk/hull.h"

#define VERTICES 4
#if CASE == 0
#define CORNERS 8
#else
#define CORNERS 12
#endif

int main(void) {
  static gjk_vec3 vertices[VERTICES];
  static uint16_t corner[CORNERS], end[4];
  gjk_hull_report report;
  uint16_t count;
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position();
  }
  for (int i = 0; i < CORNERS; i++) {
    corner[i] = any_uint16();
  }
#if CASE == 0
  for (int i = 0; i < 2; i++) {
    end[i] = (uint16_t)any_between(0, CORNERS);
  }
  count = (uint16_t)any_between(0, 2);
#else
  for (int i = 0; i < 4; i++) {
    end[i] = (uint16_t)(i < CASE ? 3 * i + 3 : CASE * 3 + 5 < CORNERS ? CASE * 3 + 5 : CORNERS);
  }
  count = CASE < 4 ? CASE + 1 : 4;
#endif
  const gjk_hull_faces faces = {any_bool() ? corner : NULL, any_bool() ? end : NULL, count};
  const int status = gjk_hull_check(any_bool() ? vertices : NULL, (uint16_t)any_between(0, VERTICES),
                                    any_bool() ? &faces : NULL, any_bool() ? &report : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert report.fault <= GJK_HULL_LAYERS;
    //@ assert \initialized(&report.face) && \initialized(&report.corner) && \initialized(&report.vertex);
  }
  return 0;
}
