// The GJK iteration of the plane.
//
// The feature is the vertex or edge of the vertices in hand that is nearest to the origin O. Its edge runs from first to
// last with O strictly on its right; the boundary of A - B runs counterclockwise.
//
//   1. Take the direction d from the feature to O: an integer vector, exact. If it is 0, the origin is a vertex.
//   2. Where a distance is asked about: stop if the feature is within it, exactly.
//   3. Support scan of both shapes: x is the vertex of A - B farthest along d.
//   4. For a yes or no: stop if the line through x across d separates O from A - B.
//   5. If x is not strictly beyond the feature along d, the feature is the nearest of A - B.
//   6. Find between which two neighbours in hand x lies: P and Q, counterclockwise P, x, Q.
//   7. The new feature is the edge P x, the edge x Q or the vertex x, by the signs of O's sides and feet. If O lies in
//      the triangle, the shapes overlap. Otherwise go on from 1.
//
// Why step 6 is enough. All vertices in hand lie on the boundary of A - B, and the nearest point f lies on the open arc
// between first and last, on O's side:
//   edge     O's foot is inside the edge, so points beyond its line are farther from O than the foot, and f is not there
//   vertex   f and x lie strictly beyond the line through the vertex v across d. The boundary beyond that line is one
//            arc, and v is one of its ends. So f and x lie on the same side of v, before the next vertex in hand, which
//            is not beyond the line
// Hence each x is new, on the arc that holds f, and the arcs that are left never hold it again. x is a corner of A - B,
// or a point within an edge of A - B to which d is normal; of such an edge at least one end is cut off unseen. So there
// are at most as many x as A - B has corners, which is at most n + m for polygons of n and m vertices. One more
// iteration finds no x, and one may be spent on what the cache holds:  n + m + 2 < GJK2_ITERATIONS_OF(n, m).
//
// The walk. If the vertices of both shapes are in order, or those of one that meets a point or segment, a walk along
// the boundary of A - B follows the first x instead. Its next edge is the next one of A or of -B, whichever turns less.
// It goes on while the next vertex is nearer to O, and ends
//   at an edge that holds O's foot, with O on its right: no other vertex lies right of it, so it is the nearest
//   at a vertex from which neither edge leads nearer: all of A - B lies between them, so it is the nearest
//   where O does not lie strictly right of the edge that leads nearer: mostly the shapes overlap. On with step 1 from x
// Distances along it fall, so it visits no vertex twice: it takes as many iterations as edges, which the bound covers.
//
// The last of these ends it at its first step or never, so iterations of a walk and of steps 1 to 7 do not add up.
// Counterclockwise (the other way round is its mirror image):
//   after a step along an edge e that leads nearer and whose foot of O is not inside, O lies strictly right of e, and its
//   direction makes an angle of 90 degrees or less with e: it points from 0 to 90 degrees to the right of e, without 0
//   the next edge f turns left from e by more than 0 and less than 180 degrees, because the boundary is convex
//   so O's direction points more than 0 and less than 270 degrees to the right of f
//   if O is on the line of f or on its left, it points 180 degrees or more to the right of f, and less than 270
//   then its angle with f is more than 90 degrees, and f does not lead nearer
//
// In a far frame, and with curved shapes, vertices are rounded. There an iteration must gain a part of a frame's unit,
// the ceiling counts, and a triangle that does not hold the origin by all three signs is none.
#include "gjk2_search.h"

// From this iteration on a curved pair's search is late: smaller gains end it.
#define LATE 32

// Makes a difference of offsets a vertex of A - B in the frame.
GJK_ONCE static gjk2_vec framed(const gjk2_search *s, gjk2_vec offset) {
  if (s->far != 0) {
    const gjk2_vec w = {gjk2_frame_far(s->a->centre.x, s->b->centre.x, offset.x, s->far),
                        gjk2_frame_far(s->a->centre.y, s->b->centre.y, offset.y, s->far)};
    //@ assert w.x >= -(INT32_C(3) << 29) && w.x <= INT32_C(3) << 29;
    //@ assert w.y >= -(INT32_C(3) << 29) && w.y <= INT32_C(3) << 29;
    return w;
  }
  return gjk2_add(s->delta, offset);
}

