// Bodies: added, removed, moved, changed. Each call checks everything first and then changes the scene, so a call that
// fails changes nothing.
#include "../arith/gjk_memory.h"
#include "gjk_scene_pairs.h"
#include "gjk_scene_part.h"
#include "gjk_scene_tree.h"

static void put_in_moved_list(gjk_scene_view *v, uint32_t slot) {
  //@ assert slot < v->header->config.bodies;
  gjk_scene_body *body = &v->bodies[slot];
  if ((body->flags & GJK_SCENE_MOVED) == 0) {
    body->flags |= GJK_SCENE_MOVED;
    body->next_moved = GJK_SCENE_INDEX(v->header->moved);
    v->header->moved = slot;
  }
}

// Makes the collider of a part that is to be added to a body at a pose.
static gjk_status build_part(const gjk_scene_view *v, const gjk_pose *pose, const gjk_part *part, gjk_collider *c) {
  return gjk_scene_part_build(v, part->shape, pose, part->own_pose ? &part->pose : NULL, c);
}

// Can the body be added?
static gjk_status check_setup(const gjk_scene_view *v, const gjk_body_setup *s) {
  const gjk_scene_header *h = v->header;
  gjk_collider c;
  uint32_t own_poses = 0;
  if (s->parts == NULL) {
    return GJK_ERROR_NULL;
  }
  if (s->part_count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (s->kind > GJK_BODY_DYNAMIC || s->detail > GJK_DETAIL_SENSOR || s->margin < 0 || s->margin > GJK_RADIUS_MAX ||
      (s->category == 0 && s->mask == 0)) {
    return GJK_ERROR_RANGE;
  }
  if (gjk_scene_lacks(v->scene->bindings.details, s->detail)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  for (uint32_t i = 0; i < s->part_count; i++) {
    const gjk_status status = build_part(v, &s->pose, &s->parts[i], &c);
    if (status != GJK_OK) {
      return status;
    }
    own_poses += s->parts[i].own_pose;
  }
  return s->part_count > h->parts.capacity - h->parts.count || own_poses > h->own_poses.capacity - h->own_poses.count
             ? GJK_ERROR_CAPACITY
             : GJK_OK;
}

// Adds a part at the front of its body's list, to the tree too. Pre: check_setup.
static void add_part(gjk_scene_view *v, uint32_t slot, const gjk_pose *pose, const gjk_part *part, uint16_t number) {
  gjk_scene_header *h = v->header;
  gjk_scene_body *body = &v->bodies[slot];
  const uint32_t index = gjk_scene_pool_take(v, &h->parts, sizeof(gjk_scene_part));
  gjk_scene_part *p = &v->parts[index];
  gjk_collider c;
  (void)build_part(v, pose, part, &c);  // cannot fail: check_setup built it
  p->next = body->first;
  body->first = GJK_SCENE_INDEX(index);
  p->body = slot;
  p->pairs = GJK_SCENE_NONE;
  p->own_pose = GJK_SCENE_NONE;
  if (part->own_pose) {
    const uint32_t at = gjk_scene_pool_take(v, &h->own_poses, sizeof(gjk_scene_own_pose));
    v->own_poses[at].next = index;
    v->own_poses[at].pose = part->pose;
    p->own_pose = GJK_SCENE_INDEX(at);
  }
  p->shape = part->shape;
  p->number = number;
  p->state = GJK_SCENE_LIVE | GJK_SCENE_PAIRS_STALE;
  gjk_scene_part_reset(v, index, &c);
  gjk_scene_tree_insert(v, index);
}

static uint32_t lowest_bit(uint32_t x) {
  return 31 - gjk_clz32(x & (~x + 1));
}

static bool is_free(const gjk_scene_view *v, uint32_t slot) {
  return (v->slots[slot / 32] >> slot % 32 & 1u) != 0;
}

// Adds a body to a slot. Pre: the slot is free.
static gjk_status add_to_slot(gjk_scene_view *v, uint32_t slot, const gjk_body_setup *s, gjk_body_id *out) {
  //@ assert slot < v->header->config.bodies;
  gjk_scene_header *h = v->header;
  gjk_scene_body *body = &v->bodies[slot];
  const gjk_status status = check_setup(v, s);
  if (status != GJK_OK) {
    return status;
  }
  v->slots[slot / 32] &= ~(UINT32_C(1) << slot % 32);
  h->bodies.count++;
  h->bodies.fresh = slot >= h->bodies.fresh ? slot + 1 : h->bodies.fresh;
  body->generation++;
  body->position = s->pose.position;
  body->rotation = s->pose.rotation;
  body->category = s->category;
  body->mask = s->mask;
  body->user = s->user;
  body->margin = s->margin;
  body->first = GJK_SCENE_NONE;
  gjk_scene_set_part_count(body, s->part_count);
  body->kind_detail = (uint8_t)(s->kind | s->detail << 4);
  if (s->detail > h->most_detail && s->detail != GJK_DETAIL_SENSOR) {
    h->most_detail = s->detail;
  }
  body->flags &= GJK_SCENE_MOVED;                 // the slot stays in the list of moved bodies
  for (uint16_t i = s->part_count; i > 0; i--) {  // backwards, so that the list is in order
    add_part(v, slot, &s->pose, &s->parts[i - 1], (uint16_t)(i - 1));
  }
  put_in_moved_list(v, slot);
  *out = gjk_scene_id_of(v, slot);
  return GJK_OK;
}

gjk_status gjk_scene_add(gjk_scene *scene, const gjk_body_setup *setup, gjk_body_id *out) {
  gjk_scene_view v;
  gjk_status status = setup == NULL || out == NULL ? GJK_ERROR_NULL : gjk_scene_edit(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  gjk_scene_header *h = v.header;
  const uint32_t words = (h->config.bodies + 31) / 32;
  while (h->lowest < words && v.slots[h->lowest] == 0) {
    h->lowest++;
  }
  if (h->lowest == words) {
    return GJK_ERROR_CAPACITY;
  }
  return add_to_slot(&v, 32 * h->lowest + lowest_bit(v.slots[h->lowest]), setup, out);
}

gjk_status gjk_scene_add_at(gjk_scene *scene, uint32_t slot, const gjk_body_setup *setup, gjk_body_id *out) {
  gjk_scene_view v;
  const gjk_status status = setup == NULL || out == NULL ? GJK_ERROR_NULL : gjk_scene_edit(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (slot >= v.header->config.bodies) {
    return GJK_ERROR_CAPACITY;
  }
  return is_free(&v, slot) ? add_to_slot(&v, slot, setup, out) : GJK_ERROR_BODY_ID;
}

// Opens a scene to change one body.
static gjk_status edit_body(gjk_scene *scene, gjk_body_id id, gjk_scene_view *v, gjk_scene_body **body) {
  const gjk_status status = gjk_scene_edit(scene, v);
  return status == GJK_OK ? gjk_scene_body_of(v, id, body) : status;
}

// Is the body one whose motion is kept?
static bool is_kept(const gjk_scene_body *body) {
  return (body->flags & GJK_SCENE_KEPT) != 0;
}

gjk_status gjk_scene_remove(gjk_scene *scene, gjk_body_id id) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  if (is_kept(body)) {
    if (scene->bindings.motion == NULL) {
      return GJK_ERROR_UNSUPPORTED;
    }
    scene->bindings.motion->forget(&v, id.slot);
  }
  gjk_scene_header *h = v.header;
  uint32_t next;
  for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = next) {
    next = v.parts[i].next;
    gjk_scene_pairs_forget(&v, i);
    gjk_scene_tree_remove(&v, i);
    if (v.parts[i].own_pose != GJK_SCENE_NONE) {
      gjk_scene_pool_give(&v, &h->own_poses, sizeof(gjk_scene_own_pose), v.parts[i].own_pose);
    }
    v.parts[i].state = 0;
    gjk_scene_pool_give(&v, &h->parts, sizeof(gjk_scene_part), i);
  }
  //@ assert id.slot < v.header->config.bodies;
  body->first = GJK_SCENE_NONE;  // the slot may be in the list of moved bodies, and stays there
  body->generation++;
  h->bodies.count--;
  if (body->generation != 0) {  // otherwise the slot is used up
    v.slots[id.slot / 32] |= UINT32_C(1) << id.slot % 32;
    h->lowest = id.slot / 32 < h->lowest ? id.slot / 32 : h->lowest;
  }
  return GJK_OK;
}

static const gjk_pose *own_pose_of(const gjk_scene_view *v, const gjk_scene_part *p) {
  const uint32_t at = p->own_pose;
  return at == GJK_SCENE_NONE ? NULL : &v->own_poses[at].pose;
}

// Inserts a part into the tree anew, after its box changed.
static void reinsert_part(gjk_scene_view *v, uint32_t index) {
  gjk_scene_tree_remove(v, index);
  gjk_scene_tree_insert(v, index);
  v->parts[index].state |= GJK_SCENE_PAIRS_STALE;
}

// Is the way to a pose a small step for all parts of a body? Sets way modulo 2^32. From a position below 2^30 no other way
// below 2^28 leads back to the same position, so a small way is the true one.
static bool is_small_step(const gjk_scene_view *v, const gjk_scene_body *body, const gjk_pose *pose, bool turns,
                          gjk_vec3 *way) {
  const gjk_vec3 *from = &body->position, *to = &pose->position;
  gjk_scene_way(from, to, way);
  bool small = gjk_scene_is_below(to, 30) && gjk_scene_is_below(way, 28);
  for (uint32_t i = body->first; i != GJK_SCENE_NONE && small; i = v->parts[i].next) {
    small = gjk_scene_part_carries(v, &v->parts[i], turns);
  }
  return small;
}

// A part's new box is set while the part is in the tree, where nodes above do not hold that box. That is safe: taking
// the part out does not look at its box, and inserting it comes after.

// Can all parts of a body be posed there? Statuses as gjk_collider_pose.
GJK_OUT_OF_LINE static gjk_status check_leap(const gjk_scene_view *v, const gjk_scene_body *body,
                                             const gjk_pose *pose) {
  gjk_status status = GJK_OK;
  gjk_collider c;
  for (uint32_t i = body->first; i != GJK_SCENE_NONE && status == GJK_OK; i = v->parts[i].next) {
    status = gjk_scene_part_at(v, &v->parts[i], pose, &c);
  }
  return status;
}

// Moves a body to another pose. turns: it has another rotation. ahead: its parts' boxes may expect the motion to go on.
static gjk_status take_body(gjk_scene_view *v, gjk_scene_body *body, const gjk_pose *pose, bool turns, bool ahead) {
  gjk_scene_step step;
  if (turns && !gjk_scene_is_rotation(&pose->rotation)) {
    return GJK_ERROR_ROTATION;
  }
  step.ahead = ahead;
  step.leap = !is_small_step(v, body, pose, turns, &step.way);
  if (step.leap) {
    const gjk_status status = check_leap(v, body, pose);
    if (status != GJK_OK) {
      return status;
    }
    gjk_scene_set_zero(&step.way);
  }
  gjk_scene_step_between(body, pose, turns, &step);
  body->position = pose->position;
  body->rotation = pose->rotation;
  for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = v->parts[i].next) {
    if (gjk_scene_part_carry(v, i, &step)) {
      reinsert_part(v, i);
    }
  }
  return GJK_OK;
}

static gjk_status move_body(gjk_scene *scene, gjk_body_id id, const gjk_pose *pose, bool ahead) {
  gjk_scene_view v;
  gjk_scene_body *body;
  gjk_status status = pose == NULL ? GJK_ERROR_NULL : edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  const bool turns = !gjk_scene_same_rotation(&body->rotation, &pose->rotation);
  if (turns || !gjk_scene_same_vec3(&body->position, &pose->position)) {
    status = take_body(&v, body, pose, turns, ahead);
    if (status != GJK_OK) {
      return status;
    }
    put_in_moved_list(&v, id.slot);
  }
  body->flags = (uint8_t)(body->flags & ~GJK_SCENE_ASLEEP);
  return GJK_OK;
}

gjk_status gjk_scene_move(gjk_scene *scene, gjk_body_id id, const gjk_pose *pose) {
  return move_body(scene, id, pose, true);
}

gjk_status gjk_scene_teleport(gjk_scene *scene, gjk_body_id id, const gjk_pose *pose) {
  gjk_scene_view v;
  gjk_scene_body *body;
  gjk_status status = pose == NULL ? GJK_ERROR_NULL : edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  const bool kept = is_kept(body);
  if (kept && scene->bindings.motion == NULL) {
    return GJK_ERROR_UNSUPPORTED;
  }
  status = move_body(scene, id, pose, false);
  if (status == GJK_OK && kept) {
    scene->bindings.motion->restart(&v, id.slot);
  }
  return status;
}

gjk_status gjk_scene_sleep(gjk_scene *scene, gjk_body_id id) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  if ((body->kind_detail & 15u) != GJK_BODY_DYNAMIC) {
    return GJK_ERROR_RANGE;
  }
  body->flags |= GJK_SCENE_ASLEEP;
  return GJK_OK;
}

