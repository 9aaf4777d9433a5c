// The axis-aligned box of a collider: its supports along the axes.
#include "gjk/collider.h"
#include "shape_class.h"

// How far the collider reaches from its centre along one axis, direction = +1 or -1; rounding included.
static int64_t reach(const gjk_collider *c, int axis, int32_t direction) {
  const int32_t length = direction * (INT32_C(1) << 29);
  const gjk_vec3 d = {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
  gjk_support found;
  c->shape->type->support(c, &d, true, &found);
  const int32_t along = axis == 0 ? found.offset.x : axis == 1 ? found.offset.y : found.offset.z;
  // A curved shape's support may stop short by 1.
  const int32_t curved = c->shape->type->vertex == NULL ? 1 : 0;
  return (int64_t)along + direction * ((int64_t)c->shape->round + curved);
}

static gjk_q16 cut_off(int64_t x) {
  return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (gjk_q16)x;
}

gjk_status gjk_collider_aabb(const gjk_collider *c, gjk_aabb *out) {
  if (c == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  out->lower.x = cut_off(c->centre.x + reach(c, 0, -1));
  out->lower.y = cut_off(c->centre.y + reach(c, 1, -1));
  out->lower.z = cut_off(c->centre.z + reach(c, 2, -1));
  out->upper.x = cut_off(c->centre.x + reach(c, 0, 1));
  out->upper.y = cut_off(c->centre.y + reach(c, 1, 1));
  out->upper.z = cut_off(c->centre.z + reach(c, 2, 1));
  return GJK_OK;
}
