// GJK on one pair: the loop that every query runs.
//
// The simplex holds the feature so far: of the vertices of A - B that were added, the vertex, edge or triangle nearest
// to the origin. Each iteration is one support scan of both shapes.
//
//   Step 1   Start: add the cached vertices to the simplex, as far as they still make a feature. If there are none, the
//            first direction is the cached one, or that from A's centre to B's.
//   Then each iteration:
//   Step 2   Take the search direction d, from the feature to the origin, rounded. If d is zero: ENCLOSING.
//   Step 3   If the goal allows NEAR, and the feature is within the radius: NEAR.
//   Step 4   Support scan: w is the vertex of A - B farthest along d.
//   Step 5   If the goal allows SEPARATED, and even w is more than the radius away along d: SEPARATED.
//   Step 6   If w is a vertex of the feature, skip step 7: w cannot be nearer.
//   Step 7   Add w if it is strictly nearer to the origin than the feature, along the exact direction. The feature
//            becomes the nearest one with w. If the origin lies in the simplex: ENCLOSING. Otherwise the next iteration
//            begins.
//   Step 8   If w is no nearer, rounding d may have hidden a nearer vertex. Scan again along the exact direction, and
//            add what that finds as in step 7.
//   Step 9   If still nothing is nearer, the feature is the nearest of A - B: NEAREST. If the goal is WITHIN and the
//            exact distance is at most the radius: NEAR.
//   Step 10  If the limit on iterations is reached: LIMIT. A later call goes on at step 2.
//
// Each feature is strictly nearer than the last, so none returns, every simplex is non-degenerate, and the loop ends.
//
// After   Gilbert, Johnson, Keerthi 1988; steps 3 and 5 as in Gino van den Bergen, A Fast and Robust GJK
//         Implementation, 1999. Departures: the signs in step 7 are exact, and the progress is strict; step 8.
#include "gjk_frame.h"

// From this iteration on a search of curved shapes counts as late: stalls then asks for more progress. Random pairs
// take at most 51 iterations.
#define LATE_ITERATIONS 64

bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius) {
  it->a = a;
  it->b = b;
  if (!gjk_frame_set(it, gjk_goal_separates(goal), radius)) {
    return false;
  }
  it->iterations = 0;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND) {  // gjk_search_points sets all that is read
    it->diagonal = false;
    gjk_simplex_clear(&it->simplex);
  }
  if (!GJK_SMALL) {
    it->scans = false;
  }
  if (GJK_SHAPES >= GJK_SHAPES_ALL) {
    it->stalls = a->shape->type->stalls;
    if (!gjk_pair_is_curved(it)) {
      it->stalls = b->shape->type->stalls;
    }
  }
  return true;
}

// Completes a vertex of A - B, whose vertex of A is set, by the vertex b of B.
GJK_ONCE static void complete_vertex(const gjk_iteration *it, gjk_vertex *v, const gjk_support *b) {
  v->b = b->vertex;
  gjk_frame_move(it, gjk_sub(v->a.offset, b->offset), &v->w);
}

bool gjk_iteration_place(gjk_iteration *it, uint16_t a, uint16_t b) {
  gjk_vertex *v = gjk_simplex_free(&it->simplex);
  gjk_support of_b;
  v->a.vertex = a;
  of_b.vertex = b;
  if (!it->a->shape->type->vertex(it->a, a, &v->a.offset) || !it->b->shape->type->vertex(it->b, b, &of_b.offset)) {
    return false;
  }
  complete_vertex(it, v, &of_b);
  return true;
}

// Step 4: the support scan of both shapes. Returns the vertex in the free slot.
GJK_ONCE static const gjk_vertex *next_vertex(gjk_iteration *it, gjk_support *b) {
  const gjk_vec3 opposite = gjk_negate(it->direction.d);
  gjk_vertex *added = gjk_simplex_free(&it->simplex);
  it->a->shape->type->support(it->a, &it->direction.d, &added->a);
  it->b->shape->type->support(it->b, &opposite, b);
  complete_vertex(it, added, b);
  return added;
}

void gjk_iteration_next(gjk_iteration *it, gjk_support *b) {
  next_vertex(it, b);
}

