// The edges of A - B: the steps of gjk2_edges.h.
#include "gjk2_edges.h"

#include "gjk2_hull.h"

// The boundary of one shape, from a corner to the next; of B with every offset taken negative.
typedef struct rim {
  const gjk2_collider *c;
  bool opposite;  // of B
  bool done;      // once round
  gjk2_support at, next;
  gjk2_vec step;  // from at to next; of B its negative
} rim;

static void find_next(rim *r) {
  r->done = !gjk2_hull_neighbour(r->c, &r->at, true, &r->next);
  r->step = r->opposite ? gjk2_sub(r->at.offset, r->next.offset) : gjk2_sub(r->next.offset, r->at.offset);
}

// Moves to next. Vertices may repeat, so a rim ends where its place is the first one's.
static void advance(rim *r, gjk2_vec first) {
  r->at = r->next;
  if (gjk2_equal(r->at.offset, first)) {
    r->done = true;
    return;
  }
  find_next(r);
}

// Step 1
static void start_rim(rim *r, const gjk2_collider *c, bool opposite, gjk2_vec d) {
  r->c = c;
  r->opposite = opposite;
  gjk2_hull_corner(c, opposite ? gjk2_negate(d) : d, &r->at);
  r->next = r->at;
  find_next(r);
}

// Step 2: which edge comes first? Above 0 that of a, below 0 that of b, 0 both. last: the edge before.
// Both turn from last by less than half a turn, or one of them by exactly that where its shape is a segment; then the
// other may be parallel to last, and comes first.
static int order(const rim *a, const rim *b, gjk2_vec last) {
  if (a->done || b->done) {
    return a->done ? -1 : 1;
  }
  const int64_t turn = gjk2_cross(a->step, b->step);
  if (turn != 0) {
    return turn > 0 ? 1 : -1;
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
typedef struct nearest {
  gjk2_edge *edge;
  uint64_t low, high;  // bounds of its distance, 2^-32 LSB
  uint32_t above;      // LSB, not below its distance
  bool found;
} nearest;

// Bounds of height / |length| in 2^-32 LSB. Pre: it is below 2^31.
static void bound_height(const gjk2_length *length, uint64_t height, uint64_t *low, uint64_t *high) {
  unsigned shift;
  const uint64_t quotient = gjk2_quotient(length, height, &shift);
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

// Step 4 for the edge by step from w, the vertex of A - B at a and b. Returns whether it is the nearest so far.
static bool keep_lower(nearest *n, gjk2_vec step, uint64_t height) {
  gjk2_length length;
  uint64_t low, high;
  if (n->found && height >= gjk_umul32(n->above, gjk2_length_bound(step))) {
    return false;
  }
  gjk2_length_set(&length, step);
  bound_height(&length, height, &low, &high);
  if (n->found && (low > n->high || (high >= n->low && compare_exactly(n->edge, height, &length) >= 0))) {
    return false;
  }
  n->found = true;
  n->low = low;
  n->high = high;
  n->above = (uint32_t)(high >> 32) + 1;
  n->edge->length = length;
  n->edge->height = (int64_t)height;
  return true;
}

static void set_vertex(const gjk2_search *s, const rim *a, const rim *b, gjk2_vertex *out) {
  out->w = gjk2_add(s->delta, gjk2_sub(a->at.offset, b->at.offset));
  out->of_a = a->at.offset;
  out->a = a->at.vertex;
  out->b = b->at.vertex;
}

gjk2_lie gjk2_nearest_edge(gjk2_search *s, gjk2_edge *edge) {
  // Step 1. The nearest edge mostly lies towards the other centre. Start an eighth of a turn before it: an edge that
  // separates comes soon then, and few edges lie lower than those before them.
  const gjk2_vec d = gjk2_negate(s->delta);
  gjk2_vec begin = {d.x + d.y, d.y - d.x};
  if ((begin.x | begin.y) == 0) {
    begin.x = 1;
  }
  rim a, b;
  start_rim(&a, s->a, false, begin);
  start_rim(&b, s->b, true, begin);
  const gjk2_vec first_a = a.at.offset, first_b = b.at.offset;
  gjk2_vec last = {-begin.y, begin.x};
  nearest n = {edge, 0, 0, 0, false};
  while (!a.done || !b.done) {  // at most once for each edge of A and of B
    const int comes = order(&a, &b, last);
    const bool of_a = comes >= 0, of_b = comes <= 0;
    last = !of_b ? a.step : !of_a ? b.step : gjk2_add(a.step, b.step);
    const gjk2_vec w = gjk2_add(s->delta, gjk2_sub(a.at.offset, b.at.offset));
    const int64_t height = gjk2_cross(w, last);
    if (height < 0) {  // Step 3
      s->d = gjk2_outward(last);
      s->along = height;
      return GJK2_LIE_APART;
    }
    const bool lower = keep_lower(&n, last, (uint64_t)height);
    if (lower) {
      set_vertex(s, &a, &b, &edge->p);
    }
    if (of_a) {
      advance(&a, first_a);
    }
    if (of_b) {
      advance(&b, first_b);
    }
    if (lower) {
      set_vertex(s, &a, &b, &edge->q);
    }
  }
  // A hull with area that has no edge with the origin on its right holds it, and its foot on the nearest edge's line is
  // on the edge. A hull without area may have the origin in its line but beyond its ends.
  if (!n.found) {
    return GJK2_LIE_OPEN;
  }
  const int64_t part = -gjk2_dot(edge->p.w, gjk2_sub(edge->q.w, edge->p.w));
  return part >= 0 && (uint64_t)part <= edge->length.squared ? GJK2_LIE_OVERLAP : GJK2_LIE_OPEN;
}
