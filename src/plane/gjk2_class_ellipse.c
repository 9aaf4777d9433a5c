// Ellipse with its axes along the local axes.
#include "gjk2_curved.h"
#include "gjk2_curved_depth.h"

static gjk_status measure_ellipse(const gjk2_shape *shape, gjk2_extent *out) {
  const gjk2_vec *size = &shape->size;
  const gjk2_vec origin = {0, 0};
  if (size->x < 0 || size->y < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const gjk_q16 longest = size->x > size->y ? size->x : size->y;
  out->centre = origin;
  out->squared = (uint64_t)gjk_mul32(longest, longest);
  out->ordered = false;
  return GJK_OK;
}

// The farthest point along d is size * u, where u is the unit vector along size * d, both products per component.
static void support_ellipse(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec size = c->shape->size, local = gjk2_curved_direction(c, *d);
  const int64_t x = gjk_mul32(size.x, local.x), y = gjk_mul32(size.y, local.y);
  gjk2_vec point = {0, 0};
  if ((x | y) != 0) {
    point = gjk2_fine_stretch(size, x, y);
  }
  gjk2_curved_support(c, point, out);
}

const gjk2_shape_class gjk2_class_ellipse = GJK2_CURVED_CLASS(measure_ellipse, support_ellipse);
