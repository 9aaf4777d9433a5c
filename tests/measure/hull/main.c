// Hulls of points beside other builders: times for points on a sphere, and answers on sets with known ones.
//
// main NAME...: names of files of points, x y z a line, from tests/data/hulls; NAME=VERTICES/FACES the true answer.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "peer.h"
#include "random.h"

#define MOST 65535

static gjk_vec3 points[MOST];
static uint32_t workspace[GJK_HULL_WORKSPACE(MOST) / 4];

void hull_by_gjk(const gjk_vec3 *p, unsigned count, hull_count *out) {
  gjk_hull hull;
  out->vertices = out->faces = 0;
  if (gjk_hull_build(p, (uint16_t)count, workspace, sizeof workspace, &hull) == GJK_OK) {
    out->vertices = hull.vertices;
    out->faces = hull.faces;
  }
}

static const struct {
  const char *name;
  hull_builder *build;
} builders[] = {
    {"gjk", hull_by_gjk},
#ifdef WITH_QHULL
    {"qhull", hull_by_qhull},
#endif
#ifdef WITH_CGAL
    {"CGAL", hull_by_cgal},
#endif
};

#define BUILDERS (sizeof builders / sizeof builders[0])

static void make_sphere(unsigned count) {
  random_state random = random_seed(count);
  for (unsigned i = 0; i < count;) {
    const double x = random_range(&random, -1000000, 1000000), y = random_range(&random, -1000000, 1000000),
                 z = random_range(&random, -1000000, 1000000), n = sqrt(x * x + y * y + z * z);
    if (n > 1000 && n <= 1000000) {
      points[i].x = (int32_t)(x / n * 1000 * 65536);
      points[i].y = (int32_t)(y / n * 1000 * 65536);
      points[i++].z = (int32_t)(z / n * 1000 * 65536);
    }
  }
}

// The least processor time of several runs, microseconds.
static double time_of(hull_builder *build, unsigned count) {
  double least = 1e30;
  hull_count answer;
  const int runs = count > 5000 ? 5 : count > 500 ? 20 : 200;
  for (int i = 0; i < runs; i++) {
    const clock_t begin = clock();
    build(points, count, &answer);
    const double own = (double)(clock() - begin) * 1e6 / CLOCKS_PER_SEC;
    least = own < least ? own : least;
  }
  return least;
}

static unsigned read_points(const char *name) {
  FILE *file = fopen(name, "r");
  char line[200];
  unsigned count = 0;
  while (file != NULL && count < MOST && fgets(line, sizeof line, file) != NULL) {
    long x, y, z;
    if (sscanf(line, "%ld %ld %ld", &x, &y, &z) == 3) {
      points[count].x = (int32_t)x;
      points[count].y = (int32_t)y;
      points[count++].z = (int32_t)z;
    }
  }
  if (file != NULL) {
    fclose(file);
  }
  return count;
}

int main(int argc, char **argv) {
  static const unsigned sizes[] = {64, 1000, 10000};
  unsigned wrong = 0;
  printf("| points on a sphere, us |");
  for (unsigned b = 0; b < BUILDERS; b++) {
    printf(" %s |", builders[b].name);
  }
  printf("\n");
  for (unsigned i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    make_sphere(sizes[i]);
    printf("| %u |", sizes[i]);
    for (unsigned b = 0; b < BUILDERS; b++) {
      printf(" %.0f |", time_of(builders[b].build, sizes[i]));
    }
    printf("\n");
  }
  for (int i = 1; i < argc; i++) {
    char name[200];
    hull_count truth, answer;
    if (sscanf(argv[i], "%199[^=]=%u/%u", name, &truth.vertices, &truth.faces) != 3) {
      return 2;
    }
    const unsigned count = read_points(name);
    printf("| %s, %u points, %u vertices, %u facets |", strrchr(name, '/') + 1, count, truth.vertices, truth.faces);
    for (unsigned b = 0; b < BUILDERS; b++) {
      builders[b].build(points, count, &answer);
      const bool right = answer.vertices == truth.vertices && (answer.faces == 0 || answer.faces == truth.faces);
      if (answer.vertices == 0) {
        printf(" refused |");
      } else if (right) {
        printf(" right |");
      } else {
        printf(" %u, %u |", answer.vertices, answer.faces);
      }
      wrong += b == 0 && !right ? 1u : 0u;
    }
    printf("\n");
  }
  return wrong > 0;
}
