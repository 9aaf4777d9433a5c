// An arm: its model is checked, its parts are placed in the frames of their links, its pairs are listed.
#include "gjk/arm.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"
#include "gjk_arm_bound.h"

// Does the pose leave every vertex as it is?
static bool is_identity(const gjk_pose *pose) {
  const gjk_vec3 *p = &pose->position;
  const gjk_quat *q = &pose->rotation;
  return (p->x | p->y | p->z | q->x | q->y | q->z) == 0 && q->w == GJK_Q30_ONE;
}

// Checks a link and makes its joint.
static gjk_status init_link(const gjk_arm_model *model, unsigned number, const gjk_arm_memory *memory) {
  const gjk_arm_link *link = &model->links[number];
  gjk_arm_link_room *room = &memory->links[number];
  const bool on_base = link->parent == GJK_ARM_BASE;
  if ((!on_base && link->parent >= number) || link->kind > GJK_ARM_PRISMATIC) {
    return GJK_ERROR_RANGE;
  }
  room->above = UINT32_C(1) << number | (on_base ? 0 : memory->links[link->parent].above);
  const gjk_status status =
      gjk_joint_init(&room->joint, &link->fixed, link->kind == GJK_ARM_FIXED ? NULL : &link->axis);
  if (status == GJK_OK && link->kind == GJK_ARM_PRISMATIC) {
    const gjk_quat axis = {link->axis.x, link->axis.y, link->axis.z, 0};
    (void)gjk_quat_normalize(&axis, &room->joint.quarter);  // gjk_joint_init has refused 0
  }
  return status;
}

// Places a part in its link's frame.
static gjk_status init_part(const gjk_arm_model *model, unsigned number, const gjk_arm_memory *memory) {
  const gjk_arm_part *part = &model->parts[number];
  gjk_arm_part_room *room = &memory->parts[number];
  if (part->link >= model->link_count) {
    return GJK_ERROR_RANGE;
  }
  gjk_status status = gjk_collider_init(&room->collider, part->shape, NULL, 0);
  if (status == GJK_OK) {
    status = gjk_collider_pose(&room->collider, &part->pose);
  }
  if (status != GJK_OK) {
    return status;
  }
  const gjk_collider *c = &room->collider;
  const uint32_t x = gjk_magnitude32(c->centre.x), y = gjk_magnitude32(c->centre.y), z = gjk_magnitude32(c->centre.z);
  const uint64_t square = gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z);  // at most 3 2^62
  const uint64_t reach = (uint64_t)gjk_isqrt64(square) + 1 + (uint32_t)c->radius;
  if (reach > (uint64_t)GJK_ARM_REACH_MAX) {
    return GJK_ERROR_RANGE;
  }
  const bool same = is_identity(&part->pose), curved = gjk_is_curved(part->shape);
  room->reach = (int32_t)reach;
  room->slack = (uint8_t)((same ? 0 : 3) + (curved ? 3 : 0));
  room->scanned = same && part->shape->type->buffered && part->shape->user == NULL;
  return GJK_OK;
}

// Are parts of the two links never tested, or does no joint move one against the other?
static bool never_tested(const gjk_arm *arm, unsigned i, unsigned k) {
  const gjk_arm_model *model = arm->model;
  const uint32_t between = arm->memory.links[i].above ^ arm->memory.links[k].above;
  bool moves = false;
  for (unsigned link = 0; link < model->link_count; link++) {
    moves = moves || ((between >> link & 1u) != 0 && gjk_arm_moves(arm, link));
  }
  return !moves || model->links[i].parent == k || model->links[k].parent == i ||
         (model->never != NULL && ((model->never[i] >> k & 1u) != 0 || (model->never[k] >> i & 1u) != 0));
}

// Does a joint move the link in the world?
static bool link_moves(const gjk_arm *arm, unsigned link) {
  bool moves = false;
  for (unsigned i = 0; i <= link; i++) {
    moves = moves || ((arm->memory.links[link].above >> i & 1u) != 0 && gjk_arm_moves(arm, i));
  }
  return moves;
}

// Adds a pair to the list, if it has room. *count: how many there are, or would be.
static void add_pair(const gjk_arm_memory *memory, uint32_t *count, unsigned part, unsigned other, unsigned frame) {
  if (*count < memory->pair_capacity) {
    gjk_arm_pair *pair = &memory->pairs[*count];
    pair->part = (uint16_t)part;
    pair->other = (uint16_t)other;
    pair->frame = (uint8_t)frame;
    pair->direction.x = pair->direction.y = pair->direction.z = 0;
  }
  (*count)++;  // at most 2^19 + 2^27
}

