// A query's search: GJK, and once it takes long, GJK that remembers the vertices it has seen.
//
// GJK forgets vertices that it needs again, so how many iterations it takes has no bound of use. After GJK_PLAIN_ITERATIONS of
// them this happens to polytopes:
//   1 The vertices of A and of B in the feature are marked as seen.
//   2 The feature is made nearest to the origin over all differences of seen vertices.
//   3 A round of GJK looks for a vertex of A - B strictly nearer along the exact direction. None: the feature is nearest.
//   4 Otherwise that vertex of A or that of B was not seen before: by 2 no difference of seen ones is nearer. On from 1.
// Each round but the last marks a vertex, and one of each shape is marked before the first. So for shapes of n and m vertices
// there are at most GJK_PLAIN_ITERATIONS + n + m - 1 iterations. Beyond GJK_MARKS vertices of a shape neighbours share a mark, and
// are seen together; then n or m is GJK_MARKS here.
//
// Step 2 is GJK among the seen vertices. Its steps are counted as well, and after GJK_RECALLS_MAX of them in a query all
// features are tried instead, which surely ends.
#ifndef GJK_SRC_SEARCH_H
#define GJK_SRC_SEARCH_H

#include "gjk_iteration.h"

// A build may define both, to test what follows.
#ifndef GJK_PLAIN_ITERATIONS
#define GJK_PLAIN_ITERATIONS 16
#endif
#ifndef GJK_RECALLS_MAX
#define GJK_RECALLS_MAX 200
#endif

// GJK_ITERATIONS_OF of gjk/format.h counts on 16.
#if GJK_PLAIN_ITERATIONS < 1 || GJK_PLAIN_ITERATIONS > 100
#error "GJK_PLAIN_ITERATIONS must be from 1 to 100"
#endif

#define GJK_MARKS 64

// The ceiling on the iterations of any query; that of curved shapes is no bound.
#define GJK_SEARCH_ITERATIONS_MAX (GJK_PLAIN_ITERATIONS + 2 * GJK_MARKS)

static inline unsigned gjk_search_limit(const gjk_iteration *it) {
  return gjk_pair_is_curved(it) ? GJK_ITERATIONS_MAX : GJK_SEARCH_ITERATIONS_MAX;
}

// As a limit: no other than that.
#define GJK_NO_LIMIT UINT8_MAX

// Iterations that remember, up to the limit in all.
gjk_outcome gjk_search_on(gjk_iteration *it, gjk_goal goal, unsigned limit);

// Runs from the cache, or cold when it is NULL or useless; after LIMIT and with a higher limit on iterations, on from there.
// Polytopes do not reach gjk_search_limit.
static inline gjk_outcome gjk_search(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache, unsigned limit) {
  const unsigned most = gjk_pair_is_curved(it) ? GJK_ITERATIONS_MAX : GJK_PLAIN_ITERATIONS;
  const unsigned plain = limit < most ? limit : most;
  gjk_outcome outcome = GJK_OUTCOME_LIMIT;
  if (it->iterations < plain) {
    it->limit = (uint8_t)plain;
    outcome = gjk_iteration_run(it, goal, cache);
  }
  return outcome == GJK_OUTCOME_LIMIT && !gjk_pair_is_curved(it) ? gjk_search_on(it, goal, limit) : outcome;
}

#endif
