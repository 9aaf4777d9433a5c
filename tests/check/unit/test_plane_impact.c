// gjk2_time_of_impact and gjk2_motion_pose against a fine search over exact distances, and against analysis.
#include "plane.h"

#define SEED 2041
#define TRIALS check_trials(4000)

typedef struct impact_case {
  plane_body pair[2];
  gjk2_motion motion[2];
  gjk2_impact_setup setup;
} impact_case;

static void print_case(const void *subject) {
  const impact_case *c = (const impact_case *)subject;
  plane_print(c->pair);
  for (int i = 0; i < 2; i++) {
    const gjk2_motion *m = &c->motion[i];
    printf("  (%d, %d) %d %d to (%d, %d) %d %d spin %d\n", m->from.position.x, m->from.position.y, m->from.rotation.c,
           m->from.rotation.s, m->to.position.x, m->to.position.y, m->to.rotation.c, m->to.rotation.s, m->spin);
  }
  printf("  margin %d tolerance %d\n", c->setup.margin, c->setup.tolerance);
}

// The gap of both as posed at a fraction; -1 where they intersect.
static gjk_q16 gap_at(const impact_case *c, gjk_q30 at) {
  gjk2_collider posed[2];
  for (int i = 0; i < 2; i++) {
    gjk2_pose pose;
    posed[i] = c->pair[i].collider;
    posed[i].buffer = NULL;
    CHECK(gjk2_motion_pose(&c->motion[i], at, &pose) == GJK_OK);
    CHECK(gjk2_collider_pose(&posed[i], &pose) == GJK_OK);
  }
  gjk2_distance_result gap;
  CHECK(gjk2_distance(&posed[0], &posed[1], NULL, &gap) == GJK_OK);
  return gap.intersecting ? -1 : gap.distance;
}

static struct {
  unsigned long hits, misses, overlaps, limits, distances, tight;
  uint8_t most;
} tally;

// What rounding may hide of a gap, LSB: see gjk2_impact.c.
static gjk_q16 slack_of(const impact_case *c) {
  const int64_t radii = (int64_t)c->pair[0].collider.radius + c->pair[1].collider.radius;
  return (gjk_q16)(6 + (radii >> 26));
}

static void check_impact(random_state *r, const impact_case *c) {
  gjk2_impact_result out;
  const gjk_status status =
      gjk2_time_of_impact(&c->pair[0].collider, &c->motion[0], &c->pair[1].collider, &c->motion[1], &c->setup, &out);
  CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
  tally.distances += out.iterations;
  tally.most = out.iterations > tally.most ? out.iterations : tally.most;
  CHECK(out.lower >= 0 && out.lower <= out.upper && out.upper <= GJK_Q30_ONE);
  const gjk_q16 margin = c->setup.margin, slack = slack_of(c);
  if (status != GJK_OK) {
    tally.limits++;
    CHECK(!out.hit && out.upper == GJK_Q30_ONE);
  } else if (out.hit) {
    const gjk_q16 gap = gap_at(c, out.upper);
    CHECK_MSG(gap <= margin + c->setup.tolerance, "%d", gap);
    CHECK((gap < 0 ? 0 : gap) == out.distance);
    CHECK(out.overlap == (out.upper == 0 && (gap < 0 || (margin > 0 && gap <= margin))));
    tally.overlaps += out.overlap;
    tally.hits += !out.overlap;
    tally.tight += out.lower == out.upper;
  } else {
    tally.misses++;
    CHECK(out.lower == GJK_Q30_ONE && out.upper == GJK_Q30_ONE && !out.overlap);
  }
  if (!out.overlap) {
    CHECK(gap_at(c, out.lower) >= 0 || (out.hit && out.lower == 0));
  }
  // Before lower nothing is as near as the margin, but for what rounding hides.
  for (int i = 0; i < 200 && out.lower > 0; i++) {
    const gjk_q30 at =
        i < 100 ? (gjk_q30)((int64_t)out.lower * i / 100)
                : (gjk_q30)((int64_t)out.lower - random_below(r, (uint32_t)out.lower / (1u << (i % 20)) + 1));
    const gjk_q16 gap = gap_at(c, at);
    CHECK_MSG(gap >= margin - slack, "gap %d at %d", gap, at);
    if (gap < margin - slack) {
      break;
    }
  }
  gjk2_pose pose;
  for (int i = 0; i < 2; i++) {
    CHECK(gjk2_motion_pose(&c->motion[i], out.lower, &pose) == GJK_OK);
    CHECK(memcmp(&pose, i == 0 ? &out.pose_a : &out.pose_b, sizeof pose) == 0);
  }
}

