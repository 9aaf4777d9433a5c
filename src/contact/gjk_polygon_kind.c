// Steps 3 and 4 of gjk_contact_polygon.c, and what the kinds of shapes share in step 1.
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

// |u.x radius| <= 2^30 2^28 = 2^58; the quotient is rounded to the nearest LSB
void gjk_polygon_lift(gjk_polygon *p, const gjk_unit3 *u, gjk_q16 radius) {
  const gjk_vec3 unit = {u->x, u->y, u->z};
  gjk_vec3 by;
  gjk_scaled(&unit, radius, 30, &by);
  for (unsigned i = 0; i < p->count; i++) {
    p->corner[i] = gjk_add(p->corner[i], by);
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
    gjk_polygon_lift(p, &u, radius);
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
