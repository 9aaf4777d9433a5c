// One shape of a body: as a collider, its boxes, and how far it moved.
#ifndef GJK_SRC_SCENE_PART_H
#define GJK_SRC_SCENE_PART_H

#include "gjk_scene_block.h"

// Writes the part as a posed collider with lazy hulls, for queries and gjk_collider_pose, not for gjk_collider_move.
void gjk_scene_part_collider(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out);

// Poses an initialised collider as a part of a body is: at the body's pose, or at own_pose in the body's frame unless
// that is NULL.
gjk_status gjk_scene_part_pose(gjk_collider *c, const gjk_pose *body, const gjk_pose *own_pose);

// Makes the collider of a part from a shape of the table. Unused frames are 0, so what is stored repeats bit for bit.
// RANGE: no such shape.
gjk_status gjk_scene_part_build(const gjk_scene_view *v, uint16_t shape, const gjk_pose *body, const gjk_pose *own_pose,
                                gjk_collider *out);

// How far the rotation from a to b moves points, Q30: at most by this times their distance from the axis.
// Pre: both are unit quaternions within the tolerance of gjk/pose.h.
uint32_t gjk_scene_rotation_bound(const gjk_quat *a, const gjk_quat *b);

// Stores where a part is after its body moved: the collider of its shape at the new pose. Adds to its motion; turn
// bounds the body's rotation. If the box in the tree is too small, sets another one, which with ahead expects the
// motion to go on, and returns true.
bool gjk_scene_part_moved(gjk_scene_view *v, uint32_t index, const gjk_collider *collider, uint32_t turn, bool ahead);

// Bits from bit 30 on are set when a coordinate is 2^29 or more in size. Below that, two of them and a margin add up.
static inline uint32_t gjk_scene_beyond_centre(const gjk_vec3 *v) {
  const uint32_t half = UINT32_C(1) << 29;
  return ((uint32_t)v->x + half) | ((uint32_t)v->y + half) | ((uint32_t)v->z + half);
}

// Can a step of less than 2^30 per axis be added to the place of a part, so that nothing leaves int32?
//
// The centre is at most 2^28 + 4 outside of the exact box. So is, of a composed pose, its position beyond the centre,
// by at most |local_centre| <= sqrt(3) 2^29.
static inline bool gjk_scene_part_shifts(const gjk_scene_part *p) {
  const uint32_t beyond = gjk_scene_beyond_centre(&p->exact.lower) | gjk_scene_beyond_centre(&p->exact.upper);
  return beyond >> 30 == 0 && (p->own_pose == GJK_SCENE_NONE || gjk_scene_beyond_centre(&p->local_centre) >> 30 == 0);
}

// An upper bound of the length of a step of less than 2^30 per axis.
uint32_t gjk_scene_step_bound(const gjk_vec3 *step);

// As gjk_scene_part_moved, for a body that keeps its rotation bit for bit, so that all of the part moves by step: stores
// what posing it would give. motion is the step's bound. Pre: gjk_scene_part_shifts.
bool gjk_scene_part_shift(const gjk_scene_view *v, uint32_t index, const gjk_vec3 *step, uint32_t motion, bool ahead);

// Stores where a part is that is new or has another shape. Nothing bounds its motion. Sets its box in the tree.
void gjk_scene_part_reset(gjk_scene_view *v, uint32_t index, const gjk_collider *collider);

// Does the part's box in the tree hold what it must: the exact one, grown by the body's margin all round?
bool gjk_scene_part_fits(const gjk_scene_view *v, const gjk_scene_part *p);

// Shrinks the part's box in the tree to the least one. The boxes of nodes above it stay as they are, and hold it still.
void gjk_scene_part_shrink_box(gjk_scene_view *v, uint32_t index);

#endif
