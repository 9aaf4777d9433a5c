// The narrow phase: is one pair near? Skips answer without a query where they can. In the order of their cost:
//
// 1. Motion. The last test, or the manifold of its report, proved the pair apart, or near, by some gap more than its
//    margins. If both parts together have moved by less since, the answer stands. What they moved is taken off the gap.
//    Parts of a body whose filter changed count as moved without bound, so step 2 is not left out.
// 2. Filters. Kinds, categories, masks or the predicate refuse the pair: it counts as apart.
// 3. Boxes. Each exact box holds its part. If the boxes are farther apart along an axis than the margins, so are the
//    parts.
// 4. Spheres. Each bounding sphere holds its part, too. If the pair was near: a part like a box, segment or point holds
//    a sphere. If those spheres are nearer than the margins, so are the parts, unless a distance is asked for.
// 5. Direction. Each part lies behind its support plane across the last separating direction. If the planes are still
//    farther apart than the margins, so are the parts. That takes one support scan of each.
// 6. The query, warm from the pair's cache. What its answer proves beyond yes or no becomes the gap of step 1.
//
// Why it is safe: what a skip answers, a query from a cold start would answer, too. Polytopes and their rounded forms
// have exact queries, and each skip proves its answer, so both agree. A query of curved or custom shapes decides
// within 2 LSB, or may reach its ceiling on iterations. So no proof says what it would answer. Such pairs take steps 2,
// 3 and 6 alone, cold. Step 3 is then the answer itself, not a skip of it. For whether such a pair has a record at all
// depends on its larger boxes in the tree, and so on history.
//
// With retest_all, pairs without curves take steps 2 and 6 alone, cold. Points take steps 1, 2, 3 and 6, which is step 4.
#include "../arith/gjk_root.h"
#include "../scene/gjk_scene_pairs.h"
#include "../scene/gjk_scene_part.h"
#include "../scene/gjk_scene_solid.h"

#ifndef GJK_SCENE_OF_PLANE
#include "gjk_scene_measure.h"
#endif

typedef struct pair_question {
  const gjk_scene_view *v;
  const gjk_scene_part *a, *b;
  int32_t margin;  // of both bodies together: below 2^29
} pair_question;

static uint8_t detail(const pair_question *q) {
  return gjk_scene_detail(q->v, &q->v->bodies[q->a->body], &q->v->bodies[q->b->body]);
}

static const gjk_shape *shape_of(const pair_question *q, const gjk_scene_part *p) {
  return q->v->scene->shapes[p->shape];
}

static void set_near(gjk_scene_pair *pair, bool near) {
  pair->state = (uint8_t)(pair->state | (near ? GJK_SCENE_PAIR_NEAR_NOW : 0u));
}

// By how much a proven lower bound of the distance exceeds the margins, for gap; 0: it does not.
GJK_ONE_COPY static int32_t beyond_margins(const pair_question *q, int64_t bound) {
  const int64_t left = bound - q->margin;
  return left > 0 ? gjk_saturate(left) : 0;
}

static bool is_curved(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b) {
  return !gjk_scene_has_vertices(v->scene->shapes[a->shape]) || !gjk_scene_has_vertices(v->scene->shapes[b->shape]);
}

// Step 1. A distance that is asked for has to be found anew.
static bool outlasts_motion(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                            gjk_scene_pair *pair) {
  const uint32_t motion = a->motion > GJK_SCENE_UNBOUNDED - b->motion ? GJK_SCENE_UNBOUNDED : a->motion + b->motion;
  const bool near = (pair->state & GJK_SCENE_PAIR_NEAR) != 0;
  const int32_t gap = pair->gap;
  if (motion >= (uint32_t)gap || is_curved(v, a, b) ||
      (near && gjk_scene_wants_distance(gjk_scene_detail(v, &v->bodies[a->body], &v->bodies[b->body])))) {
    return false;
  }
  //@ assert gap >= 0 && motion <= INT32_MAX;
  pair->gap = gap - (int32_t)motion;
  set_near(pair, near);
  return true;
}

// Settles a pair as apart when gap proves it. Returns whether it does.
static bool settle_apart(gjk_scene_pair *pair, int32_t gap, gjk_scene_outcome outcome) {
  if (gap > 0) {
    pair->gap = gap;
    pair->outcome = (uint8_t)outcome;
  }
  return gap > 0;
}

