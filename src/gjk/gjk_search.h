// A query's search: GJK, and once it takes long, GJK that remembers the vertices it has seen.
//
// GJK forgets vertices that it needs again, so its iterations have no useful bound. Polytopes get one from the steps
// below. They begin after GJK_PLAIN_ITERATIONS iterations.
//
//   Step 1   Mark the vertices of A and of B in the feature as seen. If no mark is new, stop: NEAREST (only in far
//            frames).
//   Step 2   Make the feature the nearest one over all differences of a seen vertex of A and a seen vertex of B.
//   Step 3   One iteration of GJK looks for a vertex of A - B strictly nearer along the exact direction. If there is
//            none, the feature is nearest.
//   Step 4   If there is one, its vertex of A or of B was not seen, since by step 2 no difference of seen vertices is
//            nearer. Go on from step 1.
//
// The bound: before the first step 3 a vertex of each shape is marked, and each iteration but the last brings a new
// mark. So shapes of n and m vertices take at most
//   GJK_PLAIN_ITERATIONS + n + m - 1   iterations.
// A shape has GJK_MARKS marks, bits of gjk_iteration.seen. If it has more vertices, neighbours share a mark, and n
// counts marks.
//
// Step 2 runs another GJK among the seen vertices, which has no useful bound either. After GJK_RECALLS_MAX of its steps
// in a query, step 2 tries all features instead, which ends.
#ifndef GJK_SRC_SEARCH_H
#define GJK_SRC_SEARCH_H

#include "gjk_iteration.h"

// A build may define both, so that tests reach the steps above and the trial of all features.
#ifndef GJK_PLAIN_ITERATIONS
#define GJK_PLAIN_ITERATIONS 16
#endif
#ifndef GJK_RECALLS_MAX
#define GJK_RECALLS_MAX 200
#endif

// GJK_ITERATIONS_OF in gjk/format.h is computed from 16.
#if GJK_PLAIN_ITERATIONS < 1 || GJK_PLAIN_ITERATIONS > 100
#error "GJK_PLAIN_ITERATIONS must be from 1 to 100"
#endif

// Two polytopes of any size take fewer iterations.
#define GJK_SEARCH_ITERATIONS_MAX (GJK_PLAIN_ITERATIONS + 2 * GJK_MARKS)

// Eight vertices have fewer features: see gjk_search_any.
#define GJK_ROUND_ITERATIONS 128

// The ceiling on iterations: polytopes end before it, a curved pair may end there with LIMIT.
static inline unsigned gjk_search_limit(const gjk_iteration *it) {
  return gjk_pair_is_curved(it) ? GJK_ITERATIONS_MAX : GJK_SEARCH_ITERATIONS_MAX;
}

// A limit on iterations that leaves gjk_search_limit alone to count.
#define GJK_NO_LIMIT UINT8_MAX

// Steps 1 to 4 until the goal is answered or the iterations of the query reach the limit.
gjk_outcome gjk_search_on(gjk_iteration *it, gjk_goal goal, unsigned limit);

// If several features hold the nearest point, the search may end at any of them. This replaces the simplex, so that all
// that is read of it, except for the certificate, depends on the pair alone. Pre: NEAREST; the goal counts ties.
//
// The level vertices of a shape are those that are exactly as far along the direction as its vertices in the feature.
// The last refinement has counted those beside the first one: its ties. For a box it counts half axes.
//   fewer than two ties     The nearest point lies on a vertex or edge, in which no other feature holds it.
//   two ties, a triangle    The point lies in a triangle or parallelogram. All triangles in it have the same normal,
//                           and the witness points do not depend on which one it is.
//   two ties, a diagonal    A triangle on either side of the diagonal holds it as well. One of them is taken.
//   others                  The shapes have parallel edges or faces; or vertices coincide. GJK begins once more, among the
//                           level vertices alone, from the first one of each shape. The direction is that of a box's level
//                           face, if there is one.
// points: must the vertices be canonical too? If not, and the direction is a face's, the search is left out, and the
// result is false.
bool gjk_search_canonical(gjk_iteration *it, bool points);

