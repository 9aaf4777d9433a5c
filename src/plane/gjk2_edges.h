// The edges of A - B, one after the other, and the one nearest to the origin: depth without a workspace.
//
//   1. Start at a vertex of A - B that is farthest along some direction, the last of equals counterclockwise.
//   2. The next edge of A - B is the next edge of A or the next edge of -B, whichever turns less; parallel ones make one
//      edge of both. Signs of cross products decide, exactly.
//   3. An edge with the origin strictly on its right proves that the cores are apart.
//   4. Keep the edge whose line is nearest to the origin, exactly. Go once round, or both ways until the rest is
//      farther.
//
// A shape's edges are those of the hull of its posed vertices, in whatever order these are (gjk2_hull.h).
//
// Each step takes an edge of A or of -B, so polygons of n and m vertices take at most n + m.
#ifndef GJK2_SRC_EDGES_H
#define GJK2_SRC_EDGES_H

#include "gjk2_search.h"

typedef enum gjk2_lie {
  GJK2_LIE_OVERLAP,  // the origin lies in A - B: edge is the nearest
  GJK2_LIE_APART,    // the origin lies outside; s->d separates the cores
  GJK2_LIE_OPEN      // A - B has no area and its line holds the origin, or it is a point: ask GJK
} gjk2_lie;

// The edge of A - B nearest to the origin, counterclockwise from p to q.
typedef struct gjk2_edge {
  gjk2_vertex p, q;
  gjk2_length length;
  int64_t height;  // p x q = outward normal . p >= 0: height / length is the distance of the edge's line
} gjk2_edge;

// How do the cores lie? Sets edge where they overlap. Pre: polygons in a near frame.
gjk2_lie gjk2_nearest_edge(gjk2_search *s, gjk2_edge *edge);

// Is the edge's distance below height / length? Exact.
bool gjk2_edge_is_lower(const gjk2_edge *edge, uint64_t height, const gjk2_length *length);

#endif
