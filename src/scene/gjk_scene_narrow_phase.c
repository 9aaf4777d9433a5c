// The test of one pair, and what saves it: in the order of cost.
#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"
#include "../shape/gjk_shape_class.h"
#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk_scene_pairs.h"
#include "gjk_scene_part.h"

// How far pieces of the plane distance are off: the unit vector by sqrt(3) 2^-30 of at most sqrt(3) 2^30, and the floor.
#define PLANE_SLACK 4

// How far the distance along a feature's rounded direction is off: each component by less than 1 of at least 2^29 unless
// it is exact, so the unit vectors by less than 2 sqrt(3) 2^-29 of at most 3 2^29, which is 10.4; and PLANE_SLACK.
#define NEAR_SLACK 16

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

// Has one of them no vertices? A query may then end at the ceiling on iterations, or decide within 2 LSB, so that nothing but
// asking tells what it answers: poses alone count, and nothing that was found before.
static bool is_curved(const pair_question *q) {
  return gjk_is_curved(shape_of(q, q->a)) || gjk_is_curved(shape_of(q, q->b));
}

static void set_near(gjk_scene_pair *pair, bool near) {
  pair->state = (uint8_t)(pair->state | (near ? GJK_SCENE_PAIR_NEAR_NOW : 0u));
}

// What a proven lower bound of the distance leaves beyond the margins, as gap keeps it: 0 when the bound settles nothing.
static int32_t spare(const pair_question *q, int64_t bound) {
  const int64_t left = bound - q->margin;
  return left > 0 ? gjk_saturate(left) : 0;
}

// Does what was proven at the last test, apart or near, exceed the motion since? Then that much less remains. A distance
// that is asked for has to be found anew.
static bool outlasts_motion(const pair_question *q, gjk_scene_pair *pair) {
  const uint32_t a = q->a->motion, b = q->b->motion;
  const uint32_t motion = a > GJK_SCENE_UNBOUNDED - b ? GJK_SCENE_UNBOUNDED : a + b;
  const bool near = (pair->state & GJK_SCENE_PAIR_NEAR) != 0;
  const int32_t gap = pair->gap;
  if (motion >= (uint32_t)gap || (near && gjk_scene_measures(detail(q))) || is_curved(q)) {
    return false;
  }
  //@ assert gap >= 0 && motion <= INT32_MAX;
  pair->gap = gap - (int32_t)motion;
  set_near(pair, near);
  return true;
}

static bool settle_far(gjk_scene_pair *pair, int32_t gap, gjk_scene_outcome outcome) {
  if (gap > 0) {
    pair->gap = gap;
    pair->outcome = (uint8_t)outcome;
  }
  return gap > 0;
}

// v along d, in the units of v, rounded down: less than PLANE_SLACK off for |v| <= 2^31.
static int64_t along_unit(const gjk_vec3 *d, const gjk_vec3 *v) {
  const gjk_unit3 u = gjk_unit(d);
  return gjk_sar64(gjk_mac32(gjk_mac32(gjk_mul32(u.x, v->x), u.y, v->y), u.z, v->z), 30);
}

// From the centre of A to that of B; false when they are 2^29 or more apart along an axis.
static bool between_centres(const gjk_collider *a, const gjk_collider *b, gjk_vec3 *out) {
  const int64_t x = (int64_t)b->centre.x - a->centre.x, y = (int64_t)b->centre.y - a->centre.y;
  const int64_t z = (int64_t)b->centre.z - a->centre.z;
  if ((gjk_magnitude64(x) | gjk_magnitude64(y) | gjk_magnitude64(z)) >> 29 != 0) {
    return false;
  }
  //@ assert x > -(1L << 29) && x < 1L << 29;
  //@ assert y > -(1L << 29) && y < 1L << 29;
  //@ assert z > -(1L << 29) && z < 1L << 29;
  out->x = (int32_t)x;
  out->y = (int32_t)y;
  out->z = (int32_t)z;
  return true;
}

// What lies from a point of A to one of B along d, for centres that far apart and offsets from them: these are below
// 2^28 + 2^3, so the sums are at most 2^30 + 2^4.
static int64_t along(const gjk_vec3 *d, const gjk_vec3 *centres, const gjk_vec3 *on_a, const gjk_vec3 *on_b) {
  const gjk_vec3 apart = {centres->x + on_b->x - on_a->x, centres->y + on_b->y - on_a->y,
                          centres->z + on_b->z - on_a->z};
  return along_unit(d, &apart);
}

