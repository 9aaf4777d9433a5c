// A bound for parts that reach only a little beyond: a shrunk copy that is inside the solid.
#include <math.h>
#include <stdlib.h>

#include "enclose.h"
#include "excess.h"

enum { ROUNDS = 200 };

// Half the area of a face is at most this; tiny faces come from rounding and are not shrunk.
static long double area_of(const part *p, unsigned f) {
  long double sum[3] = {0, 0, 0};
  const unsigned begin = f == 0 ? 0 : p->end[f - 1];
  const int32_t *o = p->point[p->corner[begin]];
  for (unsigned i = begin + 1; i + 1 < p->end[f]; i++) {
    const int32_t *a = p->point[p->corner[i]], *b = p->point[p->corner[i + 1]];
    for (int j = 0; j < 3; j++) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      sum[j] += (long double)(a[k] - o[k]) * (b[l] - o[l]) - (long double)(a[l] - o[l]) * (b[k] - o[k]);
    }
  }
  return sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

typedef struct wall {
  long double n[3], d, area;
} wall;

// Moves a point behind all walls near it by depth, as far as that is possible.
static void move(const wall *walls, unsigned count, long double least, long double depth, const int32_t from[3],
                 int32_t to[3]) {
  long double x[3] = {from[0], from[1], from[2]};
  for (int round = 0; round < ROUNDS; round++) {
    for (unsigned f = 0; f < count; f++) {
      const wall *w = &walls[f];
      const long double was = w->n[0] * from[0] + w->n[1] * from[1] + w->n[2] * from[2] - w->d;
      const long double is = w->n[0] * x[0] + w->n[1] * x[1] + w->n[2] * x[2] - w->d + depth;
      if (w->area >= least && was > -4 * depth - 32 && is > 0) {
        for (int j = 0; j < 3; j++) {
          x[j] -= is * w->n[j];
        }
      }
    }
  }
  for (int j = 0; j < 3; j++) {
    to[j] = (int32_t)rintl(fminl(SOLID_EXTENT, fmaxl(0, x[j])));
  }
}

long double excess_by_shrinking(const solid *s, const part *p) {
  wall *walls = solid_allocate(p->faces, sizeof walls[0]);
  int32_t(*point)[3] = solid_allocate(p->points, sizeof point[0]);
  long double largest = 0, bound = INFINITY;
  for (unsigned f = 0; f < p->faces; f++) {
    wall *w = &walls[f];
    long double length = 0;
    for (int j = 0; j < 3; j++) {
      length += (long double)p->plane[f].n[j] * (long double)p->plane[f].n[j];
    }
    for (int j = 0; j < 3; j++) {
      w->n[j] = (long double)p->plane[f].n[j] / sqrtl(length);
    }
    w->d = (long double)p->plane[f].d / sqrtl(length);
    w->area = area_of(p, f);
    largest = fmaxl(largest, w->area);
  }
  for (long double depth = 1; depth <= 64 && !isfinite(bound); depth *= 2) {
    part less;
    for (unsigned i = 0; i < p->points; i++) {
      move(walls, p->faces, largest / 256, depth, p->point[i], point[i]);
    }
    if (part_build(&less, point, p->points)) {
      if (enclose_is_inside(s, &less)) {
        bound = 0;
        for (unsigned i = 0; i < p->points; i++) {
          const long double x = p->point[i][0] - point[i][0], y = p->point[i][1] - point[i][1],
                            z = p->point[i][2] - point[i][2];
          bound = fmaxl(bound, sqrtl(x * x + y * y + z * z));
        }
      }
      part_free(&less);
    }
  }
  free(point);
  free(walls);
  return bound;
}
