// A query's search that remembers. The steps are told in gjk_search.h.
#include "gjk_search.h"

// The vertices of one shape that were seen. Bit i of *seen marks the vertices i 2^shift to (i + 1) 2^shift - 1.
typedef struct seen_vertices {
  const gjk_collider *collider;
  gjk_marks *seen;
  uint32_t count;
  uint8_t shift;
  bool level;         // of a shape made of half axes: they are the vertex `first` and all that differ from it along
  uint8_t first, in;  // the half axes of which a bit is set here
} seen_vertices;

// side: 0 for A, 1 for B.
static seen_vertices seen_vertices_of(gjk_iteration *it, unsigned side) {
  const gjk_collider *c = side == 0 ? it->a : it->b;
  const uint32_t count = c->shape->type->kind == GJK_KIND_AXES ? UINT32_C(1) << c->count : c->count;
  seen_vertices of = {c, &it->seen[side], count, 0, false, 0, 0};
  while (GJK_SHAPES >= GJK_SHAPES_POLYTOPES &&
         (count - 1) >> of.shift >= GJK_MARKS) {  // count <= 2^16: at most 10 times
    of.shift++;
  }
  return of;
}

// The bit that marks a vertex. The mask changes nothing: shift leaves numbers below GJK_MARKS.
static unsigned mark_number(const seen_vertices *of, uint32_t vertex) {
  return (GJK_SHAPES >= GJK_SHAPES_POLYTOPES ? vertex >> of->shift : vertex) & (GJK_MARKS - 1);
}

// Marks a vertex as seen. Returns whether its mark is new.
static bool mark_vertex(const seen_vertices *of, uint16_t vertex) {
  const gjk_marks before = *of->seen, bit = (gjk_marks)((gjk_marks)1 << mark_number(of, vertex));
  *of->seen |= bit;
  return *of->seen != before;
}

// The first seen vertex numbered v or more. of->count: there is none.
static uint32_t next_seen(const seen_vertices *of, uint32_t v) {
  while (v < of->count && (*of->seen >> mark_number(of, v) & 1u) == 0) {
    v++;
  }
  return v;
}

// The vertex of a collider farthest along a direction so far.
typedef struct farthest_vertex {
  const gjk_collider *collider;
  const gjk_vec3 *d;               // rounded
  const gjk_direction *direction;  // exact
  int64_t along;                   // offset . d
  int64_t slack;                   // within which products with d do not tell which vertex is farther
  gjk_vec3 offset;
  uint16_t vertex;
} farthest_vertex;

// Takes the vertex for the best if it is strictly farther along the exact direction.
static void compare_vertex(farthest_vertex *best, uint16_t vertex) {
  gjk_vec3 offset = {0, 0, 0};
  best->collider->shape->type->vertex(best->collider, vertex, &offset);
  const int64_t along = gjk_dot(best->d, &offset);  // |d| <= 3 2^29, |offset| <= 2^28:  |along| < 2^59
  if (along < best->along - best->slack) {
    return;
  }
  if (along <= best->along + best->slack) {
    const gjk_vec3 step = gjk_sub(offset, best->offset);
    if (gjk_direction_sign(best->direction, &step) <= 0) {
      return;
    }
  }
  best->along = along;
  best->offset = offset;
  best->vertex = vertex;
}

// farthest_seen of level vertices: each half axis leads on or back by itself.
static uint16_t farthest_level(const seen_vertices *of, const gjk_vec3 *d, const gjk_direction *direction) {
  unsigned vertex = of->first;
  for (unsigned k = 0; k < of->collider->count; k++) {
    const gjk_vec3 *axis = &of->collider->frame[k];
    if ((of->in >> k & 1) != 0) {
      const int64_t along = gjk_dot(d, axis), slack = gjk_norm1(*axis);  // each component of d is off by less than 1
      const bool on = along > slack || (along >= -slack && gjk_direction_sign(direction, axis) > 0);
      vertex |= (on ? 1u : 0u) << k;
    }
  }
  return (uint16_t)vertex;
}

