// Steps 1 to 4 of gjk_contact_polygon.c for shapes with a disc base: cylinder and cone. Each corner is computed with
// two bits more than an LSB has, rotated, and rounded to the nearest LSB once.
#include "../shape/gjk_disc_base.h"
#include "gjk_polygon_kind.h"

// A disc of a smaller radius, LSB, is no face: its octagon would be rounding.
#define RIM_MIN 8

// cos 45 degrees, Q2.30.
#define DIAGONAL INT32_C(759250125)

// The shape's z axis in the world, Q2.30.
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
  gjk_polygon_set_corner(out, i, position, &s.offset, i);
}

// Steps 1 and 2: the flat end as an octagon, moved outwards by the convex radius.
static void set_cap(const gjk_collider *c, const gjk_vec3 *position, bool top, gjk_polygon *out) {
  static const gjk_q30 cosine[8] = {GJK_Q30_ONE, DIAGONAL, 0, -DIAGONAL, -GJK_Q30_ONE, -DIAGONAL, 0, DIAGONAL};
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

// Steps 1 and 3: the line of the side that faces the direction, from base to top, whose radii are given.
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

void gjk_polygon_from_disc_base(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_shape *shape = c->shape;
  const bool cone = shape->type->kind == GJK_KIND_CONE;
  const gjk_vec3 axis = axis_of(c), *d = &out->direction;
  const int64_t along = gjk_dot(&axis, d);
  const bool top = along > 0, flat = !cone || !top || shape->size.z == 0;
  if (flat && gjk_height_key(top ? along : -along, gjk_dot(&axis, &axis)) >= GJK_POLYGON_FACE_KEY) {
    set_cap(c, position, top, out);
  } else if (shape->size.z > 0) {
    // A cylinder's disc radius and convex radius are parallel: their sum needs one rounding to LSB.
    set_side(c, position, cone ? shape->size.x : shape->size.x + shape->convex_radius,
             cone ? 0 : shape->size.x + shape->convex_radius, out);
    gjk_polygon_settle(out, cone ? shape->convex_radius : 0);
    out->radius = cone ? shape->convex_radius : shape->size.x + shape->convex_radius;
    out->feature = 2;
  }
}
