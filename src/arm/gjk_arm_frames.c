// Forward kinematics of an arm: the frames of all links at a fraction of an edge.
//
// A value at step m is from + (to - from) m / GJK_ARM_STEPS, exactly: with GJK_ARM_DEPTH_MAX bits below the LSB. So angles
// are not rounded, but to 2^-59 turns. The rest is as in gjk_joint.c, whose errors gjk/joint.h states.
#include "gjk_arm_frames.h"

#include "../arith/gjk_rotation.h"
#include "../arith/gjk_sine.h"
#include "../place/gjk_joint_frame.h"

// A joint's value at a step, with GJK_ARM_DEPTH_MAX bits below the LSB: at most 2^31 2^20 in size.
static int64_t value_at(const gjk_arm *arm, unsigned i, uint32_t step) {
  const int64_t from = arm->from[i], change = arm->to[i] - from;
  return gjk_shl64(from, GJK_ARM_DEPTH_MAX) + change * (int64_t)step;
}

// Turns the frame by the joint at an angle.
static void turn_by(gjk_joint_frame *frame, const gjk_joint *joint, int64_t angle) {
  const uint64_t size = gjk_magnitude64(angle);
  const uint32_t whole = (uint32_t)(size >> GJK_ARM_DEPTH_MAX);
  const uint64_t rest = size & (GJK_ARM_STEPS - 1);
  // rest < 2^20, half a turn's factor / 2^5 < 2^40; the bits dropped are below 2^5 units of 2^-64 turns.
  const uint64_t part = (rest * (GJK_HALF_TURNS_HIGH >> 5)) >> (GJK_ARM_DEPTH_MAX - 5);
  gjk_q30 sine, cosine;
  gjk_sine_cosine(angle < 0 ? -1 : 1, gjk_half_turns(whole) + part, &sine, &cosine);
  const gjk_quat own = gjk_joint_own(joint, sine, cosine);
  gjk_joint_turn(frame, &own);
}

// Shifts the frame along the joint's axis. The whole LSB: products below 2^59; the rest: below 2^51.
static void shift_by(gjk_joint_frame *frame, const gjk_vec3 rows[3], const gjk_joint *joint, int64_t length) {
  const gjk_vec3 local = {joint->quarter.x, joint->quarter.y, joint->quarter.z};
  const gjk_vec3 axis = gjk_rotate(rows, &local);
  const int64_t whole = gjk_sar64(length, GJK_ARM_DEPTH_MAX), rest = length - gjk_shl64(whole, GJK_ARM_DEPTH_MAX);
  frame->origin[0] += axis.x * whole + gjk_sar64(axis.x * rest, GJK_ARM_DEPTH_MAX);
  frame->origin[1] += axis.y * whole + gjk_sar64(axis.y * rest, GJK_ARM_DEPTH_MAX);
  frame->origin[2] += axis.z * whole + gjk_sar64(axis.z * rest, GJK_ARM_DEPTH_MAX);
}

// *to = *from, by parts: GCC makes some copies a call of memcpy on ARMv6-M.
static void arm_set_quat(gjk_quat *to, const gjk_quat *from) {
  to->x = from->x;
  to->y = from->y;
  to->z = from->z;
  to->w = from->w;
}

static void set_frame_to(gjk_joint_frame *frame, const gjk_quat *rotation, const int64_t origin[3]) {
  arm_set_quat(&frame->rotation, rotation);
  for (unsigned k = 0; k < 3; k++) {
    frame->origin[k] = origin[k];
  }
}

void gjk_arm_set_frames(gjk_arm *arm, uint32_t step, unsigned which) {
  gjk_joint_frame base, frame;
  gjk_vec3 base_rows[3];
  unsigned value = 0;
  gjk_joint_start(&base, &arm->base);
  gjk_joint_rows(&base.rotation, base_rows);
  for (unsigned i = 0; i < arm->model->link_count; i++) {  // at most GJK_ARM_LINKS_MAX
    gjk_arm_link_room *room = &arm->memory.links[i];
    const gjk_arm_link *link = &arm->model->links[i];
    const bool on_base = link->parent == GJK_ARM_BASE;
    const gjk_arm_link_room *parent = &arm->memory.links[on_base ? 0 : link->parent];
    set_frame_to(&frame, on_base ? &base.rotation : &parent->frame[which].rotation,
                 on_base ? base.origin : parent->frame[which].origin);
    gjk_joint_move(&frame, on_base ? base_rows : parent->frame[which].rows, &room->joint.offset);
    if (link->kind == GJK_ARM_REVOLUTE) {
      turn_by(&frame, &room->joint, value_at(arm, value++, step));
    } else {
      gjk_joint_turn(&frame, &room->joint.still);
    }
    gjk_joint_rows(&frame.rotation, room->frame[which].rows);
    if (link->kind == GJK_ARM_PRISMATIC) {
      shift_by(&frame, room->frame[which].rows, &room->joint, value_at(arm, value++, step));
    }
    arm_set_quat(&room->frame[which].rotation, &frame.rotation);
    for (unsigned k = 0; k < 3; k++) {
      room->frame[which].origin[k] = frame.origin[k];
    }
    gjk_joint_place(&frame, &room->frame[which].at);
  }
  for (unsigned i = 0; i < arm->model->part_count; i++) {
    gjk_arm_part_room *part = &arm->memory.parts[i];
    const gjk_arm_link_room *room = &arm->memory.links[arm->model->parts[i].link];
    part->at[which] = gjk_add(gjk_rotate(room->frame[which].rows, &part->collider.centre), room->frame[which].at);
  }
}

// Poses a copy of a part's collider in the world; what posing sets is not copied.
void gjk_arm_place_part(const gjk_arm *arm, unsigned number, unsigned which, gjk_collider *out) {
  const gjk_arm_part *part = &arm->model->parts[number];
  const gjk_arm_link_room *room = &arm->memory.links[part->link];
  gjk_pose link, pose;
  gjk_set(&room->frame[which].at, &link.position);
  arm_set_quat(&link.rotation, &room->frame[which].rotation);
  (void)gjk_pose_compose(&link, &part->pose, &pose);  // both are units, and the reach is within int32
  const gjk_collider *own = &arm->memory.parts[number].collider;
  out->shape = own->shape;
  out->buffer = NULL;
  gjk_set(&own->local_centre, &out->local_centre);
  out->core_radius = own->core_radius;
  out->radius = own->radius;
  out->count = own->count;
  out->bits = own->bits;
  out->state = GJK_STATE_INITIALISED;
  (void)gjk_collider_pose(out, &pose);
}

const gjk_collider *gjk_arm_place(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, gjk_collider *part,
                                  gjk_collider *other) {
  gjk_arm_place_part(arm, pair->part, which, part);
  if (pair->frame == GJK_ARM_BASE) {
    return &arm->obstacles[pair->other];
  }
  gjk_arm_place_part(arm, pair->other, which, other);
  return other;
}

void gjk_arm_name(const gjk_arm_pair *pair, uint32_t piece, gjk_arm_names *out) {
  out->part = pair->part;
  out->other = pair->other;
  out->obstacle = pair->frame >= GJK_ARM_BODY;
  out->piece = pair->frame == GJK_ARM_BODY ? piece : GJK_PARTS_NONE;
}