// A lower bound of the distance: that of the planes across direction, from A to B, which both shapes lie behind.
static int64_t plane_bound(const gjk_collider *a, const gjk_collider *b, const int16_t direction[3]) {
  const gjk_vec3 d = {direction[0], direction[1], direction[2]}, opposite = gjk_negate(d);
  gjk_vec3 centres;
  if ((d.x | d.y | d.z) == 0 || !between_centres(a, b, &centres)) {
    return 0;
  }
  gjk_support far_a, far_b;
  a->shape->type->support(a, &d, &far_a);
  b->shape->type->support(b, &opposite, &far_b);
  return along(&d, &centres, &far_a.offset, &far_b.offset) - PLANE_SLACK - a->shape->convex_radius -
         b->shape->convex_radius;
}

// A lower bound of the distance from the bounding spheres, where it exceeds the margins; otherwise 0.
// Pre: the boxes do not tell. Radii are at most 2^28 + 4, with their roundings, and margins less than 2^29, so the reach is
// below 2^31, and so is each component from centre to centre.
static int64_t sphere_bound(const pair_question *q) {
  const uint32_t x = (uint32_t)gjk_magnitude64((int64_t)q->a->centre.x - q->b->centre.x);
  const uint32_t y = (uint32_t)gjk_magnitude64((int64_t)q->a->centre.y - q->b->centre.y);
  const uint32_t z = (uint32_t)gjk_magnitude64((int64_t)q->a->centre.z - q->b->centre.z);
  const int32_t radii =
      q->a->core_radius + q->b->core_radius + shape_of(q, q->a)->convex_radius + shape_of(q, q->b)->convex_radius;
  const uint32_t reach = (uint32_t)radii + (uint32_t)q->margin;
  const uint64_t squared = gjk_umul32(x, x) + gjk_umul32(y, y) + gjk_umul32(z, z);
  return squared > gjk_umul32(reach, reach) ? (int64_t)gjk_isqrt64(squared) - radii : 0;
}

// A pair keeps vertices whose numbers fit a byte; others are found anew.
static void load_cache(const gjk_scene_pair *pair, gjk_cache *cache) {
  cache->count = (uint16_t)(pair->state >> GJK_SCENE_PAIR_CACHED);
  for (int i = 0; i < 3; i++) {
    cache->direction[i] = pair->direction[i];
  }
  for (int i = 0; i < 4; i++) {
    cache->a[i] = pair->a[i];
    cache->b[i] = pair->b[i];
  }
}

static void store_cache(const gjk_cache *cache, gjk_scene_pair *pair) {
  unsigned count = 0;
  for (unsigned i = 0; i < cache->count && i < 4; i++) {  // not reached: 4: what a query keeps has no more
    if (cache->a[i] < 256 && cache->b[i] < 256) {
      pair->a[count] = (uint8_t)cache->a[i];
      pair->b[count] = (uint8_t)cache->b[i];
      count++;
    }
  }
  for (int i = 0; i < 3; i++) {
    pair->direction[i] = cache->direction[i];
  }
  const unsigned flags = pair->state & ((1u << GJK_SCENE_PAIR_CACHED) - 1);
  pair->state = (uint8_t)(flags | count << GJK_SCENE_PAIR_CACHED);
}

// The distance of a pair that is near, or minus its depth where that is asked; a bound of it where a query reaches its
// ceiling or the workspace is too small.
static int32_t measure_pair(const pair_question *q, const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                            gjk_scene_pair *pair) {
  const gjk_scene *scene = q->v->scene;
  gjk_distance_result result;
  gjk_workspace workspace;
  gjk_status status;
  result.lower = 0;
  if (detail(q) == GJK_DETAIL_DEPTH) {
    gjk_scene_workspace(scene, &workspace);
    status = scene->details->signed_distance(a, b, cache, &workspace, &result);
  } else {
    status = gjk_distance(a, b, cache, &result);
  }
  if (status != GJK_OK) {
    pair->outcome |= GJK_SCENE_UNSETTLED;
  }
  return status == GJK_ERROR_ITERATION_LIMIT ? result.lower : result.distance;
}

// By how much nearer than the margins a decision proves the pair, as gap keeps it. The cores' distance is 0, or that of the
// feature, which is across the direction.
static int32_t near_spare(const pair_question *q, const gjk_collider *a, const gjk_collider *b,
                          const gjk_decision *decision) {
  const gjk_certificate *c = &decision->certificate;
  const int64_t within =
      (int64_t)q->margin + a->shape->convex_radius + b->shape->convex_radius - NEAR_SLACK;  // below 2^31
  gjk_vec3 centres, on_a, on_b;
  if (within <= 0 || c->proof == GJK_PROOF_ENCLOSING) {
    return within <= 0 ? 0 : gjk_saturate(within);
  }
  if (c->proof != GJK_PROOF_NEAR || !between_centres(a, b, &centres)) {
    return 0;
  }
  a->shape->type->vertex(a, c->a[0], &on_a);  // named by the query, so they are there
  b->shape->type->vertex(b, c->b[0], &on_b);
  const int64_t left = within - (int64_t)gjk_magnitude64(along(&c->direction, &centres, &on_a, &on_b));
  return left > 0 ? gjk_saturate(left) : 0;
}

