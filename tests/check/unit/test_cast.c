// Casts and rays by hand: statuses, ways whose answer is plain, ties, and both sides of an LSB.
//
// Random casts against an exact oracle are in test_cast_certificates.c.
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "random_vec.h"

#define SEED 14
#define TRIALS ((int)check_trials(20000))

// Casts b to a place, checks the proof, and that a ray answers alike where b is a point.
static gjk_cast_result cast(const gjk_collider *a, const gjk_collider *b, int32_t x, int32_t y, int32_t z) {
  const gjk_vec3 to = {x, y, z};
  const gjk_cast_path path = {NULL, &to, 0};
  gjk_cast_result result, ray;
  memset(&result, 0, sizeof result);
  memset(&ray, 0, sizeof ray);
  CHECK(gjk_cast(a, b, &path, &result) == GJK_OK);
  CHECK(gjk_check_cast(a, b, &path, &result) == GJK_OK);
  if (b->shape->type == &gjk_class_point && b->shape->convex_radius == 0) {
    CHECK(gjk_cast_ray(a, &b->position, &to, &ray) == GJK_OK);
    CHECK(memcmp(&result, &ray, sizeof ray) == 0);
  }
  return result;
}

// How a cast of the table ends.
typedef enum expected { MISS, HIT, INSIDE } expected;

typedef struct row {
  const char *name;
  const gjk_shape *a, *b;
  gjk_vec3 from, to;
  expected expected;
  gjk_q30 fraction;
  gjk_vec3 rest;     // of a hit
  gjk_unit3 normal;  // of a hit; 0, 0, 0: several are right
} row;

static const gjk_vec3 flat_a[3] = {{-100, -100, 0}, {100, -100, 0}, {0, 100, 0}};
static const gjk_vec3 flat_b[3] = {{-10, -10, 0}, {10, -10, 0}, {0, 10, 0}};
static const gjk_vec3 corners[3] = {{-2, -2, 0}, {-2, 0, 0}, {0, 1, 0}};
static const gjk_shape box = GJK_BOX(100, 100, 100), point = GJK_POINT, small_box = GJK_BOX(10, 10, 10),
                       rod = GJK_SEGMENT(50), plate = GJK_TRIANGLE(flat_a), chip = GJK_TRIANGLE(flat_b),
                       wedge = GJK_TRIANGLE(corners),
                       huge_box = GJK_BOX(GJK_Q16(2300.0), GJK_Q16(2300.0), GJK_Q16(2300.0));

#define ONE GJK_Q30_ONE
#define NONE \
  { 0, 0, 0 }
#define X_UP \
  { GJK_Q30_ONE, 0, 0 }
#define Y_UP \
  { 0, GJK_Q30_ONE, 0 }
#define Z_UP \
  { 0, 0, GJK_Q30_ONE }

