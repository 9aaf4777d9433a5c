// The GJK iteration: support, exact progress, nearest feature.
//
// After   Gilbert, Johnson, Keerthi 1988; the early outs as in Gino van den Bergen, A Fast and Robust GJK
//         Implementation, 1999. Departures: a vertex is added only when it is strictly nearer the origin along the
//         exact direction, so every simplex is non-degenerate, each feature is nearer than the last and none returns.
#include "iteration.h"

// Is v longer than r >= 0? Components at most 2^32, r below 2^33. Both are first cut to 31 bits when they have more,
// rounding towards "no".
static bool longer_than(const gjk_long3 *v, int64_t r) {
  const uint64_t x = gjk_magnitude64(v->x), y = gjk_magnitude64(v->y), z = gjk_magnitude64(v->z);
  const uint64_t limit = (uint64_t)r;
  if (x > limit || y > limit || z > limit) {
    return true;
  }
  if (limit >> 31 != 0) {
    return false;
  }
  // Components below 2^31: each square below 2^62, their sum below 3 2^62 < 2^64.
  return gjk_umul32((uint32_t)x, (uint32_t)x) + gjk_umul32((uint32_t)y, (uint32_t)y) +
             gjk_umul32((uint32_t)z, (uint32_t)z) > gjk_umul32((uint32_t)limit, (uint32_t)limit);
}

// The shift of a frame whose reach is 2^30 or more.
GJK_OUT_OF_LINE static int far_shift(const gjk_long3 *delta) {
  const int64_t unit = INT64_C(1) << 30;
  for (unsigned n = 0; n < 3; n++) {
    const gjk_long3 scaled = {gjk_sar64(delta->x, n), gjk_sar64(delta->y, n), gjk_sar64(delta->z, n)};
    if (!longer_than(&scaled, unit)) {
      return -(int)n;
    }
  }
  return -3;
}

bool gjk_iteration_start(gjk_iteration *it, const gjk_collider *a, const gjk_collider *b, gjk_goal goal,
                         int64_t radius) {
  it->a = a;
  it->b = b;
  it->rounds = 0;
  it->delta.x = (int64_t)a->centre.x - b->centre.x;
  it->delta.y = (int64_t)a->centre.y - b->centre.y;
  it->delta.z = (int64_t)a->centre.z - b->centre.z;
  const int64_t cores = (int64_t)a->core_radius + b->core_radius;
  if (goal == GJK_GOAL_WITHIN && longer_than(&it->delta, cores + radius)) {
    return false;
  }
  // |x| + |y| + |z| bounds the length from above; at most 3 2^32.
  const int64_t reach = (int64_t)(gjk_magnitude64(it->delta.x) + gjk_magnitude64(it->delta.y) +
                                  gjk_magnitude64(it->delta.z)) + cores;
  it->shift = (int8_t)(reach < INT64_C(1) << 30 ? (int)gjk_clz32((uint32_t)reach) - 2 : far_shift(&it->delta));
  // A radius beyond the reach settles the question like the reach, and so does any of 2^31 or more in the frame.
  const int64_t clamped = radius < reach ? radius : reach;
  it->radius = 0;
  if (radius > 0) {
    const int64_t framed = it->shift >= 0 ? gjk_shl64(clamped, (unsigned)it->shift)
                                          : gjk_sar64(clamped, (unsigned)-it->shift);
    it->radius = framed < INT32_MAX ? framed : INT32_MAX;
  }
  it->curved = a->shape->type->vertex == NULL || b->shape->type->vertex == NULL;
  gjk_simplex_clear(&it->simplex);
  return true;
}

// One component of w in a far frame: rounded to nearest.
GJK_OUT_OF_LINE static int32_t far_component(int64_t difference, int shift) {
  const unsigned n = (unsigned)-shift;
  return (int32_t)gjk_sar64(difference + (INT64_C(1) << (n - 1)), n);
}

// The frame's vector from B to A for the given offsets from their centres. Near, all sums are at most 3 2^29.
GJK_HOT_INLINE gjk_vec3 frame_vector(const gjk_iteration *it, const gjk_vec3 *a, const gjk_vec3 *b) {
  gjk_vec3 w = gjk_sub(*a, *b);
  const int shift = it->shift;
  if (shift >= 0) {
    w.x = gjk_shl32((int32_t)it->delta.x + w.x, (unsigned)shift);
    w.y = gjk_shl32((int32_t)it->delta.y + w.y, (unsigned)shift);
    w.z = gjk_shl32((int32_t)it->delta.z + w.z, (unsigned)shift);
  } else {
    w.x = far_component(it->delta.x + w.x, shift);
    w.y = far_component(it->delta.y + w.y, shift);
    w.z = far_component(it->delta.z + w.z, shift);
  }
  return w;
}