static void random_motion(random_state *r, const plane_body *body, int32_t way, gjk2_motion *m) {
  m->from = body->pose;
  m->to = body->pose;
  m->to.position.x += random_range(r, -way, way);
  m->to.position.y += random_range(r, -way, way);
  m->spin = 0;
  switch (random_below(r, 4)) {
    case 0: break;
    case 1: m->spin = random_range(r, -600000, 600000); break;
    default: m->to.rotation = plane_random_rotation(r);
  }
}

static void test_random(random_state *r) {
  static impact_case c;
  static const int32_t sizes[] = {50, 1000, 60000, 60000, 3000000, 100000000};
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = sizes[random_below(r, 6)];
    plane_random_pair(r, size, size * 3, c.pair);
    for (int k = 0; k < 2; k++) {
      random_motion(r, &c.pair[k], random_below(r, 4) == 0 ? 0 : size * 4, &c.motion[k]);
    }
    if (random_below(r, 2) == 0) {  // towards A's place
      c.motion[1].to.position.x = c.pair[0].collider.centre.x + random_range(r, -size, size);
      c.motion[1].to.position.y = c.pair[0].collider.centre.y + random_range(r, -size, size);
    }
    c.setup.margin = random_below(r, 3) == 0 ? random_range(r, 0, size / 4) : 0;
    c.setup.tolerance = random_below(r, 3) == 0 ? GJK2_IMPACT_TOLERANCE_MIN : random_range(r, 8, size / 4 + 8);
    c.setup.iterations = (uint8_t)(random_below(r, 10) == 0 ? random_range(r, 1, 3) : 0);
    check_impact(r, &c);
  }
}

// Ways of turning: both ends exact, halves on half of the angle, and whole turns.
static void test_poses(random_state *r) {
  for (unsigned long i = 0; i < TRIALS; i++) {
    gjk2_motion m;
    check_trial(i, NULL, NULL);
    m.from.rotation = plane_random_rotation(r);
    m.to.rotation = plane_random_rotation(r);
    m.from.position.x = random_range(r, INT32_MIN, INT32_MAX);
    m.from.position.y = random_range(r, -100, 100);
    m.to.position.x = random_range(r, INT32_MIN, INT32_MAX);
    m.to.position.y = random_range(r, -100, 100);
    m.spin = random_below(r, 2) == 0 ? 0 : random_range(r, INT32_MIN, INT32_MAX);
    const gjk_q30 any = random_range(r, 0, GJK_Q30_ONE), at = i % 8 == 0 ? 1 : any;
    gjk2_pose pose;
    CHECK(gjk2_motion_pose(&m, at, &pose) == GJK_OK);
    const long double s = at / 1073741824.0L;
    CHECK(fabsl(pose.position.x - (m.from.position.x + s * ((long double)m.to.position.x - m.from.position.x))) <=
          0.5L);
    CHECK(fabsl(pose.position.y - (m.from.position.y + s * ((long double)m.to.position.y - m.from.position.y))) <=
          0.5L);
    const long double from = atan2l(m.from.rotation.s, m.from.rotation.c),
                      to = atan2l(m.to.rotation.s, m.to.rotation.c);
    const long double turn = 2 * acosl(-1);
    long double angle = m.spin != 0 ? m.spin / 65536.0L : to - from;
    if (m.spin == 0) {
      angle -= turn * roundl(angle / turn);
      if (fabsl(fabsl(angle) - turn / 2) < 1e-8L) {
        continue;  // half a turn: either way round
      }
    }
    const long double x = cosl(from + s * angle) * 1073741824, y = sinl(from + s * angle) * 1073741824;
    const long double off = hypotl(x - pose.rotation.c, y - pose.rotation.s);
    CHECK_MSG(off <= 5.4L, "%Lf LSB at %d, angle %Lf", off, at, angle);
    CHECK(gjk2_motion_pose(&m, 0, &pose) == GJK_OK && memcmp(&pose, &m.from, sizeof pose) == 0);
    if (m.spin == 0) {
      CHECK(gjk2_motion_pose(&m, GJK_Q30_ONE, &pose) == GJK_OK && memcmp(&pose, &m.to, sizeof pose) == 0);
    }
  }
}

static gjk_status ask(impact_case *c, gjk2_impact_result *out) {
  for (int i = 0; i < 2; i++) {
    c->pair[i].collider.state = 0;
    CHECK(gjk2_collider_init(&c->pair[i].collider, &c->pair[i].shape, NULL, 0) == GJK_OK);
  }
  return gjk2_time_of_impact(&c->pair[0].collider, &c->motion[0], &c->pair[1].collider, &c->motion[1], &c->setup, out);
}

