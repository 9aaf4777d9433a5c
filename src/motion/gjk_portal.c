// Where a line enters A - B, by exact signs alone.
//
//   Step 1   A support scan towards the line, as seen from the centres, and equally towards the way's start. The vertex
//            found is the apex: the way mostly enters near it.
//   Step 2   Look for a vertex beyond the line from there, and then for a portal: two vertices such that, seen along the
//            line, the ray from the apex towards the line passes between them. Move the portal outwards until the line
//            lies in its triangle with the apex. If all of A - B lies on one side of the line: BESIDE.
//   Step 3   Now the line passes through the triangle, at a point of A - B. Take the triangle's plane, with the normal
//            towards the way's start. If the start lies on the plane: INSIDE.
//   Step 4   Support scan along the normal. If all of A - B lies behind both ends of the way: SHORT.
//   Step 5   If the vertex is strictly beyond the plane, put it in the place of one corner, so that the line still
//            passes through the triangle. If the plane has passed the start: INSIDE. Go on from step 4.
//   Step 6   If no vertex is, the plane bounds A - B: FACET.
//
// Ties are common in games: a line through an edge or a corner, or along a face. Steps 4 to 6 decide them as if the
// line were moved by e w_i + e^2 w_j, for an e smaller than any number. The vertices w_i and w_j of the first triangle
// are chosen so that the line moves into the triangle. Then no sign is 0, each step strictly lowers where the moved
// line meets the plane, and no triangle returns. The plane that bounds A - B where the moved line enters also does
// where the line does.
//
// A - B may have no area as seen along the line. Then the line's point lies on an edge or a vertex, and the same steps
// work with two corners or one.
//
// After   Snethen 2008, portals; van den Bergen 2004, ray casts by GJK. In other words it is the simplex method for "least s
//         such that s t is in A - B", with columns found by support scans and ties broken in lexicographic order.
#include "gjk_portal.h"

#include "../arith/gjk_ceilings.h"

static void copy_corner(const gjk_corner *from, gjk_corner *to) {
  gjk_set(&from->u, &to->u);
  to->a = from->a;
  to->b = from->b;
}

// -v to 29 bits, so that a product with t fits; v is not zero, and neither is the result.
static gjk_vec3 rounded_opposite(const gjk_long3 *v) {
  const uint64_t size = gjk_portal_bits(v);
  const unsigned zeros = gjk_clz64(size), k = zeros < 36 ? 36 - zeros : 0;  // size < 2^(64 - zeros)
  const gjk_vec3 g = {-(int32_t)gjk_sar64(v->x, k), -(int32_t)gjk_sar64(v->y, k), -(int32_t)gjk_sar64(v->z, k)};
  return g;
}

void gjk_portal_set_direction(gjk_portal *p) {
  const gjk_long3 *n = &p->n;
  if (p->wide && gjk_portal_bits(n) >> 62 != 0) {
    const gjk_long3 half = {gjk_sar64(n->x, 1), gjk_sar64(n->y, 1), gjk_sar64(n->z, 1)};
    gjk_search_direction_of(&half, &p->direction);
    p->direction.exact = false;
    return;
  }
  gjk_search_direction_of(n, &p->direction);
}

static void complete(gjk_portal *p) {
  gjk_corner *c = &p->corner[3];
  gjk_portal_scale(p, &p->of_a.offset, &p->of_b.offset, &c->u);
  c->a = p->of_a.vertex;
  c->b = p->of_b.vertex;
}

// Support scan of both shapes along n: the newest vertex.
static void scan(gjk_portal *p) {
  gjk_portal_set_direction(p);
  p->a->shape->type->support(p->a, &p->direction.d, &p->of_a);
  if (!p->lone) {
    const gjk_vec3 opposite = gjk_negate(p->direction.d);
    p->b->shape->type->support(p->b, &opposite, &p->of_b);
  }
  complete(p);
  p->iterations++;
}

