// Scenes of the plane: box, ray and nearest queries against a search of all parts; bytes per capacity; room for pairs; the
// order of additions.
#include "scene/plane_names.h"

#define AXES 2
#define SEED 7730

// After the names.
#include "scene_queries.h"

static gjk_q16 *along(gjk2_vec *v, int axis) {
  return axis == 0 ? &v->x : &v->y;
}

static void aim(random_state *random, uint32_t how, const gjk2_aabb *box, gjk2_aabb *way) {
  if (how == 1 || how == 2) {
    const gjk2_vec step = random_vector(random, GJK_Q16(2)), corner = how == 1 ? box->lower : box->upper;
    way->lower.x = corner.x - step.x;
    way->lower.y = corner.y - step.y;
    way->upper.x = corner.x + (how == 1 ? 0 : step.x);
    way->upper.y = corner.y + (how == 1 ? 0 : step.y);
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
  CHECK(bytes == 292 + 32 * 44 + 4 + 116 + 32);
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
  random_state random = random_seed(check_seed(SEED));
  check_queries(&options, &random, check_room);
  check_bytes();
  free(w.scene.block);
  return check_done("plane_scene_query");
}
