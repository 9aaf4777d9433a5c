// Vectors, rotations and chains of joints of the plane against real arithmetic: every rounding, every end of a range.
#include <math.h>

#include "gjk2/joint.h"
#include "gjk2/math.h"

#include "check.h"
#include "random.h"

#define TRIALS 100000
#define ONE 1073741824.0L
__extension__ typedef __int128 wide;

static long double worst[6];

// Notes an error, and holds it to its limit.
static void note(int which, long double error, long double limit) {
  worst[which] = fmaxl(worst[which], error);
  CHECK_MSG(error <= limit, "%d: %Lf", which, error);
}

static int32_t any_number(random_state *random) {
  static const int32_t special[] = {0, 1, -1, 65536, -65536, INT32_MAX, INT32_MIN, INT32_MIN + 1, 32768, -32768};
  if (random_below(random, 8) == 0) {
    return special[random_below(random, sizeof special / sizeof special[0])];
  }
  return (int32_t)random_u32(random) >> random_below(random, 32);
}

static gjk2_vec any_vector(random_state *random) {
  return (gjk2_vec){any_number(random), any_number(random)};
}

static int64_t within(wide x, int64_t low, int64_t high) {
  return x < low ? low : x > high ? high : (int64_t)x;
}

// (2 root - 1)^2 <= 4 squared <= (2 root + 1)^2
static bool is_root(int64_t root, wide squared) {
  return (root == 0 || (wide)(2 * root - 1) * (2 * root - 1) <= 4 * squared) &&
         4 * squared <= (wide)(2 * root + 1) * (2 * root + 1);
}

static void check_vectors(const gjk2_vec *a, const gjk2_vec *b, gjk_q16 s) {
  const gjk2_vec sum = gjk2_vec_add(a, b), difference = gjk2_vec_subtract(a, b), scaled = gjk2_vec_scale(a, s);
  CHECK(sum.x == within((wide)a->x + b->x, INT32_MIN, INT32_MAX) &&
        sum.y == within((wide)a->y + b->y, INT32_MIN, INT32_MAX));
  CHECK(difference.x == within((wide)a->x - b->x, INT32_MIN, INT32_MAX) &&
        difference.y == within((wide)a->y - b->y, INT32_MIN, INT32_MAX));
  CHECK(scaled.x == gjk_q16_multiply(a->x, s) && scaled.y == gjk_q16_multiply(a->y, s));
  const wide dot = (wide)a->x * b->x + (wide)a->y * b->y, cross = (wide)a->x * b->y - (wide)a->y * b->x;
  CHECK(gjk2_vec_dot(a, b) == within(dot, INT64_MIN, INT64_MAX));
  CHECK(gjk2_vec_cross(a, b) == within(cross, INT64_MIN, INT64_MAX));
  CHECK(is_root(gjk2_vec_length(a), (wide)a->x * a->x + (wide)a->y * a->y));
}

static unsigned long opposite;

static void check_directions(random_state *random, const gjk2_vec *a, const gjk2_vec *any) {
  gjk2_vec b = *any;
  if (random_below(random, 3) == 0) {  // opposite, or nearly
    b.x = -(a->x / 2) + random_range(random, -1, 1);
    b.y = -(a->y / 2) + random_range(random, -1, 1);
  }
  const long double na = hypotl(a->x, a->y), nb = hypotl(b.x, b.y);
  gjk2_unit unit = {7, 7};
  gjk2_rotation turn = {7, 7};
  CHECK((gjk2_vec_normalize(a, &unit) == GJK_OK) == (na > 0));
  CHECK((gjk2_rotation_between(a, &b, &turn) == GJK_OK) == (na > 0 && nb > 0));
  if (na == 0) {
    CHECK(unit.x == 7 && unit.y == 7);
  } else {
    note(0, fmaxl(fabsl(a->x / na * ONE - unit.x), fabsl(a->y / na * ONE - unit.y)), 0.501L);
  }
  if (na == 0 || nb == 0) {
    CHECK(turn.c == 7 && turn.s == 7 && gjk2_vec_angle(a, &b) == 0);
    return;
  }
  const long double dot = (long double)a->x * b.x + (long double)a->y * b.y;
  const wide exact_cross = (wide)a->x * b.y - (wide)a->y * b.x;
  const long double cross = (long double)exact_cross;
  note(1, fmaxl(fabsl(dot / na / nb * ONE - turn.c), fabsl(cross / na / nb * ONE - turn.s)), 2.5L);
  opposite += dot < -0.999999L * na * nb;
  // -pi and pi are one angle.
  const long double off = fabsl(atan2l(cross, dot) * 65536 - gjk2_vec_angle(a, &b)), circle = 411774.841L;
  note(2, fminl(off, fabsl(off - circle)), 0.501L);
}

