// Where the way of a point enters a box, by the box's three slabs. What rounding may decide is left open.
//
// A - B is all start + s_0 g_0 + s_1 g_1 + s_2 g_2 with |s_k| <= 1, where g_k are half axes and start = centre_a - centre_b. Take
//   n_k = g_i x g_j    v = |n_k . g_k|, the same for all k    e_k = n_k . start    d_k = n_k . t
// The point s t of the line is in slab k where |s d_k - e_k| <= v. With the sign of n_k for which d_k >= 0, the line enters the
// slab at (e_k - v) / d_k, and leaves it at (e_k + v) / d_k.
//
//   Step 1   Find v, e_k and d_k in 32 bits. The half axes are scaled to 30 bits for n_k, all vectors to 29 bits.
//   Step 2   A slab lies behind the way's start: SHORT. The start is in all slabs: INSIDE.
//   Step 3   Take the slab m that the line enters last. It does so beyond the way's end: SHORT.
//   Step 4   The line has left slab k by then: BESIDE. The edges along the third axis, seen along the line, part both.
//   Step 5   The point is in all slabs: FACET. Of the two halves of the parallelogram take the one that holds it.
//
// Each step asks for more than its error. So what it answers is no tie, and as exact signs would have it.
//   h = n_k / 2^32         below 2^28.1 in length
//   h . v                  v below 2^29.8 in length:  below 2^58. The part of n_k that is cut off adds less than 3 2^29
//   v, e_k, d_k            h . v / 2^29:              below 2^29, and off by less than 3 and 1 for the floor
//   q = e_k -+ v           below 2^30, and off by 8;  compared with d_k, 12
//   q d - e d              below 2^61, and off by 2^30 4 + 2^29 8 + 2 2^29 4 + 2^6 < 2^33.6
//   the same with v d      below 2^62, and off by 2^33.6 + 2 2^29 4 + 2^5 < 2^35
#include "gjk_slab.h"

#if !GJK_SMALL

#define SUM_ERROR 16
#define PRODUCT_ERROR (INT64_C(1) << 35)

// The slabs as the line passes them.
typedef struct line_slabs {
  int32_t v, e[3], d[3];
  bool minus[3];  // e and d are those of -n_k
  bool left;      // the half axes are left-handed: n_k . g_k < 0
} line_slabs;

// Is each component from -2^28 to below 2^28? Then the way's are below 2^29 in size.
static bool is_near_centre(const gjk_long3 *v) {
  const uint64_t half = UINT64_C(1) << 28;
  return (((uint64_t)v->x + half) | ((uint64_t)v->y + half) | ((uint64_t)v->z + half)) >> 29 == 0;
}

static gjk_vec3 shifted(const gjk_vec3 *v, unsigned shift) {
  const gjk_vec3 out = {gjk_shl32(v->x, shift), gjk_shl32(v->y, shift), gjk_shl32(v->z, shift)};
  return out;
}

static int32_t along_slab(const gjk_vec3 *h, const gjk_vec3 *v) {
  return (int32_t)gjk_sar64(gjk_dot(h, v), 29);
}

// Step 1. Pre: p->start is near, as p->goal.
static void set_line_slabs(const gjk_portal *p, line_slabs *of) {
  const gjk_vec3 *g = p->a->frame;
  const gjk_vec3 start = {(int32_t)p->start.x, (int32_t)p->start.y, (int32_t)p->start.z};
  const gjk_vec3 t = {(int32_t)p->way.x, (int32_t)p->way.y, (int32_t)p->way.z};
  // Below 2^29: a core radius is below 2^28 + 2^3.
  const uint32_t bits = gjk_magnitude32(start.x) | gjk_magnitude32(start.y) | gjk_magnitude32(start.z) |
                        gjk_magnitude32(t.x) | gjk_magnitude32(t.y) | gjk_magnitude32(t.z) |
                        (uint32_t)p->a->core_radius;
  const unsigned up = gjk_clz32(bits) - 3, fill = gjk_clz32((uint32_t)p->a->core_radius) - 2;
  const gjk_vec3 from = shifted(&start, up), along = shifted(&t, up);
  const gjk_vec3 axis[3] = {shifted(&g[0], fill), shifted(&g[1], fill), shifted(&g[2], fill)};
  for (unsigned k = 0; k < 3; k++) {
    gjk_long3 n;
    gjk_cross(&axis[gjk_next(k)], &axis[gjk_next(gjk_next(k))], &n);
    const gjk_vec3 h = {gjk_high32(n.x), gjk_high32(n.y), gjk_high32(n.z)};
    const int32_t e = along_slab(&h, &from), d = along_slab(&h, &along);
    of->minus[k] = d < 0;
    of->e[k] = d < 0 ? -e : e;
    of->d[k] = d < 0 ? -d : d;
    if (k == 0) {
      const gjk_vec3 own = shifted(&g[0], up);
      const int32_t volume = along_slab(&h, &own);
      of->left = volume < 0;
      of->v = volume < 0 ? -volume : volume;
    }
  }
}

// Makes a corner of another one: half axis k changes its sign. twice: 2 g_k, scaled.
static void flip_slab_axis(const gjk_corner *of, unsigned k, const gjk_vec3 *twice, gjk_corner *out) {
  const bool added = (of->a >> k & 1u) != 0;
  out->u = added ? gjk_sub(of->u, *twice) : gjk_add(of->u, *twice);
  out->a = (uint16_t)(of->a ^ 1u << k);
  out->b = 0;
}

