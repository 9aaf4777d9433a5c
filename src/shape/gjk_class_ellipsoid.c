// Ellipsoid with its axes along the local axes.
#include "gjk_curved.h"

static gjk_status measure_ellipsoid(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 *size = &shape->size;
  const gjk_vec3 origin = {0, 0, 0};
  if (size->x < 0 || size->y < 0 || size->z < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  gjk_q16 longest = size->x > size->y ? size->x : size->y;
  longest = longest > size->z ? longest : size->z;
  out->centre = origin;
  out->squared = (uint64_t)gjk_mul32(longest, longest);
  return GJK_OK;
}

// The farthest point along d is size * u, where u is the unit vector along size * d, both products per component.
static void support_ellipsoid(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 *size = &c->shape->size;
  const gjk_vec3 local = gjk_curved_direction(c, d);
  const gjk_long3 stretched = {gjk_mul32(size->x, local.x), gjk_mul32(size->y, local.y), gjk_mul32(size->z, local.z)};
  gjk_fine_point point = {0, 0, 0};
  if ((stretched.x | stretched.y | stretched.z) != 0) {
    point = gjk_fine_stretch(size, &stretched);
  }
  gjk_curved_support(c, &point, out);
}

const gjk_shape_class gjk_class_ellipsoid = GJK_CURVED_CLASS(measure_ellipsoid, support_ellipsoid, GJK_KIND_SMOOTH);
