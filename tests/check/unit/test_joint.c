// Chains of joints against real arithmetic in long double: errors of every joint, long chains, ends of ranges, statuses.
#include <math.h>

#include "gjk/joint.h"

#include "check.h"
#include "random_vec.h"
#include "reference/real_quat.h"

#define TRIALS 4000
#define MOST 24
#define ONE 1073741824.0L

static real_quat about(const gjk_vec3 *axis, gjk_angle angle) {
  const long double n =
      sqrtl((long double)axis->x * axis->x + (long double)axis->y * axis->y + (long double)axis->z * axis->z);
  const long double half = angle / 131072.0L, s = sinl(half) / n;
  return (real_quat){axis->x * s, axis->y * s, axis->z * s, cosl(half)};
}

// *origin += v turned by q.
static void move(long double origin[3], real_quat q, const gjk_vec3 *v) {
  const real_quat point = {v->x, v->y, v->z, 0}, back = {-q.x, -q.y, -q.z, q.w};
  const real_quat turned = real_quat_product(real_quat_product(q, point), back);
  origin[0] += turned.x;
  origin[1] += turned.y;
  origin[2] += turned.z;
}

// The angle between a rotation and the real one, radians.
static long double turn_between(const gjk_quat *q, real_quat r) {
  const real_quat back = {-r.x, -r.y, -r.z, r.w}, rest = real_quat_product(real_quat_of(q), back);
  return 2 * asinl(fminl(1, sqrtl(rest.x * rest.x + rest.y * rest.y + rest.z * rest.z)));
}

static struct {
  gjk_pose fixed[GJK_JOINTS_MAX], out[GJK_JOINTS_MAX], base;
  gjk_vec3 axis[GJK_JOINTS_MAX];
  gjk_angle angle[GJK_JOINTS_MAX];
  gjk_quat rotation[GJK_JOINTS_MAX];
  gjk_joint joint[GJK_JOINTS_MAX];
} arm;

static gjk_vec3 any_vector(random_state *random, unsigned bits) {
  return random_in_cube(random, (int32_t)((UINT32_C(1) << bits) - 1));
}

// A rotation within the tolerance, mostly not a unit.
static gjk_quat any_rotation(random_state *random) {
  gjk_quat q = {0, 0, 0, GJK_Q30_ONE};
  const gjk_vec3 axis = any_vector(random, 30);
  (void)gjk_quat_from_axis_angle(&axis, (gjk_angle)random_u32(random), &q);
  const long double scale = 1 + random_range(random, -8000, 8000) / ONE;
  return (gjk_quat){(gjk_q30)(q.x * scale), (gjk_q30)(q.y * scale), (gjk_q30)(q.z * scale), (gjk_q30)(q.w * scale)};
}

static void make_arm(random_state *random, unsigned count, unsigned bits) {
  arm.base.position = any_vector(random, bits);
  arm.base.rotation = any_rotation(random);
  for (unsigned i = 0; i < count; i++) {
    const gjk_vec3 none = {0, 0, 0}, z = {0, 0, 1};
    const bool default_axis = random_below(random, 4) == 0;
    arm.fixed[i].position = random_below(random, 4) == 0 ? none : any_vector(random, bits);
    arm.fixed[i].rotation = any_rotation(random);
    arm.axis[i] = default_axis ? z : any_vector(random, 1 + random_below(random, 31));
    if ((arm.axis[i].x | arm.axis[i].y | arm.axis[i].z) == 0) {
      arm.axis[i].y = INT32_MIN;
    }
    arm.angle[i] = (gjk_angle)random_u32(random) >> random_below(random, 20);
    arm.rotation[i] = any_rotation(random);
    CHECK(gjk_joint_init(&arm.joint[i], &arm.fixed[i], default_axis ? NULL : &arm.axis[i]) == GJK_OK);
    const gjk_vec3 *offset = &arm.fixed[i].position;
    const long double length = hypotl(hypotl(offset->x, offset->y), offset->z);
    CHECK(arm.joint[i].reach >= length * (1 + 1 / 65536.0L) && arm.joint[i].reach <= length * (1 + 1 / 65536.0L) + 3);
  }
}

