// Box, ray and nearest queries against a search of all parts; and continued in small buffers.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"

#define HITS 200
#define ITERATIONS 60
#define QUERIES 40
#define FAR_TRIALS 2000

static world w;
static unsigned box_hits, ray_hits, nearest_hits;

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  v.z = random_range(random, -size, size);
  return v;
}

static int order(const void *x, const void *y) {
  const gjk_scene_hit *a = x, *b = y;
  const uint32_t key_a[] = {a->fraction, a->body.slot, a->part}, key_b[] = {b->fraction, b->body.slot, b->part};
  for (int i = 0; i < 3; i++) {
    if (key_a[i] != key_b[i]) {
      return key_a[i] < key_b[i] ? -1 : 1;
    }
  }
  return 0;
}

static bool same_hits(const gjk_scene_hit *a, const gjk_scene_hit *b, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    if (order(&a[i], &b[i]) != 0 || a[i].body.generation != b[i].body.generation) {
      return false;
    }
  }
  return true;
}

// Does the way meet the box, and at which fraction? In 128 bits: the way in parts of the product of its lengths.
static bool crosses(gjk_vec3 from, gjk_vec3 to, const gjk_aabb *box, uint32_t *fraction) {
  const int64_t start[3] = {from.x, from.y, from.z}, end[3] = {to.x, to.y, to.z};
  const int64_t lower[3] = {box->lower.x, box->lower.y, box->lower.z};
  const int64_t upper[3] = {box->upper.x, box->upper.y, box->upper.z};
  __extension__ typedef __int128 wide;
  wide in_over = 0, in_under = 1, out_over = 1, out_under = 1;
  for (int i = 0; i < 3; i++) {
    const int64_t d = end[i] - start[i];
    if (d == 0) {
      if (start[i] < lower[i] || start[i] > upper[i]) {
        return false;
      }
      continue;
    }
    const wide length = d > 0 ? d : -d;
    const wide a = d > 0 ? lower[i] - start[i] : start[i] - upper[i];
    const wide b = d > 0 ? upper[i] - start[i] : start[i] - lower[i];
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

// What a query must find, in order; way: a ray, otherwise a box.
static uint32_t search(bool way, gjk_vec3 from, gjk_vec3 to, gjk_scene_hit *hits) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    for (uint16_t k = 0; b->id.generation != 0 && k < b->setup.part_count; k++) {
      gjk_aabb box;
      uint32_t fraction = 0;
      gjk_collider_aabb(&b->colliders[k], &box);
      const bool hit = way ? crosses(from, to, &box, &fraction)
                           : from.x <= box.upper.x && box.lower.x <= to.x && from.y <= box.upper.y &&
                                 box.lower.y <= to.y && from.z <= box.upper.z && box.lower.z <= to.z;
      if (hit) {
        const gjk_scene_hit found = {b->id, k, fraction};
        hits[count++] = found;
      }
    }
  }
  qsort(hits, count, sizeof hits[0], order);
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
  const uint32_t wanted = search(way, box->lower, box->upper, expected);
  CHECK(ask(way, box, NULL, hits, HITS, &count) == GJK_OK);
  CHECK_MSG(count == wanted, "%u found, %u expected", count, wanted);
  CHECK_MSG(same_hits(hits, expected, wanted), "%u found, %u expected", count, wanted);
  CHECK(ask(way, box, NULL, NULL, 0, &count) == GJK_OK);
  CHECK(count == wanted);
  for (uint32_t at = 0; at < wanted; at += 3) {
    const uint32_t here = wanted - at < 3 ? wanted - at : 3;
    CHECK(ask(way, box, at == 0 ? NULL : &expected[at - 1], few, 3, &part) == GJK_OK);
    CHECK(part == wanted - at);
    CHECK(same_hits(few, &expected[at], here));
  }
  *total += wanted;
}

static void check_box(random_state *random, int32_t reach) {
  const gjk_vec3 a = random_vector(random, reach), b = random_vector(random, reach);
  const gjk_aabb box = {{a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z},
                        {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z}};
  check_hits(false, &box, &box_hits);
}

