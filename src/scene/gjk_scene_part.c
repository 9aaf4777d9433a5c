// One shape of a body: as a collider, its boxes, and how far it moved.
#include "gjk_scene_part.h"

// By how much rounding may move a point of a posed part between two poses, LSB:
//
// offsets from the centre  less than 3 at each of the two (gjk_collider.c)        < 6
// a composed rotation      less than 2^-29 of at most 2^28 LSB at each of the two  < 1
#define POSE_ROUNDING 8

// How many more steps like its last one a part's next box in the tree has room for. With 4, a tick of sparse bodies takes
// 12 % more instructions, because more boxes are left; with 12 there are 17 % more pairs in a crowd.
#define AHEAD 8

void gjk_scene_part_load(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out) {
  gjk_scene_load(part, v->scene->shapes[part->shape], out);
}

// RANGE also where some rotation would take a concave part out of int32.
static gjk_status pose_alone(gjk_collider *c, const gjk_pose *pose) {
  return gjk_scene_has_room(c->shape, &pose->position) ? gjk_collider_pose(c, pose) : GJK_ERROR_RANGE;
}

static gjk_status pose_at(gjk_collider *c, const gjk_pose *body, const gjk_pose *own_pose) {
  gjk_pose pose;
  if (own_pose == NULL) {
    return pose_alone(c, body);
  }
  const gjk_status status = gjk_pose_compose(body, own_pose, &pose);
  return status == GJK_OK ? pose_alone(c, &pose) : status;
}

void gjk_scene_part_pose(const gjk_scene_view *v, const gjk_scene_part *part, gjk_pose *out) {
  const gjk_scene_body *body = &v->bodies[part->body];
  const uint32_t own_pose = part->own_pose;
  gjk_scene_pose_of(body, out);
  if (own_pose != GJK_SCENE_NONE) {
    const gjk_pose of_body = *out;
    (void)gjk_pose_compose(&of_body, &v->own_poses[own_pose].pose, out);  // cannot fail: the body was taken there
  }
}

// Parts are added from the last to the first, to records one after another where the pool has no holes. There a part's
// record is so many before the first one's. Otherwise a walk finds it.
uint32_t gjk_scene_part_of(const gjk_scene_view *v, const gjk_scene_body *body, uint16_t number) {
  uint32_t index = body->first;
  if (index != GJK_SCENE_NONE && number <= index) {
    const gjk_scene_part *part = &v->parts[index - number];
    if ((part->state & GJK_SCENE_LIVE) != 0 && &v->bodies[part->body] == body && part->number == number) {
      return index - number;
    }
  }
  while (index != GJK_SCENE_NONE && v->parts[index].number != number) {
    index = v->parts[index].next;
  }
  return index;
}

gjk_status gjk_scene_find_part(const gjk_scene_view *v, gjk_body_id id, uint16_t number, const gjk_scene_part **out) {
  gjk_scene_body *body;
  const gjk_status status = gjk_scene_body_of(v, id, &body);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t index = gjk_scene_part_of(v, body, number);
  if (index == GJK_SCENE_NONE) {
    return GJK_ERROR_RANGE;
  }
  *out = &v->parts[index];
  return GJK_OK;
}

gjk_status gjk_scene_part_at(const gjk_scene_view *v, const gjk_scene_part *part, const gjk_pose *body,
                             gjk_collider *out) {
  const uint32_t own_pose = part->own_pose;
  gjk_scene_part_load(v, part, out);
  //@ assert own_pose == GJK_SCENE_NONE || own_pose < v->header->config.own_poses;
  return pose_at(out, body, own_pose == GJK_SCENE_NONE ? NULL : &v->own_poses[own_pose].pose);
}

static void pose_part(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out) {
  const gjk_scene_body *body = &v->bodies[part->body];
  gjk_pose pose;
  pose.position = body->position;
  pose.rotation = body->rotation;
  (void)gjk_scene_part_at(v, part, &pose, out);  // cannot fail: the body was taken there
  //@ assert out->state == GJK_STATE_POSED;
}

#if GJK_SCENE_POSES_AGAIN
void gjk_scene_part_collider(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out) {
  if (gjk_scene_is_to_pose(v->scene->shapes[part->shape])) {
    pose_part(v, part, out);
  } else {
    gjk_scene_part_load(v, part, out);
  }
}
#endif