// Step 3
GJK_ONCE static void scan_both(const gjk2_search *s, const gjk2_vec *d, gjk2_vertex *out) {
  const gjk2_vec opposite = {-d->x, -d->y};
  s->a->shape->type->support(s->a, d, &out->a);
  s->b->shape->type->support(s->b, &opposite, &out->b);
  out->w = framed(s, gjk2_sub(out->a.offset, out->b.offset));
}

void gjk2_search_scan(const gjk2_search *s, gjk2_vec d, gjk2_vertex *out) {
  scan_both(s, &d, out);
}

bool gjk2_search_place(const gjk2_search *s, uint16_t a, uint16_t b, gjk2_vertex *out) {
  if (!s->a->shape->type->vertex(s->a, a, &out->a.offset) || !s->b->shape->type->vertex(s->b, b, &out->b.offset)) {
    return false;
  }
  out->w = framed(s, gjk2_sub(out->a.offset, out->b.offset));
  out->a.vertex = a;
  out->b.vertex = b;
  return true;
}

static void exchange_vertices(gjk2_vertex **p, gjk2_vertex **q) {
  gjk2_vertex *const kept = *p;
  *p = *q;
  *q = kept;
}

// The edge from apex to spare, or from spare to apex: O on its right, turn = apex x spare.
static void make_edge(gjk2_search *s, int64_t turn) {
  s->count = 2;
  if (turn < 0) {
    exchange_vertices(&s->first, &s->apex);
    exchange_vertices(&s->last, &s->spare);
    s->base = turn;
  } else {
    exchange_vertices(&s->last, &s->apex);
    exchange_vertices(&s->first, &s->spare);
    s->base = -turn;
  }
}

// Does the origin's foot on the line through x and p lie on p's side of x?
static bool is_ahead(const gjk2_vec *x, const gjk2_vec *p, int64_t x_squared) {
  return x_squared > gjk2_dot(*x, *p);
}

// The vertex apex, without neighbours.
static void make_apex(gjk2_search *s) {
  s->alone = true;
  s->count = 1;
  s->base = -gjk2_dot(s->apex->w, s->apex->w);
}

#if !GJK_SMALL
// Vertex i of three that a cache names, the numbers of the second above those of the first.
static bool place_cached(const gjk2_search *s, const gjk2_cache *cache, unsigned i, gjk2_vertex *out) {
  const uint16_t a = cache->a[i >> 1], b = cache->b[i >> 1];
  return gjk2_search_place(s, i == 1 ? a >> 8 : a & 0xFFu, i == 1 ? b >> 8 : b & 0xFFu, out);
}

// Loads three cached vertices, if O lies in their triangle.
static void load_triangle(gjk2_search *s, const gjk2_cache *cache) {
  if (!place_cached(s, cache, 0, s->first) || !place_cached(s, cache, 1, s->apex) ||
      !place_cached(s, cache, 2, s->last)) {
    return;
  }
  const gjk2_vec p = s->first->w, x = s->apex->w, q = s->last->w;
  const int64_t before = gjk2_cross(p, x), after = gjk2_cross(x, q), base = gjk2_cross(q, p);
  if (before >= 0 && after >= 0 && base >= 0 && (before | after | base) != 0) {
    s->count = 3;
  }
}

// Names three vertices in the room of two, where they have numbers of 8 bits.
static void keep_triangle(const gjk2_search *s, gjk2_cache *cache) {
  const gjk2_vertex *p = s->first, *x = s->apex, *q = s->last;
  if ((p->a.vertex | x->a.vertex | q->a.vertex | p->b.vertex | x->b.vertex | q->b.vertex) >> 8 == 0) {
    cache->count = 3;
    cache->a[0] = (uint16_t)(p->a.vertex | (unsigned)x->a.vertex << 8);
    cache->b[0] = (uint16_t)(p->b.vertex | (unsigned)x->b.vertex << 8);
    cache->a[1] = q->a.vertex;
    cache->b[1] = q->b.vertex;
  }
}
#endif

