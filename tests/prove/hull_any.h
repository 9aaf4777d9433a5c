// Any work of a hull of a few points, as src/hull/gjk_hull_grow.c leaves it: numbers of points and of triangles that
// there are, and no more than that. So it covers work that no points lead to.
#ifndef PROVE_HULL_ANY_H
#define PROVE_HULL_ANY_H

#include "any.h"
#include "src/hull/gjk_hull_facets.h"

// Of the largest hull of a driver.
#define ANY_POINTS 6

// Places for triangles: the workspace has 2 for each point.
#define ANY_PLACES (2 * ANY_POINTS)

static void any_points(gjk_vec3 *points, int32_t count) {
  for (int32_t i = 0; i < count; i++) {
    points[i] = any_position();
  }
}

static uint16_t any_number(uint32_t count) {
  return (uint16_t)any_between(0, (int32_t)count - 1);
}

static void any_triangle(gjk_hull_triangle *t, uint32_t points, uint32_t triangles) {
  for (int i = 0; i < 3; i++) {
    t->vertex[i] = any_number(points);
    t->side[i] = any_number(triangles);
  }
  t->outside = any_bool() ? GJK_HULL_NO_POINT : any_uint16();
  // No bit of a side or link above 2^16 triangles, and no flat or written edge yet.
  t->flags = any_bool() ? GJK_HULL_SEEN : 0;
}

static void check_triangle(const gjk_hull_triangle *t, uint32_t points, uint32_t triangles) {
  for (int i = 0; i < 3; i++) {
    const uint32_t side = gjk_hull_side(t, (unsigned)i);
    //@ assert t->vertex[i] < points;
    //@ assert side < triangles;
  }
}

#endif
