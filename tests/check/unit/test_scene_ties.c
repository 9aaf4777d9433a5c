// First hits where ties are the rule: bodies on a lattice, many at one place, rays and casts that meet several at one fraction.
// Against a cast of every part: the least (fraction, slot, part), whatever the order in which the tree holds them.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"

// The test of the plane has included the plane's.
#ifndef WORLD_OF_PLANE
#include "gjk/probe.h"
#endif

#ifndef TEST_NAME
#define TEST_NAME "scene_ties"
#define BOX GJK_BOX(HALF, HALF, HALF)
#define BALL GJK_SPHERE(HALF)
#endif

#define SEED 7741
#define WORLDS check_trials(60)
#define QUERIES 60
#define BODIES 48
#define STEP GJK_Q16(1.0)
#define HALF GJK_Q16(0.5)
#define SIDE 3  // the lattice goes so far from the origin

static const gjk_shape box = BOX, ball = BALL;
static const gjk_shape *const shapes[] = {&box, &ball};
static gjk_scene scene;
static gjk_body_id ids[BODIES];
static unsigned long ties, hits, misses;

static gjk_vec3 lattice_point(random_state *random, int32_t side, int32_t step) {
  gjk_vec3 v = {0};
  v.x = random_range(random, -side, side) * step;
  v.y = random_range(random, -side, side) * step;
#ifndef WORLD_OF_PLANE
  v.z = random_range(random, -side, side) * step;
#endif
  return v;
}

// Bodies in shuffled slots, each of one or two parts; some move afterwards, so that trees differ.
static bool fill_scene(random_state *random) {
  uint32_t slot[BODIES];
  gjk_pose pose = GJK_POSE_IDENTITY;
  for (uint32_t i = 0; i < BODIES; i++) {
    slot[i] = i;
  }
  for (uint32_t i = BODIES; i > 1; i--) {
    const uint32_t k = random_below(random, i), other = slot[k];
    slot[k] = slot[i - 1];
    slot[i - 1] = other;
  }
  for (uint32_t i = 0; i < BODIES; i++) {
    gjk_part parts[2];
    gjk_body_setup setup = {0};
    memset(parts, 0, sizeof parts);
    for (unsigned k = 0; k < 2; k++) {
      parts[k].shape = random_below(random, 4) == 0 ? 1 : 0;
      parts[k].own_pose = random_below(random, 2) == 0;
      parts[k].pose = pose;
      parts[k].pose.position = lattice_point(random, 1, STEP);
    }
    setup.pose = pose;
    setup.pose.position = lattice_point(random, SIDE, STEP);
    setup.parts = parts;
    setup.part_count = (uint16_t)(1 + random_below(random, 2));
    setup.category = setup.mask = 1;
    if (gjk_scene_add_at(&scene, slot[i], &setup, &ids[slot[i]]) != GJK_OK) {
      return false;
    }
  }
  for (uint32_t i = 0; i < BODIES / 2; i++) {
    pose.position = lattice_point(random, SIDE, STEP);
    if (gjk_scene_move(&scene, ids[random_below(random, BODIES)], &pose) != GJK_OK) {
      return false;
    }
  }
  return true;
}

// collider NULL: a ray.
static void check_first(const gjk_collider *collider, const gjk_vec3 *from, const gjk_vec3 *to) {
  gjk_scene_hit hit, best = {0};
  gjk_cast_result result, first, trial;
  unsigned equals = 0;
  bool found;
  gjk_collider part;
  memset(&first, 0, sizeof first);
  for (uint32_t slot = 0; slot < BODIES; slot++) {
    for (uint16_t k = 0; gjk_scene_collider(&scene, ids[slot], k, &part) == GJK_OK; k++) {
      const gjk_cast_path path = {NULL, to, 0};
      CHECK((collider == NULL ? gjk_cast_ray(&part, from, to, &trial) : gjk_cast(&part, collider, &path, &trial)) ==
            GJK_OK);
      if (trial.hit && (equals == 0 || trial.fraction < first.fraction)) {
        first = trial;
        best.body = ids[slot];
        best.part = k;
        equals = 0;
      }
      equals += trial.hit && trial.fraction == first.fraction ? 1 : 0;
    }
  }
  CHECK((collider == NULL ? gjk_scene_cast_ray(&scene, from, to, NULL, &hit, &result, &found)
                          : gjk_scene_cast(&scene, collider, to, 0, NULL, &hit, &result, &found)) == GJK_OK);
  CHECK(found == (equals > 0));
  if (found) {
    CHECK_MSG(hit.body.slot == best.body.slot && hit.part == best.part,
              "slot %u part %u, not slot %u part %u of %u equals", (unsigned)hit.body.slot, (unsigned)hit.part,
              (unsigned)best.body.slot, (unsigned)best.part, equals);
    CHECK(result.fraction == first.fraction && hit.fraction == (uint32_t)first.fraction);
    CHECK(result.inside == first.inside && memcmp(&result.rest_b, &first.rest_b, sizeof result.rest_b) == 0);
  }
  hits += found ? 1 : 0;
  misses += found ? 0 : 1;
  ties += equals > 1 ? 1 : 0;
}

// Along an axis, a diagonal, or anywhere on the half lattice.
static void check_way(random_state *random) {
  gjk_vec3 from = lattice_point(random, 4 * SIDE, HALF), to = lattice_point(random, 4 * SIDE, HALF);
  const uint32_t how = random_below(random, 4);
  gjk_collider c;
  gjk_pose pose = GJK_POSE_IDENTITY;
  const int32_t way = random_range(random, -6 * SIDE, 6 * SIDE) * HALF;
  if (how > 0) {
    to = from;
    to.x += how != 2 ? way : 0;
    to.y += how == 2 || how == 3 ? way : 0;
  }
  pose.position = from;
  CHECK(gjk_collider_init(&c, shapes[random_below(random, 2)], NULL, 0) == GJK_OK &&
        gjk_collider_pose(&c, &pose) == GJK_OK);
  check_first(random_below(random, 2) == 0 ? NULL : &c, &from, &to);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned long i = 0; i < WORLDS; i++) {
    gjk_scene_config config = {.bodies = BODIES, .parts = 2 * BODIES, .own_poses = 2 * BODIES, .pairs = 1};
    check_trial(i, NULL, NULL);
    config.box_margin = random_below(&random, 2) == 0 ? 0 : HALF;
    const size_t bytes = gjk_scene_bytes(&config);
    void *block = malloc(bytes);
    if (gjk_scene_init(&scene, &config, block, bytes, shapes, 2, NULL) == GJK_OK && fill_scene(&random)) {
      for (unsigned k = 0; k < QUERIES; k++) {
        check_way(&random);
      }
    } else {
      CHECK(false);
    }
    free(block);
  }
  printf("%lu hits, %lu with equals; %lu misses\n", hits, ties, misses);
  CHECK((ties > hits / 4 && misses > hits / 20) || !check_is_full());
  return check_done(TEST_NAME);
}
