// The nearest feature, by exact signs alone.
//
// The feature F is the nearest one of the vertices so far, and w is a new vertex. To add w:
//
//   Step 1   Is w strictly nearer, along the exact direction from F to the origin? If not: NONE.
//   Step 2   Then the nearest feature of F and w has w as a vertex. Take the first of these that meets its condition:
//            tetrahedron   of a triangle F and w: the origin lies behind all faces with w. ENCLOSING.
//            triangle      of an edge of F and w: the origin lies before it, its projection inside.
//            edge          of a vertex of F and w: the origin's projection lies inside, the other vertices behind.
//            vertex        w: no condition.
//   Step 3   It becomes F: NEARER. Where it is a triangle and the origin lies on it: ENCLOSING.
//
// After   Johnson's sub-algorithm (Gilbert, Johnson, Keerthi 1988): a feature is nearest when the origin's projection
//         lies inside it and every other vertex lies behind it. Departures: signs are exact; cofactors are products of
//         differences of dot products; only features with w are candidates, and since w is strictly nearer, exactly one
//         of them meets its conditions.
#include "gjk_simplex.h"

void gjk_simplex_clear(gjk_simplex *s) {
  s->count = 0;
  for (uint8_t i = 0; i < 4; i++) {
    s->order[i] = i;
  }
}

// Makes the feature the first n of the slots i, j, k; the other slots follow.
GJK_ONCE static void set_feature(gjk_simplex *s, unsigned n, unsigned i, unsigned j, unsigned k) {
  s->count = (uint8_t)n;
  s->order[0] = (uint8_t)i;
  s->order[1] = (uint8_t)j;
  s->order[2] = (uint8_t)k;
  s->order[3] = (uint8_t)(6 - i - j - k);
}

// On which side of edge (i, j) does the origin's projection onto the plane of i, j, k lie? 1: on k's side; 0: on the
// line of the edge; -1: on the other side. That is the sign of k's barycentric coordinate. Up to a positive factor:
//   the point of the line nearest to the origin   p = w_i toward(j, i) + w_j toward(i, j)
//   k's coordinate                                p . (w_i - w_k)
//   where                                         w_j . (w_i - w_k) = toward(j, k) - toward(j, i)
GJK_ONCE static int beyond_edge(const gjk_simplex *s, unsigned i, unsigned j, unsigned k) {
  const int64_t *at_i = s->toward[i], *at_j = s->toward[j];  // each <= 2^61, their differences < 2^62
  return gjk_sum_of_products_sign(at_j[i], at_i[k], at_i[j], at_j[k] - at_j[i]);
}

// Sets toward of slot w, whose square is given, and another slot.
GJK_ONCE static void set_product(gjk_simplex *s, unsigned w, int64_t square, const gjk_vec3 *v, unsigned slot) {
  const int64_t dot = gjk_dot(v, &s->slot[slot].w);
  //@ assert dot >= -(INT64_C(9) << 58) && dot <= INT64_C(9) << 58;
  s->toward[w][slot] = square - dot;
  s->toward[slot][w] = s->toward[slot][slot] - dot;
  //@ assert s->toward[w][slot] >= -(INT64_C(1) << 61) && s->toward[w][slot] <= INT64_C(1) << 61;
  //@ assert s->toward[slot][w] >= -(INT64_C(1) << 61) && s->toward[slot][w] <= INT64_C(1) << 61;
}

// Sets toward of slot w with itself and with the slots of the feature, of which there are n.
GJK_ONCE static void set_products(gjk_simplex *s, unsigned w, unsigned n) {
  const gjk_vec3 v = s->slot[w].w;
  const int64_t square = gjk_dot(&v, &v);
  //@ assert square >= 0 && square <= INT64_C(9) << 58;
  s->toward[w][w] = square;
  for (unsigned i = 0; i < n; i++) {
    set_product(s, w, square, &v, s->order[i]);
  }
}

// Makes w the feature where there is none yet. Out of line, as the next three: one frame on the stack at a time.
GJK_OUT_OF_LINE static gjk_step add_first(gjk_simplex *s, unsigned w) {
  set_products(s, w, 0);
  s->count = 1;
  return GJK_STEP_NEARER;
}

