// Brackets the fraction of a cast with a rounded or curved shape, or with a margin.
#ifndef GJK_SRC_ADVANCE_H
#define GJK_SRC_ADVANCE_H

#include "../arith/gjk_ceilings.h"
#include "gjk_way.h"

// What the rounds prove.
typedef enum gjk_advance_answer {
  GJK_ADVANCE_MISS,    // the gap stays above the margin on the whole way
  GJK_ADVANCE_INSIDE,  // it is at most the margin at the start
  GJK_ADVANCE_START,   // of polytopes alone: at the start it is the margin, to 2^-24 of a margin above 8000 units
  GJK_ADVANCE_HIT,     // it is at most the margin somewhere; of curved pairs as gjk_cast decides
  GJK_ADVANCE_OPEN,  // of polytopes alone: the way grazes, or ends, within 2 LSB of the margin. As of a hit, if it is one
  GJK_ADVANCE_LIMIT  // a ceiling is reached: up to the fraction the gap is above the margin
} gjk_advance_answer;

// Brackets the fraction of a cast with a convex radius, a margin or a curved shape.
//
// out   HIT, START, OPEN, LIMIT: inside, fraction, points, normal, rests, saturated, as gjk_cast has them. For LIMIT
//       the points and the normal are those of the last round. Always: iterations. All else is the caller's.
gjk_advance_answer gjk_advance(const gjk_collider *a, const gjk_collider *b, const gjk_way *way, gjk_q16 margin,
                               gjk_cast_result *out);

#endif
