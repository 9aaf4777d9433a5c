// Scenes of the plane: box, ray and nearest queries against a search of all parts; bytes per capacity; room for pairs; the
// order of additions.
#include <stdlib.h>
#include <string.h>

#include "scene/plane_names.h"
// After the names.
#include "check.h"
#include "scene/world.h"

#define HITS 200
#define ITERATIONS 60
#define QUERIES 40
#define SEED 7730

static world w;
static unsigned box_hits, ray_hits, nearest_hits;

static gjk2_vec random_vector(random_state *random, int32_t size) {
  gjk2_vec v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
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
static bool crosses(gjk2_vec from, gjk2_vec to, const gjk2_aabb *box, uint32_t *fraction) {
  const int64_t start[2] = {from.x, from.y}, end[2] = {to.x, to.y};
  const int64_t lower[2] = {box->lower.x, box->lower.y}, upper[2] = {box->upper.x, box->upper.y};
  __extension__ typedef __int128 wide;
  wide in_over = 0, in_under = 1, out_over = 1, out_under = 1;
  for (int i = 0; i < 2; i++) {
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
static uint32_t search(bool way, const gjk2_aabb *asked, gjk_scene_hit *hits) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    for (uint16_t k = 0; b->id.generation != 0 && k < b->setup.part_count; k++) {
      gjk2_aabb box;
      uint32_t fraction = 0;
      gjk2_collider_aabb(&b->colliders[k], &box);
      const bool hit = way ? crosses(asked->lower, asked->upper, &box, &fraction)
                           : asked->lower.x <= box.upper.x && box.lower.x <= asked->upper.x &&
                                 asked->lower.y <= box.upper.y && box.lower.y <= asked->upper.y;
      if (hit) {
        const gjk_scene_hit found = {b->id, k, fraction};
        hits[count++] = found;
      }
    }
  }
  qsort(hits, count, sizeof hits[0], order);
  return count;
}

static gjk_status ask(bool way, const gjk2_aabb *box, const gjk_scene_hit *after, gjk_scene_hit *hits,
                      uint32_t capacity, uint32_t *count) {
  return way ? gjk2_scene_query_ray(&w.scene, &box->lower, &box->upper, after, hits, capacity, count)
             : gjk2_scene_query_box(&w.scene, box, after, hits, capacity, count);
}

static void check_hits(bool way, const gjk2_aabb *box, unsigned *total) {
  static gjk_scene_hit expected[HITS], hits[HITS], few[3];
  uint32_t count, part;
  const uint32_t wanted = search(way, box, expected);
  CHECK(ask(way, box, NULL, hits, HITS, &count) == GJK_OK);
  CHECK_MSG(count == wanted, "%u found, %u expected", count, wanted);
  CHECK(same_hits(hits, expected, wanted));
  for (uint32_t at = 0; at < wanted; at += 3) {
    const uint32_t here = wanted - at < 3 ? wanted - at : 3;
    CHECK(ask(way, box, at == 0 ? NULL : &expected[at - 1], few, 3, &part) == GJK_OK);
    CHECK(part == wanted - at);
    CHECK(same_hits(few, &expected[at], here));
  }
  *total += wanted;
}

static void check_box(random_state *random, int32_t reach) {
  const gjk2_vec a = random_vector(random, reach), b = random_vector(random, reach);
  const gjk2_aabb box = {{a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y},
                         {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y}};
  check_hits(false, &box, &box_hits);
}

// Rays of any length, some along axes, some through the corner of a box.
static void check_ray(random_state *random, int32_t reach) {
  const uint32_t how = random_below(random, 4);
  gjk2_aabb way = {random_vector(random, how == 3 ? INT32_MAX : reach),
                   random_vector(random, how == 3 ? INT32_MAX : reach)};
  const world_body *b = &w.bodies[random_below(random, w.options.bodies)];
  if (how == 0) {
    way.upper.x = way.lower.x;
    way.upper.y = random_below(random, 2) == 0 ? way.lower.y : way.upper.y;
  }
  if ((how == 1 || how == 2) && b->id.generation != 0) {
    gjk2_aabb box;
    gjk2_collider_aabb(&b->colliders[0], &box);
    const gjk2_vec step = random_vector(random, GJK_Q16(2)), corner = how == 1 ? box.lower : box.upper;
    way.lower.x = corner.x - step.x;
    way.lower.y = corner.y - step.y;
    way.upper.x = corner.x + (how == 1 ? 0 : step.x);
    way.upper.y = corner.y + (how == 1 ? 0 : step.y);
  }
  check_hits(true, &way, &ray_hits);
}

static void check_nearest(random_state *random, int32_t reach) {
  const gjk_q16 limit = random_below(random, 2) == 0 ? GJK2_DISTANCE_MAX : random_range(random, 0, GJK_Q16(1));
  gjk2_collider c;
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk_scene_hit hit = {{0, 0}, 0, 0}, expected = {{0, 0}, 0, 0};
  gjk_q16 distance = 0, best = limit;
  bool found, any = false;
  const gjk_body_id ignore = w.bodies[random_below(random, w.options.bodies)].id;
  pose.position = random_vector(random, 2 * reach);
  CHECK(gjk2_collider_init(&c, world_shapes[random_below(random, WORLD_SHAPES)], NULL, 0) == GJK_OK);
  CHECK(gjk2_collider_pose(&c, &pose) == GJK_OK);
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    for (uint16_t k = 0; b->id.generation != 0 && b->id.slot != ignore.slot && k < b->setup.part_count; k++) {
      gjk2_distance_result gap;
      CHECK(gjk2_distance(&c, &b->colliders[k], NULL, &gap) == GJK_OK);
      if (gap.distance < best || (gap.distance == best && !any)) {
        const gjk_scene_hit at = {b->id, k, 0};
        best = gap.distance;
        any = true;
        expected = at;
      }
    }
  }
  CHECK(gjk2_scene_query_nearest(&w.scene, &c, limit, ignore.generation != 0 ? &ignore : NULL, &hit, &distance,
                                 &found) == GJK_OK);
  if (ignore.generation != 0) {
    CHECK_MSG(found == any, "%d, %d expected", (int)distance, (int)best);
    CHECK_MSG(!any || (distance == best && order(&hit, &expected) == 0), "%d, %d expected", (int)distance, (int)best);
    nearest_hits += any;
  }
}

