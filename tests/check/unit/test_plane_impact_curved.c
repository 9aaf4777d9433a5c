// gjk2_time_of_impact of ellipses and custom shapes: against an ellipse's distance by bisection, along the real motion;
// against polygons that custom shapes stand for; and custom shapes that do not keep their contract.
#include "plane.h"

#define SEED 2043
#define TRIALS check_trials(2000)
#define SAMPLES 100

typedef struct curved_case {
  gjk2_shape shape[2];
  gjk2_motion motion[2];
  gjk2_impact_setup setup;
  gjk2_vec corners[4];  // of a custom polygon
} curved_case;

static void print_case(const void *subject) {
  const curved_case *c = (const curved_case *)subject;
  for (int i = 0; i < 2; i++) {
    const gjk2_motion *m = &c->motion[i];
    printf("  size %d %d radius %d, (%d, %d) %d %d to (%d, %d) %d %d spin %d\n", c->shape[i].size.x, c->shape[i].size.y,
           c->shape[i].convex_radius, m->from.position.x, m->from.position.y, m->from.rotation.c, m->from.rotation.s,
           m->to.position.x, m->to.position.y, m->to.rotation.c, m->to.rotation.s, m->spin);
  }
  printf("  margin %d tolerance %d\n", c->setup.margin, c->setup.tolerance);
}

static struct { unsigned long hits, misses, overlaps, limits, distances; } tally;

// The pose at a fraction in real numbers: x, y, angle.
typedef struct real_pose {
  long double x, y, angle;
} real_pose;

static real_pose real_at(const gjk2_motion *m, long double s) {
  const long double from = atan2l(m->from.rotation.s, m->from.rotation.c);
  long double turn = m->spin / 65536.0L;
  if (m->spin == 0) {
    const long double whole = 2 * acosl(-1);
    turn = atan2l(m->to.rotation.s, m->to.rotation.c) - from;
    turn -= whole * roundl(turn / whole);
  }
  return (real_pose){m->from.position.x + s * ((long double)m->to.position.x - m->from.position.x),
                     m->from.position.y + s * ((long double)m->to.position.y - m->from.position.y), from + s * turn};
}

// The distance of the point (x, y) from an ellipse about the origin; 0 inside. The foot is (x a^2 / (t + a^2), ...) for
// the t >= 0 at which it lies on the ellipse, and there its equation falls with t.
static long double from_ellipse(long double a, long double b, long double x, long double y) {
  if (x * x / (a * a) + y * y / (b * b) <= 1) {
    return 0;
  }
  long double low = 0, high = (a > b ? a : b) * hypotl(x, y);
  for (int i = 0; i < 120; i++) {
    const long double t = (low + high) / 2, u = a * x / (t + a * a), v = b * y / (t + b * b);
    *(u * u + v * v > 1 ? &low : &high) = t;
  }
  return hypotl(x - a * a * x / (high + a * a), y - b * b * y / (high + b * b));
}

// The gap of an ellipse, A, and a circle, B.
static long double gap_of_circle(const curved_case *c, long double s) {
  const real_pose a = real_at(&c->motion[0], s), b = real_at(&c->motion[1], s);
  const long double x = b.x - a.x, y = b.y - a.y;
  return from_ellipse(c->shape[0].size.x, c->shape[0].size.y, x * cosl(a.angle) + y * sinl(a.angle),
                      y * cosl(a.angle) - x * sinl(a.angle)) -
         c->shape[0].convex_radius - c->shape[1].convex_radius;
}

// The gap of two polygons, of which A stands in for the custom shape; 0 where they intersect.
static long double gap_of_polygons(const curved_case *c, long double s) {
  gjk2_collider posed[2] = {0};
  const gjk2_shape stand_in = GJK2_ROUNDED_POLYGON(c->corners, 4, c->shape[0].convex_radius);
  gjk2_distance_result gap;
  gjk2_pose pose;
  for (int i = 0; i < 2; i++) {
    CHECK(gjk2_collider_init(&posed[i], i == 0 ? &stand_in : &c->shape[1], NULL, 0) == GJK_OK);
    CHECK(gjk2_motion_pose(&c->motion[i], (gjk_q30)llroundl(s * 1073741824), &pose) == GJK_OK);
    CHECK(gjk2_collider_pose(&posed[i], &pose) == GJK_OK);
  }
  CHECK(gjk2_distance(&posed[0], &posed[1], NULL, &gap) == GJK_OK);
  return gap.intersecting ? 0 : gap.distance;
}

