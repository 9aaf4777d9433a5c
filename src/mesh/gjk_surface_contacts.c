// The contacts of a body with one triangle of a surface, by normals that the surface has there.
//
//   1. Set the triangle's plane, seen from the side of the body. A triangle is behind its plane for a body of which more than
//      half of the height, along the normal, is behind it. There it has no contacts, unless the surface has two sides.
//   2. Clip triangle and body along the plane's normal. If a deepest point of the body lies over the triangle, and the body
//      has not come around it, the contacts found are the answer.
//   3. Otherwise ask for the signed distance, and for the edge or corner with which the triangle meets its normal.
//   4. The surface has that normal there if every triangle at the edge or corner lies behind the plane across it (the
//      polar cone of the surface). Then the contacts along it are the answer.
//   5. If not, and a triangle that is across the normal keeps the body farther out than this one does, that triangle
//      answers for both. Otherwise the contacts of step 2 stay, if there are any: they have the triangle's own normal.
//   6. If there are none, a body that touches the triangle, or whose normals are rough since it is curved, may have none at
//      all: in the groove of a concave edge it lies over neither side. So may one apart, at an edge that is flat but for the
//      rounding of its corners. Unless it lies over a triangle at that edge or corner, the nearest points of step 3 are taken
//      with the triangle's normal.
//
// Everything but the answer is relative to the body's centre. The body's radius, the margin and the triangle are each at most
// 2^28 along an axis, so corners are below 3 2^28, and below sqrt(3) 3 2^28 < 2^30.4 long; edges are below 2^29 long.
#include "../arith/gjk_unit.h"
#include "../query/gjk_manifold.h"
#include "gjk/intersect.h"
#include "gjk/mesh.h"
#include "gjk_triangle.h"

#define CORNER_MAX (INT32_C(3) << 28)

// A plane of rounded unit normal is off by up to this at the body, LSB: step 2 takes points so near to the deepest for it.
#define LEVEL 2

// A corner so far beyond the plane across a normal, for each LSB of its distance |x| + |y| + |z| and in Q30, counts as in that
// plane. Normals are reported within 2^-28, and rounded outward; those of curved shapes are rough.
#define NORMAL_SLACK 8
#define NORMAL_SLACK_CURVED (INT32_C(1) << 20)

// A triangle, as the body sees it.
typedef struct surface_face {
  gjk_vec3 local[3], world[3];  // its corners
  gjk_vec3 corner[3];           // counterclockwise seen from the body; relative to the body's centre
  gjk_vec3 direction;           // of its normal, of 30 bits
  gjk_unit3 unit;               // its normal
  gjk_vec3 deepest;             // of the body's core along the normal, relative to its centre
  gjk_q16 height;               // of the body above the plane, negative where it is deeper
  unsigned edges;               // as of gjk_parts_class.edges, from the body's side
  bool clipped;                 // the candidates of step 2 are known
  bool over;                    // its deepest point lies over the triangle
  bool touches;                 // it is known to share a point with the triangle
} surface_face;

typedef struct surface_query {
  const gjk_parts_frame *frame;
  const gjk_collider *body;
  gjk_q16 margin;
  unsigned most;
  uint32_t number;
  int32_t slack;     // of normals
  gjk_cache *cache;  // of gjk_within for all triangles
  bool limited;      // a curved body reached its ceiling where the answer depends on it
} surface_query;

static bool is_far(const gjk_vec3 *v) {
  return v->x > CORNER_MAX || v->x < -CORNER_MAX || v->y > CORNER_MAX || v->y < -CORNER_MAX || v->z > CORNER_MAX ||
         v->z < -CORNER_MAX;
}

// *out = world - centre; false: it is far.
static bool relate(const gjk_vec3 *world, const gjk_vec3 *centre, gjk_vec3 *out) {
  out->x = gjk_saturate((int64_t)world->x - centre->x);
  out->y = gjk_saturate((int64_t)world->y - centre->y);
  out->z = gjk_saturate((int64_t)world->z - centre->z);
  return !is_far(out);
}

