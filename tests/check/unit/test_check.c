// Certificates that no query gives. The library's check refuses each one, for a reason of its own.
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "placed.h"

#define ONE GJK_Q16_ONE

static const gjk_vec3 corners[3] = {{-ONE, -ONE, 0}, {ONE, -ONE, 0}, {0, ONE, 0}};
static const gjk_shape dot = GJK_POINT, sheet = GJK_TRIANGLE(corners), cube = GJK_BOX(ONE, ONE, ONE);

// The status of the claim "apart; the first count vertices of A and vertex 0 of B are nearest".
static gjk_status nearest(const gjk_collider *a, const gjk_collider *b, uint8_t count) {
  gjk_decision decision = {0};
  decision.certificate.proof = GJK_PROOF_NEAREST;
  decision.certificate.count = count;
  for (uint8_t i = 0; i < count; i++) {
    decision.certificate.a[i] = i;
  }
  return gjk_check_decision(a, b, 0, &decision);
}

// Features that hold the origin are nearest to it, but prove no gap.
static void test_origin_on_feature(void) {
  const gjk_collider a = placed_at(&dot, 5, 5, 5), b = placed_at(&sheet, 0, 0, 0);
  const gjk_collider middle = placed_at(&dot, 0, -ONE, 0), inside = placed_at(&dot, 0, 0, 0),
                     above = placed_at(&dot, 0, 0, 1);
  CHECK(nearest(&a, &a, 1) == GJK_ERROR_UNPROVEN);
  CHECK(nearest(&b, &middle, 2) == GJK_ERROR_UNPROVEN);
  CHECK(nearest(&b, &inside, 3) == GJK_ERROR_UNPROVEN);
  CHECK(nearest(&b, &above, 3) == GJK_OK);
  CHECK(nearest(&b, &above, 2) == GJK_ERROR_UNPROVEN);
  CHECK(nearest(&b, &above, 0) == GJK_ERROR_UNPROVEN);
}

// The status of the claim "the four named vertices of A, minus vertex 0 of B, enclose the origin".
static gjk_status enclosed(const gjk_collider *a, const gjk_collider *b, const uint16_t vertices[4]) {
  gjk_decision decision;
  memset(&decision, 0, sizeof decision);
  decision.yes = true;
  decision.certificate.proof = GJK_PROOF_ENCLOSING;
  decision.certificate.count = 4;
  memcpy(decision.certificate.a, vertices, sizeof decision.certificate.a);
  return gjk_check_decision(a, b, 0, &decision);
}

// Every second corner of a cube makes a tetrahedron that holds the middle. Four corners of one face enclose nothing,
// also if the origin lies in their plane.
static void test_enclosing(void) {
  static const uint16_t alternate[4] = {0, 3, 5, 6}, top[4] = {4, 5, 6, 7}, twice[4] = {0, 3, 5, 5};
  const gjk_collider a = placed_at(&cube, 0, 0, 0), middle = placed_at(&dot, 0, 0, 0),
                     beside = placed_at(&dot, ONE + 9, 0, ONE);
  const gjk_collider in_corner = placed_at(&dot, ONE - 1, ONE - 1, ONE - 1);
  CHECK(enclosed(&a, &middle, alternate) == GJK_OK);
  CHECK(enclosed(&a, &in_corner, alternate) == GJK_ERROR_UNPROVEN);
  CHECK(enclosed(&a, &middle, top) == GJK_ERROR_UNPROVEN);
  CHECK(enclosed(&a, &beside, top) == GJK_ERROR_UNPROVEN);
  CHECK(enclosed(&a, &middle, twice) == GJK_ERROR_UNPROVEN);
}