// Steps 1 to 3 where F is a vertex.
GJK_OUT_OF_LINE static gjk_step add_to_vertex(gjk_simplex *s, unsigned w) {
  unsigned a = s->order[0];
  set_products(s, w, 1);
  if (s->toward[a][w] <= 0) {
    return GJK_STEP_NONE;
  }
  if (s->toward[w][a] <= 0) {
    s->order[0] = (uint8_t)w;
    s->order[1] = (uint8_t)a;
  } else {
    s->count = 2;
  }
  return GJK_STEP_NEARER;
}

static void set_triangle_normal(gjk_simplex *s, unsigned x, unsigned y, unsigned w) {
  gjk_triangle_normal(&s->slot[x].w, &s->slot[y].w, &s->slot[w].w, &s->normal);
}

// Makes the triangle x, y, w the feature, its normal towards the origin.
static gjk_step set_triangle(gjk_simplex *s, unsigned x, unsigned y, unsigned w) {
  set_triangle_normal(s, x, y, w);
  const int side = gjk_dot_sign(&s->normal, &s->slot[x].w);
  if (side > 0) {
    set_feature(s, 3, y, x, w);
    s->normal.x = -s->normal.x;
    s->normal.y = -s->normal.y;
    s->normal.z = -s->normal.z;
    return GJK_STEP_NEARER;
  }
  set_feature(s, 3, x, y, w);
  return side == 0 ? GJK_STEP_ENCLOSING : GJK_STEP_NEARER;
}

// Makes edge (x, w), edge (y, w) or vertex w the feature, where triangle x, y, w is not it.
// x_edge: y lies behind edge (x, w). y_edge: x lies behind edge (y, w).
// toward(x, w) > 0 follows from x_edge. In the plane, with x at (0, 0), y at (1, 0), the origin at (u, h), w at (p, q):
//   u, h, q > 0                     edge (x, y) was nearest, and w is nearer
//   p h >= q u, so p > 0            by x_edge
//   toward(x, w) = u p + h q > 0    the same for y
static gjk_step set_edge(gjk_simplex *s, unsigned x, unsigned y, unsigned w, bool x_edge, bool y_edge) {
  if (x_edge && s->toward[w][x] > 0) {
    set_feature(s, 2, x, w, y);
  } else if (y_edge && s->toward[w][y] > 0) {
    set_feature(s, 2, y, w, x);
  } else {
    set_feature(s, 1, w, x, y);
  }
  return GJK_STEP_NEARER;
}

// Steps 1 to 3 where F is an edge.
GJK_OUT_OF_LINE static gjk_step add_to_edge(gjk_simplex *s, unsigned w) {
  unsigned a = s->order[0], b = s->order[1];
  set_products(s, w, 2);
  if (beyond_edge(s, a, b, w) <= 0) {
    return GJK_STEP_NONE;
  }
  bool a_edge = beyond_edge(s, a, w, b) <= 0;
  bool b_edge = beyond_edge(s, b, w, a) <= 0;
  if (!a_edge && !b_edge) {
    return set_triangle(s, a, b, w);
  }
  return set_edge(s, a, b, w, a_edge, b_edge);
}

// Does the origin's projection lie on the line of edge (i, j), or on the side that k is not on?
//
// Out of line, as set_all_products: in line they would add to the deepest stack what add_to_edge alone gains by.
GJK_OUT_OF_LINE static bool is_within_edge(const gjk_simplex *s, unsigned i, unsigned j, unsigned k) {
  return beyond_edge(s, i, j, k) <= 0;
}

GJK_OUT_OF_LINE static void set_all_products(gjk_simplex *s, unsigned w) {
  set_products(s, w, s->count);
}