// Pre: a walk has found the triangle, so it is there.
static void set_local_corners(surface_query *q, uint32_t number, surface_face *out) {
  const gjk_parts_class *type = q->frame->parts->type;
  gjk_parts_room room;
  gjk_parts_local local;
  (void)type->local(q->frame->parts->data, number, &room, &local);
  for (unsigned i = 0; i < 3; i++) {
    gjk_set(&room.vertices[i], &out->local[i]);
    gjk_set(&room.vertices[i], &out->world[i]);  // until it is turned
  }
}

// False: the triangle is not as it should be.
static bool turn_corners(surface_query *q, surface_face *f) {
  const gjk_vec3 *centre = &q->body->centre;
  return gjk_triangle_turn(q->frame, f->local, f->world) && relate(&f->world[0], centre, &f->corner[0]) &&
         relate(&f->world[1], centre, &f->corner[1]) && relate(&f->world[2], centre, &f->corner[2]);
}

// What is convex from one side is concave from the other.
static unsigned edge_from_behind(unsigned edge) {
  if (edge == GJK_MESH_CONVEX) {
    return GJK_MESH_CONCAVE;
  }
  return edge == GJK_MESH_CONCAVE ? (unsigned)GJK_MESH_CONVEX : edge;
}

// Turns a face to its other side: its first corner stays.
static void turn_over(surface_face *f, gjk_long3 *n) {
  const gjk_vec3 second = f->corner[1];
  const unsigned a = GJK_TRIANGLE_EDGE(f->edges, 0), b = GJK_TRIANGLE_EDGE(f->edges, 1),
                 c = GJK_TRIANGLE_EDGE(f->edges, 2);
  gjk_set(&f->corner[2], &f->corner[1]);
  gjk_set(&second, &f->corner[2]);
  const gjk_vec3 local = f->local[1], world = f->world[1];
  gjk_set(&f->local[2], &f->local[1]);
  gjk_set(&local, &f->local[2]);
  gjk_set(&f->world[2], &f->world[1]);
  gjk_set(&world, &f->world[2]);
  f->edges = GJK_TRIANGLE_TWO_SIDED | GJK_TRIANGLE_EDGES(edge_from_behind(c), edge_from_behind(b), edge_from_behind(a));
  n->x = -n->x;
  n->y = -n->y;
  n->z = -n->z;
}

// Is the body, a sum of half axes, apart from the triangle along one of them, by more than the margin? False proves nothing.
//   |half axis| <= 2^28, |corner| < 2^30.4:                          |along| < 2^59
//   margin, convex radius <= 2^28 each, |half axis| <= 2^29.6 by its components:  |reach| < 2^61
static bool is_aside(surface_query *q, const surface_face *f) {
  const gjk_collider *body = q->body;
  const unsigned count = body->shape->type->kind == GJK_KIND_AXES ? body->count : 0;
  for (unsigned i = 0; i < count; i++) {
    const gjk_vec3 *axis = &body->frame[i];
    int64_t reach = ((int64_t)q->margin + body->shape->convex_radius) * gjk_norm1(*axis);
    for (unsigned k = 0; k < count; k++) {
      const int64_t part = gjk_dot(axis, &body->frame[k]);
      reach += part < 0 ? -part : part;
    }
    const int64_t a = gjk_dot(axis, &f->corner[0]), b = gjk_dot(axis, &f->corner[1]), c = gjk_dot(axis, &f->corner[2]);
    if ((a > reach && b > reach && c > reach) || (a < -reach && b < -reach && c < -reach)) {
      return true;
    }
  }
  return false;
}