// Loads the cached vertices as far as they make a feature that O's foot lies on, or a triangle with O in it.
static void load_cached(gjk2_search *s, const gjk2_cache *cache) {
#if !GJK_SMALL
  if (cache->count == 3) {
    load_triangle(s, cache);
    return;
  }
#endif
  if (cache->count < 1 || cache->count > 2 || !gjk2_search_place(s, cache->a[0], cache->b[0], s->apex)) {
    return;
  }
  s->warm = true;
  make_apex(s);
  if (cache->count == 2 && gjk2_search_place(s, cache->a[1], cache->b[1], s->spare)) {
    const gjk2_vec p = s->apex->w, q = s->spare->w;
    const int64_t turn = gjk2_cross(p, q);
    if (turn != 0 && is_ahead(&p, &q, gjk2_dot(p, p)) && is_ahead(&q, &p, gjk2_dot(q, q))) {
      make_edge(s, turn);
    }
  }
}

void gjk2_search_aim(gjk2_search *s, const gjk2_cache *cache) {
  s->d = gjk2_negate(s->delta);
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && cache != NULL && !s->curved && s->far == 0) {
    if ((cache->direction[0] | cache->direction[1]) != 0) {
      s->d.x = cache->direction[0];
      s->d.y = cache->direction[1];
    }
    load_cached(s, cache);
  }
  gjk2_search_need_direction(s);
}

// Step 7 where only one vertex is in hand: with x, which is strictly nearer to O along the direction from apex.
static bool add_second(gjk2_search *s) {
  const gjk2_vec p = s->apex->w, x = s->spare->w;
  const int64_t x_squared = gjk2_dot(x, x);
  if (is_ahead(&x, &p, x_squared)) {
    const int64_t turn = gjk2_cross(p, x);
    make_edge(s, turn);
    return turn == 0 && s->far == 0;
  }
  exchange_vertices(&s->first, &s->apex);
  exchange_vertices(&s->apex, &s->spare);
  gjk2_copy_vertex(s->last, s->first);  // both neighbours are the same
  s->alone = false;
  s->base = -x_squared;
  return false;
}

// Step 6 for a vertex: makes the two neighbours in hand between which x lies first and last.
static void choose_arc(gjk2_search *s) {
  const gjk2_vec p = s->first->w;  // right of the way from first to apex lies the arc between them
  if (gjk2_cross(gjk2_sub(s->apex->w, p), gjk2_sub(s->spare->w, p)) < 0) {
    exchange_vertices(&s->last, &s->apex);
  } else {
    exchange_vertices(&s->first, &s->apex);
  }
}

// Step 7: adds x, the spare vertex, between first and last. True: the origin lies in the simplex.
static inline bool add_support(gjk2_search *s) {
  const gjk2_vec p = s->first->w, x = s->spare->w, q = s->last->w;
  const int64_t x_squared = gjk2_dot(x, x);
  const int64_t before = gjk2_cross(p, x), after = gjk2_cross(x, q);  // base of the new edges; below 0: O lies outside
  if (before < 0 && is_ahead(&x, &p, x_squared)) {
    exchange_vertices(&s->last, &s->spare);
    s->count = 2;
    s->base = before;
    return false;
  }
  if (after < 0 && is_ahead(&x, &q, x_squared)) {
    exchange_vertices(&s->first, &s->spare);
    s->count = 2;
    s->base = after;
    return false;
  }
  exchange_vertices(&s->apex, &s->spare);
  s->alone = false;
  s->base = -x_squared;
  if (before >= 0 && after >= 0 && gjk2_cross(q, p) >= 0) {
    s->count = 3;
    return true;
  }
  s->count = 1;
  return false;
}

// Step 5. Does x gain too little along d to go on? Exact of polygons in a near frame. Elsewhere the gain,
// (along - base) / |d|, must exceed |d|_1 / |d| / 8 units of the frame, or / 2 where the search is late.
static inline bool gains_nothing(const gjk2_search *s, int64_t gain) {
  return gain <= (gjk2_search_is_exact(s) ? 0 : (int64_t)(gjk2_norm1(s->d) >> (s->iterations > LATE ? 1 : 3)));
}