// Makes half of facet k the plane: of the facet that the line leaves by, or enters by. far: of the halves, the one with the
// vertex to which both other half axes are added.
static void set_slab_facet(gjk_portal *p, const line_slabs *of, unsigned k, bool leaves, bool far) {
  const gjk_vec3 *g = p->a->frame;
  const bool outward = of->minus[k] != leaves;  // of n_k
  const unsigned i = outward ? gjk_next(k) : gjk_next(gjk_next(k)), j = 3 - k - i;
  const gjk_vec3 across = gjk_add(g[i], g[j]), first = far ? across : gjk_negate(across);
  const bool added = outward != of->left;  // n_k . g_k > 0, but for left-handed axes
  const gjk_vec3 corner = added ? gjk_add(first, g[k]) : gjk_sub(first, g[k]);
  const gjk_vec3 of_i = shifted(&g[i], p->shift + 1u), of_j = shifted(&g[j], p->shift + 1u);
  p->corner[0].u = shifted(&corner, p->shift);
  p->corner[0].a = (uint16_t)((far ? 7u ^ 1u << k : 0) | (added ? 1u << k : 0));
  p->corner[0].b = 0;
  flip_slab_axis(&p->corner[0], i, &of_i, &p->corner[1]);
  flip_slab_axis(&p->corner[0], j, &of_j, &p->corner[2]);
  p->count = 3;
  p->leaving = true;  // the corners run counterclockwise about the outward normal
}

// Step 4 found that the line has left slab k where it enters slab m. The direction g of the certificate, for which the plane
// across g x t parts both.
static gjk_passage pass_beside(gjk_portal *p, unsigned m, unsigned k) {
  const gjk_vec3 *g = &p->a->frame[3 - m - k];
  const gjk_vec3 start = {(int32_t)p->start.x, (int32_t)p->start.y, (int32_t)p->start.z};
  const gjk_vec3 t = {(int32_t)p->way.x, (int32_t)p->way.y, (int32_t)p->way.z};
  gjk_long3 moment;
  gjk_cross(&t, &start, &moment);  // (g x t) . start = g . (t x start)
  p->g = gjk_dot_sign(&moment, g) < 0 ? *g : gjk_negate(*g);
  return GJK_PASSAGE_BESIDE;
}

// Steps 4 and 5.
static gjk_passage pass_slabs(gjk_portal *p, const line_slabs *of, unsigned m) {
  const int32_t q = of->e[m] - of->v;
  const int64_t reach = gjk_mul32(of->v, of->d[m]);
  int64_t sum = 0;
  for (unsigned n = 1; n < 3; n++) {
    const unsigned k = n == 1 ? gjk_next(m) : gjk_next(gjk_next(m));
    // Times d_m and det: s d_k - e_k
    const int64_t at = gjk_mul32(q, of->d[k]) - gjk_mul32(of->e[k], of->d[m]);
    if (at > reach + PRODUCT_ERROR) {
      return pass_beside(p, m, k);
    }
    if (at > reach - PRODUCT_ERROR || at < PRODUCT_ERROR - reach) {
      return GJK_PASSAGE_LIMIT;
    }
    sum += of->minus[k] ? -at : at;
  }
  if (sum >= -2 * PRODUCT_ERROR && sum <= 2 * PRODUCT_ERROR) {
    return GJK_PASSAGE_LIMIT;
  }
  set_slab_facet(p, of, m, false, (sum > 0) != of->left);
  gjk_portal_set_plane(p);
  gjk_portal_set_direction(p);
  return GJK_PASSAGE_FACET;
}

// Steps 2 and 3.
static gjk_passage enter_slabs(gjk_portal *p, const line_slabs *of) {
  int32_t highest = of->e[0] - of->v;
  unsigned m = 0;
  for (unsigned k = 0; k < 3; k++) {
    const int32_t q = of->e[k] - of->v;
    if (of->e[k] + of->v < -SUM_ERROR) {
      set_slab_facet(p, of, k, true, false);
      return GJK_PASSAGE_SHORT;
    }
    if (of->e[k] + of->v <= SUM_ERROR) {
      return GJK_PASSAGE_LIMIT;
    }
    highest = q > highest ? q : highest;
    m = gjk_mul32(q, of->d[m]) > gjk_mul32(of->e[m] - of->v, of->d[k]) ? k : m;
  }
  const int32_t entry = of->e[m] - of->v;
  if (highest < -SUM_ERROR) {
    return GJK_PASSAGE_INSIDE;
  }
  if (entry <= SUM_ERROR || (entry >= of->d[m] - SUM_ERROR && entry <= of->d[m] + SUM_ERROR)) {
    return GJK_PASSAGE_LIMIT;
  }
  if (entry > of->d[m]) {
    set_slab_facet(p, of, m, false, false);
    return GJK_PASSAGE_SHORT;
  }
  return pass_slabs(p, of, m);
}

gjk_passage gjk_slab_find(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  line_slabs slabs;
  gjk_portal_place(p, a, b, way);
  if (!is_near_centre(&p->start) || !is_near_centre(&p->goal) || gjk_portal_is_zero(&way->t)) {
    return GJK_PASSAGE_LIMIT;
  }
  p->shift = gjk_portal_shift(a, b);
  p->iterations = 0;
  p->wide = false;
  p->near = true;
  set_line_slabs(p, &slabs);
  return enter_slabs(p, &slabs);
}

#endif
