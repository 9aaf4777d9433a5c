// SAT of boxes: the depth of points, segments and boxes in each other, by separating directions.
//
// A - B is the set of the sums  delta + s_1 g_1 + ... + s_n g_n  with |s_k| <= 1, where delta = centre_a - centre_b and
// g_k are the half axes of A and B, at most six. Each facet is spanned by two half axes or more. So its normal is one
// of the at most 15
//   n = g_i x g_j,
// and the plane of the nearer one of the two facets across n is at the height
//   (sum of |n . g_k| over all k  -  |n . delta|) / |n|.
//
//   Step 1   For each n, rounded, compute a lower bound of the height, and its height key. Each triple product
//            g_i x g_j . g_k serves three of the n. A height is surely below 0: APART.
//   Step 2   Take the n with the lowest key. None is left, or the plane cannot be better than the candidate: step 7.
//   Step 3   The half axes are parallel: n = 0, on from step 2. All half axes lie in the plane: FLAT.
//   Step 4   Take a triangle in the facet: the sums whose s_k is the sign of n . g_k, but for those in the plane.
//   Step 5   Flip the triangle over the edge that the origin's projection lies beyond, until it holds the projection,
//            or the facet ends.
//   Step 6   The origin lies strictly beyond the plane: APART. Otherwise offer the triangle; on from step 2.
//   Step 7   The candidate is the nearest facet: FACET. Without any: FLAT.
//
// After   the separating axes of Gottschalk, Lin, Manocha, OBBTree, 1996. Departures: half axes need not be at right
//         angles, since posing rounds them; exact signs; the nearest point of the facet as well.
#include "gjk_box_sat.h"

// Three half axes of each.
#define AXES 6
#define DIRECTIONS 15

// Two boxes, segments or points, in the frame of the pair.
typedef struct box_pair {
  gjk_iteration *it;
  gjk_vec3 axis[AXES];  // half axes: first those of A, then those of B
  gjk_vec3 delta;
  unsigned count, of_a;  // of half axes, and how many of them are A's
} box_pair;

bool gjk_is_box_pair(const gjk_iteration *it) {
  return it->a->shape->type->kind == GJK_KIND_AXES && it->b->shape->type->kind == GJK_KIND_AXES;
}

// A half axis in the frame.
static gjk_vec3 in_frame(const gjk_vec3 *v, int shift) {
  const gjk_vec3 scaled = {gjk_shl32(v->x, (unsigned)shift), gjk_shl32(v->y, (unsigned)shift),
                           gjk_shl32(v->z, (unsigned)shift)};
  //@ assert scaled.x >= -(INT32_C(1) << 30) && scaled.x <= INT32_C(1) << 30;
  //@ assert scaled.y >= -(INT32_C(1) << 30) && scaled.y <= INT32_C(1) << 30;
  //@ assert scaled.z >= -(INT32_C(1) << 30) && scaled.z <= INT32_C(1) << 30;
  return scaled;
}

static void set_box_pair(box_pair *pair, gjk_iteration *it) {
  pair->it = it;
  pair->of_a = it->a->count;
  pair->count = pair->of_a + it->b->count;
  for (unsigned i = 0; i < pair->count; i++) {
    pair->axis[i] = in_frame(i < pair->of_a ? &it->a->frame[i] : &it->b->frame[i - pair->of_a], it->shift);
  }
  pair->delta = it->delta;
}

