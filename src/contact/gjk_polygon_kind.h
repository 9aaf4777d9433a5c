// What the kinds of shapes share when they offer a polygon to gjk_contact_polygon.
#ifndef GJK_SRC_POLYGON_KIND_H
#define GJK_SRC_POLYGON_KIND_H

#include "../arith/gjk_height_key.h"
#include "../arith/gjk_unit.h"
#include "gjk_contact_polygon.h"

// gjk_height_key of (u . direction)^2 for a unit vector u; the direction is 2^30 long.
//   FACE_KEY    7/8 of 2^60: a face's normal within 20.7 degrees of the direction
//   LEVEL_KEY   1/8 of 2^60: an edge within 20.7 degrees of level, which is at a right angle to the direction
#define GJK_POLYGON_FACE_KEY (UINT32_C(59) << 16 | 0xC000u)
#define GJK_POLYGON_LEVEL_KEY (UINT32_C(57) << 16)

static inline bool gjk_polygon_is_zero(const gjk_vec3 *v) {
  return (v->x | v->y | v->z) == 0;
}

void gjk_polygon_negate(gjk_long3 *n);

// Sets corner i to position + offset, of the given vertex number.
static inline void gjk_polygon_set_corner(gjk_polygon *p, unsigned i, const gjk_vec3 *position, const gjk_vec3 *offset,
                                          unsigned vertex) {
  p->corner[i] = gjk_add(*position, *offset);
  p->vertex[i] = (uint16_t)vertex;
}

// How well a face of normal n meets the direction, as a height key; 0: not at all. n is rounded to 30 bits first.
uint32_t gjk_polygon_alignment(const gjk_long3 *n, const gjk_vec3 *direction);

// Moves the corners by radius u.
void gjk_polygon_lift(gjk_polygon *p, const gjk_unit3 *u, gjk_q16 radius);

// Steps 3 and 4 of gjk_contact_polygon.c: makes an edge or a corner of a face or edge.
void gjk_polygon_settle(gjk_polygon *p, gjk_q16 radius);

// Step 1 of gjk_contact_polygon.c, by kind of shape. p->direction is set, and p is a corner of feature 0.
void gjk_polygon_from_axes(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out);
void gjk_polygon_from_triangle(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out);
void gjk_polygon_from_hull(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out);
void gjk_polygon_from_disc_base(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out);

#endif
