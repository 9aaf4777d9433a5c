// A cached feature is confirmed by the edges beside it, without a support scan.
//
// Of polygons whose vertices are in order, in a near frame, with O for the origin and d for the direction from the feature to O:
//
//   1. A vertex of A - B is the nearest if the edges that leave it fall along d: two of A along d, two of B along -d. A - B
//      lies in the cone of these edges.
//   2. An edge of one shape makes one of A - B with a vertex of the other whose edges fall along d, or along -d. Parallel
//      edges of A and -B make one together.
//   3. It is the nearest if O lies on its right, with its foot inside of it.
//
// All signs are strict. So no other feature holds the nearest point, and this one is canonical (gjk2_canonical.h). Where a
// sign fails, the search decides.
#include "gjk2_recall.h"

#include "gjk2_feature.h"

#if GJK_64_BIT && !GJK_SMALL

// The posed vertices of a shape in order, or NULL: those of points, segments and boxes are sums of half axes.
static inline const gjk2_vec *recall_list(const gjk2_collider *c) {
  return c->buffer != NULL ? c->buffer : c->count == 3 ? c->frame : NULL;
}

// Has the shape vertices in order, whose places are known, and one with this number?
static inline bool recall_has(const gjk2_collider *c, unsigned number) {
  return (c->ordered ? c->buffer != NULL || !c->shape->type->buffered : c->shape->type->touch != NULL) &&
         number < c->count;
}

static inline unsigned recall_after(const gjk2_collider *c, unsigned number) {
  return number + 1 < c->count ? number + 1 : 0;
}

static inline unsigned recall_before(const gjk2_collider *c, unsigned number) {
  return (number > 0 ? number : c->count) - 1u;
}

// -1 or, of a number with that bit, 1.
static inline int64_t recall_sign(unsigned number, unsigned bit) {
  return (number & bit) != 0 ? 1 : -1;
}

GJK_ONCE static void recall_place(const gjk2_collider *c, const gjk2_vec *v, unsigned number, int64_t *x, int64_t *y) {
  if (v == NULL) {
    const int64_t s = recall_sign(number, 1), t = recall_sign(number, 2);
    *x = s * c->frame[0].x + t * c->frame[1].x;
    *y = s * c->frame[0].y + t * c->frame[1].y;
  } else {
    *x = v[number].x;
    *y = v[number].y;
  }
}

// The edge to the next vertex counterclockwise, of a box in the order 3, 2, 0, 1. Returns that one's number.
GJK_ONCE static unsigned recall_edge(const gjk2_collider *c, const gjk2_vec *v, unsigned number, int64_t *x,
                                     int64_t *y) {
  if (v == NULL) {
    const unsigned axis = c->count == 4 ? (number ^ number >> 1) & 1u : 0;
    const int64_t twice = -2 * recall_sign(number, 1u << axis);
    *x = twice * c->frame[axis].x;
    *y = twice * c->frame[axis].y;
    return number ^ (1u << axis);
  }
  const unsigned after = recall_after(c, number);
  *x = (int64_t)v[after].x - v[number].x;
  *y = (int64_t)v[after].y - v[number].y;
  return after;
}

// Do both edges from the vertex fall along d?
GJK_ONCE static bool recall_is_peak(const gjk2_collider *c, const gjk2_vec *v, unsigned number, int64_t d_x,
                                    int64_t d_y) {
  if (v == NULL) {
    return (c->count < 2 || recall_sign(number, 1) * (c->frame[0].x * d_x + c->frame[0].y * d_y) > 0) &&
           (c->count < 4 || recall_sign(number, 2) * (c->frame[1].x * d_x + c->frame[1].y * d_y) > 0);
  }
  const int64_t along = v[number].x * d_x + v[number].y * d_y;
  const gjk2_vec *after = v + recall_after(c, number), *before = v + recall_before(c, number);
  return after->x * d_x + after->y * d_y < along && before->x * d_x + before->y * d_y < along;
}

// The pair and its lists of vertices.
typedef struct recall_pair {
  const gjk2_collider *a, *b;
  const gjk2_vec *list_a, *list_b;
} recall_pair;

