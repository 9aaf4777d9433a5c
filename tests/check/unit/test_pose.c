// Quaternions and poses against long double: the errors stated in gjk/pose.h, directions, round trips.
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "gjk/pose.h"
#include "random.h"
#include "reference/real_quat.h"
#include "same.h"

#define SEED 20240611
#define ITERATIONS ((int)check_trials(200000))
#define ONE GJK_Q30_ONE

typedef struct real3 {
  long double x, y, z;
} real3;

// The largest error of a function in LSB, and the input that gave it.
typedef struct worst {
  const char *name;
  long double stated, error;
  char input[160];
} worst;

// Records the error of a component. Returns whether it is the largest so far.
static bool worse(worst *at, long double got, long double real) {
  const long double error = fabsl(got - real);
  const bool is = !(error <= at->error);
  at->error = is ? error : at->error;
  return is;
}

static bool worse_quat(worst *at, const gjk_quat *got, real_quat real) {
  const bool x = worse(at, got->x, real.x * ONE), y = worse(at, got->y, real.y * ONE);
  const bool z = worse(at, got->z, real.z * ONE), w = worse(at, got->w, real.w * ONE);
  return x || y || z || w;
}

static bool worse_vec3(worst *at, const gjk_vec3 *got, real3 real) {
  const bool x = worse(at, got->x, real.x), y = worse(at, got->y, real.y), z = worse(at, got->z, real.z);
  return x || y || z;
}

#define NOTE(at, ...) snprintf((at)->input, sizeof(at)->input, __VA_ARGS__)

static void check_worst(const worst *at) {
  printf("%s: largest error %.3Lf LSB of %.3Lf stated, for %s\n", at->name, at->error, at->stated, at->input);
  CHECK_MSG(at->error <= at->stated, "%s: %.3Lf LSB for %s", at->name, at->error, at->input);
  // A stated error that is more than twice the largest seen promises too little.
  CHECK_MSG(at->error >= 0.5L * at->stated, "%s: %.3Lf LSB", at->name, at->error);
}

