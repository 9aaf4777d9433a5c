// Asks casts, rays and times of impact about random pairs and prints how many there were: tests/build/bounds.sh builds
// it with the assertions of the sources as checks. Pairs of every family of tests/support/generate/cast.h, and pairs of
// all kinds in space and in the plane, curved too, of all sizes, on any ways and turns.
#include <stdlib.h>

#include "case/case2.h"
#include "generate/cast.h"
#include "gjk/cast.h"
#include "gjk/impact.h"
#include "gjk2/cast.h"
#include "gjk2/gjk2.h"
#include "gjk2/impact.h"

#define VERTICES 12

// A third of pairs are asked for a time of impact, which takes long.
#define IMPACT_EVERY 3

static int32_t any_number(random_state *random) {
  return (int32_t)(random_u32(random) >> 1) >> random_below(random, 31);
}

static int32_t either_sign(random_state *random) {
  return random_below(random, 2) == 0 ? any_number(random) : -any_number(random);
}

static gjk_vec3 any_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  v.z = random_range(random, -size, size);
  return v;
}

// A claim that anyone may have written.
static void forge(random_state *random, gjk_cast_result *claim) {
  gjk_cast_certificate *c = &claim->certificate;
  c->direction = any_vector(random, 1 + any_number(random) / 2);
  for (int i = 0; i < 3; i++) {
    c->a[i] = (uint16_t)random_below(random, VERTICES + 1);
    c->b[i] = (uint16_t)random_below(random, VERTICES + 1);
  }
  c->count = (uint8_t)random_below(random, 6);
  c->proof = (uint8_t)random_below(random, 9);
  claim->hit = random_below(random, 2) == 0;
  claim->inside = random_below(random, 2) == 0;
  claim->fraction = random_below(random, 2) == 0 ? either_sign(random) : claim->fraction;
  claim->rest_b.x = random_below(random, 2) == 0 ? either_sign(random) : claim->rest_b.x;
  claim->point_a.y = random_below(random, 2) == 0 ? either_sign(random) : claim->point_a.y;
  claim->normal.z = random_below(random, 2) == 0 ? either_sign(random) : claim->normal.z;
}

static void ask_cast(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, random_state *random) {
  gjk_cast_result r = {0};
  if (gjk_cast(a, b, path, &r) == GJK_OK) {
    (void)gjk_check_cast(a, b, path, &r);
  }
  forge(random, &r);
  (void)gjk_check_cast(a, b, path, &r);
  if (path->to_b != NULL) {
    (void)gjk_cast_ray(a, &b->position, path->to_b, &r);
  }
}

static void ask_impact(const gjk_collider *a, const gjk_motion *motion_a, const gjk_collider *b,
                       const gjk_motion *motion_b, gjk_q16 margin, random_state *random) {
  const gjk_impact_setup setup = {.margin = margin,
                                  .tolerance = GJK_IMPACT_TOLERANCE_MIN + (any_number(random) >> 8),
                                  .iterations = (uint8_t)random_below(random, 40)};
  gjk_impact_result r;
  gjk_pose pose;
  (void)gjk_time_of_impact(a, motion_a, b, motion_b, &setup, &r);
  (void)gjk_motion_pose(motion_b, random_range(random, 0, GJK_Q30_ONE), &pose);
}

static void ask_family(const generate_cast_family *family, uint64_t seed, case_pair *pair, case_collider made[2]) {
  random_state random = random_seed(seed);
  generate_cast(family, seed, pair);
  const bool lazy = random_below(&random, 2) == 0;
  const gjk_q16 margin = random_below(&random, 2) == 0 ? 0 : any_number(&random) >> 4;
  if (case_collider_build(&made[0], &pair->a, lazy) != GJK_OK ||
      case_collider_build(&made[1], &pair->b, lazy) != GJK_OK) {
    return;
  }
  const gjk_cast_path path = case_path(pair, margin);
  ask_cast(&made[0].collider, &made[1].collider, &path, &random);
  if (seed % IMPACT_EVERY == 0) {
    gjk_motion of_a = case_motion(&pair->a), of_b = case_motion(&pair->b);
    of_b.spin = any_vector(&random, any_number(&random) >> 8);
    ask_impact(&made[0].collider, &of_a, &made[1].collider, &of_b, margin, &random);
  }
}

