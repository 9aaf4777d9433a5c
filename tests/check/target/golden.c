// The fixed set of queries and its hash, without libc and with little RAM, so that it also runs on an 8-bit core.
// Iterations and certificates tell of the way to an answer, so they are not in it.
#include "golden.h"

#include "gjk/gjk.h"
#include "golden_mix.h"

#define VERTICES 16

typedef struct body {
  gjk_vec3 vertices[VERTICES], buffer[VERTICES];
  gjk_shape shape;
  gjk_collider collider;
  gjk_pose pose;
} body;

static body bodies[2];
static gjk_epa_cell cells[GJK_EPA_CELLS(20)];
static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(20)};

static void mix_distance(gjk_cache *cache, gjk_distance_result *out) {
  mix((uint32_t)gjk_distance(&bodies[0].collider, &bodies[1].collider, cache, out));
  mix((uint32_t)out->intersecting);
  mix((uint32_t)out->saturated);
  mix((uint32_t)out->distance);
  if (!out->intersecting) {
    mix_vector(&out->point_a);
    mix_vector(&out->point_b);
    mix_unit(&out->normal);
  }
}

static void mix_decision(gjk_q16 distance, gjk_cache *cache) {
  gjk_decision decision;
  mix((uint32_t)(distance < 0 ? gjk_intersect(&bodies[0].collider, &bodies[1].collider, cache, &decision)
                              : gjk_within(&bodies[0].collider, &bodies[1].collider, distance, cache, &decision)));
  mix((uint32_t)decision.yes);
}

static void mix_within_until(gjk_q16 distance, uint8_t iterations) {
  gjk_within_result out;
  mix((uint32_t)gjk_within_until(&bodies[0].collider, &bodies[1].collider, distance, iterations, NULL, &out));
  mix((uint32_t)out.answer);
}

static void mix_until(uint8_t iterations, gjk_q16 error) {
  const gjk_effort effort = {iterations, error};
  gjk_distance_result out;
  mix((uint32_t)gjk_distance_until(&bodies[0].collider, &bodies[1].collider, &effort, NULL, &out));
  mix((uint32_t)out.intersecting);
  mix_three(out.distance, out.lower, out.upper);
  if (!out.intersecting) {
    mix_vector(&out.point_a);
  }
}

static void mix_penetration(gjk_cache *cache) {
  gjk_penetration_result out;
  mix((uint32_t)gjk_penetration(&bodies[0].collider, &bodies[1].collider, cache, &workspace, &out));
  mix((uint32_t)out.intersecting);
  if (out.intersecting) {
    mix_three(out.depth, out.lower, out.upper);
    mix_vector(&out.point_a);
    mix_vector(&out.point_b);
    mix_unit(&out.normal);
  }
}

static void mix_contacts(gjk_q16 margin) {
  static gjk_manifold out;
  mix((uint32_t)gjk_contacts(&bodies[0].collider, &bodies[1].collider, margin, 4, NULL, &workspace, &out));
  mix(out.count);
  mix_contacts_of(&out);
}

// A shape of one of ten kinds, of about that size; every fourth has a convex radius.
static void make_shape(random_state *random, body *b, int32_t size) {
  static const gjk_shape kinds[] = {
      GJK_POINT,      GJK_SEGMENT(0),     GJK_TRIANGLE(0), GJK_BOX(0, 0, 0),
      GJK_HULL(0, 0), GJK_CYLINDER(0, 0), GJK_CONE(0, 0),  GJK_ELLIPSOID(0, 0, 0),
  };
  // Boxes and hulls are chosen twice as often.
  static const uint8_t choices[] = {0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7};
  b->shape = kinds[choices[random_below(random, sizeof choices)]];
  b->shape.size.x = random_range(random, 1, size);
  b->shape.size.y = random_range(random, 1, size);
  b->shape.size.z = random_range(random, 1, size);
  b->shape.vertices = b->vertices;
  b->shape.count = (uint16_t)(b->shape.type == &gjk_class_triangle ? 3 : 4 + random_below(random, VERTICES - 3));
  const int32_t grid = random_below(random, 4) == 0 ? size / 2 + 1 : 1;  // coarse: ties, and parallel faces
  for (unsigned i = 0; i < b->shape.count; i++) {
    const gjk_vec3 v = random_in_cube(random, size);
    b->vertices[i].x = v.x / grid * grid;
    b->vertices[i].y = v.y / grid * grid;
    b->vertices[i].z = v.z / grid * grid;
  }
  b->shape.convex_radius = random_below(random, 4) == 0 ? random_range(random, 0, size / 2) : 0;
}

static void make_pose(random_state *random, body *b, int32_t reach) {
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  b->pose = identity;
  if (random_below(random, 4) != 0) {
    const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                        random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
    mix((uint32_t)gjk_quat_normalize(&q, &b->pose.rotation));
  }
  b->pose.position = random_in_cube(random, reach);
}

static void place(random_state *random, body *b) {
  const bool baked = random_below(random, 2) == 0;
  b->collider.state = 0;
  mix((uint32_t)gjk_collider_init(&b->collider, &b->shape, baked ? b->buffer : NULL, VERTICES));
  mix((uint32_t)gjk_collider_pose(&b->collider, &b->pose));
}

// Moves B along the normal until the gap is near 0.
static void approach(random_state *random, const gjk_distance_result *result) {
  body *b = &bodies[1];
  const int32_t by = result->distance + random_range(random, -2, 2);
  gjk_vec3 position = b->pose.position;
  position.x -= (int32_t)((int64_t)result->normal.x * by / GJK_Q30_ONE);
  position.y -= (int32_t)((int64_t)result->normal.y * by / GJK_Q30_ONE);
  position.z -= (int32_t)((int64_t)result->normal.z * by / GJK_Q30_ONE);
  mix((uint32_t)gjk_collider_move(&b->collider, &position));
}

static void query_pair(random_state *random) {
  static const gjk_cache cold = {{0, 0, 0}, 0, {0, 0, 0, 0}, {0, 0, 0, 0}};
  const int32_t size = INT32_C(1) << (3 + random_below(random, 23));
  const bool far = random_below(random, 8) == 0;
  for (int i = 0; i < 2; i++) {
    make_shape(random, &bodies[i], size);
    make_pose(random, &bodies[i], far ? INT32_MAX : 2 * size);
    place(random, &bodies[i]);
  }
  gjk_cache cache = cold;
  gjk_distance_result result;
  mix_distance(NULL, &result);
  mix_decision(-1, NULL);
  mix_decision(result.distance, NULL);
  mix_distance(&cache, &result);
  mix_penetration(&cache);
  mix_contacts(0);
  if (!result.intersecting && !far) {
    approach(random, &result);
    mix_distance(&cache, &result);
    mix_decision(-1, &cache);
    mix_decision(1, NULL);
    mix_within_until(1 + size / 32, 1);
    mix_within_until(result.distance, 2);
    mix_until(2, 0);
    mix_until(0, 1 + size / 16);
    mix_penetration(NULL);
    mix_contacts(size / 8);
  }
}

uint64_t golden_hash(uint32_t pairs) {
  random_state random = random_seed(2026);
  hash = FNV_START;
  for (uint32_t i = 0; i < pairs; i++) {
    query_pair(&random);
  }
  return hash;
}
