// The GJK iteration of the plane on one pair of colliders. Every query is built on it. gjk2_search.c has its steps and
// the bound on their number.
//
// The frame. A vertex w of A - B stands relative to the origin of the question "is 0 in A - B?", in LSB:
//   centres at most 2^30 apart:   |w| <= 2^30 + 2^29 = 3 2^29, exact
//   farther apart:                w / 2^far, 1 <= far <= 3, to the nearest, with the centres at most 2^30 + 2 apart
// Edges, differences of two vertices, are at most 2^30 long. So products of a vertex and an edge or a vertex are below
// 9 2^58 < 2^62, their sums of two below 2^63: 64 bits hold every sign. Nothing is rounded in a near frame: the
// direction across an edge is an integer vector.
#ifndef GJK2_SRC_SEARCH_H
#define GJK2_SRC_SEARCH_H

#include "gjk2/cache.h"
#include "gjk2/certificate.h"
#include "gjk2_class.h"
#include "gjk2_measure.h"

typedef enum gjk2_outcome {
  GJK2_OUTCOME_NEAREST,    // the feature is the one of A - B nearest to the origin
  GJK2_OUTCOME_ENCLOSING,  // the origin lies in the simplex: the cores intersect
  GJK2_OUTCOME_SEPARATED,  // the whole of A - B is more than radius away from the origin, measured along d
  GJK2_OUTCOME_NEAR,       // the feature is within radius of the origin
  GJK2_OUTCOME_LIMIT       // open: the limit on iterations is reached
} gjk2_outcome;

// The support point of a curved pair is at most this far below the true support line, in LSB.
#define GJK2_CURVED_ERROR 2

// What is asked, and the outcomes that answer it. LIMIT is possible with every goal.
typedef enum gjk2_goal {
  GJK2_GOAL_DISTANCE,  // NEAREST, ENCLOSING or NEAR
  GJK2_GOAL_WITHIN,    // NEAREST, ENCLOSING, SEPARATED or NEAR
  GJK2_GOAL_DEPTH,     // NEAREST, ENCLOSING or SEPARATED
  GJK2_GOAL_SIGNED     // NEAREST or ENCLOSING
} gjk2_goal;

// A vertex of A - B.
typedef struct gjk2_vertex {
  gjk2_vec w;         // frame
  gjk2_support a, b;  // the vertices of A and of B
} gjk2_vertex;

static inline void gjk2_copy_vertex(gjk2_vertex *to, const gjk2_vertex *from) {
  gjk2_copy(&to->w, &from->w);
  gjk2_copy_support(&to->a, &from->a);
  gjk2_copy_support(&to->b, &from->b);
}

typedef struct gjk2_search {
  const gjk2_collider *a, *b;
  gjk2_vec delta;       // near frame: centre_a - centre_b
  gjk2_vec d;           // direction of the last support scan; after NEAREST and NEAR, from the feature to the origin
  int64_t base;         // of the feature: w . w2 for w2 turned by a quarter, or -w . w: d . w of its vertices
  int64_t along;        // d . w of the last support scan
  int32_t radius;       // frame: up to this distance of the cores the shapes count as near
  uint16_t iterations;  // so far
  uint8_t far;
  uint8_t count;  // vertices that span the feature, or with ENCLOSING the simplex
  bool curved;
  bool warm;  // the feature is the cache's, and not yet tried
  // Polygons in order, in a near frame: the first vertex is followed by a walk, of as many iterations as it takes.
  bool walks;
  bool whole;  // the walk has seen that the feature is canonical, of two polygons with area (gjk2_canonical.c)
  // Of one vertex: the feature is apex, and first and last bracket it, or are not set (alone). Of two: first and last.
  // Of three: first, apex and last. The fourth is spare.
  bool alone;
  gjk2_vertex *first, *apex, *last, *spare;
  gjk2_vertex slot[4];
} gjk2_search;

// Starts cold: sets the frame, and no vertex is in the feature. The first direction is that between the centres.
// radius: both convex radii and the distance asked about, Q16.16.
// circles: False is returned where the bounding circles are more than radius apart; then only a and b are set.
bool gjk2_search_start(gjk2_search *s, const gjk2_collider *a, const gjk2_collider *b, bool circles, uint32_t radius);

