// Asks every query about random pairs and prints how many there were: tests/build/bounds.sh builds it with the
// assertions of the sources as checks. Pairs of every family of tests/support/generate, and pairs of all kinds, curved
// too, from a few LSB to the largest there are, some of them at the ends of the world.
#include <stdlib.h>

#include "generate/generate.h"
#include "gjk/gjk.h"

#define CELLS_MAX 400

static gjk_epa_cell *cells;

// A collider and where it may be asked again from.
typedef struct question {
  gjk_collider *a, *b;
  gjk_cache *cache;
  gjk_workspace workspace;  // allocated to its size, so that a read beyond it shows
} question;

static void check(const question *q, random_state *random) {
  gjk_decision decision = {0};
  gjk_distance_result distance = {0};
  gjk_penetration_result penetration = {0};
  gjk_manifold manifold;
  const gjk_q16 reach = random_range(random, 0, 1000000);
  const gjk_effort effort = {(uint8_t)random_below(random, 6), random_range(random, 0, 9)};
  if (gjk_within(q->a, q->b, reach, q->cache, &decision) == GJK_OK) {
    (void)gjk_check_decision(q->a, q->b, reach, &decision);
  }
  if (gjk_intersect(q->a, q->b, q->cache, &decision) == GJK_OK) {
    (void)gjk_check_decision(q->a, q->b, 0, &decision);
  }
  gjk_within_result within;
  if (gjk_within_until(q->a, q->b, reach, effort.iterations, q->cache, &within) == GJK_OK &&
      within.answer != GJK_ANSWER_OPEN) {
    (void)gjk_check_decision(q->a, q->b, reach, &within.decision);
  }
  (void)gjk_distance_until(q->a, q->b, &effort, q->cache, &distance);
  if (gjk_distance(q->a, q->b, q->cache, &distance) == GJK_OK) {
    (void)gjk_check_distance(q->a, q->b, &distance);
  }
  if (gjk_penetration(q->a, q->b, q->cache, &q->workspace, &penetration) == GJK_OK) {
    (void)gjk_check_penetration(q->a, q->b, &penetration);
  }
  (void)gjk_signed_distance(q->a, q->b, q->cache, &q->workspace, &distance);
  (void)gjk_contacts(q->a, q->b, reach, 1 + random_below(random, 8), q->cache, &q->workspace, &manifold);
}

// A certificate that anyone may have written.
static void check_any_certificate(const question *q, random_state *random) {
  gjk_decision decision = {0};
  gjk_distance_result distance = {0};
  gjk_penetration_result penetration = {0};
  gjk_certificate *c = &decision.certificate;
  const unsigned zeros = random_below(random, 32);
  c->direction.x = (int32_t)random_range(random, INT32_MIN, INT32_MAX) / (1 << zeros % 31);
  c->direction.y = (int32_t)random_range(random, INT32_MIN, INT32_MAX) / (1 << zeros % 31);
  c->direction.z = (int32_t)random_range(random, INT32_MIN, INT32_MAX) / (1 << zeros % 31);
  for (int i = 0; i < 4; i++) {
    c->a[i] = (uint16_t)random_below(random, 9);
    c->b[i] = (uint16_t)random_below(random, 9);
  }
  c->count = (uint8_t)random_below(random, 6);
  c->proof = (uint8_t)random_below(random, 9);
  decision.yes = random_below(random, 2) == 0;
  (void)gjk_check_decision(q->a, q->b, 0, &decision);
  distance.certificate = penetration.certificate = *c;
  distance.intersecting = penetration.intersecting = decision.yes;
  distance.distance = penetration.depth = random_range(random, INT32_MIN, INT32_MAX) >> zeros;
  distance.lower = distance.upper = distance.distance;
  penetration.lower = penetration.upper = penetration.depth;
  (void)gjk_check_distance(q->a, q->b, &distance);
  (void)gjk_check_penetration(q->a, q->b, &penetration);
}