// v turned by the unit quaternion q = u + w: v + 2 w (u x v) + 2 u x (u x v).
static real3 real_apply(real_quat q, real3 v) {
  const real3 t = {2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x)};
  return (real3){v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
                 v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

static real3 real_vec3(const gjk_vec3 *v) {
  return (real3){v->x, v->y, v->z};
}

// A number of any size from 0 to the ends of int32_t, these included.
static int32_t random_component(random_state *random) {
  const uint32_t kind = random_below(random, 16);
  if (kind < 3) {
    const int32_t extreme[3] = {INT32_MIN, INT32_MAX, 0};
    return extreme[kind];
  }
  const int32_t high = (int32_t)(UINT32_C(0x7FFFFFFF) >> (kind < 9 ? 0 : random_below(random, 31)));
  return random_range(random, -high - 1, high);
}

// An angle: any, on a border of quadrants or octants of the angle or its half, or at the ends.
static gjk_q16 random_angle(random_state *random) {
  const uint32_t kind = random_below(random, 8);
  if (kind == 0) {
    const int32_t inward = random_range(random, 0, 2);
    return random_below(random, 2) == 0 ? INT32_MIN + inward : INT32_MAX - inward;
  }
  if (kind < 4) {
    const long double eighths = random_range(random, -41721, 41721);
    return (gjk_q16)llroundl(eighths * acosl(-1.0L) / 4 * 65536) + random_range(random, -2, 2);
  }
  return random_component(random);
}

static gjk_quat quat_of(real_quat q, long double length) {
  return (gjk_quat){(gjk_q30)llroundl(q.x * length * ONE), (gjk_q30)llroundl(q.y * length * ONE),
                    (gjk_q30)llroundl(q.z * length * ONE), (gjk_q30)llroundl(q.w * length * ONE)};
}

// A quaternion whose length is within the tolerance, in half of them just so; some are along the axes.
static gjk_quat random_unit(random_state *random) {
  gjk_quat q = {0, 0, 0, 0};
  while (q.x == 0 && q.y == 0 && q.z == 0 && q.w == 0) {
    q.x = random_component(random);
    q.y = random_component(random);
    q.z = random_component(random);
    q.w = random_component(random);
  }
  // Leaves 2 LSB of length for rounding.
  const long double edge = GJK_ROTATION_TOLERANCE / 2.0L / ONE - 2.0L / ONE;
  const uint32_t kind = random_below(random, 4);
  const long double part = kind < 2 ? 2.0L * kind - 1 : random_range(random, -1000, 1000) / 1000.0L;
  return quat_of(real_quat_of(&q), 1 + edge * part);
}

static gjk_vec3 random_vec3(random_state *random) {
  gjk_vec3 v;
  v.x = random_component(random);
  v.y = random_component(random);
  v.z = random_component(random);
  return v;
}

// A vector at most length LSB long.
static gjk_vec3 random_within(random_state *random, int32_t length) {
  const gjk_vec3 v = random_vec3(random);
  const real3 r = real_vec3(&v);
  const long double norm = sqrtl(r.x * r.x + r.y * r.y + r.z * r.z), scale = norm > length ? length / norm : 1;
  return (gjk_vec3){(gjk_q16)(r.x * scale), (gjk_q16)(r.y * scale), (gjk_q16)(r.z * scale)};
}

static void test_axis_angle(random_state *random) {
  worst at = {"axis and angle", 2, 0, ""};
  unsigned long mirrored = 0, length = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    gjk_vec3 axis = random_vec3(random);
    axis.z |= (axis.x | axis.y) == 0;
    const gjk_angle angle = random_angle(random);
    gjk_quat q, back;
    CHECK(gjk_quat_from_axis_angle(&axis, angle, &q) == GJK_OK);
    const long double half = angle / 131072.0L, sine = sinl(half);
    const real3 r = real_vec3(&axis);
    const long double norm = sqrtl(r.x * r.x + r.y * r.y + r.z * r.z);
    const real_quat real = {r.x / norm * sine, r.y / norm * sine, r.z / norm * sine, cosl(half)};
    if (worse_quat(&at, &q, real)) {
      NOTE(&at, "axis %ld %ld %ld angle %ld", (long)axis.x, (long)axis.y, (long)axis.z, (long)angle);
    }
    length += gjk_quat_invert(&q, &back) != GJK_OK;
    if (angle != INT32_MIN) {
      gjk_quat_from_axis_angle(&axis, -angle, &back);
      // Halves are rounded up, so a component of the mirror image may differ by 1.
      mirrored +=
          back.w != q.w || labs((long)back.x + q.x) > 1 || labs((long)back.y + q.y) > 1 || labs((long)back.z + q.z) > 1;
    }
  }
  check_worst(&at);
  CHECK_MSG(mirrored == 0, "%lu of %d angles and their opposites", mirrored, ITERATIONS);
  CHECK_MSG(length == 0, "%lu of %d not units", length, ITERATIONS);
}

static void test_euler(random_state *random) {
  worst at = {"Euler angles", 3, 0, ""};
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_q16 x = random_angle(random), y = random_angle(random), z = random_angle(random);
    gjk_quat q;
    CHECK(gjk_quat_from_euler(x, y, z, &q) == GJK_OK);
    const real_quat about_x = {sinl(x / 131072.0L), 0, 0, cosl(x / 131072.0L)};
    const real_quat about_y = {0, sinl(y / 131072.0L), 0, cosl(y / 131072.0L)};
    const real_quat about_z = {0, 0, sinl(z / 131072.0L), cosl(z / 131072.0L)};
    if (worse_quat(&at, &q, real_quat_product(about_z, real_quat_product(about_y, about_x)))) {
      NOTE(&at, "%ld %ld %ld", (long)x, (long)y, (long)z);
    }
  }
  check_worst(&at);
}

// The sine and cosine alone.
static void test_sine(random_state *random) {
  worst at = {"sine and cosine", 0.85L, 0, ""};
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_angle angle = random_angle(random);
    gjk_quat q;
    gjk_quat_from_euler(angle, 0, 0, &q);
    const real_quat real = {sinl(angle / 131072.0L), 0, 0, cosl(angle / 131072.0L)};
    if (worse_quat(&at, &q, real)) {
      NOTE(&at, "half of %ld", (long)angle);
    }
  }
  check_worst(&at);
}

