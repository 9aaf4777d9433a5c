// The nearest feature of points and segments, without a search.
//
// With the half axes a and b and the difference d of the centres, A - B is the parallelogram d + s a - t b with s and t
// from -1 to 1. Its squared distance from the origin is a convex function of s and t, so signs alone find the feature.
//
//   1. One of the half axes is empty: t = (b . d) / (b . b), or s = -(a . d) / (a . a), cut to its range.
//   2. Find on which sides of the ranges the nearest point of the whole plane lies. In both: it is the answer.
//   3. On each side where it lies beyond: the line there may have its nearest point within the range of the other; that
//      is the answer. Its derivative across the line is that of step 2, and points outwards.
//   4. Otherwise the answer is a corner. Where both sides offer one, the derivative at the first decides.
//
// Products, in the frame: |d| + |a| + |b| < 2^30, or |d| <= 2^30 and |a|, |b| <= 2^28. Each is below 2^60 in size.
#include "gjk_iteration.h"

typedef struct segment_products {
  int64_t aa, bb, ab, ad, bd;
} segment_products;

// Where is x in the range from -most to most? 0: strictly inside.
GJK_ONE_COPY static int range_end(int64_t x, int64_t most) {
  return x >= most ? 1 : x <= -most ? -1 : 0;
}

// Step 2: where is s in its range? s (aa bb - ab^2) = ab bd - bb ad, compared with both ends. 0: strictly inside.
// Pre: aa bb > ab^2. For t exchange aa and bb, and give -bd for ad and -ad for bd. Rarely asked.
GJK_OUT_OF_LINE static int side_exactly(const segment_products *m, bool of_t) {
  const int64_t aa = of_t ? m->bb : m->aa, bb = of_t ? m->aa : m->bb, ab = m->ab;
  const int64_t ad = of_t ? -m->bd : m->ad, bd = of_t ? -m->ad : m->bd;
  // Sums below 2^61.
  if (gjk_sum_of_products_sign(ab, bd + ab, -bb, ad + aa) >= 0) {
    return 1;
  }
  return gjk_sum_of_products_sign(ab, bd - ab, -bb, ad - aa) <= 0 ? -1 : 0;
}

// The same by high words. A difference of products p q - r s of 2^60 is that of the products of high words and 2^64, but for
//   |ph| + |qh| + |rh| + |sh| + 2 <= 2^30 + 2
// So what is compared, the sum or difference of two such, is off by less than 2^32.
//   rough   aa bb - ab^2; place: s or t times that
static inline int side_of(const segment_products *m, int64_t place, int64_t rough, bool of_t) {
  const int32_t above = gjk_high32(place - rough), below = gjk_high32(place + rough);
  if (above >= 1) {
    return 1;
  }
  if (below < -1) {
    return -1;
  }
  return above < -1 && below >= 1 ? 0 : side_exactly(m, of_t);
}

// Steps 3 and 4. *s and *t are the sides of step 2, not both 0.
static void find_border(const segment_products *m, int *s, int *t) {
  int of_t = 0, of_s = 0;
  if (*s != 0) {
    of_t = range_end(m->bd + *s * m->ab, m->bb);
    if (of_t == 0 || *t == 0) {
      *t = of_t;
      return;
    }
  }
  of_s = range_end(*t * m->ab - m->ad, m->aa);
  // At the corner (*s, of_t) the derivative points outwards: the sum is below 2^62.
  if (*s != 0 && of_s != 0 && *s * (m->ad + *s * m->aa - of_t * m->ab) <= 0) {
    *t = of_t;
    return;
  }
  *s = of_s;
}

// Steps 1 to 4: -1 or 1 is an end of the range, 0 its inside. False: the half axes are parallel.
static bool closest_sides(const segment_products *m, int *s, int *t) {
  *s = *t = 1;
  if (m->aa == 0) {
    *t = range_end(m->bd, m->bb);
    return true;
  }
  if (m->bb == 0) {
    *s = range_end(-m->ad, m->aa);
    return true;
  }
  const int32_t aa = gjk_high32(m->aa), bb = gjk_high32(m->bb), ab = gjk_high32(m->ab), ad = gjk_high32(m->ad),
                bd = gjk_high32(m->bd);
  const int64_t rough = gjk_mac32(gjk_mul32(aa, bb), -ab, ab);  // below 2^57, as the next two
  if (gjk_high32(rough) < 1 && gjk_sum_of_products_sign(m->aa, m->bb, -m->ab, m->ab) <= 0) {
    return false;
  }
  if (GJK_SMALL) {
    *s = side_exactly(m, false);
    *t = side_exactly(m, true);
  } else {
    *s = side_of(m, gjk_mac32(gjk_mul32(ab, bd), -bb, ad), rough, false);
    *t = side_of(m, gjk_mac32(gjk_mul32(aa, bd), -ab, ad), rough, true);
  }
  if (*s != 0 || *t != 0) {
    find_border(m, s, t);
  }
  return true;
}

// The half axis in the frame; a point has none.
static inline gjk_vec3 half_axis(const gjk_iteration *it, const gjk_collider *c) {
  const unsigned shift = (unsigned)it->shift;
  gjk_vec3 axis = {0, 0, 0};
  if (c->count > 0) {
    axis.x = gjk_shl32(c->frame[0].x, shift);
    axis.y = gjk_shl32(c->frame[0].y, shift);
    axis.z = gjk_shl32(c->frame[0].z, shift);
  }
  return axis;
}

