// The edges of A - B: the steps of gjk2_edges.h.
#include "gjk2_edges.h"

#include "gjk2_boxes.h"
#include "gjk2_hull.h"

// The boundary of one shape, from a corner to the next; of B with every edge taken negative.
typedef struct rim {
  const gjk2_collider *c;
  const gjk2_vec *at, *next;     // two corners
  const gjk2_vec *corner, *end;  // the list of all, counterclockwise; NULL: the vertices are in no order, or lazy
  gjk2_vec step;                 // from at to next; of B its negative
  uint32_t left;                 // edges to come; without a list 0 once round, else 1
  uint16_t first;                // without a list: the number of the first corner
  gjk2_vec own[4];               // the list of a box's corners
  gjk2_support corner_at, corner_next;  // without a list: what at and next point to
} rim;

static uint16_t number_at(const rim *r) {
  if (r->corner == NULL) {
    return r->corner_at.vertex;
  }
  const uint16_t index = (uint16_t)(r->at - r->corner);
  return r->corner == r->own ? (uint16_t)gjk2_box_number(index) : index;
}

// Sets the step to next; 0 once round.
static inline void set_step(rim *r, bool opposite) {
  r->step = opposite ? gjk2_sub(*r->at, *r->next) : gjk2_sub(*r->next, *r->at);
  if (r->left == 0) {
    r->step.x = 0;
    r->step.y = 0;
  }
}

// Moves to next where there is no list. Vertices may repeat, so a rim ends where its place is the first one's.
GJK_OUT_OF_LINE static void advance_unlisted(rim *r, bool opposite) {
  gjk2_copy_support(&r->corner_at, &r->corner_next);
  const bool round = r->left != 0 && r->corner_at.vertex == r->first;
  r->left = !round && gjk2_hull_neighbour(r->c, &r->corner_at, true, &r->corner_next) ? 1 : 0;
  r->corner_next.offset = gjk2_add(r->corner_at.offset, r->corner_next.offset);
  set_step(r, opposite);
}

// Moves to next. of_b, a constant, lets the compiler choose once.
static inline void advance(rim *r, bool of_b) {
  if (r->corner == NULL) {
    advance_unlisted(r, of_b);
    return;
  }
  const gjk2_vec *next = r->next + 1;
  r->at = r->next;
  r->next = next != r->end ? next : r->corner;
  r->left--;
  set_step(r, of_b);
}

static inline void start_list(rim *r, const gjk2_collider *c) {
  r->c = c;
  r->corner = gjk2_list_of_corners(c, r->own);
}

// Step 1
static void start_rim(rim *r, bool opposite, gjk2_vec d) {
  const gjk2_collider *c = r->c;
  gjk2_hull_corner(c, opposite ? gjk2_negate(d) : d, &r->corner_next);
  if (r->corner == NULL) {
    r->at = &r->corner_at.offset;
    r->next = &r->corner_next.offset;
    r->first = r->corner_next.vertex;
    r->left = 0;
    advance_unlisted(r, opposite);
    return;
  }
  const uint16_t number = r->corner_next.vertex;
  r->left = c->count + UINT32_C(1);
  r->end = r->corner + c->count;
  r->next = r->corner + (r->corner == r->own ? gjk2_box_index(number) : number);
  advance(r, opposite);
}

// Step 2 where the edges are parallel, or one rim is done, whose step is 0. Above 0: the edge of a comes first; below 0:
// that of b; 0: they make one edge. last: the edge before. Both turn from it by less than half a turn. The edge of a
// segment may turn by exactly that. Then the other may be parallel to last, and comes first.
static int order_parallel(const rim *a, const rim *b, gjk2_vec last) {
  if (a->left == 0 || b->left == 0) {
    return a->left == 0 ? -1 : 1;
  }
  if (gjk2_dot(a->step, b->step) > 0) {
    return 0;
  }
  return gjk2_dot(a->step, last) > 0 ? 1 : -1;
}

// out = x^2 y, 192 bits.
static void square_times(gjk_u192 *out, uint64_t x, uint64_t y) {
  gjk_u192 factor, square;
  gjk_u192_set(&factor, x);
  gjk_u192_multiply(&square, &factor, &factor);
  gjk_u192_set(&factor, y);
  gjk_u192_multiply(out, &square, &factor);
}

// Compares height / |length| with that of the edge. By squares: (2^61)^2 2^60 < 2^182.
GJK_OUT_OF_LINE static int compare_exactly(const gjk2_edge *edge, uint64_t height, const gjk2_length *length) {
  gjk_u192 x, y;
  square_times(&x, height, edge->length.squared);
  square_times(&y, (uint64_t)edge->height, length->squared);
  return gjk_u192_compare(&x, &y);
}

