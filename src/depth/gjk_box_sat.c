// Depth of boxes and segments in each other, from the directions across every two half axes.
//
// A - B holds the points delta + sum of s_i g_i with |s_i| <= 1, where delta leads from B's centre to A's and g_i are
// the half axes of both. Across n = g_i x g_j its facet is at |n . g_k| summed over the others, plus n . delta.
// After   the separating axes of Gottschalk, Lin, Manocha, OBBTree, 1996. Departures: half axes need not be at right
//         angles, as posing leaves them; exact signs; the nearest point of the facet as well.
#include "gjk_box_sat.h"

// Three half axes of each.
#define AXES 6
#define DIRECTIONS 15

typedef struct zonotope {
  gjk_iteration *it;
  gjk_vec3 axis[AXES];  // in the frame
  gjk_vec3 delta;
  unsigned count, of_a;  // axes, the first of them A's
} zonotope;

bool gjk_is_zonotope(const gjk_iteration *it) {
  return it->a->shape->type->kind == GJK_KIND_AXES && it->b->shape->type->kind == GJK_KIND_AXES;
}

static gjk_vec3 in_frame(const gjk_vec3 *v, int shift) {
  const gjk_vec3 scaled = {gjk_shl32(v->x, (unsigned)shift), gjk_shl32(v->y, (unsigned)shift),
                           gjk_shl32(v->z, (unsigned)shift)};
  //@ assert scaled.x >= -(INT32_C(1) << 30) && scaled.x <= INT32_C(1) << 30;
  //@ assert scaled.y >= -(INT32_C(1) << 30) && scaled.y <= INT32_C(1) << 30;
  //@ assert scaled.z >= -(INT32_C(1) << 30) && scaled.z <= INT32_C(1) << 30;
  return scaled;
}

static void open(zonotope *z, gjk_iteration *it) {
  z->it = it;
  z->of_a = it->a->count;
  z->count = z->of_a + it->b->count;
  for (unsigned i = 0; i < z->count; i++) {
    z->axis[i] = in_frame(i < z->of_a ? &it->a->frame[i] : &it->b->frame[i - z->of_a], it->shift);
  }
  z->delta = it->delta;
}

// A vertex of A - B by the signs of the axes: bit k is set for plus.
static void place_patch(const zonotope *z, unsigned signs, gjk_vertex *out) {
  const unsigned mask_a = (1u << z->of_a) - 1, mask_b = (1u << (z->count - z->of_a)) - 1;
  gjk_vec3 w = z->delta;
  for (unsigned k = 0; k < z->count; k++) {
    w = (signs >> k & 1u) != 0 ? gjk_add(w, z->axis[k]) : gjk_sub(w, z->axis[k]);
  }
  //@ assert w.x >= -(INT32_C(3) << 29) && w.x <= INT32_C(3) << 29;
  //@ assert w.y >= -(INT32_C(3) << 29) && w.y <= INT32_C(3) << 29;
  //@ assert w.z >= -(INT32_C(3) << 29) && w.z <= INT32_C(3) << 29;
  out->w = w;
  out->a.vertex = (uint16_t)(signs & mask_a);
  out->b = (uint16_t)(~signs >> z->of_a & mask_b);
}

// Which way e turns to v, both in a facet, seen against its normal: -1, 0 or 1. Their product is a multiple of the
// normal, and so turned as the rounded one is.
static int turn(const gjk_vec3 *normal, const gjk_vec3 *e, const gjk_vec3 *v) {
  gjk_long3 product;
  gjk_cross(e, v, &product);
  return gjk_dot_sign(&product, normal);
}

// A triangle of a facet with the outward normal it->direction, on its way to the origin's projection.
typedef struct patch {
  const zonotope *z;
  unsigned level;     // the axes in the plane, bit k for axis k
  unsigned signs[3];  // of the corners, counterclockwise seen against n
} patch;