gjk_status gjk_scene_wake(gjk_scene *scene, gjk_body_id id) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = edit_body(scene, id, &v, &body);
  if (status == GJK_OK) {
    body->flags = (uint8_t)(body->flags & ~GJK_SCENE_ASLEEP);
  }
  return status;
}

gjk_status gjk_scene_set_shape(gjk_scene *scene, gjk_body_id id, uint16_t part, uint16_t shape) {
  gjk_scene_view v;
  gjk_scene_body *body;
  gjk_collider c;
  gjk_status status = edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t index = gjk_scene_part_of(&v, body, part);
  if (index == GJK_SCENE_NONE) {
    return GJK_ERROR_RANGE;
  }
  gjk_pose pose;
  gjk_scene_pose_of(body, &pose);
  status = gjk_scene_part_build(&v, shape, &pose, own_pose_of(&v, &v.parts[index]), &c);
  if (status != GJK_OK) {
    return status;
  }
  v.parts[index].shape = shape;
  gjk_scene_part_reset(&v, index, &c);
  put_in_moved_list(&v, id.slot);
  reinsert_part(&v, index);
  return GJK_OK;
}

gjk_status gjk_scene_refilter(gjk_scene *scene, gjk_body_id id) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  for (uint32_t i = body->first; i != GJK_SCENE_NONE; i = v.parts[i].next) {
    v.parts[i].state |= GJK_SCENE_PAIRS_STALE;
    v.parts[i].motion = GJK_SCENE_UNBOUNDED;  // so no pair is settled by motion, and the filters are asked
  }
  put_in_moved_list(&v, id.slot);
  return GJK_OK;
}

