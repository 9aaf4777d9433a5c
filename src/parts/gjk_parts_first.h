// The search for the part that is met first on a straight way.
#ifndef GJK_SRC_PARTS_FIRST_H
#define GJK_SRC_PARTS_FIRST_H

#include "gjk_parts_class.h"

// By how much the boxes of ways are enlarged, LSB. It is more than the gap of two shapes at a fraction that is reported
// too early.
//   a cast           2 of gap, 4 of curved shapes; 2^-24 of the margin; a step of the fraction on the longest way: 8
//   a time of impact GJK_PARTS_EARLY comes on top of its tolerance, for poses between
#define GJK_PARTS_EARLY 320

// The first part so far. The last result is kept beside it, so that the better one is chosen without a copy.
typedef struct gjk_parts_first {
  gjk_cast_result result[2];
  unsigned best;
  uint32_t part, of_b;  // GJK_PARTS_NONE: none yet
  gjk_status status;    // OK: a hit. ITERATION_LIMIT: a part that may be met
  bool limited;         // some part reached its ceiling
} gjk_parts_first;

// A cast of one B, or of a ray, against A.
typedef struct gjk_parts_cast_question {
  const gjk_collider *b;      // NULL: a ray
  const gjk_vec3 *from, *to;  // of a ray; else to is where B's position goes, NULL: nowhere
  gjk_long3 way_a;            // of A's position
  bool moves_a;
  gjk_q16 margin;
  uint32_t number;  // of B among the parts of its body; else 0
} gjk_parts_cast_question;

void gjk_parts_first_start(gjk_parts_first *f);

// Asks the parts that may be met before the first one so far. bound: asks only those that reach their ceiling, which
// count if they may be met before the first hit. Needed for each B once the first hit of all is known, if any part is
// limited. Statuses other than OK end the query: RANGE.
gjk_status gjk_parts_first_ask(gjk_parts_first *f, const gjk_parts_frame *frame, const gjk_parts_cast_question *of,
                               bool bound);

// Writes the result, and returns its status.
gjk_status gjk_parts_first_report(const gjk_parts_first *f, gjk_cast_result *out);

#endif