// Steps 2 and 3 where F is a triangle and the origin lies outside its tetrahedron with w. visible: see visible_faces.
// On a visible face (x, y, w) the origin's projection lies on w's side of edge (x, y), so that is not tested: Seen
// along the edge, the origin stands above F at an angle below 90 degrees, and above that of the face.
GJK_OUT_OF_LINE static gjk_step set_visible(gjk_simplex *s, unsigned w, unsigned visible) {
  unsigned corner[4] = {s->order[0], s->order[1], s->order[2], s->order[0]};
  for (unsigned i = 0; i < 3; i++) {
    const unsigned x = corner[i], y = corner[i + 1];
    if ((visible >> i & 1u) != 0 && !is_within_edge(s, x, w, y) && !is_within_edge(s, y, w, x)) {
      set_triangle_normal(s, x, y, w);
      set_feature(s, 3, x, y, w);
      return GJK_STEP_NEARER;
    }
  }
  for (unsigned i = 0; i < 3; i++) {
    const unsigned x = corner[i], y = corner[i + 1], z = corner[i == 0 ? 2 : i - 1];
    if (s->toward[w][x] > 0 && s->toward[x][w] > 0 && is_within_edge(s, x, w, y) && is_within_edge(s, x, w, z)) {
      set_feature(s, 2, x, w, y);
      return GJK_STEP_NEARER;
    }
  }
  set_feature(s, 1, w, corner[0], corner[1]);
  return GJK_STEP_NEARER;
}

// Which faces of the tetrahedron of the feature and w see the origin? Bit i: the face of order[i], order[i + 1 mod 3],
// w. Out of line: its products would add 96 bytes to the deepest stack.
GJK_OUT_OF_LINE static unsigned visible_faces(const gjk_simplex *s, unsigned w) {
  const gjk_vec3 *a = &s->slot[s->order[0]].w, *b = &s->slot[s->order[1]].w, *c = &s->slot[s->order[2]].w;
  const gjk_vec3 *v = &s->slot[w].w;
  // Face (x, y, w) sees the origin when (x x y) . w < 0. Two products serve all three:
  //   (a x b) . w =  (w x a) . b
  //   (b x c) . w =  (w x b) . c
  //   (c x a) . w = -(w x a) . c
  gjk_long3 wa, wb;
  gjk_cross(v, a, &wa);
  gjk_cross(v, b, &wb);
  return (gjk_dot_sign(&wa, b) < 0 ? 1u : 0u) | (gjk_dot_sign(&wb, c) < 0 ? 2u : 0u) |
         (gjk_dot_sign(&wa, c) > 0 ? 4u : 0u);
}

// Steps 1 to 3 where F is a triangle.
GJK_OUT_OF_LINE static gjk_step add_to_triangle(gjk_simplex *s, unsigned w) {
  const gjk_vec3 step = gjk_sub(s->slot[w].w, s->slot[s->order[0]].w);
  if (gjk_dot_sign(&s->normal, &step) <= 0) {
    return GJK_STEP_NONE;
  }
  const unsigned visible = visible_faces(s, w);
  if (visible == 0) {
    s->count = 4;
    return GJK_STEP_ENCLOSING;
  }
  set_all_products(s, w);
  return set_visible(s, w, visible);
}

gjk_step gjk_simplex_add(gjk_simplex *s) {
  const unsigned w = s->order[s->count];
  switch (s->count) {
    case 3: return add_to_triangle(s, w);
    case 2: return add_to_edge(s, w);
    case 1: return add_to_vertex(s, w);
    default: break;
  }
  return add_first(s, w);
}

bool gjk_simplex_set(gjk_simplex *s, unsigned n) {
  gjk_simplex_clear(s);
  for (unsigned i = 0; i < n; i++) {
    set_all_products(s, i);
    s->count++;
  }
  if (n == 2) {
    return s->toward[0][1] > 0 && s->toward[1][0] > 0;
  }
  if (n == 3) {
    set_triangle(s, 0, 1, 2);
    return !is_within_edge(s, 0, 1, 2) && !is_within_edge(s, 1, 2, 0) && !is_within_edge(s, 2, 0, 1);
  }
  return true;
}