static void check_segments(random_state *random) {
  gjk2_vec p = any_vector(random), q = any_vector(random);
  if (random_below(random, 2) == 0) {
    p.x /= 8, p.y /= 8, q.x /= 8, q.y /= 8;
  }
  gjk2_pose pose = {{5, 5}, {5, 5}};
  gjk_q16 half = 5;
  const wide x = (wide)q.x - p.x, y = (wide)q.y - p.y;
  const gjk_status status = gjk2_pose_between(&p, &q, &pose, &half);
  if (status == GJK_ERROR_RANGE) {
    CHECK(hypotl((long double)x, (long double)y) / 2 > 2147483646.0L && half == 5 && pose.position.x == 5 &&
          pose.rotation.c == 5);
    return;
  }
  CHECK(status == GJK_OK && fabsl(hypotl((long double)x, (long double)y) / 2 - half) <= 1.5L);
  if (half < INT32_C(1) << 30) {
    CHECK(half == 0 || (wide)(2 * (int64_t)half - 1) * (2 * (int64_t)half - 1) <= x * x + y * y);
    CHECK(x * x + y * y <= (wide)(2 * (int64_t)half + 1) * (2 * (int64_t)half + 1));
  }
  if (half <= GJK2_RADIUS_MAX) {
    const long double n = hypotl(pose.rotation.c, pose.rotation.s);
    const long double ex = pose.position.x + half * (pose.rotation.c / n),
                      ey = pose.position.y + half * (pose.rotation.s / n);
    note(3, fmaxl(fabsl(ex - q.x), fabsl(ey - q.y)), 1.5L);
    note(3, fmaxl(fabsl(2.0L * pose.position.x - ex - p.x), fabsl(2.0L * pose.position.y - ey - p.y)), 1.5L);
  }
}

// A rotation within the tolerance, mostly not a unit.
static gjk2_rotation any_rotation(random_state *random) {
  gjk2_rotation unit = {GJK_Q30_ONE, 0};
  (void)gjk2_rotation_from_angle(any_number(random), &unit);
  const long double scale = 1 + random_range(random, -8000, 8000) / ONE;
  return (gjk2_rotation){(gjk_q30)(unit.c * scale), (gjk_q30)(unit.s * scale)};
}

static struct {
  gjk2_pose fixed[GJK2_JOINTS_MAX], out[GJK2_JOINTS_MAX], base;
  gjk_angle angle[GJK2_JOINTS_MAX];
  gjk2_joint joint[GJK2_JOINTS_MAX];
} arm;

