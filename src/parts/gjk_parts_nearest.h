// The search for the part that is nearest to B.
#ifndef GJK_SRC_PARTS_NEAREST_H
#define GJK_SRC_PARTS_NEAREST_H

#include "gjk_parts_class.h"

// The nearest part so far. The last result is kept beside it, so that the better one is chosen without a copy.
typedef struct gjk_parts_nearest {
  gjk_distance_result result[2];
  unsigned best;      // which of both is the nearest part's
  uint32_t part;      // its number; GJK_PARTS_NONE: none yet
  uint32_t of_b;      // the number of B's part that it is nearest to
  gjk_status status;  // of its query: OK or ITERATION_LIMIT
  bool limited;       // some part reached its ceiling
  gjk_q16 lower;      // the least lower bound of those
} gjk_parts_nearest;

// Begins without a part.
void gjk_parts_nearest_start(gjk_parts_nearest *n);

// Asks the parts that may be nearer to B than the nearest so far. of_b: number of B among the parts of its body; else 0.
// Where a part reaches its ceiling, limited is set. Pre: the region is B's, grown by 0. Other statuses than OK end the
// query.
gjk_status gjk_parts_nearest_ask(gjk_parts_nearest *n, const gjk_parts_frame *frame, gjk_region *region,
                                 const gjk_collider *b, uint32_t of_b);

// Once the nearest part is known: takes the bounds of all parts that reach their ceiling and may be nearer. To be called for
// each B, if any part is limited.
gjk_status gjk_parts_nearest_bound(gjk_parts_nearest *n, const gjk_parts_frame *frame, gjk_region *region,
                                   const gjk_collider *b);

// Writes the result, and returns its status.
gjk_status gjk_parts_nearest_report(const gjk_parts_nearest *n, gjk_distance_result *out);

#endif