bool gjk2_edge_is_lower(const gjk2_edge *edge, uint64_t height, const gjk2_length *length) {
  return compare_exactly(edge, height, length) > 0;
}

// The nearest edge so far.
typedef struct nearest_so_far {
  gjk2_edge *edge;
  uint64_t low, high;  // bounds of its distance, 2^-32 LSB
  uint32_t above;      // LSB, more than its distance and CENTRE_SLACK
  bool found;
  bool back;  // it was found clockwise: an edge as near comes before it
} nearest_so_far;

// The centre of a shape is that of its vertices' bounding box. It lies in their hull. Let p x + q y = 0, p >= |q|, be a
// line through it. Then the vertex that touches the box's left side is on its left, or on it. Rounding moves a vertex against
// it by less than 0.75 sqrt(2) LSB, and the middle by at most 0.5 sqrt(2). So two centres are off by less than this, LSB.
#define CENTRE_SLACK 4

// Bounds of height / |length| in 2^-32 LSB. Pre: it is below 2^31.
static void bound_height(const gjk2_length *length, uint64_t height, uint64_t *low, uint64_t *high) {
  unsigned shift;
  const uint64_t quotient = gjk2_quotient(length, &shift, height);
  // quotient / 2^shift < 2^31, in 2^-32 LSB below 2^63
  uint64_t middle = 0;
  if (shift < 32) {
    middle = quotient << (32 - shift);
  } else if (shift < 96) {
    middle = quotient >> (shift - 32);
  }
  const uint64_t error = (middle >> 28) + 2;
  *low = middle > error ? middle - error : 0;
  *high = middle + error;
}

// Step 4 for the edge by step. Returns whether it is the nearest so far. back: it is found clockwise.
GJK_OUT_OF_LINE static bool keep_lower(nearest_so_far *n, gjk2_vec step, uint64_t height, bool back) {
  gjk2_length length;
  uint64_t low, high;
  gjk2_length_set(&length, step);
  bound_height(&length, height, &low, &high);
  if (n->found &&
      (low > n->high || (high >= n->low && compare_exactly(n->edge, height, &length) >= (n->back ? 1 : 0)))) {
    return false;
  }
  n->found = true;
  n->back = back;
  n->low = low;
  n->high = high;
  n->above = (uint32_t)(high >> 32) + 1 + CENTRE_SLACK;
  gjk2_copy_length(&n->edge->length, &length);
  n->edge->height = (int64_t)height;
  return true;
}

static void set_corner(const rim *a, const rim *b, gjk2_vec w, gjk2_vertex *out) {
  gjk2_copy(&out->w, &w);
  gjk2_copy(&out->a.offset, a->at);
  gjk2_copy(&out->b.offset, b->at);
  out->a.vertex = number_at(a);
  out->b.vertex = number_at(b);
}

#if !GJK_SMALL
// What the loop of gjk2_nearest_edge does where both shapes have lists of corners, which are hulls with area: without
// an end of either list. The next edge of each shape turns by less than half a turn from the last edge of all. So the
// sign of their cross product tells which one comes first, also where one shape begins anew.
//
// Edges on the far side are left out. The shapes' centres lie in them, up to CENTRE_SLACK, so delta lies in A - B. Then no
// edge whose normal n points along or near delta is the nearest: its line is at least n . delta / |n| from the origin.
// Edges are visited counterclockwise from the beginning. That ends with an edge, of normal n and end w: no normal from n
// on to delta is one of a nearer edge. Then clockwise from the beginning, likewise. The test of a vertex w:
//   the line from w to delta passes the origin on its left side, at `above` or more. Let m be its unit normal
//   directions m' with m' . w at least the distance so far make an arc around w, which holds n and m
//   directions m' with m' . delta at least `above` make an arc around delta, which holds m and delta
//   m lies up to half a turn after n, since delta is not beyond the edge, which is tested
// So both arcs together hold all directions from n to delta, or n is past delta already.
//
// The answer is that of one round counterclockwise: of equally near edges the first one there, and of edges that
// separate likewise. On the way back that is the last one.

// The next edge of a shape, whichever way the walk goes.
typedef struct listed_edge {
  const gjk2_vec *from, *to;  // in the order of the walk
  gjk2_vec step;              // of B its negative
} listed_edge;

