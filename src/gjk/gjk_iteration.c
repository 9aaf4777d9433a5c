// The GJK iteration: support, exact progress, nearest feature.
//
// After   Gilbert, Johnson, Keerthi 1988; the early outs as in Gino van den Bergen, A Fast and Robust GJK
//         Implementation, 1999. Departures: a vertex is added only when it is strictly nearer the origin along the
//         exact direction, so every simplex is non-degenerate, each feature is nearer than the last and none returns.
#include "gjk_frame.h"

// From here on a search of curved shapes is long. Random pairs take at most 51 iterations.
#define LATE_ITERATIONS 64

bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius) {
  it->a = a;
  it->b = b;
  if (!gjk_frame_set(it, gjk_goal_separates(goal), radius)) {
    return false;
  }
  it->iterations = 0;
  it->stalls = a->shape->type->stalls;
  if (!gjk_pair_is_curved(it)) {
    it->stalls = b->shape->type->stalls;
  }
  gjk_simplex_clear(&it->simplex);
  return true;
}

// Completes the vertex in the free slot, which has its vertex of A, by that of B.
GJK_ONCE static void complete_vertex(gjk_iteration *it, const gjk_support *b) {
  gjk_vertex *v = gjk_simplex_free(&it->simplex);
  v->b = b->vertex;
  v->w = gjk_sub(v->a.offset, b->offset);
  gjk_frame_move(it, &v->w);
}

bool gjk_iteration_place(gjk_iteration *it, uint16_t a, uint16_t b) {
  gjk_vertex *v = gjk_simplex_free(&it->simplex);
  gjk_support of_b;
  v->a.vertex = a;
  of_b.vertex = b;
  if (!it->a->shape->type->vertex(it->a, a, &v->a.offset) || !it->b->shape->type->vertex(it->b, b, &of_b.offset)) {
    return false;
  }
  complete_vertex(it, &of_b);
  return true;
}

GJK_ONCE static void next_vertex(gjk_iteration *it, gjk_support *b) {
  const gjk_vec3 opposite = gjk_negate(it->direction.d);
  it->a->shape->type->support(it->a, &it->direction.d, &gjk_simplex_free(&it->simplex)->a);
  it->b->shape->type->support(it->b, &opposite, b);
  complete_vertex(it, b);
}

void gjk_iteration_next(gjk_iteration *it, gjk_support *b) {
  next_vertex(it, b);
}

bool gjk_iteration_refine(gjk_iteration *it, gjk_direction *direction, gjk_support *b) {
  bool moved = false;
  if (it->a->shape->type->refine != NULL) {
    moved = it->a->shape->type->refine(it->a, &it->direction.d, direction, &gjk_simplex_free(&it->simplex)->a);
  }
  if (it->b->shape->type->refine != NULL) {
    const gjk_vec3 opposite = gjk_negate(it->direction.d);
    direction->opposite = true;
    moved = it->b->shape->type->refine(it->b, &opposite, direction, b) || moved;
  }
  if (moved) {
    complete_vertex(it, b);
  }
  return moved;
}

// Moves the vertex to the farthest along the feature's exact direction. Returns whether it moved.
static bool refine_nearest(gjk_iteration *it, gjk_support *b) {
  gjk_direction direction;
  if (it->direction.exact) {
    return false;
  }
  gjk_simplex_exact_direction(&it->simplex, &direction);
  return gjk_iteration_refine(it, &direction, b);
}

bool gjk_iteration_near(const gjk_iteration *it) {
  gjk_u192 numerator, denominator;
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)it->radius * 2) <= 0;
}

// Does the plane across the direction through w leave the origin more than radius behind? Its distance is along / |d|, so:
// along^2 > radius^2 d^2. |along| <= sqrt(3) 2^30 3 2^29 < 2^62, radius^2 < 2^62, d^2 <= 3 2^60.
static bool clears(const gjk_iteration *it, const gjk_vec3 *w, int32_t radius) {
  const gjk_vec3 d = it->direction.d;
  const int64_t along = gjk_dot(&d, w);
  if (radius == 0) {
    return along < 0;
  }
  return along < 0 && gjk_sum_of_products_sign(along, along, -gjk_mul32(radius, radius), gjk_dot(&d, &d)) > 0;
}

// Is the feature near enough to settle the question? A vertex is measured; an edge or triangle is, when the plane
// across the direction to it does not clear the radius.
static bool settles_near(const gjk_iteration *it) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *v = &s->slot[s->order[0]];
  if (s->count == 1) {
    return gjk_dot(&v->w, &v->w) <= gjk_mul32(it->radius, it->radius);
  }
  return !clears(it, &v->w, it->radius) && gjk_iteration_near(it);
}