void gjk_scene_part_placed(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out) {
  if ((part->state & GJK_SCENE_UNPOSED) == 0) {
    gjk_scene_part_collider(v, part, out);
  } else {
    pose_part(v, part, out);
  }
}

void gjk_scene_part_now(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out, gjk_aabb *box) {
  gjk_scene_part_placed(v, part, out);
  if ((part->state & GJK_SCENE_UNPOSED) == 0) {
    *box = part->exact;
  } else {
    (void)gjk_collider_aabb(out, box);  // posed, so it cannot fail
  }
}

const gjk_aabb *gjk_scene_part_box(const gjk_scene_view *v, const gjk_scene_part *part, gjk_aabb *room) {
  gjk_collider c;
  if ((part->state & GJK_SCENE_UNPOSED) == 0) {
    return &part->exact;
  }
  gjk_scene_part_now(v, part, &c, room);
  return room;
}

gjk_status gjk_scene_part_build(const gjk_scene_view *v, uint16_t shape, const gjk_pose *body, const gjk_pose *own_pose,
                                gjk_collider *out) {
  if (shape >= v->scene->shape_count) {
    return GJK_ERROR_RANGE;
  }
  out->state = 0;
  gjk_scene_set_zero(&out->frame[0]);
  out->frame[1] = out->frame[0];
  out->frame[2] = out->frame[0];
  const gjk_status status = gjk_scene_bind(out, v->scene->shapes[shape]);
  return status == GJK_OK ? pose_at(out, body, own_pose) : status;
}

static uint32_t add_motion(uint32_t a, uint32_t b) {
  return a > GJK_SCENE_UNBOUNDED - b ? GJK_SCENE_UNBOUNDED : a + b;
}

// One copy in a build for size, as the next one.
GJK_ONCE static void shift(gjk_vec3 *v, const gjk_vec3 *step) {
  gjk_scene_shift(v, step);
}

// The exact box of a part, grown by margin all round, and by steps times way on the sides it points to.
//
// |way| < 2^28, steps <= 8:  |steps way| < 2^31
static gjk_aabb grown(const gjk_scene_part *p, int32_t margin, const gjk_vec3 *way, int32_t steps) {
  gjk_aabb box = p->exact;
  gjk_scene_grow(&box, margin, way, steps);
  return box;
}

// Sets the box in the tree. Parts that are near have boxes there that meet, because each is grown by its body's margin.
static void enlarge(const gjk_scene_view *v, gjk_scene_part *p, const gjk_vec3 *way, int32_t steps) {
  p->enlarged = grown(p, v->header->config.box_margin + v->bodies[p->body].margin, way, steps);
}

// The least box that the tree may have: the exact one, grown by the body's margin all round. Few bodies have a margin.
static gjk_aabb needed_box(const gjk_scene_view *v, const gjk_scene_part *p) {
  const gjk_q16 margin = v->bodies[p->body].margin;
  return margin != 0 ? grown(p, margin, &p->centre, 0) : p->exact;
}

bool gjk_scene_part_fits(const gjk_scene_view *v, const gjk_scene_part *p) {
  const gjk_aabb needed = needed_box(v, p);
  return gjk_aabb_inside(&needed, &p->enlarged);
}

GJK_ONCE static void store_collider(gjk_scene_part *p, const gjk_collider *c) {
  gjk_scene_store(c, p);
  (void)gjk_collider_aabb(c, &p->exact);  // posed, so it cannot fail
}

void gjk_scene_part_settle(const gjk_scene_view *v, uint32_t index) {
  gjk_scene_part *p = &v->parts[index];
  gjk_collider c;
  if ((p->state & GJK_SCENE_UNPOSED) != 0) {
    pose_part(v, p, &c);
    store_collider(p, &c);
    p->state = (uint8_t)(p->state & ~GJK_SCENE_UNPOSED);
  }
}

static uint32_t offset_bound(const gjk_vec3 *offset) {
  const gjk_vec3 origin = gjk_scene_equal_vec3(0);
  return gjk_scene_is_zero(offset) ? 0 : gjk_scene_distance_bound(offset, &origin);
}

