// What is refused in the plane, and what only rare input reaches: missing arguments, shapes at their limits, forged
// certificates of each kind, the largest depths, hulls without area, ends of the world, far pairs with few iterations.
#include "filled.h"
#include "placed2.h"
#include "plane.h"

#define SEED 2015
#define LARGE check_trials_least(20000, 2000)
#define FAR_EFFORTS check_trials_least(20000, 1000)

static unsigned long grown, far_open, enclosing[2];

static const gjk2_pose identity = GJK2_POSE_IDENTITY;

static void check_poses(void) {
  const gjk2_rotation turned = {0, GJK_Q30_ONE}, bent = {GJK_Q30_ONE, GJK_Q30_ONE}, diagonal = {759250125, 759250125};
  const gjk2_vec v = {1, 2};
  const gjk2_pose good = {{5, 6}, {GJK_Q30_ONE, 0}}, wrong = {{5, 6}, {GJK_Q30_ONE, GJK_Q30_ONE}};
  gjk2_rotation r;
  gjk2_vec p;
  gjk2_pose q;
  memset(&r, POISON, sizeof r);
  memset(&p, POISON, sizeof p);
  memset(&q, POISON, sizeof q);
  CHECK(gjk2_rotation_normalize(NULL, &r) == GJK_ERROR_NULL &&
        gjk2_rotation_normalize(&turned, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_compose(&turned, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_compose(&turned, &turned, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_compose(&bent, &turned, &r) == GJK_ERROR_ROTATION);
  CHECK(gjk2_rotation_invert(NULL, &r) == GJK_ERROR_NULL && gjk2_rotation_invert(&turned, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_apply(NULL, &v, &p) == GJK_ERROR_NULL &&
        gjk2_rotation_apply(&turned, NULL, &p) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_apply(&turned, &v, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_apply(NULL, &v, &p) == GJK_ERROR_NULL && gjk2_pose_apply(&good, NULL, &p) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_apply(&good, &v, NULL) == GJK_ERROR_NULL && gjk2_pose_apply(&wrong, &v, &p) == GJK_ERROR_ROTATION);
  CHECK(gjk2_pose_compose(NULL, &good, &q) == GJK_ERROR_NULL && gjk2_pose_compose(&good, NULL, &q) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_compose(&good, &good, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_compose(&wrong, &good, &q) == GJK_ERROR_ROTATION);
  CHECK(gjk2_pose_invert(NULL, &q) == GJK_ERROR_NULL && gjk2_pose_invert(&good, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_invert(&wrong, &q) == GJK_ERROR_ROTATION);
  // -position leaves int32 beyond each end of each axis.
  const gjk2_pose beyond[] = {
      {{INT32_MIN, 0}, {GJK_Q30_ONE, 0}}, {{0, INT32_MIN}, {GJK_Q30_ONE, 0}},
      {{INT32_MAX, INT32_MAX}, diagonal},  // back to (-sqrt(2), 0)
      {{INT32_MIN, INT32_MAX}, diagonal},  // back to (0, -sqrt(2))
      {{INT32_MIN, INT32_MIN}, diagonal}, {{INT32_MAX, INT32_MIN}, diagonal},
  };
  for (unsigned i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
    CHECK_MSG(gjk2_pose_invert(&beyond[i], &q) == GJK_ERROR_RANGE, "%u", i);
  }
  const gjk2_pose far = {{INT32_MAX, 0}, {GJK_Q30_ONE, 0}};
  CHECK(gjk2_pose_compose(&far, &good, &q) == GJK_ERROR_RANGE);
  CHECK(is_untouched(&r, sizeof r) && is_untouched(&p, sizeof p) && is_untouched(&q, sizeof q));
}

static void support_still(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  (void)user;
  (void)direction;
  out->x = 0;
  out->y = 0;
}

static void check_shapes(void) {
  static gjk2_vec wide[3] = {{-2 * GJK2_RADIUS_MAX, 0}, {0, 1}, {1, 0}},
                  high[3] = {{0, -2 * GJK2_RADIUS_MAX}, {1, 0}, {0, 1}};
  static gjk2_vec own[4] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  const gjk2_shape too_wide = GJK2_POLYGON(wide, 3), too_high = GJK2_TRIANGLE(high), good = GJK2_POLYGON(own, 4);
  const gjk2_shape no_class = {NULL, 0, 0, 0, {0, 0}, 0, 0}, box = GJK2_BOX(1, -1), ellipse = GJK2_ELLIPSE(-1, 1);
  const gjk2_shape custom = GJK2_CUSTOM(support_still, NULL, -1);
  gjk2_vec hull[3];
  uint16_t corners = 9;
  gjk2_collider c;
  gjk2_aabb aabb;
  memset(&c, 0, sizeof c);
  const gjk2_collider before = c;
  CHECK(gjk2_collider_init(&c, &too_wide, NULL, 0) == GJK_ERROR_SIZE);
  CHECK(gjk2_collider_init(&c, &too_high, NULL, 0) == GJK_ERROR_SIZE);
  CHECK(gjk2_collider_init(&c, &no_class, NULL, 0) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_init(&c, &box, NULL, 0) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_collider_init(&c, &ellipse, NULL, 0) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_collider_init(&c, &custom, NULL, 0) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_collider_init(&c, &good, own + 1, 4) == GJK_ERROR_OVERLAP);
  CHECK(memcmp(&c, &before, sizeof c) == 0);
  CHECK(gjk2_polygon_order(wide, 3, hull, &corners) == GJK_ERROR_SIZE && corners == 9);
  CHECK(gjk2_polygon_order(high, 3, hull, &corners) == GJK_ERROR_SIZE && corners == 9);
  // A point alone has a pose of its own.
  const gjk2_shape point = GJK2_POINT;
  const gjk2_pose bent = {{0, 0}, {GJK_Q30_ONE, GJK_Q30_ONE}};
  gjk2_collider alone;
  CHECK(gjk2_collider_init(&alone, &point, NULL, 0) == GJK_OK);
  CHECK(gjk2_collider_pose(&alone, &bent) == GJK_ERROR_ROTATION);
  c = placed2(&good, 0, 0);
  const gjk2_vec out = {0, INT32_MAX};
  CHECK(gjk2_collider_pose(NULL, &identity) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_move(NULL, &out) == GJK_ERROR_NULL && gjk2_collider_move(&c, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_collider_move(&c, &out) == GJK_ERROR_RANGE && c.centre.y == 4);
  memset(&aabb, POISON, sizeof aabb);
  CHECK(gjk2_collider_aabb(NULL, &aabb) == GJK_ERROR_NULL && gjk2_collider_aabb(&c, NULL) == GJK_ERROR_NULL);
  CHECK(is_untouched(&aabb, sizeof aabb));
}

// A custom shape without a size is a point.
static void check_custom_point(void) {
  const gjk2_shape still = GJK2_CUSTOM(support_still, NULL, 0), ball = GJK2_CIRCLE(50);
  gjk2_collider a, b;
  gjk2_distance_result out;
  a = placed2(&still, 0, 0);
  b = placed2(&ball, 300, 400);
  CHECK(gjk2_distance(&a, &b, NULL, &out) == GJK_OK);
  CHECK_MSG(out.distance >= 448 && out.distance <= 452, "%d", out.distance);
}

static void check_queries(void) {
  const gjk2_shape ball = GJK2_CIRCLE(10);
  const gjk2_effort effort = {0, 0};
  gjk2_collider c, raw = {0};
  gjk2_decision yes;
  gjk2_distance_result line;
  gjk2_manifold manifold;
  c = placed2(&ball, 0, 0);
  memset(&line, POISON, sizeof line);
  memset(&yes, POISON, sizeof yes);
  memset(&manifold, POISON, sizeof manifold);
  CHECK(gjk2_distance_until(&c, &raw, &effort, NULL, &line) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_distance_until(&c, &c, &effort, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_check_decision(&c, &raw, 0, &yes) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_check_decision(&c, &c, 0, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_contacts(&c, &raw, 0, 2, NULL, &manifold) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_contacts(&c, &c, -1, 2, NULL, &manifold) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_contacts(&c, &c, 0, 0, NULL, &manifold) == GJK_ERROR_RANGE);
  CHECK(gjk2_contacts(&c, &c, 0, 3, NULL, &manifold) == GJK_ERROR_RANGE);
  CHECK(is_untouched(&line, sizeof line) && is_untouched(&yes, sizeof yes) && is_untouched(&manifold, sizeof manifold));
  // A limit that is not reached is none.
  gjk2_collider other;
  gjk2_within_result within;
  const gjk2_effort many = {250, 0};
  other = placed2(&ball, 100, 0);
  CHECK(gjk2_distance_until(&c, &other, &many, NULL, &line) == GJK_OK && line.distance == 80);
  CHECK(gjk2_within_until(&c, &other, 80, 250, NULL, &within) == GJK_OK && within.answer == GJK2_ANSWER_YES);
  CHECK(gjk2_within_until(&c, &other, 79, 250, NULL, &within) == GJK_OK && within.answer == GJK2_ANSWER_NO);
}

// The largest circles, 3 units apart, their centres more than 8192: the nearest points are the one contact.
static void check_wide_contacts(void) {
  const gjk2_shape large = GJK2_CIRCLE(GJK2_RADIUS_MAX);
  const int32_t apart = 2 * GJK2_RADIUS_MAX + GJK_Q16(3.0);
  gjk2_collider a, b;
  gjk2_manifold m;
  for (int side = 0; side < 4; side++) {
    const int32_t by = side % 2 == 0 ? apart : -apart;
    a = placed2(&large, 7, 8);
    b = placed2(&large, 7 + (side < 2 ? by : 0), 8 + (side < 2 ? 0 : by));
    CHECK(gjk2_contacts(&a, &b, GJK_Q16(4.0), 2, NULL, &m) == GJK_OK);
    CHECK(m.count == 1 && m.contact[0].distance == GJK_Q16(3.0) && m.contact[0].id == 0);
    CHECK(m.feature_a == 0 && m.feature_b == 0);
    CHECK(gjk2_contacts(&a, &b, GJK_Q16(2.0), 2, NULL, &m) == GJK_OK && m.count == 0);
  }
}

// Two boxes 1,000 LSB apart along x: every part of the answer is looked at.
static void check_forged_distances(void) {
  const gjk2_shape box = GJK2_BOX(5000, 3000), rounded = GJK2_ROUNDED_BOX(5000, 3000, 600);
  gjk2_collider a, b;
  gjk2_distance_result right, forged;
  a = placed2(&box, 0, 0);
  b = placed2(&box, 11000, 100);
  CHECK(gjk2_distance(&a, &b, NULL, &right) == GJK_OK && right.distance == 1000);
  CHECK(gjk2_check_distance(&a, &b, &right) == GJK_OK);
  const int32_t far = INT32_C(1) << 30, most = GJK_Q30_ONE + 5;
  for (int i = 0; i < 11; i++) {
    forged = right;
    switch (i) {
      case 0: forged.point_a.x = -far; break;
      case 1: forged.point_a.x = far; break;
      case 2: forged.point_b.y = -far; break;
      case 3: forged.point_b.y = far; break;
      case 4: forged.normal.x = most; break;
      case 5: forged.normal.x = -most; break;
      case 6: forged.normal.y = most; break;
      case 7: forged.normal.y = -most; break;
      case 8:  // each within 1 LSB of its shape, but together 2 LSB too near
        forged.point_a.x++;
        forged.point_b.x--;
        break;
      case 9:
        forged.point_a.x--;
        forged.point_b.x += 2;
        break;
      default: forged.saturated = true; break;
    }
    CHECK_MSG(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN, "%d", i);
  }
  // Cores that are nearer than the convex radii, said to be apart, by a feature that is the nearest.
  a = placed2(&rounded, 0, 0);
  b = placed2(&rounded, 11000, 100);
  gjk2_distance_result together;
  CHECK(gjk2_distance(&a, &b, NULL, &together) == GJK_OK && together.intersecting);
  CHECK(gjk2_check_distance(&a, &b, &together) == GJK_OK);
  forged = together;
  forged.saturated = true;
  CHECK(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
  forged = right;
  forged.distance = forged.lower = forged.upper = 0;
  CHECK(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
  forged.distance = forged.lower = forged.upper = -200;
  forged.point_a.x = forged.point_b.x = 5500;
  CHECK(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
  // A direction proves nothing about distances that leave int32 with the radii.
  gjk2_decision decision = {0};
  decision.certificate.proof = GJK2_PROOF_DIRECTION;
  decision.certificate.direction.x = 1;
  CHECK(gjk2_check_decision(&a, &b, INT32_MAX, &decision) == GJK_ERROR_UNPROVEN);
}

// Apart, a depth's answer is that, what it took and the certificate.
static void check_no_depth(void) {
  const gjk2_shape box = GJK2_BOX(5000, 3000), circle = GJK2_CIRCLE(3000), ellipse = GJK2_ELLIPSE(4000, 3000);
  const gjk2_shape *shapes[] = {&box, &circle, &ellipse};
  for (unsigned i = 0; i < 9; i++) {
    for (gjk_q16 x = 6000; x < 12000; x += 100) {  // bounding circles that meet, and such that do not
      const gjk2_collider a = placed2(shapes[i / 3], 0, 0), b = placed2(shapes[i % 3], x, 700);
      gjk2_penetration_result out;
      gjk2_distance_result distance;
      memset(&out, 0xA5, sizeof out);
      CHECK(gjk2_distance(&a, &b, NULL, &distance) == GJK_OK && gjk2_penetration(&a, &b, NULL, &out) == GJK_OK);
      if (distance.distance > 8) {
        CHECK(!out.intersecting && out.iterations <= GJK_ITERATIONS_MAX);
        CHECK(out.certificate.proof == GJK2_PROOF_NONE || gjk2_check_penetration(&a, &b, &out) != GJK_ERROR_UNPROVEN);
      }
    }
  }
}

static void check_forged_depths(void) {
  const gjk2_shape box = GJK2_BOX(5000, 3000), rounded = GJK2_ROUNDED_BOX(5000, 3000, 600), point = GJK2_POINT;
  const gjk2_shape segment = GJK2_SEGMENT(1000);
  gjk2_collider a, b;
  gjk2_penetration_result right = {0}, forged;
  a = placed2(&box, 0, 0);
  b = placed2(&box, 9000, 100);
  CHECK(gjk2_penetration(&a, &b, NULL, &right) == GJK_OK && right.depth == 1000);
  CHECK(gjk2_check_penetration(&a, &b, &right) == GJK_OK);
  forged = right;
  forged.upper++;
  CHECK(gjk2_check_penetration(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
  // A point that slides along its face is as deep, but no longer opposite the other one.
  for (gjk_q16 slid = -5; slid <= 5; slid++) {
    forged = right;
    forged.point_a.y += slid;
    CHECK(gjk2_check_penetration(&a, &b, &forged) == (abs(slid) <= 3 ? GJK_OK : GJK_ERROR_UNPROVEN));
  }
  // Every pair of vertices as the edge, with the depth of each: that of the lowest alone is right.
  unsigned accepted = 0;
  for (uint16_t i = 0; i < 256; i++) {
    const int32_t depths[] = {1000, 5900, 6100, 19000};
    for (unsigned k = 0; k < 4; k++) {
      forged = right;
      forged.certificate.a[0] = (uint16_t)(i & 3);
      forged.certificate.b[0] = (uint16_t)(i >> 2 & 3);
      forged.certificate.a[1] = (uint16_t)(i >> 4 & 3);
      forged.certificate.b[1] = (uint16_t)(i >> 6);
      forged.depth = forged.lower = forged.upper = depths[k];
      const gjk_status status = gjk2_check_penetration(&a, &b, &forged);
      CHECK(status == GJK_ERROR_UNPROVEN || (status == GJK_OK && depths[k] == 1000));
      accepted += status == GJK_OK;
    }
  }
  CHECK(accepted >= 1 && accepted <= 16);
  // Far apart, said to overlap; near, but beyond the radii, by a feature that is the nearest.
  gjk2_collider c, d;
  gjk2_distance_result gap;
  c = placed2(&rounded, 100000, 0);
  CHECK(gjk2_check_penetration(&a, &c, &right) == GJK_ERROR_UNPROVEN);
  c = placed2(&rounded, 0, 0);
  d = placed2(&rounded, 11300, 100);
  CHECK(gjk2_distance(&c, &d, NULL, &gap) == GJK_OK && gap.distance == 100);
  forged = right;
  forged.certificate = gap.certificate;
  forged.depth = forged.lower = forged.upper = 0;
  CHECK(gjk2_check_penetration(&c, &d, &forged) == GJK_ERROR_UNPROVEN);
  // Two points in the same place: any line through them, but no direction that is none or too long.
  c = placed2(&point, 5, 5);
  CHECK(gjk2_penetration(&c, &c, NULL, &right) == GJK_OK && right.certificate.proof == GJK2_PROOF_LINE);
  CHECK(gjk2_check_penetration(&c, &c, &right) == GJK_OK);
  for (int i = 0; i < 4; i++) {
    const gjk2_vec directions[4] = {{0, 0}, {INT32_MAX, 0}, {0, INT32_MIN + 1}, {0, -1}};
    forged = right;
    forged.certificate.direction = directions[i];
    CHECK(gjk2_check_penetration(&c, &c, &forged) == GJK_ERROR_UNPROVEN);  // nor another normal's
  }
  // Boxes that share a corner: a line through it that cuts them.
  a = placed2(&box, 0, 0);
  b = placed2(&box, 10000, 6000);
  CHECK(gjk2_penetration(&a, &b, NULL, &right) == GJK_OK && right.depth == 0);
  accepted = 0;
  for (uint16_t i = 0; i < 16; i++) {
    const gjk2_vec directions[2] = {{1, 0}, {1, -1}};
    for (unsigned k = 0; k < 2; k++) {
      forged = right;
      forged.certificate.proof = GJK2_PROOF_LINE;
      forged.certificate.count = 1;
      forged.certificate.a[0] = (uint16_t)(i & 3);
      forged.certificate.b[0] = (uint16_t)(i >> 2);
      forged.certificate.direction = directions[k];
      forged.normal.x = k == 0 ? GJK_Q30_ONE : 759250125;
      forged.normal.y = k == 0 ? 0 : -759250125;
      const gjk_status status = gjk2_check_penetration(&a, &b, &forged);
      CHECK(status == GJK_ERROR_UNPROVEN || (status == GJK_OK && k == 0));
      accepted += status == GJK_OK;
    }
  }
  CHECK(accepted == 1);
  // Segments in a line but apart, in both orders: an edge of height 0 that the origin is beyond.
  for (int side = -1; side <= 1; side += 2) {
    a = placed2(&segment, 0, 0);
    b = placed2(&segment, side * 2500, 0);
    CHECK(gjk2_penetration(&a, &b, NULL, &right) == GJK_OK && !right.intersecting);
    CHECK(gjk2_check_penetration(&a, &b, &right) == GJK_OK);
    CHECK(gjk2_signed_distance(&a, &b, NULL, &gap) == GJK_OK && gap.distance == 500);
    for (uint16_t i = 0; i < 16; i++) {
      memset(&forged, 0, sizeof forged);
      forged.intersecting = true;
      forged.normal.y = GJK_Q30_ONE;
      forged.certificate.proof = GJK2_PROOF_EDGE;
      forged.certificate.count = 2;
      forged.certificate.a[0] = (uint16_t)(i & 1);
      forged.certificate.b[0] = (uint16_t)(i >> 1 & 1);
      forged.certificate.a[1] = (uint16_t)(i >> 2 & 1);
      forged.certificate.b[1] = (uint16_t)(i >> 3);
      CHECK(gjk2_check_penetration(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
    }
  }
}

// Every triple of vertices of a box less a point: it proves an overlap just when the triangle holds the origin.
static void check_enclosing(void) {
  const gjk2_shape box = GJK2_BOX(10, 10), point = GJK2_POINT;
  gjk2_collider a, b;
  plane_point v[PLANE_VERTICES];
  const plane_point origin = {0, 0};
  a = placed2(&box, 0, 0);
  for (int at = 0; at < 4; at++) {
    const gjk2_vec places[4] = {{0, 10}, {10, 10}, {3, 2}, {-10, 0}};
    b = placed2(&point, places[at].x, places[at].y);
    CHECK(plane_vertices(&a, v) == 4);
    for (int i = 0; i < 64; i++) {
      const int of[3] = {i & 3, i >> 2 & 3, i >> 4};
      plane_point w[3];
      gjk2_decision decision = {0};
      decision.yes = true;
      decision.certificate.proof = GJK2_PROOF_ENCLOSING;
      decision.certificate.count = 3;
      for (int k = 0; k < 3; k++) {
        decision.certificate.a[k] = (uint16_t)of[k];
        w[k].x = v[of[k]].x - places[at].x;
        w[k].y = v[of[k]].y - places[at].y;
      }
      bool holds = false;
      int left = 0, right = 0;
      for (int k = 0; k < 3; k++) {
        const plane_point p = w[k], q = w[(k + 1) % 3];
        const int64_t side = plane_cross(p, q, origin);
        left += side > 0;
        right += side < 0;
        holds = holds || (side == 0 && p.x * q.x + p.y * q.y <= 0);
      }
      holds = holds || left == 3 || right == 3;
      const gjk_status status = gjk2_check_decision(&a, &b, 0, &decision);
      CHECK_MSG((status == GJK_OK) == holds, "place %d, vertices %d", at, i);
      enclosing[holds]++;
    }
  }
}

// A feature of two pairs that comes near enough proves it in either order.
static void check_near_both_ways(void) {
  const gjk2_shape box = GJK2_BOX(5000, 3000);
  gjk2_collider a, b;
  unsigned proven = 0;
  a = placed2(&box, 0, 0);
  for (int side = -1; side <= 1; side += 2) {
    b = placed2(&box, side * 11000, 100);
    for (uint16_t i = 0; i < 256; i++) {
      gjk2_decision forth = {0}, back;
      forth.yes = true;
      forth.certificate.proof = GJK2_PROOF_NEAR;
      forth.certificate.count = 2;
      forth.certificate.a[0] = i & 3;
      forth.certificate.b[0] = i >> 2 & 3;
      forth.certificate.a[1] = i >> 4 & 3;
      forth.certificate.b[1] = (uint16_t)(i >> 6);
      back = forth;
      for (int k = 0; k < 2; k++) {
        back.certificate.a[k] = forth.certificate.a[1 - k];
        back.certificate.b[k] = forth.certificate.b[1 - k];
      }
      const gjk_status status = gjk2_check_decision(&a, &b, 1000, &forth);
      CHECK(gjk2_check_decision(&a, &b, 1000, &back) == status);
      CHECK(gjk2_check_decision(&a, &b, 999, &forth) == GJK_ERROR_UNPROVEN);
      proven += status == GJK_OK;
    }
  }
  CHECK(proven >= 4);
}

// Shapes that reach beyond the end of the world: a point there is said to be saturated, and only there.
static void check_saturated(void) {
  const gjk2_shape segment = GJK2_SEGMENT(1000);
  gjk2_collider a;
  gjk2_pose tilted = {{INT32_MAX - 10, 5000}, {GJK_Q30_ONE, 0}};
  gjk2_distance_result right, forged;
  a = placed2(&segment, INT32_MAX - 10, 0);
  CHECK(gjk2_rotation_from_angle(GJK_ANGLE(-0.3), &tilted.rotation) == GJK_OK);
  const gjk2_collider b = posed2(&segment, &tilted);
  CHECK(gjk2_distance(&a, &b, NULL, &right) == GJK_OK && right.saturated);
  CHECK(right.point_a.x == INT32_MAX && right.point_b.x == INT32_MAX);
  CHECK(gjk2_check_distance(&a, &b, &right) == GJK_OK);
  forged = right;
  forged.point_a.x -= 5000;
  CHECK(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
  forged = right;
  forged.point_b.x -= 5000;
  CHECK(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
  forged.point_a.x -= 5000;
  CHECK(gjk2_check_distance(&a, &b, &forged) == GJK_ERROR_UNPROVEN);
}

// Ellipses without a size, in the same place: A - B is a point, so is every chord.
static void check_curved_points(void) {
  const gjk2_shape nothing = GJK2_ELLIPSE(0, 0), rounded = GJK2_ROUNDED_ELLIPSE(0, 0, 100);
  gjk2_collider a, b;
  gjk2_penetration_result out;
  a = placed2(&nothing, 3, 4);
  CHECK(gjk2_penetration(&a, &a, NULL, &out) == GJK_OK && out.intersecting);
  CHECK(out.lower == 0 && out.depth <= 2 && out.upper <= 4);
  b = placed2(&rounded, 3, 4);
  CHECK(gjk2_penetration(&a, &b, NULL, &out) == GJK_OK && out.intersecting);
  CHECK(out.lower <= 100 && out.upper >= 100 && out.depth >= 98 && out.depth <= 102);
}

// The largest overlaps at any angle: there the rounded normal may have to grow until the move parts the shapes.
static void check_large_depths(random_state *r) {
  static plane_body pair[2];
  static plane_truth truth;
  const gjk2_shape box = GJK2_BOX(GJK_Q16(2890.0), GJK_Q16(2890.0));
  gjk2_penetration_result out, forged;
  gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  for (int i = 0; i < 2; i++) {
    pair[i].shape = box;
    pair[i].pose.position = plane_random_vec(r, GJK_Q16(40.0));
    CHECK(gjk2_rotation_from_angle(random_range(r, -205887, 205887), &pair[i].pose.rotation) == GJK_OK);
    plane_place(&pair[i], false);
  }
  plane_truth_of(a, b, &truth);
  CHECK(gjk2_penetration(a, b, NULL, &out) == GJK_OK && out.intersecting);
  CHECK(plane_compare_depth(&truth, out.depth) <= 0 && plane_compare_depth(&truth, out.depth - 1) > 0);
  CHECK(gjk2_check_penetration(a, b, &out) == GJK_OK);
  // A normal that is a few LSB shorter may still be right to 2^-28, but the move no longer parts the shapes.
  forged = out;
  forged.normal.x -= forged.normal.x > 0 ? 3 : -3;
  forged.normal.y -= forged.normal.y > 0 ? 3 : -3;
  const gjk_status status = gjk2_check_penetration(a, b, &forged);
  CHECK(status == GJK_ERROR_UNPROVEN || status == GJK_OK);
  grown += status == GJK_ERROR_UNPROVEN;
}

// Far apart, with few iterations: the bounds hold the distance.
static void check_far_efforts(random_state *r) {
  static plane_body pair[2];
  const int32_t ends[2] = {INT32_MIN + 70000000, INT32_MAX - 70000000};
  for (int i = 0; i < 2; i++) {
    plane_random_shape(r, INT32_C(1) << random_below(r, 26), &pair[i]);
    pair[i].pose.rotation = plane_random_rotation(r);
    pair[i].pose.position.x = random_below(r, 2) == 0 ? ends[i] : random_range(r, ends[0] / 2, ends[1] / 2);
    pair[i].pose.position.y = random_below(r, 2) == 0 ? ends[1 - i] : random_range(r, ends[0] / 2, ends[1] / 2);
    plane_place(&pair[i], random_below(r, 2) == 0);
  }
  const gjk2_collider *a = &pair[0].collider, *b = &pair[1].collider;
  gjk2_distance_result full, part;
  gjk2_within_result within;
  CHECK(gjk2_distance(a, b, NULL, &full) == GJK_OK);
  for (uint8_t n = 1; n <= 4; n++) {
    const gjk2_effort effort = {n < 4 ? n : 0, n < 4 ? 0 : GJK_Q16(1.0)};
    CHECK(gjk2_distance_until(a, b, &effort, NULL, &part) == GJK_OK);
    // Bounds and distance are good to 2^-28 of the distance.
    const int32_t slack = full.distance / (1 << 28) + 16;
    CHECK_MSG(part.lower <= full.distance && part.upper >= full.distance - slack, "%d to %d: %d", part.lower,
              part.upper, full.distance);
    CHECK(n == 4 || part.iterations <= n);
    far_open += part.lower != part.upper;
    const gjk_q16 asked = random_range(r, 0, INT32_MAX);
    CHECK(gjk2_within_until(a, b, asked, n, NULL, &within) == GJK_OK);
    const int64_t off = (int64_t)asked - full.distance;
    CHECK(within.answer == GJK2_ANSWER_OPEN || (within.answer == GJK2_ANSWER_YES) == (off >= 0) ||
          (off <= slack && off >= -slack) || full.distance == GJK2_DISTANCE_MAX);
  }
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  check_poses();
  check_shapes();
  check_queries();
  check_wide_contacts();
  check_forged_distances();
  check_no_depth();
  check_forged_depths();
  check_custom_point();
  check_enclosing();
  check_near_both_ways();
  check_saturated();
  check_curved_points();
  for (unsigned long i = 0; i < LARGE; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    check_large_depths(&r);
  }
  for (unsigned long i = 0; i < FAR_EFFORTS; i++) {
    random_state r = random_seed(~(seed + i));
    check_trial(i, NULL, NULL);
    check_far_efforts(&r);
  }
  printf("triangles around the origin %lu of %lu; shorter normals refused %lu; far and open %lu\n", enclosing[1],
         enclosing[0] + enclosing[1], grown, far_open);
  CHECK(enclosing[0] > 20 && enclosing[1] > 20 && grown > LARGE / 10 && far_open > FAR_EFFORTS / 10);
  return check_done("plane_refusals");
}
