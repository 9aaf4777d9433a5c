// Firmware: instructions of building hulls of points on a sphere, one line per number of points.
#include "count.h"
#include "gjk/hull.h"
#include "random.h"

#ifndef HULL_BENCH_POINTS  // of boards with little memory fewer
#define HULL_BENCH_POINTS 256
#endif

static gjk_vec3 point[HULL_BENCH_POINTS];
static uint32_t workspace[GJK_HULL_WORKSPACE(HULL_BENCH_POINTS) / 4];

// floor(sqrt(x)), bit by bit.
static int64_t root(int64_t x) {
  int64_t r = 0;
  for (int bit = 30; bit >= 0; bit--) {
    const int64_t next = r | INT64_C(1) << bit;
    r = next * next <= x ? next : r;
  }
  return r;
}

// Makes count points on a sphere of 2 units, the same ones on every target.
COUNTED void make(unsigned count) {
  random_state random = random_seed(15);
  for (unsigned i = 0; i < count;) {
    const int64_t most = 1 << 20, x = random_range(&random, -(1 << 20), 1 << 20);
    const int64_t y = random_range(&random, -(1 << 20), 1 << 20), z = random_range(&random, -(1 << 20), 1 << 20);
    const int64_t squared = x * x + y * y + z * z, length = root(squared);
    if (length > most / 16 && squared <= most * most) {  // in the ball, so that no direction is preferred
      point[i].x = (gjk_q16)(x * 2 * GJK_Q16_ONE / length);
      point[i].y = (gjk_q16)(y * 2 * GJK_Q16_ONE / length);
      point[i].z = (gjk_q16)(z * 2 * GJK_Q16_ONE / length);
      i++;
    }
  }
}

// Builds their hull. Returns its facets.
COUNTED uint32_t build(unsigned count) {
  gjk_hull hull;
  return gjk_hull_build(point, (uint16_t)count, workspace, sizeof workspace, &hull) == GJK_OK ? hull.faces : 0;
}

int firmware_main(void) {
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned count = 16; count <= HULL_BENCH_POINTS; count *= 2) {
    make(count);
    const uint32_t start = board_ticks(), faces = build(count), instructions = count_since(start);
    board_print("hull of ");
    print_decimal(board_print, count);
    board_print(" points, ");
    print_decimal(board_print, faces);
    board_print(" facets: ");
    print_decimal(board_print, instructions);
    board_print(" instructions\n");
  }
  return 0;
}
