// The GJK iteration on one pair of colliders. Every query is built on it. gjk_iteration.c has the steps, gjk_frame.h
// the integers that they compute on.
#ifndef GJK_SRC_ITERATION_H
#define GJK_SRC_ITERATION_H

#include "../shape/gjk_shape_class.h"
#include "gjk/cache.h"
#include "gjk/certificate.h"
#include "gjk_simplex.h"

typedef enum gjk_outcome {
  GJK_OUTCOME_NEAREST,    // the feature is the one of A - B nearest to the origin
  GJK_OUTCOME_ENCLOSING,  // the origin lies in the simplex: the cores intersect
  GJK_OUTCOME_SEPARATED,  // the whole of A - B is more than radius away from the origin, measured along direction
  GJK_OUTCOME_NEAR,       // the feature is within radius of the origin
  GJK_OUTCOME_LIMIT       // open: the limit on iterations is reached
} gjk_outcome;

// The support point of a curved pair is at most this far below the true support plane, in LSB.
#define GJK_CURVED_ERROR 2

// What is asked, and the outcomes that answer it. LIMIT is possible with every goal.
typedef enum gjk_goal {
  GJK_GOAL_DISTANCE,  // NEAREST, ENCLOSING or NEAR
  GJK_GOAL_WITHIN,    // NEAREST, ENCLOSING, SEPARATED or NEAR
  GJK_GOAL_DEPTH,     // NEAREST, ENCLOSING or SEPARATED
  GJK_GOAL_SIGNED     // NEAREST or ENCLOSING
} gjk_goal;

// Is SEPARATED an answer to the goal?
static inline bool gjk_goal_separates(gjk_goal goal) {
  return goal == GJK_GOAL_WITHIN || goal == GJK_GOAL_DEPTH;
}

// Is NEAR an answer to the goal?
static inline bool gjk_goal_nears(gjk_goal goal) {
  return goal <= GJK_GOAL_WITHIN;
}

// Marks of vertices: a box has 8 of them, and swept along a way 16 (gjk_swept.h).
#if GJK_SHAPES <= GJK_SHAPES_BOXES
typedef uint16_t gjk_marks;
#define GJK_MARKS 16
#else
typedef uint64_t gjk_marks;
#define GJK_MARKS 64
#endif

typedef struct gjk_iteration {
  const gjk_collider *a, *b;
  gjk_vec3 delta;                  // frame: centre_a - centre_b
  int32_t radius;                  // frame: up to this distance of the cores the shapes count as near
  int8_t shift;                    // frame: 2^shift of its units are an LSB
  uint8_t iterations;              // so far
  uint8_t limit;                   // on iterations
  uint8_t recalls;                 // the search's: steps among the seen vertices so far
  gjk_marks seen[2];               // the search's: marks of the seen vertices of A and of B
  unsigned ties[2];                // gjk_direction.ties of A and of B in the last refinement
  bool scans;                      // a cached feature is confirmed by a scan along d first; not in builds for size
  bool diagonal;                   // the nearest point lies on the edge of the triangle's first two vertices
  gjk_search_direction direction;  // of the last support scan
  // gjk_shape_class.stalls of a shape of the pair that is curved; NULL: both are polytopes.
  bool (*stalls)(const gjk_vec3 *, const gjk_vec3 *, const gjk_vec3 *, int, bool);
  gjk_simplex simplex;
} gjk_iteration;

// Is A or B curved?
static inline bool gjk_pair_is_curved(const gjk_iteration *it) {
  return GJK_SHAPES >= GJK_SHAPES_ALL && it->stalls != NULL;
}

// Is a NEAREST feature of the pair made canonical? It is if a cache may have led to another feature.
static inline bool gjk_goal_counts_ties(const gjk_iteration *it, gjk_goal goal) {
  return goal != GJK_GOAL_WITHIN && it->shift >= 0 && !gjk_pair_is_curved(it);
}

// Starts cold: sets the frame, and no vertex is in the simplex.
// radius: both convex radii and the distance asked about, Q16.16, not negative.
// False: the bounding spheres are more than radius apart, and only a and b are set. Tested only if SEPARATED answers
// the goal.
bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius);

// Support scan: puts the vertex of A - B farthest along it->direction into the free slot. *b: its vertex of B.
void gjk_iteration_next(gjk_iteration *it, gjk_support *b);

// Replaces the vertex of the last support scan by the one farthest along the exact direction, of which it->direction is
// the rounded one. Returns whether that is another vertex. Marks the direction as opposite when B has been asked.
bool gjk_iteration_refine(gjk_iteration *it, gjk_direction *direction, gjk_support *b);

// Puts the vertex number a of A less the vertex number b of B into the free slot. False: one of them does not exist.
bool gjk_iteration_place(gjk_iteration *it, uint16_t a, uint16_t b);

// Iterates until the goal is answered or it->limit is reached; after LIMIT, a call with a higher limit goes on.
// cache: for a warm start; if it is NULL or of no use, the start is cold.
gjk_outcome gjk_iteration_run(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache);

// Step 1 by itself, for builds with points and segments alone. There gjk_iteration_run ignores the cache, since only
// times of impact gain by it. Returns whether the origin lies in the simplex already.
bool gjk_iteration_warm(gjk_iteration *it, const gjk_cache *cache);

// Is the exact distance of the feature at most it->radius? Pre: 1 <= count <= 3.
bool gjk_iteration_near(const gjk_iteration *it);

// Writes the certificate of an outcome, and what the cache keeps of it for the next query.
void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out);
void gjk_iteration_keep(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache);

#endif
