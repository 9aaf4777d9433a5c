// gjk2_polygon_order on any points, up to CASE of them, into a list of its own or in place; null pointers too.
#include "plane_any.h"

int main(void) {
  gjk2_vec points[CASE], ordered[CASE];
  uint16_t count;
  for (int i = 0; i < CASE; i++) {
    points[i] = any_position2();
  }
  const uint16_t given = (uint16_t)any_between(0, CASE);
  (void)gjk2_polygon_order(any_bool() ? points : NULL, given, any_bool() ? ordered : NULL, any_bool() ? &count : NULL);
  if (gjk2_polygon_order(points, given, points, &count) == GJK_OK) {
    check_within(count, CASE);
  }
  return 0;
}