// *r has the list.
static inline void next_listed(const rim *r, listed_edge *e, bool opposite, bool following) {
  const gjk2_vec *from = e->to, *to;
  if (following) {
    to = from + 1 != r->end ? from + 1 : r->corner;
  } else {
    to = (from != r->corner ? from : r->end) - 1;
  }
  e->from = from;
  e->to = to;
  e->step.x = opposite ? from->x - to->x : to->x - from->x;
  e->step.y = opposite ? from->y - to->y : to->y - from->y;
}

static void start_listed(rim *r, bool opposite, gjk2_vec d, listed_edge *e) {
  const gjk2_collider *c = r->c;
  gjk2_support corner;
  d = opposite ? gjk2_negate(d) : d;
  c->shape->type->support(c, &d, &corner);
  r->end = r->corner + c->count;
  e->to = r->corner + (r->corner == r->own ? gjk2_box_index(corner.vertex) : corner.vertex);
  next_listed(r, e, opposite, true);
  if (gjk2_dot(e->step, d) == 0) {  // of two corners the last one counterclockwise
    next_listed(r, e, opposite, true);
  }
}

static void set_listed(const rim *r, const gjk2_vec *at, gjk2_support *out) {
  const uint16_t index = (uint16_t)(at - r->corner);
  gjk2_copy(&out->offset, at);
  out->vertex = r->corner == r->own ? (uint16_t)gjk2_box_number(index & 3u) : index;
}

// Cross products of vectors truncated to 16 bits: on cores without a long multiplication they tell most signs. Core radii
// are p and q, and W = |delta.x| + |delta.y| + p + q < 2^(k + 14):
//   v = 2^k vc + r,  0 <= r < 2^k per component:  |w| <= W, |step| <= 2 W, so |wc| <= 2^14 and |stepc| <= 2^15
//   v x u / 2^(2 k) - vc x uc  is at most |vc.x| + |vc.y| + |uc.x| + |uc.y| + 2 <= 4 2^15 + 2 in size
//   |step of A| |step of B| <= 4 p q <= W^2:  products of their components are below 2^29, of w and a step 2^29 at most
#if GJK_NARROW_MULTIPLY
#define CROSS_ERROR (4 * INT32_C(32768) + 2)

typedef int32_t edge_turn;

static unsigned ruler_of(const gjk2_search *s) {
  const uint32_t reach = gjk2_norm1(s->delta) + (uint32_t)s->a->core_radius + (uint32_t)s->b->core_radius;
  const unsigned bits = 32 - gjk_clz32(reach);
  return bits > 14 ? bits - 14 : 0;
}

static inline int32_t coarse_cross(unsigned k, gjk2_vec a, gjk2_vec b) {
  return gjk_sar32(a.x, k) * gjk_sar32(b.y, k) - gjk_sar32(a.y, k) * gjk_sar32(b.x, k);
}

