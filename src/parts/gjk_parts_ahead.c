// Casts and impacts with those parts alone that B is in front of at the start.
//
// A class of its own stands for A: its walk leaves out the parts that B is not in front of. All else is A's own, so the
// queries are those of gjk_parts_cast.c and gjk_parts_impact.c.
#include "gjk_parts_ahead.h"
#include "../arith/gjk_memory.h"
#include "../arith/gjk_unit.h"

// A height errs by less than this, LSB:
//
// the unit vector  sqrt(3) 2^-30 of at most sqrt(3) 2^31, to the triangle, and 2^28, to the support: 8
// a support        less than 1 beyond the farthest along the rounded direction, of curved shapes 2
#define AHEAD_ERROR 12

// A, and both at either end of the whole way.
typedef struct ahead_body {
  const gjk_parts *own;
  gjk_parts pose[2];
  gjk_parts_frame frame[2];
  gjk_collider b[2];
  gjk_q16 near;   // what is so near B at the start is not in front of it
  int64_t aside;  // triangles so near count only if B goes through their planes
} ahead_body;

// Heights have so many bits after the point: rounded by less than an LSB together, and not at all of a plane across an axis.
#define HEIGHT_BITS 16

// What of B's height above a plane there is, LSB with HEIGHT_BITS, convex radius included: below 2^50.
typedef struct ahead_height {
  int64_t lowest, highest;
} ahead_height;

static const ahead_body *ahead_of(const void *data) {
  return (const ahead_body *)data;
}

// |v| < 2^31 per axis:  the sum below 2^61.8, shifted below 2^48
GJK_ONE_COPY static int64_t up_along(const gjk_unit3 *up, const gjk_vec3 *v) {
  return gjk_sar64(gjk_mac32(gjk_mac32(gjk_mul32(up->x, v->x), up->y, v->y), up->z, v->z), 30 - HEIGHT_BITS);
}

// Measures B above the plane of a triangle at one end of the way. False: there is no plane, or it is far away. Of planes
// across an axis it is exact.
static bool measure_height(const ahead_body *d, unsigned end, uint32_t number, ahead_height *out) {
  gjk_parts_room room;
  gjk_collider t;
  gjk_long3 n;
  gjk_search_direction along;
  gjk_support low, high;
  const gjk_collider *b = &d->b[end];
  if (d->own->type->place(&d->frame[end], number, &room, &t) != GJK_OK) {
    return false;
  }
  gjk_triangle_normal(&t.frame[0], &t.frame[1], &t.frame[2], &n);
  const int64_t x = (int64_t)b->centre.x - t.centre.x - t.frame[0].x;
  const int64_t y = (int64_t)b->centre.y - t.centre.y - t.frame[0].y;
  const int64_t z = (int64_t)b->centre.z - t.centre.z - t.frame[0].z;
  if ((n.x == 0 && n.y == 0 && n.z == 0) || (gjk_magnitude64(x) | gjk_magnitude64(y) | gjk_magnitude64(z)) >> 31 != 0) {
    return false;
  }
  gjk_search_direction_of(&n, &along);
  const gjk_vec3 down = gjk_negate(along.d), step = {(int32_t)x, (int32_t)y, (int32_t)z};
  const gjk_unit3 up = gjk_unit(&along.d);
  b->shape->type->support(b, &along.d, &high);
  b->shape->type->support(b, &down, &low);
  const int64_t at = up_along(&up, &step), radius = gjk_shl64(b->shape->convex_radius, HEIGHT_BITS);
  out->lowest = at + up_along(&up, &low.offset) - radius;
  out->highest = at + up_along(&up, &high.offset) + radius;
  return true;
}

static bool is_mostly_behind(const ahead_height *h) {
  return h->lowest + h->highest < 0;
}

// Is B at most a distance away from a part at the start? A part that cannot tell, which the query that follows meets with
// the same status, counts as away.
static bool is_near_part(const ahead_body *d, uint32_t number, int64_t distance) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_decision decision;
  return d->own->type->place(&d->frame[0], number, &room, &c) == GJK_OK &&
         gjk_within(&c, &d->b[0], gjk_saturate(distance), NULL, &decision) == GJK_OK && decision.yes;
}

// Of two sides the one counts that most of B is on. Where a height may be wrong the triangle tells whether B touches it, and
// B has to go through its plane. A triangle whose corners lie in a line has no plane: whatever is near it was so at the start.
static bool is_before_triangle(const ahead_body *d, uint32_t number) {
  ahead_height start, end;
  if (!measure_height(d, 0, number, &start)) {
    return !is_near_part(d, number, d->near + d->aside);
  }
  const bool two_sided = (d->own->type->edges(d->own->data, number) & GJK_TRIANGLE_TWO_SIDED) != 0;
  const bool behind = two_sided && is_mostly_behind(&start);
  const int64_t gap = (behind ? -start.highest : start.lowest) - gjk_shl64(d->near, HEIGHT_BITS);
  const int64_t error = gjk_shl64(AHEAD_ERROR, HEIGHT_BITS);
  if (gap <= -error || (gap <= error && is_near_part(d, number, d->near))) {
    return false;
  }
  return (gap > 0 && gap > gjk_shl64(d->aside, HEIGHT_BITS)) ||
         (measure_height(d, 1, number, &end) && is_mostly_behind(&end) != behind);
}

