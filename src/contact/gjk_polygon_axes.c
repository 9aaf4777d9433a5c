// Step 1 of gjk_contact_polygon.c for shapes spanned by half axes: box, segment, point. Corners are exact.
#include "gjk_polygon_kind.h"

// Corner k: the vertex of that number.
static void set_vertex(const gjk_collider *c, const gjk_vec3 *position, unsigned k, unsigned vertex, gjk_polygon *out) {
  gjk_vec3 offset;
  c->shape->type->vertex(c, (uint16_t)vertex, &offset);
  gjk_polygon_set_corner(out, k, position, &offset, vertex);
}

// The edge of a box along axis i whose ends agree with signs in the other axes.
static void set_box_edge(const gjk_collider *c, const gjk_vec3 *position, unsigned i, unsigned signs,
                         gjk_polygon *out) {
  set_vertex(c, position, 0, signs & ~(1u << i), out);
  set_vertex(c, position, 1, signs | 1u << i, out);
  out->count = 2;
  out->feature = (uint16_t)(out->vertex[0] + 256u * out->vertex[1]);
}

// The face of a box across axis i that contains the box's farthest corner, given by signs.
static void set_box_face(const gjk_collider *c, const gjk_vec3 *position, unsigned i, unsigned signs,
                         gjk_polygon *out) {
  const unsigned j = gjk_next(i), k = gjk_next(j);
  const gjk_vec3 *across = &c->frame[j], *across2 = &c->frame[k], *along = &c->frame[i];
  const unsigned side = signs & 1u << i;
  gjk_cross(across, across2, &out->normal);
  const bool turned = gjk_dot_sign(&out->normal, &out->direction) < 0;
  // Signs of j and k in the order that runs counterclockwise around j x k.
  const unsigned around[4] = {0, 1u << j, 1u << j | 1u << k, 1u << k};
  const gjk_vec3 middle = side != 0 ? gjk_add(*position, *along) : gjk_sub(*position, *along);
  const gjk_vec3 sum = gjk_add(*across, *across2), difference = gjk_sub(*across, *across2);
  gjk_vec3 corner[4];
  corner[0] = gjk_sub(middle, sum);
  corner[1] = gjk_add(middle, difference);
  corner[2] = gjk_add(middle, sum);
  corner[3] = gjk_sub(middle, difference);
  for (unsigned n = 0; n < 4; n++) {
    const unsigned from = turned ? 3 - n : n;
    if (GJK_SMALL) {
      set_vertex(c, position, n, side | around[from], out);
    } else {
      gjk_set(&corner[from], &out->corner[n]);
      out->vertex[n] = (uint16_t)(side | around[from]);
    }
  }
  if (turned) {
    gjk_polygon_negate(&out->normal);
  }
  out->feature = (uint16_t)(2 * i + (side != 0 ? 0u : 1u));
  out->count = 4;
}

// The axis that surely has the face nearest to the direction: 3 where none is sure. along: the axes along the direction.
// Axes of 1/16 unit or more are square to each other up to a thousandth, so a face's normal is within a thousandth of its
// axis. One within 15 degrees of the direction is the nearest, and meets it.
//   |axis| <= 2^28, |direction| about 2^30:      |along| below 2^59; its square in LSB^2 and the axis's below 2^56
static unsigned facing_axis(const gjk_collider *c, const int64_t along[3]) {
  unsigned facing = 3;
  for (unsigned i = 0; i < 3; i++) {
    const int64_t square = gjk_dot(&c->frame[i], &c->frame[i]);
    const int32_t part = (int32_t)gjk_sar64(along[i], 30);
    if (square < INT64_C(1) << 24) {
      return 3;
    }
    facing = gjk_mul32(part, part) > square - gjk_sar64(square, 4) ? i : facing;
  }
  return facing;
}

// The face whose normal is nearest to the direction. A box that is flat in two axes has no normal; it offers its
// longest edge.
static void from_box(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_vec3 *d = &out->direction;
  unsigned face, longest = 3, signs = 0;
  uint32_t best = 0, most = 0;
  int64_t along[3];
  for (unsigned i = 0; i < 3; i++) {
    along[i] = gjk_dot(&c->frame[i], d);
    signs |= along[i] >= 0 ? 1u << i : 0;
  }
  face = GJK_SMALL ? 3 : facing_axis(c, along);
  out->meets = face < 3;
  for (unsigned i = 0; i < 3 && !out->meets; i++) {
    const unsigned j = gjk_next(i);
    gjk_long3 n;
    gjk_cross(&c->frame[j], &c->frame[gjk_next(j)], &n);
    if (gjk_dot_sign(&n, d) < 0) {
      gjk_polygon_negate(&n);
    }
    const uint32_t key = gjk_polygon_alignment(&n, d);
    if ((n.x | n.y | n.z) != 0 && (face == 3 || key > best)) {
      best = key;
      face = i;
    }
    if (gjk_norm1(c->frame[i]) > most) {
      most = gjk_norm1(c->frame[i]);
      longest = i;
    }
  }
  if (face < 3) {
    set_box_face(c, position, face, signs, out);
  } else if (longest < 3) {
    set_box_edge(c, position, longest, signs, out);
  }
}

void gjk_polygon_from_axes(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && c->count == 3) {
    from_box(c, position, out);
  } else if (c->count == 1 && !gjk_polygon_is_zero(&c->frame[0])) {
    set_box_edge(c, position, 0, 0, out);
  }
}
