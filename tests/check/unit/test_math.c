// Vectors and rotations for users against real arithmetic in long double: every rounding, every end of a range.
#include <math.h>

#include "gjk/impact.h"
#include "gjk/math.h"

#include "check.h"
#include "random.h"

#define TRIALS 200000

static const double ONE_Q30 = 1073741824.0;

// Numbers of every size, and the ends of the range.
static int32_t any_number(random_state *random) {
  static const int32_t special[] = {0, 1, -1, 65536, -65536, INT32_MAX, INT32_MIN, INT32_MIN + 1, 32768, -32768};
  if (random_below(random, 8) == 0) {
    return special[random_below(random, sizeof special / sizeof special[0])];
  }
  return (int32_t)random_u32(random) >> random_below(random, 32);
}

static gjk_vec3 any_vector(random_state *random) {
  return (gjk_vec3){any_number(random), any_number(random), any_number(random)};
}

static int64_t within(long double x, int64_t low, int64_t high) {
  return x <= (long double)low ? low : x >= (long double)high ? high : (int64_t)x;
}

static void check_vectors(random_state *random) {
  const gjk_vec3 a = any_vector(random), b = any_vector(random);
  const gjk_q16 s = any_number(random);
  const gjk_vec3 sum = gjk_vec3_add(&a, &b), difference = gjk_vec3_subtract(&a, &b), scaled = gjk_vec3_scale(&a, s);
  CHECK(sum.x == within((long double)a.x + b.x, INT32_MIN, INT32_MAX));
  CHECK(sum.z == within((long double)a.z + b.z, INT32_MIN, INT32_MAX));
  CHECK(difference.y == within((long double)a.y - b.y, INT32_MIN, INT32_MAX));
  CHECK(scaled.x == gjk_q16_multiply(a.x, s) && scaled.y == gjk_q16_multiply(a.y, s) &&
        scaled.z == gjk_q16_multiply(a.z, s));

  __extension__ typedef __int128 wide;
  const wide dot = (wide)a.x * b.x + (wide)a.y * b.y + (wide)a.z * b.z;
  CHECK(gjk_vec3_dot(&a, &b) == (dot > INT64_MAX ? INT64_MAX : dot < INT64_MIN ? INT64_MIN : (int64_t)dot));

  const gjk_vec3 cross = gjk_vec3_cross(&a, &b);
  const wide z = (((wide)a.x * b.y - (wide)a.y * b.x) + 32768) >> 16;
  const wide x = (((wide)a.y * b.z - (wide)a.z * b.y) + 32768) >> 16;
  CHECK(cross.z == (z > INT32_MAX ? INT32_MAX : z < INT32_MIN ? INT32_MIN : (int32_t)z));
  CHECK(cross.x == (x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (int32_t)x));

  const wide length = gjk_vec3_length(&a), squared = 4 * ((wide)a.x * a.x + (wide)a.y * a.y + (wide)a.z * a.z);
  CHECK((length == 0 || (2 * length - 1) * (2 * length - 1) <= squared) &&
        squared <= (2 * length + 1) * (2 * length + 1));
}

static long double norm(const long double v[3]) {
  return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// v rotated by q, which is taken for q / |q|.
static void turn(const gjk_quat *q, const long double v[3], long double out[3]) {
  const long double x = q->x, y = q->y, z = q->z, w = q->w, s = 2 / (x * x + y * y + z * z + w * w);
  const long double along = x * v[0] + y * v[1] + z * v[2], side = x * x + y * y + z * z;
  const long double c[3] = {y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]}, p[3] = {x, y, z};
  for (int i = 0; i < 3; i++) {
    out[i] = v[i] + s * (w * c[i] + along * p[i] - side * v[i]);
  }
}

// A vector near the opposite of from, or near from, or any.
static gjk_vec3 other_direction(random_state *random, const gjk_vec3 *from) {
  const unsigned kind = random_below(random, 4);
  if (kind > 1) {
    return any_vector(random);
  }
  const int32_t sign = kind == 0 ? -1 : 1, noise = random_below(random, 2) == 0 ? 0 : 3;
  return (gjk_vec3){sign * (from->x / 2) + random_range(random, -noise, noise),
                    sign * (from->y / 2) + random_range(random, -noise, noise),
                    sign * (from->z / 2) + random_range(random, -noise, noise)};
}

static long double worst_angle;