static gjk_status ask(const curved_case *c, gjk2_impact_result *out) {
  gjk2_collider unposed[2] = {0};
  for (int i = 0; i < 2; i++) {
    CHECK(gjk2_collider_init(&unposed[i], &c->shape[i], NULL, 0) == GJK_OK);
  }
  return gjk2_time_of_impact(&unposed[0], &c->motion[0], &unposed[1], &c->motion[1], &c->setup, out);
}

// slack: what rounding may hide of a gap, LSB.
static void check_impact(random_state *r, const curved_case *c, long double (*gap_at)(const curved_case *, long double),
                         int slack) {
  gjk2_impact_result out;
  const gjk_status status = ask(c, &out);
  const gjk_q16 margin = c->setup.margin;
  CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
  CHECK(out.lower >= 0 && out.lower <= out.upper && out.upper <= GJK_Q30_ONE);
  tally.distances += out.iterations;
  if (status != GJK_OK) {
    tally.limits++;
    CHECK(!out.hit && out.upper == GJK_Q30_ONE);
  } else if (out.hit) {
    const long double gap = gap_at(c, out.upper / 1073741824.0L);
    CHECK_MSG(gap <= margin + c->setup.tolerance + slack, "gap %Lf at %d", gap, out.upper);
    CHECK_MSG(fabsl((gap > 0 ? gap : 0) - out.distance) <= slack, "gap %Lf, reported %d", gap, out.distance);
    tally.overlaps += out.overlap;
    tally.hits += !out.overlap;
  } else {
    tally.misses++;
    CHECK(out.lower == GJK_Q30_ONE && out.upper == GJK_Q30_ONE && !out.overlap);
  }
  // Before lower nothing is as near as the margin.
  for (int i = 0; i < SAMPLES && out.lower > 0; i++) {
    const gjk_q30 at =
        i < SAMPLES / 2 ? (gjk_q30)((int64_t)out.lower * i / (SAMPLES / 2))
                        : (gjk_q30)(out.lower - (gjk_q30)random_below(r, (uint32_t)out.lower / (1u << (i % 20)) + 1));
    const long double gap = gap_at(c, at / 1073741824.0L);
    CHECK_MSG(gap >= margin - slack, "gap %Lf at %d, before %d", gap, at, out.lower);
    if (gap < margin - slack) {
      break;
    }
  }
}

static void random_motions(random_state *r, curved_case *c, int32_t size) {
  for (int i = 0; i < 2; i++) {
    gjk2_motion *m = &c->motion[i];
    m->from.rotation = plane_random_rotation(r);
    m->to.rotation = random_below(r, 3) == 0 ? m->from.rotation : plane_random_rotation(r);
    m->from.position = plane_random_vec(r, 4 * size);
    if (m->to.rotation.c == -m->from.rotation.c && m->to.rotation.s == -m->from.rotation.s) {
      m->to.rotation = m->from.rotation;  // half a turn: either way round
    }
    m->to.position = m->from.position;
    m->spin = random_below(r, 3) == 0 ? random_range(r, -1000000, 1000000) : 0;
    if (random_below(r, 4) != 0) {
      m->to.position = plane_random_vec(r, 4 * size);
    }
  }
  if (random_below(r, 2) == 0) {  // through A
    c->motion[1].to.position.x = 2 * c->motion[0].to.position.x - c->motion[1].from.position.x;
    c->motion[1].to.position.y = 2 * c->motion[0].to.position.y - c->motion[1].from.position.y;
  }
  c->setup.margin = random_below(r, 3) == 0 ? random_range(r, 0, size / 4) : 0;
  c->setup.tolerance = random_range(r, 16, size / 4 + 16);
  c->setup.iterations = (uint8_t)(random_below(r, 10) == 0 ? random_range(r, 1, 3) : 0);
}

static void test_ellipses(random_state *r) {
  static curved_case c;
  static const int32_t sizes[] = {100, 2000, 65536, 2000000};
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = sizes[random_below(r, 4)];
    const gjk_q16 x = random_range(r, size / 4, size), y = random_range(r, 1 + size / 20, size);
    c.shape[0] = (gjk2_shape)GJK2_ROUNDED_ELLIPSE(x, y, random_below(r, 2) == 0 ? 0 : random_range(r, 0, size / 4));
    c.shape[1] = (gjk2_shape)GJK2_CIRCLE(random_range(r, 0, size));
    random_motions(r, &c, size);
    check_impact(r, &c, gap_of_circle, 9);
  }
}

// A polygon of four corners by its support function.
static void support_corners(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  const gjk2_vec *v = (const gjk2_vec *)user;
  int best = 0;
  for (int i = 1; i < 4; i++) {
    const int64_t x = (int64_t)v[i].x - v[best].x, y = (int64_t)v[i].y - v[best].y;
    best = x * direction->x + y * direction->y > 0 ? i : best;
  }
  *out = v[best];
}