// Step 1. False: the triangle has no plane, or the body is behind it. Pre: corners are set.
static bool set_face(surface_query *q, uint32_t number, surface_face *f) {
  const gjk_shape_class *type = q->body->shape->type;
  gjk_long3 n;
  gjk_search_direction along;
  gjk_support front, back;
  f->edges = q->frame->parts->type->edges(q->frame->parts->data, number);
  gjk_triangle_normal(&f->corner[0], &f->corner[1], &f->corner[2], &n);
  if (n.x == 0 && n.y == 0 && n.z == 0) {
    return false;
  }
  gjk_search_direction_of(&n, &along);
  const gjk_vec3 down = gjk_negate(along.d);
  type->support(q->body, &down, &back);
  gjk_vec3 middle = gjk_negate(f->corner[0]);
  if (type->kind != GJK_KIND_AXES) {  // of those the middle is the centre
    type->support(q->body, &along.d, &front);
    const gjk_vec3 sum = gjk_add(front.offset, back.offset);
    middle.x += gjk_sar32(sum.x, 1);
    middle.y += gjk_sar32(sum.y, 1);
    middle.z += gjk_sar32(sum.z, 1);
  } else {
    front.offset = gjk_negate(back.offset);
  }
  if (gjk_dot_sign(&n, &middle) < 0) {  // |middle| < 2^31
    if ((f->edges & GJK_TRIANGLE_TWO_SIDED) == 0) {
      return false;
    }
    turn_over(f, &n);
    gjk_set(&down, &along.d);
    gjk_set(&front.offset, &back.offset);
  }
  gjk_set(&along.d, &f->direction);
  gjk_set(&back.offset, &f->deepest);
  f->unit = gjk_unit(&along.d);
  const gjk_vec3 above = gjk_sub(back.offset, f->corner[0]);  // below 2^31 long:  the product below 2^61
  f->height = (gjk_q16)gjk_sar64(gjk_along(&f->unit, &above) + (INT64_C(1) << 29), 30) - q->body->shape->convex_radius;
  return true;
}

