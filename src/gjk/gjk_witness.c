// The witness points.
//
//   Step 1   Order the feature's vertices by their numbers.
//   Step 2   Find the exact weights of the vertices in the nearest point.
//   Step 3   Where the triangle is half of a parallelogram, of two edges or of a box's face, the other halves hold the point
//            as well. Take it from the lowest corner, along both sides: that is the same for all of them.
//   Step 4   Round the weights, and take the point of each shape by them.
//
// So the points depend on the feature's vertices alone, not on the way to them.
#include "gjk_witness.h"

// The nearest point is u and parts of the ways from there to v and to w. Of an edge w is u, of a vertex v is as well.
typedef struct feature {
  const gjk_vertex *u, *v, *w;
  gjk_barycentric weight[2];  // of v and w: each at most 1
} feature;

// At a smaller shift edges may be so long that weights of 31 bits move the point by half an LSB: low parts count too.
#define FINE_SHIFT 4

// What the low parts of the weights of v - u and w - u add, Q31. In line it costs 0.9 % of a distance query.
GJK_OUT_OF_LINE static int64_t fine_part(const feature *f, int32_t v, int32_t w) {
  // |v|, |w| <= 2^30, weights < 2^16:  at most 2^31
  return gjk_sar64(gjk_mac32(gjk_mul32(v, f->weight[0].low), w, f->weight[1].low), 16);
}

// One coordinate of the nearest point, Q31, and half an LSB:
//   u + (weight of v) (v - u) + (weight of w) (w - u).
// In line: on Cortex-M0 that saves 1.4 % of a distance query.
static inline int64_t weighted(const feature *f, int32_t u, int32_t v, int32_t w) {
  //@ assert u >= -(INT32_C(1) << 29) && u <= INT32_C(1) << 29;
  //@ assert v >= -(INT32_C(1) << 29) && v <= INT32_C(1) << 29;
  //@ assert w >= -(INT32_C(1) << 29) && w <= INT32_C(1) << 29;
  v -= u;
  w -= u;
  const int64_t start = gjk_shl64(2 * u + 1, 30);  // |u| <= 2^29:  at most 2^60 + 2^30
  //@ assert start >= -(INT64_C(1) << 61) && start <= INT64_C(1) << 61;
  // |v - u|, |w - u| <= 2^30, weights <= 2^31:  partial sums at most 9 2^59 + 2^30
  const int64_t sum = gjk_mac32(gjk_mac32(start, v, f->weight[0].high), w, f->weight[1].high);
  return (f->weight[0].low | f->weight[1].low) != 0 ? sum + fine_part(f, v, w) : sum;
}

// One coordinate of a witness point in the world: core, from the centre, Q31, moved by convex_radius along the normal.
static gjk_q16 coordinate(int64_t core, gjk_q16 centre, gjk_q30 normal, gjk_q16 convex_radius, bool *saturated) {
  return gjk_saturate_noting(centre + gjk_sar64(gjk_mac32(core, normal, 2 * convex_radius), 31), saturated);
}

// One coordinate of the vertex of B, from B's centre, by that of the vertex of A and of w. At most 2^28 + 2^3 in size.
static int32_t offset_b(const gjk_iteration *it, gjk_q16 centre_a, gjk_q16 centre_b, int32_t a, int32_t w) {
  const int shift = it->shift;
  if (shift >= 0) {
    return centre_a - centre_b + a - gjk_sar32(w, (unsigned)shift);
  }
  return (int32_t)((int64_t)centre_a - centre_b + a - gjk_shl64(w, (unsigned)-shift));
}

// One coordinate of both points. a: of the vertices of A; w: of their differences, in the frame.
GJK_ONCE static void report_axis(const gjk_iteration *it, const feature *f, gjk_q16 centre_a, gjk_q16 centre_b,
                                 const int32_t a[3], const int32_t w[3], gjk_q30 normal, gjk_q16 *point_a,
                                 gjk_q16 *point_b, bool *saturated) {
  *point_a = coordinate(weighted(f, a[0], a[1], a[2]), centre_a, normal, it->a->shape->convex_radius, saturated);
  *point_b =
      coordinate(weighted(f, offset_b(it, centre_a, centre_b, a[0], w[0]), offset_b(it, centre_a, centre_b, a[1], w[1]),
                          offset_b(it, centre_a, centre_b, a[2], w[2])),
                 centre_b, normal, -it->b->shape->convex_radius, saturated);
}

