// Scenes whose blocks are changed and sealed again, and used where they are opened all the same: tests/build/bounds.sh
// builds it with the assertions of the sources as checks. Prints how many blocks there were.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/world.h"
#include "src/scene/gjk_scene_block.h"

#define BODIES 9
#define PARTS 13
#define PAIRS 16
#define HITS 4
#define WORDS (sizeof(gjk_scene_header) / 4)

static gjk_vec3 some_position(random_state *random) {
  const int32_t reach = random_below(random, 9) == 0 ? INT32_MAX : GJK_Q16(1.5);
  gjk_vec3 p;
  p.x = random_range(random, -reach, reach);
  p.y = random_range(random, -reach, reach);
  p.z = random_range(random, -reach, reach);
  return p;
}

static gjk_pose some_pose(random_state *random) {
  const gjk_quat q = {random_range(random, -9, 9), random_range(random, -9, 9), random_range(random, -9, 9), 10};
  gjk_pose pose;
  pose.position = some_position(random);
  (void)gjk_quat_normalize(&q, &pose.rotation);
  return pose;
}

static gjk_body_id some_body(const gjk_scene *scene, random_state *random) {
  gjk_body_id body = {0, 0};
  (void)gjk_scene_body_at(scene, random_below(random, BODIES + 1), &body);
  return body;
}

static void add(gjk_scene *scene, random_state *random) {
  gjk_part parts[3];
  gjk_body_id body;
  gjk_body_setup setup = {some_pose(random), parts, 1, 0, 0, UINT32_MAX, UINT32_MAX, 0, 0};
  for (int i = 0; i < 3; i++) {
    parts[i].shape = (uint16_t)random_below(random, WORLD_SHAPES);
    parts[i].own_pose = random_below(random, 2) == 0;
    parts[i].pose = some_pose(random);
  }
  setup.part_count = (uint16_t)(1 + random_below(random, 3));
  setup.kind = (uint8_t)random_below(random, 3);
  setup.detail = (uint8_t)(random_below(random, 3) == 0 ? random_below(random, 4) : 0);
  setup.margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, GJK_Q16(0.5));
  if (random_below(random, 2) == 0) {
    (void)gjk_scene_add(scene, &setup, &body);
  } else {
    (void)gjk_scene_add_at(scene, random_below(random, BODIES + 1), &setup, &body);
  }
}

static void change(gjk_scene *scene, random_state *random) {
  const gjk_body_id body = some_body(scene, random);
  const gjk_pose pose = some_pose(random);
  const uint16_t part = (uint16_t)random_below(random, 3);
  switch (random_below(random, 11)) {
    case 0: (void)gjk_scene_remove(scene, body); break;
    case 1: (void)gjk_scene_sleep(scene, body); break;
    case 2: (void)gjk_scene_wake(scene, body); break;
    case 3: (void)gjk_scene_set_shape(scene, body, part, (uint16_t)random_below(random, WORLD_SHAPES + 1)); break;
    case 4: (void)gjk_scene_set_filter(scene, body, random_u32(random), random_u32(random)); break;
    case 5: (void)gjk_scene_refilter(scene, body); break;
    case 6: (void)gjk_scene_teleport(scene, body, &pose); break;
    case 7:
    case 8: (void)gjk_scene_move(scene, body, &pose); break;
    default: add(scene, random); break;
  }
}

static void ask(gjk_scene *scene, random_state *random) {
  const gjk_body_id body = some_body(scene, random), other = some_body(scene, random);
  const gjk_vec3 from = some_position(random), to = some_position(random);
  gjk_scene_hit hits[HITS], after = {{0, 0}, 0, 0};
  gjk_collider collider = {0};
  gjk_report near;
  gjk_manifold manifold;
  gjk_aabb box = {from, to};
  gjk_q16 distance;
  bool found;
  uint64_t hash;
  uint32_t count, cursor = random_below(random, PAIRS);
  after.body = other;
  after.part = (uint16_t)random_below(random, 3);
  const gjk_scene_hit *from_hit = random_below(random, 2) == 0 ? NULL : &after;
  (void)gjk_scene_query_ray(scene, &from, &to, from_hit, hits, random_below(random, HITS + 1), &count);
  if (gjk_scene_collider(scene, body, after.part, &collider) == GJK_OK) {
    (void)gjk_scene_query_nearest(scene, &collider, GJK_Q16(2), &body, hits, &distance, &found);
    (void)gjk_collider_aabb(&collider, &box);
  }
  (void)gjk_scene_query_box(scene, &box, from_hit, hits, random_below(random, HITS + 1), &count);
  (void)gjk_scene_next_near(scene, &cursor, &near, &found);
  near.a = body;
  near.b = other;
  near.part_a = near.part_b = after.part;
  (void)gjk_scene_manifold(scene, &near, 4, &manifold);
  (void)gjk_scene_hash(scene, &hash);
  (void)gjk_scene_check(scene);
}