static void check_angle(random_state *random) {
  const gjk_vec3 a = any_vector(random), b = other_direction(random, &a);
  const long double u[3] = {a.x, a.y, a.z}, v[3] = {b.x, b.y, b.z};
  const long double c[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const long double exact = norm(u) == 0 || norm(v) == 0 ? 0 : atan2l(norm(c), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
  const long double off = fabsl(exact * 65536 - gjk_vec3_angle(&a, &b));
  worst_angle = fmaxl(worst_angle, off);
  CHECK(off <= 0.501L);
}

static long double worst_aim;
static unsigned long opposite, beside, half_turns;

// Of opposite directions: the axis is the coordinate axis that u points along least, turned until it is across u. So
// its coordinate there is sqrt(1 - u_least^2 / |u|^2), which is at least sqrt(2 / 3), and no other one is as large.
static void check_half_turn(const long double u[3], const gjk_quat *q) {
  const long double axis[3] = {q->x, q->y, q->z};
  long double found = 0, least = fminl(fabsl(u[0]), fminl(fabsl(u[1]), fabsl(u[2])));
  for (int i = 0; i < 3; i++) {
    found = fabsl(u[i]) == least ? fmaxl(found, fabsl(axis[i])) : found;
  }
  CHECK(fabsl(found - sqrtl(1 - least * least / (norm(u) * norm(u))) * ONE_Q30) <= 12 && q->w == 0);
  half_turns++;
}

static void check_aim(random_state *random) {
  const gjk_vec3 from = any_vector(random), to = other_direction(random, &from);
  gjk_quat q = {7, 7, 7, 7};
  const long double u[3] = {from.x, from.y, from.z}, v[3] = {to.x, to.y, to.z};
  const long double lu = norm(u), lv = norm(v);
  if (lu == 0 || lv == 0) {
    CHECK(gjk_quat_between(&from, &to, &q) == GJK_ERROR_ROTATION && q.x == 7 && q.w == 7);
    return;
  }
  CHECK(gjk_quat_between(&from, &to, &q) == GJK_OK);
  long double turned[3];
  turn(&q, u, turned);
  for (int i = 0; i < 3; i++) {
    const long double off = fabsl(turned[i] / lu - v[i] / lv) * ONE_Q30;
    worst_aim = fmaxl(worst_aim, off);
    CHECK(off <= 12);
  }
  // The shortest: the axis is across both.
  const long double cosine = (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / (lu * lv);
  CHECK(fabsl((u[0] * q.x + u[1] * q.y + u[2] * q.z) / lu) <= 4 && q.w >= 0);
  if (cosine < 0 && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0]) {
    check_half_turn(u, &q);
  }
  opposite += cosine < -0.999999L;
  beside += cosine > 0.999999L;
}

static long double worst_end;

static void check_segments(random_state *random) {
  gjk_vec3 p = any_vector(random), q = any_vector(random);
  if (random_below(random, 2) == 0) {
    p.x /= 8, p.y /= 8, p.z /= 8, q.x /= 8, q.y /= 8, q.z /= 8;
  }
  gjk_pose pose = {{5, 5, 5}, {5, 5, 5, 5}};
  gjk_q16 half = 5;
  const long double way[3] = {(long double)q.x - p.x, (long double)q.y - p.y, (long double)q.z - p.z};
  const gjk_status status = gjk_pose_between(&p, &q, &pose, &half);
  if (status == GJK_ERROR_RANGE) {
    CHECK(norm(way) / 2 > 2147483646.0L && half == 5 && pose.position.x == 5 && pose.rotation.w == 5);
    return;
  }
  CHECK(status == GJK_OK && fabsl(norm(way) / 2 - half) <= 1.5L);
  if (half < INT32_C(1) << 30) {  // to the nearest: (2 half - 1)^2 <= |way|^2 <= (2 half + 1)^2
    __extension__ typedef __int128 wide;
    const wide x = (wide)q.x - p.x, y = (wide)q.y - p.y, z = (wide)q.z - p.z, squared = x * x + y * y + z * z;
    CHECK((half == 0 || (wide)(2 * (int64_t)half - 1) * (2 * (int64_t)half - 1) <= squared) &&
          squared <= (wide)(2 * (int64_t)half + 1) * (2 * (int64_t)half + 1));
  }
  const long double up[3] = {0, 0, half};
  long double end[3];
  turn(&pose.rotation, up, end);
  if (half <= GJK_RADIUS_MAX) {
    const long double off = fmaxl(fmaxl(fabsl(pose.position.x + end[0] - q.x), fabsl(pose.position.y + end[1] - q.y)),
                                  fabsl(pose.position.z + end[2] - q.z));
    worst_end = fmaxl(worst_end, off);
    CHECK(off <= 2);
  }
}

// A turn of 1 radian a unit of time in steps of a 1/1000: no drift but that of rounding.
static void check_integration(void) {
  const gjk_vec3 velocity = {0, 0, GJK_Q16_ONE}, none = {0, 0, 0};
  gjk_quat q = {0, 0, 0, GJK_Q30_ONE};
  for (int i = 0; i < 1000; i++) {
    CHECK(gjk_quat_integrate(&q, &velocity, GJK_Q30(0.001), &q) == GJK_OK);
  }
  const long double angle = 1000 * (long double)GJK_Q30(0.001) / ONE_Q30;
  CHECK(fabsl(q.z / ONE_Q30 - sinl(angle / 2)) < 1e-6L && fabsl(q.w / ONE_Q30 - cosl(angle / 2)) < 1e-6L);
  const gjk_quat before = q;
  CHECK(gjk_quat_integrate(&q, &none, GJK_Q30_ONE, &q) == GJK_OK && q.x == before.x && q.z == before.z);
  CHECK(gjk_quat_integrate(&q, &velocity, GJK_Q30_ONE + 1, &q) == GJK_ERROR_RANGE && q.z == before.z);
  CHECK(gjk_quat_integrate(&q, &velocity, -1, &q) == GJK_ERROR_RANGE);
  CHECK(gjk_quat_integrate(NULL, &velocity, 0, &q) == GJK_ERROR_NULL);
  CHECK(gjk_quat_integrate(&q, NULL, 0, &q) == GJK_ERROR_NULL &&
        gjk_quat_integrate(&q, &velocity, 0, NULL) == GJK_ERROR_NULL);
  const gjk_quat no_unit = {GJK_Q30_ONE, GJK_Q30_ONE, 0, 0};
  CHECK(gjk_quat_integrate(&no_unit, &velocity, GJK_Q30_ONE, &q) == GJK_ERROR_ROTATION && q.z == before.z);
}

static void check_ends(void) {
  const gjk_vec3 low = {INT32_MIN, INT32_MIN, INT32_MIN}, high = {INT32_MAX, INT32_MAX, INT32_MAX}, zero = {0, 0, 0};
  gjk_unit3 unit = {7, 7, 7};
  gjk_pose pose;
  gjk_q16 half;
  CHECK(gjk_vec3_dot(&low, &low) == INT64_MAX && gjk_vec3_dot(&low, &high) == INT64_MIN);
  CHECK(gjk_vec3_length(&low) == UINT32_C(3719550787) && gjk_vec3_length(&zero) == 0);
  CHECK(gjk_vec3_normalize(&zero, &unit) == GJK_ERROR_ROTATION && unit.x == 7);
  CHECK(gjk_vec3_normalize(NULL, &unit) == GJK_ERROR_NULL && gjk_vec3_normalize(&low, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_vec3_normalize(&low, &unit) == GJK_OK && unit.x == unit.z && unit.x == -619925131);
  CHECK(gjk_vec3_angle(&low, &high) == GJK_ANGLE(3.14159265358979) && gjk_vec3_angle(&low, &zero) == 0 &&
        gjk_vec3_angle(&zero, &low) == 0 && gjk_vec3_angle(&low, &low) == 0);
  CHECK(gjk_pose_between(&low, &high, &pose, &half) == GJK_ERROR_RANGE);
  CHECK(gjk_pose_between(&high, &high, &pose, &half) == GJK_OK && half == 0 && pose.rotation.w == GJK_Q30_ONE &&
        pose.position.x == INT32_MAX);
  CHECK(gjk_pose_between(&low, NULL, &pose, &half) == GJK_ERROR_NULL);
  CHECK(gjk_pose_between(NULL, &low, &pose, &half) == GJK_ERROR_NULL);
  CHECK(gjk_pose_between(&low, &high, NULL, &half) == GJK_ERROR_NULL &&
        gjk_pose_between(&low, &high, &pose, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_quat_between(NULL, &high, &pose.rotation) == GJK_ERROR_NULL &&
        gjk_quat_between(&low, NULL, &pose.rotation) == GJK_ERROR_NULL);
  CHECK(gjk_quat_between(&low, &high, NULL) == GJK_ERROR_NULL);
}

int main(void) {
  random_state random = random_seed(check_seed(2026));
  check_ends();
  check_integration();
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    check_vectors(&random);
    check_angle(&random);
    check_aim(&random);
    check_segments(&random);
  }
  CHECK(opposite > TRIALS / 20 && beside > TRIALS / 20 && half_turns > TRIALS / 100);
  printf("worst: angle %.4Lf LSB, aim %.2Lf, ends of segments %.2Lf\n", worst_angle, worst_aim, worst_end);
  return check_done("math");
}
