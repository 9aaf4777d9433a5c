// Polygons on a grid: see gjk_flat.h.
#include "gjk_flat.h"

// The bits of the largest difference of a corner from o, per axis.
static uint32_t spread(const gjk_polygon *p, const gjk_vec3 *o, uint32_t all) {
  for (unsigned i = 0; i < p->count; i++) {
    const gjk_vec3 v = gjk_sub(p->corner[i], *o);
    all |= gjk_magnitude32(v.x) | gjk_magnitude32(v.y) | gjk_magnitude32(v.z);
  }
  return all;
}

// The direction in turn from its longest component on, and how the grid is shifted.
typedef struct view {
  const gjk_vec3 *origin;
  int32_t d[3];  // m, m + 1, m + 2; both lines of u with the sign of d.m
  int32_t size;  // |d.m|
  unsigned axis, shift;
} view;

// The components of v in turn from the axis on.
static void turn(const gjk_vec3 *v, unsigned axis, int32_t out[3]) {
  out[0] = axis == 0 ? v->x : axis == 1 ? v->y : v->z;
  out[1] = axis == 0 ? v->y : axis == 1 ? v->z : v->x;
  out[2] = axis == 0 ? v->z : axis == 1 ? v->x : v->y;
}

// |d| <= 2^30 and |v| < 2^bits per component: sums below 2^(31 + bits), shifted by bits + 2 below 2^29.
static void put_on_grid(const view *seen, const gjk_polygon *p, gjk_flat_point *out) {
  for (unsigned i = 0; i < p->count; i++) {
    const gjk_vec3 way = gjk_sub(p->corner[i], *seen->origin);
    int32_t v[3];
    turn(&way, seen->axis, v);
    out[i].u = (int32_t)gjk_sar64(gjk_mul32(seen->size, v[1]) - gjk_mul32(seen->d[1], v[0]), seen->shift);
    out[i].v = (int32_t)gjk_sar64(gjk_mul32(seen->d[0], v[2]) - gjk_mul32(seen->d[2], v[0]), seen->shift);
  }
}

void gjk_flat_set(gjk_flat *flat, const gjk_polygon *a, const gjk_polygon *b) {
  const gjk_vec3 *d = &a->direction;
  const uint32_t x = gjk_magnitude32(d->x), y = gjk_magnitude32(d->y), z = gjk_magnitude32(d->z);
  view seen;
  seen.origin = &a->corner[0];
  seen.axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  turn(d, seen.axis, seen.d);
  seen.size = (int32_t)gjk_magnitude32(seen.d[0]);
  seen.d[1] = seen.d[0] < 0 ? -seen.d[1] : seen.d[1];
  flat->bits = 32 - gjk_clz32(spread(b, seen.origin, spread(a, seen.origin, 1)));
  flat->size = (uint32_t)seen.size;
  seen.shift = flat->bits + 2;
  put_on_grid(&seen, a, flat->a);
  put_on_grid(&seen, b, flat->b);
}