static void check_chain(random_state *random, unsigned count, unsigned bits) {
  const int32_t most = (int32_t)((UINT32_C(1) << bits) - 1);
  arm.base.position.x = random_range(random, -most, most);
  arm.base.position.y = random_range(random, -most, most);
  arm.base.rotation = any_rotation(random);
  for (unsigned i = 0; i < count; i++) {
    arm.fixed[i].position.x = random_range(random, -most, most);
    arm.fixed[i].position.y = random_range(random, -most, most);
    arm.fixed[i].rotation = any_rotation(random);
    arm.angle[i] = any_number(random);
    CHECK(gjk2_joint_init(&arm.joint[i], &arm.fixed[i]) == GJK_OK);
    const long double length = hypotl(arm.fixed[i].position.x, arm.fixed[i].position.y);
    CHECK(arm.joint[i].reach >= length * (1 + 1 / 65536.0L) && arm.joint[i].reach <= length * (1 + 1 / 65536.0L) + 3);
  }
  CHECK(gjk2_joints_from_angles(arm.joint, count, &arm.base, arm.angle, arm.out) == GJK_OK);
  long double angle = atan2l(arm.base.rotation.s, arm.base.rotation.c), x = arm.base.position.x,
              y = arm.base.position.y;
  long double lever = 0;
  for (unsigned i = 0; i < count; i++) {
    const gjk2_vec *v = &arm.fixed[i].position;
    x += cosl(angle) * v->x - sinl(angle) * v->y;
    y += sinl(angle) * v->x + cosl(angle) * v->y;
    lever += (i + 1) * hypotl(v->x, v->y);
    angle += atan2l(arm.fixed[i].rotation.s, arm.fixed[i].rotation.c) + arm.angle[i] / 65536.0L;
    const gjk2_rotation *r = &arm.out[i].rotation;
    const long double n = hypotl(r->c, r->s);
    note(4, fabsl(r->s / n * cosl(angle) - r->c / n * sinl(angle)) * 134217728 / (i + 2), 1);
    const long double off = fmaxl(fabsl(arm.out[i].position.x - x), fabsl(arm.out[i].position.y - y));
    note(5, fmaxl(0, off - 0.51L) * 134217728 / fmaxl(1, lever), 1);
    gjk2_rotation back;
    CHECK(gjk2_rotation_invert(r, &back) == GJK_OK);  // a unit within the tolerance
  }
}

static void check_integration(void) {
  gjk2_rotation r = {GJK_Q30_ONE, 0};
  for (int i = 0; i < 1000; i++) {
    CHECK(gjk2_rotation_integrate(&r, GJK_Q16_ONE, GJK_Q30(0.001), &r) == GJK_OK);
  }
  const long double angle = 1000 * (long double)GJK_Q30(0.001) / ONE;
  CHECK(fabsl(r.s / ONE - sinl(angle)) < 1e-6L && fabsl(r.c / ONE - cosl(angle)) < 1e-6L);
  const gjk2_rotation before = r, bent = {GJK_Q30_ONE, GJK_Q30_ONE};
  CHECK(gjk2_rotation_integrate(&r, 0, GJK_Q30_ONE, &r) == GJK_OK && r.c == before.c && r.s == before.s);
  CHECK(gjk2_rotation_integrate(&r, 5, GJK_Q30_ONE + 1, &r) == GJK_ERROR_RANGE && r.s == before.s);
  CHECK(gjk2_rotation_integrate(&r, 5, -1, &r) == GJK_ERROR_RANGE);
  CHECK(gjk2_rotation_integrate(&bent, 5, 0, &r) == GJK_ERROR_ROTATION && r.s == before.s);
  CHECK(gjk2_rotation_integrate(NULL, 5, 0, &r) == GJK_ERROR_NULL &&
        gjk2_rotation_integrate(&r, 5, 0, NULL) == GJK_ERROR_NULL);
}

