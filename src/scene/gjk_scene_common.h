// What the records of a scene's block have in common in space and in the plane.
#ifndef GJK_SRC_SCENE_COMMON_H
#define GJK_SRC_SCENE_COMMON_H

#include "../arith/gjk_hash.h"
#include "../arith/gjk_wide.h"
#include "gjk/body.h"
#include "gjk/status.h"

// A function of a header that goes in line. Where GJK_SMALL is 1, the compiler decides.
#if GJK_SMALL
#define GJK_SCENE_IN_LINE static inline
#else
#define GJK_SCENE_IN_LINE GJK_ONCE static
#endif

// A node of the tree is one number: a part's index with this bit set, or an inner node's index.
#define GJK_SCENE_LEAF UINT32_C(0x80000000)

// Room for a walk over the tree, which puts off one sibling per level. Heights of siblings differ by at most 1, so 2^20
// leaves are at most 1.45 * 20 = 29 deep.
#define GJK_SCENE_DEPTH 32

// The motion of a part that nothing bounds: it is new, has another shape, jumped, or its pairs are to be filtered
// again.
#define GJK_SCENE_UNBOUNDED UINT32_MAX

// gjk_scene_body.flags
#define GJK_SCENE_ASLEEP 1u
#define GJK_SCENE_MOVED 2u  // in the list of bodies that changed since the last update, header.moved
#define GJK_SCENE_KEPT 4u   // has a record of its motion
#define GJK_SCENE_FAST 8u   // and is swept

// gjk_scene_kept.state
#define GJK_SCENE_SWEPT 1u     // in the update under way
#define GJK_SCENE_UNPROVEN 2u  // and a query did not settle

// gjk_scene_part.state
#define GJK_SCENE_LIVE 1u
#define GJK_SCENE_PAIRS_STALE 2u  // some pairs whose enlarged boxes meet may be missing, and others may be left
#define GJK_SCENE_MARK 4u         // has a pair with the part whose pairs are being made

// The body turned since the part was posed: centre, fraction and frame are of an earlier rotation. exact holds the part,
// but need not be its least box. Parts with pairs are posed again when an update begins.
#define GJK_SCENE_UNPOSED 8u

// gjk_scene_pair.state; the upper three bits count the cached vertices.
#define GJK_SCENE_PAIR_LIVE 1u
#define GJK_SCENE_PAIR_NEAR 2u      // near at the last update
#define GJK_SCENE_PAIR_QUEUED 4u    // to be tested in the update under way
#define GJK_SCENE_PAIR_NEAR_NOW 8u  // the test found it near
#define GJK_SCENE_PAIR_GONE 16u     // one of its bodies was removed; its end is still to be reported
#define GJK_SCENE_PAIR_CACHED 5u    // shift

// gjk_scene_pair.outcome: flags beside a gjk_scene_outcome or gjk_event.
#define GJK_SCENE_NO_FLAG 64u  // never set
#define GJK_SCENE_TOLD 128u  // what its last report said still holds: since then no call moved or changed a body of it

// What a report says of one side of a pair, and what orders reports.
typedef struct gjk_scene_side {
  uint32_t slot, generation;
  uint16_t part;
} gjk_scene_side;

// What settled a pair. FILTERED to COLD are in the order of their counters in gjk_scene_stats.
typedef enum gjk_scene_outcome {
  GJK_SCENE_PENDING = 0,
  GJK_SCENE_FILTERED,
  GJK_SCENE_MOTION,
  GJK_SCENE_BOXES,
  GJK_SCENE_DIRECTION,
  GJK_SCENE_WARM,
  GJK_SCENE_COLD,
  GJK_SCENE_OUTCOMES,
  GJK_SCENE_UNSETTLED = 16,  // flag
  GJK_SCENE_MEASURED = 32    // flag: the distance or depth was found
} gjk_scene_outcome;

// Records of one size. A pool hands out the record that was given back last, or else the next one that was never used.
typedef struct gjk_scene_pool {
  uint32_t at;  // bytes from the start of the block
  uint32_t capacity;
  uint32_t fresh;  // records from here on were never used
  uint32_t free;   // first free record below fresh, or none
  uint32_t count;  // records in use
} gjk_scene_pool;

typedef enum gjk_scene_phase {
  GJK_SCENE_IDLE = 0,
  GJK_SCENE_TESTING,   // the queue holds the pairs to be tested; those before next_test are done
  GJK_SCENE_REPORTING  // the queue holds the pairs to be reported, in order; those from next_report on are left
} gjk_scene_phase;

// The larger of gap and the gap of two intervals, which is 0 when they meet; below 2^32.
static inline uint32_t gjk_larger_gap(uint32_t gap, gjk_q16 lower_a, gjk_q16 upper_a, gjk_q16 lower_b,
                                      gjk_q16 upper_b) {
  const uint32_t apart = lower_a > upper_b   ? (uint32_t)lower_a - (uint32_t)upper_b
                         : lower_b > upper_a ? (uint32_t)lower_b - (uint32_t)upper_a
                                             : 0;
  return apart > gap ? apart : gap;
}

// An eighth of one side of a box:  < 2^29
static inline uint32_t gjk_scene_side_cost(int32_t lower, int32_t upper) {
  return ((uint32_t)upper - (uint32_t)lower) >> 3;
}

// |a - b|, below 2^32.
static inline uint32_t gjk_scene_difference(int32_t a, int32_t b) {
  return a > b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

// An upper bound of the length of a vector, from the sum of its components and the largest one, a.
//
// With the other components b, c <= a:  (a + b/2 + c/2)^2 >= a^2 + a b + a c >= a^2 + b^2 + c^2
// In three dimensions the bound is at most a fifth too long. Pre: sum < 2^32.
static inline uint32_t gjk_scene_length_bound(uint32_t sum, uint32_t largest) {
  return sum / 2 + largest / 2 + 1;
}

static inline uint32_t gjk_scene_larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

// x + step, which fits: gjk_scene_part_carries
static inline int32_t gjk_scene_plus(int32_t x, int32_t step) {
  return gjk_int32((uint32_t)x + (uint32_t)step);
}

static inline int32_t gjk_scene_lower_by(int32_t x, gjk_q16 margin) {
  return x < INT32_MIN + margin ? INT32_MIN : x - margin;
}

static inline int32_t gjk_scene_higher_by(int32_t x, gjk_q16 margin) {
  return x > INT32_MAX - margin ? INT32_MAX : x + margin;
}

// Grows a box along one axis: by margin at both sides, and by step on the side that step points to.
GJK_SCENE_IN_LINE void gjk_scene_grow_side(gjk_q16 *lower, gjk_q16 *upper, int32_t margin, int32_t step) {
  const int32_t least = gjk_scene_lower_by(*lower, margin), back = step < 0 ? step : 0;
  *lower = least < INT32_MIN - back ? INT32_MIN : least + back;
  *upper = gjk_scene_higher_by(gjk_scene_higher_by(*upper, margin), step > 0 ? step : 0);
}

#endif
