// Which parts in the tree a box meets on a straight way.
//
// 1. For each axis, take the reciprocal of the way once. Then a plane's fraction of the way is one product.
// 2. Each fraction is rounded down, by less than 2^-14 of itself and 2 steps of 2^-30. Where the box leaves, that is
//    added. So no box that is met is left out, and none counts as met later than it is.
// 3. Of two children, the one that is met sooner is looked at first. What is met later than latest is left out.
//
// A box inside another one is met no sooner. So whether a part is found, and from where on, depends on its own exact box
// alone, not on the tree.
#ifndef GJK_SRC_SCENE_PASSAGE_H
#define GJK_SRC_SCENE_PASSAGE_H

#include "gjk_scene_tree.h"

// By how much boxes of ways are enlarged. It is more than a reported fraction may be too early.
//
// a cast       2 LSB of gap, 4 with curved shapes; a step of the fraction where the way is long, 4
// an impact    its tolerance: at most 16 LSB and 2^-23 of the 2^30 LSB that two shapes reach, and rounding of poses
#define GJK_SCENE_EARLY 192

// One axis of a way. Where it leads down, all coordinates are complemented, ~x, so that it leads up: that turns their
// order round and stays in int32.
typedef struct gjk_scene_axis {
  int32_t mirror;        // 0 or -1: coordinates x count as x ^ mirror
  int32_t lower, upper;  // what the box spans at the start; cut off at the ends of int32
  uint32_t length;       // of the way
  uint32_t leaving;      // the same, 0 where lower is cut off: then the box does not leave anything
  uint32_t inverse;      // 2^32 / (the upper 16 bits of 2^scale length + 1), rounded down
  uint32_t scale;        // 2^scale length has its highest bit set
} gjk_scene_axis;

// At most this many parts are known to be near.
#define GJK_SCENE_NEAR 8

typedef struct gjk_scene_passage {
  gjk_scene_axis axis[GJK_SCENE_AXES];
  uint32_t latest;                    // Q30
  uint32_t waiting[GJK_SCENE_DEPTH];  // nodes, as in gjk_scene_walk
  uint32_t entered[GJK_SCENE_DEPTH];  // where each is met
  unsigned count;
} gjk_scene_passage;

// Starts with a box, enlarged by grow all round, that moves as a point does from from to to. Pre: 0 <= grow < 2^35.
void gjk_scene_passage_start(const gjk_scene_view *v, gjk_scene_passage *p, const gjk_aabb *box, int64_t grow,
                             const gjk_vec3 *from, const gjk_vec3 *to);

// Starts with the parts of a list alone. Pre: count <= GJK_SCENE_NEAR.
void gjk_scene_passage_start_among(const gjk_scene_view *v, gjk_scene_passage *p, const gjk_aabb *box, int64_t grow,
                                   const gjk_vec3 *from, const gjk_vec3 *to, const uint32_t *parts, unsigned count);

// The next part, or NONE. Sets a fraction, Q30 rounded down, before which the box does not meet that of the part.
uint32_t gjk_scene_passage_next(const gjk_scene_view *v, gjk_scene_passage *p, uint32_t *entered);

#endif
