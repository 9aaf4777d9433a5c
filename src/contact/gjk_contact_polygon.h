// The face, edge or corner with which a shape meets a direction.
#ifndef GJK_SRC_CONTACT_POLYGON_H
#define GJK_SRC_CONTACT_POLYGON_H

#include "../shape/gjk_shape_class.h"

// On the shape's surface, its rounding included, relative to a centre that both shapes of a pair share: components at
// most 2^30 in size, edges at most 2^29 long.
typedef struct gjk_polygon {
  gjk_vec3 corner[GJK_FACE_CORNERS_MAX];  // of a face counterclockwise seen from outside, of an edge by vertex number
  uint16_t vertex[GJK_FACE_CORNERS_MAX];  // their numbers
  gjk_long3 normal;                       // of a face, outwards, below 2^62
  gjk_vec3 direction;                     // that it meets, a unit vector in Q2.30
  uint16_t feature;                       // its number, see gjk/contacts.h
  gjk_q16 radius;                         // of an edge: of the side that it is the line of, 0: sharp
  uint8_t count;  // 1: a corner, or none known, and nothing else is set; 2: an edge; more: a face
} gjk_polygon;

// What c, its centre at position, meets the other shape with along direction, Q2.30, which leads out of it: a face within
// 20 degrees of it, else the edge that reaches farthest if it is level within 20 degrees, else a corner.
// Pre: components of position at most 2^29.
void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *direction, gjk_polygon *out);

#endif