void gjk_scene_step_between(const gjk_scene_body *body, const gjk_pose *pose, bool turns, gjk_scene_step *step) {
  step->length = gjk_scene_distance_bound(&body->position, &pose->position);
  step->turn = 0;
  if (turns) {
    // Not 0, because opposite quaternions may round differently.
    step->turn = gjk_scene_rotation_bound(&body->rotation, &pose->rotation) | 1u;
  }
}

// Bounds how far the rotation of its body moves a point of a part. A point at the origin of its body stays. Beyond 2^28
// from there nothing bounds it.
//
// Rounding where the centre is not the origin moves it by less than 7 more: the centre by 0.51 and a composed position by
// 0.9 per component, each at both poses, and a composed rotation by 2.
static uint64_t turned_by(const gjk_scene_view *v, const gjk_scene_part *p, uint32_t turn) {
  const uint32_t own_pose = p->own_pose;
  if (!gjk_scene_part_turns(v, p)) {
    return UINT64_MAX;
  }
  uint32_t away = offset_bound(gjk_scene_local_centre(p, v->scene->shapes[p->shape]));
  if (own_pose != GJK_SCENE_NONE) {
    away += offset_bound(&v->own_poses[own_pose].pose.position);
  } else if (away == 0 && gjk_scene_is_point(v->scene->shapes[p->shape])) {
    return 0;
  }
  // core_radius <= 2^28 + 4, away < 2^30:  the product < 2^63
  return (gjk_umul32((uint32_t)p->core_radius + away, turn) >> 30) + 1 + POSE_ROUNDING + (away > 0 ? 8 : 0);
}

// Adds the rotation of a step to what is stored of a part. False: exact would have to grow by 2^28 or more, and does not.
static bool turn_part(const gjk_scene_view *v, gjk_scene_part *p, uint32_t turn) {
  const uint64_t turned = turned_by(v, p, turn);
  if (turned == 0) {
    return true;
  }
  p->motion = add_motion(p->motion, turned > UINT32_MAX ? UINT32_MAX : (uint32_t)turned);
  p->state |= GJK_SCENE_UNPOSED;
  if (turned >> 28 != 0) {
    return false;
  }
  const gjk_vec3 outwards = gjk_scene_equal_vec3((int32_t)turned), inwards = gjk_scene_equal_vec3(-(int32_t)turned);
  shift(&p->exact.lower, &inwards);
  shift(&p->exact.upper, &outwards);
  return true;
}

// Poses a part whose box in the tree may be too small. If it is, sets another one and returns true.
GJK_OUT_OF_LINE static bool leave_box(const gjk_scene_view *v, uint32_t index, const gjk_scene_step *step) {
  gjk_scene_part *p = &v->parts[index];
  gjk_scene_part_settle(v, index);
  if (gjk_scene_part_fits(v, p)) {
    return false;
  }
  enlarge(v, p, &step->way, step->ahead ? AHEAD : 0);
  return true;
}

bool gjk_scene_part_carry(const gjk_scene_view *v, uint32_t index, const gjk_scene_step *step) {
  gjk_scene_part *p = &v->parts[index];
  bool little = step->turn == 0 || turn_part(v, p, step->turn);
  p->motion = add_motion(p->motion, step->length);
  shift(&p->centre, &step->way);
  shift(&p->exact.lower, &step->way);
  shift(&p->exact.upper, &step->way);
  if (step->leap) {
    p->state |= GJK_SCENE_UNPOSED;
    little = false;
  }
  return !(little && gjk_scene_part_fits(v, p)) && leave_box(v, index, step);
}

void gjk_scene_part_reset(gjk_scene_view *v, uint32_t index, const gjk_collider *collider) {
  gjk_scene_part *p = &v->parts[index];
  p->motion = GJK_SCENE_UNBOUNDED;
  gjk_scene_store_shape(collider, p);
  p->state = (uint8_t)(p->state & ~GJK_SCENE_UNPOSED);
  store_collider(p, collider);
  enlarge(v, p, &p->centre, 0);
}

void gjk_scene_part_shrink_box(gjk_scene_view *v, uint32_t index) {
  gjk_scene_part_settle(v, index);
  v->parts[index].enlarged = needed_box(v, &v->parts[index]);
}
