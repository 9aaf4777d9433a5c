// Faces and edges that meet a direction.
#include "contact_polygon.h"

#include "rotation.h"
#include "unit.h"

// cos 45 degrees.
#define DIAGONAL ((gjk_q30)759250125)

gjk_q30 gjk_cosine(const gjk_unit3 *u, const gjk_unit3 *v) {
  const gjk_vec3 w = {v->x, v->y, v->z};
  const int64_t cosine = gjk_sar64(gjk_along(u, &w), 30);
  return cosine < GJK_Q30_ONE ? (gjk_q30)cosine : GJK_Q30_ONE;
}

static gjk_unit3 opposite(gjk_unit3 u) {
  const gjk_unit3 v = {-u.x, -u.y, -u.z};
  return v;
}

// Is e x f not 0? Then its direction. Pre: |e| |f| <= 2^62.
static bool normal_of(const gjk_vec3 *e, const gjk_vec3 *f, gjk_unit3 *out) {
  gjk_long3 n;
  gjk_rounded d;
  gjk_cross(e, f, &n);
  if ((n.x | n.y | n.z) == 0) {
    return false;
  }
  gjk_round_direction(&n, &d);
  *out = gjk_unit(&d.d);
  return true;
}

static void set_edge(const gjk_vec3 *from, const gjk_vec3 *to, gjk_polygon *out) {
  out->corner[0] = *from;
  out->corner[1] = *to;
  out->count = 2;
}

// The face of a box across axis i, on the side to which u leads; its corners go around the axes j and k.
static void set_box_face(const gjk_collider *c, const gjk_vec3 *position, unsigned i, gjk_unit3 across,
                         const gjk_unit3 *u, gjk_polygon *out) {
  const gjk_vec3 *axis = &c->frame[i], *j = &c->frame[gjk_next(i)], *k = &c->frame[gjk_next(gjk_next(i))];
  const bool turned = gjk_cosine(&across, u) < 0;  // u leads against j x k
  out->normal = turned ? opposite(across) : across;
  const bool minus = gjk_along(&out->normal, axis) < 0;
  const gjk_vec3 face = minus ? gjk_sub(*position, *axis) : gjk_add(*position, *axis);
  const gjk_vec3 low = gjk_sub(face, *j), high = gjk_add(face, *j);
  out->corner[0] = gjk_sub(low, *k);
  out->corner[turned ? 3 : 1] = gjk_sub(high, *k);
  out->corner[2] = gjk_add(high, *k);
  out->corner[turned ? 1 : 3] = gjk_add(low, *k);
  out->count = 4;
  out->feature = (uint16_t)(2 * i + minus);
}

static void find_box_face(const gjk_collider *c, const gjk_vec3 *position, const gjk_unit3 *u, gjk_polygon *out) {
  gjk_q30 best = -1;
  for (unsigned i = 0; i < 3; i++) {
    gjk_unit3 across;
    if (normal_of(&c->frame[gjk_next(i)], &c->frame[gjk_next(gjk_next(i))], &across)) {
      const gjk_q30 cosine = gjk_cosine(&across, u), size = cosine < 0 ? -cosine : cosine;
      if (size > best) {
        best = size;
        set_box_face(c, position, i, across, u, out);
      }
    }
  }
  // No two axes span a face: at most one has a length.
  for (unsigned i = 0; i < 3 && best < 0; i++) {
    const gjk_vec3 *axis = &c->frame[i];
    if ((axis->x | axis->y | axis->z) != 0) {
      const gjk_vec3 from = gjk_sub(*position, *axis), to = gjk_add(*position, *axis);
      set_edge(&from, &to, out);
    }
  }
}

static void from_axes(const gjk_collider *c, const gjk_vec3 *position, const gjk_unit3 *u, gjk_polygon *out) {
  if (c->count == 3) {
    find_box_face(c, position, u, out);
  } else if (c->count == 1) {
    const gjk_vec3 from = gjk_sub(*position, c->frame[0]), to = gjk_add(*position, c->frame[0]);
    set_edge(&from, &to, out);
  }
}

// The normal of a face of a hull, from the first corners that are not in a line. False: all are.
static bool normal_of_corners(const gjk_vec3 *corner, unsigned count, gjk_unit3 *out) {
  const gjk_vec3 edge = gjk_sub(corner[1], corner[0]);
  for (unsigned i = 2; i < count; i++) {
    const gjk_vec3 edge2 = gjk_sub(corner[i], corner[0]);
    if (normal_of(&edge, &edge2, out)) {
      return true;
    }
  }
  return false;
}

static void from_triangle(const gjk_collider *c, const gjk_vec3 *position, const gjk_unit3 *u, gjk_polygon *out) {
  for (unsigned i = 0; i < 3; i++) {
    out->corner[i] = gjk_add(*position, c->frame[i]);
  }
  if (!normal_of_corners(out->corner, 3, &out->normal)) {
    return;
  }
  out->count = 3;
  if (gjk_cosine(&out->normal, u) < 0) {
    const gjk_vec3 second = out->corner[1];
    out->corner[1] = out->corner[2];
    out->corner[2] = second;
    out->normal = opposite(out->normal);
    out->feature = 1;
  }
}

