// One shape of a body: as a collider, and its boxes.
#ifndef GJK_SRC_SCENE_PART_H
#define GJK_SRC_SCENE_PART_H

#include "gjk_scene_block.h"

// The part as a posed collider, hulls lazy: good for queries and for posing, not for gjk_collider_move.
void gjk_scene_part_collider(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out);

// Poses an initialised collider to the part of a body: at the body's pose, or at own_pose in the body's frame, if not
// NULL.
gjk_status gjk_scene_part_pose(gjk_collider *c, const gjk_pose *body, const gjk_pose *own_pose);

// Makes the collider of such a part from a shape of the table, 0 where the shape uses no frame. Posing repeats bit for
// bit. RANGE: no such shape.
gjk_status gjk_scene_part_build(const gjk_scene_view *v, uint16_t shape, const gjk_pose *body, const gjk_pose *own_pose,
                                gjk_collider *out);

// How far the rotation from a to b turns points, Q30: they move by at most this times their distance from the axis.
// Pre: both are units within the tolerance.
uint32_t gjk_scene_rotation_bound(const gjk_quat *a, const gjk_quat *b);

// Takes over a posed collider, which the part's shape was posed to: boxes, and how far its points moved if the body
// turned by turn since; ahead: the box in the tree may expect the motion to go on. Returns whether that box changed.
bool gjk_scene_part_moved(gjk_scene_view *v, uint32_t index, const gjk_collider *collider, uint32_t turn, bool ahead);

// The same for a part that is new, or has another shape: nothing bounds its motion, and its box in the tree is set.
void gjk_scene_part_reset(gjk_scene_view *v, uint32_t index, const gjk_collider *collider);

// Takes the part's box in the tree back to what it must hold. Nodes above stay as large as they were.
void gjk_scene_part_shrink_box(gjk_scene_view *v, uint32_t index);

#endif