// The seen vertex farthest along the exact direction; among equals the first.
// Each component of d is off by less than 1, and two vertices are at most 2 core_radius apart. So products with d order
// two vertices wrongly only within 2 sqrt(3) core_radius, which is less than slack.
static uint16_t farthest_seen(const seen_vertices *of, const gjk_vec3 *d, const gjk_direction *direction) {
  const gjk_collider *c = of->collider;
  if (!GJK_SMALL && of->level) {
    return farthest_level(of, d, direction);  // the same one, sooner
  }
  farthest_vertex best = {c, d, direction, -(INT64_C(1) << 62), 4 * (int64_t)c->core_radius, {0, 0, 0}, 0};
#if GJK_SHAPES <= GJK_SHAPES_BOXES
  for (unsigned v = 0; v < of->count; v++) {  // at most GJK_MARKS
    if ((*of->seen >> v & 1) != 0) {
      compare_vertex(&best, (uint16_t)v);
    }
  }
#else
  uint32_t first = 0;
  for (uint64_t rest = *of->seen; rest != 0; rest >>= 1) {  // at most GJK_MARKS
    const uint32_t end = first + (UINT32_C(1) << of->shift);
    for (uint32_t v = first; (rest & 1u) != 0 && v < end && v < of->count; v++) {
      compare_vertex(&best, (uint16_t)v);
    }
    first = end;
  }
#endif
  return best.vertex;
}

// Adds the difference of seen vertices that is farthest along the direction from the feature to the origin.
// NONE: that is no nearer, or the origin lies on the feature.
static gjk_step add_farthest_seen(gjk_iteration *it, const seen_vertices *a, const seen_vertices *b) {
  gjk_direction direction;
  if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
    return GJK_STEP_NONE;
  }
  const gjk_vec3 opposite = gjk_negate(it->direction.d);
  gjk_simplex_exact_direction(&it->simplex, &direction);
  const uint16_t of_a = farthest_seen(a, &it->direction.d, &direction);
  direction.opposite = true;
  gjk_iteration_place(it, of_a, farthest_seen(b, &opposite, &direction));
  return gjk_simplex_add(&it->simplex);
}

// A candidate for the answer: the simplex of up to four differences of seen vertices. The chains are ordered like
// words: by the vertices of A and B of the first difference, then of the second, and so on.
typedef struct vertex_chain {
  uint16_t a[4], b[4];
  uint8_t last;  // index of the last difference; it stands in the simplex slot of the same index
} vertex_chain;

// Must the chain be tried? Other chains have no answer that these miss:
// The nearest point of A - B is a point of A less a point of B, each spanned by vertices of its shape. Five vertices in
// all suffice to span both (Kirchberger 1903). Take as few as do; then no other two points spanned by them have this
// difference. The differences of these vertices form a prism. The chains in which no number falls and at most three
// rise cut the prism into simplices, and one of them holds the point.
// In a far frame differences are rounded one by one, so the above does not hold: any three may be needed.
static bool is_chain_needed(const gjk_iteration *it, const vertex_chain *c) {
  unsigned rises = 0;
  if (it->shift < 0) {
    return c->last < 3;
  }
  for (unsigned i = 0; i < c->last; i++) {
    if (c->b[i + 1] < c->b[i]) {
      return false;
    }
    rises += (c->a[i + 1] > c->a[i] ? 1u : 0u) + (c->b[i + 1] > c->b[i] ? 1u : 0u);
  }
  return rises <= 3;
}

// Makes the chain the simplex. ENCLOSING: it holds the origin. NEARER: it is the nearest feature of all differences of
// seen vertices. NONE: neither.
static gjk_step try_chain(gjk_iteration *it, const seen_vertices *a, const seen_vertices *b, const vertex_chain *c) {
  gjk_simplex *s = &it->simplex;
  const unsigned length = c->last + 1u;
  s->count = (uint8_t)c->last;
  for (uint8_t i = 0; i < 4; i++) {
    s->order[i] = i;
  }
  gjk_iteration_place(it, c->a[c->last], c->b[c->last]);
  if (gjk_simplex_encloses(s, length)) {
    s->count = (uint8_t)length;
    return GJK_STEP_ENCLOSING;
  }
  if (length == 4 || !gjk_simplex_set(s, length)) {
    return GJK_STEP_NONE;
  }
  return add_farthest_seen(it, a, b) == GJK_STEP_NONE ? GJK_STEP_NEARER : GJK_STEP_NONE;
}