// The vertex of A - B whose s_k are signs. Bit k is set: s_k = 1; otherwise -1.
static void vertex_of_signs(const box_pair *pair, unsigned signs, gjk_vertex *out) {
  const unsigned mask_a = (1u << pair->of_a) - 1, mask_b = (1u << (pair->count - pair->of_a)) - 1;
  gjk_vec3 w = pair->delta;
  for (unsigned k = 0; k < pair->count; k++) {
#if GJK_CONDITIONAL_MOVES
    const int32_t minus = (int32_t)(signs >> k & 1u) - 1;  // -1 where it is subtracted
    w.x += (pair->axis[k].x ^ minus) - minus;
    w.y += (pair->axis[k].y ^ minus) - minus;
    w.z += (pair->axis[k].z ^ minus) - minus;
#else
    w = (signs >> k & 1u) != 0 ? gjk_add(w, pair->axis[k]) : gjk_sub(w, pair->axis[k]);
#endif
  }
  //@ assert w.x >= -(INT32_C(3) << 29) && w.x <= INT32_C(3) << 29;
  //@ assert w.y >= -(INT32_C(3) << 29) && w.y <= INT32_C(3) << 29;
  //@ assert w.z >= -(INT32_C(3) << 29) && w.z <= INT32_C(3) << 29;
  out->w = w;
  out->a.vertex = (uint16_t)(signs & mask_a);
  out->b = (uint16_t)(~signs >> pair->of_a & mask_b);
}

// On which side of the edge e does v point, both in a facet seen against its normal? 1: left, 0: along e, -1: right.
// The rounded normal suffices, since e x v is 0 or parallel to the exact one.
static int side_of_edge(const gjk_vec3 *normal, const gjk_vec3 *e, const gjk_vec3 *v) {
  gjk_long3 product;
  gjk_cross(e, v, &product);
  return gjk_dot_sign(&product, normal);
}

// A triangle of vertices of the facet with the outward normal it->direction, on its way to the origin's projection.
typedef struct facet_triangle {
  const box_pair *pair;
  unsigned in_plane;  // bit k: half axis k lies in the plane
  unsigned signs[3];  // the corners as of vertex_of_signs, counterclockwise seen against the normal
} facet_triangle;

// Replaces the corner opposite to the edge from corner i by the vertex of the facet farthest beyond that edge. False:
// no vertex lies beyond.
static bool flip_over_edge(facet_triangle *t, unsigned i) {
  const gjk_simplex *s = &t->pair->it->simplex;
  const unsigned j = gjk_next(i), start = t->signs[i], end = t->signs[j];
  const gjk_vec3 edge = gjk_sub(s->slot[j].w, s->slot[i].w);
  unsigned signs = start;
  bool beyond = false;
  for (unsigned k = 0; k < t->pair->count; k++) {
    const unsigned bit = 1u << k;
    const int side = (t->in_plane & bit) != 0 ? side_of_edge(&t->pair->it->direction.d, &edge, &t->pair->axis[k]) : 0;
    if (side != 0) {
      signs = side < 0 ? signs | bit : signs & ~bit;
      beyond = beyond || ((signs ^ start) & bit) != 0;
    }
  }
  if (beyond) {
    t->signs[0] = start;
    t->signs[1] = signs;
    t->signs[2] = end;
  }
  return beyond;
}

// Step 5. Returns whether the triangle holds the origin's projection.
static bool reach_projection(facet_triangle *t) {
  gjk_simplex *s = &t->pair->it->simplex;
  // A facet has at most 2 AXES vertices, and no vertex is left behind twice.
  for (int flips = 0; flips < 2 * AXES; flips++) {  // not reached: the ceiling
    for (int i = 0; i < 3; i++) {
      vertex_of_signs(t->pair, t->signs[i], &s->slot[i]);
    }
    const unsigned edge = gjk_simplex_set(s, 3) ? 3 : gjk_simplex_beyond(s);
    if (edge == 3) {
      return true;
    }
    if (!flip_over_edge(t, edge)) {
      break;
    }
  }
  return false;
}