static void test_normalize(random_state *random) {
  worst at = {"normalise", 0.501L, 0, ""};
  unsigned long changed = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_vec3 v = random_vec3(random);
    gjk_quat q = {v.x, v.y, v.z, random_component(random)}, unit;
    q.w |= (q.x | q.y | q.z) == 0;
    CHECK(gjk_quat_normalize(&q, &unit) == GJK_OK);
    if (worse_quat(&at, &unit, real_quat_of(&q))) {
      NOTE(&at, "%ld %ld %ld %ld", (long)q.x, (long)q.y, (long)q.z, (long)q.w);
    }
    gjk_quat_normalize(&q, &q);
    changed += !same_quat(&q, &unit);
  }
  check_worst(&at);
  CHECK_MSG(changed == 0, "in place %lu of %d", changed, ITERATIONS);
}

static void test_compose(random_state *random) {
  worst at = {"compose", 0.501L, 0, ""};
  unsigned long changed = 0, returned = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_quat a = random_unit(random), b = random_unit(random);
    gjk_quat p, into_a = a, into_b = b, square_a = a, squared;
    CHECK(gjk_quat_compose(&a, &b, &p) == GJK_OK);
    if (worse_quat(&at, &p, real_quat_product(real_quat_of(&a), real_quat_of(&b)))) {
      NOTE(&at, "%ld %ld %ld %ld by %ld %ld %ld %ld", (long)a.x, (long)a.y, (long)a.z, (long)a.w, (long)b.x, (long)b.y,
           (long)b.z, (long)b.w);
    }
    gjk_quat_compose(&into_a, &b, &into_a);
    gjk_quat_compose(&a, &into_b, &into_b);
    gjk_quat_compose(&a, &a, &squared);
    gjk_quat_compose(&square_a, &square_a, &square_a);
    changed += !same_quat(&into_a, &p) || !same_quat(&into_b, &p) || !same_quat(&square_a, &squared);

    gjk_quat opposite, none;
    CHECK(gjk_quat_invert(&a, &opposite) == GJK_OK);
    gjk_quat_compose(&a, &opposite, &none);
    returned += none.x == 0 && none.y == 0 && none.z == 0 && none.w == ONE;
  }
  check_worst(&at);
  CHECK_MSG(changed == 0, "in place %lu of %d", changed, ITERATIONS);
  CHECK_MSG(returned == (unsigned long)ITERATIONS, "with the inverse %lu of %d", returned, ITERATIONS);
}

// Turns and moves vectors that are at most length LSB long.
static void test_apply(random_state *random, const char *name, int32_t length, long double stated) {
  worst at = {name, stated, 0, ""};
  unsigned long changed = 0, out_of_range = 0, wrong = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_pose pose = {random_vec3(random), random_unit(random)};
    const gjk_vec3 v = length == 0 ? random_vec3(random) : random_within(random, length);
    const real3 turned = real_apply(real_quat_of(&pose.rotation), real_vec3(&v));
    const real3 p = real_vec3(&pose.position), moved = {p.x + turned.x, p.y + turned.y, p.z + turned.z};
    const gjk_vec3 none = {1, 2, 3};
    gjk_vec3 got = none, in_place = v;
    const gjk_status status = gjk_quat_apply(&pose.rotation, &v, &got);
    const long double largest = fmaxl(fabsl(turned.x), fmaxl(fabsl(turned.y), fabsl(turned.z)));
    if (status == GJK_OK) {
      if (worse_vec3(&at, &got, turned)) {
        NOTE(&at, "%ld %ld %ld by %ld %ld %ld %ld", (long)v.x, (long)v.y, (long)v.z, (long)pose.rotation.x,
             (long)pose.rotation.y, (long)pose.rotation.z, (long)pose.rotation.w);
      }
      wrong += largest > 2147483648.0L + stated;
    } else {
      out_of_range++;
      wrong += status != GJK_ERROR_RANGE || largest < 2147483647.0L - stated || !same_vec3(&got, &none);
    }
    gjk_quat_apply(&pose.rotation, &in_place, &in_place);
    changed += !same_vec3(&in_place, status == GJK_OK ? &got : &v);

    gjk_vec3 placed = none;
    const gjk_status at_pose = gjk_pose_apply(&pose, &v, &placed);
    const long double farthest = fmaxl(fabsl(moved.x), fmaxl(fabsl(moved.y), fabsl(moved.z)));
    if (at_pose == GJK_OK) {
      worse_vec3(&at, &placed, moved);
      wrong += farthest > 2147483648.0L + stated;
    } else {
      wrong += at_pose != GJK_ERROR_RANGE || farthest < 2147483647.0L - stated || !same_vec3(&placed, &none);
    }
  }
  check_worst(&at);
  CHECK_MSG(wrong == 0, "%s: %lu of %d statuses", name, wrong, ITERATIONS);
  CHECK_MSG(changed == 0, "%s: in place %lu of %d", name, changed, ITERATIONS);
  CHECK_MSG(length == 0
                ? out_of_range > (unsigned long)ITERATIONS / 10 && out_of_range < (unsigned long)ITERATIONS * 9 / 10
                : out_of_range == 0,
            "%s: %lu of %d out of range", name, out_of_range, ITERATIONS);
}

