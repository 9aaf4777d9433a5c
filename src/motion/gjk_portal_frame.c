// A line and A - B beside it: the frame of gjk_portal_frame.h, and its exact signs.
#include "gjk_portal_frame.h"

// v / 8, rounded down.
static gjk_vec3 eighth(const gjk_long3 *v) {
  const gjk_vec3 q = {(int32_t)gjk_sar64(v->x, 3), (int32_t)gjk_sar64(v->y, 3), (int32_t)gjk_sar64(v->z, 3)};
  return q;
}

// (x, y, z), and u in LSB added to it. u may be NULL.
static gjk_vec3 place(const gjk_portal *p, const gjk_vec3 *u, int32_t x, int32_t y, int32_t z) {
  gjk_vec3 v = {x, y, z};
  if (u != NULL) {
    v.x += gjk_sar32(u->x, p->shift);
    v.y += gjk_sar32(u->y, p->shift);
    v.z += gjk_sar32(u->z, p->shift);
  }
  return v;
}

int64_t gjk_portal_dot(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at, uint32_t *low) {
  if (p->near) {
    const gjk_vec3 v = place(p, u, (int32_t)at->x, (int32_t)at->y, (int32_t)at->z);
    return gjk_dot_exact(&p->n, &v, low);
  }
  // |at / 8| <= sqrt(3) 2^30:  |n . (at / 8)| < 2^91, 8 times its high part < 2^63
  uint32_t low_of_q;
  const gjk_vec3 q = eighth(at), rest = place(p, u, (int32_t)(at->x & 7), (int32_t)(at->y & 7), (int32_t)(at->z & 7));
  const int64_t of_q = gjk_dot_exact(&p->n, &q, &low_of_q), of_rest = gjk_dot_exact(&p->n, &rest, low);
  const uint64_t lows = 8 * (uint64_t)low_of_q + *low;
  *low = (uint32_t)(lows & INT32_MAX);
  return 8 * of_q + of_rest + (int64_t)(lows >> 31);
}

// Out of line: near pairs go past it.
GJK_OUT_OF_LINE static int far_side(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at) {
  uint32_t low;
  const int64_t high = gjk_portal_dot(p, u, at, &low);
  return high != 0 ? gjk_sign64(high) : low != 0;
}

int gjk_portal_side(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at) {
  if (!p->near) {
    return far_side(p, u, at);
  }
  const gjk_vec3 v = place(p, u, (int32_t)at->x, (int32_t)at->y, (int32_t)at->z);
  return gjk_dot_sign(&p->n, &v);
}

// x y modulo 2^64, which is the product where that fits.
static inline uint64_t product(int64_t x, int64_t y) {
  return (uint64_t)x * (uint64_t)y;
}

// *out = t x v. Pre: it fits. Out of line: near pairs go past it.
GJK_OUT_OF_LINE static void cross_wide(const gjk_long3 *t, const gjk_long3 *v, gjk_long3 *out) {
  out->x = gjk_int64(product(t->y, v->z) - product(t->z, v->y));
  out->y = gjk_int64(product(t->z, v->x) - product(t->x, v->z));
  out->z = gjk_int64(product(t->x, v->y) - product(t->y, v->x));
}

void gjk_portal_cross(const gjk_portal *p, const gjk_vec3 *v, gjk_long3 *out) {
  if (!p->wide) {
    gjk_cross(&p->t, v, out);
    return;
  }
  const gjk_long3 wide = {v->x, v->y, v->z};
  cross_wide(&p->way, &wide, out);
}

void gjk_portal_face(gjk_portal *p, const gjk_vec3 *g) {
  const gjk_vec3 opposite = gjk_negate(*g);
  gjk_set(g, &p->g);
  gjk_portal_cross(p, &opposite, &p->n);
}

int gjk_portal_beside(const gjk_portal *p, const gjk_vec3 *u) {
  gjk_long3 v;
  gjk_portal_lateral(p, u, &v);
  return gjk_dot_sign(&v, &p->g);
}

int64_t gjk_portal_component(const gjk_long3 *v, unsigned axis) {
  return gjk_long_component(v, axis);
}

// Is each component from -2^29 to below 2^29?
GJK_ONE_COPY static bool is_below_29(const gjk_long3 *v) {
  const uint64_t half = UINT64_C(1) << 29;
  return (((uint64_t)v->x + half) | ((uint64_t)v->y + half) | ((uint64_t)v->z + half)) >> 30 == 0;
}