// Steps 2 and 3
GJK_ONCE static bool recall_is_edge(const recall_pair *of, const gjk2_cache *cache, gjk2_feature *out) {
  const bool of_a = cache->a[1] != cache->a[0], of_b = cache->b[1] != cache->b[0];
  int64_t a_x = 0, a_y = 0, b_x = 0, b_y = 0;
  if ((of_a && recall_edge(of->a, of->list_a, cache->a[0], &a_x, &a_y) != cache->a[1]) ||
      (of_b && recall_edge(of->b, of->list_b, cache->b[0], &b_x, &b_y) != cache->b[1])) {
    return false;
  }
  const int64_t x = a_x - b_x, y = a_y - b_y;
  out->edge_a_x = a_x;
  out->edge_a_y = a_y;
  out->edge_x = x;
  out->edge_y = y;
  out->d_x = y;
  out->d_y = -x;
  out->base = out->w_x * y - out->w_y * x;
  const int64_t along = out->w_x * x + out->w_y * y;
  if (out->base >= 0 || along >= 0 || along + x * x + y * y <= 0) {
    return false;
  }
  return of_a && of_b ? a_x * b_y == a_y * b_x && a_x * b_x + a_y * b_y < 0
         : of_a       ? recall_is_peak(of->b, of->list_b, cache->b[0], -y, x)
                      : recall_is_peak(of->a, of->list_a, cache->a[0], y, -x);
}

// Step 1
GJK_ONCE static bool recall_is_vertex(const recall_pair *of, const gjk2_cache *cache, gjk2_feature *out) {
  const int64_t x = out->w_x, y = out->w_y;
  out->d_x = -x;
  out->d_y = -y;
  out->base = -(x * x + y * y);
  return out->base != 0 && recall_is_peak(of->a, of->list_a, cache->a[0], -x, -y) &&
         recall_is_peak(of->b, of->list_b, cache->b[0], x, y);
}

// Steps 1 to 3. Pre: the numbers of the first vertex are in range.
GJK_ONCE static bool recall_confirms(const recall_pair *of, const gjk2_cache *cache, gjk2_feature *out) {
  int64_t b_x, b_y;
  recall_place(of->a, of->list_a, cache->a[0], &out->a_x, &out->a_y);
  recall_place(of->b, of->list_b, cache->b[0], &b_x, &b_y);
  out->w_x = (int64_t)of->a->centre.x - of->b->centre.x + out->a_x - b_x;
  out->w_y = (int64_t)of->a->centre.y - of->b->centre.y + out->a_y - b_y;
  out->base = out->d_x = out->d_y = 0;
  out->edge_x = out->edge_y = out->edge_a_x = out->edge_a_y = 0;
  out->is_edge = cache->count == 2;
  return out->is_edge ? recall_is_edge(of, cache, out) : recall_is_vertex(of, cache, out);
}

bool gjk2_recall(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cache *cache, unsigned parts,
                 gjk2_distance_result *out) {
  gjk2_feature of;
  if (cache->count > 2 || !gjk2_frame_is_near(a, b) || !recall_has(a, cache->a[0]) || !recall_has(b, cache->b[0])) {
    return false;
  }
  const recall_pair boxes = {a, b, NULL, NULL}, pair = {a, b, recall_list(a), recall_list(b)};
  if (pair.list_a == NULL && pair.list_b == NULL ? !recall_confirms(&boxes, cache, &of)
                                                 : !recall_confirms(&pair, cache, &of)) {
    return false;
  }
  for (unsigned i = 0; i < cache->count; i++) {
    out->certificate.a[i] = cache->a[i];
    out->certificate.b[i] = cache->b[i];
  }
  gjk2_feature_measure(a, b, &of, false, parts, out);
  return true;
}

#else

bool gjk2_recall(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cache *cache, unsigned parts,
                 gjk2_distance_result *out) {
  (void)a, (void)b, (void)cache, (void)parts, (void)out;
  return false;
}

#endif