// Step 2. Is the feature within radius of O, and does that answer the goal?
static bool is_near(const gjk2_search *s, gjk2_goal goal) {
  return s->radius > 0 && goal <= GJK2_GOAL_WITHIN && gjk2_is_within(-s->base, s->d, s->radius);
}

// Step 4. along < 0: is the line through x more than radius away from O?
static bool line_separates(const gjk2_search *s) {
  return s->radius == 0 || !gjk2_is_within(-s->along, s->d, s->radius);
}

// The way along the boundary of a shape.
static inline void step_of(const gjk2_collider *c, const gjk2_support *from, bool following, gjk2_support *way) {
  c->shape->type->adjacent(c, from, following, way);
}

// Does the boundary come to a vertex in another direction than step, or in the opposite one?
static inline bool comes_across(const gjk2_collider *c, const gjk2_support *at, bool following, gjk2_vec step) {
  gjk2_support way;
  step_of(c, at, !following, &way);
  return gjk2_cross(way.offset, step) != 0;
}

// A vertex of a shape: at, or the one that the way leads to from there.
static inline void go_on(gjk2_support *out, const gjk2_support *at, const gjk2_support *way, bool moves) {
  if (moves) {
    out->offset = gjk2_add(at->offset, way->offset);
    out->vertex = way->vertex;
  } else {
    gjk2_copy_support(out, at);
  }
}

// The walk one way round: see the head of this file. It begins at spare. NEAREST: the feature and d are set. LIMIT: it
// is where it began; the first step leads no nearer (s->base >= 0), or O lies inside of its line (s->base < 0).
static gjk2_outcome walk_round(gjk2_search *s, bool decides, bool following) {
  gjk2_vertex *at = s->spare, *ahead = s->first;
  gjk2_support way_a, way_b;
  int64_t came = 0;  // w . step for the last step to w
  step_of(s->a, &at->a, following, &way_a);
  step_of(s->b, &at->b, following, &way_b);
  for (;;) {  // at most once for each edge of A and of B
    // Components one by one: GCC copies a vector by a call of memcpy at -Os on ARMv6-M.
    const gjk2_vec of_a = {way_a.offset.x, way_a.offset.y}, of_b = {-way_b.offset.x, -way_b.offset.y};
    const gjk2_vec w = {at->w.x, at->w.y};
    int64_t turn = following ? gjk2_cross(of_a, of_b) : gjk2_cross(of_b, of_a);
    if (GJK_64_BIT && !GJK_SMALL && turn == 0 &&
        gjk2_dot(of_a, of_b) < 0) {  // one of them a segment's, at x: the other is across d and comes first
      turn = s->a->ordered ? 1 : -1;
    }
    gjk2_vec step = of_a;
    if (turn <= 0) {
      step = turn < 0 ? of_b : gjk2_add(of_a, of_b);
    }
    const int64_t base = gjk2_dot(w, step);
    if (base >= 0) {
      s->base = base;
      if (at == s->spare) {
        return GJK2_OUTCOME_LIMIT;
      }
      s->apex = at;
      make_apex(s);
      s->d = gjk2_negate(w);
      if (!GJK_SMALL) {
        s->whole = base > 0 && came < 0;
      }
      return GJK2_OUTCOME_NEAREST;
    }
    const gjk2_vec edge = following ? step : gjk2_negate(step);
    s->base = gjk2_cross(w, edge);
    if (s->base >= 0) {
      s->base = -1;
      return GJK2_OUTCOME_LIMIT;
    }
    s->iterations++;
    s->d = gjk2_outward(edge);
    if (decides) {
      s->along = s->base;
      return GJK2_OUTCOME_SEPARATED;
    }
    ahead->w = gjk2_add(w, step);
    go_on(&ahead->a, &at->a, &way_a, turn >= 0);
    go_on(&ahead->b, &at->b, &way_b, turn <= 0);
    //@ assert ahead->w.x >= -(INT32_C(3) << 29) && ahead->w.x <= INT32_C(3) << 29;
    //@ assert ahead->w.y >= -(INT32_C(3) << 29) && ahead->w.y <= INT32_C(3) << 29;
    came = gjk2_dot(ahead->w, step);
    if (came > 0) {
      if (!GJK_SMALL) {
        s->whole =
            turn == 0 || at != s->spare ||
            (turn > 0 ? comes_across(s->b, &at->b, following, step) : comes_across(s->a, &at->a, following, step));
      }
      s->first = following ? at : ahead;
      s->last = following ? ahead : at;
      s->count = 2;
      return GJK2_OUTCOME_NEAREST;
    }
    if (turn >= 0) {
      step_of(s->a, &ahead->a, following, &way_a);
    }
    if (turn <= 0) {
      step_of(s->b, &ahead->b, following, &way_b);
    }
    gjk2_vertex *const left = at == s->spare ? s->last : at;
    at = ahead;
    ahead = left;
  }
}

