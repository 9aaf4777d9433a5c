// Times of impact that analysis gives, grazing ones, and statuses.
#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk/cast.h"
#include "gjk/distance.h"
#include "gjk/impact.h"
#include "gjk/pose.h"
#include "placed.h"

#define TOLERANCE GJK_IMPACT_TOLERANCE_MIN
#define UNIT 65536.0
#define PI 3.14159265358979323846

static const gjk_motion rest = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};

static gjk_vec3 vec(double x, double y, double z) {
  return (gjk_vec3){(gjk_q16)lround(x * UNIT), (gjk_q16)lround(y * UNIT), (gjk_q16)lround(z * UNIT)};
}

static gjk_motion standing(double x, double y, double z) {
  gjk_motion m = rest;
  m.from.position = m.to.position = vec(x, y, z);
  return m;
}

static gjk_impact_result impact(const gjk_shape *a, const gjk_motion *ma, const gjk_shape *b, const gjk_motion *mb,
                                gjk_q16 margin) {
  gjk_collider ca = {0}, cb = {0};
  gjk_impact_result r = {0};
  const gjk_impact_setup setup = {margin, TOLERANCE, 0};
  CHECK(gjk_collider_init(&ca, a, NULL, 0) == GJK_OK && gjk_collider_init(&cb, b, NULL, 0) == GJK_OK);
  CHECK(gjk_time_of_impact(&ca, ma, &cb, mb, &setup, &r) == GJK_OK);
  gjk_impact_result turned;
  CHECK(gjk_time_of_impact(&cb, mb, &ca, ma, &setup, &turned) == GJK_OK);
  CHECK(turned.hit == r.hit && turned.overlap == r.overlap);
  return r;
}

// The hit is before the real contact by as much as lets the shapes be within margin and tolerance, at this speed of
// the contact point per fraction 1, LSB; and the reported fraction is one before which nothing touches.
static void check_hit(const gjk_impact_result *r, double fraction, double speed, unsigned most) {
  const double lower = (double)r->lower / GJK_Q30_ONE;
  CHECK_MSG(r->hit && !r->overlap && lower <= fraction && lower >= fraction - (TOLERANCE + 2) / speed,
            "lower %.9f of %.9f, %d", lower, fraction, r->hit);
  CHECK_MSG(r->iterations <= most, "%d iterations", r->iterations);
  CHECK(r->lower == r->upper && r->distance > 0 && r->distance <= TOLERANCE);
}

static void check_balls(void) {
  const gjk_shape big = GJK_SPHERE(GJK_Q16(1.0)), small = GJK_SPHERE(GJK_Q16(0.25));
  gjk_motion m = standing(-5, 0, 0);
  m.to.position = vec(5, 0, 0);
  gjk_impact_result r = impact(&big, &rest, &small, &m, 0);
  check_hit(&r, 0.375, 10 * UNIT, 3);
  m.spin = vec(0, 0, 31415.9);  // 5,000 turns: a ball does not mind
  r = impact(&big, &rest, &small, &m, 0);
  check_hit(&r, 0.375, 10 * UNIT, 3);
  gjk_motion up = standing(0, 0, -5);  // along one axis alone
  up.to.position = vec(0, 0, 5);
  r = impact(&big, &rest, &small, &up, 0);
  check_hit(&r, 0.375, 10 * UNIT, 3);
  m.to.position = m.from.position;
  r = impact(&big, &rest, &small, &m, 0);
  CHECK(!r.hit && r.lower == GJK_Q30_ONE && r.upper == GJK_Q30_ONE);
}

// A rod from its middle along z turns about x, so that its upper end moves to -y.
static void check_rod_to_ball(void) {
  const gjk_shape rod = GJK_SEGMENT(GJK_Q16(4.0)), ball = GJK_SPHERE(GJK_Q16(0.125));
  for (int i = 1; i <= 7; i++) {
    const double along = 0.5 * i, angle = 2.0;
    gjk_motion turning = rest;
    turning.spin = vec(3.0, 0, 0);
    const gjk_motion m = standing(0, -along * sin(angle), along * cos(angle));
    const gjk_impact_result r = impact(&rod, &turning, &ball, &m, 0);
    check_hit(&r, (angle - asin(0.125 / along)) / 3.0, 3.0 * along * UNIT * 0.99, 6);
  }
}