static bool is_before_part(const ahead_body *d, uint32_t number) {
  return d->own->type->edges != NULL ? is_before_triangle(d, number) : !is_near_part(d, number, d->near);
}

static uint32_t ahead_count(const void *data) {
  const gjk_parts *own = ahead_of(data)->own;
  return own->type->count(own->data);
}

static uint32_t ahead_reach(const void *data) {
  const gjk_parts *own = ahead_of(data)->own;
  return own->type->reach(own->data);
}

// None: it could be one that is left out.
static uint32_t ahead_guess(const void *data, const gjk_region *region) {
  (void)data, (void)region;
  return GJK_PARTS_NONE;
}

static bool ahead_next(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  const ahead_body *d = ahead_of(data);
  while (d->own->type->next(d->own->data, region, walk, number)) {  // ends: each part comes once
    if (is_before_part(d, *number)) {
      return true;
    }
  }
  return false;
}

static gjk_status ahead_place(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room, gjk_collider *out) {
  const gjk_parts *own = ahead_of(frame->parts->data)->own;
  const gjk_parts posed = {own->type, own->data, frame->parts->pose};
  gjk_parts_frame of_own;
  gjk_copy(&of_own, frame, sizeof of_own);
  of_own.parts = &posed;
  return own->type->place(&of_own, number, room, out);
}

static gjk_status ahead_local(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  const gjk_parts *own = ahead_of(data)->own;
  return own->type->local(own->data, number, room, out);
}

static const gjk_parts_class class_of_ahead = {
    .count = ahead_count,
    .reach = ahead_reach,
    .guess = ahead_guess,
    .next = ahead_next,
    .place = ahead_place,
    .local = ahead_local,
    .settle = NULL,
    .meet = NULL,
    .edges = NULL,
};

// Sets both where they are at one end of the way. b: bound to its shape.
static gjk_status set_end(ahead_body *d, unsigned end, const gjk_pose *pose, const gjk_collider *b,
                          const gjk_pose *pose_b) {
  d->pose[end].type = d->own->type;
  d->pose[end].data = d->own->data;
  gjk_copy(&d->pose[end].pose, pose, sizeof *pose);
  gjk_copy(&d->b[end], b, sizeof *b);
  if (pose_b != NULL) {
    d->b[end].buffer = NULL;  // B's own holds its vertices as B is posed
  }
  const gjk_status status = pose_b != NULL ? gjk_collider_pose(&d->b[end], pose_b) : GJK_OK;
  return status == GJK_OK ? gjk_parts_frame_set(&d->frame[end], &d->pose[end]) : status;
}

gjk_status gjk_parts_cast_ahead(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path, uint32_t *part,
                                gjk_cast_result *out) {
  ahead_body d;
  gjk_aabb box;
  gjk_pose to_a;
  gjk_status status = a == NULL || path == NULL ? GJK_ERROR_NULL : gjk_collider_aabb(b, &box);
  if (status != GJK_OK) {
    return status;
  }
  d.own = a;
  d.near = path->margin;
  d.aside = 0;
  gjk_copy(&to_a, &a->pose, sizeof to_a);
  to_a.position = path->to_a != NULL ? *path->to_a : to_a.position;
  status = set_end(&d, 0, &a->pose, b, NULL);
  if (status != GJK_OK) {
    return status;
  }
  // An end that is out of range the cast refuses.
  if (set_end(&d, 1, &to_a, b, NULL) != GJK_OK ||
      (path->to_b != NULL && gjk_collider_move(&d.b[1], path->to_b) != GJK_OK)) {
    return gjk_parts_cast(a, b, path, part, out);
  }
  const gjk_parts ahead = {&class_of_ahead, &d, a->pose};
  return gjk_parts_cast(&ahead, b, path, part, out);
}

// Both impacts. near: what is so near B at the start is not in front of it.
static gjk_status ask_impact_ahead(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                   const gjk_motion *motion_b, const gjk_motion *way_a, const gjk_motion *way_b,
                                   gjk_q16 near, const gjk_impact_setup *setup, uint32_t *part,
                                   gjk_impact_result *out) {
  ahead_body d;
  d.own = a;
  d.near = near;
  d.aside = (int64_t)setup->margin - near + setup->tolerance;
  gjk_status status = set_end(&d, 0, &way_a->from, b, &way_b->from);
  status = status == GJK_OK ? set_end(&d, 1, &way_a->to, b, &way_b->to) : status;
  if (status != GJK_OK) {
    return status;
  }
  const gjk_parts ahead = {&class_of_ahead, &d, a->pose};
  return gjk_parts_time_of_impact(&ahead, motion_a, b, motion_b, setup, part, out);
}

gjk_status gjk_parts_impact_ahead_of(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                     const gjk_motion *motion_b, const gjk_motion *way_a, const gjk_motion *way_b,
                                     const gjk_impact_setup *setup, uint32_t *part, gjk_impact_result *out) {
  return ask_impact_ahead(a, motion_a, b, motion_b, way_a, way_b, 0, setup, part, out);
}

gjk_status gjk_parts_impact_ahead(const gjk_parts *a, const gjk_motion *motion_a, const gjk_collider *b,
                                  const gjk_motion *motion_b, const gjk_impact_setup *setup, uint32_t *part,
                                  gjk_impact_result *out) {
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL) {
    return GJK_ERROR_NULL;
  }
  return ask_impact_ahead(a, motion_a, b, motion_b, motion_a, motion_b, setup->margin, setup, part, out);
}