static long double worst_turn, worst_place;

// Holds the poses of the chain to what gjk/joint.h states.
static void check_arm(unsigned count, bool balls) {
  real_quat q = real_quat_of(&arm.base.rotation);
  const gjk_vec3 *p = &arm.base.position;
  long double origin[3] = {p->x, p->y, p->z}, lever = 0;
  for (unsigned i = 0; i < count; i++) {
    const gjk_vec3 *v = &arm.fixed[i].position;
    move(origin, q, v);
    lever += (i + 1) * sqrtl((long double)v->x * v->x + (long double)v->y * v->y + (long double)v->z * v->z);
    q = real_quat_product(real_quat_product(q, real_quat_of(&arm.fixed[i].rotation)),
                          balls ? real_quat_of(&arm.rotation[i]) : about(&arm.axis[i], arm.angle[i]));
    const long double turn = turn_between(&arm.out[i].rotation, q) * 67108864 / (i + 2);
    worst_turn = fmaxl(worst_turn, turn);
    CHECK(turn < 1);
    const gjk_vec3 *at = &arm.out[i].position;
    const long double off = fmaxl(fmaxl(fabsl(at->x - origin[0]), fabsl(at->y - origin[1])), fabsl(at->z - origin[2]));
    const long double part = fmaxl(0, off - 0.51L) * 67108864 / fmaxl(1, lever);
    worst_place = fmaxl(worst_place, part);
    CHECK(part <= 1);
    gjk_vec3 x = {1, 0, 0}, turned;
    CHECK(gjk_quat_apply(&arm.out[i].rotation, &x, &turned) == GJK_OK);  // a unit within the tolerance
  }
}

static void check_chains(random_state *random, unsigned count, unsigned bits) {
  make_arm(random, count, bits);
  CHECK(gjk_joints_from_angles(arm.joint, count, &arm.base, arm.angle, arm.out) == GJK_OK);
  check_arm(count, false);
  CHECK(gjk_joints_from_rotations(arm.joint, count, &arm.base, arm.rotation, arm.out) == GJK_OK);
  check_arm(count, true);
}

static bool same(const gjk_pose *a, const gjk_pose *b) {
  return a->position.x == b->position.x && a->position.y == b->position.y && a->position.z == b->position.z &&
         a->rotation.x == b->rotation.x && a->rotation.y == b->rotation.y && a->rotation.z == b->rotation.z &&
         a->rotation.w == b->rotation.w;
}