static const row rows[] = {
    {"ray onto a face", &box, &point, {300, 7, 9}, {-100, 7, 9}, HIT, ONE / 2, {100, 7, 9}, X_UP},
    {"ray that ends on the face", &box, &point, {300, 7, 9}, {100, 7, 9}, HIT, ONE, {100, 7, 9}, X_UP},
    {"ray that ends an LSB before", &box, &point, {300, 7, 9}, {101, 7, 9}, MISS, 0, NONE, NONE},
    {"ray from the face outwards", &box, &point, {100, 7, 9}, {300, 7, 9}, INSIDE, 0, {100, 7, 9}, NONE},
    {"ray from an LSB before outwards", &box, &point, {101, 7, 9}, {300, 7, 9}, MISS, 0, NONE, NONE},
    {"ray along a face's plane", &box, &point, {300, 100, 9}, {-100, 100, 9}, HIT, ONE / 2, {100, 100, 9}, X_UP},
    {"ray an LSB above the plane", &box, &point, {300, 101, 9}, {-100, 101, 9}, MISS, 0, NONE, NONE},
    {"ray along an edge", &box, &point, {300, 100, 100}, {-100, 100, 100}, HIT, ONE / 2, {100, 100, 100}, X_UP},
    {"ray through a corner", &box, &point, {200, 200, 0}, {0, 0, 200}, HIT, ONE / 2, {100, 100, 100}, NONE},
    {"ray past a corner by an LSB", &box, &point, {201, 200, 0}, {1, 0, 200}, MISS, 0, NONE, NONE},
    {"ray of length 0 outside", &box, &point, {101, 0, 0}, {101, 0, 0}, MISS, 0, NONE, NONE},
    {"ray of length 0 on a corner", &box, &point, {100, 100, 100}, {100, 100, 100}, INSIDE, 0, {100, 100, 100}, NONE},
    {"ray of an LSB", &box, &point, {101, 100, 0}, {100, 100, 0}, HIT, ONE, {100, 100, 0}, X_UP},
    {"point onto a point", &point, &point, {30, 60, -90}, {-10, -20, 30}, HIT, 805306368, {0, 0, 0}, NONE},
    {"point past a point", &point, &point, {30, 60, -90}, {-10, -20, 31}, MISS, 0, NONE, NONE},
    {"rod onto a rod, end on end", &rod, &rod, {0, 0, 300}, {0, 0, -100}, HIT, ONE / 2, {0, 0, 100}, Z_UP},
    {"rod onto a rod, from one end of the world to the other",
     &rod,
     &rod,
     {0, 0, INT32_MAX},
     {0, 0, INT32_MIN},
     HIT,
     536870886,
     {0, 0, 100},
     Z_UP},
    {"rod beside a rod, side on side", &rod, &rod, {40, 0, 30}, {-40, 0, 30}, HIT, ONE / 2, {0, 0, 30}, X_UP},
    {"ray onto a rod", &rod, &point, {40, 0, 50}, {-40, 0, 50}, HIT, ONE / 2, {0, 0, 50}, NONE},
    {"ray past a rod's end", &rod, &point, {40, 0, 51}, {-40, 0, 51}, MISS, 0, NONE, NONE},
    {"chip along a plate's plane", &plate, &chip, {0, 310, 0}, {0, -90, 0}, HIT, ONE / 2, {0, 110, 0}, NONE},
    {"chip an LSB above it", &plate, &chip, {0, 310, 1}, {0, -90, 1}, MISS, 0, NONE, NONE},
    {"chip onto a plate", &plate, &chip, {3, 4, 8}, {3, 4, -8}, HIT, ONE / 2, {3, 4, 0}, Z_UP},
    {"ray away from a wedge's corner", &wedge, &point, {0, -2, 0}, {4, -2, 0}, MISS, 0, NONE, NONE},
    {"box face on face", &box, &small_box, {310, 0, 0}, {-90, 0, 0}, HIT, ONE / 2, {110, 0, 0}, X_UP},
    {"box along a face, touching",
     &box,
     &small_box,
     {110, 400, 0},
     {110, -400, 0},
     HIT,
     389231411,
     {110, 110, 0},
     Y_UP},
    {"box along a face, an LSB off", &box, &small_box, {111, 400, 0}, {111, -400, 0}, MISS, 0, NONE, NONE},
    {"box from an edge away", &box, &small_box, {110, 110, 0}, {400, 400, 0}, INSIDE, 0, {110, 110, 0}, NONE},
    {"from one end of the world to the other",
     &box,
     &small_box,
     {INT32_MIN, -9, 9},
     {INT32_MAX, -9, 9},
     HIT,
     536870884,
     {-110, -9, 9},
     {-ONE, 0, 0}},
    {"the largest shapes, across the world",
     &huge_box,
     &huge_box,
     {INT32_MIN, INT32_MIN, INT32_MIN},
     {INT32_MAX, INT32_MAX, INT32_MAX},
     HIT,
     461504512,
     {-301465600, -301465600, -301465600},
     NONE},
    {"the largest shapes, an LSB apart",
     &huge_box,
     &huge_box,
     {INT32_MIN, 301465601, 0},
     {INT32_MAX, 301465601, 0},
     MISS,
     0,
     NONE,
     NONE},
};

static void check_row(const row *r) {
  const gjk_collider a = placed_at(r->a, 0, 0, 0), b = placed_at(r->b, r->from.x, r->from.y, r->from.z);
  const gjk_cast_result out = cast(&a, &b, r->to.x, r->to.y, r->to.z);
  CHECK_MSG(out.hit == (r->expected != MISS), "%s", r->name);
  if (!out.hit || r->expected == MISS) {
    return;
  }
  CHECK_MSG(out.inside == (r->expected == INSIDE), "%s", r->name);
  CHECK_MSG(out.fraction == r->fraction, "%s: %ld", r->name, (long)out.fraction);
  CHECK_MSG(memcmp(&out.rest_b, &r->rest, sizeof r->rest) == 0, "%s: rests at %ld %ld %ld", r->name, (long)out.rest_b.x,
            (long)out.rest_b.y, (long)out.rest_b.z);
  CHECK_MSG(memcmp(&out.rest_a, &a.position, sizeof a.position) == 0, "%s", r->name);
  if ((r->normal.x | r->normal.y | r->normal.z) != 0) {
    // a unit vector is rounded by up to 2 on an axis
    const int64_t x = (int64_t)out.normal.x - r->normal.x, y = (int64_t)out.normal.y - r->normal.y,
                  z = (int64_t)out.normal.z - r->normal.z;
    CHECK_MSG(x * x + y * y + z * z <= 12, "%s: normal %ld %ld %ld", r->name, (long)out.normal.x, (long)out.normal.y,
              (long)out.normal.z);
  }
}

