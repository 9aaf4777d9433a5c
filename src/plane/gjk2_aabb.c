// The AABB of a collider of the plane.
#include "gjk2/collider.h"
#include "gjk2_class.h"

// A coordinate that the shape does not exceed along one axis, from its centre. The support point of a shape without vertices may
// stop short of the surface by 1 LSB.
static int32_t plane_reach(const gjk2_collider *c, bool along_y, int32_t direction) {
  const gjk2_vec d = {along_y ? 0 : direction * (INT32_C(1) << 29), along_y ? direction * (INT32_C(1) << 29) : 0};
  gjk2_support found;
  c->shape->type->support(c, &d, &found);
  return (along_y ? found.offset.y : found.offset.x) +
         direction * ((c->shape->type->vertex == NULL) + c->shape->convex_radius);
}

gjk_status gjk2_collider_aabb(const gjk2_collider *c, gjk2_aabb *out) {
  if (c == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK2_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  out->lower.x = gjk_saturate((int64_t)c->centre.x + plane_reach(c, false, -1));
  out->lower.y = gjk_saturate((int64_t)c->centre.y + plane_reach(c, true, -1));
  out->upper.x = gjk_saturate((int64_t)c->centre.x + plane_reach(c, false, 1));
  out->upper.y = gjk_saturate((int64_t)c->centre.y + plane_reach(c, true, 1));
  return GJK_OK;
}