// Lists pairs of parts: of the two links the one with the lower number gives the frame.
static gjk_status list_parts(gjk_arm *arm) {
  const gjk_arm_model *model = arm->model;
  arm->self_count = 0;
  for (unsigned i = 0; i < model->part_count; i++) {
    for (unsigned k = 0; k < i; k++) {
      const unsigned a = model->parts[i].link, b = model->parts[k].link;
      if (!never_tested(arm, a, b)) {
        add_pair(&arm->memory, &arm->self_count, a > b ? i : k, a > b ? k : i, a > b ? b : a);
      }
    }
  }
  arm->pair_count = arm->self_count;
  return arm->self_count <= arm->memory.pair_capacity ? GJK_OK : GJK_ERROR_CAPACITY;
}

static gjk_status init_all(gjk_arm *arm) {
  const gjk_arm_model *model = arm->model;
  gjk_status status = GJK_OK;
  for (unsigned i = 0; status == GJK_OK && i < model->link_count; i++) {
    status = init_link(model, i, &arm->memory);
    arm->value_count = (uint8_t)(arm->value_count + (model->links[i].kind != GJK_ARM_FIXED ? 1u : 0u));
  }
  for (unsigned i = 0; status == GJK_OK && i < model->part_count; i++) {
    status = init_part(model, i, &arm->memory);
  }
  return status == GJK_OK ? list_parts(arm) : status;
}

gjk_status gjk_arm_init(gjk_arm *arm, const gjk_arm_model *model, const gjk_pose *base, const gjk_arm_memory *memory) {
  if (arm == NULL || model == NULL || base == NULL || memory == NULL || model->links == NULL || memory->links == NULL ||
      (model->part_count > 0 && (model->parts == NULL || memory->parts == NULL)) ||
      (memory->pair_capacity > 0 && memory->pairs == NULL)) {
    return GJK_ERROR_NULL;
  }
  int64_t deviation;
  if (!gjk_quat_deviation(&base->rotation, &deviation)) {
    return GJK_ERROR_ROTATION;
  }
  if (model->link_count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (model->link_count > GJK_ARM_LINKS_MAX || model->part_count > GJK_ARM_PARTS_MAX) {
    return GJK_ERROR_RANGE;
  }
  gjk_arm made;
  gjk_zero(&made, sizeof made);
  made.model = model;
  made.memory.links = memory->links;
  made.memory.parts = memory->parts;
  made.memory.pairs = memory->pairs;
  made.memory.pair_capacity = memory->pair_capacity;
  made.base = *base;
  made.state = GJK_ARM_READY;
  const gjk_status status = init_all(&made);
  if (status == GJK_OK) {
    gjk_copy(arm, &made, sizeof made);
  }
  return status;
}

// Adds the pairs of all parts that move with count things.
static void list_things(gjk_arm *arm, unsigned count, unsigned frame) {
  for (unsigned i = 0; i < arm->model->part_count; i++) {
    for (unsigned k = 0; k < count && link_moves(arm, arm->model->parts[i].link); k++) {
      add_pair(&arm->memory, &arm->pair_count, i, k, frame);
    }
  }
}

bool gjk_arm_list(gjk_arm *arm, uint16_t obstacles, uint16_t bodies) {
  uint32_t moving = 0;
  for (unsigned i = 0; i < arm->model->part_count; i++) {
    moving += link_moves(arm, arm->model->parts[i].link) ? 1u : 0u;
  }
  if (moving * ((uint32_t)obstacles + bodies) > arm->memory.pair_capacity - arm->self_count) {  // below 2^27
    return false;
  }
  arm->pair_count = arm->self_count;
  arm->obstacle_count = obstacles;
  arm->body_count = bodies;
  arm->state = GJK_ARM_READY;
  list_things(arm, obstacles, GJK_ARM_BASE);
  list_things(arm, bodies, GJK_ARM_BODY);
  return true;
}

gjk_status gjk_arm_obstacles(gjk_arm *arm, const gjk_collider *obstacles, uint16_t count) {
  if (arm == NULL || (obstacles == NULL && count > 0)) {
    return GJK_ERROR_NULL;
  }
  if (!gjk_arm_is_ready(arm)) {
    return GJK_ERROR_UNINITIALISED;
  }
  for (unsigned i = 0; i < count; i++) {
    if (obstacles[i].state != GJK_STATE_POSED) {
      return GJK_ERROR_UNINITIALISED;
    }
  }
  if (!gjk_arm_list(arm, count, arm->body_count)) {
    return GJK_ERROR_CAPACITY;
  }
  arm->obstacles = obstacles;
  return GJK_OK;
}

unsigned gjk_arm_values(const gjk_arm_model *model) {
  unsigned count = 0;
  for (unsigned i = 0; model != NULL && model->links != NULL && i < model->link_count; i++) {
    count += model->links[i].kind != GJK_ARM_FIXED ? 1u : 0u;
  }
  return count;
}

gjk_status gjk_arm_poses(gjk_arm *arm, const int32_t *values, gjk_pose *out) {
  const gjk_status status = gjk_arm_stand(arm, values, out);
  for (unsigned i = 0; status == GJK_OK && i < arm->model->link_count; i++) {
    out[i].position = arm->memory.links[i].frame[0].at;
    out[i].rotation = arm->memory.links[i].frame[0].rotation;
  }
  return status;
}
