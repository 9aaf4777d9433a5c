// SAT of boxes: the depth of points, segments and boxes in each other, by separating directions.
//
// A - B is the set of the sums  delta + s_1 g_1 + ... + s_n g_n  with |s_k| <= 1, where delta = centre_a - centre_b and
// g_k are the half axes of A and B, at most six. Each facet is spanned by two half axes or more. So its normal is one
// of the at most 15
//   n = g_i x g_j,
// and the plane of the nearer one of the two facets across n is at the height
//   (sum of |n . g_k| over all k  -  |n . delta|) / |n|.
//
//   Step 1   Find bounds of all heights (gjk_box_heights.h). If a height is surely below 0: APART.
//   Step 2   In any order: bound each plane's height more closely, unless it exceeds a bound of another plane's height.
//            First scale up the normals of nearly parallel half axes.
//   Step 3   Take the planes that may be the lowest, in the order of their numbers. Leave out a plane whose half axes
//            are parallel, n = 0.
//   Step 4   Compare with the lowest so far: by heights along unit normals, and exactly where these cannot tell. If
//            both half axes of the lowest so far lie in a plane, it is the same plane. The first of equals stays. So
//            the plane is the least by height and number, a function of the pair.
//   Step 5   If all half axes lie in the plane: FLAT. Take a triangle in the facet: the sums whose s_k is the sign of
//            n . g_k, except for those in the plane.
//   Step 6   Flip the triangle over the edge that the origin's projection lies beyond, until it holds the projection,
//            which the nearest facet of all does.
//   Step 7   If the origin lies strictly beyond the plane: APART. Otherwise this is the nearest facet: FACET.
//
// Steps 1 and 2 are for speed alone, and a build for size leaves them out.
//
// After   the separating axes of Gottschalk, Lin, Manocha, OBBTree, 1996. Departures: half axes need not be at right
//         angles, since posing rounds them; exact signs; the nearest point of the facet as well.
#include "gjk_box_sat.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_unit.h"
#include "gjk_box_heights.h"

#define AXES GJK_BOX_AXES

// The planes below this number are across faces.
#define FACES 6

// Two boxes, segments or points, in the frame of the pair.
typedef struct box_pair {
  gjk_iteration *it;
  gjk_vec3 axis[AXES];  // half axes by slots
  gjk_vec3 delta;
  unsigned of_a, of_b;  // how many half axes they have
} box_pair;

bool gjk_is_box_pair(const gjk_iteration *it) {
  return it->a->shape->type->kind == GJK_KIND_AXES && it->b->shape->type->kind == GJK_KIND_AXES;
}

// Half axes in the frame, 0 for those that a shape has not.
static void set_axes(const gjk_collider *c, unsigned shift, gjk_vec3 axis[3]) {
  for (unsigned k = 0; k < 3; k++) {
    const gjk_vec3 *v = &c->frame[k];
    const bool is = k < c->count;
    axis[k].x = is ? gjk_shl32(v->x, shift) : 0;
    axis[k].y = is ? gjk_shl32(v->y, shift) : 0;
    axis[k].z = is ? gjk_shl32(v->z, shift) : 0;
    //@ assert axis[k].x >= -(INT32_C(1) << 30) && axis[k].x <= INT32_C(1) << 30;
    //@ assert axis[k].y >= -(INT32_C(1) << 30) && axis[k].y <= INT32_C(1) << 30;
    //@ assert axis[k].z >= -(INT32_C(1) << 30) && axis[k].z <= INT32_C(1) << 30;
  }
}

static void set_box_pair(box_pair *pair, gjk_iteration *it) {
  pair->it = it;
  pair->of_a = it->a->count;
  pair->of_b = it->b->count;
  set_axes(it->a, (unsigned)it->shift, pair->axis);
  set_axes(it->b, (unsigned)it->shift, pair->axis + 3);
  pair->delta = it->delta;
}