// Moves on to the next pair of seen vertices, in the order of the chains. False: there is none.
static bool next_seen_pair(const seen_vertices *a, const seen_vertices *b, uint16_t *of_a, uint16_t *of_b) {
  uint32_t next = next_seen(b, *of_b + UINT32_C(1));
  if (next == b->count) {
    next = next_seen(a, *of_a + UINT32_C(1));
    if (next == a->count) {
      return false;
    }
    *of_a = (uint16_t)next;
    next = next_seen(b, 0);
  }
  *of_b = (uint16_t)next;
  return true;
}

// Step 2 by trying all chains in order: of k and l seen vertices there are less than (k l)^4.
static gjk_step try_all_chains(gjk_iteration *it, const seen_vertices *a, const seen_vertices *b) {
  vertex_chain c;
  c.last = 0;
  c.a[1] = c.a[2] = c.a[3] = c.b[1] = c.b[2] = c.b[3] = 0;
  c.a[0] = (uint16_t)next_seen(a, 0);
  c.b[0] = (uint16_t)next_seen(b, 0);
  for (;;) {  // each chain once; one of them is the answer
    if (is_chain_needed(it, &c)) {
      const gjk_step step = try_chain(it, a, b, &c);
      if (step != GJK_STEP_NONE) {
        return step;
      }
      if (c.last < 3) {
        c.a[c.last + 1] = c.a[c.last];
        c.b[c.last + 1] = c.b[c.last];
        c.last++;
      }
    }
    while (!next_seen_pair(a, b, &c.a[c.last], &c.b[c.last])) {
      if (c.last == 0) {
        return GJK_STEP_NONE;  // not reached: one of the chains is the answer
      }
      c.last--;
    }
  }
}

// Step 2. ENCLOSING: the origin lies in the simplex.
static gjk_step nearest_of_seen(gjk_iteration *it, const seen_vertices *a, const seen_vertices *b) {
  while (it->recalls < GJK_RECALLS_MAX) {
    it->recalls++;
    const gjk_step step = add_farthest_seen(it, a, b);
    if (step != GJK_STEP_NEARER) {
      return step;
    }
  }
  return try_all_chains(it, a, b);
}

// Step 1. Returns whether a mark is new.
static bool mark_feature(const gjk_iteration *it, const seen_vertices *a, const seen_vertices *b) {
  const gjk_simplex *s = &it->simplex;
  bool found = false;
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    const bool of_a = mark_vertex(a, v->a.vertex), of_b = mark_vertex(b, v->b);
    found = found || of_a || of_b;
  }
  return found;
}

// Steps 1 and 2. LIMIT: step 3 comes next.
GJK_OUT_OF_LINE static gjk_outcome mark_and_recall(gjk_iteration *it) {
  if (it->iterations == GJK_PLAIN_ITERATIONS) {
    it->seen[0] = it->seen[1] = 0;
    it->recalls = 0;
  }
  const seen_vertices a = seen_vertices_of(it, 0), b = seen_vertices_of(it, 1);
  if (!mark_feature(it, &a, &b)) {
    // A far frame rounds vertices: a seen one may be nearer than step 2 found, but by no more than the rounding.
    gjk_simplex_direction(&it->simplex, &it->direction);
    return GJK_OUTCOME_NEAREST;
  }
  return nearest_of_seen(it, &a, &b) == GJK_STEP_ENCLOSING ? GJK_OUTCOME_ENCLOSING : GJK_OUTCOME_LIMIT;
}

gjk_outcome gjk_search_on(gjk_iteration *it, gjk_goal goal, unsigned limit) {
  gjk_outcome outcome = GJK_OUTCOME_LIMIT;
  //@ dynamic_split it->simplex.count;
  while (outcome == GJK_OUTCOME_LIMIT && it->iterations < limit) {
    outcome = mark_and_recall(it);
    if (outcome == GJK_OUTCOME_LIMIT) {
      it->limit = (uint8_t)(it->iterations + 1);  // Step 3: one iteration
      outcome = gjk_iteration_run(it, goal, NULL);
    }
  }
  return outcome;
}

// Marks the vertices of a shape made of half axes that are level with one: it may move along half axes in the plane.
static void mark_level_axes(seen_vertices *of, const gjk_direction *direction, unsigned vertex) {
  unsigned in = 0;
  for (unsigned k = 0; k < of->collider->count; k++) {
    in |= (gjk_direction_sign(direction, &of->collider->frame[k]) == 0 ? 1u : 0u) << k;
  }
  const unsigned first = vertex & ~in & 7u;
  of->level = true;
  of->in = (uint8_t)in;
  of->first = (uint8_t)first;
  *of->seen = 0;
  for (unsigned v = 0; v < of->count; v++) {  // 8 at most
    *of->seen |= (gjk_marks)((gjk_marks)((v & ~in) == first ? 1u : 0u) << v);
  }
}