// A lower bound of the distance: how far the support planes of A and B across direction, from A to B, are apart; or 0.
static int64_t plane_bound(const gjk_collider *a, const gjk_collider *b, const int16_t *direction) {
  const gjk_vec3 d = gjk_scene_direction(direction), opposite = gjk_negate(d);
  gjk_vec3 centres;
  if (gjk_scene_is_zero(&d) || !gjk_scene_between_centres(a, b, &centres)) {
    return 0;
  }
  gjk_support far_a, far_b;
  a->shape->type->support(a, &d, &far_a);
  b->shape->type->support(b, &opposite, &far_b);
  return gjk_scene_along(&d, &centres, &far_a.offset, &far_b.offset) - GJK_SCENE_PLANE_SLACK - a->shape->convex_radius -
         b->shape->convex_radius;
}

// A lower bound of the distance from the bounding spheres, where it exceeds the margins; otherwise 0.
//
// Pre  the boxes are not farther apart than the margins.
//      core_radius + convex_radius <= 2^28 + 4 each, margin < 2^29:   reach < 2^30 + 2^4
//      boxes hold the spheres' centres, not farther apart than that:  x, y, z < 2^31
static int64_t sphere_bound(const pair_question *q) {
  const int32_t radii =
      q->a->core_radius + q->b->core_radius + shape_of(q, q->a)->convex_radius + shape_of(q, q->b)->convex_radius;
  const uint32_t reach = (uint32_t)radii + (uint32_t)q->margin;
  const uint64_t squared = gjk_scene_centres_squared(q->a, q->b);
  return squared > gjk_umul32(reach, reach) ? (int64_t)gjk_isqrt64(squared) - radii : 0;
}

// By how much the spheres inside prove a pair nearer than its margins, for gap; 0: they do not, or a distance is asked
// for, which has to be found.
//
// Pre  as sphere_bound: -2^31 <= reach < 2^30; the root is less than reach.
static int32_t inner_bound(const pair_question *q) {
  const int32_t reach =
      gjk_scene_inner_radius(shape_of(q, q->a)) + gjk_scene_inner_radius(shape_of(q, q->b)) + q->margin;
  if (reach <= 0 || gjk_scene_wants_distance(detail(q))) {
    return 0;
  }
  const uint64_t squared = gjk_scene_centres_squared(q->a, q->b);
  const uint32_t whole = (uint32_t)reach;
  return squared < gjk_umul32(whole, whole) ? reach - (int32_t)gjk_isqrt64(squared) - 1 : 0;
}

// The distance of a near pair, or minus its depth for GJK_DETAIL_DEPTH. Where a query reaches its ceiling or the
// workspace is too small: a proven bound. 0 where data of many parts that were never checked have no answer.
static int32_t measure_pair(const pair_question *q, const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                            gjk_scene_pair *pair) {
  gjk_distance_result result;
  gjk_status status;
  result.distance = result.lower = 0;
  if (detail(q) == GJK_DETAIL_DEPTH) {
    status = gjk_scene_ask_depth(q->v, q->a, q->b, a, b, cache, &result);
  } else {
    status = gjk_scene_ask_distance(q->v, q->a, q->b, a, b, cache, &result);
  }
  pair->outcome |= GJK_SCENE_MEASURED;
  if (status != GJK_OK) {
    pair->outcome |= GJK_SCENE_UNSETTLED;
  }
  return status == GJK_ERROR_ITERATION_LIMIT ? result.lower : result.distance;
}

// By how much a decision proves the pair nearer than its margins, for gap; 0: it does not.
//
// The distance of the cores is 0 for GJK_PROOF_ENCLOSING. For GJK_PROOF_NEAR it is that of the decision's feature,
// which the direction is perpendicular to, so any two of its vertices tell it.
static int32_t within_margins(const pair_question *q, const gjk_collider *a, const gjk_collider *b,
                              const gjk_decision *decision) {
  const gjk_certificate *c = &decision->certificate;
  // margin < 2^29, convex_radius <= 2^28 each:  |within| < 2^31
  const int64_t within = (int64_t)q->margin + a->shape->convex_radius + b->shape->convex_radius - GJK_SCENE_NEAR_SLACK;
  gjk_vec3 centres, on_a, on_b;
  if (within <= 0 || c->proof == GJK_PROOF_ENCLOSING) {
    return within <= 0 ? 0 : gjk_saturate(within);
  }
  if (c->proof != GJK_PROOF_NEAR || !gjk_scene_between_centres(a, b, &centres)) {
    return 0;
  }
  a->shape->type->vertex(a, c->a[0], &on_a);  // the query named these vertices, so they exist
  b->shape->type->vertex(b, c->b[0], &on_b);
  const int64_t left = within - (int64_t)gjk_magnitude64(gjk_scene_along(&c->direction, &centres, &on_a, &on_b));
  return left > 0 ? gjk_saturate(left) : 0;
}

