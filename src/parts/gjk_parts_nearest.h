// The search for the part that is nearest to B.
#ifndef GJK_SRC_PARTS_NEAREST_H
#define GJK_SRC_PARTS_NEAREST_H

#include "gjk_parts_class.h"

// The nearest part so far. Normal, points and certificate are found once, at the end.
typedef struct gjk_parts_nearest {
  gjk_q16 distance;
  bool intersecting;
  uint32_t part;      // its number; GJK_PARTS_NONE: none yet
  uint32_t of_b;      // the number of B's part that it is nearest to
  gjk_status status;  // of its query: OK or ITERATION_LIMIT
  bool limited;       // some part reached its ceiling
  gjk_q16 lower;      // the least lower bound of those
} gjk_parts_nearest;

// Begins without a part.
void gjk_parts_nearest_start(gjk_parts_nearest *n);

// Asks the parts that may be nearer to B than the nearest so far. of_b: number of B among the parts of its body; else 0.
// If a part reaches its ceiling, limited is set. Pre: the region is B's, grown by 0. Other statuses than OK end the
// query.
gjk_status gjk_parts_nearest_ask(gjk_parts_nearest *n, const gjk_parts_frame *frame, gjk_region *region,
                                 const gjk_collider *b, uint32_t of_b);

// Once the nearest part is known, takes the bounds of all parts that reach their ceiling and may be nearer. Call it for
// each B if any part is limited.
gjk_status gjk_parts_nearest_bound(gjk_parts_nearest *n, const gjk_parts_frame *frame, gjk_region *region,
                                   const gjk_collider *b);

// Writes the result, and returns its status. b: the collider that the part is nearest to.
gjk_status gjk_parts_nearest_report(const gjk_parts_nearest *n, const gjk_parts_frame *frame, const gjk_collider *b,
                                    gjk_distance_result *out);

#endif