// Out of line: a fine frame, the usual one, goes past it.
GJK_OUT_OF_LINE static void nearest_points(const gjk_iteration *it, const feature *f, const gjk_unit3 *normal,
                                           gjk_vec3 *point_a, gjk_vec3 *point_b, bool *saturated) {
  const gjk_vertex *u = f->u, *v = f->v, *w = f->w;
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre;
  const int32_t ax[3] = {u->a.offset.x, v->a.offset.x, w->a.offset.x}, wx[3] = {u->w.x, v->w.x, w->w.x};
  report_axis(it, f, a->x, b->x, ax, wx, normal->x, &point_a->x, &point_b->x, saturated);
  const int32_t ay[3] = {u->a.offset.y, v->a.offset.y, w->a.offset.y}, wy[3] = {u->w.y, v->w.y, w->w.y};
  report_axis(it, f, a->y, b->y, ay, wy, normal->y, &point_a->y, &point_b->y, saturated);
  const int32_t az[3] = {u->a.offset.z, v->a.offset.z, w->a.offset.z}, wz[3] = {u->w.z, v->w.z, w->w.z};
  report_axis(it, f, a->z, b->z, az, wz, normal->z, &point_a->z, &point_b->z, saturated);
}

// What all coordinates of both points share in a frame of FINE_SHIFT or more.
typedef struct witness_move {
  int32_t v, w;                // the weights of v and w, Q31
  int32_t radius_a, radius_b;  // 2 convex_radius of A, -2 convex_radius of B
  unsigned shift;              // of the frame
} witness_move;

// start + radius normal, floored from Q31. Pre: the result fits.
static inline int32_t along_normal(int64_t start, gjk_q30 normal, int32_t radius) {
  return (int32_t)gjk_sar64(gjk_mac32(start, normal, radius), 31);
}

// One coordinate of both points, as report_axis. a0, a1, a2: of the vertices u, v, w of A; w0, w1, w2: of their
// differences, all multiples of 2^shift. With w0 / 2^shift = centre_a + a0 - centre_b - b0 and so on, and o for A's
// core point, Q31, from A's centre, B's core point from B's centre is
//   o + (centre_a - centre_b - w0 / 2^shift) + (weight of v) (w0 - w1) / 2^shift + (weight of w) (w0 - w2) / 2^shift.
// So B's point takes centre_a as well: no coordinate of B's vertices is needed. Pre: |centre_a| <= 2^30.
//   |a| < 2^28 + 2^16, |w| / 2^shift < 2^26 since the reach is below 2^30; each weight <= 2^31
//   partial sums:   A's core point 2^59 + 2^47 and twice as much for each way; 2^59 for the differences, 2^59 for the radius
//   results:        at most 2^30 + 2^28 + 2^28 + 2^27
static inline void report_coarse_axis(const witness_move *m, gjk_q16 centre_a, int32_t a0, int32_t a1, int32_t a2,
                                      int32_t w0, int32_t w1, int32_t w2, gjk_q30 normal, gjk_q16 *point_a,
                                      gjk_q16 *point_b) {
  const int64_t start = gjk_int64((uint64_t)a0 << 31 | UINT64_C(1) << 30);  // and half an LSB
  const int64_t core = gjk_mac32(gjk_mac32(start, a1 - a0, m->v), a2 - a0, m->w);
  const int64_t of_b =
      gjk_mac32(gjk_mac32(core, gjk_sar32(w0 - w1, m->shift), m->v), gjk_sar32(w0 - w2, m->shift), m->w);
  *point_a = centre_a + along_normal(core, normal, m->radius_a);
  *point_b = centre_a - gjk_sar32(w0, m->shift) + along_normal(of_b, normal, m->radius_b);
}

// The same as nearest_points. Pre: is_coarse.
static inline void coarse_points(const gjk_iteration *it, const feature *f, const gjk_unit3 *normal, gjk_vec3 *point_a,
                                 gjk_vec3 *point_b) {
  const gjk_vertex *u = f->u, *v = f->v, *w = f->w;
  const gjk_vec3 *centre = &it->a->centre;
  const witness_move m = {f->weight[0].high, f->weight[1].high, 2 * it->a->shape->convex_radius,
                          -2 * it->b->shape->convex_radius, (unsigned)it->shift};
  report_coarse_axis(&m, centre->x, u->a.offset.x, v->a.offset.x, w->a.offset.x, u->w.x, v->w.x, w->w.x, normal->x,
                     &point_a->x, &point_b->x);
  report_coarse_axis(&m, centre->y, u->a.offset.y, v->a.offset.y, w->a.offset.y, u->w.y, v->w.y, w->w.y, normal->y,
                     &point_a->y, &point_b->y);
  report_coarse_axis(&m, centre->z, u->a.offset.z, v->a.offset.z, w->a.offset.z, u->w.z, v->w.z, w->w.z, normal->z,
                     &point_a->z, &point_b->z);
}

// Have the weights no low parts, and does every coordinate fit Q16.16? A is at most 2^30 LSB from the world's origin
// along each axis, and B's points are within 2^27 + 2^28 + 2^28 of its centre.
static inline bool is_coarse(const gjk_iteration *it) {
  const gjk_vec3 *c = &it->a->centre;
  // not reached: GJK_SMALL is a constant
  return !GJK_SMALL && it->shift >= FINE_SHIFT &&
         ((uint32_t)(c->x ^ gjk_sar32(c->x, 31)) | (uint32_t)(c->y ^ gjk_sar32(c->y, 31)) |
          (uint32_t)(c->z ^ gjk_sar32(c->z, 31))) >>
                 30 ==
             0;
}