// The same rod above a floor at z = -h: its lower end comes down from the side.
static void check_rod_to_floor(void) {
  const gjk_shape rod = GJK_CAPSULE(GJK_Q16(0.0625), GJK_Q16(4.0)),
                  floor = GJK_BOX(GJK_Q16(50), GJK_Q16(50), GJK_Q16(1));
  for (int i = 0; i < 8; i++) {
    const double height = 0.25 + 0.45 * i;
    gjk_motion turning = rest;
    const gjk_quat level = {GJK_Q30(0.70710678), 0, 0, GJK_Q30(0.70710678)};  // along y
    turning.from.rotation = level;
    turning.spin = vec(1.5, 0, 0);
    const gjk_motion m = standing(0, 0, -1.0 - 0.0625 - height);
    const gjk_impact_result r = impact(&rod, &turning, &floor, &m, 0);
    const double angle = asin(height / 4.0);
    check_hit(&r, angle / 1.5, 1.5 * 4.0 * cos(angle) * UNIT * 0.99, 6);
  }
}

// A cube turns about z next to a wall at x = d: its corner reaches a (cos t + sin t).
static void check_corner(void) {
  const gjk_shape cube = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1)),
                  wall = GJK_BOX(GJK_Q16(1), GJK_Q16(9), GJK_Q16(9));
  for (int i = 1; i < 8; i++) {
    const double d = 1.0 + 0.05 * i, angle = asin(d / sqrt(2.0)) - PI / 4;
    gjk_motion turning = rest;
    turning.spin = vec(0, 0, PI * 6);
    const gjk_motion m = standing(1 + d, 0, 0);
    const gjk_impact_result r = impact(&cube, &turning, &wall, &m, 0);
    check_hit(&r, angle / (PI * 6), PI * 6 * (cos(angle) - sin(angle)) * UNIT * 0.99, 6);
  }
  // Farther than the corner reaches: no impact in 3 turns, nor in 300.
  gjk_motion turning = rest;
  const gjk_motion m = standing(1 + sqrt(2.0) + 0.001, 0, 0);
  turning.spin = vec(0, 0, PI * 6);
  gjk_impact_result r = impact(&cube, &turning, &wall, &m, 0);
  CHECK(!r.hit && r.lower == GJK_Q30_ONE);
  turning.spin = vec(0, 0, PI * 600);
  const gjk_motion aside = standing(1 + sqrt(3.0) + 0.001, 0, 0);
  r = impact(&cube, &turning, &wall, &aside, 0);
  CHECK(!r.hit && r.lower == GJK_Q30_ONE);
}

// A ball flies by a box at a gap of a few LSB, on either side of touching: what touches is a hit, what stays farther away
// than the tolerance is none.
static void check_grazing(void) {
  const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.5)), box = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
  unsigned hits = 0, misses = 0;
  for (gjk_q16 gap = -20; gap <= 40; gap++) {
    for (int turn = 0; turn < 2; turn++) {
      gjk_motion m = standing(-3, 1.5, 0.3), turning = rest;
      m.from.position.y += gap;
      m.to.position = m.from.position;
      m.to.position.x = -m.from.position.x;
      turning.spin.x = turn == 0 ? 0 : 0;
      m.spin.z = turn == 0 ? 0 : GJK_Q16(7.0);
      const gjk_impact_result r = impact(&box, &turning, &ball, &m, 0);
      CHECK_MSG(gap > 0 || r.hit, "gap %d", (int)gap);
      CHECK_MSG(gap <= TOLERANCE || !r.hit, "gap %d", (int)gap);
      hits += r.hit;
      misses += !r.hit;
    }
  }
  CHECK(hits > 30 && misses > 30);
}

// A margin: the shapes stop that far from each other.
static void check_margin(void) {
  const gjk_shape rod = GJK_SEGMENT(GJK_Q16(4.0)), ball = GJK_SPHERE(GJK_Q16(0.125));
  gjk_motion turning = rest;
  turning.spin = vec(3.0, 0, 0);
  const gjk_motion m = standing(0, -2 * sin(2.0), 2 * cos(2.0));
  const gjk_q16 margin = GJK_Q16(0.25);
  const gjk_impact_result r = impact(&rod, &turning, &ball, &m, margin);
  const double lower = (double)r.lower / GJK_Q30_ONE, real = (2.0 - asin(0.375 / 2)) / 3.0;
  CHECK(r.hit && lower <= real && lower >= real - (TOLERANCE + 2) / (3.0 * 1.9 * UNIT));
  CHECK(r.distance > margin && r.distance <= margin + TOLERANCE);
}

