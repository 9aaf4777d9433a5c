// One shape of a body: as a collider, its boxes, and how far it moved.
#include "gjk_scene_part.h"

#include "../arith/gjk_vector.h"
#include "../shape/gjk_shape_class.h"
#include "gjk/pose.h"

// By how much rounding may move a point of a posed part between two poses, LSB:
//
// offsets from the centre  less than 3 at each of the two (gjk_collider.c)        < 6
// a composed rotation      less than 2^-29 of at most 2^28 LSB at each of the two  < 1
#define POSE_ROUNDING 8

// How many more steps like its last one a part's next box in the tree has room for. With 4, a tick of sparse bodies takes
// 12 % more instructions, because more boxes are left; with 12 there are 17 % more pairs in a crowd.
#define AHEAD 8

void gjk_scene_part_collider(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out) {
  const gjk_shape *shape = v->scene->shapes[part->shape];
  out->shape = shape;
  out->buffer = NULL;
  out->position = part->centre;
  out->centre = part->centre;
  out->local_centre = part->local_centre;
  out->frame[0] = part->frame[0];
  out->frame[1] = part->frame[1];
  out->frame[2] = part->frame[2];
  out->core_radius = part->core_radius;
  out->radius = part->core_radius + shape->convex_radius;
  for (int i = 0; i < 3; i++) {
    out->fraction[i] = part->fraction[i];
  }
  out->state = GJK_STATE_POSED;
  out->count = shape->type->buffered ? shape->count : shape->type->count;
  out->bits = (uint8_t)(32 - gjk_clz32((uint32_t)part->core_radius));
}

gjk_status gjk_scene_part_pose(gjk_collider *c, const gjk_pose *body, const gjk_pose *own_pose) {
  gjk_pose pose;
  if (own_pose == NULL) {
    return gjk_collider_pose(c, body);
  }
  const gjk_status status = gjk_pose_compose(body, own_pose, &pose);
  return status == GJK_OK ? gjk_collider_pose(c, &pose) : status;
}

gjk_status gjk_scene_part_at(const gjk_scene_view *v, const gjk_scene_part *part, const gjk_pose *body,
                             gjk_collider *out) {
  const uint32_t own_pose = part->own_pose;
  gjk_scene_part_collider(v, part, out);
  //@ assert own_pose == GJK_SCENE_NONE || own_pose < v->header->config.own_poses;
  return gjk_scene_part_pose(out, body, own_pose == GJK_SCENE_NONE ? NULL : &v->own_poses[own_pose].pose);
}

static void pose_part(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out) {
  const gjk_scene_body *body = &v->bodies[part->body];
  gjk_pose pose;
  pose.position = body->position;
  pose.rotation = body->rotation;
  (void)gjk_scene_part_at(v, part, &pose, out);  // cannot fail: the body was taken there
  //@ assert out->state == GJK_STATE_POSED;
}

void gjk_scene_part_now(const gjk_scene_view *v, const gjk_scene_part *part, gjk_collider *out, gjk_aabb *box) {
  if ((part->state & GJK_SCENE_UNPOSED) == 0) {
    gjk_scene_part_collider(v, part, out);
    *box = part->exact;
  } else {
    pose_part(v, part, out);
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
  out->frame[0].x = out->frame[0].y = out->frame[0].z = 0;
  out->frame[1] = out->frame[0];
  out->frame[2] = out->frame[0];
  const gjk_status status = gjk_collider_init(out, v->scene->shapes[shape], NULL, 0);
  return status == GJK_OK ? gjk_scene_part_pose(out, body, own_pose) : status;
}

// An upper bound of the length of a vector, from the sum of its components and the largest one, a.
//
// With the other components b, c <= a:  (a + b/2 + c/2)^2 >= a^2 + a b + a c >= a^2 + b^2 + c^2
// In three dimensions the bound is at most a fifth too long. Pre: sum < 2^32.
static uint32_t length_bound(uint32_t sum, uint32_t largest) {
  return sum / 2 + largest / 2 + 1;
}

static uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

// If unit quaternions are d apart, the rotation between them moves a point by at most 2 d times its distance from the
// axis: with t = angle / 4, d = 2 sin t, and the point moves by 2 sin 2t = 4 sin t cos t. q and -q are the same
// rotation, so the nearer one counts. Quaternions of lengths within 2^-17 of 1 change d by less than 2^-16 of itself,
// which d + d / 2^15 + 1 covers.
uint32_t gjk_scene_rotation_bound(const gjk_quat *a, const gjk_quat *b) {
  //@ assert a->x >= -0x40002000L && a->y >= -0x40002000L && a->z >= -0x40002000L && a->w >= -0x40002000L;
  //@ assert a->x <= 0x40002000L && a->y <= 0x40002000L && a->z <= 0x40002000L && a->w <= 0x40002000L;
  //@ assert b->x >= -0x40002000L && b->y >= -0x40002000L && b->z >= -0x40002000L && b->w >= -0x40002000L;
  //@ assert b->x <= 0x40002000L && b->y <= 0x40002000L && b->z <= 0x40002000L && b->w <= 0x40002000L;
  const int64_t dot = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->x, b->x), a->y, b->y), a->z, b->z), a->w, b->w);
  const int32_t sign = dot < 0 ? -1 : 1;
  // |a - b| <= sqrt(2) 2^30 (1 + 2^-17):  sum < 2^31.6
  const uint32_t x = gjk_scene_difference(a->x, sign * b->x), y = gjk_scene_difference(a->y, sign * b->y);
  const uint32_t z = gjk_scene_difference(a->z, sign * b->z), w = gjk_scene_difference(a->w, sign * b->w);
  const uint32_t sum = x + y + z + w;
  if (sum == 0) {
    return 0;
  }
  const uint32_t distance = length_bound(sum, larger(larger(x, y), larger(z, w)));  // distance < 2^31.2
  return distance < UINT32_C(1) << 30 ? 2 * (distance + (distance >> 15) + 1) : UINT32_MAX;
}

