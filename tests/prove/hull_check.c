// gjk_hull_check on any vertices (4), corners of any number, null pointers too. CASE 0: up to two faces with each pair of
// ends that lie in a list of 7 corners. CASE n: of 12 corners, n faces of 3, and one more of 5, or to the end of the list.
#include "any.h"
#include "gjk/hull.h"

#define VERTICES 4
#if CASE == 0
#define CORNERS 7
#else
#define CORNERS 12
#endif

static void ask(const uint16_t end[], uint16_t count) {
  gjk_vec3 vertices[VERTICES];
  uint16_t corner[CORNERS];
  gjk_hull_report report;
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position();
  }
  for (int i = 0; i < CORNERS; i++) {
    corner[i] = any_uint16();
  }
  const gjk_hull_faces faces = {any_bool() ? corner : NULL, any_bool() ? end : NULL, count};
  const int status = gjk_hull_check(any_bool() ? vertices : NULL, (uint16_t)any_between(0, VERTICES),
                                    any_bool() ? &faces : NULL, any_bool() ? &report : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert report.fault <= GJK_HULL_LAYERS;
    //@ assert \initialized(&report.face) && \initialized(&report.corner) && \initialized(&report.vertex);
  }
}

int main(void) {
  uint16_t end[4];
#if CASE == 0
  for (uint16_t i = 0; i <= CORNERS; i++) {
    for (uint16_t k = 0; k <= CORNERS; k++) {
      end[0] = i;
      end[1] = k;
      ask(end, 2);
    }
    ask(end, 1);
  }
  ask(end, 0);
#else
  for (int i = 0; i < 4; i++) {
    end[i] = (uint16_t)(i < CASE ? 3 * i + 3 : CASE * 3 + 5 < CORNERS ? CASE * 3 + 5 : CORNERS);
  }
  ask(end, CASE < 4 ? CASE + 1 : 4);
#endif
  return 0;
}