// The vertex of A - B whose s_k are signs. Bit k is set: s_k = 1; otherwise -1.
static void vertex_of_signs(const box_pair *pair, unsigned signs, gjk_vertex *out) {
  gjk_vec3 w = pair->delta;
  for (unsigned k = 0; k < AXES; k++) {
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
  out->a.vertex = (uint16_t)(signs & ((1u << pair->of_a) - 1));
  out->b = (uint16_t)(~signs >> 3 & ((1u << pair->of_b) - 1));
}

// *out = v with half axis k added, which it has subtracted.
static void add_twice(const box_pair *pair, unsigned k, const gjk_vertex *v, gjk_vertex *out) {
  const unsigned a = k < 3 ? 1u << k : 0, b = k < 3 ? 0 : 1u << (k - 3);
  out->w = gjk_add(gjk_add(v->w, pair->axis[k]), pair->axis[k]);
  out->a.vertex = (uint16_t)(v->a.vertex | a);
  out->b = (uint16_t)(v->b & ~b);
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
  gjk_simplex *s = &t->pair->it->simplex;
  const unsigned j = gjk_next(i), start = t->signs[i], end = t->signs[j];
  const gjk_vec3 edge = gjk_sub(s->slot[j].w, s->slot[i].w);
  unsigned signs = start;
  bool beyond = false;
  for (unsigned k = 0; k < AXES; k++) {
    const unsigned bit = 1u << k;
    const int side = (t->in_plane & bit) != 0 ? side_of_edge(&t->pair->it->direction.d, &edge, &t->pair->axis[k]) : 0;
    if (side != 0) {
      signs = side < 0 ? signs | bit : signs & ~bit;
      beyond = beyond || ((signs ^ start) & bit) != 0;
    }
  }
  if (beyond) {
    gjk_vertex first, last;
    gjk_copy(&first, &s->slot[i], sizeof first);
    gjk_copy(&last, &s->slot[j], sizeof last);
    gjk_copy(&s->slot[0], &first, sizeof first);
    vertex_of_signs(t->pair, signs, &s->slot[1]);
    gjk_copy(&s->slot[2], &last, sizeof last);
    t->signs[0] = start;
    t->signs[1] = signs;
    t->signs[2] = end;
  }
  return beyond;
}

// Step 6. Returns whether the triangle holds the origin's projection. Pre: its corners are in the slots.
static bool reach_projection(facet_triangle *t) {
  gjk_simplex *s = &t->pair->it->simplex;
  // A facet has at most 2 AXES vertices, and no vertex is left behind twice.
  for (int flips = 0; flips < 2 * AXES; flips++) {  // not reached: the ceiling
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

// Two half axes in each plane, by its number.
static const uint8_t half_axes[GJK_BOX_PLANES][2] = {{1, 2}, {2, 0}, {0, 1}, {4, 5}, {5, 3}, {3, 4}, {0, 3}, {0, 4},
                                                     {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}};

// A plane that may bound A - B.
typedef struct box_plane {
  gjk_long3 n;  // g_i x g_j; once oriented outwards, pointing against delta
  unsigned number;
  bool oriented;      // what follows is set
  unsigned i, j;      // half axes in the plane, in the order of the product
  unsigned in_plane;  // bit k: half axis k lies in the plane
  unsigned signs;     // of a vertex in the plane, as of vertex_of_signs
} box_plane;

// Sets a plane by its number. False: the half axes are parallel.
static bool set_plane(const box_pair *pair, unsigned number, box_plane *out) {
  out->number = number;
  out->oriented = false;
  gjk_cross(&pair->axis[half_axes[number][0]], &pair->axis[half_axes[number][1]], &out->n);
  return (out->n.x | out->n.y | out->n.z) != 0;
}

// gjk_dot_sign, with one branch, which rarely turns: either sign is as likely here.
static inline int side_of_plane(const gjk_long3 *n, const gjk_vec3 *v) {
  const gjk_vec3 high = {gjk_high32(n->x), gjk_high32(n->y), gjk_high32(n->z)};
  const int32_t top = gjk_high32(gjk_dot(&high, v));
  return top >= 1 || top < -1 ? (int)(gjk_sar32(top, 31) | 1) : gjk_dot_sign_exact(n, v);
}

static void orient_plane(const box_pair *pair, box_plane *plane) {
  if (plane->oriented) {
    return;
  }
  const unsigned i = half_axes[plane->number][0], j = half_axes[plane->number][1];
  const bool opposite = side_of_plane(&plane->n, &pair->delta) > 0;
  const int64_t minus = opposite ? -1 : 0;
  plane->oriented = true;
  plane->n.x = (plane->n.x ^ minus) - minus;
  plane->n.y = (plane->n.y ^ minus) - minus;
  plane->n.z = (plane->n.z ^ minus) - minus;
  plane->i = opposite ? j : i;
  plane->j = opposite ? i : j;
  plane->in_plane = 1u << i | 1u << j;
  plane->signs = 0;
  for (unsigned k = 0; k < AXES; k++) {
    const int side = k == i || k == j ? 0 : side_of_plane(&plane->n, &pair->axis[k]);
    plane->signs |= (side > 0 ? 1u : 0u) << k;
    plane->in_plane |= (side == 0 ? 1u : 0u) << k;
  }
}

// The plane's height times |d|, for d across it:   sum of |d . g_k| - |d . delta|
//   |d| <= sqrt(3) 2^30, the lengths of all g_k and delta together at most 2^31:   below 2^62
static int64_t height_across(const box_pair *pair, const gjk_vec3 *d) {
  int64_t sum = -gjk_int64(gjk_magnitude64(gjk_dot(d, &pair->delta)));
  for (unsigned k = 0; k < AXES; k++) {
    sum += gjk_int64(gjk_magnitude64(gjk_dot(d, &pair->axis[k])));
  }
  return sum;
}

// How far the height along a rounded unit vector is off.
//   unit vector   within 2^-28 of the exact one:   2^-28 2^31 = 8; and 1 rounded down
#define ALONG_ERROR 9

// The height of a plane, within ALONG_ERROR.
static int32_t height_along_normal(const box_pair *pair, const box_plane *plane) {
  gjk_search_direction direction;
  gjk_search_direction_of(&plane->n, &direction);
  const gjk_unit3 unit = gjk_unit(&direction.d);
  const gjk_vec3 u = {unit.x, unit.y, unit.z};
  return (int32_t)gjk_sar64(height_across(pair, &u), 30);
}

// Step 2 of a plane whose normal is too short to tell, as of nearly parallel half axes: sum and square of the exact normal,
// scaled to 29 bits. False: it is 0.
//   sum   off by 1 per component of the scaled normal: sqrt(3) 2^31 / 2^32 < 1; and 1 rounded down
static bool measure_short_normal(const box_pair *pair, gjk_box_heights *h, unsigned k) {
  box_plane plane;
  gjk_search_direction direction;
  if (!set_plane(pair, k, &plane)) {
    return false;
  }
  gjk_search_direction_of(&plane.n, &direction);
  const gjk_vec3 scaled = gjk_scale_direction(&direction.d);
  const gjk_vec3 d = {gjk_sar32(scaled.x, 1), gjk_sar32(scaled.y, 1), gjk_sar32(scaled.z, 1)};
  h->sum[k] = gjk_high32(height_across(pair, &d));
  h->squared[k] = (uint32_t)gjk_high32(gjk_dot(&d, &d)) + 1;  // below 3 2^58 / 2^32
  return true;
}

// The sign of a plane's height; the height's square is numerator / denominator. Overwrites the simplex.
static int exact_height(const box_pair *pair, box_plane *plane, gjk_u192 *numerator, gjk_u192 *denominator) {
  gjk_simplex *s = &pair->it->simplex;
  orient_plane(pair, plane);
  gjk_simplex_clear(s);
  vertex_of_signs(pair, plane->signs, &s->slot[0]);
  s->count = 3;
  s->normal.x = plane->n.x;
  s->normal.y = plane->n.y;
  s->normal.z = plane->n.z;
  gjk_simplex_squared_distance(s, numerator, denominator);
  return gjk_dot_sign(&plane->n, &s->slot[0].w);
}

// Is the height of p below that of q? Exact; of heights below 0 any may be the lower one. Rarely asked.
GJK_OUT_OF_LINE static bool is_lower_exactly(const box_pair *pair, box_plane *p, box_plane *q) {
  gjk_u192 numerator_p, denominator_p, numerator_q, denominator_q;
  const unsigned both = 1u << half_axes[p->number][0] | 1u << half_axes[p->number][1];
  orient_plane(pair, q);
  if ((q->in_plane & both) == both) {
    return false;  // it is the same plane
  }
  const int sign_p = exact_height(pair, p, &numerator_p, &denominator_p),
            sign_q = exact_height(pair, q, &numerator_q, &denominator_q);
  if (sign_p <= 0 || sign_q <= 0) {
    return sign_p < sign_q;
  }
  return gjk_u192_compare_quotients(&numerator_p, &denominator_p, &numerator_q, &denominator_q) < 0;
}

// The planes whose heights are bounded so far, in the order of their numbers.
typedef struct bounded_planes {
  int32_t low[GJK_BOX_PLANES];  // of the height
  uint8_t number[GJK_BOX_PLANES];
  unsigned count;
  int32_t most;     // the least height is at most that, or at most 0
  uint32_t square;  // gjk_box_height_square of it
} bounded_planes;

// Steps 1 and 2 for the planes from first to last - 1. Returns the first that separates the cores, or last.
static unsigned bound_planes(const box_pair *pair, gjk_box_heights *h, unsigned first, unsigned last,
                             bounded_planes *planes) {
  unsigned k = first;
  for (; k < last && h->sum[k] >= -GJK_BOX_SUM_ERROR; k++) {
    if (gjk_box_height_exceeds(h, k, planes->square) ||
        (gjk_box_height_is_short(h, k) &&
         (!measure_short_normal(pair, h, k) || gjk_box_height_exceeds(h, k, planes->square)))) {
      continue;
    }
    int32_t high;
    gjk_box_height_bounds(h, k, &planes->low[planes->count], &high);
    planes->number[planes->count] = (uint8_t)k;
    planes->count++;
    if (high < planes->most) {
      planes->most = high > 0 ? high : 0;
      planes->square = gjk_box_height_square(planes->most);
    }
  }
  return k;
}

// A face that seems to be low. Pre: none separates the cores.
static unsigned face_to_begin_with(const gjk_box_heights *h) {
  uint32_t least = UINT32_MAX;
  unsigned face = 0;
  for (unsigned k = 0; k < FACES; k++) {
    const uint32_t square = (uint32_t)gjk_sar64(gjk_mul32(h->sum[k], h->sum[k]), 28) / ((h->squared[k] >> 14) + 1);
    face = square < least ? k : face;
    least = square < least ? square : least;
  }
  return face;
}

// Steps 1 and 2, from the plane first on, or if that is no number from one that is found. Returns a plane that
// separates the cores, or GJK_BOX_PLANES.
static unsigned bound_heights(const box_pair *pair, gjk_box_heights *h, unsigned first, bounded_planes *planes) {
  const unsigned begin = first < GJK_BOX_PLANES && !gjk_box_height_is_short(h, first) ? first : face_to_begin_with(h);
  int32_t low;
  planes->count = 0;
  if (h->sum[begin] < -GJK_BOX_SUM_ERROR) {
    return begin;
  }
  gjk_box_height_bounds(h, begin, &low, &planes->most);
  planes->most = planes->most > 0 ? planes->most : 0;
  planes->square = gjk_box_height_square(planes->most);
  const unsigned apart = bound_planes(pair, h, 0, begin, planes);
  planes->low[planes->count] = low;
  planes->number[planes->count] = (uint8_t)begin;
  planes->count++;
  return apart < begin ? apart : bound_planes(pair, h, begin + 1, GJK_BOX_PLANES, planes);
}

// Leaves those planes that may be the least.
static void keep_doubtful(const gjk_box_heights *h, bounded_planes *planes) {
  unsigned count = 0;
  for (unsigned n = 0; n < planes->count; n++) {
    const unsigned k = planes->number[n];
    if (planes->low[n] <= planes->most && !gjk_box_height_exceeds(h, k, planes->square)) {
      planes->number[count++] = (uint8_t)k;
    }
  }
  planes->count = count;
}

// Steps 3 and 4. NULL: all half axes are parallel. A build for size does without steps 1 and 2: it takes all planes.
static box_plane *least_plane(const box_pair *pair, const bounded_planes *planes, box_plane slot[2]) {
  box_plane *least = NULL, *next = &slot[0];
  int32_t lowest = 0;
  for (unsigned n = 0; n < planes->count; n++) {
    if (!set_plane(pair, planes->number[n], next)) {
      continue;
    }
    const int32_t height = planes->count > 1 ? height_along_normal(pair, next) : 0;
    if (GJK_SMALL && height < -ALONG_ERROR) {
      return next;  // it separates the cores
    }
    if (least == NULL || height < lowest - 2 * ALONG_ERROR ||
        (height <= lowest + 2 * ALONG_ERROR && is_lower_exactly(pair, next, least))) {
      lowest = height;
      least = next;
      next = least == &slot[0] ? &slot[1] : &slot[0];
    }
  }
  return least;
}

// Step 1. Makes it->direction the normal of plane k, which separates A from B.
static void direct_across(const box_pair *pair, unsigned k) {
  gjk_vec3 *d = &pair->it->direction.d;
  gjk_long3 n;
  gjk_cross(&pair->axis[half_axes[k][0]], &pair->axis[half_axes[k][1]], &n);
  gjk_search_direction_of(&n, &pair->it->direction);
  if (gjk_dot(d, &pair->delta) > 0) {
    *d = gjk_negate(*d);
  }
}

// Does the origin's projection seem to lie beyond the edge from v to w? side_of_edge of where it lies, as far as the rounded
// normal tells: v is not in the plane of the origin.
static bool seems_beyond(const gjk_vec3 *normal, const gjk_vec3 *v, const gjk_vec3 *w) {
  const gjk_vec3 e = gjk_sub(*w, *v);
  gjk_long3 product;
  gjk_cross(&e, v, &product);
  return gjk_dot_sign(&product, normal) > 0;
}

// Steps 6, where the projection counts, and 7. Step 6 begins with the half of a parallelogram that seems to hold it: where both
// hold it, the points are the same. In a larger facet they may depend on where it begins.
static gjk_box_sat_answer offer_facet(const box_pair *pair, const box_plane *plane, bool points, gjk_facet *facet) {
  gjk_simplex *s = &pair->it->simplex;
  const unsigned i = 1u << plane->i, j = 1u << plane->j;
  facet_triangle t = {pair, plane->in_plane, {plane->signs, plane->signs | i, plane->signs | j}};
  vertex_of_signs(pair, plane->signs, &s->slot[0]);
  add_twice(pair, plane->i, &s->slot[0], &s->slot[1]);
  add_twice(pair, plane->j, &s->slot[0], &s->slot[2]);
  bool covers = true;
  if (GJK_SMALL || points) {
    if (!GJK_SMALL && plane->in_plane == (i | j) &&
        seems_beyond(&pair->it->direction.d, &s->slot[1].w, &s->slot[2].w)) {
      gjk_copy(&s->slot[0], &s->slot[1], sizeof s->slot[0]);
      add_twice(pair, plane->j, &s->slot[0], &s->slot[1]);
      t.signs[0] = plane->signs | i;
      t.signs[1] = plane->signs | i | j;
    }
    covers = reach_projection(&t);
  } else {
    gjk_simplex_clear(s);
    s->count = 3;
    s->normal.x = plane->n.x;
    s->normal.y = plane->n.y;
    s->normal.z = plane->n.z;
  }
  if (gjk_dot_sign(&plane->n, &s->slot[0].w) < 0) {
    return GJK_BOX_SAT_APART;
  }
  gjk_facet_consider(facet, pair->it, covers, -1);
  return GJK_BOX_SAT_FACET;
}

gjk_box_sat_answer gjk_box_sat(gjk_iteration *it, unsigned *number, bool *points, gjk_facet *facet) {
  gjk_box_heights heights;
  box_pair pair;
  bounded_planes planes;
  box_plane slot[2];
  if (it->a->count + it->b->count < 3) {
    return GJK_BOX_SAT_FLAT;
  }
  set_box_pair(&pair, it);
  if (GJK_SMALL) {
    for (planes.count = 0; planes.count < GJK_BOX_PLANES; planes.count++) {
      planes.number[planes.count] = (uint8_t)planes.count;
    }
  } else {
    unsigned apart = gjk_box_heights_set(pair.axis, &pair.delta, pair.of_a, pair.of_b, &heights);
    apart = apart < GJK_BOX_PLANES ? apart : bound_heights(&pair, &heights, *number, &planes);
    if (apart < GJK_BOX_PLANES) {
      direct_across(&pair, apart);
      return GJK_BOX_SAT_APART;
    }
    keep_doubtful(&heights, &planes);
  }
  box_plane *plane = least_plane(&pair, &planes, slot);
  if (plane == NULL) {
    return GJK_BOX_SAT_FLAT;
  }
  // Step 5.
  orient_plane(&pair, plane);
  if (plane->in_plane == (1u << AXES) - 1) {
    return GJK_BOX_SAT_FLAT;
  }
  *number = plane->number;
  gjk_search_direction_of(&plane->n, &it->direction);
  *points = *points || *number >= FACES;
  return offer_facet(&pair, plane, *points, facet);
}
