// Simple hulls in the plane: all points inside exactly, few enough vertices, the stated excess that of the result.
#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk2/hull.h"
#include "random.h"

#define MOST 400

static gjk2_vec point[MOST], vertex[2 * MOST], hull_vertex[MOST], kept[2 * MOST];
static uint16_t count;
static gjk2_hull full;

static void print(const void *subject) {
  (void)subject;
  for (unsigned i = 0; i < count; i++) {
    printf("%ld %ld\n", (long)point[i].x, (long)point[i].y);
  }
}

static void add(int32_t x, int32_t y) {
  point[count].x = x;
  point[count++].y = y;
}

// Twice the area of a, b, c, which are less than 2^30 apart.
static int64_t turn(gjk2_vec a, gjk2_vec b, gjk2_vec c) {
  return ((int64_t)b.x - a.x) * ((int64_t)c.y - a.y) - ((int64_t)b.y - a.y) * ((int64_t)c.x - a.x);
}

// The distance of q from the hull, in double.
static double distance_of(gjk2_vec q) {
  double least = INFINITY;
  bool inside = full.dimension == 2;
  for (unsigned i = 0; i < full.vertices; i++) {
    const gjk2_vec a = hull_vertex[i], b = hull_vertex[(i + 1) % full.vertices];
    const double ex = (double)b.x - a.x, ey = (double)b.y - a.y, wx = (double)q.x - a.x, wy = (double)q.y - a.y;
    const double squared = ex * ex + ey * ey, t = squared > 0 ? (wx * ex + wy * ey) / squared : 0;
    const double at = t < 0 ? 0 : t > 1 ? 1 : t, own = hypot(wx - at * ex, wy - at * ey);
    least = own < least ? own : least;
    inside = inside && turn(a, b, q) >= 0;
  }
  return inside ? 0 : least;
}

// Simplifies and checks all that is promised. Returns the excess.
static uint32_t check_simple(uint16_t most) {
  gjk2_hull_simple simple = {0, 0};
  gjk2_hull_report report;
  memset(vertex, 0xA5, sizeof vertex);
  CHECK(gjk2_hull_build(point, count, hull_vertex, &full) == GJK_OK);
  CHECK(gjk2_hull_simplify(point, count, most, vertex, &simple) == GJK_OK);
  for (unsigned i = 2u * count; i < 2 * MOST; i++) {
    CHECK((uint32_t)vertex[i].x == UINT32_C(0xA5A5A5A5));
  }
  if (full.vertices <= most) {
    CHECK(simple.vertices == full.vertices && simple.excess == 0 &&
          memcmp(vertex, hull_vertex, full.vertices * sizeof vertex[0]) == 0);
    return 0;
  }
  CHECK(simple.vertices <= most);
  CHECK(gjk2_hull_check(vertex, simple.vertices, &report) == GJK_OK && report.fault == GJK2_HULL_SOUND);
  unsigned beyond = 0;
  double excess = 0;
  for (unsigned i = 0; i < simple.vertices; i++) {
    for (unsigned j = 0; j < count; j++) {
      beyond += turn(vertex[i], vertex[(i + 1) % simple.vertices], point[j]) < 0;
    }
    const double own = distance_of(vertex[i]);
    excess = own > excess ? own : excess;
  }
  CHECK(beyond == 0);
  CHECK_MSG(excess <= simple.excess + 0.01 && excess + 4.01 >= simple.excess, "excess %.3f, stated %lu", excess,
            (unsigned long)simple.excess);
  return simple.excess;
}

// Corners of a circle to a regular polygon around it, nearly: its corners are at 1 / cos(pi / n).
static void test_circle(void) {
  static const uint16_t most[] = {4, 5, 8, 16, 32, 64, 128};
  const int32_t radius = 10000000;
  count = 0;
  for (unsigned i = 0; i < 256; i++) {
    add((int32_t)lround(radius * cos(i * 2 * acos(-1) / 256)), (int32_t)lround(radius * sin(i * 2 * acos(-1) / 256)));
  }
  check_trial(0, NULL, NULL);
  for (unsigned i = 0; i < sizeof most / sizeof most[0]; i++) {
    const double least = radius * (1 / cos(acos(-1) / most[i]) - 1), found = check_simple(most[i]);
    printf("circle of radius %ld: %u vertices, excess %.0f, at best %.0f\n", (long)radius, most[i], found, least);
    CHECK(found <= 2.5 * least);
  }
}