bool gjk_iteration_refine(gjk_iteration *it, gjk_direction *direction, gjk_support *b) {
  bool moved = false;
  gjk_vertex *added = gjk_simplex_free(&it->simplex);
  if (it->a->shape->type->refine != NULL) {
    moved = it->a->shape->type->refine(it->a, &it->direction.d, direction, &added->a);
    it->ties[0] = direction->ties;
    if (direction->spanning == 1 && direction->ties == 0) {
      it->ties[1] = 0;  // a vertex is one difference, unless both shapes have an edge across the direction
      return moved;
    }
  }
  if (it->b->shape->type->refine != NULL) {
    const gjk_vec3 opposite = gjk_negate(it->direction.d);
    direction->opposite = true;
    if (!GJK_SMALL && direction->level != NULL) {
      direction->level += 3;
    }
    moved = it->b->shape->type->refine(it->b, &opposite, direction, b) || moved;
    it->ties[1] = direction->ties;
  }
  if (moved) {
    complete_vertex(it, added, b);
  }
  return moved;
}

// Do two vertices of A - B share their vertex of A or of B?
static inline bool share_vertex(const gjk_vertex *v, const gjk_vertex *w) {
#if GJK_CONDITIONAL_MOVES
  return ((uint32_t)v->a.vertex ^ w->a.vertex) * ((uint32_t)v->b ^ w->b) == 0;  // both are below 2^16
#else
  return v->a.vertex == w->a.vertex || v->b == w->b;
#endif
}

// The vertices of A and then of B in an edge or a triangle, if all of A are equally far along its exact direction, and
// all of B. The differences are. Where two of them share a vertex of one shape, so are their vertices of the other.
// False: two of three, or the two of an edge, share none; or differences are rounded, or have no numbers.
static bool level_vertices(const gjk_iteration *it, uint16_t level[6]) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *u = &s->slot[s->order[0]], *v = &s->slot[s->order[1]];
  const gjk_vertex *w = s->count == 3 ? &s->slot[s->order[2]] : v;
  level[0] = u->a.vertex;
  level[1] = v->a.vertex;
  level[2] = w->a.vertex;
  level[3] = u->b;
  level[4] = v->b;
  level[5] = w->b;
  const bool of_uv = share_vertex(u, v);
#if GJK_CONDITIONAL_MOVES
  const bool two = (of_uv ? 1 : 0) + (share_vertex(v, w) ? 1 : 0) + (share_vertex(u, w) ? 1 : 0) >= 2;
#else
  const bool two = of_uv ? share_vertex(v, w) || share_vertex(u, w) : share_vertex(v, w) && share_vertex(u, w);
#endif
  return two && it->shift >= 0 && !gjk_pair_is_curved(it);
}

// Step 8: replaces w by the vertex farthest along the exact direction. Returns whether that is another one. An exact
// direction hides none, so it only counts ties, if the goal counts them.
static inline bool refine_nearest(gjk_iteration *it, gjk_goal goal, gjk_support *b) {
  gjk_direction direction;
  uint16_t level[6];
  if (!gjk_goal_counts_ties(it, goal) && it->direction.exact) {
    return false;
  }
  gjk_simplex_exact_direction(&it->simplex, &direction);
  if (!GJK_SMALL && it->simplex.count > 1 && level_vertices(it, level)) {
    direction.level = level;
  }
  return gjk_iteration_refine(it, &direction, b);
}

bool gjk_iteration_near(const gjk_iteration *it) {
  const gjk_simplex *s = &it->simplex;
  gjk_u192 numerator, denominator;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS || s->count == 1) {
    return s->toward[s->order[0]][s->order[0]] <= gjk_mul32(it->radius, it->radius);
  }
  gjk_simplex_squared_distance(s, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)it->radius * 2) <= 0;
}

