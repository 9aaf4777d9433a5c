// The outlines of colliders and boxes in the plane, for debug drawing.
#include "gjk2/draw.h"

#include "../arith/gjk_circle.h"
#include "gjk2_class.h"

typedef struct drawn_polygon {
  const gjk2_draw *draw;
  gjk_draw_role role;
  unsigned points;  // so far
  gjk2_vec first, last;
} drawn_polygon;

static void draw_side(const drawn_polygon *p, const gjk2_vec *from, const gjk2_vec *to) {
  if (p->draw->line != NULL && (from->x != to->x || from->y != to->y)) {
    p->draw->line(p->draw->user, from, to, p->role);
  }
}

// Goes on to the next corner.
static void draw_corner(drawn_polygon *p, const gjk2_vec *at) {
  if (p->points == 0) {
    p->first = *at;
  } else {
    draw_side(p, &p->last, at);
  }
  p->last = *at;
  p->points++;
}

// An offset from the centre, and so far along a unit vector, in the world.
//
// centre < 2^31, |offset| < 2^28 + 2^3, radius <= 2^28, and the unit vector's components are at most 2^30
static gjk2_vec plane_in_world(const gjk2_collider *c, const gjk2_vec *offset, const gjk2_vec *unit, gjk_q16 radius) {
  const int64_t half = INT64_C(1) << 29;
  const gjk2_vec at = {
      gjk_saturate((int64_t)c->centre.x + offset->x + gjk_sar64(gjk_mul32(unit->x, radius) + half, 30)),
      gjk_saturate((int64_t)c->centre.y + offset->y + gjk_sar64(gjk_mul32(unit->y, radius) + half, 30))};
  return at;
}

// The vertices, one after the other round the shape. Pre: they are ordered.
static void draw_vertices(drawn_polygon *p, const gjk2_collider *c) {
  const gjk2_vec none = {0, 0};
  gjk2_support at = {{0, 0}, 0}, way;
  (void)c->shape->type->vertex(c, 0, &at.offset);  // there is one
  for (unsigned i = 0; i < c->count; i++) {
    const gjk2_vec corner = plane_in_world(c, &at.offset, &none, 0);
    draw_corner(p, &corner);
    c->shape->type->adjacent(c, &at, true, &way);
    gjk2_follow(&at, &way);
  }
}

static void draw_directions(drawn_polygon *p, const gjk2_collider *c) {
  for (unsigned i = 0; i < GJK_DRAW_DIRECTIONS; i++) {
    gjk2_vec d;
    gjk2_support far;
    gjk_circle(i, &d.x, &d.y);
    c->shape->type->support(c, &d, &far);
    const gjk2_vec at = plane_in_world(c, &far.offset, &d, c->shape->convex_radius);
    draw_corner(p, &at);
  }
}

gjk_status gjk2_draw_collider(const gjk2_draw *draw, const gjk2_collider *collider, gjk_draw_role role) {
  if (draw == NULL || collider == NULL) {
    return GJK_ERROR_NULL;
  }
  if (collider->state != GJK2_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  drawn_polygon p = {draw, role, 0, {0, 0}, {0, 0}};
  const bool sharp = !gjk2_is_curved(collider->shape) && collider->shape->convex_radius == 0;
  if (sharp && (collider->ordered || collider->count < 3)) {
    draw_vertices(&p, collider);
  } else {
    draw_directions(&p, collider);
  }
  if (p.points > 2) {
    draw_side(&p, &p.last, &p.first);
  } else if (p.points == 1 && draw->point != NULL) {
    draw->point(draw->user, &p.first, role);
  }
  return GJK_OK;
}

gjk_status gjk2_draw_box(const gjk2_draw *draw, const gjk2_aabb *box, gjk_draw_role role) {
  if (draw == NULL || box == NULL) {
    return GJK_ERROR_NULL;
  }
  drawn_polygon p = {draw, role, 0, {0, 0}, {0, 0}};
  for (unsigned i = 0; i < 4; i++) {
    const gjk2_vec corner = {i == 0 || i == 3 ? box->lower.x : box->upper.x, i < 2 ? box->lower.y : box->upper.y};
    draw_corner(&p, &corner);
  }
  draw_side(&p, &p.last, &p.first);
  return GJK_OK;
}