// Is the pair near? Sets gap.
static bool ask(const pair_question *q, const gjk_collider *a, const gjk_collider *b, gjk_cache *cache,
                gjk_scene_pair *pair) {
  gjk_decision decision;
  const gjk_status status = gjk_within(a, b, q->margin, cache, &decision);
  if (status != GJK_OK) {
    pair->outcome |= GJK_SCENE_UNSETTLED;
  } else if (!decision.yes) {
    pair->gap = cache != NULL ? spare(q, plane_bound(a, b, cache->direction)) : 0;
    return false;
  }
  if (gjk_scene_measures(detail(q))) {
    pair->gap = measure_pair(q, a, b, cache, pair);
  } else {
    pair->gap = status == GJK_OK ? near_spare(q, a, b, &decision) : 0;
  }
  return true;
}

static void query(const pair_question *q, bool cold, gjk_scene_pair *pair) {
  gjk_collider a, b;
  gjk_cache cache;
  gjk_scene_part_collider(q->v, q->a, &a);
  gjk_scene_part_collider(q->v, q->b, &b);
  if (cold) {
    pair->outcome = GJK_SCENE_COLD;
    set_near(pair, ask(q, &a, &b, NULL, pair));
    return;
  }
  // What was near last time had no such direction.
  if ((pair->state & GJK_SCENE_PAIR_NEAR) == 0 &&
      settle_far(pair, spare(q, plane_bound(&a, &b, pair->direction)), GJK_SCENE_DIRECTION)) {
    return;
  }
  load_cache(pair, &cache);
  pair->outcome = cache.count != 0 || (cache.direction[0] | cache.direction[1] | cache.direction[2]) != 0
                      ? GJK_SCENE_WARM
                      : GJK_SCENE_COLD;
  const bool near = ask(q, &a, &b, &cache, pair);
  store_cache(&cache, pair);
  set_near(pair, near);
}

static bool refused(const pair_question *q) {
  const gjk_scene *scene = q->v->scene;
  const gjk_body_id a = gjk_scene_id_of(q->v, q->a->body), b = gjk_scene_id_of(q->v, q->b->body);
  return !gjk_scene_wanted(q->v, q->a, q->b) ||
         (scene->predicate != NULL &&
          !scene->predicate(scene->user, a, q->v->bodies[a.slot].user, b, q->v->bodies[b.slot].user));
}

static bool boxes_tell(const pair_question *q, gjk_scene_pair *pair) {
  return settle_far(pair, spare(q, gjk_aabb_gap(&q->a->exact, &q->b->exact)), GJK_SCENE_BOXES);
}

// Unless the pair was near, do the bounding spheres tell?
static bool spheres_tell(const pair_question *q, gjk_scene_pair *pair) {
  return (pair->state & GJK_SCENE_PAIR_NEAR) == 0 && settle_far(pair, spare(q, sphere_bound(q)), GJK_SCENE_BOXES);
}

// What a skip answers, a query from a cold start would answer, too. Without curves both are exact. With curves, boxes that
// are apart are the answer, not a skip of it: whether there is a record to ask depends on larger boxes, and so on history.
void gjk_scene_narrow_phase(const gjk_scene_view *v, gjk_scene_pair *pair) {
  if (pair->outcome != GJK_SCENE_PENDING) {
    return;
  }
  const gjk_scene_part *part_a = &v->parts[pair->part[0]], *part_b = &v->parts[pair->part[1]];
  pair_question q = {v, part_a, part_b, 0};
  const bool skips = v->header->config.retest_all == 0;
  if (skips && outlasts_motion(&q, pair)) {
    pair->outcome = GJK_SCENE_MOTION;
    return;
  }
  q.margin = v->bodies[part_a->body].margin + v->bodies[part_b->body].margin;
  if (refused(&q)) {
    pair->gap = 0;
    pair->outcome = GJK_SCENE_FILTERED;
  } else if (!((skips || is_curved(&q)) && boxes_tell(&q, pair))) {
    const bool cold = !skips || is_curved(&q);
    if (cold || !spheres_tell(&q, pair)) {
      query(&q, cold, pair);
    }
  }
}
