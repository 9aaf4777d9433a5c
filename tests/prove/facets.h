// Any facet that src/depth/gjk_facet.c may hold, and the check that one is such a facet.
#ifndef PROVE_FACETS_H
#define PROVE_FACETS_H

#include "simplex_any.h"
#include "src/depth/gjk_facet.h"

// A depth in LSB: GJK_HEIGHT_MAX, and what heights and curved supports may be off by.
#define ANY_DEPTH ((INT32_C(1) << 30) + 8)

// A corner; offsets only come with curved shapes.
static void any_corner(gjk_vertex *v, bool curved) {
  v->w = any_vec3(ANY_W);
  v->a.vertex = any_uint16();
  v->b = any_uint16();
  if (curved) {
    v->a.offset = any_vec3(ANY_OFFSET);
  }
}

static void check_corner(const gjk_vertex *v, bool curved) {
  check_vec3(&v->w, ANY_W);
  check_size(v->a.vertex, UINT16_MAX);
  check_size(v->b, UINT16_MAX);
  if (curved) {
    check_vec3(&v->a.offset, ANY_OFFSET);
  }
}

static void any_facet(gjk_facet *facet, bool curved) {
  for (int i = 0; i < 3; i++) {
    any_corner(&facet->corner[i], curved);
  }
  facet->direction.d = any_direction(3);
  facet->direction.exact = any_bool();
  facet->normal.x = any_between(-ANY_UNIT, ANY_UNIT);
  facet->normal.y = any_between(-ANY_UNIT, ANY_UNIT);
  facet->normal.z = any_between(-ANY_UNIT, ANY_UNIT);
  facet->depth = any_between(0, ANY_DEPTH);
  facet->covers = any_bool();
  facet->set = any_bool();
  facet->found = true;
}

static void check_facet(const gjk_facet *facet, bool curved) {
  //@ assert facet->found;
  for (int i = 0; i < 3; i++) {
    check_corner(&facet->corner[i], curved);
  }
  check_vec3(&facet->direction.d, INT32_C(1) << 30);
  check_size(facet->direction.exact, 1);
  check_size(facet->normal.x, ANY_UNIT);
  check_size(facet->normal.y, ANY_UNIT);
  check_size(facet->normal.z, ANY_UNIT);
  check_size(facet->depth, ANY_DEPTH);
  //@ assert facet->depth >= 0;
  check_size(facet->covers, 1);
  check_size(facet->set, 1);
}

#endif