static uint32_t add_motion(uint32_t a, uint32_t b) {
  return a > GJK_SCENE_UNBOUNDED - b ? GJK_SCENE_UNBOUNDED : a + b;
}

// x + step, which fits: gjk_scene_part_shifts
static int32_t plus(int32_t x, int32_t step) {
  return gjk_int32((uint32_t)x + (uint32_t)step);
}

// One copy in a build for size, as the next one.
GJK_ONCE static void shift(gjk_vec3 *v, const gjk_vec3 *step) {
  v->x = plus(v->x, step->x);
  v->y = plus(v->y, step->y);
  v->z = plus(v->z, step->z);
}

static int32_t lower_by(int32_t x, gjk_q16 margin) {
  return x < INT32_MIN + margin ? INT32_MIN : x - margin;
}

static int32_t higher_by(int32_t x, gjk_q16 margin) {
  return x > INT32_MAX - margin ? INT32_MAX : x + margin;
}

// Grows a box along one axis: by margin at both sides, and by step on the side that step points to.
GJK_ONCE static void grow_side(gjk_q16 *lower, gjk_q16 *upper, int32_t margin, int32_t step) {
  *lower = lower_by(lower_by(*lower, margin), step < 0 ? -step : 0);
  *upper = higher_by(higher_by(*upper, margin), step > 0 ? step : 0);
}

// The exact box of a part, grown by margin all round, and by steps times way on the sides it points to.
//
// |way| < 2^28, steps <= 8:  |steps way| < 2^31
static gjk_aabb grown(const gjk_scene_part *p, int32_t margin, const gjk_vec3 *way, int32_t steps) {
  gjk_aabb box = p->exact;
  grow_side(&box.lower.x, &box.upper.x, margin, steps * way->x);
  grow_side(&box.lower.y, &box.upper.y, margin, steps * way->y);
  grow_side(&box.lower.z, &box.upper.z, margin, steps * way->z);
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
  p->centre = c->centre;
  p->frame[0] = c->frame[0];
  p->frame[1] = c->frame[1];
  p->frame[2] = c->frame[2];
  for (int i = 0; i < 3; i++) {
    p->fraction[i] = c->fraction[i];
  }
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

// An upper bound of the distance from a to b. UNBOUNDED when they are 2^30 or more apart along an axis.
static uint32_t distance_bound(const gjk_vec3 *a, const gjk_vec3 *b) {
  const uint32_t x = gjk_scene_difference(a->x, b->x), y = gjk_scene_difference(a->y, b->y);
  const uint32_t z = gjk_scene_difference(a->z, b->z);
  if ((x | y | z) >> 30 != 0) {
    return GJK_SCENE_UNBOUNDED;
  }
  return (x | y | z) == 0 ? 0 : length_bound(x + y + z, larger(x, larger(y, z)));
}

static uint32_t offset_bound(const gjk_vec3 *offset) {
  static const gjk_vec3 origin = {0, 0, 0};
  return (offset->x | offset->y | offset->z) == 0 ? 0 : distance_bound(offset, &origin);
}

void gjk_scene_step_between(const gjk_scene_body *body, const gjk_pose *pose, bool turns, gjk_scene_step *step) {
  step->length = distance_bound(&body->position, &pose->position);
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
  const gjk_shape_class *type = v->scene->shapes[p->shape]->type;
  if (!gjk_scene_part_turns(v, p)) {
    return UINT64_MAX;
  }
  uint32_t away = offset_bound(&p->local_centre);
  if (own_pose != GJK_SCENE_NONE) {
    away += offset_bound(&v->own_poses[own_pose].pose.position);
  } else if (away == 0 && type->kind == GJK_KIND_AXES && type->count == 0) {
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
  const gjk_vec3 outwards = {(int32_t)turned, (int32_t)turned, (int32_t)turned}, inwards = gjk_negate(outwards);
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
  p->local_centre = collider->local_centre;
  p->core_radius = collider->core_radius;
  p->state = (uint8_t)(p->state & ~GJK_SCENE_UNPOSED);
  store_collider(p, collider);
  enlarge(v, p, &p->centre, 0);
}

void gjk_scene_part_shrink_box(gjk_scene_view *v, uint32_t index) {
  gjk_scene_part_settle(v, index);
  v->parts[index].enlarged = needed_box(v, &v->parts[index]);
}