static void update(gjk_scene *scene, random_state *random) {
  gjk_report reports[PAIRS];
  gjk_progress progress;
  uint32_t pairs;
  if (random_below(random, 3) == 0 && gjk_scene_update_begin(scene, &pairs) == GJK_OK && pairs > 0) {
    const uint32_t first = random_below(random, pairs);
    (void)gjk_scene_test_pairs(scene, first, first + random_below(random, pairs - first + 1));
  }
  (void)gjk_scene_update_slice(scene, random_below(random, 3) == 0 ? random_below(random, 9) : PAIRS, reports,
                               random_below(random, 3) == 0 ? random_below(random, 5) : PAIRS, &progress);
}

// What passed the check passes it after any call.
static bool go_on(gjk_scene *scene, random_state *random, int iterations) {
  for (int i = 0; i < iterations; i++) {
    const uint32_t changes = random_below(random, 6);
    for (uint32_t k = 0; k < changes; k++) {
      change(scene, random);
      if (gjk_scene_check(scene) != GJK_OK) {
        return false;
      }
    }
    ask(scene, random);
    update(scene, random);
    if (gjk_scene_check(scene) != GJK_OK) {
      return false;
    }
  }
  return true;
}

// What a field may hold instead.
static uint32_t some_word(const uint32_t *block, uint32_t words, uint32_t old, random_state *random) {
  switch (random_below(random, 9)) {
    case 0: return GJK_SCENE_NONE;
    case 1: return old + 1;
    case 2: return old - 1;
    case 3: return block[random_below(random, words)];
    case 4: return random_below(random, PAIRS + 2);
    case 5: return GJK_SCENE_LEAF | random_below(random, PARTS + 1);
    case 6: return random_u32(random);
    default: return old ^ UINT32_C(1) << random_below(random, 32);
  }
}

// Changes one to three words of a block; one in four of them lies in its header.
static void forge(uint32_t *block, uint32_t words, random_state *random) {
  const uint32_t changes = 1 + random_below(random, 3);
  for (uint32_t i = 0; i < changes; i++) {
    const uint32_t at = random_below(random, 4) == 0 ? random_below(random, WORDS) : random_below(random, words);
    block[at] = some_word(block, words, block[at], random);
  }
}

static gjk_scene_config some_config(random_state *random) {
  gjk_scene_config config = {BODIES, PARTS, PARTS / 2, PAIRS, GJK_Q16(0.25), 0, 0, 0, 0, 0, 0};
  config.detail = (uint8_t)(random_below(random, 3) == 0 ? random_below(random, 4) : 0);
  config.persist = (uint8_t)random_below(random, 2);
  config.retest_all = random_below(random, 4) == 0;
  config.workspace_cells = random_below(random, 60);
  return config;
}

int main(int count, char **arguments) {
  const uint64_t blocks = count > 1 ? strtoull(arguments[1], NULL, 10) : 1000;
  const world_options usual = {0};
  const gjk_scene_bindings bindings = world_bindings(&usual);
  uint64_t opened = 0;
  for (uint64_t i = 0; i < blocks / 50; i++) {
    random_state random = random_seed(i);
    const gjk_scene_config config = some_config(&random);
    const size_t bytes = gjk_scene_bytes(&config);
    uint32_t *block = malloc(bytes);
    gjk_scene scene;
    if (gjk_scene_init(&scene, &config, block, bytes, world_shapes, WORLD_SHAPES, &bindings) != GJK_OK) {
      return 1;
    }
    for (int k = 0; k < 50; k++) {
      uint32_t *copy = malloc(bytes);
      gjk_scene other;
      if (!go_on(&scene, &random, 1)) {
        return 1;
      }
      memcpy(copy, block, bytes);
      forge(copy, (uint32_t)(bytes / 4), &random);
      if (gjk_scene_attach(&other, copy, bytes, world_shapes, WORLD_SHAPES, NULL) == GJK_OK &&
          gjk_scene_seal(&other) == GJK_OK &&
          gjk_scene_open(&other, copy, bytes, world_shapes, WORLD_SHAPES, &bindings) == GJK_OK) {
        opened++;
        if (!go_on(&other, &random, 5)) {
          return 1;
        }
      }
      free(copy);
    }
    free(block);
  }
  printf("%llu\n", (unsigned long long)blocks);
  return opened * 8 > blocks && opened * 2 < blocks ? 0 : 1;
}