static void test_random(void) {
  random_state random = random_seed(check_seed(5150));
  unsigned fewer = 0, same = 0, boxed = 0;
  for (unsigned long trial = 0; trial < check_trials(4000); trial++) {
    const int32_t size = INT32_C(1) << random_range(&random, 1, 27), thick = size >> random_below(&random, 28);
    const int32_t at = random_range(&random, -1000000000, 1000000000);
    const uint32_t n = 1 + random_below(&random, 60);
    check_trial(trial, print, NULL);
    count = 0;
    while (count < n) {
      const int32_t x = random_range(&random, -size, size), y = random_range(&random, -thick, thick);
      if (trial % 2 == 0 || (double)x * x / size / size + (double)y * y / (thick + 1.0) / (thick + 1.0) > 0.9) {
        add(at + x, at + y + (trial % 3 == 0 ? x / 2 : 0));
      }
    }
    const uint16_t most = (uint16_t)random_range(&random, 4, 12);
    check_simple(most);
    fewer += full.vertices > most;
    same += full.vertices <= most;
    memcpy(kept, vertex, sizeof kept);
    boxed += full.vertices > most && vertex[0].y == vertex[1].y && vertex[1].x == vertex[2].x;
    for (uint32_t i = count; i > 1; i--) {
      const uint32_t j = random_below(&random, i);
      const gjk2_vec swapped = point[i - 1];
      point[i - 1] = point[j];
      point[j] = swapped;
    }
    check_simple(most);
    CHECK(full.vertices <= most || memcmp(kept, vertex, 4 * sizeof kept[0]) == 0);
  }
  CHECK_MSG(!check_is_full() || (fewer > check_trials(4000) / 4 && same > check_trials(4000) / 4 && boxed < fewer / 2),
            "%u %u %u", fewer, same, boxed);
}

// The ends of int32, the largest size, the statuses.
static void test_cases(void) {
  gjk2_hull_simple simple = {7, 8};
  for (int end = 0; end < 2; end++) {
    const int32_t side = 2 * GJK2_RADIUS_MAX, low = end == 0 ? INT32_MIN : INT32_MAX - side;
    check_trial((unsigned long)end, print, NULL);
    count = 0;
    for (int32_t i = 0; i < 40; i++) {
      add(low + i * (side / 39), low + (i * i - 39 * i + 400) * (side / 400));
    }
    check_simple(4);
    check_simple(7);
  }
  CHECK(gjk2_hull_simplify(NULL, count, 4, vertex, &simple) == GJK_ERROR_NULL);
  CHECK(gjk2_hull_simplify(point, count, 4, NULL, &simple) == GJK_ERROR_NULL);
  CHECK(gjk2_hull_simplify(point, count, 4, vertex, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_hull_simplify(point, count, 3, vertex, &simple) == GJK_ERROR_RANGE);
  CHECK(gjk2_hull_simplify(point, 0, 4, vertex, &simple) == GJK_ERROR_EMPTY);
  point[0].x = 0;
  CHECK(gjk2_hull_simplify(point, count, 4, vertex, &simple) == GJK_ERROR_SIZE);
  CHECK(simple.vertices == 7 && simple.excess == 8);
}

// An octagon as wide as may be: the edges beside each edge meet beyond the room for corners. Its box is what is left.
static void test_no_room(void) {
  const int32_t r = GJK2_RADIUS_MAX, h = r / 100 * 71;
  const int32_t x[8] = {r, h, 0, -h, -r, -h, 0, h}, y[8] = {0, h, r, h, 0, -h, -r, -h};
  count = 0;
  for (int i = 0; i < 8; i++) {
    add(x[i], y[i]);
  }
  CHECK(check_simple(7) > (uint32_t)(r - h) && vertex[0].x == -r && vertex[0].y == -r);
}

int main(void) {
  test_circle();
  test_random();
  test_cases();
  test_no_room();
  return check_done("plane simplify");
}
