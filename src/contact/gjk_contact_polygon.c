// Faces, edges and corners that meet a direction.
#include "gjk_contact_polygon.h"

#include "../arith/gjk_height_key.h"
#include "../arith/gjk_unit.h"
#include "../shape/gjk_disc_base.h"

// The direction is 2^30 long. By gjk_height_key, the square of what a unit vector has of it: 7/8 of 2^60 for a normal that is
// within 20.7 degrees of it, 1/8 for an edge that is within 20.7 degrees of level.
#define FACE_KEY (UINT32_C(59) << 16 | 0xC000u)
#define LEVEL_KEY (UINT32_C(57) << 16)

// A rim of less counts as a point.
#define RIM_MIN 8

// Corners of a hull that lie at most so far behind its farthest one, Q30 LSB, are among the farthest.
#define LEVEL_SLACK (INT64_C(4) << 30)

// Faces within about a degree of each other meet the direction as well as each other.
#define ALIKE_KEY 64

// What a face with farthest corners to share is preferred by; above all ranks.
#define SHARES_EDGE (UINT32_C(1) << 23)

static bool is_zero(const gjk_vec3 *v) {
  return (v->x | v->y | v->z) == 0;
}

static void negate(gjk_long3 *n) {
  n->x = -n->x;
  n->y = -n->y;
  n->z = -n->z;
}

// How well a face meets the direction, 0: not at all.
static uint32_t alignment(const gjk_long3 *n, const gjk_vec3 *direction) {
  gjk_search_direction r;
  if ((n->x | n->y | n->z) == 0) {
    return 0;
  }
  gjk_search_direction_of(n, &r);
  return gjk_height_key(gjk_dot(&r.d, direction), gjk_dot(&r.d, &r.d));
}

// How far from level an edge is. Pre: not 0.
static uint32_t slope(const gjk_vec3 *edge, const gjk_vec3 *direction) {
  const int64_t along = gjk_dot(edge, direction);
  return gjk_height_key(along < 0 ? -along : along, gjk_dot(edge, edge));
}

// Moves the corners by radius along u, Q2.30, to the nearest LSB.
static void lift(gjk_polygon *p, const gjk_unit3 *u, gjk_q16 radius) {
  const int64_t half = INT64_C(1) << 29;
  const gjk_vec3 by = {(gjk_q16)gjk_sar64(gjk_mul32(u->x, radius) + half, 30),
                       (gjk_q16)gjk_sar64(gjk_mul32(u->y, radius) + half, 30),
                       (gjk_q16)gjk_sar64(gjk_mul32(u->z, radius) + half, 30)};
  for (unsigned i = 0; i < p->count; i++) {
    p->corner[i] = gjk_add(p->corner[i], by);
  }
}

static void lift_face(gjk_polygon *p, gjk_q16 radius) {
  if (radius > 0) {
    gjk_search_direction r;
    gjk_search_direction_of(&p->normal, &r);
    const gjk_unit3 u = gjk_unit(&r.d);
    lift(p, &u, radius);
  }
}

// Square to the edge, as near to the direction as that allows; the edge is nearly level, so the rest is most of it.
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

static void set_corner(gjk_polygon *p, unsigned i, const gjk_vec3 *position, const gjk_vec3 *offset, unsigned vertex) {
  p->corner[i] = gjk_add(*position, *offset);
  p->vertex[i] = (uint16_t)vertex;
}

