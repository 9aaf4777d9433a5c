// The polygon with which a shape meets a direction: a face, an edge or a corner.
//
//   1. The kind of the shape offers its face that meets the direction best, or the edge or corner that it has:
//      gjk_polygon_axes.c, gjk_polygon_vertices.c, gjk_polygon_disc_base.c.
//   2. A face within 20.7 degrees of the direction stays, moved outwards by the convex radius.
//   3. Otherwise, of the two edges at the farthest corner the one that is more level stays, if it is within 20.7
//      degrees of level; it too is moved outwards by the convex radius.
//   4. Otherwise the farthest corner stays.
//
// What is rounded, in LSB, for the largest radius of 2^28 LSB:
//   corner of a polytope     not at all: the posed vertex
//   corner of a disc base    per component to the nearest LSB, within 1 of the surface
//   move of a face           unit vector within 7/2 2^-30:  0.88, to the nearest LSB: 0.87; together below 2
//   move of an edge          unit vector within 15/2 2^-30: 1.88, to the nearest LSB: 0.87; together below 3
#include "gjk_contact_polygon.h"

#include "../arith/gjk_unit.h"
#include "gjk_polygon_kind.h"

void gjk_polygon_negate(gjk_long3 *n) {
  n->x = -n->x;
  n->y = -n->y;
  n->z = -n->z;
}

uint32_t gjk_polygon_alignment(const gjk_long3 *n, const gjk_vec3 *direction) {
  gjk_search_direction r;
  if ((n->x | n->y | n->z) == 0) {
    return 0;
  }
  gjk_search_direction_of(n, &r);
  return gjk_height_key(gjk_dot(&r.d, direction), gjk_dot(&r.d, &r.d));
}

// How far from level an edge is, as a height key. Pre: edge != 0.
static uint32_t slope(const gjk_vec3 *edge, const gjk_vec3 *direction) {
  const int64_t along = gjk_dot(edge, direction);
  return gjk_height_key(along < 0 ? -along : along, gjk_dot(edge, edge));
}

// Moves the corners by radius u.
//   |u.x radius| <= 2^30 2^28 = 2^58; the quotient is rounded to the nearest LSB
static void lift(gjk_polygon *p, const gjk_unit3 *u, gjk_q16 radius) {
  const gjk_vec3 unit = {u->x, u->y, u->z};
  gjk_vec3 by;
  gjk_scaled(&unit, radius, 30, &by);
  for (unsigned i = 0; i < p->count; i++) {
    p->corner[i] = gjk_add(p->corner[i], by);
  }
}

// Step 2: along the normal, which is rounded to 30 bits before it is made a unit vector.
static void lift_face(gjk_polygon *p, gjk_q16 radius) {
  if (radius > 0) {
    gjk_search_direction r;
    gjk_search_direction_of(&p->normal, &r);
    const gjk_unit3 u = gjk_unit(&r.d);
    lift(p, &u, radius);
  }
}

// Step 3: along the part of the direction that is square to the edge. The edge is nearly level, so that part is at
// least 0.93 of the direction. Errors in 2^-30:
//   e           each component 1:                                 at most 1.8 in length
//   along       1.8, and 1 rounded down; |along| <= 0.36 2^30:    2.8
//   square      0.36 1.8 + 2.8, and 1 rounded down per component: 5.2
//   u           5.2 / 0.93, and 1 per component:                  7.5
static void lift_edge(gjk_polygon *p, gjk_q16 radius) {
  if (radius > 0) {
    const gjk_vec3 edge = gjk_sub(p->corner[1], p->corner[0]), *d = &p->direction;
    const gjk_unit3 e = gjk_unit(&edge);
    const gjk_q30 along = (gjk_q30)gjk_sar64(gjk_along(&e, d), 30);
    const gjk_vec3 square = {d->x - (int32_t)gjk_sar64(gjk_mul32(e.x, along), 30),
                             d->y - (int32_t)gjk_sar64(gjk_mul32(e.y, along), 30),
                             d->z - (int32_t)gjk_sar64(gjk_mul32(e.z, along), 30)};
    const gjk_unit3 u = gjk_unit(&square);
    lift(p, &u, radius);
  }
}

