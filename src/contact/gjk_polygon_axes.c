// Step 1 of gjk_contact_polygon.c for shapes spanned by half axes: box, segment, point. Corners are exact.
#include "gjk_polygon_kind.h"

// The edge of a box along axis i whose ends agree with signs in the other axes.
static void set_box_edge(const gjk_collider *c, const gjk_vec3 *position, unsigned i, unsigned signs,
                         gjk_polygon *out) {
  for (unsigned k = 0; k < 2; k++) {
    gjk_vec3 offset;
    const unsigned vertex = k == 0 ? signs & ~(1u << i) : signs | 1u << i;
    c->shape->type->vertex(c, (uint16_t)vertex, &offset);
    gjk_polygon_set_corner(out, k, position, &offset, vertex);
  }
  out->count = 2;
  out->feature = (uint16_t)(out->vertex[0] + 256u * out->vertex[1]);
}

// The face of a box across axis i that contains the box's farthest corner, given by signs.
static void set_box_face(const gjk_collider *c, const gjk_vec3 *position, unsigned i, unsigned signs,
                         gjk_polygon *out) {
  const unsigned j = gjk_next(i), k = gjk_next(j);
  const gjk_vec3 *across = &c->frame[j], *across2 = &c->frame[k];
  gjk_cross(across, across2, &out->normal);
  const bool turned = gjk_dot_sign(&out->normal, &out->direction) < 0;
  // Signs of j and k in the order that runs counterclockwise around j x k.
  const unsigned around[4] = {0, 1u << j, 1u << j | 1u << k, 1u << k};
  for (unsigned n = 0; n < 4; n++) {
    gjk_vec3 offset;
    const unsigned vertex = (signs & 1u << i) | around[turned ? 3 - n : n];
    c->shape->type->vertex(c, (uint16_t)vertex, &offset);
    gjk_polygon_set_corner(out, n, position, &offset, vertex);
  }
  if (turned) {
    gjk_polygon_negate(&out->normal);
  }
  out->feature = (uint16_t)(2 * i + ((signs >> i & 1u) ^ 1u));
  out->count = 4;
}

// The face whose normal is nearest to the direction. A box that is flat in two axes has no normal; it offers its
// longest edge.
static void from_box(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_vec3 *d = &out->direction;
  unsigned face = 3, longest = 3, signs = 0;
  uint32_t best = 0, most = 0;
  for (unsigned i = 0; i < 3; i++) {
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
    signs |= gjk_dot(&c->frame[i], d) >= 0 ? 1u << i : 0;
  }
  if (face < 3) {
    set_box_face(c, position, face, signs, out);
  } else if (longest < 3) {
    set_box_edge(c, position, longest, signs, out);
  }
}

void gjk_polygon_from_axes(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  if (c->count == 3) {
    from_box(c, position, out);
  } else if (c->count == 1 && !gjk_polygon_is_zero(&c->frame[0])) {
    set_box_edge(c, position, 0, 0, out);
  }
}