// A rod turns about its middle onto a point, from any angle and by up to 2607 turns: arms of which the moment is known.
static void test_rod(random_state *r) {
  static impact_case c;
  unsigned long hits = 0;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    check_trial(i, NULL, NULL);
    const bool wild = random_below(r, 4) == 0;  // thousands of turns of a long rod: products of more than 64 bits
    const gjk_q16 half = wild ? INT32_C(1) << 27 : random_range(r, 20000, 2000000);
    const gjk2_shape rod = GJK2_SEGMENT(half), point = GJK2_POINT;
    const gjk2_pose origin = GJK2_POSE_IDENTITY;
    const gjk_angle most = random_below(r, 4) == 0 ? 30000000 : 1500000;
    const gjk_angle at = random_range(r, 10000, 400000), spin = wild ? INT32_C(1) << 30 : random_range(r, 1000, most);
    gjk2_rotation to_point;
    CHECK(gjk2_rotation_from_angle(at, &to_point) == GJK_OK);
    c.pair[0].shape = rod;
    c.pair[1].shape = point;
    c.motion[0].from = c.motion[0].to = c.motion[1].from = c.motion[1].to = origin;
    c.motion[0].spin = spin;
    c.motion[1].spin = 0;
    const gjk_q16 reach = half / 8 * (gjk_q16)(2 + random_below(r, 5));
    c.motion[1].from.position.x = c.motion[1].to.position.x = (gjk_q16)((int64_t)to_point.c * reach >> 30);
    c.motion[1].from.position.y = c.motion[1].to.position.y = (gjk_q16)((int64_t)to_point.s * reach >> 30);
    c.setup.margin = 0;
    c.setup.tolerance = wild ? 8000 : 20;  // a step of the fraction leads 2048 LSB along the end of the long rod
    c.setup.iterations = 0;
    gjk2_impact_result out;
    CHECK(ask(&c, &out) == GJK_OK);
    // The rod's line meets the point each half turn.
    const double half_turn = 205887.416, first = at - half_turn * floor(at / half_turn);
    const double off = (c.setup.tolerance + 1.0) / reach * 65536;  // the angle of the tolerance and 1 LSB at the point
    if (spin > first) {
      CHECK_MSG(out.hit, "spin %d, at %f", spin, first);
      hits++;
      const double lower = out.lower / 1073741824.0 * spin, upper = out.upper / 1073741824.0 * spin;
      CHECK_MSG(lower <= first && upper >= first - off && upper <= first + off, "%f from %f to %f", first, lower,
                upper);
    } else if (spin < first - off) {
      CHECK(!out.hit);
    }
  }
  CHECK(hits > TRIALS / 20);
}

// Fast and thin bodies that spin do not pass a wall of an LSB.
static void test_bullets(random_state *r) {
  static impact_case c;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    check_trial(i, NULL, NULL);
    const gjk2_shape wall = GJK2_BOX(1, 10000000),
                     bullet = GJK2_BOX(random_range(r, 100, 60000), random_range(r, 1, 100));
    const gjk2_pose origin = GJK2_POSE_IDENTITY;
    c.pair[0].shape = wall;
    c.pair[1].shape = bullet;
    c.motion[0].from = c.motion[0].to = c.motion[1].from = origin;
    c.motion[0].spin = 0;
    c.motion[1].from.position.x = -100000;
    c.motion[1].from.rotation = plane_random_rotation(r);
    c.motion[1].to = c.motion[1].from;
    c.motion[1].to.position.x = 200000 + random_range(r, 0, 100000000);
    c.motion[1].to.position.y = random_range(r, -5000000, 5000000);
    c.motion[1].spin = random_range(r, -10000000, 10000000);
    c.setup.margin = 0;
    c.setup.tolerance = 100;
    c.setup.iterations = 250;
    gjk2_impact_result out;
    const gjk_status status = ask(&c, &out);
    CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
    CHECK(status != GJK_OK || out.hit);
    CHECK(out.pose_b.position.x <= 0 && out.lower < GJK_Q30_ONE);
  }
}