static void test_custom(random_state *r) {
  static curved_case c;
  static const int32_t sizes[] = {100, 2000, 65536, 2000000};
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, print_case, &c);
    const int32_t size = sizes[random_below(r, 4)];
    for (int k = 0; k < 4; k++) {
      c.corners[k] = plane_random_vec(r, size);
    }
    c.shape[0] = (gjk2_shape)GJK2_ROUNDED_CUSTOM(support_corners, c.corners, size + size / 2,
                                                 random_below(r, 2) == 0 ? 0 : random_range(r, 0, size / 4));
    c.shape[1] = (gjk2_shape)GJK2_BOX(random_range(r, 0, size), random_range(r, 1, size));
    random_motions(r, &c, size);
    check_impact(r, &c, gap_of_polygons, 12);
  }
}

static uint32_t lies;

// Any point within the bound, another one each time.
static void support_lying(const void *user, const gjk2_vec *direction, gjk2_vec *out) {
  const gjk_q16 bound = *(const gjk_q16 *)user;
  (void)direction;
  lies = lies * UINT32_C(1664525) + UINT32_C(1013904223);
  out->x = (gjk_q16)(lies >> 8) % (bound / 2);
  lies = lies * UINT32_C(1664525) + UINT32_C(1013904223);
  out->y = -((gjk_q16)(lies >> 8) % (bound / 2));
}

// A support function that does not keep its contract costs an answer, not the end of the query or its ranges. Against what
// the shape's bound never meets, the answer is right.
static void test_lies(random_state *r) {
  static curved_case c;
  static gjk_q16 bound;
  unsigned long found = 0;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    gjk2_impact_result out;
    check_trial(i, print_case, &c);
    bound = random_range(r, 100, 200000);
    c.shape[0] = (gjk2_shape)GJK2_CUSTOM(support_lying, &bound, bound);
    c.shape[1] = (gjk2_shape)GJK2_BOX(bound / 3, bound / 5);
    random_motions(r, &c, bound);
    const gjk_status status = ask(&c, &out);
    CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
    CHECK(out.lower >= 0 && out.lower <= out.upper && out.upper <= GJK_Q30_ONE);
    found += status == GJK_OK && out.hit;
    c.motion[0].from.position.x = c.motion[0].to.position.x = 40 * bound;
    c.setup.iterations = 0;
    CHECK(ask(&c, &out) != GJK_OK || !out.hit);
  }
  CHECK(found > TRIALS / 40);
}

// A wheel that spins on its axle touches nothing, whatever it is made of; moved to the wall beside it, it does.
static void test_wheels(random_state *r) {
  static curved_case c;
  for (unsigned long i = 0; i < TRIALS / 4; i++) {
    gjk2_impact_result out;
    check_trial(i, print_case, &c);
    const gjk_q16 radius = random_range(r, 1000, 500000), gap = random_range(r, 100, 1000);
    const gjk2_shape wheel = GJK2_ELLIPSE(radius, radius), wall = GJK2_BOX(50, 4 * radius);
    const gjk2_pose origin = GJK2_POSE_IDENTITY;
    c.shape[0] = wheel;
    c.shape[1] = wall;
    for (int k = 0; k < 2; k++) {
      c.motion[k].from = c.motion[k].to = origin;
      c.motion[k].spin = 0;
    }
    c.motion[1].from.position.x = c.motion[1].to.position.x = radius + gap + 50;
    c.motion[0].spin = random_range(r, -20000000, 20000000);
    c.setup.margin = 0;
    c.setup.tolerance = 40;
    c.setup.iterations = 0;
    CHECK(ask(&c, &out) == GJK_OK && !out.hit);
    c.motion[0].to.position.x = 4 * gap;  // contact at a quarter of the way
    CHECK(ask(&c, &out) == GJK_OK && out.hit);
    const double lower = out.lower / 1073741824.0 * 4 * gap, upper = out.upper / 1073741824.0 * 4 * gap;
    CHECK_MSG(lower <= gap + 9 && upper >= gap - 49 && upper <= gap + 9, "gap %d, %f to %f", gap, lower, upper);
  }
}

int main(void) {
  random_state r = random_seed(check_seed(SEED));
  test_ellipses(&r);
  test_custom(&r);
  printf("%lu hits, %lu misses, %lu overlaps, %lu at the ceiling; %lu distances\n", tally.hits, tally.misses,
         tally.overlaps, tally.limits, tally.distances);
  CHECK(tally.hits > TRIALS / 4 && tally.misses > TRIALS / 4 && tally.overlaps > TRIALS / 20 && tally.limits > 0);
  test_lies(&r);
  test_wheels(&r);
  return check_done("plane_impact_curved");
}