// Is the vertex of no use: does the feature have it already, or for a curved pair nearly? Then the signs need not be
// computed to see it.
static bool is_duplicate(gjk_iteration *it) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *added = gjk_simplex_free(&it->simplex);
  if (gjk_pair_is_curved(it) && s->count > 0) {
    return it->stalls(&it->direction.d, &s->slot[s->order[0]].w, &added->w, it->shift,
                      it->iterations >= LATE_ITERATIONS);
  }
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    if (v->a.vertex == added->a.vertex && v->b == added->b) {
      return true;
    }
  }
  return false;
}

// Takes the cached direction; false when there is none.
static bool cached_direction(gjk_iteration *it, const gjk_cache *cache) {
  gjk_vec3 *d = &it->direction.d;
  d->x = cache->direction[0];
  d->y = cache->direction[1];
  d->z = cache->direction[2];
  it->direction.exact = true;
  return (d->x | d->y | d->z) != 0;
}

// The first direction: the cached one, or from A's centre to B's.
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

// Starts from the cached feature, as far as it still is one. Does the origin lie in it?
static bool warm_start(gjk_iteration *it, const gjk_cache *cache) {
  //@ dynamic_split it->simplex.count;
  for (unsigned i = 0; i < cache->count && i < 4; i++) {
    const gjk_step step =
        gjk_iteration_place(it, cache->a[i], cache->b[i]) ? gjk_simplex_add(&it->simplex) : GJK_STEP_NONE;
    if (step == GJK_STEP_ENCLOSING ||
        (step == GJK_STEP_NEARER && it->simplex.count < 3 && !gjk_simplex_direction(&it->simplex, &it->direction))) {
      return true;
    }
  }
  return false;
}

// Adds the vertex of the last direction, or if that is no nearer the one that rounding has hidden.
static gjk_step add_vertex(gjk_iteration *it, gjk_support *b) {
  if (!is_duplicate(it)) {
    const gjk_step step = gjk_simplex_add(&it->simplex);
    if (step != GJK_STEP_NONE) {
      return step;
    }
  }
  return refine_nearest(it, b) ? gjk_simplex_add(&it->simplex) : GJK_STEP_NONE;
}

gjk_outcome gjk_iteration_run(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache) {
  gjk_support b;
  // Of rounded vertices, where the search ends, and whether it does in time, would depend on where it began.
  if (it->shift < 0 || gjk_pair_is_curved(it)) {
    cache = NULL;
  }
  if (cache != NULL && warm_start(it, cache)) {
    return GJK_OUTCOME_ENCLOSING;
  }
  //@ dynamic_split it->simplex.count;
  for (; it->iterations < it->limit; it->iterations++) {
    if (it->simplex.count == 0) {
      first_direction(it, cache);
    } else if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
      return GJK_OUTCOME_ENCLOSING;
    } else if (it->radius > 0 && gjk_goal_nears(goal) && settles_near(it)) {
      return GJK_OUTCOME_NEAR;
    }
    next_vertex(it, &b);
    if (gjk_goal_separates(goal) && clears(it, &gjk_simplex_free(&it->simplex)->w, it->radius)) {
      it->iterations++;
      return GJK_OUTCOME_SEPARATED;
    }
    const gjk_step step = add_vertex(it, &b);
    if (step != GJK_STEP_NEARER) {
      it->iterations++;
      if (step == GJK_STEP_ENCLOSING) {
        return GJK_OUTCOME_ENCLOSING;
      }
      // Within the rounding of the direction clears and settles_near may both have left it open.
      return goal == GJK_GOAL_WITHIN && it->radius > 0 && gjk_iteration_near(it) ? GJK_OUTCOME_NEAR
                                                                                 : GJK_OUTCOME_NEAREST;
    }
  }
  return GJK_OUTCOME_LIMIT;
}

// The vertices of the feature, when there are some to be named. Returns their number.
static uint8_t name_vertices(const gjk_iteration *it, gjk_outcome outcome, uint16_t a[4], uint16_t b[4]) {
  const gjk_simplex *s = &it->simplex;
  const uint8_t count = gjk_pair_is_curved(it) || outcome == GJK_OUTCOME_SEPARATED ? 0 : s->count;
  for (unsigned i = 0; i < count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    a[i] = v->a.vertex;
    b[i] = v->b;
  }
  return count;
}

void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out) {
  static const uint8_t proof[] = {GJK_PROOF_NEAREST, GJK_PROOF_ENCLOSING, GJK_PROOF_DIRECTION, GJK_PROOF_NEAR,
                                  GJK_PROOF_NONE};
  out->proof = gjk_pair_is_curved(it) ? GJK_PROOF_NONE : proof[outcome];
  out->count = name_vertices(it, outcome, out->a, out->b);
  out->direction = it->direction.d;
}

// The 15 leading bits of a direction.
static void keep_direction(const gjk_vec3 *d, int16_t kept[3]) {
  const uint32_t bits = gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z);
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