// Loads face i of a hull; returns how well it meets u.
static gjk_q30 load_face(const gjk_collider *c, const gjk_vec3 *position, uint32_t i, const gjk_unit3 *u,
                         gjk_polygon *out) {
  const gjk_hull_faces *faces = c->shape->faces;
  const uint16_t first = i == 0 ? 0 : faces->end[i - 1];
  out->count = (uint8_t)(faces->end[i] - first);
  for (unsigned k = 0; k < out->count; k++) {
    gjk_vec3 offset;
    c->shape->type->vertex(c, faces->corner[first + k], &offset);
    out->corner[k] = gjk_add(*position, offset);
  }
  out->feature = (uint16_t)i;
  return normal_of_corners(out->corner, out->count, &out->normal) ? gjk_cosine(&out->normal, u) : -GJK_Q30_ONE;
}

static void from_hull(const gjk_collider *c, const gjk_vec3 *position, const gjk_unit3 *u, gjk_polygon *out) {
  if (c->shape->faces == NULL || c->shape->faces->count == 0) {
    return;
  }
  uint32_t best = 0;
  gjk_q30 cosine = -GJK_Q30_ONE;
  for (uint32_t i = 0; i < c->shape->faces->count; i++) {
    const gjk_q30 meets = load_face(c, position, i, u, out);
    if (meets > cosine) {
      cosine = meets;
      best = i;
    }
  }
  if (load_face(c, position, best, u, out) <= -GJK_Q30_ONE) {
    out->count = 1;
  }
}

// A point of a cylinder or cone, from its own frame.
static gjk_vec3 to_world(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *local) {
  return gjk_add(*position, gjk_rotate(c->frame, local));
}

// size cos or sin of 45 degrees.
static gjk_q16 diagonal(gjk_q16 size) {
  return (gjk_q16)gjk_sar64(gjk_mul32(size, DIAGONAL) + (INT64_C(1) << 29), 30);
}

// The rim at z = height as an octagon: top faces up.
static void set_cap(const gjk_collider *c, const gjk_vec3 *position, gjk_q16 height, bool top, gjk_polygon *out) {
  const gjk_q16 r = c->shape->size.x, d = diagonal(r);
  const gjk_q16 x[8] = {r, d, 0, -d, -r, -d, 0, d}, y[8] = {0, d, r, d, 0, -d, -r, -d};
  for (unsigned i = 0; i < 8; i++) {
    const gjk_vec3 local = {x[i], top ? y[i] : -y[i], height};
    out->corner[i] = to_world(c, position, &local);
  }
  const gjk_unit3 up = {c->frame[0].z, c->frame[1].z, c->frame[2].z};
  out->normal = top ? up : opposite(up);
  out->feature = top ? 0 : 1;
  out->count = 8;
}

// The line of the side towards u, given in the shape's frame and not along the axis: from the base's rim to radius top at
// the upper end.
static void set_side(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *u, gjk_q16 top,
                     gjk_polygon *out) {
  const gjk_vec3 level = {u->x, u->y, 0};
  const gjk_unit3 v = gjk_unit(&level);
  const gjk_q16 r = c->shape->size.x, h = c->shape->size.z;
  const gjk_vec3 low = {(gjk_q16)gjk_sar64(gjk_mul32(r, v.x), 30), (gjk_q16)gjk_sar64(gjk_mul32(r, v.y), 30), -h};
  const gjk_vec3 high = {top == 0 ? 0 : low.x, top == 0 ? 0 : low.y, h};
  const gjk_vec3 from = to_world(c, position, &low), to = to_world(c, position, &high);
  set_edge(&from, &to, out);
  out->feature = 2;
}

static void from_cylinder(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *local, gjk_polygon *out) {
  const gjk_q16 h = c->shape->size.z;
  if (local->z >= DIAGONAL || local->z <= -DIAGONAL) {
    set_cap(c, position, local->z > 0 ? h : -h, local->z > 0, out);
  } else {
    set_side(c, position, local, c->shape->size.x, out);
  }
}

// The side's normal leans up by radius in 2 half of the way out.
static void from_cone(const gjk_collider *c, const gjk_vec3 *position, const gjk_vec3 *local, gjk_polygon *out) {
  if (local->z <= -DIAGONAL) {
    set_cap(c, position, -c->shape->size.z, false, out);
    return;
  }
  if ((local->x | local->y) == 0) {
    return;
  }
  const gjk_vec3 level = {local->x, local->y, 0}, slope = {2 * c->shape->size.z, c->shape->size.x, 0};
  if ((slope.x | slope.y) == 0) {
    return;
  }
  const gjk_unit3 out_from_axis = gjk_unit(&level), lean = gjk_unit(&slope);
  const gjk_q30 out_share = (gjk_q30)gjk_sar64(gjk_along(&out_from_axis, &level), 30);
  const int64_t cosine = gjk_sar64(gjk_mac32(gjk_mul32(lean.x, out_share), lean.y, local->z), 30);
  if (cosine >= GJK_ALIGNED) {
    set_side(c, position, local, 0, out);
  }
}

void gjk_contact_polygon(const gjk_collider *c, const gjk_vec3 *position, const gjk_unit3 *u, gjk_polygon *out) {
  const uint8_t kind = c->shape->type->kind;
  out->corner[0] = *position;
  out->count = 1;
  out->feature = 0;
  if (kind == GJK_KIND_AXES) {
    from_axes(c, position, u, out);
  } else if (kind == GJK_KIND_VERTICES) {
    if (c->shape->type->buffered) {
      from_hull(c, position, u, out);
    } else {
      from_triangle(c, position, u, out);
    }
  } else if (kind != GJK_KIND_SMOOTH) {
    const gjk_vec3 world = {u->x, u->y, u->z}, local = gjk_rotate_back(c->frame, &world);
    if (kind == GJK_KIND_CYLINDER) {
      from_cylinder(c, position, &local, out);
    } else {
      from_cone(c, position, &local, out);
    }
  }
}