// A number with the sign of a x b.
static inline edge_turn sign_of_turn(unsigned k, gjk2_vec a, gjk2_vec b) {
  const int32_t coarse = coarse_cross(k, a, b);
  if (coarse > CROSS_ERROR || coarse < -CROSS_ERROR) {
    return coarse;
  }
  const int64_t turn = gjk2_cross(a, b);
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

// Is the line along step through w surely above LSB or more from the origin, which lies on its left?
static inline bool is_high(unsigned k, gjk2_vec w, gjk2_vec step, uint32_t above) {
  const uint32_t rough = above >> k, length = (gjk2_norm1(step) >> k) + 1;  // length <= 2^16 + 1
  const int32_t coarse = coarse_cross(k, w, step) - CROSS_ERROR;
  return coarse > 0 && rough <= 16384 && (uint32_t)coarse >= (rough + 1) * length;
}
#else
typedef int64_t edge_turn;

static inline unsigned ruler_of(const gjk2_search *s) {
  (void)s;
  return 0;
}

static inline edge_turn sign_of_turn(unsigned k, gjk2_vec a, gjk2_vec b) {
  (void)k;
  return gjk2_cross(a, b);
}

// The exact height costs as little.
static inline bool is_high(unsigned k, gjk2_vec w, gjk2_vec step, uint32_t above) {
  (void)k, (void)w, (void)step, (void)above;
  return false;
}
#endif

// The walk over both lists.
typedef struct listed_walk {
  gjk2_search *s;
  const rim *a, *b;
  listed_edge of_a, of_b;       // the next edges
  gjk2_vec w;                   // where they begin
  const gjk2_vec *at_a, *at_b;  // the corners where the nearest edge begins, counterclockwise
  int comes;                    // 1: it is an edge of A; -1: of B; 0: of both
  uint32_t left;                // edges to come
  bool apart;                   // s->d separates
} listed_walk;

// Is no edge beyond the vertex w nearer than all so far? edge: the last one visited, counterclockwise; k: ruler_of.
static inline bool ends_walk(const gjk2_search *s, unsigned k, gjk2_vec w, gjk2_vec edge, uint32_t above,
                             bool following) {
  const gjk2_vec on = following ? gjk2_sub(s->delta, w) : gjk2_sub(w, s->delta);
#if GJK_NARROW_MULTIPLY
  if (!is_high(k, w, on, above)) {
    return false;
  }
#else
  (void)k;
  if (gjk2_cross(w, on) < gjk_int64(gjk_umul32(above, gjk2_norm1(on)))) {
    return false;
  }
#endif
  return gjk2_cross(gjk2_sub(w, s->delta), edge) >= 0;
}

// Visits edges counterclockwise, or clockwise, until none beyond is the nearest.
GJK_ONCE static void walk_listed(listed_walk *l, nearest_so_far *n, bool following) {
  gjk2_search *s = l->s;
  listed_edge a = l->of_a, b = l->of_b;
  gjk2_vec w = l->w;
  uint32_t left = l->left;
  const unsigned k = ruler_of(s);
  while (left > 0) {
    const edge_turn turn = following ? sign_of_turn(k, a.step, b.step) : sign_of_turn(k, b.step, a.step);
    int32_t x = b.step.x, y = b.step.y;
    if (turn >= 0) {
      x = turn > 0 ? a.step.x : x + a.step.x;
      y = turn > 0 ? a.step.y : y + a.step.y;
    }
    const gjk2_vec edge = {following ? x : -x, following ? y : -y}, from = w;
    w.x += x;
    w.y += y;
    //@ assert w.x >= -(INT32_C(3) << 29) && w.x <= INT32_C(3) << 29;
    //@ assert w.y >= -(INT32_C(3) << 29) && w.y <= INT32_C(3) << 29;
    const bool high = is_high(k, w, edge, n->above);
    const int64_t height = high ? 0 : gjk2_cross(from, edge);
    if (height < 0) {  // Step 3
      s->d = gjk2_outward(edge);
      s->along = height;
      l->apart = true;
      if (following) {
        break;
      }
    } else {
      if (!following && l->apart) {
        break;
      }
      // Most edges are farther by a rough bound, and most others by a better one.
      if (!high && (uint64_t)height < gjk_umul32(n->above, gjk2_norm1(edge)) &&
          (uint64_t)height < gjk_umul32(n->above, gjk2_length_bound(edge)) &&
          keep_lower(n, edge, (uint64_t)height, !following)) {
        gjk2_copy(&n->edge->p.w, following ? &from : &w);
        gjk2_copy(&n->edge->q.w, &edge);
        l->at_a = following || turn < 0 ? a.from : a.to;
        l->at_b = following || turn > 0 ? b.from : b.to;
        l->comes = turn > 0 ? 1 : turn < 0 ? -1 : 0;
      }
      if (ends_walk(s, k, w, edge, n->above, following)) {
        break;
      }
    }
    if (turn >= 0) {
      next_listed(l->a, &a, false, following);
    }
    if (turn <= 0) {
      next_listed(l->b, &b, true, following);
    }
    left -= turn == 0 && left > 1 ? 2 : 1;
  }
  l->left = left;
}

// Sets the edge's ends, of which w of the first and the step to the other are known.
static void set_listed_edge(const listed_walk *l, gjk2_edge *edge) {
  const gjk2_vec *a = l->at_a, *b = l->at_b;
  edge->q.w = gjk2_add(edge->p.w, edge->q.w);
  set_listed(l->a, a, &edge->p.a);
  set_listed(l->b, b, &edge->p.b);
  a = l->comes < 0 ? a : a + 1 != l->a->end ? a + 1 : l->a->corner;
  b = l->comes > 0 ? b : b + 1 != l->b->end ? b + 1 : l->b->corner;
  set_listed(l->a, a, &edge->q.a);
  set_listed(l->b, b, &edge->q.b);
}

// The same over two lists of corners.
static bool measure_listed(gjk2_search *s, rim *rim_a, rim *rim_b, gjk2_vec begin, nearest_so_far *n) {
  listed_walk l;
  l.s = s;
  l.a = rim_a;
  l.b = rim_b;
  start_listed(rim_a, false, begin, &l.of_a);
  start_listed(rim_b, true, begin, &l.of_b);
  l.w = gjk2_add(s->delta, gjk2_sub(*l.of_a.from, *l.of_b.from));
  l.left = s->a->count + (uint32_t)s->b->count;
  l.apart = false;
  l.at_a = l.of_a.from;
  l.at_b = l.of_b.from;
  l.comes = 0;
  walk_listed(&l, n, true);
  if (!l.apart && l.left > 0) {
    l.of_a.to = l.of_a.from;
    l.of_b.to = l.of_b.from;
    next_listed(rim_a, &l.of_a, false, false);
    next_listed(rim_b, &l.of_b, true, false);
    walk_listed(&l, n, false);
  }
  if (!l.apart) {
    set_listed_edge(&l, n->edge);
  }
  return !l.apart;
}
#endif

// The walk over all edges, where a shape has no list of corners. False: one of them separates, and s->d is set.
static bool measure_rims(gjk2_search *s, rim *rim_a, rim *rim_b, gjk2_vec begin, nearest_so_far *n) {
  start_rim(rim_a, false, begin);
  start_rim(rim_b, true, begin);
  gjk2_vec step = {-begin.y, begin.x}, w = gjk2_add(s->delta, gjk2_sub(*rim_a->at, *rim_b->at));
  for (;;) {  // at most once for each edge of A and of B
    const int64_t turn = gjk2_cross(rim_a->step, rim_b->step);
    int comes = turn > 0 ? 1 : -1;
    if (turn == 0) {
      if ((rim_a->left | rim_b->left) == 0) {
        break;
      }
      comes = order_parallel(rim_a, rim_b, step);
    }
    step.x = (comes >= 0 ? rim_a->step.x : 0) + (comes <= 0 ? rim_b->step.x : 0);
    step.y = (comes >= 0 ? rim_a->step.y : 0) + (comes <= 0 ? rim_b->step.y : 0);
    const int64_t height = gjk2_cross(w, step);
    if (height < 0) {  // Step 3
      s->d = gjk2_outward(step);
      s->along = height;
      return false;
    }
    // Most edges are farther by a rough bound.
    const bool lower = (uint64_t)height < gjk_umul32(n->above, gjk2_length_bound(step)) &&
                       keep_lower(n, step, (uint64_t)height, false);
    if (lower) {
      set_corner(rim_a, rim_b, w, &n->edge->p);
    }
    w = gjk2_add(w, step);
    //@ assert w.x >= -(INT32_C(3) << 29) && w.x <= INT32_C(3) << 29;
    //@ assert w.y >= -(INT32_C(3) << 29) && w.y <= INT32_C(3) << 29;
    if (comes >= 0) {
      advance(rim_a, false);
    }
    if (comes <= 0) {
      advance(rim_b, true);
    }
    if (lower) {
      set_corner(rim_a, rim_b, w, &n->edge->q);
    }
  }
  return true;
}

gjk2_lie gjk2_nearest_edge(gjk2_search *s, gjk2_edge *edge) {
#if GJK_64_BIT && !GJK_SMALL
  const gjk2_lie lie = gjk2_boxes_edge(s, edge);
  if (lie != GJK2_LIE_OPEN) {
    return lie;
  }
#endif
  // Step 1. The nearest edge mostly lies towards the other centre. Start 27 degrees before it: an edge that
  // separates comes soon then, and few edges lie lower than those before them.
  const gjk2_vec d = gjk2_negate(s->delta);
  gjk2_vec begin = {d.x + gjk_sar32(d.y, 1), d.y - gjk_sar32(d.x, 1)};
  if ((begin.x | begin.y) == 0) {
    begin.x = 1;
  }
  rim a, b;
  nearest_so_far n = {edge, 0, 0, UINT32_MAX, false, false};
  start_list(&a, s->a);
  start_list(&b, s->b);
#if !GJK_SMALL
  if (a.corner != NULL && b.corner != NULL) {
    return measure_listed(s, &a, &b, begin, &n) ? GJK2_LIE_OVERLAP : GJK2_LIE_APART;
  }
#endif
  if (!measure_rims(s, &a, &b, begin, &n)) {
    return GJK2_LIE_APART;
  }
  // If a hull with area has no edge with the origin on its right, it holds the origin. Then the foot on the nearest
  // edge's line is on the edge. A hull without area may have the origin in its line but beyond its ends.
  if (!n.found) {
    return GJK2_LIE_OPEN;
  }
  const int64_t part = -gjk2_dot(edge->p.w, gjk2_sub(edge->q.w, edge->p.w));
  return part >= 0 && (uint64_t)part <= edge->length.squared ? GJK2_LIE_OVERLAP : GJK2_LIE_OPEN;
}