// Makes the newest vertex one that is farthest along n exactly. Returns whether it is another one.
static bool refine(gjk_portal *p) {
  gjk_direction exact = {NULL, NULL, &p->n, 0, 0, 3, false, NULL, 0};
  if (p->direction.exact) {
    return false;
  }
  bool moved = p->a->shape->type->refine(p->a, &p->direction.d, &exact, &p->of_a);
  if (!p->lone) {
    const gjk_vec3 opposite = gjk_negate(p->direction.d);
    exact.opposite = true;
    moved = p->b->shape->type->refine(p->b, &opposite, &exact, &p->of_b) || moved;
  }
  complete(p);
  return moved;
}

// The sign of n . w for the newest vertex w of a support scan along n, which is farthest where the sign is below least.
static int look(gjk_portal *p, int least) {
  scan(p);
  const int side = gjk_portal_beside(p, &p->corner[3].u);
  return side < least && refine(p) ? gjk_portal_beside(p, &p->corner[3].u) : side;
}

GJK_ONE_COPY static int look_along(gjk_portal *p, const gjk_vec3 *g, int least) {
  gjk_portal_face(p, g);
  return look(p, least);
}

GJK_ONE_COPY static gjk_vec3 unit_axis(unsigned axis, int32_t length) {
  const gjk_vec3 v = {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
  return v;
}

GJK_ONE_COPY static void set_inward(gjk_portal *p, unsigned i, unsigned j) {
  gjk_set(&p->corner[i].u, &p->inward[0]);
  gjk_set(&p->corner[j].u, &p->inward[1]);
}

// The apex lies on the line: makes another vertex the apex. *v: t x w of the apex. False: all vertices lie on the line.
static bool leave_line(gjk_portal *p, gjk_long3 *v) {
  const unsigned along = gjk_portal_main_axis(&p->way);
  for (unsigned i = 0; i < 4; i++) {
    const gjk_vec3 g = unit_axis(i < 2 ? gjk_next(along) : gjk_next(gjk_next(along)), (i & 1u) != 0 ? -1 : 1);
    look_along(p, &g, 1);
    gjk_portal_lateral(p, &p->corner[3].u, v);
    if (!gjk_portal_is_zero(v)) {
      copy_corner(&p->corner[3], &p->corner[0]);
      return true;
    }
  }
  p->count = 1;
  p->axis = (uint8_t)along;
  return false;
}

// The line passes through the edge of corners 0 and 1, seen along it: looks for a vertex on either side.
static void widen_edge(gjk_portal *p, const gjk_long3 *v) {
  const gjk_vec3 e = gjk_sub(p->corner[1].u, p->corner[0].u), opposite = gjk_negate(e);
  gjk_long3 across;
  p->count = 3;
  if (look_along(p, &e, 1) > 0) {
    set_inward(p, 3, 0);
    copy_corner(&p->corner[0], &p->corner[2]);
    copy_corner(&p->corner[1], &p->corner[0]);
    copy_corner(&p->corner[2], &p->corner[1]);
    copy_corner(&p->corner[3], &p->corner[2]);
    return;
  }
  if (look_along(p, &opposite, 1) > 0) {
    set_inward(p, 3, 0);
    copy_corner(&p->corner[3], &p->corner[2]);
    return;
  }
  p->count = 2;
  gjk_portal_cross(p, &e, &across);
  p->axis = gjk_portal_main_axis(&across);
  p->side = (int8_t)gjk_sign64(gjk_portal_component(v, p->axis));
}

static bool same_corner(const gjk_corner *c, const gjk_corner *d) {
  return c->a == d->a && c->b == d->b;
}

// Step 2. v: t x w of the apex, corner 0. Corner 1 lies left of the ray from the apex to the line, det(t, w_0, w_1) > 0, and
// corner 2 right of it; where none is found yet, it is the apex itself.
static gjk_passage grow_portal(gjk_portal *p, const gjk_long3 *v) {
  gjk_corner *c = p->corner;
  while (p->iterations < GJK_CAST_ITERATIONS_MAX) {
    const gjk_vec3 g = gjk_sub(c[2].u, c[1].u);
    gjk_portal_face(p, &g);
    // Where one of them is the apex, the line lies beyond them for sure.
    if (!same_corner(&c[0], &c[1]) && !same_corner(&c[0], &c[2]) && gjk_portal_beside(p, &c[1].u) >= 0) {
      set_inward(p, 0, 1);
      return GJK_PASSAGE_FACET;
    }
    if (look(p, 0) < 0) {
      return GJK_PASSAGE_BESIDE;
    }
    const int side = gjk_portal_turn(v, &c[0].u, &c[3].u);
    if (side > 0) {
      copy_corner(&c[3], &c[1]);
    } else if (side < 0) {
      copy_corner(&c[3], &c[2]);
    } else if (!same_corner(&c[0], &c[1])) {
      set_inward(p, 1, 0);
      copy_corner(&c[3], &c[2]);
      return GJK_PASSAGE_FACET;
    } else {
      set_inward(p, 2, 0);
      copy_corner(&c[3], &c[1]);
      return GJK_PASSAGE_FACET;
    }
  }
  return GJK_PASSAGE_LIMIT;
}

// Step 1. n = g x t leads to the line. It is tilted towards the start, on ways below 2^30 LSB.
//   |g| < 2^30, |t| < 2^30.8:   |n| < 2^60.8, |t 2^30| < 2^60.8
static void find_apex(gjk_portal *p) {
  gjk_vec3 g = unit_axis(gjk_next(gjk_portal_main_axis(&p->way)), 1);
  if (!gjk_portal_is_zero(&p->m)) {
    g = rounded_opposite(&p->m);
  }
  gjk_portal_face(p, &g);
  if (!p->wide) {
    p->n.x -= gjk_shl64(p->t.x, 30);
    p->n.y -= gjk_shl64(p->t.y, 30);
    p->n.z -= gjk_shl64(p->t.z, 30);
  }
  scan(p);
  copy_corner(&p->corner[3], &p->corner[0]);
}

// Steps 1 and 2. FACET: the line passes through the corners; a triangle runs counterclockwise seen against t.
static gjk_passage find_first(gjk_portal *p) {
  gjk_corner *c = p->corner;
  gjk_long3 v;
  find_apex(p);
  gjk_portal_lateral(p, &c[0].u, &v);
  if (gjk_portal_is_zero(&v) && !leave_line(p, &v)) {
    return GJK_PASSAGE_FACET;
  }
  const gjk_vec3 g = rounded_opposite(&v);
  if (look_along(p, &g, 0) < 0) {
    return GJK_PASSAGE_BESIDE;
  }
  const int side = gjk_portal_turn(&v, &c[0].u, &c[3].u);
  copy_corner(&c[side >= 0 ? 3 : 0], &c[1]);
  if (side == 0) {
    widen_edge(p, &v);
    return GJK_PASSAGE_FACET;
  }
  copy_corner(&c[side < 0 ? 3 : 0], &c[2]);
  p->count = 3;
  return grow_portal(p, &v);
}

void gjk_portal_set_plane(gjk_portal *p) {
  const gjk_corner *c = p->corner;
  if (p->count == 3) {
    const gjk_corner *second = p->leaving ? &c[1] : &c[2], *third = p->leaving ? &c[2] : &c[1];
    gjk_triangle_normal(&c[0].u, &second->u, &third->u, &p->n);
    return;
  }
  gjk_vec3 axis = unit_axis(p->axis, 1);
  gjk_long3 across = {p->way.x, p->way.y, p->way.z};
  p->n.x = axis.x;
  p->n.y = axis.y;
  p->n.z = axis.z;
  if (p->count == 2) {
    const gjk_vec3 e = gjk_sub(c[1].u, c[0].u);
    gjk_portal_cross(p, &e, &across);  // (e x axis) . t = (t x e) . axis
    gjk_cross(&e, &axis, &p->n);
  }
  if ((gjk_portal_component(&across, p->axis) > 0) != p->leaving) {
    p->n.x = -p->n.x;
    p->n.y = -p->n.y;
    p->n.z = -p->n.z;
  }
}

// The sign of det(t, w_3, w_i) where the line is moved inward; v = t x w_3. 0: both vertices lie on a parallel to the line.
static int moved_side(const gjk_portal *p, const gjk_long3 *v, unsigned i) {
  const gjk_corner *c = p->corner;
  const gjk_vec3 step = gjk_sub(c[i].u, c[3].u);
  int side = gjk_dot_sign(v, &step);
  for (unsigned k = 0; k < 2 && side == 0; k++) {
    // Moved by e w_k, the determinant grows by e det(t, w_k, w_3 - w_i).
    gjk_long3 inward;
    gjk_portal_lateral(p, &p->inward[k], &inward);
    side = -gjk_dot_sign(&inward, &step);
  }
  return side;
}

// Which corner gives way to the newest vertex?
static unsigned leaving_corner(const gjk_portal *p) {
  gjk_long3 v;
  if (p->count == 1) {
    return 0;
  }
  gjk_portal_lateral(p, &p->corner[3].u, &v);
  if (p->count == 2) {
    const int side = gjk_sign64(gjk_portal_component(&v, p->axis));
    return side == p->side ? 0 : 1;
  }
  const int side = moved_side(p, &v, 0);
  if (side == 0) {
    return 0;
  }
  if (side > 0) {
    return moved_side(p, &v, 1) < 0 ? 2 : 0;
  }
  return moved_side(p, &v, 2) > 0 ? 1 : 0;
}

// Steps 4 and 6 for the plane across n: SHORT or FACET; INSIDE stands for a vertex strictly beyond it.
static gjk_passage look_beyond(gjk_portal *p) {
  const gjk_corner *c = p->corner;
  bool below, stuck;
  scan(p);
  do {
    const gjk_vec3 step = gjk_sub(c[3].u, c[0].u);
    stuck = gjk_dot_sign(&p->n, &step) <= 0;
    below = !p->arrives && gjk_portal_side(p, &c[3].u, &p->goal) < 0;
  } while ((stuck || below) && refine(p));  // at most twice: what is refined is farthest
  return below ? GJK_PASSAGE_SHORT : stuck ? GJK_PASSAGE_FACET : GJK_PASSAGE_INSIDE;
}

// Step 3: which way to look. True: the start lies on the plane.
static bool face_start(gjk_portal *p) {
  gjk_portal_set_plane(p);
  const int side = gjk_portal_side(p, &p->corner[0].u, &p->start);
  if (side > 0) {
    p->leaving = true;
    gjk_portal_copy(&p->start, &p->goal);
    gjk_portal_set_plane(p);
  } else {
    p->arrives = gjk_portal_side(p, &p->corner[0].u, &p->goal) >= 0;
  }
  return side == 0;
}

// Steps 3 to 6.
static gjk_passage follow_line(gjk_portal *p) {
  if (face_start(p)) {
    return GJK_PASSAGE_INSIDE;
  }
  while (p->iterations < GJK_CAST_ITERATIONS_MAX) {
    const gjk_passage passage = look_beyond(p);
    if (passage != GJK_PASSAGE_INSIDE) {
      return passage;
    }
    copy_corner(&p->corner[3], &p->corner[leaving_corner(p)]);
    gjk_portal_set_plane(p);
    if (gjk_portal_side(p, &p->corner[0].u, &p->start) >= 0) {
      return GJK_PASSAGE_INSIDE;
    }
  }
  return GJK_PASSAGE_LIMIT;
}

gjk_passage gjk_portal_find(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  gjk_portal_start(p, a, b, way);
  const gjk_passage first = find_first(p);
  return first == GJK_PASSAGE_FACET ? follow_line(p) : first;
}