// A direction proves a gap if each of its components is in range, and its square as well.
static void test_directions(void) {
  const gjk_collider a = placed_at(&cube, 0, 0, 0);
  gjk_decision decision = {0};
  decision.certificate.proof = GJK_PROOF_DIRECTION;
  const gjk_q16 most = 3 * (INT32_C(1) << 29);
  for (int axis = 0; axis < 3; axis++) {
    const gjk_q16 gap = 2 * ONE + 10;
    const gjk_collider b = placed_at(&cube, axis == 0 ? gap : 0, axis == 1 ? gap : 0, axis == 2 ? gap : 0);
    for (gjk_q16 size = most; size <= most + 1; size++) {
      gjk_vec3 d = {axis == 0 ? size : 0, axis == 1 ? size : 0, axis == 2 ? size : 0};
      const gjk_status status = size <= most ? GJK_OK : GJK_ERROR_UNPROVEN;
      decision.certificate.direction = d;
      CHECK(gjk_check_decision(&a, &b, 0, &decision) == status);
      CHECK(gjk_check_decision(&a, &b, 9, &decision) == status);
      CHECK(gjk_check_decision(&a, &b, 10, &decision) == GJK_ERROR_UNPROVEN);
      CHECK(gjk_check_decision(&a, &b, INT32_MAX, &decision) == GJK_ERROR_UNPROVEN);
      CHECK(gjk_check_decision(&b, &a, 0, &decision) == GJK_ERROR_UNPROVEN);
    }
  }
  // Components in range, but a square of 2^62 or more: products of that are wrong where they take digits.
  const gjk_collider near = placed_at(&dot, 1, 0, 0), origin = placed_at(&dot, 0, 0, 0);
  for (int bits = 28; bits <= 29; bits++) {
    const gjk_q16 size = 3 * (INT32_C(1) << bits);
    decision.certificate.direction = (gjk_vec3){-size, size, size};
    CHECK(gjk_check_decision(&near, &origin, 0, &decision) == (bits == 28 ? GJK_OK : GJK_ERROR_UNPROVEN));
    CHECK(gjk_check_decision(&near, &origin, 1, &decision) == GJK_ERROR_UNPROVEN);
  }
  // With the convex radii the asked distance needs more than 31 bits.
  static const gjk_shape ball = GJK_SPHERE(ONE);
  const gjk_collider p = placed_at(&ball, 0, 0, 0), q = placed_at(&ball, 5 * ONE, 0, 0);
  decision.certificate.direction = (gjk_vec3){ONE, 0, 0};
  CHECK(gjk_check_decision(&p, &q, 3 * ONE - 1, &decision) == GJK_OK);
  CHECK(gjk_check_decision(&p, &q, 3 * ONE, &decision) == GJK_ERROR_UNPROVEN);
  CHECK(gjk_check_decision(&p, &q, INT32_MAX, &decision) == GJK_ERROR_UNPROVEN);
}

// The largest shapes at the largest distance of a frame with shift 0, asked about more than such a frame can hold.
static void test_largest(void) {
  static const gjk_shape box = GJK_BOX(154943445, 154943445, 154943445), barrel = GJK_CYLINDER(189766190, 189766190);
  const gjk_q16 away = 619925130;  // 2^30 / sqrt(3)
  const gjk_shape *const shapes[2] = {&box, &barrel};
  for (int i = 0; i < 2; i++) {
    const gjk_collider a = placed_at(shapes[i], 0, 0, 0), b = placed_at(shapes[i], away, away, away);
    gjk_cache cache = {0};
    gjk_decision decision;
    for (int change = 0; change < 3; change++) {
      CHECK(gjk_intersect(&a, &b, &cache, &decision) == GJK_OK);
      CHECK(!decision.yes);
      CHECK(gjk_within(&a, &b, INT32_MAX, &cache, &decision) == GJK_OK);
      CHECK(decision.yes);
      CHECK(gjk_within(&a, &b, away / 4, &cache, &decision) == GJK_OK);
      CHECK(!decision.yes);
    }
  }
}

// If the bounding spheres are apart, the answer holds whatever the certificate says.
static void test_spheres(void) {
  const gjk_collider a = placed_at(&cube, 0, 0, 0), b = placed_at(&cube, 0, 0, 100 * ONE);
  gjk_decision decision = {0};
  CHECK(gjk_check_decision(&a, &b, 5, &decision) == GJK_OK);
  decision.yes = true;
  CHECK(gjk_check_decision(&a, &b, 5, &decision) == GJK_ERROR_UNPROVEN);
  // Shapes too far apart for exact proofs, asked about a distance larger still.
  const gjk_collider c = placed_at(&cube, 0, 0, INT32_MAX), d = placed_at(&cube, 0, 0, INT32_MIN + 2);
  CHECK(gjk_check_decision(&a, &c, INT32_MAX, &decision) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_check_decision(&c, &d, INT32_MAX, &decision) == GJK_ERROR_UNPROVEN);
}