static void check_statuses(void) {
  const gjk2_vec a = {1, 2}, low = {INT32_MIN, INT32_MIN}, high = {INT32_MAX, INT32_MAX};
  const gjk2_pose mark = {{1, 2}, {3, 4}};
  gjk2_pose still = GJK2_POSE_IDENTITY, bent = {{0, 0}, {GJK_Q30_ONE, GJK_Q30_ONE}}, out[2] = {mark, mark};
  gjk2_unit unit;
  gjk2_rotation turn;
  gjk_q16 half;
  gjk2_joint joint[2] = {{{9, 9}, 9, {9, 9}}, {{9, 9}, 9, {9, 9}}};
  const gjk_angle angle[2] = {1, 2};
  CHECK(gjk2_vec_dot(&low, &low) == INT64_MAX && gjk2_vec_dot(&low, &high) < -INT64_MAX / 2);
  CHECK(gjk2_vec_normalize(NULL, &unit) == GJK_ERROR_NULL && gjk2_vec_normalize(&a, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_rotation_between(NULL, &a, &turn) == GJK_ERROR_NULL &&
        gjk2_rotation_between(&a, &a, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_between(&a, NULL, out, &half) == GJK_ERROR_NULL &&
        gjk2_pose_between(&a, &a, out, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_pose_between(&low, &high, out, &half) == GJK_ERROR_RANGE && out[0].position.y == 2);
  CHECK(gjk2_pose_between(&high, &high, out, &half) == GJK_OK && half == 0 && out[0].rotation.c == GJK_Q30_ONE &&
        out[0].position.x == INT32_MAX);
  out[0] = mark;
  CHECK(gjk2_joint_init(NULL, &still) == GJK_ERROR_NULL && gjk2_joint_init(joint, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_joint_init(joint, &bent) == GJK_ERROR_ROTATION && joint[0].reach == 9 && joint[0].offset.y == 9);
  still.position.x = 1000000;
  CHECK(gjk2_joint_init(&joint[0], &still) == GJK_OK && gjk2_joint_init(&joint[1], &still) == GJK_OK);
  CHECK(gjk2_joints_from_angles(NULL, 2, &still, angle, out) == GJK_ERROR_NULL);
  CHECK(gjk2_joints_from_angles(joint, 2, NULL, angle, out) == GJK_ERROR_NULL);
  CHECK(gjk2_joints_from_angles(joint, 2, &still, NULL, out) == GJK_ERROR_NULL);
  CHECK(gjk2_joints_from_angles(joint, 2, &still, angle, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_joints_from_angles(joint, 2, &bent, angle, out) == GJK_ERROR_ROTATION);
  CHECK(gjk2_joints_from_angles(joint, GJK2_JOINTS_MAX + 1, &still, angle, out) == GJK_ERROR_RANGE);
  still.position.y = -(gjk_q16)(INT32_MAX - joint[0].reach - joint[1].reach) - 1;
  CHECK(gjk2_joints_from_angles(joint, 2, &still, angle, out) == GJK_ERROR_RANGE);
  CHECK(out[0].position.x == 1 && out[0].rotation.s == 4 && out[1].position.y == 2);
  still.position.y++;
  CHECK(gjk2_joints_from_angles(joint, 2, &still, angle, out) == GJK_OK && out[1].position.y != 2);
  CHECK(gjk2_joints_from_angles(joint, 0, &still, angle, out) == GJK_OK);
}

int main(void) {
  random_state random = random_seed(check_seed(2029));
  check_statuses();
  check_integration();
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    const gjk2_vec a = any_vector(&random), b = any_vector(&random);
    check_vectors(&a, &b, any_number(&random));
    check_directions(&random, &a, &b);
    check_segments(&random);
    if (i % 20 == 0) {
      check_chain(&random, 1 + random_below(&random, 24), 1 + random_below(&random, 25));
    }
  }
  check_chain(&random, GJK2_JOINTS_MAX, 18);
  CHECK(opposite > TRIALS / 20);
  printf(
      "worst: unit %.4Lf LSB, rotation between %.2Lf, angle %.4Lf, ends of segments %.2Lf; of what is stated, joints' "
      "rotations %.2Lf, positions %.2Lf\n",
      worst[0], worst[1], worst[2], worst[3], worst[4], worst[5]);
  return check_done("plane math");
}
