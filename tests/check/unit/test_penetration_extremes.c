// Penetration at the limits: at the end of the world, with convex radii of an LSB, with no cells or very many, with
// caches that cannot help; and what is refused.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "case/case.h"
#include "check.h"
#include "exact/depth.h"
#include "gjk/gjk.h"
#include "placed.h"
#include "random.h"

#define SEED 31
#define ONE GJK_Q16_ONE
#define CELLS 4096
#define PAIRS ((int)check_trials(20000))
#define POINTS 17000
#define WIDENED 6000

static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};

static gjk_collider turned(const gjk_shape *shape, gjk_vec3 position, const gjk_quat *rotation) {
  const gjk_pose pose = {position, *rotation};
  return posed(shape, &pose);
}

static gjk_quat random_turn(random_state *random) {
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1001)};
  gjk_quat out;
  CHECK(gjk_quat_normalize(&q, &out) == GJK_OK);
  return out;
}

static gjk_vec3 sum(gjk_vec3 a, gjk_vec3 b) {
  return (gjk_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static gjk_q16 random_depth(random_state *random, gjk_q16 below) {
  return random_below(random, 2) == 0 ? 0 : (gjk_q16)random_below(random, (uint32_t)below);
}

// Sets the shapes and poses that a failure of the trial prints.
static void show(unsigned long number, const gjk_shape *a, gjk_vec3 at_a, const gjk_quat *turn_a, const gjk_shape *b,
                 gjk_vec3 at_b, const gjk_quat *turn_b) {
  static case_posed posed;
  posed = (case_posed){*a, *b, {at_a, *turn_a}, {at_b, *turn_b}};
  check_trial(number, case_show_posed, &posed);
}

// Overlaps at the corners of the world have the same bits as in its middle, although B has no room to move out.
static void test_end_of_world(void) {
  random_state random = random_seed(check_seed(SEED));
  unsigned long moved = 0, overlapping = 0;
  for (int i = 0; i < PAIRS; i++) {
    const gjk_q16 size = 3 + (gjk_q16)random_below(&random, UINT32_C(1) << (2 + random_below(&random, 16)));
    const gjk_shape box = GJK_ROUNDED_BOX(size, size / 2, size / 3, 1 + size / 4),
                    capsule = GJK_CAPSULE(size / 2, size);
    const gjk_quat turn_a = random_turn(&random), turn_b = random_turn(&random);
    const unsigned corner = random_below(&random, 8);
    gjk_vec3 end = {(corner & 1) != 0 ? INT32_MAX : INT32_MIN, (corner & 2) != 0 ? INT32_MAX : INT32_MIN,
                    (corner & 4) != 0 ? INT32_MAX : INT32_MIN};
    const gjk_vec3 inwards = {(corner & 1) != 0 ? -1 : 1, (corner & 2) != 0 ? -1 : 1, (corner & 4) != 0 ? -1 : 1};
    gjk_vec3 apart;
    // B is in the corner, or at one wall of the world. A is farther inside, or level with B so that it has no room
    // either.
    apart.x = -inwards.x * random_depth(&random, size);
    apart.y = -inwards.y * random_depth(&random, size);
    apart.z = -inwards.z * random_depth(&random, size);
    const unsigned walls = random_below(&random, 4);
    end.x = walls == 1 || walls == 2 ? 0 : end.x;
    end.y = walls == 2 || walls == 3 ? 0 : end.y;
    end.z = walls == 3 || walls == 1 ? 0 : end.z;
    const gjk_vec3 start = {end.x - apart.x, end.y - apart.y, end.z - apart.z}, origin = {0, 0, 0};
    show((unsigned long)i, &box, start, &turn_a, &capsule, end, &turn_b);
    const gjk_collider a = turned(&box, start, &turn_a), b = turned(&capsule, end, &turn_b);
    const gjk_collider p = turned(&box, origin, &turn_a), q = turned(&capsule, sum(origin, apart), &turn_b);
    gjk_penetration_result there = {0}, here = {0};
    CHECK(gjk_penetration(&a, &b, NULL, &workspace, &there) == GJK_OK);
    CHECK(gjk_penetration(&p, &q, NULL, &workspace, &here) == GJK_OK);
    const bool same = there.intersecting == here.intersecting &&
                      (!here.intersecting || (there.depth == here.depth && there.iterations == here.iterations &&
                                              memcmp(&there.normal, &here.normal, sizeof here.normal) == 0));
    CHECK_MSG(same, "pair %d: depth %ld there, %ld here", i, (long)there.depth, (long)here.depth);
    CHECK(gjk_check_penetration(&a, &b, &there) == GJK_OK);
    overlapping += here.intersecting;
    moved++;
  }
  CHECK(overlapping * 10 > moved * 5);
}

// Along each axis, at both ends of the world, B has no room to move out, so A must be moved.
static void test_walls(void) {
  static const gjk_shape ball = GJK_SPHERE(ONE);
  const gjk_quat none = {0, 0, 0, GJK_Q30_ONE};
  for (int axis = 0; axis < 3; axis++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      for (gjk_q16 room = 0; room < 2 * ONE + 3; room += ONE - 4) {
        const gjk_q16 end = sign > 0 ? INT32_MAX - room : INT32_MIN + room, inner = end - sign * 9;
        const gjk_vec3 at = {axis == 0 ? end : 5, axis == 1 ? end : 5, axis == 2 ? end : 5},
                       in = {axis == 0 ? inner : 5, axis == 1 ? inner : 5, axis == 2 ? inner : 5};
        const gjk_collider a = turned(&ball, in, &none), b = turned(&ball, at, &none);
        const gjk_unit3 normal = {axis == 0 ? sign * GJK_Q30_ONE : 0, axis == 1 ? sign * GJK_Q30_ONE : 0,
                                  axis == 2 ? sign * GJK_Q30_ONE : 0};
        gjk_penetration_result r;
        CHECK(gjk_penetration(&a, &b, NULL, &workspace, &r) == GJK_OK);
        CHECK(r.intersecting);
        CHECK(r.depth == 2 * ONE - 9);
        CHECK(memcmp(&r.normal, &normal, sizeof normal) == 0);
        CHECK(gjk_check_penetration(&a, &b, &r) == GJK_OK);
      }
    }
  }
}

// Large shapes with a convex radius of an LSB: the least by which a move can fail. B must part from A when it has
// moved.
static void test_thin_convex_radius(void) {
  random_state random = random_seed(check_seed(SEED) + 1);
  for (int i = 0; i < PAIRS; i++) {
    const gjk_q16 size = INT32_C(1) << (20 + random_below(&random, 7));
    const gjk_shape a_shape = GJK_ROUNDED_BOX(size, size / 2, size / 3, 1), b_shape = GJK_BOX(size / 3, size, size / 2);
    // Turns them by a little, so that normals are close to the axes.
    const gjk_vec3 axis = {random_range(&random, -ONE, ONE), random_range(&random, -ONE, ONE), ONE};
    gjk_quat turn_a, turn_b;
    CHECK(gjk_quat_from_axis_angle(&axis, 1 << random_below(&random, 16), &turn_a) == GJK_OK);
    CHECK(gjk_quat_from_axis_angle(&axis, 1 << random_below(&random, 16), &turn_b) == GJK_OK);
    const gjk_vec3 origin = {0, 0, 0},
                   at = {random_range(&random, -size / 2, size / 2), random_range(&random, -size / 2, size / 2),
                         random_range(&random, -size / 2, size / 2)};
    show((unsigned long)i, &a_shape, origin, &turn_a, &b_shape, at, &turn_b);
    const gjk_collider a = turned(&a_shape, origin, &turn_a);
    gjk_collider b = turned(&b_shape, at, &turn_b);
    gjk_penetration_result r;
    CHECK(gjk_penetration(&a, &b, NULL, &workspace, &r) == GJK_OK);
    CHECK(r.intersecting);
    CHECK(gjk_check_penetration(&a, &b, &r) == GJK_OK);
    gjk_vec3 to = at;
    gjk_q16 *const along[3] = {&to.x, &to.y, &to.z};
    const gjk_q30 u[3] = {r.normal.x, r.normal.y, r.normal.z};
    for (int k = 0; k < 3; k++) {  // rounded away from 0
      const int64_t product = (int64_t)r.depth * u[k];
      *along[k] += (gjk_q16)(product > 0 ? (product + GJK_Q30_ONE - 1) / GJK_Q30_ONE
                                         : -((-product + GJK_Q30_ONE - 1) / GJK_Q30_ONE));
    }
    gjk_decision d;
    gjk_distance_result gap;
    CHECK(gjk_collider_move(&b, &to) == GJK_OK);
    CHECK(gjk_distance(&a, &b, NULL, &gap) == GJK_OK);
    CHECK(gjk_intersect(&a, &b, NULL, &d) == GJK_OK);
    CHECK_MSG(gap.distance <= 3, "pair %d", i);
    CHECK_MSG(!d.yes || gap.certificate.proof != GJK_PROOF_ENCLOSING, "pair %d", i);
  }
}

static gjk_q30 narrowed(gjk_q30 u, gjk_q30 by) {
  return u > by ? u - by : u < -by ? u + by : u;
}

// A normal that is a little shorter may still be within 2^-28, but the move no longer parts the shapes. Then the
// library's check and the oracle must refuse it. Returns how often that happened.
static unsigned long narrow(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *found,
                            int pair) {
  unsigned long refused = 0;
  char why[200];
  for (gjk_q30 by = 1; by <= 2; by++) {
    gjk_penetration_result r = *found;
    r.normal.x = narrowed(r.normal.x, by);
    r.normal.y = narrowed(r.normal.y, by);
    r.normal.z = narrowed(r.normal.z, by);
    const bool parts = exact_check_move(a, b, &r, why, sizeof why);
    refused += !parts;
    CHECK_MSG(parts || gjk_check_penetration(a, b, &r) == GJK_ERROR_UNPROVEN, "pair %d, narrower by %d", pair, (int)by);
  }
  return refused;
}

// The largest boxes, turned by so little that a normal may lose more by rounding than the move gains by its own. The
// library widens such a normal until the move parts the shapes, wherever they are.
static void test_widened_normals(void) {
  const gjk_quat none = {0, 0, 0, GJK_Q30_ONE};
  random_state random = random_seed(check_seed(SEED) + 3);
  unsigned long refused[2] = {0, 0};
  for (int i = 0; i < WIDENED; i++) {
    const gjk_q16 size = INT32_C(1) << (27 - random_below(&random, 3));
    const gjk_q16 half = size - random_range(&random, 0, 1000), half2 = size - random_range(&random, 0, 1000);
    const gjk_shape a_shape = GJK_ROUNDED_BOX(half, size, size, i % 2), b_shape = GJK_BOX(half2, size, size);
    const gjk_vec3 axis = {random_range(&random, -ONE, ONE), random_range(&random, -ONE, ONE), ONE};
    gjk_quat turn;
    CHECK(gjk_quat_from_axis_angle(&axis, random_range(&random, 16, 64), &turn) == GJK_OK);
    const int side = random_below(&random, 2) == 0 ? 1 : -1;
    const gjk_vec3 start = {side * random_range(&random, 2 * size, 6 * size), random_range(&random, -size, size), 0};
    const gjk_vec3 end = {start.x + side * random_range(&random, size / 64, i % 64 == 0 ? size : size / 4), start.y,
                          start.z};
    show((unsigned long)i, &a_shape, start, &turn, &b_shape, end, &none);
    const gjk_collider a = turned(&a_shape, start, &turn), b = turned(&b_shape, end, &none);
    gjk_penetration_result r;
    char why[200] = "";
    CHECK(gjk_penetration(&a, &b, NULL, NULL, &r) == GJK_OK);
    CHECK(r.intersecting);
    CHECK_MSG(exact_check_penetration(&a, &b, &r, why, sizeof why), "pair %d: %s", i, why);
    CHECK_MSG(gjk_check_penetration(&a, &b, &r) == GJK_OK, "pair %d", i);
    refused[i % 2] += i % 8 < 2 ? narrow(&a, &b, &r, i) : 0;
  }
  printf("narrower normals refused: %lu, rounded %lu\n", refused[0], refused[1]);
  CHECK(refused[0] > 20);
  CHECK(refused[1] > 20);
}

// For boxes apart it reports the distance, with a cache or without.
static void test_signed_apart(void) {
  static const gjk_shape box = GJK_BOX(ONE, ONE, ONE);
  const gjk_quat none = {0, 0, 0, GJK_Q30_ONE};
  gjk_cache cache = {0};
  for (int extra = 0; extra < 4; extra++) {
    const gjk_vec3 origin = {0, 0, 0}, at = {0, 2 * ONE + 3 + extra, ONE / 2};
    const gjk_collider a = turned(&box, origin, &none), b = turned(&box, at, &none);
    gjk_distance_result r;
    CHECK(gjk_signed_distance(&a, &b, &cache, NULL, &r) == GJK_OK);
    CHECK(!r.intersecting);
    CHECK(r.distance == 3 + extra);
    CHECK(gjk_signed_distance(&a, &b, NULL, NULL, &r) == GJK_OK);
    CHECK(!r.intersecting);
    CHECK(r.distance == 3 + extra);
    CHECK(cache.count > 0);
  }
}

// Do the points lie across the normal from each other, to 2 LSB in each component?
static bool is_across(const gjk_penetration_result *r) {
  const int64_t x = (int64_t)r->point_a.x - r->point_b.x, y = (int64_t)r->point_a.y - r->point_b.y,
                z = (int64_t)r->point_a.z - r->point_b.z;
  const gjk_unit3 *n = &r->normal;
  return llabs(x * n->y - y * n->x) <= 4 * (int64_t)GJK_Q30_ONE &&
         llabs(y * n->z - z * n->y) <= 4 * (int64_t)GJK_Q30_ONE &&
         llabs(z * n->x - x * n->z) <= 4 * (int64_t)GJK_Q30_ONE;
}

// An EPA hull has at least four vertices. A workspace without cells has room for none. Every face of the first
// tetrahedron is above the origin.
static void test_workspaces(void) {
  for (uint16_t n = 0; n < 4; n++) {
    CHECK(gjk_workspace_bytes(n) == 0);
  }
  CHECK(gjk_workspace_bytes(4) == GJK_EPA_CELLS(4) * sizeof(gjk_epa_cell));
  CHECK(gjk_workspace_bytes(16000) == (size_t)GJK_EPA_CELLS(16000) * sizeof(gjk_epa_cell));
  static const gjk_vec3 corner[4] = {{ONE, ONE, ONE}, {-ONE, -ONE, ONE}, {-ONE, ONE, -ONE}, {ONE, -ONE, -ONE}};
  static const gjk_shape hull = GJK_HULL(corner, 4), ball = GJK_SPHERE(ONE / 4);
  static const gjk_workspace none = {NULL, CELLS}, empty = {cells, 0}, least = {cells, 8}, few = {cells, 7};
  static const gjk_workspace *const bad[] = {NULL, &none, &empty, &few};
  const gjk_quat turn = {0, 0, 0, GJK_Q30_ONE};
  const gjk_vec3 origin = {0, 0, 0}, at = {100, 200, 300};
  const gjk_collider a = turned(&hull, origin, &turn), b = turned(&ball, at, &turn);
  gjk_penetration_result whole, r;
  CHECK(gjk_penetration(&a, &b, NULL, &workspace, &whole) == GJK_OK);
  // The depth is the least of (1 + v . at) / sqrt(3) over the corners v, 37606.3 LSB, and the radius of the ball.
  CHECK(whole.depth == 37607 + ONE / 4);
  CHECK(gjk_penetration(&a, &b, NULL, &least, &r) == GJK_OK);
  CHECK(r.depth == whole.depth);
  for (unsigned i = 0; i < 4; i++) {
    memset(&r, 0, sizeof r);
    CHECK(gjk_penetration(&a, &b, NULL, bad[i], &r) == GJK_ERROR_CAPACITY);
    CHECK(r.intersecting);
    CHECK(r.lower <= whole.depth);
    CHECK(r.depth >= whole.depth);
    CHECK(r.depth == r.upper);
    CHECK(r.certificate.proof == GJK_PROOF_NONE);
    CHECK(r.iterations > 0);
    CHECK(is_across(&r));
  }
}

// If EPA would need more faces than it can number, the answer is bounds, and they hold.
static void test_many_faces(void) {
  static gjk_vec3 points[POINTS];
  const gjk_q16 radius = INT32_C(1) << 27;
  const double golden = 2.399963229728653;  // a spiral around a sphere
  for (int i = 0; i < POINTS; i++) {
    const double z = 1 - (2 * i + 1.0) / POINTS, flat = sqrt(1 - z * z);
    points[i].x = (gjk_q16)(radius * flat * cos(golden * i));
    points[i].y = (gjk_q16)(radius * flat * sin(golden * i));
    points[i].z = (gjk_q16)(radius * z);
  }
  static const gjk_shape hull = GJK_HULL(points, POINTS), point = GJK_POINT;
  const gjk_workspace large = {malloc((size_t)GJK_EPA_CELLS(POINTS) * sizeof(gjk_epa_cell)), GJK_EPA_CELLS(POINTS)};
  const gjk_quat turn = {0, 0, 0, GJK_Q30_ONE};
  const gjk_vec3 origin = {0, 0, 0};
  const gjk_collider a = turned(&hull, origin, &turn), b = turned(&point, origin, &turn);
  gjk_penetration_result r;
  CHECK(gjk_penetration(&a, &b, NULL, &large, &r) == GJK_ERROR_CAPACITY);
  CHECK(r.intersecting);
  printf("%u supports, depth %ld to %ld\n", r.iterations, (long)r.lower, (long)r.upper);
  CHECK(r.lower > radius - radius / 2000);
  CHECK(r.upper < radius);
  CHECK(r.lower <= r.upper);
  CHECK(r.iterations > 16000);
  free(large.cells);
}

// Refusals leave the output as it was. gjk_workspace_bytes agrees with GJK_EPA_CELLS.
static void test_refusals(void) {
  static const gjk_shape point = GJK_POINT;
  const gjk_quat turn = {0, 0, 0, GJK_Q30_ONE};
  const gjk_collider a = turned(&point, (gjk_vec3){123456, 0, 0}, &turn), none = {0};
  gjk_penetration_result r, before;
  gjk_distance_result d;
  CHECK(gjk_penetration(&a, &a, NULL, NULL, &r) == GJK_OK && r.intersecting && r.depth == 0);
  memset(&r, 0x5A, sizeof r);
  before = r;
  CHECK(gjk_penetration(NULL, &a, NULL, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_penetration(&a, NULL, NULL, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_penetration(&a, &a, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_penetration(&a, &none, NULL, NULL, &r) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_penetration(&none, &a, NULL, NULL, &r) == GJK_ERROR_UNINITIALISED);
  CHECK(memcmp(&r, &before, sizeof r) == 0);
  CHECK(gjk_signed_distance(NULL, &a, NULL, NULL, &d) == GJK_ERROR_NULL);
  CHECK(gjk_signed_distance(&a, &a, NULL, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_signed_distance(&a, &none, NULL, NULL, &d) == GJK_ERROR_UNINITIALISED);
  for (uint16_t vertices = 4; vertices < 16000; vertices = (uint16_t)(vertices + 37)) {
    CHECK(gjk_workspace_bytes(vertices) == sizeof(gjk_epa_cell) * GJK_EPA_CELLS((size_t)vertices));
  }
}

int main(void) {
  test_end_of_world();
  test_walls();
  test_thin_convex_radius();
  test_widened_normals();
  test_signed_apart();
  test_workspaces();
  test_many_faces();
  test_refusals();
  return check_done("penetration_extremes");
}