// Puts the corner at the ends s and t into slot i, the last one. a, b: the half axes, multiples of 2^shift.
GJK_ONCE static void place_corner(gjk_iteration *it, unsigned i, const gjk_vec3 *a, const gjk_vec3 *b, int s, int t) {
  const uint16_t of_a = it->a->count > 0 && s > 0 ? 1 : 0, of_b = it->b->count > 0 && t > 0 ? 1 : 0;
  if (GJK_SMALL) {
    gjk_iteration_place(it, of_a, of_b);
  } else {
    const unsigned shift = (unsigned)it->shift;
    gjk_vertex *v = &it->simplex.slot[i];
    const gjk_vec3 end = {s * a->x, s * a->y, s * a->z};
    v->a.offset.x = gjk_sar32(end.x, shift);
    v->a.offset.y = gjk_sar32(end.y, shift);
    v->a.offset.z = gjk_sar32(end.z, shift);
    v->a.vertex = of_a;
    v->b = of_b;
    v->w.x = it->delta.x + end.x - t * b->x;
    v->w.y = it->delta.y + end.y - t * b->y;
    v->w.z = it->delta.z + end.z - t * b->z;
  }
  it->simplex.count = (uint8_t)(i + 1);
}

// Makes the feature the corners, and sets the direction. False: the nearest point lies on a triangle's border, or it is the
// origin.
static bool take_corners(gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  return gjk_simplex_set(s, s->count) && (s->count < 3 || gjk_dot_sign(&s->normal, &s->slot[0].w) != 0) &&
         gjk_simplex_direction(s, &it->direction);
}

// The same for one corner.
static bool set_lone_corner(gjk_iteration *it) {
  const gjk_vec3 *w = &it->simplex.slot[0].w;
  it->simplex.toward[0][0] = gjk_dot(w, w);
  it->direction.d = gjk_negate(*w);
  it->direction.exact = true;
  return (w->x | w->y | w->z) != 0;
}

// The same for the edge along a half axis h, from the corner v to w. square: h . h; along: h . m for the middle m = v + h =
// w - h. Below 2^60 and 2^61. The products of h with m + h and h - m are above 0, since m is cut inside the range.
static bool set_edge_along(gjk_iteration *it, int64_t square, int64_t along) {
  gjk_simplex *s = &it->simplex;
  const gjk_vec3 *v = &s->slot[0].w, *w = &s->slot[1].w;
  s->toward[0][0] = gjk_dot(v, v);
  s->toward[1][1] = gjk_dot(w, w);
  s->toward[0][1] = 2 * (square - along);
  s->toward[1][0] = 2 * (square + along);
  return gjk_search_direction_of_edge(v, s->toward[1][0], w, s->toward[0][1], &it->direction);
}

// The same for half of the parallelogram, beside the diagonal that the first two corners span.
static bool set_half(gjk_iteration *it, const segment_products *m, const gjk_vec3 *a, const gjk_vec3 *b) {
  // The sign of s + t: on which side of the diagonal.
  const int side = gjk_sum_of_products_sign(m->bd, m->aa + m->ab, -m->ad, m->bb + m->ab);
  if (side != 0) {
    place_corner(it, 2, a, b, side, side);
  }
  return side != 0 && take_corners(it);
}

// Makes the feature the corner, edge or half parallelogram, and sets the direction from it. False: there is none.
static bool set_closest(gjk_iteration *it, const segment_products *m, const gjk_vec3 *a, const gjk_vec3 *b, int s,
                        int t) {
  place_corner(it, 0, a, b, s != 0 ? s : t != 0 ? -1 : 1, t != 0 ? t : -1);
  if (s != 0 && t != 0) {
    return GJK_SMALL ? take_corners(it) : set_lone_corner(it);
  }
  place_corner(it, 1, a, b, s != 0 ? s : t != 0 ? 1 : -1, t != 0 ? t : 1);
  if (s == 0 && t == 0) {
    return set_half(it, m, a, b);
  }
  if (GJK_SMALL) {
    return take_corners(it);
  }
  return s != 0 ? set_edge_along(it, m->bb, -m->bd - s * m->ab) : set_edge_along(it, m->aa, m->ad - t * m->ab);
}

// Points alone: their one difference. False: it is the origin.
static bool close_points(gjk_iteration *it) {
  const gjk_vec3 zero = {0, 0, 0};
  gjk_vertex *v = &it->simplex.slot[0];
  v->a.offset = zero;
  v->a.vertex = 0;
  v->b = 0;
  v->w = it->delta;
  it->simplex.count = 1;
  return set_lone_corner(it);
}

// Points and segments.
static bool close_axes(gjk_iteration *it) {
  const gjk_vec3 a = half_axis(it, it->a), b = half_axis(it, it->b);
  const segment_products m = {gjk_dot(&a, &a), gjk_dot(&b, &b), gjk_dot(&a, &b), gjk_dot(&a, &it->delta),
                              gjk_dot(&b, &it->delta)};
  int s, t;
  return closest_sides(&m, &s, &t) && set_closest(it, &m, &a, &b, s, t);
}

bool gjk_close_segments(gjk_iteration *it) {
  gjk_simplex_clear(&it->simplex);
  if (!GJK_SMALL && it->a->count + it->b->count == 0 ? close_points(it) : close_axes(it)) {
    it->iterations = 1;
    it->ties[0] = it->ties[1] = 0;  // the half axes are not parallel: the nearest point is that of one feature
    return true;
  }
  gjk_simplex_clear(&it->simplex);
  return false;
}
