// The GJK iteration on one pair of colliders: what every query is made of.
//
// Frame of the pair: vertices w of A - B are taken relative to the origin of the question "where is 0?" and
// multiplied by 2^shift, so that the filters on high words settle nearly every sign. With the reach
// W0 = |centre_a - centre_b| + core_radius_a + core_radius_b:
//   W0 < 2^30    shift >= 0 with 2^shift W0 < 2^30: |w| < 2^30, edges below 2^31
//   near         shift = 0: |centre_a - centre_b| <= 2^30, so |w| <= 3 2^29 and edges at most 2^30
//   far          shift < 0: centres rounded to 2^-shift LSB and at most 2^30 apart in that unit; w rounded to nearest;
//                the gap is above 2^29 LSB and the rounding moves it by at most 2^-28 of itself
#ifndef GJK_SRC_ITERATION_H
#define GJK_SRC_ITERATION_H

#include "../shape/gjk_shape_class.h"
#include "gjk/cache.h"
#include "gjk/certificate.h"
#include "gjk_simplex.h"

typedef enum gjk_outcome {
  GJK_OUTCOME_NEAREST,    // the feature is nearest to the origin
  GJK_OUTCOME_ENCLOSING,  // the origin lies in the simplex: the cores intersect
  GJK_OUTCOME_SEPARATED,  // every w is farther than radius, along direction
  GJK_OUTCOME_NEAR,       // the feature comes within radius
  GJK_OUTCOME_LIMIT       // the limit on iterations
} gjk_outcome;

// How far the support points of a curved pair may stay behind its surface, LSB.
#define GJK_CURVED_ERROR 2

typedef enum gjk_goal {
  GJK_GOAL_DISTANCE,  // NEAREST, ENCLOSING or NEAR
  GJK_GOAL_WITHIN,    // any
  GJK_GOAL_DEPTH,     // NEAREST, ENCLOSING or SEPARATED
  GJK_GOAL_SIGNED     // NEAREST or ENCLOSING
} gjk_goal;

// Does the goal stop at the first separating direction? And as soon as the feature is near?
static inline bool gjk_goal_separates(gjk_goal goal) {
  return goal == GJK_GOAL_WITHIN || goal == GJK_GOAL_DEPTH;
}

static inline bool gjk_goal_nears(gjk_goal goal) {
  return goal <= GJK_GOAL_WITHIN;
}

typedef struct gjk_iteration {
  const gjk_collider *a, *b;
  gjk_vec3 delta;  // from B's centre to A's, in the frame of the pair
  int32_t radius;  // what counts as near, there
  int8_t shift;
  uint8_t iterations;
  uint8_t limit;    // on iterations
  uint8_t recalls;  // what gjk_search remembers: see there
  uint64_t seen[2];
  gjk_search_direction direction;  // of the last support
  // Of one of the two that has no vertices, see gjk_shape_class.stalls; NULL: both have.
  bool (*stalls)(const gjk_vec3 *, const gjk_vec3 *, const gjk_vec3 *, int, bool);
  gjk_simplex simplex;
} gjk_iteration;

// Is one of the two shapes curved?
static inline bool gjk_pair_is_curved(const gjk_iteration *it) {
  return it->stalls != NULL;
}

// Sets the frame of the pair; radius is the sum of the roundings and the asked distance, Q16.16, not negative.
// False: the bounding spheres are more than radius apart (asked only where the goal separates); only a, b are set.
bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius);

// Fills the simplex's free slot with the farthest vertex of A - B along the direction, made of A's and of *b.
void gjk_iteration_next(gjk_iteration *it, gjk_support *b);

// Moves that vertex to the farthest along the exact direction, of which it->direction is the rounded one. Returns whether
// it moved.
bool gjk_iteration_refine(gjk_iteration *it, gjk_direction *direction, gjk_support *b);

// Fills the free slot with the vertex of A - B of these numbers; false: there is none.
bool gjk_iteration_place(gjk_iteration *it, uint16_t a, uint16_t b);

// Runs from the cache, or cold when it is NULL or useless; after LIMIT and with a higher limit, on from there.
gjk_outcome gjk_iteration_run(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache);

// Is the feature's exact distance at most radius? Pre: 1 <= count <= 3.
bool gjk_iteration_near(const gjk_iteration *it);

// What a query reports and keeps of an iteration.
void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out);
void gjk_iteration_keep(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache);

#endif
