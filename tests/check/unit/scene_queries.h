// Box, ray and nearest queries of the scene of a world against a search of all parts; and continued in small buffers.
//
// A test of the plane includes it under the plane's names. Each test says before that what its dimension is: AXES; the
// component of a vector along an axis; and how rays are aimed, how of 0 to 3, at a box.
#ifndef SCENE_QUERIES_H
#define SCENE_QUERIES_H

#include <stdlib.h>

#include "check.h"
#include "scene/world.h"
#include "scene_hits.h"

static gjk_q16 *along(gjk_vec3 *v, int axis);
static void aim(random_state *random, uint32_t how, const gjk_aabb *box, gjk_aabb *way);

#define HITS 200
#define ITERATIONS 60
#define QUERIES 40

static world w;
static unsigned box_hits, ray_hits, nearest_hits;

static gjk_q16 component(gjk_vec3 v, int axis) {
  return *along(&v, axis);
}

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  for (int axis = 0; axis < AXES; axis++) {
    *along(&v, axis) = random_range(random, -size, size);
  }
  return v;
}

// Does the way meet the box, and at which fraction? In 128 bits: the way in parts of the product of its lengths.
static bool crosses(gjk_vec3 from, gjk_vec3 to, const gjk_aabb *box, uint32_t *fraction) {
  __extension__ typedef __int128 wide;
  wide in_over = 0, in_under = 1, out_over = 1, out_under = 1;
  for (int axis = 0; axis < AXES; axis++) {
    const int64_t start = component(from, axis), d = component(to, axis) - start;
    const int64_t lower = component(box->lower, axis), upper = component(box->upper, axis);
    if (d == 0) {
      if (start < lower || start > upper) {
        return false;
      }
      continue;
    }
    const wide length = d > 0 ? d : -d;
    const wide a = d > 0 ? lower - start : start - upper;
    const wide b = d > 0 ? upper - start : start - lower;
    if (a * in_under > in_over * length) {
      in_over = a;
      in_under = length;
    }
    if (b * out_under < out_over * length) {
      out_over = b;
      out_under = length;
    }
  }
  if (in_over * out_under > out_over * in_under) {
    return false;
  }
  *fraction = (uint32_t)(in_over * (1 << 30) / in_under);
  return true;
}

static bool boxes_meet(const gjk_aabb *a, const gjk_aabb *b) {
  bool meet = true;
  for (int axis = 0; axis < AXES; axis++) {
    meet = meet && component(a->lower, axis) <= component(b->upper, axis) &&
           component(b->lower, axis) <= component(a->upper, axis);
  }
  return meet;
}

// What a query must find, in order; way: a ray, otherwise a box.
static uint32_t search(bool way, const gjk_aabb *asked, gjk_scene_hit *hits) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    for (uint16_t k = 0; b->id.generation != 0 && k < b->setup.part_count; k++) {
      gjk_aabb box;
      uint32_t fraction = 0;
      gjk_collider_aabb(&b->colliders[k], &box);
      if (way ? crosses(asked->lower, asked->upper, &box, &fraction) : boxes_meet(asked, &box)) {
        const gjk_scene_hit found = {b->id, k, fraction, b->setup.user};
        hits[count++] = found;
      }
    }
  }
  qsort(hits, count, sizeof hits[0], order_hits);
  return count;
}

static gjk_status ask(bool way, const gjk_aabb *box, const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity,
                      uint32_t *count) {
  return way ? gjk_scene_query_ray(&w.scene, &box->lower, &box->upper, after, hits, capacity, count)
             : gjk_scene_query_box(&w.scene, box, after, hits, capacity, count);
}

static void check_hits(bool way, const gjk_aabb *box, unsigned *total) {
  static gjk_scene_hit expected[HITS], hits[HITS], few[3];
  uint32_t count, part;
  const uint32_t wanted = search(way, box, expected);
  CHECK(ask(way, box, NULL, hits, HITS, &count) == GJK_OK);
  CHECK_MSG(count == wanted, "%u found, %u expected", count, wanted);
  CHECK_MSG(same_hits(hits, expected, wanted), "%u found, %u expected", count, wanted);
  CHECK(ask(way, box, NULL, NULL, 0, &count) == GJK_OK);
  CHECK(count == wanted);
  for (uint32_t at = 0, room = 1; at < wanted; at += room, room = room % 3 + 1) {
    const uint32_t here = wanted - at < room ? wanted - at : room;
    CHECK(ask(way, box, at == 0 ? NULL : &expected[at - 1], few, room, &part) == GJK_OK);
    CHECK(part == wanted - at);
    CHECK(same_hits(few, &expected[at], here));
  }
  *total += wanted;
}

