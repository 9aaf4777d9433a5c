// The polygon with which a shape meets a direction: a face, an edge or a corner.
//
//   1. The kind of the shape offers its face that meets the direction best, or the edge or corner that it has:
//      gjk_polygon_axes.c, gjk_polygon_vertices.c, gjk_polygon_disc_base.c.
//   2. A face within 20.7 degrees of the direction stays, moved outwards by the convex radius.
//   3. Otherwise, of the two edges at the farthest corner the one that is more level stays, if it is within 20.7
//      degrees of level; it too is moved outwards by the convex radius.
//   4. Otherwise the farthest corner stays. Steps 3 and 4 are in gjk_polygon_kind.c.
//
// What is rounded, in LSB, for the largest radius of 2^28 LSB:
//   corner of a polytope     not at all: the posed vertex
//   corner of a disc base    per component to the nearest LSB, within 1 of the surface
//   move of a face           unit vector within 7/2 2^-30:  0.88, to the nearest LSB: 0.87; together below 2
//   move of an edge          unit vector within 15/2 2^-30: 1.88, to the nearest LSB: 0.87; together below 3
#include "gjk_contact_polygon.h"

#include "gjk_polygon_kind.h"

// Step 2: along the normal, which is rounded to 30 bits before it is made a unit vector.
static void lift_face(gjk_polygon *p, gjk_q16 radius) {
  if (radius > 0) {
    gjk_search_direction r;
    gjk_search_direction_of(&p->normal, &r);
    const gjk_unit3 u = gjk_unit(&r.d);
    gjk_polygon_lift(p, &u, radius);
  }
}

// Steps 2 to 4. Spheres, capsules and points have no face.
static void finish_polygon(gjk_polygon *p, gjk_q16 radius) {
  if (GJK_SHAPES > GJK_SHAPES_ROUND &&
      (p->meets || (p->count > 2 && gjk_polygon_alignment(&p->normal, &p->direction) >= GJK_POLYGON_FACE_KEY))) {
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