// May several features hold the nearest point?
static inline bool gjk_search_has_ties(const gjk_iteration *it, gjk_goal goal, gjk_outcome outcome) {
  return GJK_SHAPES >= GJK_SHAPES_ROUND && outcome == GJK_OUTCOME_NEAREST && gjk_goal_counts_ties(it, goal) &&
         it->ties[0] + it->ties[1] > 1;
}

// Do the shapes have a closed form? It needs no feature to start from.
static inline bool gjk_search_may_close(const gjk_iteration *it) {
  return it->a->shape->type->close != NULL && it->a->shape->type->close == it->b->shape->type->close;
}

// Does a closed form find the feature? It rounds nothing in exact frames. For WITHIN a separating plane answers sooner.
bool gjk_search_closes(gjk_iteration *it, gjk_goal goal);

// The search for two points, where A - B is one vertex. It counts as many iterations as the other searches.
gjk_outcome gjk_search_points(gjk_iteration *it, gjk_goal goal, unsigned limit);

// Searches until the goal is answered or the iterations of the query reach the limit. After LIMIT, a call with a higher
// limit goes on. cache: for a warm start; if it is NULL or of no use, the start is cold. NEAREST: any feature that
// holds the nearest point.
//
// If all shapes are points and segments, steps 1 to 4 are not needed. A - B of two has four vertices at most, and eight
// if one is swept (gjk_swept.h). Each iteration but the last finds a feature strictly nearer than all before. Eight
// vertices have 8 + 28 + 56 features.
static inline gjk_outcome gjk_search_any(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache, unsigned limit) {
  const unsigned of_polytopes = GJK_SHAPES <= GJK_SHAPES_ROUND ? GJK_ROUND_ITERATIONS : GJK_PLAIN_ITERATIONS;
  const unsigned most = gjk_pair_is_curved(it) ? GJK_ITERATIONS_MAX : of_polytopes;
  const unsigned plain = limit < most ? limit : most;
  const bool may_close = GJK_SHAPES >= GJK_SHAPES_BOXES || goal != GJK_GOAL_WITHIN;
  gjk_outcome outcome = GJK_OUTCOME_LIMIT;
#if GJK_SHAPES <= GJK_SHAPES_POINTS
  return gjk_search_points(it, goal, limit);
#endif
  if (it->iterations < plain) {
    if (may_close && it->iterations == 0 && (GJK_SHAPES <= GJK_SHAPES_ROUND || it->a->shape->type->close != NULL) &&
        gjk_search_closes(it, goal)) {
      return GJK_OUTCOME_NEAREST;
    }
#if GJK_SHAPES <= GJK_SHAPES_ROUND
    if (goal != GJK_GOAL_WITHIN && it->iterations == 0 && cache != NULL && gjk_iteration_warm(it, cache)) {
      return GJK_OUTCOME_ENCLOSING;
    }
#endif
    it->limit = (uint8_t)plain;
    outcome = gjk_iteration_run(it, goal, cache);
  }
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && outcome == GJK_OUTCOME_LIMIT && !gjk_pair_is_curved(it)) {
    outcome = gjk_search_on(it, goal, limit);
  }
  return outcome;
}

// The same without a limit, for callers to which all nearest features are the same. Points and segments then do without
// the closed form, which only callers with a limit need. A build for size has one copy, in gjk_search.c.
#if GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_BOXES
gjk_outcome gjk_search_whole(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache);
#else
static inline gjk_outcome gjk_search_whole(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache) {
  if (GJK_SHAPES == GJK_SHAPES_ROUND) {
    it->limit = GJK_ROUND_ITERATIONS;
    return gjk_iteration_run(it, goal, NULL);
  }
  return gjk_search_any(it, goal, cache, GJK_NO_LIMIT);
}
#endif

// gjk_search_any for what is reported, which is the canonical feature.
static inline gjk_outcome gjk_search(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache, unsigned limit) {
  const gjk_outcome outcome = gjk_search_any(it, goal, cache, limit);
  if (gjk_search_has_ties(it, goal, outcome)) {
    (void)gjk_search_canonical(it, true);
  }
  return outcome;
}

#endif