// Does the plane across d through w lie before the origin, by more than the radius? Its distance is -d . w / |d|:
// (d . w)^2 > radius^2 |d|^2.
static bool plane_clears_radius(const gjk_iteration *it, const gjk_vec3 *w) {
  const gjk_vec3 d = it->direction.d;
  const int32_t radius = it->radius;
  const int64_t along = gjk_dot(&d, w);  // |d| <= sqrt(3) 2^30, |w| <= 3 2^29:  |along| < 2^62
  if (radius == 0) {
    return along < 0;
  }
  // radius^2 < 2^62, |d|^2 <= 3 2^60
  return along < 0 && gjk_sum_of_products_sign(along, along, -gjk_mul32(radius, radius), gjk_dot(&d, &d)) > 0;
}

// Step 3: is the feature within the radius? Exact. The plane across d, a lower bound of the distance, spares most edges
// and triangles from being measured.
static bool settles_near(const gjk_iteration *it) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *v = &s->slot[s->order[0]];
  return (s->count == 1 || !plane_clears_radius(it, &v->w)) && gjk_iteration_near(it);
}

#if GJK_CONDITIONAL_MOVES

// 0 where two vertices of A - B have the same numbers; otherwise below 2^16.
static inline uint64_t vertices_differ(const gjk_vertex *v, const gjk_vertex *w) {
  return (uint64_t)((unsigned)(v->a.vertex ^ w->a.vertex) | (unsigned)(v->b ^ w->b));
}

#endif

// Step 6: is w a vertex of the feature? Of a curved pair: does w gain too little over the feature to go on? The signs
// of step 7 would reject a vertex of the feature as well, at a higher cost.
static bool is_duplicate(const gjk_iteration *it, const gjk_vertex *added) {
  const gjk_simplex *s = &it->simplex;
  if (gjk_pair_is_curved(it) && s->count > 0) {
    return it->stalls(&it->direction.d, &s->slot[s->order[0]].w, &added->w, it->shift,
                      it->iterations >= LATE_ITERATIONS);
  }
#if GJK_CONDITIONAL_MOVES
  // One condition for all of them: which it is would be a guess.
  if (s->count == 0) {
    return false;
  }
  const gjk_vertex *u = &s->slot[s->order[0]], *v = &s->slot[s->order[s->count > 1 ? 1 : 0]],
                   *w = &s->slot[s->order[s->count > 2 ? 2 : 0]];
  return vertices_differ(u, added) * vertices_differ(v, added) * vertices_differ(w, added) == 0;  // below 2^48
#else
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    if (v->a.vertex == added->a.vertex && v->b == added->b) {
      return true;
    }
  }
  return false;
#endif
}

// Takes the direction of the cache. False: it has none.
static bool cached_direction(gjk_iteration *it, const gjk_cache *cache) {
  gjk_vec3 *d = &it->direction.d;
  d->x = cache->direction[0];
  d->y = cache->direction[1];
  d->z = cache->direction[2];
  it->direction.exact = true;
  return (d->x | d->y | d->z) != 0;
}

// Step 1: the first direction, where no vertex was cached.
static void first_direction(gjk_iteration *it, const gjk_cache *cache) {
  gjk_vec3 *d = &it->direction.d;
  if (cache != NULL && cached_direction(it, cache)) {
    return;
  }
  it->direction.exact = true;
  *d = gjk_negate(it->delta);
  if ((d->x | d->y | d->z) == 0) {
    d->x = 1;
  }
}

// The bits of half axes without a length. Support scans set them; a cache may name the other vertex of the two.
static unsigned empty_axes(const gjk_collider *c) {
  unsigned bits = 0;
  if (c->shape->type->kind == GJK_KIND_AXES) {
    for (unsigned i = 0; i < c->count; i++) {
      const gjk_vec3 *axis = &c->frame[i];
      bits |= (axis->x | axis->y | axis->z) == 0 ? 1u << i : 0;
    }
  }
  return bits;
}