// What one more of each capacity takes: what gjk2/scene.h says, and at most two thirds of what it takes in space.
static void check_bytes(void) {
  const gjk2_scene_config one = {.bodies = 32, .parts = 1, .own_poses = 0, .pairs = 1};
  gjk2_scene_config bodies = one, parts = one, own_poses = one, pairs = one;
  bodies.bodies += 32;
  parts.parts++;
  own_poses.own_poses++;
  pairs.pairs++;
  const size_t bytes = gjk2_scene_bytes(&one);
  CHECK(bytes == 288 + 32 * 44 + 4 + 116 + 32);
  CHECK(gjk2_scene_bytes(&bodies) - bytes == 32 * 44 + 4);
  CHECK(gjk2_scene_bytes(&parts) - bytes == 116);
  CHECK(gjk2_scene_bytes(&own_poses) - bytes == 20);
  CHECK(gjk2_scene_bytes(&pairs) - bytes == 32);
#undef gjk_scene_bytes
#undef gjk_scene_config
  const gjk_scene_config space = {.bodies = 32, .parts = 32, .own_poses = 0, .pairs = 1};
  gjk_scene_config more = space;
  gjk2_scene_config flat = {.bodies = 64, .parts = 64, .own_poses = 0, .pairs = 1}, less = flat;
  more.bodies = more.parts = 64;
  less.bodies = less.parts = 32;
  CHECK(3 * (gjk2_scene_bytes(&flat) - gjk2_scene_bytes(&less)) <=
        2 * (gjk_scene_bytes(&more) - gjk_scene_bytes(&space)));
  more = space;
  more.pairs++;
  CHECK(3 * (gjk2_scene_bytes(&pairs) - bytes) <= 2 * (gjk_scene_bytes(&more) - gjk_scene_bytes(&space)));
}