bool gjk_simplex_widen(gjk_simplex *s) {
  const unsigned w = s->order[2];
  set_all_products(s, w);
  set_triangle(s, s->order[0], s->order[1], w);
  if ((s->normal.x | s->normal.y | s->normal.z) == 0) {
    s->count = 2;
    return false;
  }
  return true;
}

unsigned gjk_simplex_beyond(const gjk_simplex *s) {
  unsigned edge = 0;
  while (edge < 3 && beyond_edge(s, edge, gjk_next(edge), gjk_next(gjk_next(edge))) >= 0) {
    edge++;
  }
  return edge;
}

// The sign of (w_i x w_j) . w_k.
static int volume_sign(const gjk_simplex *s, unsigned i, unsigned j, unsigned k) {
  gjk_long3 product;
  gjk_cross(&s->slot[i].w, &s->slot[j].w, &product);
  return gjk_dot_sign(&product, &s->slot[k].w);
}

bool gjk_simplex_encloses(gjk_simplex *s, unsigned n) {
  if (n == 4) {
    // The origin's barycentric coordinates, up to a common factor; inside, none has the sign of another's opposite.
    const int weight[4] = {volume_sign(s, 1, 2, 3), -volume_sign(s, 0, 2, 3), volume_sign(s, 0, 1, 3),
                           -volume_sign(s, 0, 1, 2)};
    int low = 0, high = 0;
    for (int i = 0; i < 4; i++) {
      low = weight[i] < low ? weight[i] : low;
      high = weight[i] > high ? weight[i] : high;
    }
    return low * high == 0 && low + high != 0;
  }
  // The origin's projection lies strictly inside what they span, and the direction from there to the origin is zero.
  gjk_search_direction direction;
  if (!gjk_simplex_set(s, n)) {
    return false;
  }
  return n == 3 ? gjk_dot_sign(&s->normal, &s->slot[0].w) == 0 : !gjk_simplex_direction(s, &direction);
}

bool gjk_simplex_direction(const gjk_simplex *s, gjk_search_direction *out) {
  const unsigned a = s->order[0], b = s->order[1];
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 3) {
    gjk_search_direction_of(&s->normal, out);
    return true;
  }
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 2) {
    return gjk_search_direction_of_edge(&s->slot[a].w, s->toward[b][a], &s->slot[b].w, s->toward[a][b], out);
  }
  out->d = gjk_negate(s->slot[a].w);
  out->exact = true;
  return s->toward[a][a] != 0;
}

void gjk_simplex_exact_direction(const gjk_simplex *s, gjk_direction *out) {
  const unsigned a = s->order[0], b = s->order[1];
  out->a = &s->slot[a].w;
  out->b = &s->slot[b].w;
  out->n = &s->normal;
  if (s->count == 2) {
    out->ta = s->toward[a][b];
    out->tb = s->toward[b][a];
  }
  out->spanning = s->count;
  out->opposite = false;
  out->level = NULL;
}

static void set_limbs(gjk_u192 *out, const gjk_u128 *x) {
  gjk_u192_set(out, x->low);
  out->limb[2] = (uint32_t)(x->high & UINT32_MAX);
  out->limb[3] = (uint32_t)(x->high >> 32);
}

// *out = p q + r s, which is not negative. Pre: see gjk_sum_of_products.
static void set_sum_of_products(int64_t p, int64_t q, int64_t r, int64_t s, gjk_u192 *out) {
  gjk_u128 sum;
  gjk_sum_of_products(p, q, r, s, &sum);
  set_limbs(out, &sum);
}

// *out = (n . w)^2 for a vertex w of the triangle. |n . w| <= 2^93.
static void squared_height(const gjk_simplex *s, gjk_u192 *out) {
  uint32_t low;
  gjk_u128 height;
  gjk_u192 x;
  const int64_t high = gjk_dot_exact(&s->normal, &s->slot[s->order[0]].w, &low);
  gjk_magnitude95(high, low, &height);
  set_limbs(&x, &height);
  gjk_u192_multiply(out, &x, &x);
}