// Keeps corners i and j only, the one of the lower vertex number first.
static void keep_edge(gjk_polygon *p, unsigned i, unsigned j) {
  const bool ordered = p->vertex[i] <= p->vertex[j];
  const unsigned first = ordered ? i : j, second = ordered ? j : i;
  // corner[1] is written as a sum: GCC copies two vectors at once by a call of memcpy on ARMv6-M.
  const gjk_vec3 from = p->corner[first], edge = gjk_sub(p->corner[second], from);
  const uint16_t from_vertex = p->vertex[first], to_vertex = p->vertex[second];
  p->corner[0] = from;
  p->corner[1] = gjk_add(from, edge);
  //@ assert p->corner[1].x >= -(INT32_C(3) << 28) && p->corner[1].x <= INT32_C(3) << 28;
  //@ assert p->corner[1].y >= -(INT32_C(3) << 28) && p->corner[1].y <= INT32_C(3) << 28;
  //@ assert p->corner[1].z >= -(INT32_C(3) << 28) && p->corner[1].z <= INT32_C(3) << 28;
  p->vertex[0] = from_vertex;
  p->vertex[1] = to_vertex;
  p->feature = (uint16_t)(from_vertex + 256u * to_vertex);
  p->count = 2;
}

// An edge has one other corner, which both neighbours are.
void gjk_polygon_settle(gjk_polygon *p, gjk_q16 radius) {
  const gjk_vec3 *d = &p->direction;
  unsigned top = 0, end = 0;
  uint32_t least = GJK_POLYGON_LEVEL_KEY;
  int64_t farthest = INT64_MIN;
  for (unsigned i = 0; i < p->count; i++) {
    const int64_t along = gjk_dot(&p->corner[i], d);  // |corner| <= sqrt(3) 2^30, |d| about 2^30: below 2^62
    if (along > farthest) {
      farthest = along;
      top = i;
    }
  }
  end = top;
  const unsigned neighbour[2] = {top + 1 < p->count ? top + 1 : 0, top > 0 ? top - 1 : p->count - 1u};
  for (unsigned k = 0; k < 2; k++) {
    const gjk_vec3 edge = gjk_sub(p->corner[neighbour[k]], p->corner[top]);
    const uint32_t key = gjk_polygon_is_zero(&edge) ? GJK_POLYGON_LEVEL_KEY : slope(&edge, d);
    if (key < least) {
      least = key;
      end = neighbour[k];
    }
  }
  if (end == top) {  // Step 4
    p->feature = p->vertex[top];
    p->count = 1;
    return;
  }
  keep_edge(p, top, end);
  lift_edge(p, radius);
}

// Steps 2 to 4.
static void finish_polygon(gjk_polygon *p, gjk_q16 radius) {
  if (GJK_SHAPES <= GJK_SHAPES_ROUND) {  // no faces
    if (p->count > 1) {
      gjk_polygon_settle(p, radius);
    }
  } else if (p->meets || (p->count > 2 && gjk_polygon_alignment(&p->normal, &p->direction) >= GJK_POLYGON_FACE_KEY)) {
    lift_face(p, radius);
  } else if (p->count > 1) {
    gjk_polygon_settle(p, radius);
  }
}

void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *direction, gjk_polygon *out) {
  const gjk_shape_class *type = c->shape->type;
  // Step 1.
  out->direction = *direction;
  out->count = 1;
  out->meets = false;
  out->feature = 0;
  out->radius = c->shape->convex_radius;
  switch (GJK_SHAPES <= GJK_SHAPES_BOXES ? (uint8_t)GJK_KIND_AXES : type->kind) {
    case GJK_KIND_AXES: gjk_polygon_from_axes(c, position, out); break;
    case GJK_KIND_VERTICES:
      if (GJK_SHAPES >= GJK_SHAPES_POLYTOPES && type->buffered) {
        gjk_polygon_from_hull(c, position, out);
      } else if (GJK_SHAPES >= GJK_SHAPES_POLYTOPES) {
        gjk_polygon_from_triangle(c, position, out);
      }
      break;
    case GJK_KIND_CYLINDER:
    case GJK_KIND_CONE:
      if (GJK_SHAPES >= GJK_SHAPES_ALL) {
        gjk_polygon_from_disc_base(c, position, out);
      }
      return;
    default: return;
  }
  finish_polygon(out, c->shape->convex_radius);
}