// The walk from x, the spare vertex.
GJK_ONCE static gjk2_outcome walk_on(gjk2_search *s, gjk2_goal goal) {
  const gjk2_vec w = s->spare->w;
  gjk2_outcome outcome = GJK2_OUTCOME_ENCLOSING;
  bool nears = false;
  int64_t level = 0;  // above 0: no way from w is across d
  s->walks = false;
  if ((w.x | w.y) != 0) {
    const bool decides = s->radius == 0 && (goal == GJK2_GOAL_WITHIN || goal == GJK2_GOAL_DEPTH);
    // The way to O's side is likely the shorter one.
    const bool following = gjk2_cross(s->d, w) <= 0;
    outcome = walk_round(s, decides, following);
    if (outcome == GJK2_OUTCOME_LIMIT) {
      const int64_t ahead = s->base;
      outcome = walk_round(s, decides, !following);
      // No way leads nearer. Where w lies within an edge, straight across from O, O may be on its inside.
      nears = outcome == GJK2_OUTCOME_LIMIT && ahead >= 0 && s->base >= 0 && (ahead | s->base) != 0;
      level = ahead < s->base ? ahead : s->base;
    }
  }
  if (outcome == GJK2_OUTCOME_LIMIT || outcome == GJK2_OUTCOME_ENCLOSING) {
    exchange_vertices(&s->apex, &s->spare);
    make_apex(s);
    if (nears) {
      if (!GJK_SMALL) {
        s->whole = level > 0;
      }
      s->d = gjk2_negate(w);
      outcome = GJK2_OUTCOME_NEAREST;
    }
  }
  return outcome == GJK2_OUTCOME_NEAREST && is_near(s, goal) ? GJK2_OUTCOME_NEAR : outcome;
}

// Steps 3 and 4. True: the line through x separates, which answers the goal.
GJK_ONCE static bool scan_separates(gjk2_search *s, gjk2_goal goal) {
  scan_both(s, &s->d, s->spare);
  s->along = gjk2_dot(s->d, s->spare->w);
  //@ assert s->along >= -(INT64_C(9) << 59) && s->along <= INT64_C(9) << 59;
  return s->along < 0 && (goal == GJK2_GOAL_WITHIN || goal == GJK2_GOAL_DEPTH) && line_separates(s);
}