// How many pairs of parts an update needs room for at first: those whose boxes meet, each grown by its body's margin.
static uint32_t needed_pairs(void) {
  uint32_t count = 0;
  for (uint32_t m = 0; m < w.options.bodies; m++) {
    for (uint32_t n = m + 1; n < w.options.bodies; n++) {
      const world_body *a = &w.bodies[m], *b = &w.bodies[n];
      const bool may = (a->setup.kind != GJK_BODY_STATIC || b->setup.kind != GJK_BODY_STATIC) &&
                       (a->setup.category & b->setup.mask) != 0 && (b->setup.category & a->setup.mask) != 0;
      const int64_t margin = (int64_t)a->setup.margin + b->setup.margin;
      for (int i = 0; may && a->id.generation != 0 && i < a->setup.part_count; i++) {
        for (int k = 0; b->id.generation != 0 && k < b->setup.part_count; k++) {
          gjk2_aabb x, y;
          gjk2_collider_aabb(&a->colliders[i], &x);
          gjk2_collider_aabb(&b->colliders[k], &y);
          count += x.lower.x <= y.upper.x + margin && y.lower.x <= x.upper.x + margin &&
                   x.lower.y <= y.upper.y + margin && y.lower.y <= x.upper.y + margin;
        }
      }
    }
  }
  return count;
}

// The bodies of the world in another scene, added in another order, with room for so many pairs. Returns its status.
static gjk_status copy_world(random_state *random, uint32_t pairs, uint64_t *hash) {
  static uint32_t block[60000];
  static gjk2_report reports[WORLD_REPORTS];
  gjk2_scene_config config = world_config(&w.options);
  const gjk2_scene_bindings bindings = world_bindings(&w.options);
  gjk2_scene scene;
  gjk_progress progress;
  uint32_t slots[WORLD_BODIES], count = 0;
  config.pairs = pairs;
  config.box_margin = random_range(random, 0, GJK_Q16(2));
  CHECK(gjk2_scene_init(&scene, &config, block, sizeof block, world_shapes, WORLD_SHAPES, &bindings) == GJK_OK);
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const uint32_t at = random_below(random, count + 1);
    if (w.bodies[i].id.generation != 0) {
      slots[count] = slots[at];
      slots[at] = i;
      count++;
    }
  }
  for (uint32_t i = 0; i < count; i++) {
    gjk_body_id id;
    CHECK(gjk2_scene_add_at(&scene, slots[i], &w.bodies[slots[i]].setup, &id) == GJK_OK);
  }
  const gjk_status status = gjk2_scene_update(&scene, reports, WORLD_REPORTS, &progress);
  CHECK(status != GJK_OK || gjk2_scene_hash(&scene, hash) == GJK_OK);
  CHECK(gjk2_scene_check(&scene) == GJK_OK);
  return status;
}

// With room for fewer pairs than are needed: CAPACITY. With as many or more: the same, in whatever order bodies came.
static void check_room(random_state *random) {
  uint64_t hash = 0, other = 0;
  const uint32_t needed = needed_pairs();
  CHECK(needed > 9);
  CHECK(copy_world(random, 4000, &hash) == GJK_OK);
  for (uint32_t pairs = needed - 9; pairs < needed; pairs++) {
    CHECK_MSG(copy_world(random, pairs, &other) == GJK_ERROR_CAPACITY, "%u of %u", pairs, needed);
  }
  for (uint32_t pairs = needed; pairs < needed + 9; pairs++) {
    CHECK_MSG(copy_world(random, pairs, &other) == GJK_OK, "%u of %u", pairs, needed);
    CHECK(other == hash);
  }
  CHECK(copy_world(random, 1, &other) == GJK_ERROR_CAPACITY);
}

int main(void) {
  const world_options options = {WORLD_BODIES, GJK_Q16(4), GJK_Q16(0.2), GJK_DETAIL_DISTANCE, 0, 0, false, true, false,
                                 false,        0,          false};
  const gjk2_scene_config config = world_config(&options);
  const size_t bytes = gjk2_scene_bytes(&config);
  void *block = malloc(bytes);
  random_state random = random_seed(check_seed(SEED));
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
    if (i >= 10) {
      check_room(&random);
    }
  }
  check_bytes();
  printf("%u parts in boxes, %u on rays, %u nearest\n", box_hits, ray_hits, nearest_hits);
  CHECK(box_hits > ITERATIONS * QUERIES && ray_hits > ITERATIONS * QUERIES / 2 &&
        nearest_hits > ITERATIONS * QUERIES / 3);
  free(block);
  return check_done("plane_scene_query");
}