// Outputs after an error are as they were.
static void check_refused(const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path, gjk_status status) {
  gjk_cast_result before, out;
  memset(&before, 0x5A, sizeof before);
  out = before;
  CHECK(gjk_cast(a, b, path, &out) == status);
  CHECK(memcmp(&out, &before, sizeof out) == 0);
  CHECK(gjk_check_cast(a, b, path, &out) == status);
}

static void check_statuses(void) {
  const gjk_collider a = placed_at(&box, INT32_MAX, 0, 0), b = placed_at(&small_box, INT32_MIN, 300, 0);
  const gjk_vec3 near = {INT32_MIN, 0, 0}, far = {INT32_MAX, 0, 0};
  const gjk_vec3 shifted[4] = {{110, 0, 0}, {90, 0, 0}, {100, 10, 0}, {100, 0, 10}};
  const gjk_shape off = GJK_HULL(shifted, 4);
  gjk_collider unposed = {0};
  gjk_cast_result out;
  const gjk_cast_path none = {NULL, NULL, 0}, negative = {NULL, NULL, -1}, apart = {&near, &far, 0};
  check_refused(NULL, &b, &none, GJK_ERROR_NULL);
  check_refused(&a, NULL, &none, GJK_ERROR_NULL);
  check_refused(&a, &b, NULL, GJK_ERROR_NULL);
  check_refused(&a, &unposed, &none, GJK_ERROR_UNINITIALISED);
  check_refused(&unposed, &b, &none, GJK_ERROR_UNINITIALISED);
  check_refused(&a, &b, &negative, GJK_ERROR_NEGATIVE);
  check_refused(&a, &b, &apart, GJK_ERROR_RANGE);  // towards each other by twice 2^32 - 1 LSB
  CHECK(gjk_cast(&a, &b, &none, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_check_cast(&a, &b, &none, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_cast_ray(&a, NULL, &near, &out) == GJK_ERROR_NULL);
  CHECK(gjk_cast_ray(&a, &near, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk_cast_ray(NULL, &near, &far, &out) == GJK_ERROR_NULL);
  CHECK(gjk_cast_ray(&a, &near, &far, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_cast_ray(&unposed, &near, &far, &out) == GJK_ERROR_UNINITIALISED);
  // The centre of the hull's box is 100 LSB from its origin: it would leave int32 at the end.
  const gjk_collider c = placed_at(&off, 0, 0, 0);
  const gjk_cast_path beyond = {NULL, &far, 0};
  check_refused(&b, &c, &beyond, GJK_ERROR_RANGE);
}

// Both move: only the way of one against the other counts, and both rest where they touch.
static void check_both_move(void) {
  const gjk_collider a = placed_at(&box, 0, 0, 0), b = placed_at(&box, 600, 0, 0);
  const gjk_vec3 to_a = {200, 50, -7}, to_b = {200, 50, -7};
  const gjk_cast_path path = {&to_a, &to_b, 0};
  gjk_cast_result out;
  CHECK(gjk_cast(&a, &b, &path, &out) == GJK_OK);
  CHECK(gjk_check_cast(&a, &b, &path, &out) == GJK_OK);
  CHECK(out.hit && !out.inside);
  CHECK(out.fraction == (gjk_q30)(((int64_t)2 << 30) / 3));  // 400 of 600
  CHECK(out.rest_a.x == 133 && out.rest_b.x == 333);         // 133 1/3 and 200 more
  CHECK(out.rest_a.y == 33 && out.rest_a.z == -5);           // 33 1/3, -4 2/3
  CHECK(out.rest_b.y == 33 && out.rest_b.z == -5);
  CHECK(out.point_a.x >= 232 && out.point_a.x <= 234);  // 233 1/3
}

// Balls: the way meets a sphere about A's centre where both radii and the margin reach.
static void check_balls(void) {
  const gjk_shape ball = GJK_SPHERE(300), marble = GJK_SPHERE(100);
  const gjk_collider a = placed_at(&ball, 0, 0, 0);
  for (int32_t y = 0; y <= 520; y++) {
    const gjk_collider b = placed_at(&marble, -1000, y, 0);
    const gjk_vec3 to = {1000, y, 0};
    const gjk_cast_path path = {NULL, &to, 100};
    gjk_cast_result out;
    CHECK(gjk_cast(&a, &b, &path, &out) == GJK_OK);
    CHECK_MSG(out.hit == (y <= 500), "%ld", (long)y);
    CHECK(gjk_check_cast(&a, &b, &path, &out) == GJK_OK);
    if (out.hit) {
      const int64_t x = -1000 + (((int64_t)2000 * out.fraction) >> 30), squared = x * x + (int64_t)y * y;
      CHECK_MSG(squared >= 499 * 499 && squared <= 503 * 503, "%ld: %ld", (long)y, (long)squared);
    }
    out.hit = !out.hit;
    out.inside = false;
    CHECK(gjk_check_cast(&a, &b, &path, &out) == GJK_ERROR_UNPROVEN);
  }
}

// At rest the shapes share no inner point; an LSB nearer along each axis of the normal, or on by the same way, they meet.
static void check_rest(const gjk_collider *a, gjk_collider *b, const gjk_vec3 *to, const gjk_cast_result *hit) {
  static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
  const gjk_workspace workspace = {cells, GJK_EPA_CELLS(64)};
  const gjk_vec3 from = b->position;
  gjk_penetration_result depth;
  CHECK(gjk_collider_move(b, &hit->rest_b) == GJK_OK);
  CHECK(gjk_penetration(a, b, NULL, &workspace, &depth) == GJK_OK);
  CHECK_MSG(!depth.intersecting || depth.depth == 0, "depth %ld", (long)depth.depth);
  // On from the resting place: it is at most an LSB per axis before the plane.
  const gjk_vec3 on = {hit->rest_b.x + (to->x - from.x), hit->rest_b.y + (to->y - from.y),
                       hit->rest_b.z + (to->z - from.z)};
  const gjk_cast_path path = {NULL, &on, 0};
  gjk_cast_result again;
  CHECK(gjk_cast(a, b, &path, &again) == GJK_OK);
  CHECK(gjk_check_cast(a, b, &path, &again) == GJK_OK);
  if (again.hit && !again.inside) {
    const double n = (double)hit->normal.x * (to->x - from.x) + (double)hit->normal.y * (to->y - from.y) +
                     (double)hit->normal.z * (to->z - from.z);
    const double gap = -n * again.fraction / 1073741824.0 / 1073741824.0;
    CHECK_MSG(gap <= 1.74 || memcmp(&again.normal, &hit->normal, sizeof hit->normal) != 0, "on by %f", gap);
  }
}

// Small hulls on a lattice, where ties are the rule.
static void check_random(random_state *random, unsigned long number, unsigned *hits, unsigned *most) {
  static gjk_vec3 vertices[2][24];
  const int32_t size = random_below(random, 2) == 0 ? 3 : 3000;
  const uint16_t n = (uint16_t)(1 + random_below(random, 24)), m = (uint16_t)(1 + random_below(random, 24));
  const gjk_shape of_a = GJK_HULL(vertices[0], n), of_b = GJK_HULL(vertices[1], m);
  check_trial(number, NULL, NULL);
  for (unsigned i = 0; i < 24; i++) {
    vertices[0][i] = random_in_cube(random, size);
    vertices[1][i] = random_in_cube(random, size);
  }
  const gjk_vec3 from = random_in_cube(random, 3 * size), to = random_in_cube(random, 3 * size);
  const gjk_collider a = placed_at(&of_a, 0, 0, 0);
  gjk_collider b = placed_at(&of_b, from.x, from.y, from.z);
  const gjk_cast_result out = cast(&a, &b, to.x, to.y, to.z);
  *most = out.iterations > *most ? out.iterations : *most;
  gjk_decision start;
  CHECK(gjk_intersect(&a, &b, NULL, &start) == GJK_OK);
  CHECK(start.yes == (out.hit && out.inside));
  if (out.hit && !out.inside) {
    ++*hits;
    check_rest(&a, &b, &to, &out);
  } else if (!out.hit) {
    CHECK(gjk_collider_move(&b, &to) == GJK_OK);
    CHECK(gjk_intersect(&a, &b, NULL, &start) == GJK_OK);
    CHECK(!start.yes);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  unsigned hits = 0, most = 0;
  for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    check_row(&rows[i]);
  }
  check_statuses();
  check_both_move();
  check_balls();
  for (int i = 0; i < TRIALS; i++) {
    check_random(&random, (unsigned long)i, &hits, &most);
  }
  printf("%u hits, %u iterations at most\n", hits, most);
  CHECK(hits > (unsigned)TRIALS / 10);
  CHECK(hits < (unsigned)TRIALS * 9 / 10);
  CHECK(most <= 30);
  return check_done("cast");
}