void gjk_iteration_place(gjk_iteration *it, const gjk_support *a, const gjk_support *b) {
  gjk_vertex *v = gjk_simplex_free(&it->simplex);
  const gjk_vec3 offset = a->offset;
  v->offset_a = offset;
  v->w = frame_vector(it, &offset, &b->offset);
  v->a = a->vertex;
  v->b = b->vertex;
}

static void support(const gjk_iteration *it, gjk_support *a, gjk_support *b) {
  const gjk_direction *direction = &it->direction;
  const gjk_vec3 opposite = gjk_negate(direction->rounded);
  it->a->shape->type->support(it->a, &direction->rounded, direction->exact, a);
  it->b->shape->type->support(it->b, &opposite, direction->exact, b);
}

// Moves the supports to the farthest vertices along the exact direction. Returns whether one moved.
static bool refine(const gjk_iteration *it, gjk_support *a, gjk_support *b) {
  bool moved = false;
  if (a->tie) {
    moved = it->a->shape->type->refine(it->a, &it->direction.rounded, &it->direction, false, a);
  }
  if (b->tie) {
    const gjk_vec3 opposite = gjk_negate(it->direction.rounded);
    moved = it->b->shape->type->refine(it->b, &opposite, &it->direction, true, b) || moved;
  }
  return moved;
}

bool gjk_iteration_near(const gjk_iteration *it) {
  gjk_limbs numerator, denominator;
  gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  return gjk_compare_distance(&numerator, &denominator, (uint64_t)it->radius * 2) <= 0;
}

// Does the plane across d at distance |along| / |d|, along < 0, leave the origin more than radius behind?
// along^2 > radius^2 d^2: |along| <= sqrt(3) 2^30 3 2^29 < 2^62, radius^2 < 2^62, d^2 <= 3 2^60.
static bool clears(const gjk_iteration *it, int64_t along) {
  const gjk_vec3 d = it->direction.rounded;
  return along < 0 && gjk_sum_sign(along, along, -(it->radius * it->radius), gjk_dot(d, d)) > 0;
}

// Is the feature near enough to settle the question? A vertex is measured; an edge or triangle is, when the plane
// across the direction to it does not clear the radius.
static bool settles_near(const gjk_iteration *it) {
  const gjk_simplex *s = &it->simplex;
  const gjk_vertex *v = &s->slot[s->order[0]];
  if (s->count == 1) {
    return gjk_dot(v->w, v->w) <= it->radius * it->radius;
  }
  return !clears(it, gjk_dot(it->direction.rounded, v->w)) && gjk_iteration_near(it);
}

// Does the feature have this vertex already? Then it is no nearer, and the signs need not be computed to see it.
static bool known(const gjk_iteration *it, const gjk_support *a, const gjk_support *b) {
  const gjk_simplex *s = &it->simplex;
  for (unsigned i = 0; i < s->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    if (v->a == a->vertex && v->b == b->vertex) {
      return !it->curved;
    }
  }
  return false;
}

// Starts from the cached feature, as far as it still is one. Returns ENCLOSING if the origin lies in it.
GJK_OUT_OF_LINE static gjk_step warm_start(gjk_iteration *it, const gjk_cache *cache) {
  const gjk_shape_class *type_a = it->a->shape->type, *type_b = it->b->shape->type;
  gjk_step step = GJK_STEP_NONE;
  if (it->curved) {
    return step;
  }
  for (unsigned i = 0; i < cache->count && i < 4 && step != GJK_STEP_ENCLOSING; i++) {
    gjk_support a, b;
    a.vertex = cache->a[i];
    b.vertex = cache->b[i];
    if (type_a->vertex(it->a, a.vertex, &a.offset) && type_b->vertex(it->b, b.vertex, &b.offset)) {
      gjk_iteration_place(it, &a, &b);
      step = gjk_simplex_add(&it->simplex);
      if (it->simplex.count < 3 && step == GJK_STEP_NEARER && !gjk_simplex_direction(&it->simplex, &it->direction)) {
        step = GJK_STEP_ENCLOSING;
      }
    }
  }
  return step;
}

