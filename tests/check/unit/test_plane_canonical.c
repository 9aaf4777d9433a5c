// In the plane, too, a cache changes speed and nothing else: every field of every answer but iterations and certificate is the
// same from a cold start, with its own cache, with that from before a small move, with that of another pair, and with random
// bytes. Half of the pairs are aligned on a lattice, where features tie: parallel edges, repeated and collinear vertices,
// shapes in the same place. Each answer also has its proof.
#include <string.h>

#include "check.h"
#include "generate/generate.h"
#include "gjk2/gjk2.h"
#include "plane_same.h"

#define PAIRS check_trials(20000)
#define SEED 9400
#define CORNERS 7
#define KINDS 10
#define QUERIES 7

static gjk2_vec corners[2][CORNERS], posed[2][CORNERS];

// A box's corners in order, the middle of its upper side, a point inside and a corner again.
static void make_corners(random_state *random, gjk2_vec *v, gjk_q16 x, gjk_q16 y, bool aligned) {
  const int8_t sign[CORNERS][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 1}, {0, 0}, {1, 1}};
  for (int k = 0; k < CORNERS; k++) {
    v[k].x = aligned ? x * sign[k][0] : random_range(random, -x, x);
    v[k].y = aligned ? y * sign[k][1] : random_range(random, -y, y);
  }
}

static gjk2_shape make_shape(random_state *random, int i, gjk_q16 size, bool aligned) {
  const gjk_q16 x = size * random_range(random, 1, 3), y = size * random_range(random, 1, 3);
  gjk2_vec *v = corners[i];
  make_corners(random, v, x, y, aligned);
  const gjk2_shape kinds[KINDS] = {GJK2_BOX(x, y),
                                   GJK2_BOX(x, y),
                                   GJK2_CAPSULE(size / 2, x),
                                   GJK2_ROUNDED_BOX(x, y, size / 8),
                                   GJK2_BOX(x, 0),
                                   GJK2_CIRCLE(size),
                                   GJK2_SEGMENT(x),
                                   GJK2_TRIANGLE(v),
                                   GJK2_POLYGON(v, 4),
                                   GJK2_ROUNDED_POLYGON(v, CORNERS, size / 4)};
  return kinds[random_below(random, KINDS)];
}

static gjk2_pose make_pose(random_state *random, bool aligned, gjk_q16 size, int32_t reach) {
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  if (aligned) {
    const gjk2_rotation turns[4] = {{GJK_Q30_ONE, 0}, {GJK_Q30_ONE, 0}, {0, GJK_Q30_ONE}, {-GJK_Q30_ONE, 0}};
    pose.rotation = turns[random_below(random, 4)];
    pose.position.x = size / 2 * random_range(random, -9, 9);
    pose.position.y = size / 2 * random_range(random, -9, 9);
  } else {
    CHECK(gjk2_rotation_from_angle(random_range(random, -400000, 400000), &pose.rotation) == GJK_OK);
    pose.position.x = random_range(random, -reach, reach);
    pose.position.y = random_range(random, -reach, reach);
  }
  return pose;
}

typedef struct answers {
  gjk_status status[QUERIES];
  gjk2_decision touch, within;
  gjk2_distance_result gap, until, apart;
  gjk2_penetration_result depth;
  gjk2_manifold contacts;
} answers;

typedef struct question {
  gjk2_collider a, b;
  gjk_q16 margin;
  gjk2_effort effort;
} question;

static void ask(const question *q, const gjk2_cache *from, answers *out) {
  gjk2_cache c[QUERIES], *cache[QUERIES];
  for (int i = 0; i < QUERIES; i++) {
    memset(&c[i], 0, sizeof c[i]);
    c[i] = from != NULL ? *from : c[i];
    cache[i] = from != NULL ? &c[i] : NULL;
  }
  memset(out, 0, sizeof *out);
  out->status[0] = gjk2_intersect(&q->a, &q->b, cache[0], &out->touch);
  out->status[1] = gjk2_within(&q->a, &q->b, q->margin, cache[1], &out->within);
  out->status[2] = gjk2_distance(&q->a, &q->b, cache[2], &out->gap);
  out->status[3] = gjk2_distance_until(&q->a, &q->b, &q->effort, cache[3], &out->until);
  out->status[4] = gjk2_penetration(&q->a, &q->b, cache[4], &out->depth);
  out->status[5] = gjk2_signed_distance(&q->a, &q->b, cache[5], &out->apart);
  out->status[6] = gjk2_contacts(&q->a, &q->b, q->margin, 2, cache[6], &out->contacts);
}

static unsigned long differing[QUERIES];

static void compare(unsigned pair, const char *cache, const answers *p, const answers *q) {
  const bool same[QUERIES] = {p->touch.yes == q->touch.yes,
                              p->within.yes == q->within.yes,
                              same_gap(&p->gap, &q->gap),
                              same_gap(&p->until, &q->until),
                              same_depth(&p->depth, &q->depth),
                              same_gap(&p->apart, &q->apart),
                              same_manifold(&p->contacts, &q->contacts)};
  for (int k = 0; k < QUERIES; k++) {
    if ((p->status[k] != q->status[k] || !same[k]) && differing[k]++ < 2) {
      printf("pair %u: query %d with %s\n", pair, k, cache);
    }
  }
}

