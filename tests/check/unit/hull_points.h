// A hull of points with its output, for tests.
#ifndef HULL_POINTS_H
#define HULL_POINTS_H

#include <stdio.h>
#include <string.h>

#include "check.h"
#include "gjk/hull.h"
#include "random.h"

#define HULL_POINTS 1024

typedef struct hull_points {
  gjk_vec3 point[HULL_POINTS];
  uint16_t count;
} hull_points;

typedef struct hull_output {
  gjk_hull hull;
  gjk_vec3 vertex[HULL_POINTS];
  uint16_t corner[8 * HULL_POINTS], end[2 * HULL_POINTS];
  gjk_hull_faces faces;
  gjk_hull_volume volume;
} hull_output;

// Prints points as gjk-convert reads them.
static void hull_points_print(const void *subject) {
  const hull_points *p = (const hull_points *)subject;
  printf("hull %u\n", p->count);
  for (unsigned i = 0; i < p->count; i++) {
    printf("%ld %ld %ld\n", (long)p->point[i].x, (long)p->point[i].y, (long)p->point[i].z);
  }
}

static inline void hull_points_add(hull_points *p, int32_t x, int32_t y, int32_t z) {
  const gjk_vec3 point = {x, y, z};
  p->point[p->count++] = point;
}

// Puts the points in another order.
static inline void hull_points_shuffle(hull_points *p, random_state *random) {
  for (uint32_t i = p->count; i > 1; i--) {
    const uint32_t j = random_below(random, i);
    const gjk_vec3 swapped = p->point[i - 1];
    p->point[i - 1] = p->point[j];
    p->point[j] = swapped;
  }
}

// Builds and writes out the hull. Checks every status.
static inline void hull_output_make(const hull_points *p, hull_output *out) {
  static uint32_t workspace[GJK_HULL_WORKSPACE(HULL_POINTS) / 4];
  CHECK(gjk_hull_build(p->point, p->count, workspace, GJK_HULL_WORKSPACE(p->count), &out->hull) == GJK_OK);
  CHECK(gjk_hull_vertices(&out->hull, out->vertex, HULL_POINTS) == GJK_OK);
  CHECK(gjk_hull_write_faces(&out->hull, out->corner, 8 * HULL_POINTS, out->end, 2 * HULL_POINTS, &out->faces) ==
        GJK_OK);
  CHECK(gjk_hull_get_volume(&out->hull, &out->volume) == GJK_OK);
}

// Are two outputs the same, field by field?
static inline bool hull_output_equal(const hull_output *a, const hull_output *b) {
  const uint32_t corners = a->faces.count > 0 ? a->end[a->faces.count - 1] : 0;
  return a->hull.dimension == b->hull.dimension && a->hull.vertices == b->hull.vertices &&
         a->hull.faces == b->hull.faces && a->hull.edges == b->hull.edges && a->hull.corners == b->hull.corners &&
         a->hull.most_corners == b->hull.most_corners && a->volume.high == b->volume.high &&
         a->volume.low == b->volume.low && a->faces.count == b->faces.count &&
         memcmp(a->vertex, b->vertex, a->hull.vertices * sizeof a->vertex[0]) == 0 &&
         memcmp(a->corner, b->corner, corners * sizeof a->corner[0]) == 0 &&
         memcmp(a->end, b->end, a->faces.count * sizeof a->end[0]) == 0;
}

#endif