// Marks the vertices of a shape that are level with one at the offset.
static void mark_level(seen_vertices *of, const gjk_direction *direction, unsigned vertex, const gjk_vec3 *at) {
  if (GJK_SHAPES <= GJK_SHAPES_BOXES || of->collider->shape->type->kind == GJK_KIND_AXES) {
    mark_level_axes(of, direction, vertex);
    return;
  }
  *of->seen = 0;
  for (uint32_t v = 0; v < of->count; v++) {
    gjk_vec3 offset;
    of->collider->shape->type->vertex(of->collider, (uint16_t)v, &offset);
    const gjk_vec3 step = gjk_sub(offset, *at);
    if (gjk_direction_sign(direction, &step) == 0) {
      mark_vertex(of, (uint16_t)v);
    }
  }
}

// The level vertices of A and of B. Pre: NEAREST.
GJK_OUT_OF_LINE static void mark_all_level(gjk_iteration *it, seen_vertices of[2]) {
  const gjk_vertex *one = gjk_simplex_vertex(&it->simplex, 0);
  gjk_direction direction;
  gjk_vec3 of_b;
  of[0] = seen_vertices_of(it, 0);
  of[1] = seen_vertices_of(it, 1);
  gjk_simplex_exact_direction(&it->simplex, &direction);
  it->b->shape->type->vertex(it->b, one->b, &of_b);
  mark_level(&of[0], &direction, one->a.vertex, &one->a.offset);
  mark_level(&of[1], &direction, one->b, &of_b);
}

// The direction to the origin across a box's level face, from two of its half axes. False: no such face is level.
static bool direct_across_face(gjk_iteration *it, const seen_vertices *of) {
  const gjk_vec3 *axis = of->collider->frame;
  for (unsigned i = 0; of->level && i < 3; i++) {
    const unsigned j = gjk_next(i), both = 1u << i | 1u << j;
    gjk_long3 n = {0, 0, 0};
    if ((of->in & both) == both) {
      gjk_cross(&axis[i], &axis[j], &n);
    }
    if ((n.x | n.y | n.z) != 0) {
      if (gjk_dot_sign(&n, &gjk_simplex_vertex(&it->simplex, 0)->w) > 0) {
        gjk_cross(&axis[j], &axis[i], &n);
      }
      gjk_search_direction_of(&n, &it->direction);
      return true;
    }
  }
  return false;
}

// The feature among the level vertices that GJK finds from their first ones on. It spans the same nearest point.
static void search_level(gjk_iteration *it, const seen_vertices of[2]) {
  gjk_simplex *s = &it->simplex;
  gjk_simplex_clear(s);
  gjk_iteration_place(it, (uint16_t)next_seen(&of[0], 0), (uint16_t)next_seen(&of[1], 0));
  gjk_simplex_add(s);
  it->recalls = 0;
  nearest_of_seen(it, &of[0], &of[1]);
}

// The third corner of a triangle whose other two are the ends of a diagonal: of a box's face, or of the parallelogram of two
// edges. False: the edge is no diagonal.
static bool place_beside_diagonal(gjk_iteration *it) {
  const gjk_vertex *u = gjk_simplex_vertex(&it->simplex, 0), *v = gjk_simplex_vertex(&it->simplex, 1);
  const unsigned of_a = u->a.vertex ^ v->a.vertex, of_b = u->b ^ v->b;
  const unsigned low_a = of_a & (~of_a + 1u), low_b = of_b & (~of_b + 1u);
  if (of_a != 0 && of_b != 0) {
    return gjk_iteration_place(it, u->a.vertex, v->b);
  }
  if (GJK_SHAPES <= GJK_SHAPES_ROUND) {
    return false;
  }
  if (it->a->shape->type->kind == GJK_KIND_AXES && of_a != low_a) {
    return gjk_iteration_place(it, (uint16_t)(u->a.vertex ^ low_a), u->b);
  }
  return it->b->shape->type->kind == GJK_KIND_AXES && of_b != low_b &&
         gjk_iteration_place(it, u->a.vertex, (uint16_t)(u->b ^ low_b));
}