// Step 1: adds the cached vertices. Returns whether they enclose the origin; then the direction is that of the last edge, which
// they began with. Where the origin lies on a vertex or an edge, no other vertex is nearer, and step 2 finds that.
static bool warm_start(gjk_iteration *it, const gjk_cache *cache) {
  const unsigned empty_a = empty_axes(it->a), empty_b = empty_axes(it->b);
  gjk_simplex *s = &it->simplex;
#if !GJK_SMALL
  unsigned a = 0, b = 0;  // of the last edge; the vertices that make it a triangle or a tetrahedron leave their slots
#endif
  //@ dynamic_split it->simplex.count;
  for (unsigned i = 0; i < cache->count && i < 4; i++) {
    const gjk_step step = gjk_iteration_place(it, (uint16_t)(cache->a[i] | empty_a), (uint16_t)(cache->b[i] | empty_b))
                              ? gjk_simplex_add(s)
                              : GJK_STEP_NONE;
#if GJK_SMALL
    if (step == GJK_STEP_ENCLOSING ||
        (step == GJK_STEP_NEARER && s->count < 3 && !gjk_simplex_direction(s, &it->direction))) {
      return true;
    }
  }
#else
    if (step == GJK_STEP_ENCLOSING) {
      gjk_search_direction_of_edge(&s->slot[a].w, s->toward[b][a], &s->slot[b].w, s->toward[a][b], &it->direction);
      return true;
    }
    if (s->count < 3 && s->count > 0) {
      a = s->order[0];
      b = s->order[s->count - 1];
    }
  }
#endif
  return false;
}

#if GJK_SHAPES <= GJK_SHAPES_ROUND
bool gjk_iteration_warm(gjk_iteration *it, const gjk_cache *cache) {
  return it->shift >= 0 && warm_start(it, cache);
}
#endif

// Steps 6 to 8. NONE: nothing of A - B is nearer than the feature.
static gjk_step add_vertex(gjk_iteration *it, gjk_goal goal, const gjk_vertex *added, gjk_support *b) {
  if (!is_duplicate(it, added)) {
    const gjk_step step = gjk_simplex_add(&it->simplex);
    if (step != GJK_STEP_NONE) {
      return step;
    }
  }
  return refine_nearest(it, goal, b) ? gjk_simplex_add(&it->simplex) : GJK_STEP_NONE;
}

// The iteration of a cached edge or triangle, which mostly is the nearest still: of steps 4 to 8, step 8 alone, from one of its
// vertices. LIMIT: it is not. The direction of a vertex is exact, and step 8 may then leave B out.
static inline gjk_outcome confirm_feature(gjk_iteration *it, gjk_goal goal, gjk_support *b) {
  const gjk_vertex *v = &it->simplex.slot[it->simplex.order[0]];
  gjk_vertex *added = gjk_simplex_free(&it->simplex);
  if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
    return GJK_OUTCOME_ENCLOSING;
  }
  if (it->radius > 0 && gjk_goal_nears(goal) && settles_near(it)) {
    return GJK_OUTCOME_NEAR;
  }
  gjk_set(&v->a.offset, &added->a.offset);
  added->a.vertex = v->a.vertex;
  b->vertex = v->b;
  it->b->shape->type->vertex(it->b, v->b, &b->offset);
  const gjk_step step = refine_nearest(it, goal, b) ? gjk_simplex_add(&it->simplex) : GJK_STEP_NONE;
  it->iterations++;
  return step == GJK_STEP_ENCLOSING ? GJK_OUTCOME_ENCLOSING
         : step == GJK_STEP_NEARER  ? GJK_OUTCOME_LIMIT
                                    : GJK_OUTCOME_NEAREST;
}

// May a refinement begin at any vertex?
static bool refines_from_any(const gjk_collider *c) {
  return GJK_CONDITIONAL_MOVES || c->shape->type->kind != GJK_KIND_AXES;
}

