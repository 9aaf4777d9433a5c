// Cylinder along local z.
#include "gjk_curved.h"
#include "gjk_disc_base.h"

static void support_cylinder(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 local = gjk_curved_direction(c, d);
  gjk_fine_point point;
  gjk_rim(c->shape->size.x, &local, &point);
  point.z = (local.z < 0 ? -c->shape->size.z : c->shape->size.z) * (1 << GJK_FINE_BITS);
  gjk_curved_support(c, &point, out);
}

const gjk_shape_class gjk_class_cylinder = GJK_CURVED_CLASS(gjk_disc_base_measure, support_cylinder, GJK_KIND_CYLINDER);