// Steps 1 to 7.
GJK_OUT_OF_LINE static gjk2_outcome iterate(gjk2_search *s, gjk2_goal goal, uint32_t limit) {
  limit = limit != GJK2_NO_LIMIT ? limit : gjk2_search_limit(s);
  while (s->iterations < limit) {
    if (s->count != 0) {
      gjk2_search_direct(s);  // Step 1
      //@ assert s->base >= -(INT64_C(9) << 58) && s->base <= INT64_C(9) << 58;
      if ((s->d.x | s->d.y) == 0) {
        return GJK2_OUTCOME_ENCLOSING;
      }
      if (is_near(s, goal)) {  // Step 2
        return GJK2_OUTCOME_NEAR;
      }
    }
    s->iterations = (uint16_t)(s->iterations + (s->iterations < UINT16_MAX));
    if (scan_separates(s, goal)) {  // Steps 3 and 4
      return GJK2_OUTCOME_SEPARATED;
    }
    if (s->count != 0 && gains_nothing(s, s->along - s->base)) {  // Step 5
      return GJK2_OUTCOME_NEAREST;
    }
    bool encloses = false;
    if (s->count == 0 || s->warm) {  // what the cache holds need not lie on the boundary: begin anew with x, which does
      s->warm = false;
      if (s->walks) {
        const gjk2_outcome outcome = walk_on(s, goal);
        if (outcome != GJK2_OUTCOME_LIMIT) {
          return outcome;
        }
      } else {
        exchange_vertices(&s->apex, &s->spare);
        make_apex(s);
      }
    } else if (s->count == 1 && s->alone) {
      encloses = add_second(s);
    } else {
      if (s->count == 1) {
        choose_arc(s);  // Step 6
      }
      encloses = add_support(s);  // Step 7
    }
    if (encloses) {
      return GJK2_OUTCOME_ENCLOSING;
    }
  }
  return GJK2_OUTCOME_LIMIT;
}

// Makes apex the one vertex of A - B, that of two points.
static inline void place_origins(gjk2_search *s) {
  if (GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_ROUND) {
    (void)gjk2_search_place(s, 0, 0, s->apex);
    return;
  }
  const gjk2_support none = {{0, 0}, 0};
  const gjk2_vec w =
      GJK_SHAPES <= GJK_SHAPES_POINTS ? framed(s, none.offset) : s->delta;  // the former in far frames, too
  gjk2_copy(&s->apex->w, &w);
  gjk2_copy_support(&s->apex->a, &none);
  gjk2_copy_support(&s->apex->b, &none);
}

// The one vertex of A - B: nothing needs to be searched.
static gjk2_outcome settle_point(gjk2_search *s, gjk2_goal goal) {
  place_origins(s);
  make_apex(s);
  s->d = gjk2_negate(s->apex->w);
  s->along = s->base;
  s->iterations = 1;
  if (s->base == 0) {
    return GJK2_OUTCOME_ENCLOSING;
  }
  if (goal == GJK2_GOAL_SIGNED || (goal == GJK2_GOAL_DISTANCE && s->radius == 0)) {
    return GJK2_OUTCOME_NEAREST;
  }
  const bool separates = line_separates(s);
  return goal == GJK2_GOAL_DISTANCE ? (separates ? GJK2_OUTCOME_NEAREST : GJK2_OUTCOME_NEAR)
         : separates                ? GJK2_OUTCOME_SEPARATED
         : goal == GJK2_GOAL_WITHIN ? GJK2_OUTCOME_NEAR
                                    : GJK2_OUTCOME_NEAREST;
}

#if GJK_64_BIT && !GJK_SMALL
// Is the pair a polygon in order and a point or segment, in a near frame? Then A - B has area, and a walk takes it all.
static inline bool is_polygon_with_ends(const gjk2_search *s) {
  const bool ends_a = s->a->shape->type->touch != NULL, ends_b = s->b->shape->type->touch != NULL;
  return s->far == 0 && ((s->a->ordered && ends_b) || (s->b->ordered && ends_a));
}
#endif

// The first of two iterations on a far pair of points, for a query that counts them: the rounded difference of the centres is
// not yet the direction of the rounded vertex.
static gjk2_outcome begin_far_point(gjk2_search *s, gjk2_goal goal) {
  place_origins(s);
  make_apex(s);
  s->along = gjk2_dot(s->d, s->apex->w);
  s->iterations = 1;
  return s->along < 0 && goal == GJK2_GOAL_WITHIN && line_separates(s) ? GJK2_OUTCOME_SEPARATED : GJK2_OUTCOME_LIMIT;
}

#if GJK_64_BIT && !GJK_SMALL
// Boxes alone have four vertices without a list.
static inline bool walks_as_boxes(const gjk2_search *s) {
  return s->a->count == 4 && s->b->count == 4 && !s->a->shape->type->buffered && !s->b->shape->type->buffered;
}