// Step 1 for two of them.
static inline void order_two(const gjk_simplex *s, uint8_t *first, uint8_t *second) {
  const gjk_vertex *v = &s->slot[*first], *w = &s->slot[*second];
  if (v->a.vertex > w->a.vertex || (v->a.vertex == w->a.vertex && v->b > w->b)) {
    const uint8_t other = *second;
    *second = *first;
    *first = other;
  }
}

// Is at most one bit set?
static inline bool is_bit(unsigned x) {
  return (x & (x - 1u)) == 0;
}

// Step 3: which of three ordered vertices of a parallelogram has both others for neighbours? 3: they are on none.
//   two edges    it shares its vertex of A with one of them, that of B with the other
//   a face       its number, of a corner of the box, differs from either in one bit
static unsigned corner_between(const gjk_iteration *it, const gjk_vertex *u, const gjk_vertex *v, const gjk_vertex *w) {
  const bool one_a = u->a.vertex == w->a.vertex, one_b = u->b == v->b && u->b == w->b;
  if (one_a || one_b) {
    const unsigned i = one_a ? u->b : u->a.vertex, j = one_a ? v->b : v->a.vertex, k = one_a ? w->b : w->a.vertex;
    const bool ij = is_bit(i ^ j), jk = is_bit(j ^ k), ik = is_bit(i ^ k);
    const gjk_collider *c = one_a ? it->b : it->a;
    return c->shape->type->kind != GJK_KIND_AXES ? 3 : ij && ik ? 0 : ij && jk ? 1 : ik && jk ? 2 : 3;
  }
  if (u->a.vertex == v->a.vertex) {
    return w->b == u->b ? 0 : w->b == v->b ? 1 : 3;
  }
  return v->a.vertex != w->a.vertex ? 3 : u->b == v->b ? 1 : u->b == w->b ? 2 : 3;
}

// *out = p + q - r, a vertex of A - B beside them.
static void add_corner(const gjk_vertex *p, const gjk_vertex *q, const gjk_vertex *r, gjk_vertex *out) {
  const gjk_vec3 offset = gjk_sub(p->a.offset, r->a.offset), w = gjk_sub(p->w, r->w);
  out->a.offset = gjk_add(offset, q->a.offset);
  out->w = gjk_add(w, q->w);
}

// Step 3: f becomes the lowest corner and its neighbours, part[1] and part[2] the exact weights of the ways to them, where
// the vertices are on a parallelogram. scratch: room for a corner that is not among them.
static void take_parallelogram(const gjk_iteration *it, feature *f, gjk_u128 part[3], gjk_vertex *scratch) {
  switch (corner_between(it, f->u, f->v, f->w)) {
    case 1:  // u is the lowest; v and the corner opposite to v are its neighbours
      add_corner(f->u, f->w, f->v, scratch);
      f->w = scratch;
      gjk_u128_add(&part[1], &part[2]);
      break;
    case 2:  // the lowest is opposite to w
      add_corner(f->u, f->v, f->w, scratch);
      f->w = f->v;
      f->v = f->u;
      f->u = scratch;
      gjk_u128_add(&part[0], &part[2]);
      gjk_u128_add(&part[2], &part[1]);
      part[1] = part[0];
      break;
    default: break;  // u is the lowest, v and w are its neighbours
  }
}

void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a, gjk_vec3 *point_b,
                        bool *saturated) {
  const gjk_simplex *s = &it->simplex;
  // Curved shapes have no numbers; a far frame rounds a corner and its neighbours apart. Both always start cold.
  const bool ordered = it->shift >= 0 && !gjk_pair_is_curved(it);
  uint8_t order[3] = {s->order[0], s->order[1], s->order[2]};
  gjk_vertex scratch;
  feature f;
  //@ assert s->count >= 1 && s->count <= 3;
  if (ordered && s->count > 1) {
    order_two(s, &order[0], &order[1]);
    if (s->count == 3) {
      order_two(s, &order[1], &order[2]);
      order_two(s, &order[0], &order[1]);
    }
  }
  f.u = &s->slot[order[0]];
  f.v = s->count > 1 ? &s->slot[order[1]] : f.u;
  f.w = s->count > 2 ? &s->slot[order[2]] : f.u;
  f.weight[0].high = f.weight[0].low = f.weight[1].high = f.weight[1].low = 0;
  if (s->count > 1) {
    gjk_u128 part[3], whole;
    gjk_simplex_parts(s, order, part);
    whole = part[0];
    gjk_u128_add(&whole, &part[1]);
    if (s->count == 3) {
      gjk_u128_add(&whole, &part[2]);
      if (ordered) {
        take_parallelogram(it, &f, part, &scratch);
      }
    }
    gjk_weights(&part[1], s->count - 1u, &whole, it->shift < FINE_SHIFT, f.weight);
  }
  if (is_coarse(it)) {
    coarse_points(it, &f, normal, point_a, point_b);
  } else {
    nearest_points(it, &f, normal, point_a, point_b, saturated);
  }
}