// The first direction: the cached one, or from A's centre to B's.
static void first_direction(gjk_iteration *it, const gjk_cache *cache) {
  gjk_direction *direction = &it->direction;
  direction->rank = 1;
  direction->exact = true;
  if (cache != NULL && (cache->direction[0] | cache->direction[1] | cache->direction[2]) != 0) {
    direction->rounded.x = cache->direction[0];
    direction->rounded.y = cache->direction[1];
    direction->rounded.z = cache->direction[2];
    return;
  }
  const gjk_vec3 centre = {0, 0, 0};
  direction->rounded = gjk_negate(frame_vector(it, &centre, &centre));
  if ((direction->rounded.x | direction->rounded.y | direction->rounded.z) == 0) {
    direction->rounded.x = 1;
  }
}

gjk_outcome gjk_iteration_run(gjk_iteration *it, gjk_goal goal, const gjk_cache *cache) {
  gjk_support a, b;
  if (it->shift < 0) {
    cache = NULL;  // the distance of rounded vertices would depend, by an LSB, on where the search began
  }
  if (cache != NULL && warm_start(it, cache) == GJK_STEP_ENCLOSING) {
    return GJK_OUTCOME_ENCLOSING;
  }
  for (; it->rounds < GJK_ITERATIONS_MAX; it->rounds++) {
    if (it->simplex.count == 0) {
      first_direction(it, cache);
    } else if (!gjk_simplex_direction(&it->simplex, &it->direction)) {
      return GJK_OUTCOME_ENCLOSING;
    } else if (it->radius > 0 && settles_near(it)) {
      return GJK_OUTCOME_NEAR;
    }
    support(it, &a, &b);
    gjk_iteration_place(it, &a, &b);
    if (goal == GJK_GOAL_WITHIN &&
        clears(it, gjk_dot(it->direction.rounded, gjk_simplex_free(&it->simplex)->w))) {
      it->rounds++;
      return GJK_OUTCOME_SEPARATED;
    }
    gjk_step step = known(it, &a, &b) ? GJK_STEP_NONE : gjk_simplex_add(&it->simplex);
    if (step == GJK_STEP_NONE && refine(it, &a, &b)) {
      gjk_iteration_place(it, &a, &b);
      step = gjk_simplex_add(&it->simplex);
    }
    if (step != GJK_STEP_NEARER) {
      it->rounds++;
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

void gjk_iteration_certify(const gjk_iteration *it, gjk_outcome outcome, gjk_certificate *out) {
  static const uint8_t proof[] = {GJK_PROOF_NEAREST, GJK_PROOF_ENCLOSING, GJK_PROOF_DIRECTION, GJK_PROOF_NEAR,
                                  GJK_PROOF_NONE};
  const gjk_simplex *s = &it->simplex;
  out->proof = it->curved ? GJK_PROOF_NONE : proof[outcome];
  out->count = it->curved || outcome == GJK_OUTCOME_SEPARATED ? 0 : s->count;
  out->direction = it->direction.rounded;
  for (unsigned i = 0; i < out->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    out->a[i] = v->a;
    out->b[i] = v->b;
  }
}

// The 15 leading bits of a direction.
static void keep_direction(const gjk_vec3 *d, int16_t kept[3]) {
  const uint32_t bits = gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z);
  const unsigned shift = bits >> 15 == 0 ? 0 : 17 - gjk_clz32(bits);
  kept[0] = (int16_t)gjk_sar32(d->x, shift);
  kept[1] = (int16_t)gjk_sar32(d->y, shift);
  kept[2] = (int16_t)gjk_sar32(d->z, shift);
}

void gjk_iteration_keep(const gjk_iteration *it, gjk_outcome outcome, gjk_cache *cache) {
  const gjk_simplex *s = &it->simplex;
  cache->count = it->curved || outcome == GJK_OUTCOME_SEPARATED ? 0 : s->count;
  keep_direction(&it->direction.rounded, cache->direction);
  for (unsigned i = 0; i < cache->count; i++) {
    const gjk_vertex *v = &s->slot[s->order[i]];
    cache->a[i] = v->a;
    cache->b[i] = v->b;
  }
}
