// Where two polygons, or a polygon and an edge, or two edges, cover each other along the direction in which they meet.
#ifndef GJK_SRC_CLIP_H
#define GJK_SRC_CLIP_H

#include "gjk/contacts.h"
#include "gjk_contact_polygon.h"

// Two convex polygons share a polygon with at most the corners of both.
#define GJK_TOUCHES_MAX (2 * GJK_FACE_CORNERS_MAX)

// Pairs of points, one across from the other.
typedef struct gjk_touches {
  gjk_contact touch[GJK_TOUCHES_MAX];
  unsigned count;
} gjk_touches;

// What of a shape a point is of, one byte of an id each: A's is the high one.
#define GJK_PART_FACE 0x00u         // within the face
#define GJK_PART_FACE_CORNER 0x01u  // plus the corner's index
#define GJK_PART_FACE_EDGE 0x11u    // plus that of the corner where the edge starts
#define GJK_PART_EDGE 0x40u         // within the edge
#define GJK_PART_EDGE_END 0x41u     // plus the end's index
#define GJK_PART_CORNER 0x80u

// The part of a polygon, edge or corner that a point within it is of.
static inline unsigned gjk_part_of(const gjk_polygon *p) {
  return p->count > 2 ? GJK_PART_FACE : p->count == 2 ? GJK_PART_EDGE : GJK_PART_CORNER;
}

static inline uint16_t gjk_touch_id(unsigned part_a, unsigned part_b) {
  return (uint16_t)(part_a << 8 | part_b);
}

// The corners of what a and b share, seen along a->direction, which is -b->direction: in the world, centre being that of
// the polygons; those at most margin apart. Edges that cross at an angle with a sine of more than 1/32 share nothing.
// Pre: both have two corners at least.
void gjk_clip(const gjk_polygon *a, const gjk_polygon *b, const gjk_vec3 *centre, gjk_q16 margin, gjk_touches *out);

#endif
