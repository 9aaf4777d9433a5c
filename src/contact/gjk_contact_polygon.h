// The polygon with which a shape meets a direction: a face, an edge or a corner.
#ifndef GJK_SRC_CONTACT_POLYGON_H
#define GJK_SRC_CONTACT_POLYGON_H

#include "../shape/gjk_shape_class.h"

// A face of a box has four.
#define GJK_POLYGON_CORNERS (GJK_SHAPES <= GJK_SHAPES_BOXES ? 4 : GJK_FACE_CORNERS_MAX)

// On the shape's surface, its convex radius included, relative to an origin that both shapes of a pair share.
//   components   at most 2^30 in size
//   edges        at most 2^29 long
typedef struct gjk_polygon {
  gjk_vec3 corner[GJK_POLYGON_CORNERS];  // of a face counterclockwise seen from outside, of an edge by vertex number
  uint16_t vertex[GJK_POLYGON_CORNERS];  // the corners' vertex numbers
  gjk_long3 normal;                      // of a face: outward, components below 2^62
  gjk_vec3 direction;                    // the direction that the polygon meets: a unit vector, Q2.30
  uint16_t feature;                      // the number that gjk/contacts.h gives the face, edge or corner
  gjk_q16 radius;                        // of an edge: the radius of the surface around it; 0: sharp
  bool meets;                            // it is a face known to be within 20 degrees of the direction
  uint8_t
      count;  // 2: an edge; more: a face; 1: a corner, or nothing known, and then only direction and feature are set
} gjk_polygon;

// Finds the polygon with which c meets another shape along direction, a unit vector in Q2.30 that leads out of c: a
// face within 20 degrees of direction, else an edge at the farthest corner that is level within 20 degrees, else a
// corner. position: where c's centre is, relative to the origin of the pair.
// Pre: components of position at most 2^29.
void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *direction, gjk_polygon *out);

#endif