int32_t gjk_simplex_along_axis(const gjk_simplex *s) {
  const gjk_vec3 *w = &s->slot[s->order[0]].w;
  const gjk_long3 *n = &s->normal;
  const bool face = GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 3, x = face ? n->x != 0 : w->x != 0,
             y = face ? n->y != 0 : w->y != 0, z = face ? n->z != 0 : w->z != 0;
  if (s->count == 2 || (x ? y || z : y == z)) {
    return -1;
  }
  return (int32_t)gjk_magnitude32(x ? w->x : y ? w->y : w->z);
}

void gjk_simplex_squared_distance(const gjk_simplex *s, gjk_u192 *numerator, gjk_u192 *denominator) {
  const unsigned a = s->order[0], b = s->order[1];
  const gjk_long3 *n = &s->normal;
  const int64_t square = s->toward[a][a];
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 3) {
    // (n . a)^2 / |n|^2
    gjk_u192 z;
    squared_height(s, numerator);
    set_sum_of_products(n->x, n->x, n->y, n->y, denominator);
    set_sum_of_products(n->z, n->z, 0, 0, &z);
    gjk_u192_add(denominator, &z);
  } else if (GJK_SHAPES >= GJK_SHAPES_ROUND && s->count == 2) {
    // |a x b|^2 / |b - a|^2, where |a x b|^2 = (a . a) (b . b) - (a . b)^2
    const int64_t dot = square - s->toward[a][b];
    set_sum_of_products(square, s->toward[b][b], -dot, dot, numerator);
    gjk_u192_set(denominator, (uint64_t)(s->toward[a][b] + s->toward[b][a]));
  } else {
    gjk_u192_set(numerator, (uint64_t)square);
    gjk_u192_set(denominator, 1);
  }
}

int gjk_compare_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, uint64_t twice) {
  gjk_u192 x, y;
  gjk_u192_set(&y, twice);
  gjk_u192_multiply(&x, &y, &y);
  gjk_u192_multiply(&y, &x, denominator);
  x = *numerator;
  gjk_u192_add(&x, &x);
  gjk_u192_add(&x, &x);
  return gjk_u192_compare(&x, &y);
}

int64_t gjk_round_distance(const gjk_u192 *numerator, const gjk_u192 *denominator, int64_t low, int64_t high,
                           unsigned shift, gjk_round_to to) {
  while (low < high) {  // half of the candidates stay
    const int64_t middle = gjk_sar64(low + high, 1);
    //@ assert middle >= low && middle < high;
    // The result exceeds middle when the distance, in units of 2^shift, is
    //   to round up          > middle
    //   to the nearest     >= middle + 1/2
    //   to round down      >= middle + 1
    const int sign = gjk_compare_distance(numerator, denominator, (uint64_t)(2 * middle + (int)to) << shift);
    if (to == GJK_ROUND_UP ? sign > 0 : sign >= 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

// The number whose sign beyond_edge returns, where it is not negative: k's barycentric coordinate times the square of
// twice the triangle's area. At most 2^124.
static void weight_of(const gjk_simplex *s, unsigned i, unsigned j, unsigned k, gjk_u128 *out) {
  const int64_t *at_i = s->toward[i], *at_j = s->toward[j];
  gjk_sum_of_products(at_j[i], at_i[k], at_i[j], at_j[k] - at_j[i], out);
}

void gjk_simplex_parts(const gjk_simplex *s, gjk_u128 part[3]) {
  const unsigned a = s->order[0], b = s->order[1], c = s->order[2];
  if (s->count == 3) {
    weight_of(s, b, c, a, &part[0]);
    weight_of(s, c, a, b, &part[1]);
    weight_of(s, a, b, c, &part[2]);
    return;
  }
  part[0].high = part[1].high = part[2].high = part[2].low = 0;
  part[0].low = (uint64_t)s->toward[b][a];
  part[1].low = (uint64_t)s->toward[a][b];
}

void gjk_simplex_weights(const gjk_simplex *s, bool fine, gjk_barycentric weight[2]) {
  gjk_u128 part[3];
  gjk_simplex_parts(s, part);
  gjk_barycentrics(&part[0], &part[1], &part[2], fine, weight);
}