// The right feature, with distances beside the right one.
static void test_distances(void) {
  const gjk_collider a = placed_at(&dot, 0, 0, 0), b = placed_at(&dot, 3, 4, 0);
  gjk_distance_result result = {0};
  CHECK(gjk_distance(&a, &b, NULL, &result) == GJK_OK);
  CHECK(result.distance == 5);
  CHECK(gjk_check_distance(&a, &b, &result) == GJK_OK);
  static const gjk_q16 wrong[] = {0, 4, 6, 65536, GJK_DISTANCE_MAX - 1, GJK_DISTANCE_MAX, -1, -5};
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    result.distance = result.lower = result.upper = wrong[i];
    CHECK_MSG(gjk_check_distance(&a, &b, &result) == GJK_ERROR_UNPROVEN, "%ld", (long)wrong[i]);
  }
}

static gjk_status penetrates(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result,
                             gjk_q16 depth) {
  gjk_penetration_result r = *result;
  r.depth = r.lower = r.upper = depth;
  return gjk_check_penetration(a, b, &r);
}

// Depths beside the right one, for each kind of proof; proofs that prove nothing; pairs that have no depth.
static void test_penetrations(void) {
  static gjk_epa_cell cells[GJK_EPA_CELLS(16)];
  static const gjk_workspace workspace = {cells, GJK_EPA_CELLS(16)};
  static const gjk_shape soft = GJK_ROUNDED_BOX(ONE, ONE, ONE, ONE), barrel = GJK_CYLINDER(ONE, ONE);
  const gjk_collider a = placed_at(&cube, 0, 0, 0), b = placed_at(&cube, 0, 0, 2 * ONE - 10),
                     far = placed_at(&cube, 0, 9 * ONE, 0);
  gjk_penetration_result r = {0};
  CHECK(gjk_check_penetration(NULL, &b, &r) == GJK_ERROR_NULL);
  CHECK(gjk_check_penetration(&a, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_check_penetration(&a, &b, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_check_penetration(&a, &far, &r) == GJK_OK);
  r.intersecting = true;
  CHECK(gjk_check_penetration(&a, &far, &r) == GJK_ERROR_UNPROVEN);
  const gjk_collider curved = placed_at(&barrel, 0, 0, 2 * ONE - 10);
  CHECK(gjk_penetration(&a, &curved, NULL, &workspace, &r) == GJK_OK);
  CHECK(r.intersecting);
  CHECK(gjk_check_penetration(&a, &curved, &r) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk_check_penetration(&curved, &a, &r) == GJK_ERROR_UNSUPPORTED);
  // Proven by a facet.
  CHECK(gjk_penetration(&a, &b, NULL, &workspace, &r) == GJK_OK);
  CHECK(r.depth == 10);
  CHECK(r.certificate.proof == GJK_PROOF_FACET);
  CHECK(gjk_check_penetration(&a, &b, &r) == GJK_OK);
  static const gjk_q16 wrong[] = {-INT32_MAX, -1, 0, 9, 11, 20, 65536, INT32_MAX};
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    CHECK(penetrates(&a, &b, &r, wrong[i]) == GJK_ERROR_UNPROVEN);
  }
  gjk_penetration_result other = r;
  // A point that slides along its face is as deep, but no longer opposite the other one.
  for (gjk_q16 slid = -5; slid <= 5; slid++) {
    other.point_a.x = r.point_a.x + slid;
    CHECK(gjk_check_penetration(&a, &b, &other) == (abs(slid) <= 3 ? GJK_OK : GJK_ERROR_UNPROVEN));
    other.point_a.x = r.point_a.x;
  }
  for (uint8_t count = 0; count <= 5; count++) {
    other.certificate.count = count;
    CHECK(gjk_check_penetration(&a, &b, &other) == (count == 3 ? GJK_OK : GJK_ERROR_UNPROVEN));
  }
  for (uint8_t proof = 0; proof < 20; proof++) {
    other = r;
    other.certificate.proof = proof;
    CHECK(gjk_check_penetration(&a, &b, &other) == (proof == GJK_PROOF_FACET ? GJK_OK : GJK_ERROR_UNPROVEN));
  }
  other = r;
  other.certificate.a[1] = other.certificate.a[0];
  other.certificate.b[1] = other.certificate.b[0];
  CHECK(gjk_check_penetration(&a, &b, &other) == GJK_ERROR_UNPROVEN);  // an edge
  other.certificate.a[1] = 8;
  CHECK(gjk_check_penetration(&a, &b, &other) == GJK_ERROR_UNPROVEN);  // a vertex that there is not
  // Shapes whose cores overlap are within any distance: also one that is smaller than their convex radii.
  const gjk_collider p = placed_at(&soft, 0, 0, 0), q = placed_at(&soft, 0, 0, 2 * ONE - 10);
  CHECK(gjk_penetration(&p, &q, NULL, &workspace, &r) == GJK_OK);
  CHECK(r.depth == 2 * ONE + 10);
  CHECK(gjk_check_penetration(&p, &q, &r) == GJK_OK);
  CHECK(penetrates(&p, &q, &r, 2 * ONE + 9) == GJK_ERROR_UNPROVEN);
  CHECK(penetrates(&p, &q, &r, 3) == GJK_ERROR_UNPROVEN);
  // Proven by the nearest feature of cores that are apart.
  const gjk_collider s = placed_at(&soft, 0, 0, 2 * ONE + 10);
  CHECK(gjk_penetration(&p, &s, NULL, &workspace, &r) == GJK_OK);
  CHECK(r.depth == 2 * ONE - 10);
  CHECK(r.certificate.proof == GJK_PROOF_NEAREST);
  CHECK(gjk_check_penetration(&p, &s, &r) == GJK_OK);
  static const gjk_q16 beside[] = {-1, 0, 2 * ONE - 11, 2 * ONE - 9, 2 * ONE, 2 * ONE + 1};
  for (size_t i = 0; i < sizeof beside / sizeof beside[0]; i++) {
    CHECK(penetrates(&p, &s, &r, beside[i]) == GJK_ERROR_UNPROVEN);
  }
  // Cores much nearer to each other than the convex radii, in a frame of high resolution.
  static const gjk_shape large = GJK_SPHERE(INT32_C(1) << 27);
  const gjk_collider u = placed_at(&large, 0, 0, 0), v = placed_at(&large, 0, 3, 4);
  CHECK(gjk_penetration(&u, &v, NULL, &workspace, &r) == GJK_OK);
  CHECK(r.depth == (INT32_C(1) << 28) - 5);
  CHECK(gjk_check_penetration(&u, &v, &r) == GJK_OK);
  for (int i = 0; i < 29; i++) {
    CHECK(penetrates(&u, &v, &r, r.depth - (INT32_C(1) << i)) == GJK_ERROR_UNPROVEN);
    CHECK(penetrates(&u, &v, &r, r.depth + (INT32_C(1) << i)) == GJK_ERROR_UNPROVEN);
  }
}

static gjk_vec3 moved(gjk_vec3 v, int axis, gjk_q16 by) {
  v.x += axis == 0 ? by : 0;
  v.y += axis == 1 ? by : 0;
  v.z += axis == 2 ? by : 0;
  return v;
}

// Cubes that touch along each axis, up to corner to corner. The plane between them proves it, whatever the length of
// its normal.
static void test_planes(void) {
  static const gjk_shape soft = GJK_ROUNDED_BOX(ONE, ONE, ONE, 10);
  static const gjk_q30 size[] = {1, 5, INT32_MAX};
  const gjk_collider a = placed_at(&cube, 0, 0, 0);
  for (int axis = 0; axis < 3; axis++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const gjk_q16 by = sign * 2 * ONE, x = axis == 0 ? by : 0, y = axis == 1 ? by : 0, z = axis == 2 ? by : 0;
      const gjk_collider b = placed_at(&cube, x, y, z),
                         deep = placed_at(&cube, x - (x > 0) + (x < 0), y - (y > 0) + (y < 0), z - (z > 0) + (z < 0)),
                         apart = placed_at(&cube, x + (x > 0) - (x < 0), y + (y > 0) - (y < 0), z + (z > 0) - (z < 0));
      const gjk_vec3 corner = {axis == 0 ? sign * ONE : ONE, axis == 1 ? sign * ONE : ONE,
                               axis == 2 ? sign * ONE : ONE};
      const gjk_unit3 normal = {axis == 0 ? sign * GJK_Q30_ONE : 0, axis == 1 ? sign * GJK_Q30_ONE : 0,
                                axis == 2 ? sign * GJK_Q30_ONE : 0};
      gjk_penetration_result r = {0};
      r.intersecting = true;
      r.point_a = r.point_b = corner;
      r.normal = normal;
      r.certificate.proof = GJK_PROOF_PLANE;
      r.certificate.count = 1;
      r.certificate.a[0] = (uint16_t)(sign > 0 ? 7 : 7 & ~(1 << axis));
      r.certificate.b[0] = (uint16_t)(sign > 0 ? 7 & ~(1 << axis) : 7);
      gjk_q30 *const along = axis == 0   ? &r.certificate.direction.x
                             : axis == 1 ? &r.certificate.direction.y
                                         : &r.certificate.direction.z;
      CHECK(gjk_check_penetration(&a, &b, &r) == GJK_ERROR_UNPROVEN);
      for (int i = 0; i < 3; i++) {
        *along = sign * size[i];
        CHECK(gjk_check_penetration(&a, &b, &r) == GJK_OK);
        CHECK(penetrates(&a, &b, &r, 1) == GJK_ERROR_UNPROVEN);
        CHECK(penetrates(&a, &b, &r, -1) == GJK_ERROR_UNPROVEN);
        CHECK(gjk_check_penetration(&b, &a, &r) == GJK_ERROR_UNPROVEN);
        CHECK(gjk_check_penetration(&a, &deep, &r) == GJK_ERROR_UNPROVEN);
        CHECK(gjk_check_penetration(&a, &apart, &r) == GJK_ERROR_UNPROVEN);
      }
      *along = INT32_MIN;
      CHECK(gjk_check_penetration(&a, &b, &r) == GJK_ERROR_UNPROVEN);
      // If the cubes have a convex radius and intersect, the plane must also touch both cores.
      const gjk_collider soft_a = placed_at(&soft, 0, 0, 0), soft_b = placed_at(&soft, x, y, z);
      const gjk_collider apart_b = placed_at(&soft, apart.centre.x, apart.centre.y, apart.centre.z);
      *along = sign * ONE;
      r.depth = r.lower = r.upper = 20;
      r.point_a = moved(corner, axis, sign * 10);
      r.point_b = moved(corner, axis, -sign * 10);
      CHECK(gjk_check_penetration(&soft_a, &soft_b, &r) == GJK_OK);
      CHECK(gjk_check_penetration(&soft_a, &apart_b, &r) == GJK_ERROR_UNPROVEN);
    }
  }
}

