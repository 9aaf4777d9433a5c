// A triangle of a surface as a body sees it.
#include "gjk_surface_face.h"

#include "../arith/gjk_unit.h"
#include "gjk/mesh.h"

// More is far, along an axis, in steps of 2 LSB.
#define CORNER_MAX (INT32_C(3) << 27)

// LSB. The least height of an edge's end above or below the plane that no rounding of the normal makes up: that is off by less
// than 2^-28 of the way from a corner of the triangle, below 2^30 for points of the body that lie over it.
#define CLEAR 8

// *out = world - centre; false: it is far.
static bool relate_axis(int32_t world, int32_t centre, int32_t *out) {
  const int32_t half = gjk_sar32(world, 1) - gjk_sar32(centre, 1);
  if (half > CORNER_MAX || half < -CORNER_MAX) {
    return false;
  }
  *out = world - centre;
  return true;
}

static bool relate(const gjk_vec3 *world, const gjk_vec3 *centre, gjk_vec3 *out) {
  return relate_axis(world->x, centre->x, &out->x) && relate_axis(world->y, centre->y, &out->y) &&
         relate_axis(world->z, centre->z, &out->z);
}

void gjk_face_find(const gjk_parts_frame *frame, uint32_t number, gjk_surface_face *f) {
  gjk_parts_room room;
  gjk_parts_local local;
  f->number = number;
  (void)frame->parts->type->local(frame->parts->data, number, &room, &local);
  for (unsigned i = 0; i < 3; i++) {
    gjk_set(&room.vertices[i], &f->local[i]);
  }
}

bool gjk_face_turn(const gjk_parts_frame *frame, const gjk_collider *body, gjk_surface_face *f) {
  const gjk_vec3 *centre = &body->centre;
  return gjk_triangle_turn(frame, f->local, f->world) && relate(&f->world[0], centre, &f->corner[0]) &&
         relate(&f->world[1], centre, &f->corner[1]) && relate(&f->world[2], centre, &f->corner[2]);
}

GJK_ONE_COPY static void exchange_last(gjk_vec3 v[3]) {
  const gjk_vec3 second = v[1];
  gjk_set(&v[2], &v[1]);
  gjk_set(&second, &v[2]);
}

// Turns a face to its other side: its first corner stays. What is convex from one side is concave from the other: 2 and 0, the
// kinds that are even.
static void turn_over(gjk_surface_face *f) {
  const unsigned edges = GJK_TRIANGLE_EDGES(GJK_TRIANGLE_EDGE(f->edges, 2), GJK_TRIANGLE_EDGE(f->edges, 1),
                                            GJK_TRIANGLE_EDGE(f->edges, 0));
  const unsigned even = ~edges & GJK_TRIANGLE_EDGES(1, 1, 1);
  exchange_last(f->local);
  exchange_last(f->world);
  exchange_last(f->corner);
  f->edges = GJK_TRIANGLE_TWO_SIDED | (edges ^ even << 1);
}

// How many half axes the body is a sum of. 0: it is something else.
static unsigned axes_of(const gjk_collider *body) {
  return body->shape->type->kind == GJK_KIND_AXES ? body->count : 0;
}

//   |half axis| <= 2^28, |corner| < 2^30.4:                          |along| < 2^59
//   margin, convex radius <= 2^28 each, |half axis| <= 2^29.6 by its components:  |reach| < 2^61
bool gjk_face_is_aside(const gjk_collider *body, gjk_q16 margin, const gjk_surface_face *f) {
  const unsigned count = axes_of(body);
  for (unsigned i = 0; i < count; i++) {
    const gjk_vec3 *axis = &body->frame[i];
    int64_t reach = ((int64_t)margin + body->shape->convex_radius) * gjk_norm1(*axis);
    for (unsigned k = 0; k < count; k++) {
      const int64_t part = gjk_dot(axis, &body->frame[k]);
      reach += part < 0 ? -part : part;
    }
    const int64_t first = gjk_dot(axis, &f->corner[0]);
    bool aside = (first < 0 ? -first : first) > reach;
    for (unsigned k = 1; k < 3 && aside; k++) {
      const int64_t along = gjk_dot(axis, &f->corner[k]);
      aside = (first < 0 ? -along : along) > reach;
    }
    if (aside) {
      return true;
    }
  }
  return false;
}

bool gjk_face_set(const gjk_parts_frame *frame, const gjk_collider *body, gjk_surface_face *f) {
  const gjk_shape_class *type = body->shape->type;
  gjk_long3 n;
  gjk_search_direction along;
  gjk_support front, back;
  f->edges = frame->parts->type->edges(frame->parts->data, f->number);
  gjk_triangle_normal(&f->corner[0], &f->corner[1], &f->corner[2], &n);
  if ((n.x | n.y | n.z) == 0) {
    return false;
  }
  gjk_search_direction_of(&n, &along);
  const gjk_vec3 down = gjk_negate(along.d);
  type->support(body, &down, &back);
  if (type->kind == GJK_KIND_AXES) {
    front.offset = gjk_negate(back.offset);
  } else {
    type->support(body, &along.d, &front);
  }
  const gjk_vec3 sum = gjk_add(front.offset, back.offset), *at = &f->corner[0];
  const gjk_vec3 middle = {gjk_sar32(sum.x, 1) - at->x, gjk_sar32(sum.y, 1) - at->y, gjk_sar32(sum.z, 1) - at->z};
  if (gjk_dot_sign(&n, &middle) < 0) {  // |middle| < 2^31
    if ((f->edges & GJK_TRIANGLE_TWO_SIDED) == 0) {
      return false;
    }
    turn_over(f);
    gjk_set(&down, &along.d);
    gjk_set(&front.offset, &back.offset);
  }
  gjk_set(&along.d, &f->direction);
  gjk_set(&back.offset, &f->deepest);
  f->unit = gjk_unit(&along.d);
  const gjk_vec3 above = gjk_sub(back.offset, f->corner[0]);  // below 2^31 long:  the product below 2^61
  f->height = (gjk_q16)gjk_sar64(gjk_along(&f->unit, &above) + (INT64_C(1) << 29), 30) - body->shape->convex_radius;
  return true;
}

