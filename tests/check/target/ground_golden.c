// The hash of ground in the plane: the platform game, then queries of a chain, a profile and a grid at random poses.
#define PLATFORM_IS_MEASURED
#include "ground_golden.h"

#include "gjk2/pose.h"
#include "random.h"
#include "tests/programs/examples/platform.c"

#define TICKS 240
#define QUERIES 200
#define VERTICES 40
#define FOUND 8

static uint64_t hash;

static void mix(int64_t x) {
  hash = (hash ^ (uint64_t)x) * UINT64_C(0x100000001B3);
}

static void mix_vec(const gjk2_vec *v) {
  mix(v->x);
  mix(v->y);
}

static void play(void) {
  uint64_t of_scene = 0;
  bool fine = start();
  for (int i = 0; i < TICKS && fine; i++) {
    fine = tick(i);
  }
  mix(fine && gjk2_scene_hash(&scene, &of_scene) == GJK_OK);
  mix((int64_t)(of_scene >> 1));
  mix_vec(&runner.position);
}

static void mix_contacts(const gjk2_ground *of, const gjk2_pose *at, const gjk2_collider *c) {
  static gjk2_chain_contact found[FOUND];
  uint16_t count = 0;
  mix(gjk2_ground_contacts(of, at, c, 3000, found, FOUND, &count));
  for (unsigned i = 0; i < count; i++) {
    const gjk2_manifold *m = &found[i].manifold;
    mix(found[i].segment);
    mix(m->normal.x);
    mix(m->normal.y);
    for (unsigned k = 0; k < m->count; k++) {
      mix_vec(&m->contact[k].point_a);
      mix_vec(&m->contact[k].point_b);
      mix(m->contact[k].distance);
      mix(m->contact[k].id);
    }
  }
}

static void mix_distance(const gjk2_ground *of, const gjk2_pose *at, const gjk2_collider *c) {
  gjk2_distance_result result;
  uint32_t segment = 0;
  bool found = false;
  mix(gjk2_ground_distance(of, at, c, &result, &segment, &found));
  if (found) {
    mix(segment);
    mix(result.distance);
    mix(result.intersecting ? 0 : result.point_b.x);
  }
}

static void mix_cast(const gjk2_ground *of, const gjk2_pose *at, const gjk2_collider *c, const gjk2_vec *to) {
  const gjk2_cast_path path = {0, to, 0};
  gjk2_cast_result result;
  uint32_t segment = 0;
  mix(gjk2_ground_cast(of, at, c, &path, &result, &segment));
  mix(result.hit ? result.fraction : -1);
  mix(segment);
  mix(gjk2_ground_cast_ray(of, at, &c->position, to, &result, &segment));
  mix(result.hit ? result.fraction : -1);
  mix(segment);
}

static void ask_all(random_state *random, const gjk2_ground *grounds, unsigned count) {
  static const gjk2_shape bodies[] = {GJK2_CIRCLE(20000), GJK2_BOX(30000, 12000), GJK2_CAPSULE(9000, 25000)};
  for (unsigned i = 0; i < QUERIES; i++) {
    gjk2_pose at = GJK2_POSE_IDENTITY, place = GJK2_POSE_IDENTITY;
    gjk2_collider c;
    (void)gjk2_rotation_from_angle(random_range(random, -200000, 200000), &at.rotation);
    (void)gjk2_rotation_from_angle(random_range(random, -200000, 200000), &place.rotation);
    place.position.x = random_range(random, -400000, 400000);
    place.position.y = random_range(random, -400000, 400000);
    gjk2_vec to;
    to.x = random_range(random, -400000, 400000);
    to.y = random_range(random, -400000, 400000);
    mix(gjk2_collider_init(&c, &bodies[i % 3], 0, 0));
    mix(gjk2_collider_pose(&c, &place));
    mix_contacts(&grounds[i % count], &at, &c);
    mix_distance(&grounds[i % count], &at, &c);
    mix_cast(&grounds[i % count], &at, &c, &to);
  }
}

uint64_t ground_golden_hash(void) {
  static gjk2_vec vertices[VERTICES];
  static int16_t heights[VERTICES];
  static gjk2_index_box boxes[GJK2_INDEX_BOXES(VERTICES)];
  static gjk2_index index;
  gjk2_polyline chain = {vertices, VERTICES, 0};
  const gjk2_heights profile = {heights, VERTICES, 15000, 4};
  gjk2_ground grounds[3];
  gjk2_shape shape;
  random_state random = random_seed(20);
  for (int i = 0; i < VERTICES; i++) {
    vertices[i].x = (VERTICES / 2 - i) * 14000 + random_range(&random, -4000, 4000);
    vertices[i].y = random_range(&random, -12000, 12000);
    heights[i] = (int16_t)random_range(&random, -900, 900);
  }
  hash = 1;
  mix(gjk2_index_build(&chain, boxes, sizeof boxes / sizeof boxes[0], &index));
  chain.index = &index;
  mix(gjk2_ground_of_chain(&chain, &grounds[0], &shape));
  mix(gjk2_ground_of_heights(&profile, &grounds[1], &shape));
  mix(gjk2_ground_of_tiles(&tiles, &grounds[2], &shape));
  ask_all(&random, grounds, 3);
  play();
  return hash;
}
