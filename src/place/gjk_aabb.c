// The AABB of a collider.
#include "../shape/gjk_shape_class.h"
#include "gjk/collider.h"

// A coordinate that a curved shape does not exceed along one axis, from its centre; direction is +1 or -1. The support
// point may stop short of the surface by 1 LSB.
static int32_t reach(const gjk_collider *c, int axis, int32_t direction) {
  const int32_t length = direction * (INT32_C(1) << 29);
  const gjk_vec3 d = {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
  gjk_support found;
  c->shape->type->support(c, &d, &found);
  return (axis == 0 ? found.offset.x : axis == 1 ? found.offset.y : found.offset.z) + direction;
}

static void bound_curved(const gjk_collider *c, gjk_aabb *out) {
  out->lower.x = reach(c, 0, -1);
  out->lower.y = reach(c, 1, -1);
  out->lower.z = reach(c, 2, -1);
  out->upper.x = reach(c, 0, 1);
  out->upper.y = reach(c, 1, 1);
  out->upper.z = reach(c, 2, 1);
}

static int32_t size_of(int32_t x) {
  return x < 0 ? -x : x;
}

// Each half axis reaches as far along a coordinate axis as its component there. Pre: the sums are at most core_radius.
static void bound_axes(const gjk_collider *c, gjk_aabb *out) {
  gjk_vec3 sum = {0, 0, 0};
  for (unsigned i = 0; i < c->count; i++) {
    sum.x += size_of(c->frame[i].x);
    sum.y += size_of(c->frame[i].y);
    sum.z += size_of(c->frame[i].z);
  }
  out->lower = gjk_negate(sum);
  out->upper = sum;
}

static void bound_vertices(const gjk_collider *c, gjk_aabb *out) {
  gjk_vec3 v;
  (void)c->shape->type->vertex(c, 0, &v);  // a triangle or hull has a vertex 0
  out->lower = v;
  out->upper = v;
  for (uint32_t i = 1; i < c->count; i++) {
    (void)c->shape->type->vertex(c, (uint16_t)i, &v);
    out->lower.x = v.x < out->lower.x ? v.x : out->lower.x;
    out->lower.y = v.y < out->lower.y ? v.y : out->lower.y;
    out->lower.z = v.z < out->lower.z ? v.z : out->lower.z;
    out->upper.x = v.x > out->upper.x ? v.x : out->upper.x;
    out->upper.y = v.y > out->upper.y ? v.y : out->upper.y;
    out->upper.z = v.z > out->upper.z ? v.z : out->upper.z;
  }
}

// centre + offset, saturated. Comparisons of 32 bits take less code than gjk_saturate of a 64-bit sum.
static gjk_q16 saturating_add(gjk_q16 centre, int32_t offset) {
  if (offset < 0) {
    return centre < INT32_MIN - offset ? INT32_MIN : centre + offset;
  }
  return centre > INT32_MAX - offset ? INT32_MAX : centre + offset;
}

gjk_status gjk_collider_aabb(const gjk_collider *c, gjk_aabb *out) {
  if (c == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (c->state != GJK_STATE_POSED) {
    return GJK_ERROR_UNINITIALISED;
  }
  const gjk_q16 convex_radius = c->shape->convex_radius;
  if (gjk_is_curved(c->shape)) {
    bound_curved(c, out);
  } else if (gjk_has_half_axes(c->shape)) {
    bound_axes(c, out);
  } else {
    bound_vertices(c, out);
  }
  //@ assert convex_radius >= 0 && convex_radius <= GJK_RADIUS_MAX;
  //@ assert out->lower.x >= -(1L << 29) && out->lower.y >= -(1L << 29) && out->lower.z >= -(1L << 29);
  //@ assert out->upper.x <= 1L << 29 && out->upper.y <= 1L << 29 && out->upper.z <= 1L << 29;
  out->lower.x = saturating_add(c->centre.x, out->lower.x - convex_radius);
  out->lower.y = saturating_add(c->centre.y, out->lower.y - convex_radius);
  out->lower.z = saturating_add(c->centre.z, out->lower.z - convex_radius);
  out->upper.x = saturating_add(c->centre.x, out->upper.x + convex_radius);
  out->upper.y = saturating_add(c->centre.y, out->upper.y + convex_radius);
  out->upper.z = saturating_add(c->centre.z, out->upper.z + convex_radius);
  return GJK_OK;
}
