// The search for the part that overlaps B most.
#ifndef GJK_SRC_PARTS_DEEPEST_H
#define GJK_SRC_PARTS_DEEPEST_H

#include "gjk_parts_class.h"

// The deepest part so far. The last result is kept beside it, so that the better one is chosen without a copy.
typedef struct gjk_parts_deepest {
  gjk_penetration_result result[2];
  unsigned best;
  uint32_t part, of_b;  // GJK_PARTS_NONE: none yet
  gjk_status status;    // of its query: OK or CAPACITY
  gjk_q16 lower;        // the largest lower bound of all
} gjk_parts_deepest;

void gjk_parts_deepest_start(gjk_parts_deepest *d);

// Asks the parts whose boxes meet the region. number: of B among the parts of its body; else 0.
gjk_status gjk_parts_deepest_ask(gjk_parts_deepest *d, const gjk_parts_frame *frame, const gjk_region *region,
                                 const gjk_collider *b, uint32_t number, const gjk_workspace *workspace);

// Writes the result, and returns its status.
gjk_status gjk_parts_deepest_report(const gjk_parts_deepest *d, gjk_penetration_result *out);

#endif