gjk_status gjk_scene_set_filter(gjk_scene *scene, gjk_body_id id, uint32_t category, uint32_t mask) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = edit_body(scene, id, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  body->category = category;
  body->mask = mask;
  return gjk_scene_refilter(scene, id);
}

gjk_status gjk_scene_set_user(gjk_scene *scene, gjk_body_id id, uint32_t user) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = edit_body(scene, id, &v, &body);
  if (status != GJK_OK || body->user == user) {
    return status;
  }
  body->user = user;
  return gjk_scene_refilter(scene, id);  // the predicate's arguments changed
}

// Opens a scene to read one body.
static gjk_status read_body(const gjk_scene *scene, gjk_body_id id, const void *out, gjk_scene_view *v,
                            gjk_scene_body **body) {
  const gjk_status status = out == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, v);
  return status == GJK_OK ? gjk_scene_body_of(v, id, body) : status;
}

gjk_status gjk_scene_get(const gjk_scene *scene, gjk_body_id id, gjk_body_state *out) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = read_body(scene, id, out, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  gjk_scene_pose_of(body, &out->pose);
  out->category = body->category;
  out->mask = body->mask;
  out->user = body->user;
  out->margin = body->margin;
  out->part_count = (uint16_t)gjk_scene_part_count(body, v.parts);
  out->kind = body->kind_detail & 15u;
  out->detail = body->kind_detail >> 4;
  out->asleep = (body->flags & GJK_SCENE_ASLEEP) != 0;
  out->motion = (body->flags & GJK_SCENE_FAST) != 0 ? GJK_MOTION_FAST
                : is_kept(body)                     ? GJK_MOTION_KEPT
                                                    : GJK_MOTION_NOT_KEPT;
  return GJK_OK;
}