static void check_statuses(random_state *random) {
  const gjk_pose mark = {{1, 2, 3}, {4, 5, 6, 7}};
  gjk_pose still = GJK_POSE_IDENTITY, bent = GJK_POSE_IDENTITY;
  const gjk_vec3 none = {0, 0, 0};
  gjk_joint joint = {{9, 9, 9}, 9, {9, 9, 9, 9}, {9, 9, 9, 9}};
  bent.rotation.x = 40000000;
  CHECK(gjk_joint_init(NULL, &still, NULL) == GJK_ERROR_NULL && gjk_joint_init(&joint, NULL, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_joint_init(&joint, &bent, NULL) == GJK_ERROR_ROTATION);
  CHECK(gjk_joint_init(&joint, &still, &none) == GJK_ERROR_ROTATION);
  CHECK(joint.reach == 9 && joint.offset.x == 9 && joint.still.w == 9 && joint.quarter.x == 9);
  make_arm(random, 3, 20);
  arm.out[0] = arm.out[1] = arm.out[2] = mark;
  const gjk_quat good = arm.rotation[2];
  arm.rotation[2] = bent.rotation;
  CHECK(gjk_joints_from_rotations(arm.joint, 3, &arm.base, arm.rotation, arm.out) == GJK_ERROR_ROTATION);
  CHECK(gjk_joints_from_rotations(arm.joint, 3, &bent, arm.rotation, arm.out) == GJK_ERROR_ROTATION);
  CHECK(gjk_joints_from_angles(arm.joint, 3, &bent, arm.angle, arm.out) == GJK_ERROR_ROTATION);
  CHECK(gjk_joints_from_angles(NULL, 3, &still, arm.angle, arm.out) == GJK_ERROR_NULL);
  CHECK(gjk_joints_from_angles(arm.joint, 3, NULL, arm.angle, arm.out) == GJK_ERROR_NULL);
  CHECK(gjk_joints_from_angles(arm.joint, 3, &still, NULL, arm.out) == GJK_ERROR_NULL);
  CHECK(gjk_joints_from_angles(arm.joint, 3, &still, arm.angle, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_joints_from_rotations(arm.joint, 3, &still, NULL, arm.out) == GJK_ERROR_NULL);
  CHECK(gjk_joints_from_angles(arm.joint, GJK_JOINTS_MAX + 1, &still, arm.angle, arm.out) == GJK_ERROR_RANGE);
  // The reach of the chain and its base, to the LSB.
  const uint32_t reach = arm.joint[0].reach + arm.joint[1].reach + arm.joint[2].reach;
  still.position.y = -(gjk_q16)(INT32_MAX - reach) - 1;
  CHECK(gjk_joints_from_angles(arm.joint, 3, &still, arm.angle, arm.out) == GJK_ERROR_RANGE);
  CHECK(same(&arm.out[0], &mark) && same(&arm.out[2], &mark));
  still.position.y++;
  CHECK(gjk_joints_from_angles(arm.joint, 3, &still, arm.angle, arm.out) == GJK_OK && !same(&arm.out[2], &mark));
  still.position.y = INT32_MIN;
  CHECK(gjk_joints_from_angles(arm.joint, 3, &still, arm.angle, arm.out) == GJK_ERROR_RANGE);
  CHECK(gjk_joints_from_angles(arm.joint, 0, &arm.base, arm.angle, arm.out) == GJK_OK);
  // The base may be one of out.
  arm.rotation[2] = good;
  gjk_pose apart[3];
  CHECK(gjk_joints_from_rotations(arm.joint, 3, &arm.base, arm.rotation, apart) == GJK_OK);
  arm.out[2] = arm.base;
  CHECK(gjk_joints_from_rotations(arm.joint, 3, &arm.out[2], arm.rotation, arm.out) == GJK_OK);
  CHECK(same(&arm.out[0], &apart[0]) && same(&arm.out[2], &apart[2]));
}

// Offsets that reach the ends of int32: the longest that there may be, in a line and bent.
static void check_far(random_state *random) {
  const gjk_vec3 z = {0, 0, 1};
  const gjk_pose still = GJK_POSE_IDENTITY;
  arm.base = still;
  for (unsigned i = 0; i < 2; i++) {
    arm.fixed[i] = still;
    arm.fixed[i].position.x = INT32_C(1073709000);
    arm.axis[i] = z;
    CHECK(gjk_joint_init(&arm.joint[i], &arm.fixed[i], NULL) == GJK_OK);
  }
  for (unsigned i = 0; i < 1000; i++) {
    arm.base.rotation = any_rotation(random);
    arm.angle[0] = i == 0 ? 0 : (gjk_angle)random_u32(random);
    arm.angle[1] = (gjk_angle)random_u32(random);
    CHECK(gjk_joints_from_angles(arm.joint, 2, &arm.base, arm.angle, arm.out) == GJK_OK);
    check_arm(2, false);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(2028));
  check_statuses(&random);
  check_far(&random);
  for (unsigned long i = 0; i < TRIALS; i++) {
    check_trial(i, NULL, NULL);
    check_chains(&random, 1 + random_below(&random, MOST), 1 + random_below(&random, 25));
  }
  for (unsigned i = 0; i < 3; i++) {
    check_chains(&random, GJK_JOINTS_MAX, 18);
  }
  printf("worst: rotations %.2Lf of what is stated, positions %.2Lf\n", worst_turn, worst_place);
  return check_done("joints");
}