// Keeps corners i and j alone.
static void keep_edge(gjk_polygon *p, unsigned i, unsigned j) {
  const bool ordered = p->vertex[i] <= p->vertex[j];
  const unsigned first = ordered ? i : j, second = ordered ? j : i;
  // As a sum, since GCC copies two of them for ARMv6-M by a call of memcpy.
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

// From a face that leans away, the more level edge at its farthest corner; from an edge, itself. Unless it is level
// enough, the farthest corner.
static void settle_for_less(gjk_polygon *p, gjk_q16 radius) {
  const gjk_vec3 *d = &p->direction;
  unsigned top = 0, end = 0;
  uint32_t least = LEVEL_KEY;
  int64_t farthest = INT64_MIN;
  for (unsigned i = 0; i < p->count; i++) {
    const int64_t along = gjk_dot(&p->corner[i], d);  // below 2^62
    if (along > farthest) {
      farthest = along;
      top = i;
    }
  }
  end = top;
  const unsigned neighbour[2] = {top + 1 < p->count ? top + 1 : 0, top > 0 ? top - 1 : p->count - 1u};
  for (unsigned k = 0; k < 2; k++) {
    const gjk_vec3 edge = gjk_sub(p->corner[neighbour[k]], p->corner[top]);
    const uint32_t key = is_zero(&edge) ? LEVEL_KEY : slope(&edge, d);
    if (key < least) {
      least = key;
      end = neighbour[k];
    }
  }
  if (end == top) {
    p->feature = p->vertex[top];
    p->count = 1;
    return;
  }
  keep_edge(p, top, end);
  lift_edge(p, radius);
}

// Keeps the face if it meets the direction well enough.
static void finish_polygon(gjk_polygon *p, gjk_q16 radius) {
  if (p->count > 2 && alignment(&p->normal, &p->direction) >= FACE_KEY) {
    lift_face(p, radius);
  } else if (p->count > 1) {
    settle_for_less(p, radius);
  }
}

// The edge of a box along axis i that reaches farthest: with as little of the others as there is.
static void set_box_edge(const gjk_collider *c, const gjk_vec3 *position, unsigned i, unsigned signs,
                         gjk_polygon *out) {
  for (unsigned k = 0; k < 2; k++) {
    gjk_vec3 offset;
    const unsigned vertex = k == 0 ? signs & ~(1u << i) : signs | 1u << i;
    c->shape->type->vertex(c, (uint16_t)vertex, &offset);
    set_corner(out, k, position, &offset, vertex);
  }
  out->count = 2;
  out->feature = (uint16_t)(out->vertex[0] + 256u * out->vertex[1]);
}

// The face of a box across axis i that its farthest corner, by signs, is one of.
static void set_box_face(const gjk_collider *c, const gjk_vec3 *position, unsigned i, unsigned signs,
                         gjk_polygon *out) {
  const unsigned j = gjk_next(i), k = gjk_next(j);
  const gjk_vec3 *across = &c->frame[j], *across2 = &c->frame[k];
  gjk_cross(across, across2, &out->normal);
  const bool turned = gjk_dot_sign(&out->normal, &out->direction) < 0;
  // Around j x k: both minus, j, both, k.
  const unsigned around[4] = {0, 1u << j, 1u << j | 1u << k, 1u << k};
  for (unsigned n = 0; n < 4; n++) {
    gjk_vec3 offset;
    const unsigned vertex = (signs & 1u << i) | around[turned ? 3 - n : n];
    c->shape->type->vertex(c, (uint16_t)vertex, &offset);
    set_corner(out, n, position, &offset, vertex);
  }
  if (turned) {
    negate(&out->normal);
  }
  out->feature = (uint16_t)(2 * i + ((signs >> i & 1u) ^ 1u));
  out->count = 4;
}

static void from_box(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_vec3 *d = &out->direction;
  unsigned face = 3, longest = 3, signs = 0;
  uint32_t best = 0, most = 0;
  for (unsigned i = 0; i < 3; i++) {
    const unsigned j = gjk_next(i);
    gjk_long3 n;
    gjk_cross(&c->frame[j], &c->frame[gjk_next(j)], &n);
    if (gjk_dot_sign(&n, d) < 0) {
      negate(&n);
    }
    const uint32_t key = alignment(&n, d);
    if ((n.x | n.y | n.z) != 0 && (face == 3 || key > best)) {
      best = key;
      face = i;
    }
    if (gjk_norm1(c->frame[i]) > most) {
      most = gjk_norm1(c->frame[i]);
      longest = i;
    }
    signs |= gjk_dot(&c->frame[i], d) >= 0 ? 1u << i : 0;
  }
  if (face < 3) {
    set_box_face(c, position, face, signs, out);
  } else if (longest < 3) {
    set_box_edge(c, position, longest, signs, out);
  }
}

static void from_axes(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  if (c->count == 3) {
    from_box(c, position, out);
  } else if (c->count == 1 && !is_zero(&c->frame[0])) {
    set_box_edge(c, position, 0, 0, out);
  }
}

// Sums the triangles of a face: at most 10 times 2^58 for edges of 2^29.
static void set_polygon_normal(gjk_polygon *p) {
  gjk_long3 n = {0, 0, 0};
  for (unsigned i = 2; i < p->count; i++) {
    gjk_long3 part;
    gjk_triangle_normal(&p->corner[0], &p->corner[i - 1], &p->corner[i], &part);
    n.x += part.x;
    n.y += part.y;
    n.z += part.z;
  }
  //@ assert n.x > -(INT64_C(1) << 62) && n.x < INT64_C(1) << 62;
  //@ assert n.y > -(INT64_C(1) << 62) && n.y < INT64_C(1) << 62;
  //@ assert n.z > -(INT64_C(1) << 62) && n.z < INT64_C(1) << 62;
  p->normal = n;
}

static void from_triangle(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  for (unsigned i = 0; i < 3; i++) {
    set_corner(out, i, position, &c->frame[i], i);
  }
  out->count = 3;
  set_polygon_normal(out);
  if (gjk_dot_sign(&out->normal, &out->direction) < 0) {
    set_corner(out, 1, position, &c->frame[2], 2);
    set_corner(out, 2, position, &c->frame[1], 1);
    negate(&out->normal);
    out->feature = 1;
  }
}

// Loads face i of a hull. Returns how many corners reach as far as limit, or 2 if there are more.
static unsigned load_face(const gjk_collider *c, const gjk_vec3 *position, uint32_t i, int64_t limit,
                          gjk_polygon *out) {
  const gjk_hull_faces *faces = c->shape->faces;
  const uint16_t first = i == 0 ? 0 : faces->end[i - 1];
  unsigned farthest = 0;
  out->count = (uint8_t)(faces->end[i] - first);
  for (unsigned k = 0; k < out->count; k++) {
    gjk_vec3 offset;
    const uint16_t vertex = faces->corner[first + k];
    c->shape->type->vertex(c, vertex, &offset);
    set_corner(out, k, position, &offset, vertex);
    farthest += gjk_dot(&offset, &out->direction) >= limit ? 1 : 0;
  }
  out->feature = (uint16_t)i;
  return farthest < 2 ? farthest : 2;
}

// Is a rounded face broad enough for its normal to count? Posing moves corners by an LSB. That turns a face of width W by
// about 1 / W, and takes points at radius up to radius / (2 W^2) off the surface. W is at least the normal's largest
// component by the sum of a corner's distances from the first. 2^root is from the root of radius to twice that.
static bool is_broad(const gjk_polygon *p, gjk_q16 radius) {
  const uint64_t x = gjk_magnitude64(p->normal.x), y = gjk_magnitude64(p->normal.y), z = gjk_magnitude64(p->normal.z);
  const uint64_t size = x > y ? (x > z ? x : z) : (y > z ? y : z);
  uint32_t length = 0;
  for (unsigned i = 1; i < p->count; i++) {
    const uint32_t from_first = gjk_norm1(gjk_sub(p->corner[i], p->corner[0]));  // below 2^31
    length = from_first > length ? from_first : length;
  }
  const unsigned root = radius > 0 ? (33 - gjk_clz32((uint32_t)radius)) / 2 : 0;  // at most 15
  return radius == 0 || size >= (uint64_t)length << root;
}

// The face that meets the direction best among those with two farthest corners; without such, among those with one. Of
// faces in one plane it is the first.
static void from_hull(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_hull_faces *faces = c->shape->faces;
  uint32_t best = 0, best_face = 0;
  gjk_support found;
  if (faces == NULL || faces->count == 0) {
    return;
  }
  c->shape->type->support(c, &out->direction, &found);
  const int64_t limit = gjk_dot(&found.offset, &out->direction) - LEVEL_SLACK;
  for (uint32_t i = 0; i < faces->count; i++) {  // below 2^16
    const unsigned farthest = load_face(c, position, i, limit, out);
    if (farthest > 0) {
      set_polygon_normal(out);
      const uint32_t key = is_broad(out, c->shape->convex_radius) ? alignment(&out->normal, &out->direction) : 0;
      const uint32_t score = key > 0 && farthest > 1 ? key + SHARES_EDGE : key;
      if (score > best + (best > 0 ? ALIKE_KEY : 0)) {
        best = score;
        best_face = i;
      }
    }
  }
  if (best > 0) {
    load_face(c, position, best_face, limit, out);
    set_polygon_normal(out);
  } else {
    out->count = 1;
    out->feature = found.vertex;
  }
}

static gjk_vec3 axis_of(const gjk_collider *c) {
  const gjk_vec3 axis = {c->frame[0].z, c->frame[1].z, c->frame[2].z};
  return axis;
}

static void set_fine_corner(const gjk_collider *c, const gjk_vec3 *position, const gjk_fine_point *point, unsigned i,
                            gjk_polygon *out) {
  gjk_support s;
  gjk_curved_support(c, point, &s);
  //@ assert s.offset.x >= -(INT32_C(1) << 28) && s.offset.x <= INT32_C(1) << 28;
  //@ assert s.offset.y >= -(INT32_C(1) << 28) && s.offset.y <= INT32_C(1) << 28;
  //@ assert s.offset.z >= -(INT32_C(1) << 28) && s.offset.z <= INT32_C(1) << 28;
  set_corner(out, i, position, &s.offset, i);
}

// The flat end of a cylinder or cone as an octagon, its rounding included.
static void set_cap(const gjk_collider *c, const gjk_vec3 *position, bool top, gjk_polygon *out) {
  const int32_t diagonal = 759250125;  // 2^30 cos 45 degrees
  const gjk_q30 cosine[8] = {GJK_Q30_ONE, diagonal, 0, -diagonal, -GJK_Q30_ONE, -diagonal, 0, diagonal};
  const gjk_shape *shape = c->shape;
  const int32_t height = (shape->size.z + shape->convex_radius) * (1 << GJK_FINE_BITS);  // at most 2^30
  const gjk_vec3 axis = axis_of(c);
  if (shape->size.x < RIM_MIN) {
    return;
  }
  for (unsigned i = 0; i < 8; i++) {
    const gjk_q30 sine = cosine[(i + 6) & 7u];
    const gjk_fine_point point = {gjk_fine(shape->size.x, cosine[i]), gjk_fine(shape->size.x, top ? sine : -sine),
                                  top ? height : -height};
    set_fine_corner(c, position, &point, i, out);
  }
  out->normal.x = top ? axis.x : -(int64_t)axis.x;
  out->normal.y = top ? axis.y : -(int64_t)axis.y;
  out->normal.z = top ? axis.z : -(int64_t)axis.z;
  out->feature = top ? 0 : 1;
  out->count = 8;
}

// The line of the side that faces the direction, from base to top.
static void set_side(const gjk_collider *c, const gjk_vec3 *position, gjk_q16 base, gjk_q16 top, gjk_polygon *out) {
  const gjk_vec3 local = gjk_curved_direction(c, &out->direction);
  const int32_t height = c->shape->size.z * (1 << GJK_FINE_BITS);
  gjk_fine_point point;
  gjk_rim(base, &local, &point);
  point.z = -height;
  set_fine_corner(c, position, &point, 0, out);
  gjk_rim(top, &local, &point);
  point.z = height;
  set_fine_corner(c, position, &point, 1, out);
  out->count = 2;
}

static void from_round(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_shape *shape = c->shape;
  const bool cone = shape->type->kind == GJK_KIND_CONE;
  const gjk_vec3 axis = axis_of(c), *d = &out->direction;
  const int64_t along = gjk_dot(&axis, d);
  const bool top = along > 0, flat = !cone || !top || shape->size.z == 0;
  if (flat && gjk_height_key(top ? along : -along, gjk_dot(&axis, &axis)) >= FACE_KEY) {
    set_cap(c, position, top, out);
  } else if (shape->size.z > 0) {
    // A cylinder's own radius adds to its rounding, so that its side needs rounding to LSB but once.
    set_side(c, position, cone ? shape->size.x : shape->size.x + shape->convex_radius,
             cone ? 0 : shape->size.x + shape->convex_radius, out);
    settle_for_less(out, cone ? shape->convex_radius : 0);
    out->radius = cone ? shape->convex_radius : shape->size.x + shape->convex_radius;
    out->feature = 2;
  }
}

void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *direction, gjk_polygon *out) {
  const gjk_shape_class *type = c->shape->type;
  out->direction = *direction;
  out->count = 1;
  out->feature = 0;
  out->radius = c->shape->convex_radius;
  switch (type->kind) {
    case GJK_KIND_AXES: from_axes(c, position, out); break;
    case GJK_KIND_VERTICES:
      if (type->buffered) {
        from_hull(c, position, out);
      } else {
        from_triangle(c, position, out);
      }
      break;
    case GJK_KIND_CYLINDER:
    case GJK_KIND_CONE: from_round(c, position, out); return;
    default: return;
  }
  finish_polygon(out, c->shape->convex_radius);
}