// Without any rotation a cast gives the same contact.
static void check_cast(void) {
  const gjk_shape a = GJK_BOX(GJK_Q16(1), GJK_Q16(0.5), GJK_Q16(0.25)), b = GJK_CAPSULE(GJK_Q16(0.25), GJK_Q16(1));
  unsigned hits = 0;
  for (int i = -12; i <= 12; i++) {
    gjk_motion ma = rest, mb = standing(-4, 0.125 * i, 0.3);
    const gjk_quat tilted = {GJK_Q30(0.36), GJK_Q30(0.48), GJK_Q30(0.0), GJK_Q30(0.8)};
    ma.from.rotation = ma.to.rotation = tilted;
    ma.to.position = vec(0.5, 1, 0);
    mb.to.position = vec(4, 0.2, -0.1);
    const gjk_impact_result r = impact(&a, &ma, &b, &mb, 0);
    const gjk_collider ca = posed(&a, &ma.from), cb = posed(&b, &mb.from);
    const gjk_cast_path path = {&ma.to.position, &mb.to.position, 0};
    gjk_cast_result cast;
    CHECK(gjk_cast(&ca, &cb, &path, &cast) == GJK_OK);
    CHECK(!cast.hit || (r.hit && r.lower <= cast.fraction));
    CHECK(cast.hit || !r.hit || r.distance <= TOLERANCE);
    hits += cast.hit;
  }
  CHECK(hits > 5 && hits < 25);
}

// Bodies at one place, whose spheres meet from the start on: an edge 2 units from the place turns about it, and the block
// there is half as thick as it is near.
static void check_same_place(void) {
  const gjk_vec3 ends[2] = {vec(2, 0, -1), vec(2, 0, 1)};
  const gjk_shape edge = GJK_HULL(ends, 2), block = GJK_BOX(GJK_Q16(0.25), GJK_Q16(3.0), GJK_Q16(0.25)),
                  pillar = GJK_BOX(GJK_Q16(1.25), GJK_Q16(1.25), GJK_Q16(1.25));
  gjk_motion turning = rest;
  turning.spin = vec(0, 0, 2.5);
  const double angle = acos(0.125);
  gjk_impact_result r = impact(&edge, &turning, &block, &rest, 0);
  check_hit(&r, angle / 2.5, 2.5 * 2 * sin(angle) * UNIT * 0.99, 8);
  r = impact(&edge, &turning, &pillar, &rest, 0);  // its corners are sqrt(2) 1.25 away
  CHECK(!r.hit && r.lower == GJK_Q30_ONE);
}

// The same of shapes farther from their positions than levers are measured: an edge 17,000 units away comes round to a box.
// And two that lie away from each other, farther than Q16.16 tells, which come nearer by an LSB.
static void check_far_arms(void) {
  const gjk_vec3 ends[2] = {vec(17000, 0, -1), vec(17000, 0, 1)}, left[1] = {vec(-11000, 0, 0)},
                 right[1] = {vec(11000, 0, 0)};
  const gjk_shape edge = GJK_HULL(ends, 2), box = GJK_BOX(GJK_Q16(1.0), GJK_Q16(1.0), GJK_Q16(1.0)),
                  west = GJK_HULL(left, 1), east = GJK_HULL(right, 1);
  gjk_motion turning = rest, beside = standing(17000, 10, 0), from = standing(-10000, 0, 0), to = standing(10000, 0, 0);
  const gjk_impact_setup setup = {0, GJK_Q16(0.125), 0};
  gjk_collider a = {0}, b = {0};
  gjk_impact_result r;
  turning.spin.z = GJK_Q16(0.001);
  CHECK(gjk_collider_init(&a, &edge, NULL, 0) == GJK_OK && gjk_collider_init(&b, &box, NULL, 0) == GJK_OK);
  CHECK(gjk_time_of_impact(&a, &turning, &b, &beside, &setup, &r) == GJK_OK);
  const double way = turning.spin.z / UNIT, fraction = asin(9.0 / 17000) / way, lower = (double)r.lower / GJK_Q30_ONE;
  CHECK_MSG(r.hit && lower <= fraction && lower >= fraction - 0.126 / (way * 16999), "lower %.9f of %.9f", lower,
            fraction);
  CHECK(r.distance > 0 && r.distance <= setup.tolerance && r.normal.y > GJK_Q30(0.9999));
  CHECK(gjk_collider_init(&a, &west, NULL, 0) == GJK_OK && gjk_collider_init(&b, &east, NULL, 0) == GJK_OK);
  to.to.position.x--;
  CHECK(gjk_time_of_impact(&a, &from, &b, &to, &setup, &r) == GJK_OK);
  CHECK(!r.hit && r.lower == GJK_Q30_ONE && r.iterations == 1);
}

