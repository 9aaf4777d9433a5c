// A query's search, in iterations of GJK; see pair_search.h.
#include "gjk_search.h"

// One shape, and which of its vertices were seen: bit i stands for the vertices from i 2^shift to before (i + 1) 2^shift.
typedef struct album {
  const gjk_collider *collider;
  uint64_t *seen;
  uint32_t count;
  unsigned shift;
} album;

// side 0: of A; 1: of B.
static album open_album(gjk_iteration *it, unsigned side) {
  const gjk_collider *c = side == 0 ? it->a : it->b;
  const uint32_t count = c->shape->type->kind == GJK_KIND_AXES ? UINT32_C(1) << c->count : c->count;
  album of = {c, &it->seen[side], count, 0};
  while ((count - 1) >> of.shift >= GJK_MARKS) {  // at most 10 times
    of.shift++;
  }
  return of;
}

// The number of a vertex's mark.
static unsigned number_of(const album *of, uint32_t vertex) {
  return vertex >> of->shift & (GJK_MARKS - 1);  // no more than GJK_MARKS - 1 as it is
}

// Returns whether the mark is new.
static bool mark(const album *of, uint16_t vertex) {
  const uint64_t bit = UINT64_C(1) << number_of(of, vertex), before = *of->seen;
  *of->seen |= bit;
  return *of->seen != before;
}

// The first seen vertex from number v on; count: none.
static uint32_t next_seen(const album *of, uint32_t v) {
  while (v < of->count && (*of->seen >> number_of(of, v) & 1u) == 0) {
    v++;
  }
  return v;
}

// The farthest vertex so far along a direction.
typedef struct lead {
  const gjk_collider *collider;
  const gjk_vec3 *d;               // rounded
  const gjk_direction *direction;  // exact
  int64_t along, slack;
  gjk_vec3 offset;
  uint16_t vertex;
} lead;

static void look_at(lead *l, uint16_t vertex) {
  gjk_vec3 offset = {0, 0, 0};
  l->collider->shape->type->vertex(l->collider, vertex, &offset);
  const int64_t along = gjk_dot(l->d, &offset);  // at most 3 2^29 times sqrt(3) 2^28
  if (along < l->along - l->slack) {
    return;
  }
  if (along <= l->along + l->slack) {
    const gjk_vec3 step = gjk_sub(offset, l->offset);
    if (gjk_direction_sign(l->direction, &step) <= 0) {
      return;
    }
  }
  l->along = along;
  l->offset = offset;
  l->vertex = vertex;
}

// The seen vertex that is farthest along the exact direction; among equals the first. Each component of the rounded one is off
// by less than 1, which moves the difference of two products by less than 2 sqrt(3) core_radius.
static uint16_t farthest_seen(const album *of, const gjk_vec3 *d, const gjk_direction *direction) {
  const gjk_collider *c = of->collider;
  lead l = {c, d, direction, -(INT64_C(1) << 62), 4 * (int64_t)c->core_radius, {0, 0, 0}, 0};
  uint32_t first = 0;
  for (uint64_t rest = *of->seen; rest != 0; rest >>= 1) {  // at most GJK_MARKS
    const uint32_t end = first + (UINT32_C(1) << of->shift);
    for (uint32_t v = first; (rest & 1u) != 0 && v < end && v < of->count; v++) {
      look_at(&l, (uint16_t)v);
    }
    first = end;
  }
  return l.vertex;
}