static void ask(gjk_collider *a, gjk_collider *b, random_state *random) {
  gjk_cache cache = generate_cache(random);
  const uint32_t count = random_below(random, 3) == 0 ? random_below(random, 60) : CELLS_MAX;
  cells = malloc((count + 1) * sizeof *cells);
  const question q = {a, b, random_below(random, 2) == 0 ? NULL : &cache, {cells, count}};
  check(&q, random);
  check(&q, random);  // from the cache that the first has left
  check_any_certificate(&q, random);
  free(cells);
}

static void ask_family(const generate_family *family, uint64_t seed, case_pair *pair, case_collider made[2]) {
  random_state random = random_seed(seed);
  generate_pair(family, seed, pair);
  const bool lazy = random_below(&random, 2) == 0;
  if (case_collider_build(&made[0], &pair->a, lazy) == GJK_OK &&
      case_collider_build(&made[1], &pair->b, lazy) == GJK_OK) {
    ask(&made[0].collider, &made[1].collider, &random);
  }
}

static gjk_q16 some_size(random_state *random, int32_t size) {
  return random_below(random, 4) == 0 ? random_range(random, 0, 3) : random_range(random, 0, size);
}

static void make_any(random_state *random, int32_t size, case_shape *shape) {
  case_shape_reset(shape);
  shape->kind = (case_kind)random_below(random, CASE_ELLIPSOID + 1);
  shape->size.x = some_size(random, size);
  shape->size.y = shape->kind == CASE_CYLINDER || shape->kind == CASE_CONE ? shape->size.x : some_size(random, size);
  shape->size.z = some_size(random, size);
  case_shape_set_count(shape, shape->kind == CASE_TRIANGLE ? 3 : shape->kind == CASE_HULL ? 24 : 0);
  for (size_t i = 0; i < shape->count; i++) {
    shape->vertices[i].x = random_range(random, -size, size);
    shape->vertices[i].y = random_range(random, -size, size);
    shape->vertices[i].z = random_range(random, -size, size);
  }
  shape->convex_radius = random_below(random, 2) == 0 ? 0 : some_size(random, size);
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  (void)gjk_quat_normalize(&q, &shape->pose.rotation);
}

// Of any kinds and of one scale; near each other, at random or at an end of the world.
static void ask_any(uint64_t seed, case_pair *pair, case_collider made[2]) {
  random_state random = random_seed(seed);
  const int32_t size = INT32_C(1) << (1 + random_below(&random, 27));
  const int32_t world = random_below(&random, 4) == 0 ? INT32_MAX / 2 : INT32_C(1) << random_below(&random, 30);
  gjk_vec3 *p = &pair->a.pose.position, *q = &pair->b.pose.position;
  make_any(&random, size, &pair->a);
  make_any(&random, size, &pair->b);
  const int32_t apart = random_below(&random, 8) == 0 ? INT32_C(1) << 29 : size < INT32_C(1) << 28 ? 2 * size : size;
  p->x = random_range(&random, -world, world);
  p->y = random_range(&random, -world, world);
  p->z = random_range(&random, -world, world);
  q->x = p->x + random_range(&random, -apart, apart);
  q->y = p->y + random_range(&random, -apart, apart);
  q->z = p->z + random_range(&random, -apart, apart);
  const bool lazy = random_below(&random, 2) == 0;
  if (case_collider_build(&made[0], &pair->a, lazy) == GJK_OK &&
      case_collider_build(&made[1], &pair->b, lazy) == GJK_OK) {
    ask(&made[0].collider, &made[1].collider, &random);
  }
}

int main(int count, char **arguments) {
  const uint64_t pairs = count > 1 ? strtoull(arguments[1], NULL, 10) : 1000;
  static case_pair pair;
  static case_collider made[2];
  for (uint64_t i = 0; i < pairs; i++) {
    const uint64_t family = i % (generate_family_count + 4u);
    if (family < generate_family_count) {
      ask_family(&generate_families[family], i, &pair, made);
    } else {
      ask_any(i, &pair, made);
    }
  }
  case_pair_free(&pair);
  case_collider_free(&made[0]);
  case_collider_free(&made[1]);
  printf("%llu\n", (unsigned long long)pairs);
  return 0;
}
