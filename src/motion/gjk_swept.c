// The class of swept shapes: each function asks that of the shape that is swept, and then which end of the way is farther.
#include "gjk_swept.h"

#include "../arith/gjk_root.h"

static const gjk_swept *swept_of(const gjk_collider *c) {
  return (const gjk_swept *)c->shape->user;
}

// Makes a vertex of B one of the swept shape, at the end of the way or at its start.
static void move_to(const gjk_swept *s, bool end, gjk_support *at) {
  at->offset = gjk_add(at->offset, end ? s->ahead : s->back);
  at->vertex = (uint16_t)(at->vertex + (end ? s->count : 0));
}

static void support_swept(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_swept *s = swept_of(c);
  const gjk_vec3 way = gjk_sub(s->ahead, s->back);
  s->b->shape->type->support(s->b, d, out);
  move_to(s, gjk_dot(&way, d) > 0, out);  // |way| < 2^30, |d| <= 2^31
}

// Vertices that direction->level names hold for B as well: those at the start have B's numbers, and B has no number of those
// at the end; of half axes, two of either kind differ by what B's differ by.
static bool refine_swept(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
  const gjk_swept *s = swept_of(c);
  const gjk_vec3 way = gjk_sub(s->ahead, s->back);
  const uint16_t before = at->vertex;
  const int side = gjk_direction_sign(direction, &way);
  const bool end = before >= s->count;
  at->offset = gjk_sub(at->offset, end ? s->ahead : s->back);
  at->vertex = (uint16_t)(before - (end ? s->count : 0));
  s->b->shape->type->refine(s->b, d, direction, at);
  if (s->b->shape->type->kind == GJK_KIND_AXES) {
    direction->ties = (1u << direction->ties) - 1;
  }
  if (side == 0) {
    direction->ties = 2 * direction->ties + 1;  // at either end
  }
  move_to(s, side != 0 ? side > 0 : end, at);
  return at->vertex != before;
}

static bool vertex_swept(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  const gjk_swept *s = swept_of(c);
  const bool end = number >= s->count;
  if (!s->b->shape->type->vertex(s->b, (uint16_t)(number - (end ? s->count : 0)), offset)) {
    return false;
  }
  *offset = gjk_add(*offset, end ? s->ahead : s->back);
  return true;
}

static const gjk_shape_class swept_class = {
    .measure = NULL,
    .pose = NULL,
    .support = support_swept,
    .refine = refine_swept,
    .vertex = vertex_swept,
    .stalls = NULL,
    .close = NULL,
    .concave = NULL,
    .buffered = false,
    .count = 0,
    .kind = GJK_KIND_VERTICES,
};

// *to = *from, without a call of memcpy.
static void copy_collider(gjk_collider *to, const gjk_collider *from) {
  to->shape = from->shape;
  to->buffer = from->buffer;
  to->position = from->position;
  to->centre = from->centre;
  to->local_centre = from->local_centre;
  for (unsigned i = 0; i < 3; i++) {
    to->frame[i] = from->frame[i];
    to->fraction[i] = from->fraction[i];
  }
  to->core_radius = from->core_radius;
  to->radius = from->radius;
  to->state = from->state;
  to->count = from->count;
  to->bits = from->bits;
}

// A whole number of LSB that is at least half the way's length. Pre: components below 2^30 in size.
static int32_t half_length(const gjk_vec3 *t) {
  const int64_t square = gjk_dot(t, t);  // below 3 2^60
  return (int32_t)((gjk_isqrt64((uint64_t)square) >> 1) + 2);
}

// One axis: B's place against A's at the middle of the way, rounded down. A's own is half of it, so that both fit.
static int32_t part_of(int64_t apart, int32_t *other) {
  const int32_t half = (int32_t)gjk_sar64(apart, 1);
  *other = (int32_t)(half - apart);
  return half;
}

bool gjk_swept_set(gjk_swept *s, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  const int64_t limit = INT64_C(1) << 30;
  const uint32_t count = b->shape->type->kind == GJK_KIND_AXES ? UINT32_C(1) << b->count : b->count;
  const gjk_long3 *t = &way->t;
  if (t->x >= limit || t->x <= -limit || t->y >= limit || t->y <= -limit || t->z >= limit || t->z <= -limit ||
      count > INT16_MAX) {
    return false;
  }
  const gjk_vec3 whole = {(int32_t)t->x, (int32_t)t->y, (int32_t)t->z};
  const int32_t length = half_length(&whole);  // below 2^30
  if (a->core_radius + b->core_radius + length >= (INT32_C(1) << 29) - (INT32_C(1) << 17)) {
    return false;
  }
  s->b = b;
  s->count = (uint16_t)count;
  s->ahead.x = whole.x - gjk_sar32(whole.x, 1);
  s->ahead.y = whole.y - gjk_sar32(whole.y, 1);
  s->ahead.z = whole.z - gjk_sar32(whole.z, 1);
  s->back = gjk_sub(s->ahead, whole);
  s->shape.type = &swept_class;
  s->shape.user = s;
  s->shape.convex_radius = b->shape->convex_radius;
  copy_collider(&s->still, a);
  s->swept.shape = &s->shape;
  s->swept.buffer = NULL;
  s->swept.count = (uint16_t)(2 * count);
  s->swept.state = GJK_STATE_POSED;
  s->swept.core_radius = b->core_radius + length;
  s->swept.radius = b->radius + length;
  // A at the start stands at centre_a, B's middle at centre_b - back.
  const gjk_vec3 *ca = &a->centre, *cb = &b->centre;
  s->still.centre.x = part_of((int64_t)ca->x - cb->x + s->back.x, &s->swept.centre.x);
  s->still.centre.y = part_of((int64_t)ca->y - cb->y + s->back.y, &s->swept.centre.y);
  s->still.centre.z = part_of((int64_t)ca->z - cb->z + s->back.z, &s->swept.centre.z);
  return true;
}