// Turns the triangle over its edge from corner i, onto the vertex of the facet that is farthest beyond it. False: there
// is none.
static bool turn_over(patch *p, unsigned i) {
  const gjk_simplex *s = &p->z->it->simplex;
  const unsigned j = gjk_next(i), start = p->signs[i], end = p->signs[j];
  const gjk_vec3 edge = gjk_sub(s->slot[j].w, s->slot[i].w);
  unsigned signs = start;
  bool beyond = false;
  for (unsigned k = 0; k < p->z->count; k++) {
    const unsigned bit = 1u << k;
    const int side = (p->level & bit) != 0 ? turn(&p->z->it->direction.d, &edge, &p->z->axis[k]) : 0;
    if (side != 0) {
      signs = side < 0 ? signs | bit : signs & ~bit;
      beyond = beyond || ((signs ^ start) & bit) != 0;
    }
  }
  if (beyond) {
    p->signs[0] = start;
    p->signs[1] = signs;
    p->signs[2] = end;
  }
  return beyond;
}

// Moves the triangle until it holds the origin's projection. False: the facet doesn't.
static bool find_projection(patch *p) {
  gjk_simplex *s = &p->z->it->simplex;
  // A facet has at most twice as many vertices as there are axes, and none is left behind twice.
  for (int round = 0; round < 2 * AXES; round++) {  // not reached: the ceiling
    for (int i = 0; i < 3; i++) {
      place_patch(p->z, p->signs[i], &s->slot[i]);
    }
    gjk_simplex_set(s, 3);
    const unsigned edge = gjk_simplex_beyond(s);
    if (edge == 3) {
      return true;
    }
    if (!turn_over(p, edge)) {
      break;
    }
  }
  return false;
}

// Considers the nearer facet across axes i and j, if these are not parallel.
static gjk_zonotope_answer consider_axis(const zonotope *z, unsigned i, unsigned j, gjk_facet *facet) {
  gjk_long3 n;
  gjk_cross(&z->axis[i], &z->axis[j], &n);
  if ((n.x | n.y | n.z) == 0) {
    return GJK_ZONOTOPE_FACET;
  }
  const bool opposite = gjk_dot_sign(&n, &z->delta) > 0;
  const unsigned first = opposite ? j : i, second = opposite ? i : j;
  if (opposite) {
    n.x = -n.x;
    n.y = -n.y;
    n.z = -n.z;
  }
  patch p = {z, 1u << i | 1u << j, {0, 0, 0}};
  for (unsigned k = 0; k < z->count; k++) {
    const int side = k == i || k == j ? 0 : gjk_dot_sign(&n, &z->axis[k]);
    p.signs[0] |= side > 0 ? 1u << k : 0;
    p.level |= side == 0 ? 1u << k : 0;
  }
  p.signs[1] = p.signs[0] | 1u << first;
  p.signs[2] = p.signs[0] | 1u << second;
  if (p.level + 1 == 1u << z->count) {
    return GJK_ZONOTOPE_FLAT;
  }
  gjk_search_direction_of(&n, &z->it->direction);
  const bool covers = find_projection(&p);
  if (gjk_dot_sign(&n, &z->it->simplex.slot[0].w) < 0) {
    return GJK_ZONOTOPE_APART;
  }
  gjk_facet_consider(facet, z->it, covers, -1);
  return GJK_ZONOTOPE_FACET;
}

// The directions across every two axes, with lower bounds of the ranks of their facets.
typedef struct directions {
  uint32_t key[DIRECTIONS];
  uint8_t i[DIRECTIONS], j[DIRECTIONS];
  unsigned count;
} directions;

// Cut normals: components at most 2^30 in size and less than 1 below n / 2^shift, the same shift for all.
static gjk_vec3 cut_normal(const zonotope *z, unsigned i, unsigned j, unsigned shift) {
  gjk_long3 n;
  gjk_cross(&z->axis[i], &z->axis[j], &n);
  const gjk_long3 low = {gjk_sar64(n.x, shift), gjk_sar64(n.y, shift), gjk_sar64(n.z, shift)};
  //@ assert low.x >= -(INT32_C(1) << 30) && low.x <= INT32_C(1) << 30;
  //@ assert low.y >= -(INT32_C(1) << 30) && low.y <= INT32_C(1) << 30;
  //@ assert low.z >= -(INT32_C(1) << 30) && low.z <= INT32_C(1) << 30;
  const gjk_vec3 cut = {(int32_t)low.x, (int32_t)low.y, (int32_t)low.z};
  return cut;
}

static unsigned cut_shift(const zonotope *z) {
  uint32_t bits = 1;
  for (unsigned k = 0; k < z->count; k++) {
    bits |= gjk_magnitude32(z->axis[k].x) | gjk_magnitude32(z->axis[k].y) | gjk_magnitude32(z->axis[k].z);
  }
  const unsigned b = 32 - gjk_clz32(bits);  // components of n are below 2^(2 b + 1)
  return b > 14 ? 2 * b - 29 : 0;
}

