// The corners of the convex hull of a polygon's posed vertices, whatever their order.
//
// Where the vertices are in order (gjk2_collider) a corner's neighbours are its neighbours in the list. Elsewhere the
// next corner is the vertex that has no other on the right of the way to it, and of several in one line the farthest:
// one pass over the vertices, a step of gift wrapping (Jarvis 1973). So vertices in no order, repeated ones, ones in a
// line, and those that posing has moved inside or behind each other are all treated as the hull that they have.
#ifndef GJK2_SRC_HULL_H
#define GJK2_SRC_HULL_H

#include "gjk2_class.h"

// The corner farthest along d, of several the last one counterclockwise. Pre: a polygon; d != 0, |d| <= 3 2^29.
void gjk2_hull_corner(const gjk2_collider *c, gjk2_vec d, gjk2_support *out);

// The way to the corner that follows another counterclockwise, or precedes it. False: there is no other.
bool gjk2_hull_neighbour(const gjk2_collider *c, const gjk2_support *corner, bool following, gjk2_support *way);

// The list of a collider's corners, counterclockwise, relative to its centre: a box's is written to own. NULL: its vertices
// are in no order, or lazy.
static inline const gjk2_vec *gjk2_list_of_corners(const gjk2_collider *c, gjk2_vec own[4]) {
  if (!c->ordered) {
    return NULL;
  }
  if (c->shape->type->buffered) {
    return c->buffer;
  }
  if (c->count == 3) {
    return c->frame;
  }
  const gjk2_vec x = c->frame[0], y = c->frame[1];
  own[0].x = x.x + y.x;
  own[0].y = x.y + y.y;
  own[1].x = y.x - x.x;
  own[1].y = y.y - x.y;
  own[2].x = -own[0].x;
  own[2].y = -own[0].y;
  own[3].x = -own[1].x;
  own[3].y = -own[1].y;
  return own;
}

// The number of a box's corner from its place in the list, and back: 3, 2, 0, 1 counterclockwise.
static inline unsigned gjk2_box_number(unsigned index) {
  return 0x4Bu >> (2 * index) & 3u;
}

static inline unsigned gjk2_box_index(unsigned number) {
  return 0x1Eu >> (2 * number) & 3u;
}

#endif