static void make_any(random_state *random, int32_t size, case_shape *shape) {
  case_shape_reset(shape);
  shape->kind = (case_kind)random_below(random, CASE_ELLIPSOID + 1);
  shape->size.x = random_range(random, 1, size);
  shape->size.y =
      shape->kind == CASE_CYLINDER || shape->kind == CASE_CONE ? shape->size.x : random_range(random, 1, size);
  shape->size.z = random_range(random, 1, size);
  case_shape_set_count(shape, shape->kind == CASE_TRIANGLE ? 3 : shape->kind == CASE_HULL ? VERTICES : 0);
  for (size_t i = 0; i < shape->count; i++) {
    shape->vertices[i] = any_vector(random, size);
  }
  shape->convex_radius = random_below(random, 2) == 0 ? 0 : random_range(random, 0, size);
}

static void any_turn(random_state *random, gjk_quat *out) {
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  (void)gjk_quat_normalize(&q, out);
}

// Of any kinds and of one scale, on ways of that scale or across the world.
static void ask_any(uint64_t seed, case_pair *pair, case_collider made[2]) {
  random_state random = random_seed(seed);
  const int32_t size = INT32_C(1) << (1 + random_below(&random, 27));
  const int32_t world = random_below(&random, 4) == 0 ? INT32_MAX : size < INT32_C(1) << 28 ? 4 * size : size;
  case_shape *const shape[2] = {&pair->a, &pair->b};
  gjk_motion motion[2];
  for (int i = 0; i < 2; i++) {
    make_any(&random, size, shape[i]);
    any_turn(&random, &shape[i]->pose.rotation);
    shape[i]->pose.position = any_vector(&random, world);
    const gjk_vec3 to = any_vector(&random, random_below(&random, 2) == 0 ? world : size);
    case_shape_move_to(shape[i], &to);
    any_turn(&random, &shape[i]->end.rotation);
    shape[i]->spin = any_vector(&random, random_below(&random, 2) == 0 ? 0 : any_number(&random));
    motion[i] = case_motion(shape[i]);
    shape[i]->moves = random_below(&random, 4) != 0;
  }
  const bool lazy = random_below(&random, 2) == 0;
  if (case_collider_build(&made[0], &pair->a, lazy) == GJK_OK &&
      case_collider_build(&made[1], &pair->b, lazy) == GJK_OK) {
    const gjk_cast_path path = case_path(pair, random_below(&random, 2) == 0 ? 0 : any_number(&random));
    ask_cast(&made[0].collider, &made[1].collider, &path, &random);
    ask_impact(&made[0].collider, &motion[0], &made[1].collider, &motion[1], path.margin >> 2, &random);
  }
}

static gjk2_vec any_vector2(random_state *random, int32_t size) {
  const gjk2_vec v = {random_range(random, -size, size), random_range(random, -size, size)};
  return v;
}

static void make_any2(random_state *random, int32_t size, case2_shape *shape) {
  case2_shape_reset(shape);
  shape->kind = (case2_kind)random_below(random, CASE2_ELLIPSE + 1);
  shape->size.x = shape->kind == CASE2_POINT ? 0 : random_range(random, 1, size);
  shape->size.y = shape->kind == CASE2_BOX || shape->kind == CASE2_ELLIPSE ? random_range(random, 1, size) : 0;
  case2_shape_set_count(shape, shape->kind == CASE2_TRIANGLE ? 3 : shape->kind == CASE2_POLYGON ? VERTICES : 0);
  for (size_t i = 0; i < shape->count; i++) {
    shape->vertices[i] = any_vector2(random, size);
  }
  shape->convex_radius = random_below(random, 2) == 0 ? 0 : random_range(random, 0, size);
}

