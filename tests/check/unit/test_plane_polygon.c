// gjk2_polygon_order against monotone chains: duplicates, points in a line, in place, the largest coordinates.
#include "plane.h"

#define SEED 2007
#define TRIALS check_trials(30000)
#define MANY 20000

static void check_order(const gjk2_vec *points, int count) {
  static gjk2_vec out[MANY], within[MANY];
  static plane_point given[MANY], hull[MANY + 2];
  uint16_t n = 0, m = 0;
  for (int i = 0; i < count; i++) {
    within[i] = points[i];
    given[i].x = points[i].x;
    given[i].y = points[i].y;
  }
  CHECK(gjk2_polygon_order(points, (uint16_t)count, out, &n) == GJK_OK);
  CHECK(gjk2_polygon_order(within, (uint16_t)count, within, &m) == GJK_OK);
  const int truth = plane_hull(given, count, hull);
  CHECK_MSG(n == truth && m == truth, "%d and %d corners instead of %d", n, m, truth);
  int start = 0;
  for (int i = 1; i < truth; i++) {
    const bool lower = hull[i].y < hull[start].y || (hull[i].y == hull[start].y && hull[i].x < hull[start].x);
    start = lower ? i : start;
  }
  bool same = true;
  for (int i = 0; i < n && i < truth; i++) {
    const plane_point p = hull[(start + i) % truth];
    same = same && out[i].x == p.x && out[i].y == p.y && within[i].x == p.x && within[i].y == p.y;
  }
  CHECK(same);
}

static void check_statuses(void) {
  gjk2_vec points[4] = {{0, 0}, {2 * GJK2_RADIUS_MAX, 0}, {5, 5}, {0, 0}}, out[4];
  uint16_t n = 9;
  CHECK(gjk2_polygon_order(NULL, 3, out, &n) == GJK_ERROR_NULL);
  CHECK(gjk2_polygon_order(points, 3, NULL, &n) == GJK_ERROR_NULL);
  CHECK(gjk2_polygon_order(points, 3, out, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_polygon_order(points, 0, out, &n) == GJK_ERROR_EMPTY);
  CHECK(gjk2_polygon_order(points, 3, points + 1, &n) == GJK_ERROR_OVERLAP);
  CHECK(gjk2_polygon_order(points, 3, out, &n) == GJK_OK && n == 3);
  points[2].x = -1;
  n = 9;
  CHECK(gjk2_polygon_order(points, 3, out, &n) == GJK_ERROR_SIZE);
  CHECK(n == 9);
}

int main(void) {
  static gjk2_vec points[MANY];
  const uint64_t seed = check_seed(SEED);
  check_statuses();
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    const int32_t size = INT32_C(1) << random_below(&r, 29), most = size < GJK2_RADIUS_MAX ? size : GJK2_RADIUS_MAX;
    const int32_t at = random_range(&r, INT32_MIN + most, INT32_MAX - most);
    const int count = 1 + (int)random_below(&r, i % 1000 == 0 ? MANY : 40);
    const bool line = random_below(&r, 8) == 0;
    for (int k = 0; k < count; k++) {
      const int32_t x = random_range(&r, -most, most);
      points[k].x = at + x;
      points[k].y = at + (line ? x / 3 * 2 : random_range(&r, -most, most));
    }
    check_trial(i, NULL, NULL);
    check_order(points, count);
  }
  return check_done("plane_polygon");
}
