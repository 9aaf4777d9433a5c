// How far a body reaches along a direction d from a vertex v of a chain: the least d . (b - v) / |d| over its points b.
//
// Over a wedge it is largest at the wedge's ends, at an edge of the body that faces v, or where v is nearest to a corner.
// Everything is relative to the body's centre, and without its convex radius.
#ifndef GJK2_SRC_CHAIN_REACH_H
#define GJK2_SRC_CHAIN_REACH_H

#include "gjk2_class.h"
#include "gjk2_measure.h"

// A direction, and how far the body's core reaches along it: height / |d|.
typedef struct gjk2_chain_aim {
  gjk2_vec d;
  int64_t height;
  uint64_t squared;  // |d|^2
  gjk2_vec at;       // a farthest point of the core
  uint16_t feature;  // as of gjk2_manifold, and its byte of an id
  uint8_t id;
} gjk2_chain_aim;

// The body's reach along d from v, by its corner deepest along d.
void gjk2_chain_aim_along(const gjk2_collider *body, const gjk2_vec *d, const gjk2_vec *v, gjk2_chain_aim *out);

// Does the body reach farther along a than along b? Exact.
bool gjk2_chain_is_farther(const gjk2_chain_aim *a, const gjk2_chain_aim *b);

// Is d strictly within the wedge that turns left from one direction to another, by at most half a turn?
static inline bool gjk2_chain_is_in_wedge(const gjk2_vec *from, const gjk2_vec *to, const gjk2_vec *d) {
  return gjk2_cross(*from, *d) > 0 && gjk2_cross(*d, *to) > 0;
}

// The direction strictly within a wedge along which the body, a polygon, reaches farthest from v. False: there is none.
bool gjk2_chain_find_in_wedge(const gjk2_collider *body, const gjk2_vec *from, const gjk2_vec *to, const gjk2_vec *v,
                              gjk2_chain_aim *best);

// The reach to the nearest LSB. Sets the unit of its direction.
int64_t gjk2_chain_measure(const gjk2_chain_aim *aim, gjk2_unit *unit);

#endif