static void check_overlap(void) {
  const gjk_shape box = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
  gjk_motion m = standing(1.5, 0, 0);
  m.to.position = vec(9, 0, 0);
  gjk_impact_result r = impact(&box, &rest, &box, &m, 0);
  CHECK(r.hit && r.overlap && r.lower == 0 && r.upper == 0 && r.distance == 0 && r.iterations == 1);
  m = standing(2.5, 0, 0);
  r = impact(&box, &rest, &box, &m, GJK_Q16(0.5));
  CHECK(r.hit && r.overlap && r.distance == GJK_Q16(0.5) && r.normal.x == GJK_Q30_ONE && r.lower == 0);
  m.from.position.x = m.to.position.x = GJK_Q16(2.0) + TOLERANCE;
  r = impact(&box, &rest, &box, &m, 0);
  CHECK(r.hit && !r.overlap && r.distance == TOLERANCE && r.lower == 0);
}

static void check_statuses(void) {
  const gjk_shape box = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
  static const gjk_vec3 far_away[4] = {{INT32_MAX, 0, 0}, {INT32_MAX, 9, 0}, {INT32_MAX, 0, 9}, {INT32_MAX - 9, 0, 0}};
  const gjk_shape hull = GJK_HULL(far_away, 4);
  gjk_collider a = {0}, b = {0}, h = {0};
  gjk_motion m = standing(5, 0, 0), bad = m;
  gjk_impact_setup setup = {0, TOLERANCE, 0};
  gjk_impact_result r, before;
  memset(&r, 0x5A, sizeof r);
  before = r;
  CHECK(gjk_collider_init(&a, &box, NULL, 0) == GJK_OK && gjk_collider_init(&h, &hull, NULL, 0) == GJK_OK);
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, &setup, &r) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_collider_init(&b, &box, NULL, 0) == GJK_OK);
  CHECK(gjk_time_of_impact(NULL, &rest, &b, &m, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_time_of_impact(&a, NULL, &b, &m, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_time_of_impact(&a, &rest, NULL, &m, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_time_of_impact(&a, &rest, &b, NULL, &setup, &r) == GJK_ERROR_NULL);
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, NULL, &r) == GJK_ERROR_NULL);
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, &setup, NULL) == GJK_ERROR_NULL);
  bad.to.rotation.w = 0;
  CHECK(gjk_time_of_impact(&a, &rest, &b, &bad, &setup, &r) == GJK_ERROR_ROTATION);
  CHECK(gjk_time_of_impact(&a, &bad, &b, &m, &setup, &r) == GJK_ERROR_ROTATION);
  setup.margin = -1;
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, &setup, &r) == GJK_ERROR_NEGATIVE);
  setup.margin = GJK_IMPACT_MARGIN_MAX + 1;
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, &setup, &r) == GJK_ERROR_RANGE);
  setup.margin = 0;
  setup.tolerance = TOLERANCE - 1;
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, &setup, &r) == GJK_ERROR_RANGE);
  setup.tolerance = TOLERANCE;
  CHECK(gjk_time_of_impact(&a, &rest, &h, &rest, &setup, &r) == GJK_ERROR_RANGE);  // 32,768 units from its origin
  setup.tolerance = GJK_Q16_ONE;
  CHECK(gjk_time_of_impact(&a, &rest, &h, &m, &setup, &r) == GJK_ERROR_RANGE);  // its centre may leave int32
  CHECK(memcmp(&r, &before, sizeof r) == 0);
  CHECK(gjk_time_of_impact(&a, &rest, &b, &m, &setup, &r) == GJK_OK && !r.hit);
}

int main(void) {
  check_balls();
  check_rod_to_ball();
  check_rod_to_floor();
  check_corner();
  check_grazing();
  check_margin();
  check_cast();
  check_same_place();
  check_far_arms();
  check_overlap();
  check_statuses();
  return check_done("impact analytic");
}