static void check_box(random_state *random, int32_t reach) {
  gjk_aabb box = {random_vector(random, reach), random_vector(random, reach)};
  for (int axis = 0; axis < AXES; axis++) {
    gjk_q16 *lower = along(&box.lower, axis), *upper = along(&box.upper, axis);
    if (*lower > *upper) {
      const gjk_q16 kept = *lower;
      *lower = *upper;
      *upper = kept;
    }
  }
  check_hits(false, &box, &box_hits);
}

// Rays of any length, some along axes, some aimed at a corner of a box.
static void check_ray(random_state *random, int32_t reach) {
  const uint32_t how = random_below(random, 4);
  gjk_aabb way = {random_vector(random, how == 3 ? INT32_MAX : reach),
                  random_vector(random, how == 3 ? INT32_MAX : reach)};
  const world_body *b = &w.bodies[random_below(random, w.options.bodies)];
  if (how == 0) {
    way.upper.x = way.lower.x;
    way.upper.y = random_below(random, 2) == 0 ? way.lower.y : way.upper.y;
  }
  if (b->id.generation != 0) {
    gjk_aabb box;
    gjk_collider_aabb(&b->colliders[0], &box);
    aim(random, how, &box, &way);
  }
  check_hits(true, &way, &ray_hits);
}

static int64_t larger(int64_t a, int64_t b) {
  return a > b ? a : b;
}

// The distance; where the ceiling on iterations leaves it open, the larger of the bounds that the query and the boxes prove.
static gjk_q16 distance_of(const gjk_collider *a, const gjk_collider *b) {
  gjk_distance_result gap;
  gjk_aabb x, y;
  const gjk_status status = gjk_distance(a, b, NULL, &gap);
  CHECK(status == GJK_OK || (status == GJK_ERROR_ITERATION_LIMIT && world_is_tight()));
  gjk_collider_aabb(a, &x);
  gjk_collider_aabb(b, &y);
  int64_t bound = gap.lower;
  for (int axis = 0; axis < AXES; axis++) {
    bound = larger(bound, larger((int64_t)component(x.lower, axis) - component(y.upper, axis),
                                 (int64_t)component(y.lower, axis) - component(x.upper, axis)));
  }
  return status == GJK_OK ? gap.distance : bound < INT32_MAX ? (gjk_q16)bound : INT32_MAX;
}

static void check_nearest(random_state *random, int32_t reach) {
  const gjk_q16 limit = random_below(random, 2) == 0 ? GJK_DISTANCE_MAX : random_range(random, 0, GJK_Q16(1));
  gjk_collider c;
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_scene_hit hit = {{0, 0}, 0, 0, 0}, expected = {{0, 0}, 0, 0, 0};
  gjk_q16 distance = 0, best = limit;
  bool found, any = false;
  const gjk_body_id ignore = w.bodies[random_below(random, w.options.bodies)].id;
  pose.position = random_vector(random, 2 * reach);
  CHECK(gjk_collider_init(&c, world_shapes[random_below(random, WORLD_SHAPES)], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&c, &pose) == GJK_OK);
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    if (b->id.generation == 0 || b->id.slot == ignore.slot) {
      continue;
    }
    for (uint16_t k = 0; k < b->setup.part_count; k++) {
      const gjk_q16 gap = distance_of(&c, &b->colliders[k]);
      if (gap < best || (gap == best && !any)) {
        const gjk_scene_hit at = {b->id, k, 0, b->setup.user};
        best = gap;
        any = true;
        expected = at;
      }
    }
  }
  CHECK(gjk_scene_query_nearest(&w.scene, &c, limit, ignore.generation != 0 ? &ignore : NULL, &hit, &distance,
                                &found) == GJK_OK);
  if (ignore.generation != 0) {
    CHECK_MSG(found == any, "%d, %d expected", (int)distance, (int)best);
    CHECK_MSG(!any || (distance == best && order_hits(&hit, &expected) == 0 && hit.user == expected.user),
              "%d, %d expected", (int)distance, (int)best);
    nearest_hits += any;
  }
}

// Changes a world of these options and asks; after the tenth round also again, unless it is NULL.
static void check_queries(const world_options *options, random_state *random, void (*again)(random_state *random)) {
  const gjk_scene_config config = world_config(options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  CHECK(block != NULL);
  CHECK(world_start(&w, options, block, bytes));
  for (int i = 0; i < ITERATIONS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    for (int k = 0; k < 20; k++) {
      CHECK(world_change(&w, random));
    }
    for (int k = 0; k < QUERIES; k++) {
      check_box(random, options->reach);
      check_ray(random, options->reach);
      check_nearest(random, options->reach);
    }
    if (i >= 10 && again != NULL) {
      again(random);
    }
  }
  printf("%u parts in boxes, %u on rays, %u nearest\n", box_hits, ray_hits, nearest_hits);
  CHECK(box_hits > ITERATIONS * QUERIES);
  CHECK(ray_hits > ITERATIONS * QUERIES / 2);
  CHECK(nearest_hits > ITERATIONS * QUERIES / 3);
}

#endif
