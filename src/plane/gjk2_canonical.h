// Which feature is reported where several hold the nearest point.
#ifndef GJK2_SRC_CANONICAL_H
#define GJK2_SRC_CANONICAL_H

#include "gjk2_search.h"

// Makes the feature one that depends on the pair alone: the whole edge of A - B that holds the nearest point within, or its end.
// Pre: a search has ended NEAREST; polygons, in a near frame.
void gjk2_search_canonical(gjk2_search *s);

// As gjk2_search_run, for goals that report a feature: a canonical one.
static inline gjk2_outcome gjk2_search_feature(gjk2_search *s, gjk2_goal goal, uint32_t limit) {
  const gjk2_outcome outcome = gjk2_search_run(s, goal, limit);
  if (outcome == GJK2_OUTCOME_NEAREST && gjk2_search_is_exact(s)) {
    gjk2_search_canonical(s);
  }
  return outcome;
}

// The same without a search: NEAREST or ENCLOSING; LIMIT, and nothing is set, where the shapes do not allow it.
// Pre: the search has just been started.
static inline gjk2_outcome gjk2_search_close(gjk2_search *s) {
  const gjk2_shape_class *of_a = s->a->shape->type, *of_b = s->b->shape->type;
  const gjk2_shape_class *type = of_a->close != NULL ? of_a : of_b;
  return type->close != NULL && gjk2_search_is_exact(s) ? type->close(s) : GJK2_OUTCOME_LIMIT;
}

#endif