// A half axis with the sign of a vertex: plus or minus.
static inline gjk2_vec signed_half(gjk2_vec axis, bool plus) {
  const gjk2_vec other = gjk2_negate(axis);
  return plus ? axis : other;
}

// Sets a vertex of two boxes: its half axes with their signs, A's and B's.
static void set_box_corner(const gjk2_search *s, const gjk2_vec *of_a, const gjk2_vec *of_b, unsigned number_a,
                           unsigned number_b, gjk2_vertex *out) {
  out->a.offset = gjk2_add(of_a[0], of_a[1]);
  out->b.offset = gjk2_add(of_b[0], of_b[1]);
  out->a.vertex = (uint16_t)number_a;
  out->b.vertex = (uint16_t)number_b;
  out->w = gjk2_add(s->delta, gjk2_sub(out->a.offset, out->b.offset));
}

// The scan and the walk of two boxes, as far as the first edge, by half axes alone. False: the walk decides. Pre: boxes with
// area, in a near frame; nothing but the nearest feature is asked for.
GJK_OUT_OF_LINE static bool walk_boxes(gjk2_search *s) {
  const gjk2_vec d = {s->d.x, s->d.y};
  gjk2_vec a[2] = {s->a->frame[0], s->a->frame[1]}, b[2] = {s->b->frame[0], s->b->frame[1]};
  const bool a_0 = gjk2_dot(a[0], d) >= 0, a_1 = gjk2_dot(a[1], d) >= 0;
  const bool b_0 = gjk2_dot(b[0], d) <= 0, b_1 = gjk2_dot(b[1], d) <= 0;
  a[0] = signed_half(a[0], a_0);
  a[1] = signed_half(a[1], a_1);
  b[0] = signed_half(b[0], b_0);
  b[1] = signed_half(b[1], b_1);
  unsigned number_a = (a_0 ? 1u : 0u) | (a_1 ? 2u : 0u), number_b = (b_0 ? 1u : 0u) | (b_1 ? 2u : 0u);
  set_box_corner(s, a, b, number_a, number_b, s->apex);
  const gjk2_vec w = {s->apex->w.x, s->apex->w.y};
  bool following = gjk2_cross(d, w) <= 0;
  for (int i = 0; i < 2; i++, following = !following) {
    // As gjk2_class_axes.c: of corners with equal signs the next edge counterclockwise is along x.
    const unsigned ahead_a = (a_0 == a_1) == following ? 0 : 1, ahead_b = (b_0 == b_1) == following ? 0 : 1;
    const gjk2_vec of_a = gjk2_negate(a[ahead_a]), of_b = {b[ahead_b].x, b[ahead_b].y};  // half of the edges
    const int64_t turn = following ? gjk2_cross(of_a, of_b) : gjk2_cross(of_b, of_a);
    const gjk2_vec step = turn > 0 ? of_a : turn < 0 ? of_b : gjk2_add(of_a, of_b);
    const int64_t base = gjk2_dot(w, step);
    if (base > 0) {
      continue;
    }
    const int64_t side = following ? gjk2_cross(w, step) : gjk2_cross(step, w);
    const gjk2_vec end = {w.x + 2 * step.x, w.y + 2 * step.y};
    if (base == 0 || side >= 0 || gjk2_dot(end, step) <= 0) {
      return false;
    }
    // Another edge of the shape that stays, in the same direction, would be behind.
    s->whole = turn == 0 || gjk2_cross(turn > 0 ? b[1 - ahead_b] : a[1 - ahead_a], step) != 0;
    s->iterations = 2;
    s->count = 2;
    s->first = following ? s->apex : s->spare;
    s->last = following ? s->spare : s->apex;
    s->spare = &s->slot[0];
    s->apex = &s->slot[2];
    if (turn >= 0) {
      a[ahead_a] = of_a;
      number_a ^= 1u << ahead_a;
    }
    if (turn <= 0) {
      b[ahead_b] = gjk2_negate(of_b);
      number_b ^= 1u << ahead_b;
    }
    set_box_corner(s, a, b, number_a, number_b, following ? s->last : s->first);
    s->base = 2 * side;
    s->d = gjk2_outward(gjk2_sub(s->last->w, s->first->w));
    return true;
  }
  s->whole = true;
  s->iterations = 1;
  make_apex(s);
  s->d = gjk2_negate(w);
  return true;
}
#endif

