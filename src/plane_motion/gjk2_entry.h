// Where the line of a way enters A - B, cores alone.
#ifndef GJK2_SRC_ENTRY_H
#define GJK2_SRC_ENTRY_H

#include "gjk2_way.h"

// The line enters across the edge from p to q, p to the right of the way or on it, q to the left or on it; or, where
// count is 1, at the vertex p. No vertex of A - B lies beyond n . w = along, and the way leads against n: closing > 0.
typedef struct gjk2_entry {
  gjk2_span p, q;
  int64_t side_p, side_q;  // t x w of both
  gjk2_vec n;
  int64_t along;
  uint64_t closing;  // -(n . t)
  unsigned count;
} gjk2_entry;

// False: the line passes A - B, and p is the vertex nearest to it. Pre: two polygons; t is not 0.
bool gjk2_entry_find(gjk2_way *way, gjk2_entry *out);

#endif
