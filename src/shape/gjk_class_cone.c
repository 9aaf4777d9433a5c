// Cone along local z: the apex above, the disc base below.
#include "gjk_curved.h"
#include "gjk_disc_base.h"

// Is the apex farther along d than the rim? It is where 2 half d.z > radius |(d.x, d.y)|. Both sides are squared: at
// most 2^120.
static bool apex_is_farther(const gjk_shape *shape, const gjk_vec3 *d) {
  const gjk_vec3 level = {d->x, d->y, 0};
  const int64_t rise = gjk_mul32(2 * shape->size.z, d->z);
  return rise > 0 &&
         gjk_sum_of_products_sign(rise, rise, -gjk_mul32(shape->size.x, shape->size.x), gjk_dot(&level, &level)) > 0;
}

static void support_cone(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 local = gjk_curved_direction(c, d);
  const int32_t half = c->shape->size.z * (1 << GJK_FINE_BITS);
  gjk_fine_point point = {0, 0, half};
  if (!apex_is_farther(c->shape, &local)) {
    gjk_rim(c->shape->size.x, &local, &point);
    point.z = -half;
  }
  gjk_curved_support(c, &point, out);
}

const gjk_shape_class gjk_class_cone = GJK_CURVED_CLASS(gjk_disc_base_measure, support_cone, GJK_KIND_CONE);