// Makes the diagonal a triangle with the nearest point on its border. False: it is no diagonal.
GJK_OUT_OF_LINE static bool complete_diagonal(gjk_iteration *it) {
  if (!place_beside_diagonal(it) || !gjk_simplex_widen(&it->simplex)) {
    return false;  // not widened: of parallel edges
  }
  it->diagonal = true;
  return true;
}

// gjk_search_canonical of two segments. Where they are parallel, all of A - B is level: a line, on which the second vertex is
// the farthest beyond the foot of the origin. Otherwise one feature alone holds the nearest point.
static void canonical_segments(gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  gjk_long3 n;
  gjk_cross(&it->a->frame[0], &it->b->frame[0], &n);
  if ((n.x | n.y | n.z) == 0) {
    gjk_simplex_clear(s);
    gjk_iteration_place(it, 0, 0);
    gjk_simplex_add(s);
    const gjk_vec3 *w = &gjk_simplex_vertex(s, 0)->w;  // the direction is the opposite
    gjk_iteration_place(it, gjk_dot(w, &it->a->frame[0]) < 0 ? 1 : 0, gjk_dot(w, &it->b->frame[0]) > 0 ? 1 : 0);
    gjk_simplex_add(s);
  }
}

bool gjk_search_canonical(gjk_iteration *it, bool points) {
  const gjk_simplex *s = &it->simplex;
  seen_vertices level[2];
  if (GJK_SHAPES <= GJK_SHAPES_ROUND) {
    if (s->count < 3 && (s->count == 1 || !complete_diagonal(it))) {
      canonical_segments(it);
    }
    gjk_simplex_direction(s, &it->direction);
    return true;
  }
  bool across = false;
  if (!GJK_SMALL && it->ties[0] + it->ties[1] == 2 && s->count == 3) {
    return true;  // the direction is the triangle's
  }
  if (it->ties[0] + it->ties[1] > 2 || s->count == 1 || (s->count == 2 && !complete_diagonal(it))) {
    mark_all_level(it, level);
    across = direct_across_face(it, &level[0]) || direct_across_face(it, &level[1]);
    if (!GJK_SMALL && across && !points) {
      return false;
    }
    const gjk_search_direction face = it->direction;
    search_level(it, level);
    if (across) {
      it->direction = face;
    }
  }
  if (!across) {
    gjk_simplex_direction(s, &it->direction);
  }
  return true;
}

bool gjk_search_closes(gjk_iteration *it, gjk_goal goal) {
  if (GJK_SHAPES <= GJK_SHAPES_ROUND) {
    return it->shift >= 0 && goal != GJK_GOAL_WITHIN && gjk_close_segments(it);
  }
  return gjk_search_may_close(it) && it->shift >= 0 && goal != GJK_GOAL_WITHIN && it->a->shape->type->close(it);
}

#if GJK_SMALL && GJK_SHAPES >= GJK_SHAPES_BOXES
gjk_outcome gjk_search_whole(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache) {
  return gjk_search_any(it, goal, cache, GJK_NO_LIMIT);
}
#endif

#if GJK_SHAPES <= GJK_SHAPES_POINTS
gjk_outcome gjk_search_points(gjk_iteration *it, gjk_goal goal, unsigned limit) {
  gjk_simplex *s = &it->simplex;
  const gjk_vec3 w = it->delta;
  const int64_t square = gjk_dot(&w, &w);
  const bool first = it->iterations == 0;
  s->slot[0].w = w;  // of the vertices nothing else is read
  s->order[0] = 0;
  s->toward[0][0] = square;
  s->count = 1;
  it->direction.d = gjk_negate(w);
  it->direction.exact = true;
  it->iterations = first ? 1 : 2;
  if (square == 0) {
    return GJK_OUTCOME_ENCLOSING;
  }
  if (goal == GJK_GOAL_WITHIN) {
    return gjk_iteration_near(it) ? GJK_OUTCOME_NEAR : GJK_OUTCOME_SEPARATED;
  }
  // A far pair knows that its first vertex is the nearest once it has found it again.
  return first && limit == 1 && it->shift < 0 ? GJK_OUTCOME_LIMIT : GJK_OUTCOME_NEAREST;
}
#endif