static void check_proofs(unsigned pair, const question *q, const answers *x) {
  CHECK_MSG(gjk2_check_decision(&q->a, &q->b, 0, &x->touch) == GJK_OK, "pair %u", pair);
  CHECK_MSG(gjk2_check_decision(&q->a, &q->b, q->margin, &x->within) == GJK_OK, "pair %u", pair);
  CHECK_MSG(gjk2_check_distance(&q->a, &q->b, &x->gap) == GJK_OK, "pair %u", pair);
  const gjk_status deep = gjk2_check_penetration(&q->a, &q->b, &x->depth);
  CHECK_MSG(deep == GJK_OK || (deep == GJK_ERROR_UNSUPPORTED && !x->depth.intersecting), "pair %u", pair);
  CHECK_MSG(x->apart.intersecting || gjk2_check_distance(&q->a, &q->b, &x->apart) == GJK_OK, "pair %u", pair);
}

static gjk2_cache make_rubbish(random_state *random) {
  gjk2_cache c;
  for (int k = 0; k < 2; k++) {
    c.direction[k] = (int16_t)random_range(random, -32768, 32767);
    c.a[k] = (uint16_t)random_below(random, CORNERS + 1);
    c.b[k] = (uint16_t)random_below(random, CORNERS + 1);
  }
  c.count = (uint16_t)random_below(random, 4);
  return c;
}

int main(void) {
  unsigned touching = 0, apart = 0;
  gjk2_cache before = {0};
  for (unsigned i = 0; i < PAIRS; i++) {
    random_state random = random_seed(check_seed(SEED) + i);
    const bool aligned = i % 2 == 0;
    const gjk_q16 size = aligned ? 2 << random_below(&random, 17) : random_range(&random, 3, 1 << (4 + i % 16));
    const gjk2_shape shapes[2] = {make_shape(&random, 0, size, aligned), make_shape(&random, 1, size, aligned)};
    const gjk2_pose poses[2] = {make_pose(&random, aligned, size, size), make_pose(&random, aligned, size, 5 * size)};
    const gjk2_cache rubbish = make_rubbish(&random);
    question q;
    answers cold, warm;
    gjk2_cache own = {0}, past = {0};
    gjk2_distance_result gap;
    const bool baked = i % 3 != 0;
    CHECK(gjk2_collider_init(&q.a, &shapes[0], baked ? posed[0] : NULL, CORNERS) == GJK_OK);
    CHECK(gjk2_collider_init(&q.b, &shapes[1], baked ? posed[1] : NULL, CORNERS) == GJK_OK);
    const gjk2_vec place = {poses[1].position.x + random_range(&random, -size / 8 - 1, size / 8 + 1),
                            poses[1].position.y + random_range(&random, -size / 8 - 1, size / 8 + 1)};
    CHECK(gjk2_collider_pose(&q.a, &poses[0]) == GJK_OK && gjk2_collider_pose(&q.b, &poses[1]) == GJK_OK);
    CHECK(gjk2_collider_move(&q.b, &place) == GJK_OK && gjk2_distance(&q.a, &q.b, &past, &gap) == GJK_OK);
    CHECK(gjk2_collider_move(&q.b, &poses[1].position) == GJK_OK);
    q.margin = size * (int32_t)random_below(&random, 3);
    q.effort.iterations = (uint8_t)random_below(&random, 6);
    q.effort.error = random_below(&random, 2) == 0 ? 0 : size / 8;
    ask(&q, NULL, &cold);
    check_proofs(i, &q, &cold);
    CHECK(gjk2_distance(&q.a, &q.b, &own, &gap) == GJK_OK);
    const gjk2_cache *const caches[4] = {&own, &past, &before, &rubbish};
    static const char *const names[4] = {"its own cache", "that from before a move", "another pair's cache",
                                         "a cache of random bits"};
    for (int k = 0; k < 4; k++) {
      ask(&q, caches[k], &warm);
      compare(i, names[k], &cold, &warm);
      check_proofs(i, &q, &warm);
    }
    before = own;
    touching += cold.touch.yes;
    apart += !cold.gap.intersecting;
  }
  printf("%u touching, %u apart\n", touching, apart);
  printf(
      "differ by cache: %lu intersections, %lu within, %lu distances, %lu of an effort, %lu depths, %lu signed, %lu "
      "manifolds\n",
      differing[0], differing[1], differing[2], differing[3], differing[4], differing[5], differing[6]);
  for (int k = 0; k < QUERIES; k++) {
    CHECK(differing[k] == 0);
  }
  CHECK(touching > PAIRS / 8);
  CHECK(apart > PAIRS / 8);
  return check_done("plane canonical");
}