// Adds the difference of seen vertices that is farthest along the direction from the feature to the origin. NONE: it is no
// nearer, or the origin lies on the feature.
static gjk_step recall(gjk_iteration *it, const album *a, const album *b) {
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

// Differences of seen vertices in the first slots, each after the one before: by its vertex of A, then of B.
typedef struct chain {
  uint16_t a[4], b[4];
  uint8_t last;  // the number of the last slot
} chain;

// Is the chain one to be tried? The answer is a difference of a point of A and one of B, each spanned by vertices of its shape.
// Five vertices in all suffice (Kirchberger 1903). Of the fewest that do, no other points have this difference.
// Chains in which no number falls and at most three rise cut the prism of these vertices into simplices.
// In a far frame differences are rounded, and so any three may be needed.
static bool is_candidate(const gjk_iteration *it, const chain *c) {
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

// Is the simplex of the chain the answer: does it hold the origin, or is it the nearest feature?
static gjk_step try_chain(gjk_iteration *it, const album *a, const album *b, const chain *c) {
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
  return recall(it, a, b) == GJK_STEP_NONE ? GJK_STEP_NEARER : GJK_STEP_NONE;
}

// The next pair of seen vertices. False: there is none.
static bool advance(const album *a, const album *b, uint16_t *of_a, uint16_t *of_b) {
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

// Makes the feature the nearest over all differences of seen vertices by trying all: k and l of them have less than (k l)^4
// chains.
static gjk_step try_all(gjk_iteration *it, const album *a, const album *b) {
  chain c;
  c.last = 0;
  c.a[1] = c.a[2] = c.a[3] = c.b[1] = c.b[2] = c.b[3] = 0;
  c.a[0] = (uint16_t)next_seen(a, 0);
  c.b[0] = (uint16_t)next_seen(b, 0);
  for (;;) {  // each chain once, and one of them is the answer
    if (is_candidate(it, &c)) {
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
    while (!advance(a, b, &c.a[c.last], &c.b[c.last])) {
      if (c.last == 0) {
        return GJK_STEP_NONE;  // not reached: see above
      }
      c.last--;
    }
  }
}

// Step 2 of pair_search.h. ENCLOSING: the origin lies in the simplex.
static gjk_step recall_all(gjk_iteration *it, const album *a, const album *b) {
  while (it->recalls < GJK_RECALLS_MAX) {
    it->recalls++;
    const gjk_step step = recall(it, a, b);
    if (step != GJK_STEP_NEARER) {
      return step;
    }
  }
  return try_all(it, a, b);
}

// Marks the vertices of the feature. Returns whether a mark is new.
static bool mark_feature(const gjk_iteration *it, const album *a, const album *b) {
  const gjk_simplex *s = &it->simplex;
  bool found = false;
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    const bool of_a = mark(a, v->a.vertex), of_b = mark(b, v->b);
    found = found || of_a || of_b;
  }
  return found;
}

// 1 and 2 of pair_search.h. LIMIT: a round of GJK comes next.
GJK_OUT_OF_LINE static gjk_outcome remember(gjk_iteration *it) {
  if (it->iterations == GJK_PLAIN_ITERATIONS) {
    it->seen[0] = it->seen[1] = 0;
    it->recalls = 0;
  }
  const album a = open_album(it, 0), b = open_album(it, 1);
  if (!mark_feature(it, &a, &b)) {
    // In a far frame alone, where vertices are rounded: another one is nearer by no more than that.
    gjk_simplex_direction(&it->simplex, &it->direction);
    return GJK_OUTCOME_NEAREST;
  }
  return recall_all(it, &a, &b) == GJK_STEP_ENCLOSING ? GJK_OUTCOME_ENCLOSING : GJK_OUTCOME_LIMIT;
}

gjk_outcome gjk_search_on(gjk_iteration *it, gjk_goal goal, unsigned limit) {
  gjk_outcome outcome = GJK_OUTCOME_LIMIT;
  //@ dynamic_split it->simplex.count;
  while (outcome == GJK_OUTCOME_LIMIT && it->iterations < limit) {
    outcome = remember(it);
    if (outcome == GJK_OUTCOME_LIMIT) {
      it->limit = (uint8_t)(it->iterations + 1);
      outcome = gjk_iteration_run(it, goal, NULL);
    }
  }
  return outcome;
}