// A claim proven by the facet of A - B that the top of A and the bottom of B make. A - B lies behind its plane whether
// the shapes overlap or not.
static gjk_penetration_result by_upper_facet(gjk_q16 depth, gjk_q16 point_a, gjk_q16 point_b) {
  static const uint16_t of_a[3] = {2, 6, 3}, of_b[3] = {5, 1, 4};
  gjk_penetration_result r;
  memset(&r, 0, sizeof r);
  r.intersecting = true;
  r.depth = r.lower = r.upper = depth;
  r.normal.y = GJK_Q30_ONE;
  r.point_a.y = point_a;
  r.point_b.y = point_b;
  r.certificate.proof = GJK_PROOF_FACET;
  r.certificate.count = 3;
  memcpy(r.certificate.a, of_a, sizeof of_a);
  memcpy(r.certificate.b, of_b, sizeof of_b);
  return r;
}

// Boxes apart have no depth for the facet to bound. The origin lies beside the facet, or across from it; all else that
// is claimed of the slabs would be right.
static void test_facet_of_boxes_apart(void) {
  static const gjk_shape small = GJK_BOX(1000, 1000, 1000), slab = GJK_BOX(1000, 100, 1000);
  const gjk_collider a = placed_at(&small, 0, 0, 0), beside = placed_at(&small, 2100, 0, 0);
  gjk_penetration_result r = by_upper_facet(2000, 1000, -1000);
  CHECK(gjk_check_penetration(&a, &a, &r) == GJK_OK);
  r.point_a.x = r.point_b.x = 1000;
  CHECK(gjk_check_penetration(&a, &beside, &r) == GJK_ERROR_UNPROVEN);
  const gjk_collider p = placed_at(&slab, 0, 0, 0), across = placed_at(&slab, 0, -300, 0),
                     touching = placed_at(&slab, 0, -200, 0);
  r = by_upper_facet(400, 100, -300);
  CHECK(gjk_check_penetration(&p, &touching, &r) == GJK_OK);  // enough, though not the least
  r = by_upper_facet(500, 100, -400);
  CHECK(gjk_check_penetration(&p, &across, &r) == GJK_ERROR_UNPROVEN);
  // A depth larger than the bounding spheres allow is never the least.
  const gjk_collider below = placed_at(&small, 0, -2000, 0);
  r = by_upper_facet(4000, 1000, -3000);
  CHECK(gjk_check_penetration(&a, &below, &r) == GJK_ERROR_UNPROVEN);
}

