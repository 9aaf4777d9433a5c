// Any polygon that src/contact/gjk_contact_polygon.c may give, and the check that one is such a polygon.
#ifndef PROVE_POLYGONS_H
#define PROVE_POLYGONS_H

#include "simplex_any.h"
#include "src/contact/gjk_contact_polygon.h"

// Bound of a corner from A's centre: B's centre is at most 2^29 away, and core and convex radius of a shape reach 2^28
// together.
#define ANY_CORNER ((INT32_C(1) << 30) - 1)

// count: 1 to GJK_FACE_CORNERS_MAX, known by its value.
static void any_polygon(gjk_polygon *p, int32_t count) {
  p->count = (uint8_t)count;
  p->feature = any_uint16();
  if (count > 1) {
    for (int i = 0; i < count; i++) {
      p->corner[i] = any_vec3(ANY_CORNER);
    }
    p->direction = any_vec3(ANY_UNIT);
    p->radius = any_between(0, 2 * GJK_RADIUS_MAX);
  }
  if (count > 2) {
    any_normal(&p->normal);
  }
}

static void check_polygon(const gjk_polygon *p) {
  //@ assert p->count >= 1 && p->count <= GJK_FACE_CORNERS_MAX;
  check_size(p->feature, UINT16_MAX);
  if (p->count > 1) {
    for (unsigned i = 0; i < p->count; i++) {
      check_vec3(&p->corner[i], ANY_CORNER);
    }
    check_vec3(&p->direction, ANY_UNIT);
    //@ assert p->radius >= 0 && p->radius <= 2 * GJK_RADIUS_MAX;
  }
  if (p->count > 2) {
    check_size(p->normal.x, ANY_NORMAL);
    check_size(p->normal.y, ANY_NORMAL);
    check_size(p->normal.z, ANY_NORMAL);
  }
}

#endif