// Are the centres near enough, surely, for a frame without scaling? Then components of centre_a - centre_b are at most
// 2^29 + 3 in size, and it is shorter than 2^30.
static inline bool gjk2_frame_is_near(const gjk2_collider *a, const gjk2_collider *b) {
  // A quarter of centre_a - centre_b: each component below 2^30, and off by less than 1.
  const int32_t x = gjk_sar32(a->centre.x, 2) - gjk_sar32(b->centre.x, 2);
  const int32_t y = gjk_sar32(a->centre.y, 2) - gjk_sar32(b->centre.y, 2);
  // Bit 27 or a higher one differs from the sign: that component is not from -2^27 to below 2^27.
  return ((uint32_t)(x ^ gjk_sar32(x, 31)) | (uint32_t)(y ^ gjk_sar32(y, 31))) >> 27 == 0;
}

// One coordinate of a vertex in a far frame: (a - b + offset) / 2^far, rounded to the nearest.
int32_t gjk2_frame_far(gjk_q16 a, gjk_q16 b, int32_t offset, unsigned far);

// Any direction serves if that between the centres is 0.
static inline void gjk2_search_need_direction(gjk2_search *s) {
  if ((s->d.x | s->d.y) == 0) {
    s->d.x = 1;
  }
}

// Sets the first direction anew, from the cache where it serves.
void gjk2_search_aim(gjk2_search *s, const gjk2_cache *cache);

// Iterates until the goal is answered or the iterations of the query reach the limit; after LIMIT and with a higher
// limit, on from there. GJK2_NO_LIMIT: none but gjk2_search_limit.
#define GJK2_NO_LIMIT UINT32_MAX
gjk2_outcome gjk2_search_run(gjk2_search *s, gjk2_goal goal, uint32_t limit);

// The ceiling on iterations: polygons end before it, a curved pair may end there with LIMIT.
static inline uint32_t gjk2_search_limit(const gjk2_search *s) {
  return s->curved ? GJK_ITERATIONS_MAX : GJK2_ITERATIONS_OF((uint32_t)s->a->count, (uint32_t)s->b->count);
}

// Support scan along d, at most 3 2^29 long: the vertex of A - B farthest along it.
void gjk2_search_scan(const gjk2_search *s, gjk2_vec d, gjk2_vertex *out);

// The difference of the vertices with these numbers. False: one of them does not exist.
bool gjk2_search_place(const gjk2_search *s, uint16_t a, uint16_t b, gjk2_vertex *out);

// Sets d to the direction from the feature to the origin, of which base is known. Pre: count is 1 or 2.
static inline void gjk2_search_direct(gjk2_search *s) {
  s->d = GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 2 ? gjk2_outward(gjk2_sub(s->last->w, s->first->w))
                                                         : gjk2_negate(s->apex->w);
  //@ assert s->d.x >= -(INT32_C(3) << 29) && s->d.x <= INT32_C(3) << 29;
  //@ assert s->d.y >= -(INT32_C(3) << 29) && s->d.y <= INT32_C(3) << 29;
}

// The feature's vertices: one or two, or after ENCLOSING three.
static inline const gjk2_vertex *gjk2_search_vertex(const gjk2_search *s, unsigned i) {
  return GJK_SHAPES <= GJK_SHAPES_POINTS || s->count == 1 ? s->apex
         : i == 0                                         ? s->first
         : i == 1 && s->count == 3                        ? s->apex
                                                          : s->last;
}

// Writes the certificate of an outcome, and what the cache keeps of it for the next query.
void gjk2_search_certify(const gjk2_search *s, gjk2_outcome outcome, gjk2_certificate *out);
void gjk2_search_keep(const gjk2_search *s, gjk2_outcome outcome, gjk2_cache *cache);

// Sets the cached direction: the leading bits of d.
static inline void gjk2_cache_direction(gjk2_cache *cache, gjk2_vec d) {
  const unsigned zeros = gjk_clz32(gjk_magnitude32(d.x) | gjk_magnitude32(d.y) | 1);
  const unsigned down = zeros < 17 ? 17 - zeros : 0;
  cache->direction[0] = (int16_t)gjk_sar32(d.x, down);
  cache->direction[1] = (int16_t)gjk_sar32(d.y, down);
}

// Is A - B a single point, that of two circles, in a near frame?
static inline bool gjk2_search_is_point(const gjk2_search *s) {
  return s->a->count == 1 && s->b->count == 1 && s->far == 0;
}

// Are both shapes polygons, in a near frame? Then nothing is rounded.
static inline bool gjk2_search_is_exact(const gjk2_search *s) {
  return s->far == 0 && !s->curved;
}

// The sum of both convex radii, LSB.
static inline int32_t gjk2_convex_radii(const gjk2_search *s) {
  return s->a->shape->convex_radius + s->b->shape->convex_radius;
}

#endif