// Steps 3 to 6 for half axes i and j. FACET: on from step 2.
static gjk_box_sat_answer test_direction(const box_pair *pair, unsigned i, unsigned j, gjk_facet *facet) {
  // Step 3: the normal of the plane across both half axes.
  gjk_long3 n;
  gjk_cross(&pair->axis[i], &pair->axis[j], &n);
  if ((n.x | n.y | n.z) == 0) {
    return GJK_BOX_SAT_FACET;
  }
  // The nearer facet is on the side opposite to delta.
  const bool opposite = gjk_dot_sign(&n, &pair->delta) > 0;
  const unsigned first = opposite ? j : i, second = opposite ? i : j;
  if (opposite) {
    n.x = -n.x;
    n.y = -n.y;
    n.z = -n.z;
  }
  // Step 4: a triangle in the facet.
  facet_triangle t = {pair, 1u << i | 1u << j, {0, 0, 0}};
  for (unsigned k = 0; k < pair->count; k++) {
    const int side = k == i || k == j ? 0 : gjk_dot_sign(&n, &pair->axis[k]);
    t.signs[0] |= side > 0 ? 1u << k : 0;
    t.in_plane |= side == 0 ? 1u << k : 0;
  }
  t.signs[1] = t.signs[0] | 1u << first;
  t.signs[2] = t.signs[0] | 1u << second;
  if (t.in_plane + 1 == 1u << pair->count) {
    return GJK_BOX_SAT_FLAT;
  }
  // Step 5: towards the projection. Step 6: a candidate.
  gjk_search_direction_of(&n, &pair->it->direction);
  const bool covers = reach_projection(&t);
  if (gjk_dot_sign(&n, &pair->it->simplex.slot[0].w) < 0) {
    return GJK_BOX_SAT_APART;
  }
  gjk_facet_consider(facet, pair->it, covers, -1);
  return GJK_BOX_SAT_FACET;
}

// The directions g_i x g_j, i < j, that are left, with lower bounds of the height keys.
typedef struct separating_directions {
  uint32_t key[DIRECTIONS];
  uint8_t i[DIRECTIONS], j[DIRECTIONS];
  unsigned count;
} separating_directions;

// g_i x g_j / 2^shift, rounded down: each component off by less than 1.
static gjk_vec3 truncated_normal(const box_pair *pair, unsigned i, unsigned j, unsigned shift) {
  gjk_long3 n;
  gjk_cross(&pair->axis[i], &pair->axis[j], &n);
  const gjk_long3 low = {gjk_sar64(n.x, shift), gjk_sar64(n.y, shift), gjk_sar64(n.z, shift)};
  //@ assert low.x >= -(INT32_C(1) << 30) && low.x <= INT32_C(1) << 30;
  //@ assert low.y >= -(INT32_C(1) << 30) && low.y <= INT32_C(1) << 30;
  //@ assert low.z >= -(INT32_C(1) << 30) && low.z <= INT32_C(1) << 30;
  const gjk_vec3 truncated = {(int32_t)low.x, (int32_t)low.y, (int32_t)low.z};
  return truncated;
}

// The shift that leaves the components of every g_i x g_j at most 2^30 in size.
static unsigned truncation_of(const box_pair *pair) {
  uint32_t bits = 1;
  for (unsigned k = 0; k < pair->count; k++) {
    bits |= gjk_magnitude32(pair->axis[k].x) | gjk_magnitude32(pair->axis[k].y) | gjk_magnitude32(pair->axis[k].z);
  }
  const unsigned b = 32 - gjk_clz32(bits);  // |g_k| components < 2^b, of n < 2^(2 b + 1)
  return b > 14 ? 2 * b - 29 : 0;
}

// How far rounding the normal may move the sum of step 1:
//   |x| + |y| + |z| of delta and of each of four half axes   <= 3 2^30
//   all five together                                         < 2^34
#define SUM_ERROR (INT64_C(1) << 34)

// The height by a rounded normal shorter than this says nothing; its bound is 0.
#define SHORTEST_NORMAL (INT64_C(1) << 16)

// |n . v|
static int64_t size_along(const gjk_vec3 *n, const gjk_vec3 *v) {
  const int64_t along = gjk_dot(n, v);
  return along < 0 ? -along : along;
}