gjk_outcome gjk_iteration_run(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache) {
  gjk_support b;
  // The vertices of far frames and of curved shapes are rounded: where the search ends would depend on where it began.
  // So the cache does not count.
  if (GJK_SHAPES <= GJK_SHAPES_ROUND || it->shift < 0 || gjk_pair_is_curved(it)) {
    cache = NULL;
  }
  if (cache != NULL && warm_start(it, cache)) {
    return GJK_OUTCOME_ENCLOSING;
  }
  if (!GJK_SMALL && cache != NULL && !it->scans && it->simplex.count > 1 && !gjk_goal_separates(goal) &&
      refines_from_any(it->a) && refines_from_any(it->b)) {
    const gjk_outcome outcome = confirm_feature(it, goal, &b);
    if (outcome != GJK_OUTCOME_LIMIT) {
      return outcome;
    }
  }
  //@ dynamic_split it->simplex.count;
  for (; it->iterations < it->limit; it->iterations++) {
    // Step 2: the search direction. Step 3: the feature is near.
    if (it->simplex.count == 0) {
      first_direction(it, cache);
    } else if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
      return GJK_OUTCOME_ENCLOSING;
    } else if (it->radius > 0 && gjk_goal_nears(goal) && settles_near(it)) {
      return GJK_OUTCOME_NEAR;
    }
    // Step 4: the support scan.
    const gjk_vertex *added = next_vertex(it, &b);
    // Step 5: the whole of A - B is beyond the radius.
    if (gjk_goal_separates(goal) && plane_clears_radius(it, &added->w)) {
      it->iterations++;
      return GJK_OUTCOME_SEPARATED;
    }
    // Steps 6 to 8: the vertex makes a nearer feature, or none does.
    const gjk_step step = add_vertex(it, goal, added, &b);
    if (step != GJK_STEP_NEARER) {
      it->iterations++;
      if (step == GJK_STEP_ENCLOSING) {
        return GJK_OUTCOME_ENCLOSING;
      }
      // Step 9: steps 3 and 5 use the rounded direction, so a distance this close to the radius passes both. Compare
      // the exact one.
      return goal == GJK_GOAL_WITHIN && it->radius > 0 && gjk_iteration_near(it) ? GJK_OUTCOME_NEAR
                                                                                 : GJK_OUTCOME_NEAREST;
    }
  }
  // Step 10: the limit.
  return GJK_OUTCOME_LIMIT;
}

// Writes the vertex numbers of the feature that proves the outcome. Returns how many: 0 for a curved pair, whose points
// have no numbers, and for SEPARATED, which the direction proves.
GJK_ONCE static uint8_t name_vertices(const gjk_iteration *it, gjk_outcome outcome, uint16_t a[4], uint16_t b[4]) {
  const gjk_simplex *s = &it->simplex;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    a[0] = b[0] = 0;
    return outcome == GJK_OUTCOME_SEPARATED ? 0 : 1;
  }
  const uint8_t named = outcome == GJK_OUTCOME_NEAREST && it->diagonal ? 2 : s->count;
  const uint8_t count = gjk_pair_is_curved(it) || outcome == GJK_OUTCOME_SEPARATED ? 0 : named;
  for (unsigned i = 0; i < count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    a[i] = v->a.vertex;
    b[i] = v->b;
  }
  return count;
}

void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out) {
  // Not by designators, which C++ lacks for arrays.
  static const uint8_t proof[] = {
      GJK_PROOF_NEAREST,    // GJK_OUTCOME_NEAREST
      GJK_PROOF_ENCLOSING,  // GJK_OUTCOME_ENCLOSING
      GJK_PROOF_DIRECTION,  // GJK_OUTCOME_SEPARATED
      GJK_PROOF_NEAR,       // GJK_OUTCOME_NEAR
      GJK_PROOF_NONE,       // GJK_OUTCOME_LIMIT
  };
  out->proof = gjk_pair_is_curved(it) ? (uint8_t)GJK_PROOF_NONE : proof[outcome];
  out->count = name_vertices(it, outcome, out->a, out->b);
  out->direction = it->direction.d;
}

// The 15 leading bits of d.
static void keep_direction(const gjk_vec3 *d, int16_t kept[3]) {
  const uint32_t bits = gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z);  // below 2^32
  const unsigned shift = bits >> 15 == 0 ? 0 : 17 - gjk_clz32(bits);
  //@ assert shift <= 17;
  kept[0] = (int16_t)gjk_sar32(d->x, shift);
  kept[1] = (int16_t)gjk_sar32(d->y, shift);
  kept[2] = (int16_t)gjk_sar32(d->z, shift);
}

void gjk_iteration_keep(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache) {
  keep_direction(&it->direction.d, cache->direction);
  cache->count = name_vertices(it, outcome, cache->a, cache->b);
}