static void test_statuses(void) {
  static const gjk2_shape box = GJK2_BOX(100, 50);
  const gjk2_motion still = {GJK2_POSE_IDENTITY, GJK2_POSE_IDENTITY, 0};
  gjk2_motion bent = still, crooked = still;
  bent.from.rotation.c = 5;
  crooked.to.rotation.c = 5;
  gjk2_collider a = {0}, b = {0};
  gjk2_impact_setup setup = {0, GJK2_IMPACT_TOLERANCE_MIN, 0};
  gjk2_impact_result out, before;
  gjk2_pose pose;
  memset(&out, 0x55, sizeof out);
  before = out;
  CHECK(gjk2_time_of_impact(&a, &still, &b, &still, &setup, &out) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_collider_init(&a, &box, NULL, 0) == GJK_OK && gjk2_collider_init(&b, &box, NULL, 0) == GJK_OK);
  CHECK(gjk2_time_of_impact(NULL, &still, &b, &still, &setup, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_time_of_impact(&a, NULL, &b, &still, &setup, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_time_of_impact(&a, &still, NULL, &still, &setup, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_time_of_impact(&a, &still, &b, NULL, &setup, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_time_of_impact(&a, &still, &b, &still, NULL, &out) == GJK_ERROR_NULL);
  CHECK(gjk2_time_of_impact(&a, &still, &b, &still, &setup, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_time_of_impact(&a, &bent, &b, &still, &setup, &out) == GJK_ERROR_ROTATION);
  CHECK(gjk2_time_of_impact(&a, &still, &b, &crooked, &setup, &out) == GJK_ERROR_ROTATION);
  crooked.spin = 1;
  setup.margin = -1;
  CHECK(gjk2_time_of_impact(&a, &still, &b, &still, &setup, &out) == GJK_ERROR_NEGATIVE);
  setup.margin = 0;
  setup.tolerance = GJK2_IMPACT_TOLERANCE_MIN - 1;
  CHECK(gjk2_time_of_impact(&a, &still, &b, &still, &setup, &out) == GJK_ERROR_RANGE);
  CHECK(memcmp(&out, &before, sizeof out) == 0);
  setup.tolerance = GJK2_IMPACT_TOLERANCE_MIN;
  CHECK(gjk2_time_of_impact(&a, &still, &b, &crooked, &setup, &out) == GJK_OK);
  CHECK(out.hit && out.overlap && out.lower == 0 && out.upper == 0 && out.distance == 0 && out.iterations == 1);
  CHECK(gjk2_motion_pose(NULL, 0, &pose) == GJK_ERROR_NULL && gjk2_motion_pose(&still, 0, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_motion_pose(&still, -1, &pose) == GJK_ERROR_RANGE);
  CHECK(gjk2_motion_pose(&still, GJK_Q30_ONE + 1, &pose) == GJK_ERROR_RANGE);
  CHECK(gjk2_motion_pose(&bent, 0, &pose) == GJK_ERROR_ROTATION);
}

// Circles that start 20,000 units apart, beyond what products of 32 bits take, and one turns: they touch where their centres
// are 2 units apart.
static void test_far(void) {
  const gjk2_shape circle = GJK2_CIRCLE(GJK_Q16(1));
  const gjk2_impact_setup setup = {0, GJK2_IMPACT_TOLERANCE_MIN * 64, 0};
  gjk2_motion still = {GJK2_POSE_IDENTITY, GJK2_POSE_IDENTITY, GJK_Q16(3)}, moves = still;
  gjk2_collider a = {0}, b = {0};
  gjk2_impact_result out;
  moves.from.position.x = GJK_Q16(-20000);
  moves.to.position.x = GJK_Q16(20000);
  CHECK(gjk2_collider_init(&a, &circle, NULL, 0) == GJK_OK && gjk2_collider_init(&b, &circle, NULL, 0) == GJK_OK);
  CHECK(gjk2_time_of_impact(&a, &still, &b, &moves, &setup, &out) == GJK_OK && out.hit && !out.overlap);
  const double way = 40000.0 * 65536, fraction = (20000.0 - 2) / 40000, lower = (double)out.lower / GJK_Q30_ONE;
  CHECK_MSG(lower <= fraction && lower >= fraction - (setup.tolerance + 4) / way, "lower %.9f of %.9f", lower,
            fraction);
  CHECK(out.upper >= out.lower && out.distance <= setup.tolerance && out.normal.x < -GJK_Q30(0.9999));
}

int main(void) {
  random_state r = random_seed(check_seed(SEED));
  test_poses(&r);
  test_random(&r);
  test_rod(&r);
  test_bullets(&r);
  test_far();
  test_statuses();
  printf("%lu hits (%lu at one fraction), %lu misses, %lu overlaps, %lu at the ceiling; %lu distances, at most %u\n",
         tally.hits, tally.tight, tally.misses, tally.overlaps, tally.limits, tally.distances, tally.most);
  CHECK(tally.hits > TRIALS / 20 && tally.misses > TRIALS / 5 && tally.overlaps > TRIALS / 20 && tally.limits > 0);
  return check_done("plane_impact");
}