// *v 2^shift, modulo 2^64.
GJK_ONE_COPY static void scale(gjk_long3 *v, unsigned shift) {
  v->x = gjk_shl64(v->x, shift);
  v->y = gjk_shl64(v->y, shift);
  v->z = gjk_shl64(v->z, shift);
}

void gjk_portal_start(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  gjk_portal_place(p, a, b, way);
  if (gjk_portal_is_zero(&p->way)) {
    // Any axis serves for whether the origin lies in A - B.
    p->way.x = 1;
  }
  p->shift = gjk_portal_shift(a, b);
  const uint64_t bits = gjk_portal_bits(&p->way);
  p->wide = bits >> 30 != 0;
  p->near = !p->wide && is_below_29(&p->start) && is_below_29(&p->goal);
  gjk_long3 t = {p->way.x, p->way.y, p->way.z};
  if (!p->wide) {
    const unsigned shift = gjk_clz32((uint32_t)bits) - 2;
    p->t.x = gjk_shl32((int32_t)t.x, shift);
    p->t.y = gjk_shl32((int32_t)t.y, shift);
    p->t.z = gjk_shl32((int32_t)t.z, shift);
    //@ assert p->t.x > -(INT32_C(1) << 30) && p->t.x < INT32_C(1) << 30;
    //@ assert p->t.y > -(INT32_C(1) << 30) && p->t.y < INT32_C(1) << 30;
    //@ assert p->t.z > -(INT32_C(1) << 30) && p->t.z < INT32_C(1) << 30;
    t.x = p->t.x;
    t.y = p->t.y;
    t.z = p->t.z;
  }
  if (p->near) {
    const gjk_vec3 start = {(int32_t)p->start.x, (int32_t)p->start.y, (int32_t)p->start.z};
    gjk_cross(&p->t, &start, &p->m);
    scale(&p->m, p->shift);
  } else {
    gjk_long3 start = {p->start.x, p->start.y, p->start.z};
    scale(&start, p->shift);
    cross_wide(&t, &start, &p->m);
  }
  p->iterations = 0;
  p->lone = gjk_portal_is_point(b);
  p->of_b.offset.x = p->of_b.offset.y = p->of_b.offset.z = 0;
  p->of_b.vertex = 0;
  p->leaving = false;
  p->arrives = false;
}

// v . d = 2^32 (returned) + *low, exact. Pre: |v| < 2^62.9, |d| < 2^30, lengths: the low digits' sum is below 2^62.8
static int64_t dot_wide(const gjk_long3 *v, const gjk_vec3 *d, uint32_t *low) {
  const gjk_vec3 lowest = {gjk_low_balanced(v->x), gjk_low_balanced(v->y), gjk_low_balanced(v->z)};
  const gjk_vec3 highest = {gjk_high_balanced(v->x), gjk_high_balanced(v->y), gjk_high_balanced(v->z)};
  const int64_t sum = gjk_dot(&lowest, d);
  *low = gjk_low32(sum);
  return gjk_dot(&highest, d) + gjk_sar64(sum, 32);
}

void gjk_portal_weights(const gjk_portal *p, gjk_u128 weight[3]) {
  const gjk_corner *c = p->corner;
  gjk_long3 v;
  for (unsigned i = 0; i < 3; i++) {
    weight[i].high = weight[i].low = 0;
  }
  if (p->count == 3) {
    for (unsigned i = 0; i < 3; i++) {
      const unsigned j = gjk_next(i), k = gjk_next(j);
      const gjk_vec3 step = gjk_sub(c[k].u, c[j].u);
      uint32_t low;
      gjk_portal_lateral(p, &c[j].u, &v);
      const int64_t high = dot_wide(&v, &step, &low);
      weight[i].high = (uint64_t)gjk_sar64(high, 32);
      weight[i].low = (uint64_t)high << 32 | low;
    }
  } else if (p->count == 2) {
    for (unsigned i = 0; i < 2; i++) {
      gjk_portal_lateral(p, &c[1 - i].u, &v);
      weight[i].low = gjk_magnitude64(gjk_portal_component(&v, p->axis));
    }
  } else {
    weight[0].low = 1;
  }
}
