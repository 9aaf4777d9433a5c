// The witness points, by barycentric coordinates.
//
//   1. Describe the nearest point by the feature: exact parts that its coordinates are in proportion to. Three corners of a
//      parallelogram are described by it; other vertices are put in an order of their numbers.
//   2. Divide the parts out, to 31 bits or 47.
//   3. Put the point of each shape together and round it.
//
// The description does not depend on which of its triangles the search has found, so the points do not either.
#include "gjk_witness.h"

// The feature's vertices and the barycentric coordinates of its nearest point. Of an edge w is u, of a vertex v is as
// well; their weight is 0 then. Of a parallelogram u is a corner, and v and w are those beside it: each weight is the
// portion of a side, and both together may be up to 2.
typedef struct feature {
  const gjk_vertex *u, *v, *w;
  gjk_barycentric weight[2];  // of v and w
} feature;

// At a smaller shift edges may be so long that weights of 31 bits move the point by half an LSB: low parts count too.
#define FINE_SHIFT 4

// One coordinate of a witness point in the world: core, from the centre, Q31, moved by convex_radius along the normal.
GJK_ONCE static gjk_q16 coordinate(int64_t core, gjk_q16 centre, gjk_q30 normal, gjk_q16 convex_radius,
                                   bool *saturated) {
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

#if GJK_SHAPES <= GJK_SHAPES_POINTS

// One coordinate of both points of two points, w apart in the frame: half an LSB is added to the cores.
GJK_ONE_COPY static void axis_of_points(const gjk_iteration *it, gjk_q16 centre_a, gjk_q16 centre_b, int32_t w,
                                        gjk_q30 normal, gjk_q16 *point_a, gjk_q16 *point_b, bool *saturated) {
  const int64_t half = INT64_C(1) << 30, core_b = gjk_shl64(offset_b(it, centre_a, centre_b, 0, w), 31) + half;
  *point_a = coordinate(half, centre_a, normal, it->a->shape->convex_radius, saturated);
  *point_b = coordinate(core_b, centre_b, normal, -it->b->shape->convex_radius, saturated);
}

static void nearest_points(const gjk_iteration *it, const feature *f, const gjk_unit3 *normal, gjk_vec3 *point_a,
                           gjk_vec3 *point_b, bool *saturated) {
  const gjk_vec3 *a = &it->a->centre, *b = &it->b->centre, *w = &f->u->w;
  axis_of_points(it, a->x, b->x, w->x, normal->x, &point_a->x, &point_b->x, saturated);
  axis_of_points(it, a->y, b->y, w->y, normal->y, &point_a->y, &point_b->y, saturated);
  axis_of_points(it, a->z, b->z, w->z, normal->z, &point_a->z, &point_b->z, saturated);
}

#else

// What the low parts of the weights of v - u and w - u add, Q31. In line it costs 0.9 % of a distance query.
GJK_OUT_OF_LINE static int64_t fine_part(const feature *f, int32_t v, int32_t w) {
  // |v|, |w| <= 2^30, weights < 2^16:  at most 2^31
  return gjk_sar64(gjk_mac32(gjk_mul32(v, f->weight[0].low), w, f->weight[1].low), 16);
}

// One coordinate of the nearest point, Q31, and half an LSB:
//   u + (weight of v) (v - u) + (weight of w) (w - u).
GJK_ONCE static int64_t weighted(const feature *f, int32_t u, int32_t v, int32_t w) {
  //@ assert u >= -(INT32_C(1) << 29) && u <= INT32_C(1) << 29;
  //@ assert v >= -(INT32_C(1) << 29) && v <= INT32_C(1) << 29;
  //@ assert w >= -(INT32_C(1) << 29) && w <= INT32_C(1) << 29;
  v -= u;
  w -= u;
  const int64_t start = gjk_shl64(2 * u + 1, 30);  // |u| <= 2^29:  at most 2^60 + 2^30
  //@ assert start >= -(INT64_C(1) << 61) && start <= INT64_C(1) << 61;
  // |v - u|, |w - u| <= 2^30, weights < 2^31:  partial sums below 5 2^60 + 2^30
  const int64_t sum = gjk_mac32(gjk_mac32(start, v, f->weight[0].high), w, f->weight[1].high);
  return (f->weight[0].low | f->weight[1].low) != 0 ? sum + fine_part(f, v, w) : sum;
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
  const gjk_vertex *const corner[3] = {f->u, f->v, f->w};
  const gjk_vec3 unit = {normal->x, normal->y, normal->z};
  gjk_q16 on_a[3], on_b[3];
  for (unsigned axis = 0; axis < 3; axis++) {
    int32_t a[3], w[3];
    for (unsigned i = 0; i < 3; i++) {
      a[i] = gjk_component(&corner[i]->a.offset, axis);
      w[i] = gjk_component(&corner[i]->w, axis);
    }
    report_axis(it, f, gjk_component(&it->a->centre, axis), gjk_component(&it->b->centre, axis), a, w,
                gjk_component(&unit, axis), &on_a[axis], &on_b[axis], saturated);
  }
  point_a->x = on_a[0];
  point_a->y = on_a[1];
  point_a->z = on_a[2];
  point_b->x = on_b[0];
  point_b->y = on_b[1];
  point_b->z = on_b[2];
}

#endif

// What all coordinates of both points share in a frame of FINE_SHIFT or more.
typedef struct witness_move {
  int32_t v, w;                // the weights of v and w, Q31
  int32_t radius_a, radius_b;  // 2 convex_radius of A, -2 convex_radius of B
  unsigned shift;              // of the frame
} witness_move;

// start + radius normal, floored from Q31. Pre: the result fits.
#if GJK_NARROW_MULTIPLY
GJK_OUT_OF_LINE
#else
GJK_ONCE
#endif
static int32_t along_normal(int64_t start, gjk_q30 normal, int32_t radius) {
  if (GJK_NARROW_MULTIPLY && radius == 0) {
    return (int32_t)gjk_sar64(start, 31);
  }
  return (int32_t)gjk_sar64(gjk_mac32(start, normal, radius), 31);
}

// One coordinate of both points, as report_axis, of a feature of count vertices. a0, a1, a2: of the vertices u, v, w of A; w0,
// w1, w2: of their differences, all multiples of 2^shift. With w0 / 2^shift = centre_a + a0 - centre_b - b0 and so on, and o
// for A's core point, Q31, from A's centre, B's core point from B's centre is
//   o + (centre_a - centre_b - w0 / 2^shift) + (weight of v) (w0 - w1) / 2^shift + (weight of w) (w0 - w2) / 2^shift.
// So B's point takes centre_a as well: no coordinate of B's vertices is needed. Pre: |centre_a| <= 2^30.
//   |a| < 2^28 + 2^16, |w| / 2^shift < 2^26 since the reach is below 2^30; weights < 2^31 each
//   partial sums:   A's core point within 2^59 + 2^47, 5 times that on the way; 2^59 for the differences and for the radius
//   results:        at most 2^30 + 2^28 + 2^28 + 2^27
GJK_ONCE static void report_coarse_axis(const witness_move *m, unsigned count, gjk_q16 centre_a, int32_t a0, int32_t a1,
                                        int32_t a2, int32_t w0, int32_t w1, int32_t w2, gjk_q30 normal,
                                        gjk_q16 *point_a, gjk_q16 *point_b) {
  int64_t core = gjk_int64((uint64_t)a0 << 31 | UINT64_C(1) << 30);  // and half an LSB
  int64_t of_b = core;
  if (count > 1) {
    core = of_b = gjk_mac32(core, a1 - a0, m->v);
    if (count > 2) {
      core = of_b = gjk_mac32(core, a2 - a0, m->w);
      of_b = gjk_mac32(of_b, gjk_sar32(w0 - w2, m->shift), m->w);
    }
    of_b = gjk_mac32(of_b, gjk_sar32(w0 - w1, m->shift), m->v);
  }
  *point_a = centre_a + along_normal(core, normal, m->radius_a);
  *point_b = centre_a - gjk_sar32(w0, m->shift) + along_normal(of_b, normal, m->radius_b);
}

// The same as nearest_points. Pre: is_coarse. In line, for the count of the feature.
GJK_ONCE static void coarse_points(const gjk_iteration *it, unsigned count, const feature *f, const gjk_unit3 *normal,
                                   gjk_vec3 *point_a, gjk_vec3 *point_b) {
  const gjk_vertex *u = f->u, *v = f->v, *w = f->w;
  const gjk_vec3 *centre = &it->a->centre;
  const witness_move m = {f->weight[0].high, f->weight[1].high, 2 * it->a->shape->convex_radius,
                          -2 * it->b->shape->convex_radius, (unsigned)it->shift};
  report_coarse_axis(&m, count, centre->x, u->a.offset.x, v->a.offset.x, w->a.offset.x, u->w.x, v->w.x, w->w.x,
                     normal->x, &point_a->x, &point_b->x);
  report_coarse_axis(&m, count, centre->y, u->a.offset.y, v->a.offset.y, w->a.offset.y, u->w.y, v->w.y, w->w.y,
                     normal->y, &point_a->y, &point_b->y);
  report_coarse_axis(&m, count, centre->z, u->a.offset.z, v->a.offset.z, w->a.offset.z, u->w.z, v->w.z, w->w.z,
                     normal->z, &point_a->z, &point_b->z);
}

// Have the weights no low parts, and does every coordinate fit Q16.16? A is at most 2^30 LSB from the world's origin
// along each axis, and B's points are within 2^27 + 2^28 + 2^28 of its centre.
static inline bool is_coarse(const gjk_iteration *it) {
  const gjk_vec3 *c = &it->a->centre;
  // not reached: GJK_SMALL is a constant. Points leave the offsets of vertices unset.
  return !GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_ROUND && it->shift >= FINE_SHIFT &&
         ((uint32_t)(c->x ^ gjk_sar32(c->x, 31)) | (uint32_t)(c->y ^ gjk_sar32(c->y, 31)) |
          (uint32_t)(c->z ^ gjk_sar32(c->z, 31))) >>
                 30 ==
             0;
}

// The number of a difference: A's number in the high half, B's in the low half.
static inline uint32_t number_of(const gjk_vertex *v) {
  return (uint32_t)v->a.vertex << 16 | v->b;
}

// From the bits in which two numbers differ: in those of one shape alone?
static inline bool is_side(uint32_t differ) {
  return (differ & 0xFFFFu) == 0 || differ >> 16 == 0;
}

static inline bool has_more_bits(uint32_t x) {
  return (x & (x - 1)) != 0;
}

// Step 1: where to begin, by the numbers of a triangle's vertices. Half of a parallelogram begins across from the diagonal:
//   of two edges    the ends of the diagonal differ in both shapes
//   of a box face   they differ by two half axes
// Any other triangle begins at the lowest number. In each case the choice does not depend on the order.
static inline unsigned first_corner(const gjk_iteration *it, const uint32_t n[3]) {
  const uint32_t differ = n[0] ^ n[1], differ2 = n[1] ^ n[2], all = differ | differ2;
  if (!is_side(all)) {
    return !is_side(differ) ? 2 : !is_side(differ2) ? 0 : 1;
  }
  if (GJK_SHAPES <= GJK_SHAPES_BOXES || (all >> 16 != 0 ? it->a : it->b)->shape->type->kind == GJK_KIND_AXES) {
    return has_more_bits(differ) ? 2 : has_more_bits(differ2) ? 0 : 1;
  }
  return n[0] < n[1] ? (n[0] < n[2] ? 0 : 2) : (n[1] < n[2] ? 1 : 2);
}

// Steps 1 and 2 of an edge.
static inline void describe_edge(const gjk_iteration *it, feature *f) {
  const gjk_simplex *s = &it->simplex;
  f->u = f->w = &s->slot[s->order[0]];
  f->v = &s->slot[s->order[1]];
#if GJK_SMALL
  gjk_u128 part[3];
  gjk_simplex_parts(s, part);
  gjk_portions(&part[2], &part[0], &part[1], number_of(f->v) < number_of(f->u) ? 2 : 0, it->shift < FINE_SHIFT,
               f->weight);
#else
  const unsigned u = s->order[0], v = s->order[1];
  gjk_portion((uint64_t)s->toward[v][u], (uint64_t)s->toward[u][v], number_of(f->v) < number_of(f->u),
              it->shift < FINE_SHIFT, &f->weight[1]);
#endif
  f->weight[0] = f->weight[1];
}

// Steps 1 and 2 of a triangle.
static inline void describe_triangle(const gjk_iteration *it, feature *f) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *const v[3] = {&s->slot[s->order[0]], &s->slot[s->order[1]], &s->slot[s->order[2]]};
  uint32_t n[3];
  n[0] = number_of(v[0]);
  n[1] = number_of(v[1]);
  n[2] = number_of(v[2]);
  const unsigned i = first_corner(it, n), j = gjk_next(i), k = gjk_next(j);
  gjk_u128 part[3];
  f->u = v[i];
  f->v = v[j];
  f->w = v[k];
  gjk_simplex_parts(s, part);
  gjk_portions(&part[i], &part[j], &part[k], (n[j] < n[i] ? 1u : 0u) | (n[k] < n[i] ? 2u : 0u), it->shift < FINE_SHIFT,
               f->weight);
}

void gjk_witness_points(const gjk_iteration *it, const gjk_unit3 *normal, gjk_vec3 *point_a, gjk_vec3 *point_b,
                        bool *saturated) {
  const gjk_simplex *s = &it->simplex;
  feature f;
  //@ assert s->count >= 1 && s->count <= 3;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 3) {
    describe_triangle(it, &f);
  } else if (GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 2) {
    describe_edge(it, &f);
  } else {
    f.u = f.v = f.w = &s->slot[s->order[0]];
    f.weight[0].high = f.weight[0].low = f.weight[1].high = f.weight[1].low = 0;
  }
  if (!is_coarse(it)) {
    nearest_points(it, &f, normal, point_a, point_b, saturated);
  } else if (s->count == 3) {
    coarse_points(it, 3, &f, normal, point_a, point_b);
  } else if (s->count == 2) {
    coarse_points(it, 2, &f, normal, point_a, point_b);
  } else {
    coarse_points(it, 1, &f, normal, point_a, point_b);
  }
}