// Asks the queries whether the pair is near, and sets gap.
static bool query_near(const pair_question *q, const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                       gjk_scene_pair *pair) {
  gjk_decision decision;
  const gjk_status status = gjk_scene_ask_within(q->v, q->a, q->b, a, b, q->margin, cache, &decision);
  if (status != GJK_OK) {
    pair->outcome |= GJK_SCENE_UNSETTLED;
  } else if (!decision.yes) {
    pair->gap = cache != NULL ? beyond_margins(q, plane_bound(a, b, cache->direction)) : 0;
    return false;
  }
  if (gjk_scene_wants_distance(detail(q))) {
    pair->gap = measure_pair(q, a, b, cache, pair);
  } else {
    pair->gap = status == GJK_OK ? within_margins(q, a, b, &decision) : 0;
  }
  return true;
}

// Step 5.
static bool hint_settles(const pair_question *q, const gjk_collider *a, const gjk_collider *b, gjk_scene_pair *pair) {
  int16_t room[GJK_SCENE_AXES];
  return settle_apart(pair, beyond_margins(q, plane_bound(a, b, gjk_scene_hint(pair, room))), GJK_SCENE_DIRECTION);
}

// Steps 5 and 6; cold: step 6 alone, without the cache.
static void query_pair(const pair_question *q, bool cold, gjk_scene_pair *pair) {
  gjk_collider a, b;
  gjk_cache cache;
  gjk_scene_part_collider(q->v, q->a, &a);
  gjk_scene_part_collider(q->v, q->b, &b);
  if (cold) {
    pair->outcome = GJK_SCENE_COLD;
    set_near(pair, query_near(q, &a, &b, NULL, pair));
    return;
  }
  // The last query of a near pair left no separating direction.
  if ((pair->state & GJK_SCENE_PAIR_NEAR) == 0 && hint_settles(q, &a, &b, pair)) {
    return;
  }
  gjk_scene_load_cache(pair, &cache);
  pair->outcome = cache.count != 0 || !gjk_scene_is_zero_direction(cache.direction) ? GJK_SCENE_WARM : GJK_SCENE_COLD;
  const bool near = query_near(q, &a, &b, &cache, pair);
  gjk_scene_store_cache(&cache, near, pair);
  set_near(pair, near);
}

// Step 3.
static bool boxes_apart(const pair_question *q, gjk_scene_pair *pair) {
  return settle_apart(pair, beyond_margins(q, gjk_aabb_gap(&q->a->exact, &q->b->exact)), GJK_SCENE_BOXES);
}

// Step 4. Spheres around a pair that was near seldom part before its boxes do, so they are not looked at.
static bool spheres_settle(const pair_question *q, gjk_scene_pair *pair) {
  if ((pair->state & GJK_SCENE_PAIR_NEAR) == 0) {
    return settle_apart(pair, beyond_margins(q, sphere_bound(q)), GJK_SCENE_BOXES);
  }
  const int32_t gap = inner_bound(q);
  if (gap > 0) {
    pair->gap = gap;
    pair->outcome = GJK_SCENE_BOXES;
    set_near(pair, true);
  }
  return gap > 0;
}

// Steps 3 to 6.
static void test_geometry(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                          gjk_scene_pair *pair) {
  const int32_t margin = v->bodies[a->body].margin + v->bodies[b->body].margin;
  const pair_question q = {v, a, b, margin};
  const bool skips = v->header->config.retest_all == 0, curved = is_curved(v, a, b);
  if ((skips || curved) && boxes_apart(&q, pair)) {
    return;
  }
  const bool cold = GJK_SHAPES <= GJK_SHAPES_POINTS || !skips || curved;  // spheres are what points ask about
  if (cold || !spheres_settle(&q, pair)) {
    query_pair(&q, cold, pair);
  }
}

// Steps 2 to 6. told: a flag that stays.
GJK_OUT_OF_LINE static void test_pair(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                      unsigned told, gjk_scene_pair *pair) {
  if (gjk_scene_is_refused(v, a->body, b->body)) {  // Step 2
    pair->gap = 0;
    pair->outcome = GJK_SCENE_FILTERED;
  } else {
    test_geometry(v, a, b, pair);
  }
  pair->outcome = (uint8_t)(pair->outcome | told);
}

void gjk_scene_narrow_phase(const gjk_scene_view *v, gjk_scene_pair *pair) {
  const unsigned told = pair->outcome & GJK_SCENE_TOLD;
  if (!gjk_scene_is_pending(pair)) {
    return;
  }
  const gjk_scene_part *a = &v->parts[gjk_scene_end(pair, 0)], *b = &v->parts[gjk_scene_end(pair, 1)];
  if (v->header->config.retest_all == 0 && outlasts_motion(v, a, b, pair)) {
    pair->outcome = (uint8_t)(GJK_SCENE_MOTION | told);
  } else {
    test_pair(v, a, b, told, pair);
  }
}