// Rays of any length, some along axes, some through the corner of a box.
static void check_ray(random_state *random, int32_t reach) {
  const uint32_t how = random_below(random, 4);
  gjk_aabb way = {random_vector(random, how == 3 ? INT32_MAX : reach),
                  random_vector(random, how == 3 ? INT32_MAX : reach)};
  const world_body *b = &w.bodies[random_below(random, w.options.bodies)];
  if (how == 0) {
    way.upper.x = way.lower.x;
    way.upper.y = random_below(random, 2) == 0 ? way.lower.y : way.upper.y;
  }
  if (how < 3 && b->id.generation != 0) {
    gjk_aabb box;
    gjk_collider_aabb(&b->colliders[0], &box);
    const gjk_vec3 step = random_vector(random, GJK_Q16(2)),
                   corner = random_below(random, 2) == 0 ? box.lower : box.upper;
    way.upper.x = how == 0 ? way.upper.x : corner.x;
    way.upper.y = how == 0 ? way.upper.y : corner.y;
    way.upper.z = corner.z;
    if (how == 2) {
      way.lower.x = corner.x - step.x;
      way.lower.y = corner.y - step.y;
      way.lower.z = corner.z - step.z;
      way.upper.x = corner.x + step.x;
      way.upper.y = corner.y + step.y;
      way.upper.z = corner.z + step.z;
    }
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
  const int64_t along_x = larger((int64_t)x.lower.x - y.upper.x, (int64_t)y.lower.x - x.upper.x);
  const int64_t along_y = larger((int64_t)x.lower.y - y.upper.y, (int64_t)y.lower.y - x.upper.y);
  const int64_t along_z = larger((int64_t)x.lower.z - y.upper.z, (int64_t)y.lower.z - x.upper.z);
  const int64_t bound = larger(gap.lower, larger(along_x, larger(along_y, along_z)));
  return status == GJK_OK ? gap.distance : bound < INT32_MAX ? (gjk_q16)bound : INT32_MAX;
}

static void check_nearest(random_state *random, int32_t reach) {
  const gjk_q16 limit = random_below(random, 2) == 0 ? GJK_DISTANCE_MAX : random_range(random, 0, GJK_Q16(1));
  gjk_collider c;
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_scene_hit hit = {{0, 0}, 0, 0}, expected = {{0, 0}, 0, 0};
  gjk_q16 distance = 0, best = limit;
  bool found, any = false;
  const gjk_body_id ignore = w.bodies[random_below(random, w.options.bodies)].id;
  pose.position = random_vector(random, 2 * reach);
  gjk_collider_init(&c, world_shapes[random_below(random, WORLD_SHAPES)], NULL, 0);
  gjk_collider_pose(&c, &pose);
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    if (b->id.generation == 0 || b->id.slot == ignore.slot) {
      continue;
    }
    for (uint16_t k = 0; k < b->setup.part_count; k++) {
      const gjk_q16 gap = distance_of(&c, &b->colliders[k]);
      if (gap < best || (gap == best && !any)) {
        const gjk_scene_hit at = {b->id, k, 0};
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
    CHECK_MSG(!any || (distance == best && order(&hit, &expected) == 0), "%d, %d expected", (int)distance, (int)best);
    nearest_hits += any;
  }
}

static void check_refusals(void) {
  const gjk_aabb flipped = {{0, 0, 0}, {5, -1, 5}}, flipped_x = {{1, 0, 0}, {0, 0, 0}},
                 flipped_z = {{0, 0, 3}, {0, 0, 2}}, point = {{0, 0, 0}, {0, 0, 0}};
  uint32_t count;
  gjk_scene_hit hit;
  gjk_q16 distance;
  bool found;
  gjk_collider c = {0};
  CHECK(gjk_scene_query_box(&w.scene, &flipped, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_query_box(&w.scene, &flipped_x, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_query_box(&w.scene, &flipped_z, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_scene_query_box(&w.scene, &point, NULL, NULL, 0, &count) == GJK_OK);
  CHECK(gjk_scene_query_box(NULL, &point, NULL, NULL, 0, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_ray(NULL, &flipped.lower, &flipped.upper, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_box(&w.scene, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_box(&w.scene, &flipped, NULL, NULL, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_box(&w.scene, &flipped, NULL, &hit, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_ray(&w.scene, &flipped.lower, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 5, NULL, &hit, &distance, &found) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_scene_query_nearest(&w.scene, NULL, 5, NULL, &hit, &distance, &found) == GJK_ERROR_NULL);
  CHECK(gjk_collider_init(&c, world_shapes[0], NULL, 0) == GJK_OK);
  const gjk_pose identity = GJK_POSE_IDENTITY;
  CHECK(gjk_collider_pose(&c, &identity) == GJK_OK);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, -1, NULL, &hit, &distance, &found) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_scene_query_nearest(NULL, &c, 0, NULL, &hit, &distance, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 0, NULL, NULL, &distance, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 0, NULL, &hit, NULL, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_nearest(&w.scene, &c, 0, NULL, &hit, &distance, NULL) == GJK_ERROR_NULL);
}

// Among equally near parts the lowest slot, then the lowest part, whatever the order in which the tree holds them; a body
// is left out by its whole id.
static void check_equals(void) {
  static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5));
  static const gjk_shape *const shapes[] = {&ball};
  static const gjk_scene_config config = {8, 16, 16, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[1400];
  static const gjk_vec3 corner[8] = {{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                                     {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
  gjk_scene scene;
  gjk_scene_hit hit;
  gjk_q16 distance;
  bool found;
  gjk_collider c;
  const gjk_pose identity = GJK_POSE_IDENTITY;
  CHECK(gjk_collider_init(&c, &ball, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&c, &identity) == GJK_OK);
  for (uint32_t first = 0; first < 8; first++) {  // slots from there on, in either order
    gjk_body_id bodies[8];
    CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
    for (uint32_t i = first; i < 8; i++) {
      gjk_part parts[2] = {{0, true, GJK_POSE_IDENTITY}, {0, true, GJK_POSE_IDENTITY}};
      for (int k = 0; k < 2; k++) {  // the second across the middle
        const gjk_vec3 *at = &corner[k == 0 ? i : 7 - i];
        parts[k].pose.position.x = at->x * GJK_Q16(2);
        parts[k].pose.position.y = at->y * GJK_Q16(2);
        parts[k].pose.position.z = at->z * GJK_Q16(2);
      }
      const gjk_body_setup setup = {GJK_POSE_IDENTITY, parts, 2, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
      const uint32_t slot = first % 2 == 0 ? i : 7 - (i - first);
      CHECK(gjk_scene_add_at(&scene, slot, &setup, &bodies[slot]) == GJK_OK);
    }
    for (uint32_t slot = first; slot < 8; slot++) {
      CHECK(gjk_scene_query_nearest(&scene, &c, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(found);
      CHECK(hit.body.slot == slot);
      CHECK(hit.part == 0);
      CHECK(distance == 161487);  // 2 sqrt(3) - 1
      CHECK(gjk_scene_query_nearest(&scene, &c, 161487, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(found);
      CHECK(gjk_scene_query_nearest(&scene, &c, 161486, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(!found);
      CHECK(gjk_scene_query_nearest(&scene, &c, 0, NULL, &hit, &distance, &found) == GJK_OK);
      CHECK(!found);
      CHECK(gjk_scene_query_nearest(&scene, &c, 161487, &bodies[slot], &hit, &distance, &found) == GJK_OK);
      CHECK(found == (slot < 7));
      CHECK(!found || hit.body.slot == slot + 1);
      const gjk_body_id stale = {slot, bodies[slot].generation + 2};
      CHECK(gjk_scene_query_nearest(&scene, &c, 161487, &stale, &hit, &distance, &found) == GJK_OK);
      CHECK(found);
      CHECK(hit.body.slot == slot);
      CHECK(gjk_scene_remove(&scene, bodies[slot]) == GJK_OK);
    }
    CHECK(gjk_scene_query_nearest(&scene, &c, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
    CHECK(!found);
  }
}

// Beyond 16384 units a distance is reported up to 2 LSB off, less than the gap of the boxes, too: the nearest part is still the
// one that gjk_distance says is.
static void check_far(random_state *random) {
  static const gjk_shape slab = GJK_BOX(INT32_C(1) << 27, 9000, 9000);
  static const gjk_shape *const shapes[] = {&slab};
  static const gjk_scene_config config = {3, 3, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[600];
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  const unsigned trials = (unsigned)check_trials(FAR_TRIALS);
  unsigned below = 0;
  for (unsigned i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    gjk_scene scene;
    gjk_scene_hit hit;
    gjk_body_id bodies[3];
    gjk_collider c, part_collider;
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_q16 distance, best = GJK_DISTANCE_MAX;
    uint32_t nearest = 0;
    bool found;
    const int32_t sign = random_below(random, 2) == 0 ? 1 : -1,
                  away = random_range(random, 1 << 30, (1 << 30) + (1 << 27) - 5);
    pose.position.x = -sign * away;
    CHECK(gjk_collider_init(&c, &slab, NULL, 0) == GJK_OK);
    CHECK(gjk_collider_pose(&c, &pose) == GJK_OK);
    CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
    for (unsigned k = 0; k < 3; k++) {
      setup.pose.position.x = sign * (away + random_range(random, 0, 4));
      setup.pose.position.y = random_range(random, -9000, 9000);
      CHECK(gjk_scene_add(&scene, &setup, &bodies[k]) == GJK_OK);
      CHECK(gjk_scene_collider(&scene, bodies[k], 0, &part_collider) == GJK_OK);
      gjk_distance_result r = {0};
      CHECK(gjk_distance(&c, &part_collider, NULL, &r) == GJK_OK);
      below += r.distance < (int64_t)away + sign * setup.pose.position.x - (1 << 28);
      nearest = r.distance < best ? k : nearest;
      best = r.distance < best ? r.distance : best;
    }
    CHECK(gjk_scene_query_nearest(&scene, &c, GJK_DISTANCE_MAX, NULL, &hit, &distance, &found) == GJK_OK);
    CHECK(found);
    CHECK(distance == best);
    CHECK(hit.body.slot == nearest);
  }
  CHECK(below > trials / 2);
}

// Ways along the faces and edges of a box, and an LSB beside them; ways that end at it; points.
static void check_borders(void) {
  static const gjk_shape crate = GJK_BOX(100, 100, 100);
  static const gjk_shape *const shapes[] = {&crate};
  static const gjk_scene_config config = {1, 1, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  static uint32_t block[400];
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_scene scene;
  gjk_scene_hit hit;
  gjk_body_id body;
  gjk_collider c;
  gjk_aabb box;
  uint32_t count;
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 1, NULL) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  CHECK(gjk_scene_collider(&scene, body, 0, &c) == GJK_OK);
  CHECK(gjk_collider_aabb(&c, &box) == GJK_OK);
  CHECK(box.lower.x == -100);
  CHECK(box.upper.z == 100);
  for (int axis = 0; axis < 3; axis++) {
    for (gjk_q16 s = -101; s <= 101; s += s == -101 || s == 100 ? 1 : 200) {
      for (gjk_q16 t = -101; t <= 101; t += t == -101 || t == 100 ? 1 : 200) {
        const bool inside = s >= -100 && s <= 100 && t >= -100 && t <= 100;
        for (gjk_q16 end = -101; end <= 101; end++) {
          const gjk_vec3 from = {axis == 0 ? -300 : s, axis == 1 ? -300 : axis == 0 ? s : t, axis == 2 ? -300 : t};
          gjk_vec3 to = from, point = from;
          *(axis == 0 ? &to.x : axis == 1 ? &to.y : &to.z) = end;
          *(axis == 0 ? &point.x : axis == 1 ? &point.y : &point.z) = end;
          CHECK(gjk_scene_query_ray(&scene, &from, &to, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 ? 1 : 0));
          const uint32_t fraction = (uint32_t)((UINT64_C(200) << 30) / (uint32_t)(end + 300));
          CHECK(count == 0 || hit.fraction == fraction);
          CHECK(gjk_scene_query_ray(&scene, &to, &from, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 ? 1 : 0));
          CHECK(count == 0 || hit.fraction == (end <= 100 ? 0 : (uint32_t)((UINT64_C(1) << 30) / 401)));
          CHECK(gjk_scene_query_ray(&scene, &point, &point, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 && end <= 100 ? 1 : 0));
          CHECK(count == 0 || hit.fraction == 0);
          const gjk_aabb dot = {point, point};
          CHECK(gjk_scene_query_box(&scene, &dot, NULL, &hit, 1, &count) == GJK_OK);
          CHECK(count == (inside && end >= -100 && end <= 100 ? 1 : 0));
        }
      }
    }
  }
}

int main(void) {
  const world_options options = {WORLD_BODIES, GJK_Q16(4), GJK_Q16(0.2), GJK_DETAIL_TOUCH, 0, 0, false, false, false,
                                 false,        0,          false};
  const gjk_scene_config config = world_config(&options);
  const size_t bytes = gjk_scene_bytes(&config);
  void *block = malloc(bytes);
  random_state random = random_seed(check_seed(31));
  CHECK(block != NULL);
  CHECK(world_start(&w, &options, block, bytes));
  for (int i = 0; i < ITERATIONS; i++) {
    check_trial((unsigned long)i, NULL, NULL);
    for (int k = 0; k < 20; k++) {
      CHECK(world_change(&w, &random));
    }
    for (int k = 0; k < QUERIES; k++) {
      check_box(&random, options.reach);
      check_ray(&random, options.reach);
      check_nearest(&random, options.reach);
    }
  }
  check_refusals();
  check_equals();
  check_borders();
  check_far(&random);
  printf("%u parts in boxes, %u on rays, %u nearest\n", box_hits, ray_hits, nearest_hits);
  CHECK(box_hits > ITERATIONS * QUERIES);
  CHECK(ray_hits > ITERATIONS * QUERIES / 2);
  CHECK(nearest_hits > ITERATIONS * QUERIES / 3);
  free(block);
  return check_done("scene_query");
}