// A sum of products with cut normals is off by less than 2^34: delta and the half axes are sqrt(3) 2^30 long together,
// so |x| + |y| + |z| adds up to at most 3 2^30 for delta and each of four half axes.
#define CUT_ERROR (INT64_C(1) << 34)

// Cut normals shorter than this say nothing about a height.
#define CUT_SHORTEST (INT64_C(1) << 16)

static int64_t size_along(const gjk_vec3 *n, const gjk_vec3 *v) {
  const int64_t along = gjk_dot(n, v);
  return along < 0 ? -along : along;
}

// The number of the pair i < j.
static unsigned pair_of(unsigned i, unsigned j) {
  static const uint8_t before[AXES] = {0, 4, 7, 9, 10, 10};  // less i + 1
  return before[i] + j - 1;
}

// False: one of the directions, it->direction, separates A from B. The height across i, j is the sum of
// |g_i x g_j . g_k| over all k, less |g_i x g_j . delta|; each triple serves three directions.
static bool rank_directions(const zonotope *z, directions *out) {
  int64_t sum[DIRECTIONS], squared[DIRECTIONS];
  const unsigned shift = cut_shift(z);
  sum[0] = 0;  // the others are set by the first triple that they are in: all at once would call memset
  for (unsigned i = 0; i < z->count; i++) {
    for (unsigned j = i + 1; j < z->count; j++) {
      const gjk_vec3 n = cut_normal(z, i, j, shift);
      const unsigned ij = pair_of(i, j);
      squared[ij] = gjk_dot(&n, &n);
      int64_t rest = sum[ij] - size_along(&n, &z->delta);
      for (unsigned k = j + 1; k < z->count; k++) {
        const int64_t volume = size_along(&n, &z->axis[k]);
        rest += volume;
        sum[pair_of(i, k)] = volume + (i == 0 && j == 1 ? 0 : sum[pair_of(i, k)]);
        sum[pair_of(j, k)] = volume + (i == 0 ? 0 : sum[pair_of(j, k)]);
      }
      sum[ij] = rest;
    }
  }
  out->count = 0;
  for (unsigned i = 0; i < z->count; i++) {
    for (unsigned j = i + 1; j < z->count; j++) {
      const unsigned ij = pair_of(i, j), n = out->count++;
      if (squared[ij] >= CUT_SHORTEST * CUT_SHORTEST && sum[ij] < -CUT_ERROR) {
        const gjk_vec3 normal = cut_normal(z, i, j, shift);
        z->it->direction.d = gjk_dot(&normal, &z->delta) > 0 ? gjk_negate(normal) : normal;
        return false;
      }
      out->key[n] = squared[ij] < CUT_SHORTEST * CUT_SHORTEST ? 0 : gjk_height_key(sum[ij] - CUT_ERROR, squared[ij]);
      out->i[n] = (uint8_t)i;
      out->j[n] = (uint8_t)j;
    }
  }
  return true;
}

gjk_zonotope_answer gjk_box_sat(gjk_iteration *it, gjk_facet *facet) {
  directions d;
  zonotope z;
  open(&z, it);
  if (!rank_directions(&z, &d)) {
    return GJK_ZONOTOPE_APART;
  }
  // If A - B does not hold the origin, one of its planes lies before it. Its key tells next to nothing of height, so
  // that it is considered before the search can end: that takes a plane whose facet holds the origin, or others that
  // are higher.
  while (d.count > 0) {  // at most DIRECTIONS times
    unsigned lowest = 0;
    for (unsigned k = 1; k < d.count; k++) {
      lowest = d.key[k] < d.key[lowest] ? k : lowest;
    }
    if (!gjk_facet_may_improve(facet, it->shift, d.key[lowest])) {
      break;
    }
    const gjk_zonotope_answer answer = consider_axis(&z, d.i[lowest], d.j[lowest], facet);
    if (answer != GJK_ZONOTOPE_FACET) {
      return answer;
    }
    d.count--;
    d.key[lowest] = d.key[d.count];
    d.i[lowest] = d.i[d.count];
    d.j[lowest] = d.j[d.count];
  }
  return facet->found ? GJK_ZONOTOPE_FACET : GJK_ZONOTOPE_FLAT;
}