// Cores 1 LSB apart whose convex radii overlap. The facet before the origin gives the depth with the wrong sign, and
// points that are off by only 2 LSB.
static void test_facet_before_origin(void) {
  static const uint16_t of_a[3] = {1, 3, 7}, of_b[3] = {6, 4, 0};
  static const gjk_shape soft = GJK_ROUNDED_BOX(1000, 1000, 1000, 10);
  const gjk_collider a = placed_at(&soft, 0, 0, 0), b = placed_at(&soft, 2001, 0, 0),
                     deep = placed_at(&soft, 1999, 0, 0);
  gjk_penetration_result r;
  memset(&r, 0, sizeof r);
  r.intersecting = true;
  r.depth = r.lower = r.upper = 21;
  r.normal.x = GJK_Q30_ONE;
  r.point_a.x = 1010;
  r.point_b.x = 989;
  r.certificate.proof = GJK_PROOF_FACET;
  r.certificate.count = 3;
  memcpy(r.certificate.a, of_a, sizeof of_a);
  memcpy(r.certificate.b, of_b, sizeof of_b);
  CHECK(gjk_check_penetration(&a, &deep, &r) == GJK_OK);
  r.point_b.x = 991;
  CHECK(gjk_check_penetration(&a, &b, &r) == GJK_ERROR_UNPROVEN);
  r.depth = r.lower = r.upper = 19;
  CHECK(gjk_check_penetration(&a, &b, &r) == GJK_ERROR_UNPROVEN);
}