gjk_status gjk_scene_last_pose(const gjk_scene *scene, gjk_body_id id, gjk_pose *out) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = read_body(scene, id, out, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  for (uint32_t i = 0; i < v.header->kept; i++) {
    if (v.kept[i].slot == id.slot) {
      gjk_copy(out, &v.kept[i].last, sizeof *out);
      return GJK_OK;
    }
  }
  return GJK_ERROR_UNSUPPORTED;
}

gjk_status gjk_scene_body_at(const gjk_scene *scene, uint32_t slot, gjk_body_id *out) {
  gjk_scene_view v;
  const gjk_status status = out == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (slot >= v.header->config.bodies) {
    return GJK_ERROR_RANGE;
  }
  *out = gjk_scene_id_of(&v, slot);
  out->generation = out->generation % 2 != 0 ? out->generation : 0;
  return GJK_OK;
}

gjk_status gjk_scene_collider(const gjk_scene *scene, gjk_body_id id, uint16_t part, gjk_collider *out) {
  gjk_scene_view v;
  gjk_scene_body *body;
  const gjk_status status = read_body(scene, id, out, &v, &body);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t index = gjk_scene_part_of(&v, body, part);
  if (index == GJK_SCENE_NONE) {
    return GJK_ERROR_RANGE;
  }
  if (gjk_scene_is_concave(v.scene->shapes[v.parts[index].shape])) {
    return GJK_ERROR_UNSUPPORTED;
  }
  gjk_pose pose;
  gjk_scene_pose_of(body, &pose);
  return gjk_scene_part_at(&v, &v.parts[index], &pose, out);
}
