// Which feature is reported if several hold the nearest point.
#ifndef GJK2_SRC_CANONICAL_H
#define GJK2_SRC_CANONICAL_H

#include "gjk2_search.h"

// Makes the feature depend on the pair alone: the whole edge of A - B that holds the nearest point inside, or its end.
// Pre: a search has ended NEAREST; polygons, in a near frame.
void gjk2_search_canonical(gjk2_search *s);

// As gjk2_search_run, for goals that report a feature: a canonical one.
static inline gjk2_outcome gjk2_search_feature(gjk2_search *s, gjk2_goal goal, uint32_t limit) {
  const gjk2_outcome outcome = gjk2_search_run(s, goal, limit);
  const bool whole = !GJK_SMALL && s->whole;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && outcome == GJK2_OUTCOME_NEAREST && !whole && gjk2_search_is_exact(s)) {
    gjk2_search_canonical(s);
  }
  return outcome;
}

#endif
