// A lazy hull answers with the same bits as the baked one.
#include <math.h>
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"

#define SEED 977
#define PAIRS 20000

typedef struct pair_of_colliders {
  case_collider a, b;
} pair_of_colliders;

static bool build(const case_pair *pair, bool lazy, pair_of_colliders *out) {
  return case_collider_build(&out->a, &pair->a, lazy) == GJK_OK &&
         case_collider_build(&out->b, &pair->b, lazy) == GJK_OK;
}

static bool same_vec3(gjk_vec3 a, gjk_vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_certificate(const gjk_certificate *a, const gjk_certificate *b) {
  return a->proof == b->proof && a->count == b->count && same_vec3(a->direction, b->direction) &&
         memcmp(a->a, b->a, a->count * sizeof a->a[0]) == 0 && memcmp(a->b, b->b, a->count * sizeof a->b[0]) == 0;
}

static bool same_distance(const gjk_distance_result *a, const gjk_distance_result *b) {
  bool same = a->intersecting == b->intersecting && a->distance == b->distance && a->saturated == b->saturated &&
              a->lower == b->lower && a->upper == b->upper && a->iterations == b->iterations &&
              same_certificate(&a->certificate, &b->certificate);
  return same &&
         (a->intersecting || (same_vec3(a->point_a, b->point_a) && same_vec3(a->point_b, b->point_b) &&
                              a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z));
}

static bool same_decision(const gjk_decision *a, const gjk_decision *b) {
  return a->yes == b->yes && a->iterations == b->iterations && same_certificate(&a->certificate, &b->certificate);
}

static bool same_box(const gjk_collider *a, const gjk_collider *b) {
  gjk_aabb box_a, box_b;
  return gjk_collider_aabb(a, &box_a) == GJK_OK && gjk_collider_aabb(b, &box_b) == GJK_OK &&
         same_vec3(box_a.lower, box_b.lower) && same_vec3(box_a.upper, box_b.upper);
}

// A hull near the surface of another shape: half of the pairs touch or nearly do.
static bool make_pair(random_state *random, case_pair *pair, pair_of_colliders *baked) {
  const gjk_q16 reach = random_reach(random);
  gjk_distance_result gap;
  random_shape(random, CASE_HULL, reach, &pair->a);
  random_shape(random, (case_kind)random_below(random, CASE_ELLIPSOID + 1), reach, &pair->b);
  if (!build(pair, false, baked)) {
    return false;
  }
  const gjk_vec3 a = baked->a.collider.centre, b = baked->b.collider.centre;
  const double radii = (double)baked->a.collider.radius + baked->b.collider.radius;
  const gjk_vec3 apart = random_vector(random, radii * 1.2 * sqrt(random_unit(random)));
  gjk_vec3 *position = &pair->b.pose.position;
  position->x += a.x - b.x + apart.x;
  position->y += a.y - b.y + apart.y;
  position->z += a.z - b.z + apart.z;
  if (!build(pair, false, baked) || gjk_distance(&baked->a.collider, &baked->b.collider, NULL, &gap) != GJK_OK) {
    return false;
  }
  if (!gap.intersecting && random_below(random, 2) == 0) {
    position->x += gap.point_a.x - gap.point_b.x;
    position->y += gap.point_a.y - gap.point_b.y;
    position->z += gap.point_a.z - gap.point_b.z + random_range(random, -2, 2);
  }
  return build(pair, false, baked);
}

static bool same_answers(const pair_of_colliders *baked, const pair_of_colliders *lazy, bool *together) {
  const gjk_collider *a = &baked->a.collider, *b = &baked->b.collider;
  const gjk_collider *lazy_a = &lazy->a.collider, *lazy_b = &lazy->b.collider;
  gjk_distance_result distance[2];
  gjk_decision touch[2], within[2];
  gjk_cache cache[2];
  memset(cache, 0, sizeof cache);
  bool fine =
      gjk_distance(a, b, NULL, &distance[0]) == GJK_OK && gjk_distance(lazy_a, lazy_b, NULL, &distance[1]) == GJK_OK;
  CHECK(fine);
  if (!fine) {
    return false;
  }
  *together = distance[0].intersecting;
  const gjk_q16 near = distance[0].distance;
  fine = gjk_intersect(a, b, &cache[0], &touch[0]) == GJK_OK &&
         gjk_intersect(lazy_a, lazy_b, &cache[1], &touch[1]) == GJK_OK &&
         gjk_within(a, b, near, &cache[0], &within[0]) == GJK_OK &&
         gjk_within(lazy_a, lazy_b, near, &cache[1], &within[1]) == GJK_OK;
  return fine && same_distance(&distance[0], &distance[1]) && same_decision(&touch[0], &touch[1]) &&
         same_decision(&within[0], &within[1]) && same_box(a, lazy_a);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  case_pair pair = {0};
  pair_of_colliders baked, lazy;
  memset(&baked, 0, sizeof baked);
  memset(&lazy, 0, sizeof lazy);
  unsigned made = 0, together = 0;
  for (unsigned i = 0; i < PAIRS; i++) {
    check_trial(i, NULL, NULL);
    bool hit = false;
    if (!make_pair(&random, &pair, &baked) || !build(&pair, true, &lazy)) {
      continue;
    }
    made++;
    bool same = same_answers(&baked, &lazy, &hit);
    CHECK(same);
    if (!same) {
      case_print(stdout, &pair);
    }
    together += hit;
  }
  printf("lazy: %u pairs, %u together\n", made, together);
  CHECK(made > PAIRS * 8 / 10);
  CHECK(together > made / 5);
  CHECK(together < made * 4 / 5);
  case_collider_free(&baked.a);
  case_collider_free(&baked.b);
  case_collider_free(&lazy.a);
  case_collider_free(&lazy.b);
  case_pair_free(&pair);
  return check_done("lazy");
}