// Composes and inverts poses within 4095 units, and goes back.
static void test_poses(random_state *random) {
  worst composed = {"pose compose", 1, 0, ""}, inverted = {"pose invert", 1, 0, ""};
  worst back = {"pose composed with its inverse", 2, 0, ""};
  unsigned long changed = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    const gjk_pose a = {random_within(random, GJK_RADIUS_MAX), random_unit(random)};
    const gjk_pose b = {random_within(random, GJK_RADIUS_MAX), random_unit(random)};
    gjk_pose ab, inverse, into_a = a, into_b = b;
    CHECK(gjk_pose_compose(&a, &b, &ab) == GJK_OK);
    CHECK(gjk_pose_invert(&a, &inverse) == GJK_OK);
    gjk_quat product, conjugate;
    gjk_quat_compose(&a.rotation, &b.rotation, &product);
    gjk_quat_invert(&a.rotation, &conjugate);
    changed += !same_quat(&product, &ab.rotation) || !same_quat(&conjugate, &inverse.rotation);
    gjk_pose_compose(&into_a, &b, &into_a);
    gjk_pose_compose(&a, &into_b, &into_b);
    changed += !same_pose(&into_a, &ab) || !same_pose(&into_b, &ab);

    const real3 p = real_vec3(&a.position), opposite = {-p.x, -p.y, -p.z};
    const real3 turned = real_apply(real_quat_of(&a.rotation), real_vec3(&b.position));
    const real3 moved = {p.x + turned.x, p.y + turned.y, p.z + turned.z};
    if (worse_vec3(&composed, &ab.position, moved)) {
      NOTE(&composed, "trial %d", i);
    }
    if (worse_vec3(&inverted, &inverse.position, real_apply(real_quat_of(&conjugate), opposite))) {
      NOTE(&inverted, "trial %d", i);
    }
    const real3 origin = {0, 0, 0};
    CHECK(gjk_pose_compose(&a, &inverse, &into_a) == GJK_OK);
    if (worse_vec3(&back, &into_a.position, origin)) {
      NOTE(&back, "trial %d", i);
    }
    gjk_pose in_place = a;
    gjk_pose_invert(&in_place, &in_place);
    changed += !same_pose(&in_place, &inverse);
  }
  check_worst(&composed);
  check_worst(&inverted);
  check_worst(&back);
  CHECK_MSG(changed == 0, "%lu of %d", changed, ITERATIONS);
}

