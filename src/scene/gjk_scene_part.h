// One shape of a body: as a collider, its boxes, and how far it moved.
#ifndef GJK_SRC_SCENE_PART_H
#define GJK_SRC_SCENE_PART_H

#include "gjk_scene_block.h"

// Writes what is stored of a part as a posed collider with lazy hulls, to be posed.
void gjk_scene_part_load(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out);

// The same for queries alone. Pre: it is posed.
#if GJK_SCENE_POSES_AGAIN
void gjk_scene_part_collider(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out);
#else
#define gjk_scene_part_collider gjk_scene_part_load
#endif

// Writes the part's collider at another pose of its body. Statuses as gjk_collider_pose.
gjk_status gjk_scene_part_at(const gjk_scene_view *v, const gjk_scene_part *part, const gjk_pose *body,
                             gjk_collider *out);

// The same at its body's pose, posed or not; and its exact box.
void gjk_scene_part_placed(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out);
void gjk_scene_part_now(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out, gjk_aabb *box);

// The exact box of a part, posed or not; room is where it may be written.
const gjk_aabb *gjk_scene_part_box(const gjk_scene_view *v, const gjk_scene_part *part, gjk_aabb *room);

// The pose of a part: its body's, with its own.
void gjk_scene_part_pose(const gjk_scene_view *v, const gjk_scene_part *part, gjk_pose *out);

// The index of a body's part by its number, or none.
uint32_t gjk_scene_part_of(const gjk_scene_view *v, const gjk_scene_body *body, uint16_t number);

// Finds a part by its body's id and its number. BODY_ID, or RANGE: there is none.
gjk_status gjk_scene_find_part(const gjk_scene_view *v, gjk_body_id id, uint16_t number, const gjk_scene_part **out);

// Poses a part, unless it is posed.
void gjk_scene_part_settle(const gjk_scene_view *v, uint32_t index);

// Makes the collider of a part from a shape of the table. Unused frames are 0, so what is stored repeats bit for bit.
// RANGE: no such shape.
gjk_status gjk_scene_part_build(const gjk_scene_view *v, uint16_t shape, const gjk_pose *body, const gjk_pose *own_pose,
                                gjk_collider *out);

// How a body moves from one pose to the next.
typedef struct gjk_scene_step {
  gjk_vec3 way;     // of its position, below 2^28; 0 where it is not so small
  uint32_t length;  // bounds the motion of its position
  uint32_t turn;    // bounds the rotation, see gjk_scene_rotation_bound; 0: it is the same bit for bit
  bool leap;        // it is no small step: parts have to be posed
  bool ahead;       // boxes in the tree may expect the motion to go on
} gjk_scene_step;

// Sets length and turn of a step. turns: the rotations differ.
void gjk_scene_step_between(const gjk_scene_body *body, const gjk_pose *pose, bool turns, gjk_scene_step *step);

// Are the offsets of a part that turn about its body's position within 2^28 per axis?
static inline bool gjk_scene_part_turns(const gjk_scene_view *v, const gjk_scene_part *part) {
  const uint32_t own_pose = part->own_pose;
  //@ assert own_pose == GJK_SCENE_NONE || own_pose < v->header->config.own_poses;
  return gjk_scene_is_below(gjk_scene_local_centre(part, v->scene->shapes[part->shape]), 28) &&
         (own_pose == GJK_SCENE_NONE || gjk_scene_is_below(&v->own_poses[own_pose].pose.position, 28));
}

// Can a step of less than 2^28 be added to what is stored of this part? The next position of its body is below 2^30. Then
// no pose of the part there leaves int32: its centre is at most twice sqrt(3) 2^28 away from the position.
static inline bool gjk_scene_part_carries(const gjk_scene_view *v, const gjk_scene_part *part, bool turns) {
  return gjk_scene_is_below(&part->exact.lower, 30) && gjk_scene_is_below(&part->exact.upper, 30) &&
         ((!turns && part->own_pose == GJK_SCENE_NONE) || gjk_scene_part_turns(v, part));
}

// Moves a part as its body did, whose pose is stored. Adds to its motion. Poses it only if it may have left its box in
// the tree, or leaps. If it has, sets another box and returns true. Pre: gjk_scene_part_carries, or it leaps.
bool gjk_scene_part_carry(const gjk_scene_view *v, uint32_t index, const gjk_scene_step *step);

// Stores where a part is, if it is new or has another shape. Nothing bounds its motion then. Sets its box in the tree.
void gjk_scene_part_reset(gjk_scene_view *v, uint32_t index, const gjk_collider *collider);

// Does the part's box in the tree hold what it must: exact, grown by the body's margin all round?
bool gjk_scene_part_fits(const gjk_scene_view *v, const gjk_scene_part *p);

// Shrinks the part's box in the tree to the least one, and poses the part for that. The boxes of nodes above it stay as
// they are, and still hold it.
void gjk_scene_part_shrink_box(gjk_scene_view *v, uint32_t index);

#endif
