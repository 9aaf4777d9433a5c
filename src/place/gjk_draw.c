// The outlines of colliders and boxes, for debug drawing.
#include "gjk/draw.h"

#include "../arith/gjk_circle.h"
#include "../shape/gjk_shape_class.h"

typedef struct drawn_outline {
  const gjk_draw *draw;
  const gjk_collider *c;
  gjk_draw_role role;
} drawn_outline;

static void draw_line(const drawn_outline *o, const gjk_vec3 *from, const gjk_vec3 *to) {
  if (o->draw->line != NULL && (from->x != to->x || from->y != to->y || from->z != to->z)) {
    o->draw->line(o->draw->user, from, to, o->role);
  }
}

// An offset from the centre, and so far along a unit vector, in the world.
//
// centre < 2^31, |offset| < 2^28 + 2^3, radius <= 2^28, and the unit vector's components are at most 2^30
static gjk_vec3 place_in_world(const gjk_collider *c, const gjk_vec3 *offset, const gjk_vec3 *unit, gjk_q16 radius) {
  const int64_t half = INT64_C(1) << 29;
  const gjk_vec3 at = {
      gjk_saturate((int64_t)c->centre.x + offset->x + gjk_sar64(gjk_mul32(unit->x, radius) + half, 30)),
      gjk_saturate((int64_t)c->centre.y + offset->y + gjk_sar64(gjk_mul32(unit->y, radius) + half, 30)),
      gjk_saturate((int64_t)c->centre.z + offset->z + gjk_sar64(gjk_mul32(unit->z, radius) + half, 30))};
  return at;
}

// Pre: the vertex exists.
static gjk_vec3 vertex_in_world(const drawn_outline *o, unsigned number) {
  const gjk_vec3 none = {0, 0, 0};
  gjk_vec3 offset;
  (void)o->c->shape->type->vertex(o->c, (uint16_t)number, &offset);
  return place_in_world(o->c, &offset, &none, 0);
}

static void draw_edge(const drawn_outline *o, unsigned i, unsigned j) {
  const gjk_vec3 from = vertex_in_world(o, i), to = vertex_in_world(o, j);
  draw_line(o, &from, &to);
}

// Vertices whose numbers differ in one bit share an edge.
static void draw_axes(const drawn_outline *o) {
  const unsigned axes = o->c->count;
  if (axes == 0 && o->c->shape->convex_radius == 0 && o->draw->point != NULL) {
    const gjk_vec3 at = vertex_in_world(o, 0);
    o->draw->point(o->draw->user, &at, o->role);
  }
  for (unsigned i = 0; i < 1u << axes; i++) {
    for (unsigned axis = 0; axis < axes; axis++) {
      if ((i >> axis & 1u) == 0) {
        draw_edge(o, i, i | 1u << axis);
      }
    }
  }
}

// Of the two faces at an edge one has it from the lower vertex to the higher one.
static void draw_faces(const drawn_outline *o, const gjk_hull_faces *faces) {
  unsigned first = 0;
  for (unsigned face = 0; face < faces->count; face++) {
    const unsigned end = faces->end[face];
    for (unsigned i = first; i < end; i++) {
      const unsigned from = faces->corner[i], to = faces->corner[i + 1 < end ? i + 1 : first];
      if (from < to) {
        draw_edge(o, from, to);
      }
    }
    first = end;
  }
}

// The silhouette as seen along an axis of the world.
static void draw_silhouette(const drawn_outline *o, unsigned axis) {
  const gjk_shape *shape = o->c->shape;
  gjk_vec3 first = {0, 0, 0}, last = {0, 0, 0};
  for (unsigned i = 0; i < GJK_DRAW_DIRECTIONS; i++) {
    gjk_vec3 d = {0, 0, 0};
    gjk_support far;
    gjk_circle(i, axis == 0 ? &d.y : &d.x, axis == 2 ? &d.y : &d.z);
    shape->type->support(o->c, &d, &far);
    const gjk_vec3 at = place_in_world(o->c, &far.offset, &d, shape->convex_radius);
    if (i == 0) {
      first = at;
    } else {
      draw_line(o, &last, &at);
    }
    last = at;
  }
  draw_line(o, &last, &first);
}

gjk_status gjk_draw_collider(const gjk_draw *draw, const gjk_collider *collider, gjk_draw_role role) {
  if (draw == NULL || collider == NULL) {
    return GJK_ERROR_NULL;
  }
  if (collider->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  const drawn_outline o = {draw, collider, role};
  const gjk_shape *shape = collider->shape;
  const bool triangle = shape->type->kind == GJK_KIND_VERTICES && !shape->type->buffered;
  const gjk_hull_faces *faces = shape->type->buffered ? shape->faces : NULL;
  if (shape->type->kind == GJK_KIND_AXES) {
    draw_axes(&o);
  } else if (triangle) {
    draw_edge(&o, 0, 1);
    draw_edge(&o, 1, 2);
    draw_edge(&o, 2, 0);
  } else if (faces != NULL) {
    draw_faces(&o, faces);
  }
  const bool by_edges = shape->type->kind == GJK_KIND_AXES || triangle || faces != NULL;
  for (unsigned axis = 0; axis < 3 && (!by_edges || shape->convex_radius > 0); axis++) {
    draw_silhouette(&o, axis);
  }
  return GJK_OK;
}

gjk_status gjk_draw_box(const gjk_draw *draw, const gjk_aabb *box, gjk_draw_role role) {
  if (draw == NULL || box == NULL) {
    return GJK_ERROR_NULL;
  }
  const drawn_outline o = {draw, NULL, role};
  for (unsigned i = 0; i < 8; i++) {
    const gjk_vec3 from = {(i & 1u) == 0 ? box->lower.x : box->upper.x, (i & 2u) == 0 ? box->lower.y : box->upper.y,
                           (i & 4u) == 0 ? box->lower.z : box->upper.z};
    const gjk_vec3 x = {box->upper.x, from.y, from.z}, y = {from.x, box->upper.y, from.z};
    const gjk_vec3 z = {from.x, from.y, box->upper.z};
    draw_line(&o, &from, &x);
    draw_line(&o, &from, &y);
    draw_line(&o, &from, &z);
  }
  return GJK_OK;
}