// Which way rotations turn, and which of two composed poses comes first.
static void test_directions(void) {
  const gjk_angle quarter = GJK_ANGLE(1.5707963267948966);
  const gjk_vec3 x = {GJK_Q16_ONE, 0, 0}, y = {0, GJK_Q16_ONE, 0}, z = {0, 0, GJK_Q16_ONE};
  gjk_quat about_x, about_y, about_z, both, euler;
  gjk_vec3 turned;
  gjk_quat_from_axis_angle(&x, quarter, &about_x);
  gjk_quat_from_axis_angle(&y, quarter, &about_y);
  gjk_quat_from_axis_angle(&z, quarter, &about_z);
  CHECK(gjk_quat_apply(&about_x, &y, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &z));
  CHECK(gjk_quat_apply(&about_y, &z, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &x));
  CHECK(gjk_quat_apply(&about_z, &x, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &y));
  // First about x, then about z: y goes to z, and stays there.
  CHECK(gjk_quat_compose(&about_z, &about_x, &both) == GJK_OK);
  CHECK(gjk_quat_apply(&both, &y, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &z));
  CHECK(gjk_quat_from_euler(quarter, 0, quarter, &euler) == GJK_OK);
  CHECK(gjk_quat_apply(&euler, &y, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &z));
  CHECK(gjk_quat_from_euler(quarter, quarter, 0, &euler) == GJK_OK);
  CHECK(gjk_quat_apply(&euler, &y, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &x));
  // First b, which turns about z; then a, which moves along x.
  const gjk_pose a = {{GJK_Q16_ONE, 0, 0}, {0, 0, 0, ONE}}, b = {{0, GJK_Q16_ONE, 0}, about_z};
  gjk_pose ab;
  const gjk_vec3 expected = {GJK_Q16_ONE, 2 * GJK_Q16_ONE, 0};
  CHECK(gjk_pose_compose(&a, &b, &ab) == GJK_OK);
  CHECK(gjk_pose_apply(&ab, &x, &turned) == GJK_OK);
  CHECK(same_vec3(&turned, &expected));
}

// The identity and the half turns about the axes are exact, on any vector.
static void test_exact(random_state *random) {
  const gjk_quat identity = {0, 0, 0, ONE}, turn_z = {0, 0, -ONE, 0};
  const gjk_vec3 up = {0, 0, -7};
  gjk_quat q;
  CHECK(gjk_quat_from_axis_angle(&up, 0, &q) == GJK_OK);
  CHECK(same_quat(&q, &identity));
  CHECK(gjk_quat_from_euler(0, 0, 0, &q) == GJK_OK);
  CHECK(same_quat(&q, &identity));
  CHECK(gjk_quat_compose(&turn_z, &identity, &q) == GJK_OK);
  CHECK(same_quat(&q, &turn_z));
  const gjk_quat along[4] = {{INT32_MIN, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -3, 0}, {0, 0, 0, INT32_MAX}};
  const gjk_quat units[4] = {{-ONE, 0, 0, 0}, {0, ONE, 0, 0}, {0, 0, -ONE, 0}, {0, 0, 0, ONE}};
  for (int i = 0; i < 4; i++) {
    CHECK_MSG(gjk_quat_normalize(&along[i], &q) == GJK_OK, "%d", i);
    CHECK_MSG(same_quat(&q, &units[i]), "%d", i);
  }
  const gjk_quat corner = {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
  const gjk_quat diagonal = {-ONE / 2, -ONE / 2, -ONE / 2, -ONE / 2};
  CHECK(gjk_quat_normalize(&corner, &q) == GJK_OK);
  CHECK(same_quat(&q, &diagonal));
  for (int i = 0; i < 1000; i++) {
    const gjk_vec3 v = random_vec3(random);
    gjk_vec3 same;
    CHECK(gjk_quat_apply(&identity, &v, &same) == GJK_OK);
    CHECK(same_vec3(&same, &v));
    if (v.x != INT32_MIN && v.y != INT32_MIN) {
      const gjk_vec3 half_turned = {-v.x, -v.y, v.z};
      CHECK(gjk_quat_apply(&turn_z, &v, &same) == GJK_OK);
      CHECK(same_vec3(&same, &half_turned));
    }
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  test_directions();
  test_exact(&random);
  test_axis_angle(&random);
  test_euler(&random);
  test_sine(&random);
  test_normalize(&random);
  test_compose(&random);
  test_apply(&random, "apply, up to 4095 units", GJK_RADIUS_MAX, 1);
  test_apply(&random, "apply, up to 8192 units", 8192 * GJK_Q16_ONE, 1);
  test_apply(&random, "apply, any vector", 0, 4);
  test_poses(&random);
  return check_done("pose");
}