static void any_turn2(random_state *random, gjk2_rotation *out) {
  const gjk2_rotation r = {random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  (void)gjk2_rotation_normalize(&r, out);
}

static void forge2(random_state *random, gjk2_cast_result *claim) {
  gjk2_cast_certificate *c = &claim->certificate;
  c->direction = any_vector2(random, 1 + any_number(random) / 2);
  for (int i = 0; i < 3; i++) {
    c->a[i] = (uint16_t)random_below(random, VERTICES + 1);
    c->b[i] = (uint16_t)random_below(random, VERTICES + 1);
  }
  c->count = (uint8_t)random_below(random, 6);
  c->proof = (uint8_t)random_below(random, 9);
  claim->hit = random_below(random, 2) == 0;
  claim->inside = random_below(random, 2) == 0;
  claim->fraction = random_below(random, 2) == 0 ? either_sign(random) : claim->fraction;
  claim->rest_b.x = random_below(random, 2) == 0 ? either_sign(random) : claim->rest_b.x;
  claim->normal.y = random_below(random, 2) == 0 ? either_sign(random) : claim->normal.y;
}

static void ask_plane(uint64_t seed, case2_pair *pair, case2_collider made[2]) {
  random_state random = random_seed(seed);
  const int32_t size = INT32_C(1) << (1 + random_below(&random, 27));
  const int32_t world = random_below(&random, 4) == 0 ? INT32_MAX : size < INT32_C(1) << 28 ? 4 * size : size;
  case2_shape *const shape[2] = {&pair->a, &pair->b};
  gjk2_motion motion[2];
  for (int i = 0; i < 2; i++) {
    make_any2(&random, size, shape[i]);
    any_turn2(&random, &shape[i]->pose.rotation);
    shape[i]->pose.position = any_vector2(&random, world);
    const gjk2_vec to = any_vector2(&random, random_below(&random, 2) == 0 ? world : size);
    case2_shape_move_to(shape[i], &to);
    any_turn2(&random, &shape[i]->end.rotation);
    shape[i]->spin = random_below(&random, 2) == 0 ? 0 : either_sign(&random);
    motion[i] = case2_motion(shape[i]);
    shape[i]->moves = random_below(&random, 4) != 0;
  }
  const bool lazy = random_below(&random, 2) == 0;
  if (case2_collider_build(&made[0], &pair->a, lazy) != GJK_OK ||
      case2_collider_build(&made[1], &pair->b, lazy) != GJK_OK) {
    return;
  }
  const gjk2_collider *a = &made[0].collider, *b = &made[1].collider;
  const gjk2_cast_path path = case2_path(pair, random_below(&random, 2) == 0 ? 0 : any_number(&random));
  const gjk2_impact_setup setup = {.margin = path.margin >> 2,
                                   .tolerance = GJK2_IMPACT_TOLERANCE_MIN + (any_number(&random) >> 8),
                                   .iterations = (uint8_t)random_below(&random, 40)};
  gjk2_cast_result r = {0};
  gjk2_impact_result impact;
  gjk2_pose pose;
  if (gjk2_cast(a, b, &path, &r) == GJK_OK) {
    (void)gjk2_check_cast(a, b, &path, &r);
  }
  forge2(&random, &r);
  (void)gjk2_check_cast(a, b, &path, &r);
  (void)gjk2_cast_ray(a, &b->position, &pair->b.end.position, &r);
  (void)gjk2_time_of_impact(a, &motion[0], b, &motion[1], &setup, &impact);
  (void)gjk2_motion_pose(&motion[1], random_range(&random, 0, GJK_Q30_ONE), &pose);
}

int main(int count, char **arguments) {
  const uint64_t pairs = count > 1 ? strtoull(arguments[1], NULL, 10) : 1000;
  static case_pair pair;
  static case2_pair pair2;
  static case_collider made[2];
  static case2_collider made2[2];
  for (uint64_t i = 0; i < pairs; i++) {
    const uint64_t family = i % (generate_cast_family_count + 16u);
    if (family < generate_cast_family_count) {
      ask_family(&generate_cast_families[family], i, &pair, made);
    } else if (i % 2 == 0) {
      ask_any(i, &pair, made);
    } else {
      ask_plane(i, &pair2, made2);
    }
  }
  case_pair_free(&pair);
  case2_pair_free(&pair2);
  for (int i = 0; i < 2; i++) {
    case_collider_free(&made[i]);
    case2_collider_free(&made2[i]);
  }
  printf("%llu\n", (unsigned long long)pairs);
  return 0;
}