// The pairs i < j counted from 0: (0, 1), (0, 2) ... (4, 5).
static unsigned direction_number(unsigned i, unsigned j) {
  static const uint8_t before[AXES] = {0, 4, 7, 9, 10, 10};  // pairs before (i, i + 1), less i
  return before[i] + j - 1;
}

// Step 1. False: it->direction separates A from B.
// Any sum of |n . g_k| and |n . delta| is at most |n . w| for a vertex w of A - B, up to the sign of delta:
//   |n| <= sqrt(3) 2^30,  |w| <= 3 2^29:  |n . w| < 2^62
static bool key_directions(const box_pair *pair, separating_directions *out) {
  int64_t sum[DIRECTIONS], squared[DIRECTIONS];
  const unsigned shift = truncation_of(pair);
  // The first triple product of a sum sets it. GCC would turn a loop that sets all to 0 into a call of memset.
  sum[0] = 0;
  for (unsigned i = 0; i < pair->count; i++) {
    for (unsigned j = i + 1; j < pair->count; j++) {
      const gjk_vec3 n = truncated_normal(pair, i, j, shift);
      const unsigned ij = direction_number(i, j);
      squared[ij] = gjk_dot(&n, &n);
      int64_t rest = sum[ij] - size_along(&n, &pair->delta);
      for (unsigned k = j + 1; k < pair->count; k++) {
        const int64_t volume = size_along(&n, &pair->axis[k]);
        rest += volume;
        sum[direction_number(i, k)] = volume + (i == 0 && j == 1 ? 0 : sum[direction_number(i, k)]);
        sum[direction_number(j, k)] = volume + (i == 0 ? 0 : sum[direction_number(j, k)]);
      }
      sum[ij] = rest;
    }
  }
  out->count = 0;
  for (unsigned i = 0; i < pair->count; i++) {
    for (unsigned j = i + 1; j < pair->count; j++) {
      const unsigned ij = direction_number(i, j), n = out->count++;
      if (squared[ij] >= SHORTEST_NORMAL * SHORTEST_NORMAL && sum[ij] < -SUM_ERROR) {
        const gjk_vec3 normal = truncated_normal(pair, i, j, shift);
        pair->it->direction.d = gjk_dot(&normal, &pair->delta) > 0 ? gjk_negate(normal) : normal;
        return false;
      }
      out->key[n] =
          squared[ij] < SHORTEST_NORMAL * SHORTEST_NORMAL ? 0 : gjk_height_key(sum[ij] - SUM_ERROR, squared[ij]);
      out->i[n] = (uint8_t)i;
      out->j[n] = (uint8_t)j;
    }
  }
  return true;
}

gjk_box_sat_answer gjk_box_sat(gjk_iteration *it, gjk_facet *facet) {
  separating_directions d;
  box_pair pair;
  set_box_pair(&pair, it);
  if (!key_directions(&pair, &d)) {
    return GJK_BOX_SAT_APART;
  }
  // If the origin lies outside A - B, it lies beyond a plane, whose lower bound is below 0 and whose key is 0. Step 2
  // cannot end the search before that plane: only a facet that the origin lies on could.
  while (d.count > 0) {  // at most DIRECTIONS times
    // Step 2: the lowest key.
    unsigned lowest = 0;
    for (unsigned k = 1; k < d.count; k++) {
      lowest = d.key[k] < d.key[lowest] ? k : lowest;
    }
    if (!gjk_facet_may_improve(facet, it->shift, d.key[lowest])) {
      break;
    }
    const gjk_box_sat_answer answer = test_direction(&pair, d.i[lowest], d.j[lowest], facet);
    if (answer != GJK_BOX_SAT_FACET) {
      return answer;
    }
    d.count--;
    d.key[lowest] = d.key[d.count];
    d.i[lowest] = d.i[d.count];
    d.j[lowest] = d.j[d.count];
  }
  // Step 7: the best candidate.
  return facet->found ? GJK_BOX_SAT_FACET : GJK_BOX_SAT_FLAT;
}