// A coordinate may saturate where the shape reaches the end of the world, and nowhere else.
static void test_cut_off(void) {
  static const gjk_shape ball = GJK_SPHERE(ONE);
  const gjk_q16 ends[2] = {INT32_MAX, INT32_MIN};
  for (int i = 0; i < 2; i++) {
    const gjk_q16 inwards = i == 0 ? -ONE : ONE, end = ends[i] + inwards / 2;
    const gjk_collider a = placed_at(&ball, end, 0, 0), b = placed_at(&ball, end, 3 * ONE, 0);
    const gjk_collider near = placed_at(&ball, end, 0, 0), inner = placed_at(&ball, end + 3 * inwards, 3, 0);
    gjk_distance_result r;
    // The points are not where the shapes leave the world, so they must not saturate.
    CHECK(gjk_distance(&a, &b, NULL, &r) == GJK_OK);
    CHECK(!r.saturated);
    CHECK(gjk_check_distance(&a, &b, &r) == GJK_OK);
    r.point_a.x = r.point_b.x = ends[i];
    r.saturated = true;
    CHECK(gjk_check_distance(&a, &b, &r) == GJK_OK);  // what is at the end is not checked
    r.saturated = false;
    CHECK(gjk_check_distance(&a, &b, &r) == GJK_ERROR_UNPROVEN);
    CHECK(gjk_distance(&inner, &near, NULL, &r) == GJK_OK);
    CHECK(gjk_check_distance(&inner, &near, &r) == GJK_OK);
    r.saturated = true;
    CHECK(gjk_check_distance(&inner, &near, &r) == GJK_ERROR_UNPROVEN);
    r.point_a.x = ends[i];
    CHECK(gjk_check_distance(&inner, &near, &r) == GJK_ERROR_UNPROVEN);
    // Beyond the end of the world the points do saturate.
    const gjk_collider edge = placed_at(&ball, ends[i], 0, 0), over = placed_at(&ball, ends[i] + 3 * inwards, 0, 0);
    CHECK(gjk_distance(&over, &edge, NULL, &r) == GJK_OK);
    CHECK(gjk_check_distance(&over, &edge, &r) == GJK_OK);
  }
}

int main(void) {
  test_origin_on_feature();
  test_enclosing();
  test_directions();
  test_largest();
  test_spheres();
  test_distances();
  test_penetrations();
  test_planes();
  test_facet_of_boxes_apart();
  test_facet_before_origin();
  test_cut_off();
  return check_done("check");
}
