// src/contact/gjk_clip.h with any two polygons: two edges, CASE 0, a face and an edge, 1, an edge and a face, 2, or two
// faces, 3, each of three or the most corners.
#include "src/contact/gjk_clip.h"

#include "candidates.h"
#include "polygons.h"

static void run(int32_t count_a, int32_t count_b) {
  gjk_polygon a, b;
  gjk_candidates candidates;
  const gjk_vec3 centre = any_position();
  any_polygon(&a, count_a);
  any_polygon(&b, count_b);
  gjk_clip(&a, &b, &centre, any_between(0, INT32_MAX), &candidates);
  check_candidates(&candidates);
}

int main(void) {
  static const int32_t corners[] = {3, GJK_FACE_CORNERS_MAX};
#if CASE == 0
  run(2, 2);
#elif CASE == 3
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < 2; k++) {
      run(corners[i], corners[k]);
    }
  }
#else
  for (int i = 0; i < 2; i++) {
    run(CASE == 1 ? corners[i] : 2, CASE == 2 ? corners[i] : 2);
  }
#endif
  return 0;
}
