// The face, edge or point with which a shape meets a direction.
#ifndef GJK_SRC_CONTACT_POLYGON_H
#define GJK_SRC_CONTACT_POLYGON_H

#include "shape_class.h"

// Relative to a centre that both shapes of a pair share; coordinates at most 2^30.
typedef struct gjk_polygon {
  gjk_vec3 corner[GJK_FACE_CORNERS_MAX];  // counterclockwise seen from outside
  gjk_unit3 normal;                       // outwards, of a polygon
  uint16_t feature;                       // its number, see gjk/contacts.h
  uint8_t count;                          // 1: no more than a point is known; 2: an edge; from 3 on a polygon
} gjk_polygon;

// u . v, Q2.30.
gjk_q30 gjk_cosine(const gjk_unit3 *u, const gjk_unit3 *v);

// Within about 20 degrees.
#define GJK_ALIGNED (GJK_Q30_ONE / 16 * 15)

// What c, its centre at position, meets the direction u with, which leads out of it.
void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_unit3 *u, gjk_polygon *out);

#endif