gjk2_outcome gjk2_search_run(gjk2_search *s, gjk2_goal goal, uint32_t limit) {
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return s->far != 0 && limit == 1 ? begin_far_point(s, goal) : settle_point(s, goal);
  }
  if (gjk2_search_is_point(s) && limit != 0) {
    return settle_point(s, goal);
  }
  if (!GJK_SMALL && s->count == 3) {  // the cache's
    return GJK2_OUTCOME_ENCLOSING;
  }
#if GJK_64_BIT && !GJK_SMALL
  s->walks = s->walks || (limit == GJK2_NO_LIMIT && is_polygon_with_ends(s));
#endif
#if !GJK_SMALL
  // What iterate does for a cold start, without its loop.
  if (s->walks && s->count == 0) {
#if GJK_64_BIT
    if ((goal == GJK2_GOAL_DISTANCE || goal == GJK2_GOAL_SIGNED) && walks_as_boxes(s) && walk_boxes(s)) {
      return is_near(s, goal) ? GJK2_OUTCOME_NEAR : GJK2_OUTCOME_NEAREST;
    }
#endif
    s->iterations++;
    if (scan_separates(s, goal)) {
      return GJK2_OUTCOME_SEPARATED;
    }
    const gjk2_outcome outcome = walk_on(s, goal);
    if (outcome != GJK2_OUTCOME_LIMIT) {
      return outcome;
    }
  }
#endif
  return iterate(s, goal, limit);
}

// The numbers of the feature's vertices. Of three only the cache has no room, and it takes no simplex.
static inline void name_feature(const gjk2_search *s, uint16_t *a, uint16_t *b) {
  if (GJK_SHAPES <= GJK_SHAPES_POINTS || s->count == 1) {
    a[0] = s->apex->a.vertex;
    b[0] = s->apex->b.vertex;
    return;
  }
  a[0] = s->first->a.vertex;
  b[0] = s->first->b.vertex;
  if (s->count == 3) {
    *++a = s->apex->a.vertex;
    *++b = s->apex->b.vertex;
  }
  a[1] = s->last->a.vertex;
  b[1] = s->last->b.vertex;
}

void gjk2_search_certify(const gjk2_search *s, gjk2_outcome outcome, gjk2_certificate *out) {
  static const uint8_t proofs[] = {GJK2_PROOF_NEAREST, GJK2_PROOF_ENCLOSING, GJK2_PROOF_DIRECTION, GJK2_PROOF_NEAR,
                                   GJK2_PROOF_NONE};
  out->count = 0;
  out->proof = GJK2_PROOF_NONE;
  if (s->curved) {
    return;
  }
  out->proof = proofs[outcome];
  gjk2_copy(&out->direction, &s->d);
  if (outcome != GJK2_OUTCOME_SEPARATED) {
    out->count = s->count;
    name_feature(s, out->a, out->b);
  }
}

void gjk2_search_keep(const gjk2_search *s, gjk2_outcome outcome, gjk2_cache *cache) {
  if (GJK_SHAPES <= GJK_SHAPES_POINTS || s->curved || s->far != 0) {
    return;
  }
  cache->count = 0;
  cache->direction[0] = 0;
  cache->direction[1] = 0;
  if (outcome == GJK2_OUTCOME_ENCLOSING) {
#if !GJK_SMALL
    if (s->count == 3) {
      keep_triangle(s, cache);
    }
#endif
    return;
  }
  gjk2_cache_direction(cache, s->d);
  if (outcome == GJK2_OUTCOME_SEPARATED) {
    return;
  }
  cache->count = s->count;
  name_feature(s, cache->a, cache->b);
}