//   |direction| <= sqrt(3) 2^30, |edge| < 2^29, |to| < 2^31.5
bool gjk_face_is_over(const gjk_surface_face *f, const gjk_vec3 *point) {
  for (unsigned i = 0; i < 3; i++) {
    const gjk_vec3 edge = gjk_sub(f->corner[gjk_next(i)], f->corner[i]), to = gjk_sub(*point, f->corner[i]);
    gjk_long3 inward;
    gjk_cross(&f->direction, &edge, &inward);
    if (gjk_dot_sign(&inward, &to) < 0) {
      return false;
    }
  }
  return true;
}

// A coordinate moved by a length along the normal.
GJK_ONE_COPY static int32_t moved_along(int32_t centre, int32_t offset, int32_t normal, gjk_q16 by) {
  const int64_t half = INT64_C(1) << 29;
  return gjk_saturate((int64_t)centre + offset + gjk_sar64(gjk_mul32(normal, by) + half, 30));
}

static void move_deepest(const gjk_vec3 *centre, const gjk_surface_face *f, gjk_q16 by, gjk_vec3 *out) {
  const gjk_vec3 *p = &f->deepest;
  out->x = moved_along(centre->x, p->x, f->unit.x, by);
  out->y = moved_along(centre->y, p->y, f->unit.y, by);
  out->z = moved_along(centre->z, p->z, f->unit.z, by);
}

void gjk_face_move_deepest(const gjk_collider *body, const gjk_surface_face *f, gjk_q16 by, gjk_vec3 *out) {
  move_deepest(&body->centre, f, by, out);
}

// x, by at most `by` nearer to a third of a sum, which is found to within 1 and 2^-17 of the way there. The face is within the
// margin, so x is at most 3 2^28 + 3 in size, as sum / 3 is.
GJK_ONE_COPY static int32_t pulled(int32_t x, int64_t sum, int32_t by) {
  const int32_t third = (int32_t)gjk_sar64((sum - 3 * (int64_t)x) * 21845, 16);  // below 2^30.6 in size
  return x + (third > by ? by : third < -by ? -by : third);
}

bool gjk_face_is_nearly_over(const gjk_collider *body, const gjk_surface_face *f) {
  static const gjk_vec3 centre = {0, 0, 0};
  const gjk_vec3 *c = f->corner;
  gjk_vec3 foot;  // of the deepest point on the plane
  if (f->height < 0) {
    return false;
  }
  const int32_t h = f->height + body->shape->convex_radius, by = 8 + gjk_sar32(h, 6);
  move_deepest(&centre, f, -h, &foot);
  foot.x = pulled(foot.x, (int64_t)c[0].x + c[1].x + c[2].x, by);
  foot.y = pulled(foot.y, (int64_t)c[0].y + c[1].y + c[2].y, by);
  foot.z = pulled(foot.z, (int64_t)c[0].z + c[1].z + c[2].z, by);
  return gjk_face_is_over(f, &foot);
}

// The edge taken is the steepest to the plane. What lies over the triangle is a prism, so all of the edge is in it if both ends
// are, and meets the plane in the triangle if one end is above the plane and one below.
bool gjk_face_is_pierced(const gjk_collider *body, const gjk_surface_face *f) {
  const unsigned count = axes_of(body);
  const int64_t bottom = (int64_t)f->height + body->shape->convex_radius;  // of the core
  int32_t most = 0;
  gjk_vec3 way = {0, 0, 0};
  for (unsigned i = 0; i < count; i++) {
    const gjk_vec3 *axis = &body->frame[i];
    const int32_t along = (int32_t)gjk_sar64(gjk_along(&f->unit, axis), 30);
    const int32_t rise = along < 0 ? -along : along;
    if (rise > most) {
      most = rise;
      way = along < 0 ? gjk_negate(*axis) : *axis;
    }
  }
  const gjk_vec3 top = gjk_add(f->deepest, gjk_add(way, way));
  return bottom <= -CLEAR && bottom + most + most >= CLEAR + 2 && gjk_face_is_over(f, &top);
}

bool gjk_face_is_pointed(const gjk_collider *body, const gjk_surface_face *f) {
  bool pointed = body->shape->type->kind == GJK_KIND_AXES;
  for (unsigned i = 0; pointed && i < body->count; i++) {
    pointed = gjk_magnitude64(gjk_along(&f->unit, &body->frame[i])) > (uint64_t)GJK_FACE_LEVEL << 30;
  }
  return pointed;
}
