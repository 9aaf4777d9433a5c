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

const gjk_shape_class gjk_class_cylinder = {
    .measure = gjk_disc_base_measure,
    .pose = gjk_curved_pose,
    .support = support_cylinder,
    .refine = NULL,
    .vertex = NULL,
    .stalls = gjk_curved_stalls,
    .close = NULL,
    .concave = NULL,
    .buffered = false,
    .count = 0,
    .kind = GJK_KIND_CYLINDER,
};