// Does a point, relative to the body's centre, lie over the triangle? Along the plane's direction of 30 bits, exact.
//   |direction| <= sqrt(3) 2^30, |edge| < 2^29, |to| < 2^31.5
static bool is_over(const surface_face *f, const gjk_vec3 *point) {
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

// x, by at most `by` nearer to a third of a sum.
static int32_t pulled(int32_t x, int64_t sum, int64_t by) {
  const int64_t way = sum - 3 * (int64_t)x;
  return (int32_t)(x + (way > 3 * by ? by : way < -3 * by ? -by : 0));
}

// Does the deepest point lie over the triangle but for the rounding of corners? Each is off by less than an LSB, which tilts a
// triangle of 128 LSB by 1/64. So a point above an edge that is flat but for that may lie over neither side.
static bool is_nearly_over(surface_query *q, const surface_face *f) {
  const gjk_vec3 *c = f->corner, *p = &f->deepest;
  const int64_t by = 8 + gjk_sar64((int64_t)f->height + q->body->shape->convex_radius, 6);
  const gjk_vec3 near = {pulled(p->x, (int64_t)c[0].x + c[1].x + c[2].x, by),
                         pulled(p->y, (int64_t)c[0].y + c[1].y + c[2].y, by),
                         pulled(p->z, (int64_t)c[0].z + c[1].z + c[2].z, by)};
  return f->height >= 0 && is_over(f, &near);
}

// A point of the core moved by a length along the normal, in the world.
static void point_below(surface_query *q, const surface_face *f, int64_t length, gjk_vec3 *out) {
  const int64_t half = INT64_C(1) << 29;
  const gjk_vec3 *at = &q->body->centre, *p = &f->deepest;
  const gjk_q16 by = gjk_saturate(length);
  out->x = gjk_saturate((int64_t)at->x + p->x + gjk_sar64(gjk_mul32(f->unit.x, by) + half, 30));
  out->y = gjk_saturate((int64_t)at->y + p->y + gjk_sar64(gjk_mul32(f->unit.y, by) + half, 30));
  out->z = gjk_saturate((int64_t)at->z + p->z + gjk_sar64(gjk_mul32(f->unit.z, by) + half, 30));
}

// Is one of the candidates as deep as the body is?
static bool reaches(const gjk_candidates *candidates, gjk_q16 height) {
  for (unsigned i = 0; i < candidates->count; i++) {
    if (candidates->candidate[i].distance <= height + LEVEL) {
      return true;
    }
  }
  return false;
}

// A body that is behind the plane in part may have come around the triangle, and not touch it.
static bool touches(surface_query *q, const gjk_collider *triangle) {
  gjk_decision decision;
  const gjk_status status = gjk_intersect(triangle, q->body, NULL, &decision);
  q->limited = q->limited || status != GJK_OK;
  return status != GJK_OK || decision.yes;
}

// Does an edge of a body's core, a sum of half axes, that ends at its deepest point pass through the triangle? False proves
// nothing. The edge taken is the steepest to the plane. If both ends are over the triangle, the edge meets the plane in it.
static bool is_pierced(surface_query *q, const surface_face *f) {
  const gjk_collider *body = q->body;
  const unsigned count = body->shape->type->kind == GJK_KIND_AXES ? body->count : 0;
  int64_t most = 0;
  gjk_vec3 top = f->deepest;
  for (unsigned i = 0; i < count; i++) {
    const gjk_vec3 *axis = &body->frame[i];
    const int64_t along = gjk_along(&f->unit, axis), size = along < 0 ? -along : along;
    if (size > most) {
      const gjk_vec3 way = along < 0 ? gjk_negate(*axis) : *axis;
      most = size;
      top = gjk_add(f->deepest, gjk_add(way, way));
    }
  }
  if (most == 0 || !is_over(f, &top)) {
    return false;
  }
  gjk_long3 n;
  const gjk_vec3 above = gjk_sub(top, f->corner[0]), below = gjk_sub(f->deepest, f->corner[0]);
  gjk_triangle_normal(&f->corner[0], &f->corner[1], &f->corner[2], &n);
  return gjk_dot_sign(&n, &above) >= 0 && gjk_dot_sign(&n, &below) <= 0;
}

// Is the body, a sum of half axes, so steep to the plane that it has one deepest point alone?
static bool is_pointed(surface_query *q, const surface_face *f) {
  const gjk_collider *body = q->body;
  if (body->shape->type->kind != GJK_KIND_AXES) {
    return false;
  }
  for (unsigned i = 0; i < body->count; i++) {
    const int64_t along = gjk_along(&f->unit, &body->frame[i]);
    if (along <= (int64_t)LEVEL << 30 && along >= -((int64_t)LEVEL << 30)) {
      return false;
    }
  }
  return true;
}

// The candidates along the triangle's own normal, once.
static void find_on_face(surface_query *q, surface_face *f, const gjk_collider *triangle, gjk_candidates *candidates,
                         gjk_manifold *out) {
  if (!f->clipped) {
    out->normal = f->unit;
    gjk_manifold_find(triangle, q->body, q->margin, candidates, out);
    f->clipped = true;
  }
}

// Where the deepest point lies over the triangle, it is likely to touch, or is as near as it is high. A direction that keeps the
// body off one triangle is likely to keep it off the next. A limit of iterations is left to gjk_signed_distance.
static bool is_within_margin(surface_query *q, surface_face *f, const gjk_collider *triangle) {
  gjk_decision decision;
  f->touches = f->over && f->height < 0 && (is_pierced(q, f) || touches(q, triangle));
  if (f->touches || (f->over && f->height >= 0 && f->height <= (int64_t)q->margin - 2 * LEVEL)) {
    return true;
  }
  return gjk_within(triangle, q->body, q->margin, q->cache, &decision) != GJK_OK || decision.yes;
}

// Step 2. False: no deepest point of the body lies over the triangle.
static bool meets_face(surface_query *q, surface_face *f, const gjk_collider *triangle, gjk_candidates *candidates,
                       gjk_manifold *out) {
  if (!f->over && is_pointed(q, f)) {
    return false;
  }
  find_on_face(q, f, triangle, candidates, out);
  const bool found = reaches(candidates, f->height);
  if ((!f->over && !found) || (f->height < 0 && !f->touches && !touches(q, triangle))) {
    return false;
  }
  if (f->over && !found && f->height > q->margin) {
    return true;
  }
  if (f->over && !found) {
    gjk_distance_result nearest;
    const gjk_q16 radius = q->body->shape->convex_radius;
    nearest.distance = f->height;
    point_below(q, f, -(int64_t)radius, &nearest.point_b);
    point_below(q, f, -(int64_t)radius - f->height, &nearest.point_a);
    gjk_manifold_keep(candidates, &nearest, q->most, out);
  } else {
    gjk_manifold_keep(candidates, NULL, q->most, out);
  }
  return true;
}

// How far p is beyond the plane across the normal at v: above 0, at least by the slack.
static bool is_beyond_plane(surface_query *q, const gjk_unit3 *normal, const gjk_vec3 *v, const gjk_vec3 *p) {
  const gjk_vec3 step = gjk_sub(*p, *v);
  return gjk_along(normal, &step) > (int64_t)gjk_norm1(step) * q->slack;  // below 2^33 2^20
}

// Step 3: bit i is set if the triangle meets the normal with its corner i.
static unsigned corners_that_meet(surface_query *q, const surface_face *f, const gjk_unit3 *normal) {
  unsigned top = 0, bits = 0;
  for (unsigned i = 1; i < 3; i++) {
    const gjk_vec3 step = gjk_sub(f->corner[i], f->corner[top]);
    top = gjk_along(normal, &step) > 0 ? i : top;
  }
  for (unsigned i = 0; i < 3; i++) {
    bits |= is_beyond_plane(q, normal, &f->corner[i], &f->corner[top]) ? 0u : 1u << i;
  }
  return bits;
}

// Which of the triangle's edges has these two corners.
static unsigned edge_with(unsigned bits) {
  return bits == 3 ? 0 : bits == 6 ? 1 : 2;
}

static bool has_corner(const surface_face *f, const gjk_vec3 *local) {
  return gjk_same_place(&f->local[0], local) || gjk_same_place(&f->local[1], local) ||
         gjk_same_place(&f->local[2], local);
}

// The triangles at an edge or corner of a face, one after the other.
typedef struct ring_walk {
  gjk_region region;
  gjk_parts_walk walk;
  const gjk_vec3 *p, *r;  // the edge's ends, or the corner twice
} ring_walk;

static void ring_start(ring_walk *ring, const gjk_vec3 *p, const gjk_vec3 *r) {
  gjk_aabb *box = &ring->region.box;
  ring->region.moves = false;
  ring->p = p;
  ring->r = r;
  box->lower.x = (int32_t)gjk_sar64((int64_t)p->x + r->x, 1);
  box->lower.y = (int32_t)gjk_sar64((int64_t)p->y + r->y, 1);
  box->lower.z = (int32_t)gjk_sar64((int64_t)p->z + r->z, 1);
  gjk_set(&box->lower, &box->upper);
  gjk_parts_walk_start(&ring->walk);
}

// Ends: each triangle comes once.
static bool ring_next(surface_query *q, ring_walk *ring, uint32_t *number, surface_face *other) {
  while (gjk_parts_next(q->frame, &ring->region, &ring->walk, number)) {
    if (*number != q->number) {
      set_local_corners(q, *number, other);
      if (has_corner(other, ring->p) && has_corner(other, ring->r) && turn_corners(q, other)) {
        return true;
      }
    }
  }
  return false;
}

// For a body that overlaps a triangle only one that it overlaps as well can answer.
static bool answers(surface_query *q, const surface_face *other, bool together) {
  gjk_parts_room room;
  gjk_collider triangle;
  return !together || (gjk_triangle_collider(other->world, &room, &triangle) == GJK_OK && touches(q, &triangle));
}

// Steps 4 and 5, at the edge from corner i to corner j, or at a corner, i = j. *answered: a triangle across the normal
// answers.
static bool has_normal(surface_query *q, const surface_face *f, const gjk_unit3 *normal, unsigned i, unsigned j,
                       bool together, bool *answered) {
  ring_walk ring;
  surface_face other;
  uint32_t number;
  bool has = true;
  ring_start(&ring, &f->local[i], &f->local[j]);
  while ((has || !*answered) && ring_next(q, &ring, &number, &other)) {
    if (is_beyond_plane(q, normal, &f->corner[i], &other.corner[0]) ||
        is_beyond_plane(q, normal, &f->corner[i], &other.corner[1]) ||
        is_beyond_plane(q, normal, &f->corner[i], &other.corner[2])) {
      has = false;
      *answered = set_face(q, number, &other) && other.height > f->height && answers(q, &other, together);
    }
  }
  return has;
}

// Does the deepest point lie over some triangle at the edge or corner?
static bool is_over_ring(surface_query *q, const surface_face *f, unsigned i, unsigned j, bool together) {
  ring_walk ring;
  surface_face other;
  uint32_t number;
  ring_start(&ring, &f->local[i], &f->local[j]);
  while (ring_next(q, &ring, &number, &other)) {
    if (set_face(q, number, &other) && is_over(&other, &other.deepest) && answers(q, &other, together)) {
      return true;
    }
  }
  return false;
}

// Step 6: the nearest points of both, with the triangle's normal.
static void keep_nearest(surface_query *q, const surface_face *f, gjk_distance_result *nearest,
                         gjk_candidates *candidates, gjk_manifold *out) {
  nearest->distance = f->height > nearest->distance ? f->height : nearest->distance;
  if (nearest->distance <= q->margin) {
    gjk_manifold_keep(candidates, nearest, q->most, out);
  }
}

// Has the triangle a convex or an open edge, so that it may have normals that are not its own? A corner alone does not
// count: where it has a normal that none of this triangle's edges has, other triangles there have such edges.
static bool has_ridge(const surface_face *f) {
  for (unsigned i = 0; i < 3; i++) {
    const unsigned edge = GJK_TRIANGLE_EDGE(f->edges, i);
    if (edge == GJK_MESH_CONVEX || edge == GJK_MESH_OPEN) {
      return true;
    }
  }
  return (f->edges & GJK_TRIANGLE_TWO_SIDED) != 0;
}

// Steps 3 to 6 without a distance. False: it is needed.
static bool is_settled(surface_query *q, surface_face *f, const gjk_collider *triangle, gjk_candidates *candidates,
                       gjk_manifold *out) {
  if (has_ridge(f) || gjk_is_curved(q->body->shape)) {
    return false;
  }
  find_on_face(q, f, triangle, candidates, out);
  if (candidates->count == 0) {
    return f->height >= 0 && !is_nearly_over(q, f);
  }
  if (f->height >= 0 || f->touches || touches(q, triangle)) {
    gjk_manifold_keep(candidates, NULL, q->most, out);
  }
  return true;
}

// Steps 3 to 6.
static gjk_status meet_beside(surface_query *q, surface_face *f, const gjk_collider *triangle,
                              const gjk_workspace *workspace, gjk_candidates *candidates, gjk_manifold *out) {
  gjk_distance_result nearest;
  if (is_settled(q, f, triangle, candidates, out)) {
    return GJK_OK;
  }
  const gjk_status status = gjk_signed_distance(triangle, q->body, NULL, workspace, &nearest);
  if ((status != GJK_OK && status != GJK_ERROR_CAPACITY) || nearest.distance > q->margin) {
    return status;
  }
  const gjk_vec3 normal = {nearest.normal.x, nearest.normal.y, nearest.normal.z};
  const unsigned bits = corners_that_meet(q, f, &nearest.normal);
  const bool in_front = gjk_along(&f->unit, &normal) > 0;
  const bool may = in_front || (f->edges & GJK_TRIANGLE_TWO_SIDED) != 0;
  bool answered = false, has = in_front;
  unsigned i = 0, j = 0;
  if (bits == 7 && in_front) {
    nearest.normal = f->unit;
  } else if ((bits & (bits - 1)) != 0) {
    i = edge_with(bits);
    j = gjk_next(i);
    const unsigned edge = GJK_TRIANGLE_EDGE(f->edges, i);
    const gjk_mesh_edge ridge = in_front ? GJK_MESH_CONVEX : GJK_MESH_CONCAVE;
    if (may && edge == (unsigned)ridge) {
      has = has_normal(q, f, &nearest.normal, i, j, nearest.distance <= 0, &answered);
    } else {
      has = may && edge == GJK_MESH_OPEN;
    }
  } else {
    i = j = bits >> 1;  // 0, 1 or 2
    has = may && has_normal(q, f, &nearest.normal, i, j, nearest.distance <= 0, &answered);
  }
  if (has) {
    out->normal = nearest.normal;
    gjk_manifold_find(triangle, q->body, q->margin, candidates, out);
    gjk_manifold_keep(candidates, &nearest, q->most, out);
    return status;
  }
  if (answered) {
    return status;
  }
  find_on_face(q, f, triangle, candidates, out);
  if (candidates->count > 0 && (nearest.distance <= 0 || f->height >= 0)) {
    gjk_manifold_keep(candidates, NULL, q->most, out);
  } else if ((nearest.distance <= 0 || gjk_is_curved(q->body->shape) || is_nearly_over(q, f)) &&
             !is_over_ring(q, f, i, j, nearest.distance <= 0)) {
    keep_nearest(q, f, &nearest, candidates, out);
  }
  return status;
}

gjk_status gjk_surface_meet(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_q16 margin,
                            unsigned most, gjk_cache *cache, const gjk_workspace *workspace, gjk_manifold *out) {
  surface_query q = {frame, b,    margin, most, number, gjk_is_curved(b->shape) ? NORMAL_SLACK_CURVED : NORMAL_SLACK,
                     cache, false};
  surface_face face;
  gjk_parts_room room;
  gjk_collider triangle;
  gjk_candidates candidates;
  out->count = 0;
  out->feature_a = 0;
  out->feature_b = 0;
  candidates.count = 0;
  face.clipped = false;
  set_local_corners(&q, number, &face);
  if (!turn_corners(&q, &face) || is_aside(&q, &face) || !set_face(&q, number, &face) ||
      face.height > (int64_t)margin + LEVEL) {
    return GJK_OK;
  }
  face.over = is_over(&face, &face.deepest);
  gjk_status status = gjk_triangle_collider(face.world, &room, &triangle);
  if (status != GJK_OK || !is_within_margin(&q, &face, &triangle)) {
    return status;
  }
  if (!meets_face(&q, &face, &triangle, &candidates, out)) {
    status = meet_beside(&q, &face, &triangle, workspace, &candidates, out);
  }
  if (q.limited) {
    out->count = 0;
    status = GJK_ERROR_ITERATION_LIMIT;
  }
  return status;
}

// The contacts that the triangle alone has tell how far apart they may be.
bool gjk_surface_settle(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_manifold *m) {
  gjk_q16 margin = 0;
  for (unsigned i = 0; i < m->count; i++) {
    margin = m->contact[i].distance > margin ? m->contact[i].distance : margin;
  }
  const unsigned most = m->count;
  margin = margin < GJK_RADIUS_MAX ? margin : GJK_RADIUS_MAX;
  const gjk_status status = most == 0 ? GJK_OK : gjk_surface_meet(frame, number, b, margin, most, NULL, NULL, m);
  return (status == GJK_OK || status == GJK_ERROR_CAPACITY) && m->count > 0;
}
