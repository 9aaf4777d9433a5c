// One shape of a body: as a collider, and its boxes.
#include "gjk_scene_part.h"

#include "../shape/gjk_shape_class.h"
#include "gjk/pose.h"

// Posing moves vertices by roundings, before and after: offsets by less than 3 (collider.c), so by less than 6 against
// each other; and the rotation of a part with a pose of its own is rounded, by less than 2^-29, which is less than 1
// for both poses.
#define POSE_ROUNDING 8

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

// At least the length of a vector whose components have this sum and maximum: with the others b, ... at most the
// maximum a, (a + b/2 + ...)^2 >= a^2 + a b + ... >= a^2 + b^2 + ... At most a fifth too long in three dimensions. Pre:
// sum < 2^32.
static uint32_t length_bound(uint32_t sum, uint32_t largest) {
  return sum / 2 + largest / 2 + 1;
}

static uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

// |a - b|, below 2^32.
static uint32_t difference(int32_t a, int32_t b) {
  return a > b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

// Unit quaternions d apart turn points by at most 2 d times their distance: with t = angle / 4, d = 2 sin t, and a
// point moves by 2 sin 2t = 4 sin t cos t. q and -q are the same rotation. Lengths within 2^-17 of 1 change d by less
// than 2^-16 of itself.
uint32_t gjk_scene_rotation_bound(const gjk_quat *a, const gjk_quat *b) {
  //@ assert a->x >= -0x40002000L && a->y >= -0x40002000L && a->z >= -0x40002000L && a->w >= -0x40002000L;
  //@ assert a->x <= 0x40002000L && a->y <= 0x40002000L && a->z <= 0x40002000L && a->w <= 0x40002000L;
  //@ assert b->x >= -0x40002000L && b->y >= -0x40002000L && b->z >= -0x40002000L && b->w >= -0x40002000L;
  //@ assert b->x <= 0x40002000L && b->y <= 0x40002000L && b->z <= 0x40002000L && b->w <= 0x40002000L;
  const int64_t dot = gjk_mac32(gjk_mac32(gjk_mac32(gjk_mul32(a->x, b->x), a->y, b->y), a->z, b->z), a->w, b->w);
  const int32_t sign = dot < 0 ? -1 : 1;
  // The length of the difference is at most sqrt(2) 2^30 (1 + 2^-17), so the sum of its components at most 2^31.5.
  const uint32_t x = difference(a->x, sign * b->x), y = difference(a->y, sign * b->y);
  const uint32_t z = difference(a->z, sign * b->z), w = difference(a->w, sign * b->w);
  const uint32_t sum = x + y + z + w;
  if (sum == 0) {
    return 0;
  }
  const uint32_t distance = length_bound(sum, larger(larger(x, y), larger(z, w)));  // below 2^31.2
  return distance < UINT32_C(1) << 30 ? 2 * (distance + (distance >> 15) + 1) : UINT32_MAX;
}

// How far it is from a to b, or a little more; UNBOUNDED from 2^30 along an axis.
static uint32_t distance_moved(const gjk_vec3 *a, const gjk_vec3 *b) {
  const uint32_t x = difference(a->x, b->x), y = difference(a->y, b->y), z = difference(a->z, b->z);
  if ((x | y | z) >> 30 != 0) {
    return GJK_SCENE_UNBOUNDED;
  }
  return (x | y | z) == 0 ? 0 : length_bound(x + y + z, larger(x, larger(y, z)));
}

static uint32_t add_motion(uint32_t a, uint32_t b) {
  return a > GJK_SCENE_UNBOUNDED - b ? GJK_SCENE_UNBOUNDED : a + b;
}

// Bounds how far points of the part move when the collider replaces it. The same frame leaves offsets from the centre
// as they are, bit for bit.
static uint32_t motion_to(const gjk_scene_part *p, const gjk_collider *c, uint32_t turn) {
  uint32_t motion = distance_moved(&p->centre, &c->centre);
  if (!gjk_scene_same_vec3(&p->frame[0], &c->frame[0]) || !gjk_scene_same_vec3(&p->frame[1], &c->frame[1]) ||
      !gjk_scene_same_vec3(&p->frame[2], &c->frame[2])) {
    // core_radius <= 2^28 + 4 and turn < 2^32: below 2^61.
    const uint64_t turned = gjk_umul32((uint32_t)c->core_radius, turn) >> 30;
    motion = add_motion(motion, (uint32_t)turned + 1 + POSE_ROUNDING);
  }
  return motion;
}

// Grows one side of a box by margin, and by step more if that is the side it points to.
static void grow_side(gjk_q16 *lower, gjk_q16 *upper, int64_t margin, int64_t step) {
  *lower = gjk_saturate(*lower - margin + (step < 0 ? step : 0));
  *upper = gjk_saturate(*upper + margin + (step > 0 ? step : 0));
}

// Boxes that are larger by the margins of their bodies meet whenever the parts are near.
static void enlarge(gjk_scene_view *v, gjk_scene_part *p, int64_t x, int64_t y, int64_t z) {
  const int64_t margin = (int64_t)v->header->config.box_margin + v->bodies[p->body].margin;
  p->enlarged = p->exact;
  grow_side(&p->enlarged.lower.x, &p->enlarged.upper.x, margin, x);
  grow_side(&p->enlarged.lower.y, &p->enlarged.upper.y, margin, y);
  grow_side(&p->enlarged.lower.z, &p->enlarged.upper.z, margin, z);
}

// What the box in the tree must hold: the exact one, with the body's margin all round.
static gjk_aabb needed_box(const gjk_scene_view *v, const gjk_scene_part *p) {
  gjk_aabb needed = p->exact;
  const int64_t margin = v->bodies[p->body].margin;
  if (margin != 0) {
    grow_side(&needed.lower.x, &needed.upper.x, margin, 0);
    grow_side(&needed.lower.y, &needed.upper.y, margin, 0);
    grow_side(&needed.lower.z, &needed.upper.z, margin, 0);
  }
  return needed;
}

static bool has_room(const gjk_scene_view *v, const gjk_scene_part *p) {
  const gjk_aabb needed = needed_box(v, p);
  return gjk_aabb_inside(&needed, &p->enlarged);
}

static void take_over(gjk_scene_part *p, const gjk_collider *c) {
  p->centre = c->centre;
  p->frame[0] = c->frame[0];
  p->frame[1] = c->frame[1];
  p->frame[2] = c->frame[2];
  for (int i = 0; i < 3; i++) {
    p->fraction[i] = c->fraction[i];
  }
  (void)gjk_collider_aabb(c, &p->exact);  // posed, so it cannot fail
}

bool gjk_scene_part_moved(gjk_scene_view *v, uint32_t index, const gjk_collider *collider, uint32_t turn, bool ahead) {
  gjk_scene_part *p = &v->parts[index];
  const gjk_vec3 before = p->centre;
  p->motion = add_motion(p->motion, motion_to(p, collider, turn));
  take_over(p, collider);
  if (has_room(v, p)) {
    return false;
  }
  // For four more such steps, at most 2^34.
  const int64_t x = 4 * ((int64_t)p->centre.x - before.x), y = 4 * ((int64_t)p->centre.y - before.y);
  const int64_t z = 4 * ((int64_t)p->centre.z - before.z);
  enlarge(v, p, ahead ? x : 0, ahead ? y : 0, ahead ? z : 0);
  return true;
}

void gjk_scene_part_reset(gjk_scene_view *v, uint32_t index, const gjk_collider *collider) {
  gjk_scene_part *p = &v->parts[index];
  p->motion = GJK_SCENE_UNBOUNDED;
  p->local_centre = collider->local_centre;
  p->core_radius = collider->core_radius;
  take_over(p, collider);
  enlarge(v, p, 0, 0, 0);
}

void gjk_scene_part_shrink_box(gjk_scene_view *v, uint32_t index) {
  v->parts[index].enlarged = needed_box(v, &v->parts[index]);
}
