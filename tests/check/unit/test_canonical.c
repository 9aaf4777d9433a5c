// A cache changes speed and nothing else: every field of every answer but iterations and certificate is the same from a
// cold start, with its own cache, with that of another pair, and with random bytes. Half of the pairs are aligned on a
// lattice, where features tie: equal faces, parallel edges, repeated, collinear and coplanar vertices, shapes in the same
// place. Each answer also has its proof. test_ceilings.sh repeats this test with low ceilings.
//
// A and B exchanged give the same decision, distance, depth and bounds; the same points to 2 LSB and the same normal to
// 4 units of 2^-30 where these are unique.
#include <math.h>
#include <string.h>

#include "check.h"
#include "generate/polytope.h"
#include "gjk/check.h"
#include "gjk/gjk.h"
#include "random_vec.h"
#include "same.h"
#include "src/gjk/gjk_iteration.h"
#include "src/gjk/gjk_search.h"

#define PAIRS check_trials(20000)
#define SEED 9300
#define CORNERS 18
#define CELLS 260u
#define KINDS 13

static gjk_vec3 corners[2][CORNERS];
static gjk_epa_cell cells[CELLS];

static const uint16_t cube_corner[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const uint16_t cube_end[] = {4, 8, 12, 16, 20, 24};
static const gjk_hull_faces cube_faces = {cube_corner, cube_end, 6};

// A box's corners as a hull; from 8 on points in its edges and faces, one of them twice.
static void make_corners(gjk_vec3 *v, gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  static const int8_t more[CORNERS - 8][3] = {{0, 1, 1},  {0, -1, 1}, {0, 0, 1},  {1, 0, -1},  {1, 1, 1},
                                              {-1, 0, 0}, {0, 0, 1},  {1, 1, -1}, {-1, -1, 0}, {0, -1, -1}};
  for (int k = 0; k < CORNERS; k++) {
    const gjk_vec3 sign = {(k & 1) * 2 - 1, (k & 2) - 1, (k & 4) / 2 - 1};
    v[k].x = x * (k < 8 ? sign.x : more[k - 8][0]);
    v[k].y = y * (k < 8 ? sign.y : more[k - 8][1]);
    v[k].z = z * (k < 8 ? sign.z : more[k - 8][2]);
  }
}

static gjk_shape make_shape(random_state *random, int i, gjk_q16 size, bool aligned) {
  const gjk_q16 x = size * random_range(random, 1, 3), y = size * random_range(random, 1, 3), z = size;
  const unsigned kind = random_below(random, KINDS);
  gjk_vec3 *v = corners[i];
  make_corners(v, x, y, z);
  if (kind >= 9 && !aligned) {
    for (int k = 0; k < CORNERS; k++) {
      v[k] = generate_vector(random, size);
    }
  }
  switch (kind) {
    case 0:
    case 1:
    case 2: return (gjk_shape)GJK_BOX(x, y, z);
    case 3: return (gjk_shape)GJK_CAPSULE(size / 2, x);
    case 4: return (gjk_shape)GJK_ROUNDED_BOX(x, y, z, size / 8);
    case 5: return (gjk_shape)GJK_BOX(x, y, 0);
    case 6: return (gjk_shape)GJK_SPHERE(size);
    case 7: return (gjk_shape)GJK_HULL_WITH_FACES(v, 8, &cube_faces);
    case 8: return (gjk_shape)GJK_SEGMENT(x);
    case 9: return (gjk_shape)GJK_TRIANGLE(v);
    case 10: return (gjk_shape)GJK_HULL(v, CORNERS);
    case 11: return (gjk_shape)GJK_ROUNDED_HULL(v, 8, size / 8);
    default: break;
  }
  return (gjk_shape)GJK_HULL(v, 6);
}

static gjk_pose make_pose(random_state *random, bool aligned, gjk_q16 size, double reach) {
  static const gjk_q30 h = 759250125;  // sqrt(1/2)
  const gjk_quat turns[5] = {{0, 0, 0, GJK_Q30_ONE}, {0, 0, 0, GJK_Q30_ONE}, {h, 0, 0, h}, {0, h, 0, h}, {0, 0, h, h}};
  gjk_pose pose = GJK_POSE_IDENTITY;
  if (aligned) {
    pose.rotation = turns[random_below(random, 5)];
    pose.position.x = size / 2 * random_range(random, -9, 9);
    pose.position.y = size / 2 * random_range(random, -9, 9);
    pose.position.z = size / 2 * random_range(random, -9, 9);
  } else {
    pose.rotation = generate_rotation(random);
    pose.position = generate_vector(random, reach * 2 * generate_unit(random));
  }
  return pose;
}

typedef struct answers {
  gjk_status touched, near, measured, stopped, pierced, parted, met;
  gjk_decision touch, within;
  gjk_distance_result gap, until, apart;
  gjk_penetration_result depth;
  gjk_manifold contacts;
} answers;

typedef struct question {
  gjk_collider a, b;
  gjk_q16 margin;
  gjk_workspace workspace;
  gjk_effort effort;
} question;

static void ask(const question *q, const gjk_cache *from, answers *out) {
  const gjk_cache none = {{0, 0, 0}, 0, {0, 0, 0, 0}, {0, 0, 0, 0}};
  gjk_cache c[7];
  gjk_cache *cache[7];
  for (int i = 0; i < 7; i++) {
    c[i] = from != NULL ? *from : none;
    cache[i] = from != NULL ? &c[i] : NULL;
  }
  memset(out, 0, sizeof *out);
  out->touched = gjk_intersect(&q->a, &q->b, cache[0], &out->touch);
  out->near = gjk_within(&q->a, &q->b, q->margin, cache[1], &out->within);
  out->measured = gjk_distance(&q->a, &q->b, cache[2], &out->gap);
  out->stopped = gjk_distance_until(&q->a, &q->b, &q->effort, cache[3], &out->until);
  out->pierced = gjk_penetration(&q->a, &q->b, cache[4], &q->workspace, &out->depth);
  out->parted = gjk_signed_distance(&q->a, &q->b, cache[5], &q->workspace, &out->apart);
  out->met = gjk_contacts(&q->a, &q->b, q->margin, GJK_CONTACTS_MAX, cache[6], &q->workspace, &out->contacts);
}

static unsigned long differing[7];

static void count(unsigned long *differ, bool same, unsigned pair, const char *what, const char *cache) {
  if (!same && (*differ)++ < 3) {
    printf("pair %u: another %s with %s\n", pair, what, cache);
  }
}

static void compare(unsigned pair, const char *cache, const answers *cold, const answers *warm) {
  count(&differing[0], cold->touched == warm->touched && cold->touch.yes == warm->touch.yes, pair, "intersection",
        cache);
  count(&differing[1], cold->near == warm->near && cold->within.yes == warm->within.yes, pair, "nearness", cache);
  count(&differing[2], cold->measured == warm->measured && same_gap(&cold->gap, &warm->gap), pair, "distance", cache);
  count(&differing[3], cold->stopped == warm->stopped && same_gap(&cold->until, &warm->until), pair, "effort", cache);
  count(&differing[4], cold->pierced == warm->pierced && same_depth(&cold->depth, &warm->depth), pair, "depth", cache);
  count(&differing[5], cold->parted == warm->parted && same_gap(&cold->apart, &warm->apart), pair, "signed distance",
        cache);
  count(&differing[6], cold->met == warm->met && same_manifold(&cold->contacts, &warm->contacts), pair, "manifold",
        cache);
}

// The proofs of an answer.
static void check_proofs(unsigned pair, const question *q, const answers *x) {
  CHECK_MSG(gjk_check_decision(&q->a, &q->b, 0, &x->touch) == GJK_OK, "pair %u", pair);
  CHECK_MSG(gjk_check_decision(&q->a, &q->b, q->margin, &x->within) == GJK_OK, "pair %u", pair);
  CHECK_MSG(gjk_check_distance(&q->a, &q->b, &x->gap) == GJK_OK, "pair %u", pair);
  CHECK_MSG(x->pierced != GJK_OK || gjk_check_penetration(&q->a, &q->b, &x->depth) == GJK_OK, "pair %u", pair);
  CHECK_MSG(x->apart.intersecting || gjk_check_distance(&q->a, &q->b, &x->apart) == GJK_OK, "pair %u", pair);
}

static gjk_cache make_rubbish(random_state *random) {
  gjk_cache c;
  for (int k = 0; k < 3; k++) {
    c.direction[k] = (int16_t)random_range(random, -32768, 32767);
  }
  c.count = (uint16_t)random_below(random, 6);
  for (int k = 0; k < 4; k++) {
    c.a[k] = (uint16_t)random_below(random, random_below(random, 2) == 0 ? 8 : CORNERS + 1);
    c.b[k] = (uint16_t)random_below(random, random_below(random, 2) == 0 ? 8 : CORNERS + 1);
  }
  return c;
}

static void pose(question *q, const gjk_shape shapes[2], const gjk_pose poses[2]) {
  CHECK(gjk_collider_init(&q->a, &shapes[0], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_init(&q->b, &shapes[1], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&q->a, &poses[0]) == GJK_OK);
  CHECK(gjk_collider_pose(&q->b, &poses[1]) == GJK_OK);
}

static void check_caches(void) {
  unsigned touching = 0, apart = 0, full = 0;
  gjk_cache before = {0};
  for (unsigned i = 0; i < PAIRS; i++) {
    random_state random = random_seed(check_seed(SEED) + i);
    const bool aligned = i % 2 == 0;
    const gjk_q16 size = aligned ? 2 << random_below(&random, 17) : generate_reach(&random) / 8 + 8;
    const gjk_shape shapes[2] = {make_shape(&random, 0, size, aligned), make_shape(&random, 1, size, aligned)};
    question q;
    answers cold, warm;
    const gjk_pose poses[2] = {make_pose(&random, aligned, size, size), make_pose(&random, aligned, size, 4.0 * size)};
    const gjk_cache rubbish = make_rubbish(&random);
    gjk_cache own = {0};
    pose(&q, shapes, poses);
    q.margin = size * (int32_t)random_below(&random, 3);
    q.workspace.cells = cells;
    q.workspace.count = random_below(&random, 4) == 0 ? random_below(&random, 40) : CELLS;
    q.effort.iterations = (uint8_t)random_below(&random, 6);
    q.effort.error = random_below(&random, 2) == 0 ? 0 : size / 8;
    ask(&q, NULL, &cold);
    check_proofs(i, &q, &cold);
    gjk_distance_result gap;
    gjk_distance(&q.a, &q.b, &own, &gap);
    ask(&q, &own, &warm);
    compare(i, "its own cache", &cold, &warm);
    check_proofs(i, &q, &warm);
    gjk_penetration_result depth;
    gjk_penetration(&q.a, &q.b, &own, &q.workspace, &depth);
    ask(&q, &own, &warm);
    compare(i, "the cache of its depth", &cold, &warm);
    ask(&q, &before, &warm);
    compare(i, "another pair's cache", &cold, &warm);
    check_proofs(i, &q, &warm);
    ask(&q, &rubbish, &warm);
    compare(i, "a cache of random bits", &cold, &warm);
    check_proofs(i, &q, &warm);
    before = own;
    touching += cold.touch.yes;
    apart += cold.measured == GJK_OK && !cold.gap.intersecting;
    full += cold.pierced == GJK_ERROR_CAPACITY;
  }
  printf("%u touching, %u apart, %u beyond the workspace\n", touching, apart, full);
  printf(
      "differ by cache: %lu intersections, %lu within, %lu distances, %lu of an effort, %lu depths, %lu signed, %lu "
      "manifolds\n",
      differing[0], differing[1], differing[2], differing[3], differing[4], differing[5], differing[6]);
  for (int k = 0; k < 7; k++) {
    CHECK(differing[k] == 0);
  }
  CHECK(touching > PAIRS / 8);
  CHECK(apart > PAIRS / 8);
  CHECK(full > PAIRS / 100);
}

static int32_t larger(int32_t a, int32_t b) {
  return a > b ? a : b;
}

// The largest difference of a coordinate.
static int32_t difference(const gjk_vec3 *a, const gjk_vec3 *b) {
  return larger(larger(abs(a->x - b->x), abs(a->y - b->y)), abs(a->z - b->z));
}

// The same of a direction and the opposite one.
static int32_t turn(const gjk_unit3 *a, const gjk_unit3 *b) {
  return larger(larger(abs(a->x + b->x), abs(a->y + b->y)), abs(a->z + b->z));
}

// The height of the plane that a certificate names, LSB.
static long double height_of(const gjk_collider *a, const gjk_collider *b, const gjk_certificate *c) {
  long double w[3][3], n[3];
  for (int i = 0; i < 3; i++) {
    gjk_vec3 u, v;
    CHECK(a->shape->type->vertex(a, c->a[i], &u) && b->shape->type->vertex(b, c->b[i], &v));
    w[i][0] = (long double)a->centre.x - b->centre.x + u.x - v.x;
    w[i][1] = (long double)a->centre.y - b->centre.y + u.y - v.y;
    w[i][2] = (long double)a->centre.z - b->centre.z + u.z - v.z;
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = (w[1][j] - w[0][j]) * (w[2][k] - w[0][k]) - (w[1][k] - w[0][k]) * (w[2][j] - w[0][j]);
  }
  return (n[0] * w[0][0] + n[1] * w[0][1] + n[2] * w[0][2]) / sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

static unsigned long unique, several, deep, other_way;

// Are there more vertices as near as the feature's, of parallel edges or faces, than a triangle or a parallelogram has?
static bool has_several(const question *q) {
  gjk_iteration it;
  gjk_iteration_start(&it, &q->a, &q->b, GJK_GOAL_SIGNED, 0);
  CHECK(gjk_search(&it, GJK_GOAL_SIGNED, NULL, GJK_NO_LIMIT) == GJK_OUTCOME_NEAREST);
  return it.ties[0] + it.ties[1] > 2 || (it.ties[0] + it.ties[1] == 2 && it.simplex.count < 3);
}

static void check_exchanged_gap(unsigned pair, const question *q) {
  gjk_distance_result there, back;
  CHECK(gjk_distance(&q->a, &q->b, NULL, &there) == GJK_OK && gjk_distance(&q->b, &q->a, NULL, &back) == GJK_OK);
  CHECK_MSG(there.intersecting == back.intersecting && there.distance == back.distance, "pair %u", pair);
  if (there.intersecting) {
    return;
  }
  CHECK_MSG(turn(&there.normal, &back.normal) <= 4, "pair %u: %d", pair, turn(&there.normal, &back.normal));
  const bool tied = has_several(q);
  unique += !tied;
  several += tied;
  CHECK_MSG(tied || (difference(&there.point_a, &back.point_b) <= 2 && difference(&there.point_b, &back.point_a) <= 2),
            "pair %u: %d %d", pair, difference(&there.point_a, &back.point_b),
            difference(&there.point_b, &back.point_a));
}

// Where the direction is another one, both planes are exactly as high. Of two boxes to an LSB.
static void check_exchanged_depth(unsigned pair, const question *q) {
  gjk_penetration_result there, back;
  const gjk_status status = gjk_penetration(&q->a, &q->b, NULL, &q->workspace, &there);
  CHECK_MSG(gjk_penetration(&q->b, &q->a, NULL, &q->workspace, &back) == status, "pair %u", pair);
  CHECK_MSG(there.intersecting == back.intersecting, "pair %u", pair);
  if (status != GJK_OK || !there.intersecting) {
    return;
  }
  CHECK_MSG(there.depth == back.depth && there.lower == back.lower && there.upper == back.upper, "pair %u", pair);
  deep++;
  if (turn(&there.normal, &back.normal) > 4 && there.certificate.proof == GJK_PROOF_FACET &&
      back.certificate.proof == GJK_PROOF_FACET) {
    other_way++;
    const long double one = height_of(&q->a, &q->b, &there.certificate);
    const long double other = height_of(&q->b, &q->a, &back.certificate);
    const bool boxes = q->a.shape->type->kind == GJK_KIND_AXES && q->b.shape->type->kind == GJK_KIND_AXES;
    CHECK_MSG(fabsl(one - other) <= (boxes ? 1 : 1e-9L * (one + 1)), "pair %u: %.12Lf %.12Lf", pair, one, other);
  }
}

static void check_exchanged(void) {
  for (unsigned i = 0; i < PAIRS; i++) {
    random_state random = random_seed(check_seed(SEED) + 1000000 + i);
    const bool aligned = i % 4 == 0;
    // Every other pair is of a few LSB: there directions are often within an LSB of each other, and not as deep.
    const gjk_q16 size = aligned      ? 2 << random_below(&random, 25)
                         : i % 2 == 0 ? generate_reach(&random) / 8 + 8
                                      : random_range(&random, 4, 60);
    const gjk_shape shapes[2] = {make_shape(&random, 0, size, aligned), make_shape(&random, 1, size, aligned)};
    const gjk_pose poses[2] = {make_pose(&random, aligned, size, size), make_pose(&random, aligned, size, size / 4.0)};
    question q;
    pose(&q, shapes, poses);
    q.workspace.cells = cells;
    q.workspace.count = CELLS;
    check_exchanged_gap(i, &q);
    check_exchanged_depth(i, &q);
  }
  printf("exchanged: %lu unique, %lu with several nearest points, %lu deep, %lu of them another way\n", unique, several,
         deep, other_way);
  CHECK(unique > PAIRS / 8 && several > PAIRS / 50);
  CHECK(deep > PAIRS / 4 && other_way < deep / 4);
}

// Long octahedra with a point near their middle: facets on either side of x are within an LSB of each other. The one that is
// reported is the lowest, not one that is as deep in whole LSB.
static void check_lowest_facet(void) {
  unsigned close = 0;
  for (unsigned i = 0; i < PAIRS / 10; i++) {
    random_state random = random_seed(check_seed(SEED) + 2000000 + i);
    const gjk_q16 size = 1 << (14 + random_below(&random, 10));
    const gjk_q16 x = 4 * size + random_range(&random, 0, 9), y = size + random_range(&random, 0, 9);
    const gjk_q16 z = size + random_range(&random, 0, 9);
    const gjk_vec3 v[6] = {{x, 0, 0}, {-x, 0, 0}, {0, y, 0}, {0, -y, 0}, {0, 0, z}, {0, 0, -z}};
    const gjk_shape shapes[2] = {GJK_HULL(v, 6), GJK_POINT};
    gjk_pose poses[2] = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY};
    gjk_penetration_result depth;
    question q;
    poses[1].position = random_in_cube(&random, 3);
    pose(&q, shapes, poses);
    q.workspace.cells = cells;
    q.workspace.count = CELLS;
    const long double a = 1.0L / x, b = 1.0L / y, c = 1.0L / z, far = sqrtl(a * a + b * b + c * c);
    const gjk_vec3 *at = &poses[1].position;
    const long double least = (1 - a * abs(at->x) - b * abs(at->y) - c * abs(at->z)) / far;
    CHECK(gjk_penetration(&q.a, &q.b, NULL, &q.workspace, &depth) == GJK_OK && depth.intersecting);
    CHECK_MSG(fabsl(height_of(&q.a, &q.b, &depth.certificate) - least) < 1e-6L, "octahedron %u: %Lf, not %Lf", i,
              height_of(&q.a, &q.b, &depth.certificate), least);
    close += at->x != 0;
  }
  CHECK(close > PAIRS / 100);
}

int main(void) {
  check_lowest_facet();
  check_caches();
  check_exchanged();
  return check_done("canonical");
}
