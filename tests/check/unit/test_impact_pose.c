// Poses on the way of a motion, against the motion in long double.
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/impact.h"
#include "reference/random_shape.h"
#include "reference/real_quat.h"

#define SEED 90210
#define MOTIONS 20000
#define PI_LONG 3.14159265358979323846264338327950288L

// What a rotation may be off by, radians. A long double of 53 bits counts many turns less exactly than the library.
#define ANGLE_ERROR (1.0L / (1 << 26))

// The angle between two rotations.
static long double angle_between(real_quat a, real_quat b) {
  const real_quat back = {-b.x, -b.y, -b.z, b.w}, rest = real_quat_product(a, back);
  const long double sine = sqrtl(rest.x * rest.x + rest.y * rest.y + rest.z * rest.z);
  return 2 * atan2l(sine, fabsl(rest.w));
}

// Half of the angle over the whole way, and its axis; w: the cosine of half an arc.
static real_quat whole_way(const gjk_motion *m, long double *half) {
  real_quat axis = {m->spin.x, m->spin.y, m->spin.z, 0};
  long double size = sqrtl(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  *half = size / 131072;
  if (size == 0) {
    real_quat back = real_quat_of(&m->from.rotation);
    back.x = -back.x;
    back.y = -back.y;
    back.z = -back.z;
    axis = real_quat_product(real_quat_of(&m->to.rotation), back);
    if (axis.w < 0) {
      axis.x = -axis.x;
      axis.y = -axis.y;
      axis.z = -axis.z;
      axis.w = -axis.w;
    }
    size = sqrtl(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    *half = atan2l(size, axis.w);
  }
  if (size > 0) {
    axis.x /= size;
    axis.y /= size;
    axis.z /= size;
  }
  return axis;
}

static real_quat rotation_at(const gjk_motion *m, gjk_q30 fraction) {
  long double half;
  const real_quat axis = whole_way(m, &half);
  const long double angle = fmodl(half * fraction / GJK_Q30_ONE, 2 * PI_LONG), sine = sinl(angle);
  const real_quat turned = {axis.x * sine, axis.y * sine, axis.z * sine, cosl(angle)};
  return real_quat_product(turned, real_quat_of(&m->from.rotation));
}

static bool near_coordinate(gjk_q16 from, gjk_q16 to, gjk_q30 fraction, gjk_q16 at) {
  const long double real = from + ((long double)to - from) * fraction / GJK_Q30_ONE;
  return fabsl(real - at) <= 0.5L;
}

static void show(const void *subject) {
  const gjk_motion *m = (const gjk_motion *)subject;
  printf("from %d %d %d %d to %d %d %d %d spin %d %d %d\n", (int)m->from.rotation.x, (int)m->from.rotation.y,
         (int)m->from.rotation.z, (int)m->from.rotation.w, (int)m->to.rotation.x, (int)m->to.rotation.y,
         (int)m->to.rotation.z, (int)m->to.rotation.w, (int)m->spin.x, (int)m->spin.y, (int)m->spin.z);
}

static gjk_vec3 any_position(random_state *random) {
  const unsigned down = random_below(random, 32);
  return (gjk_vec3){(gjk_q16)(random_range(random, INT32_MIN, INT32_MAX) >> down),
                    (gjk_q16)(random_range(random, INT32_MIN, INT32_MAX) >> down),
                    (gjk_q16)(random_range(random, INT32_MIN, INT32_MAX) >> down)};
}

// A rotation that differs from q by a few LSB, by any part of a turn, or by nearly half a turn.
static gjk_quat other_rotation(random_state *random, const gjk_quat *q) {
  gjk_quat turned = random_rotation(random), near_half = {0, 0, 0, 0};
  if (random_below(random, 3) == 0) {
    turned = *q;
    turned.x += random_range(random, -3000, 3000) >> random_below(random, 12);
    turned.y += random_range(random, -3000, 3000) >> random_below(random, 12);
    turned.z += random_range(random, -3000, 3000) >> random_below(random, 12);
  } else if (random_below(random, 4) == 0) {
    near_half.x = GJK_Q30_ONE;
    near_half.w = random_range(random, -20, 20);
    (void)gjk_quat_compose(&near_half, q, &turned);
  }
  return turned;
}

// Is the arc so nearly half a turn that either way round is as short?
static bool is_either_way(const gjk_motion *m) {
  long double half;
  return (m->spin.x | m->spin.y | m->spin.z) == 0 && whole_way(m, &half).w < 4.0L / GJK_Q30_ONE;
}

static long double worst;

static void check_motion(random_state *random, const gjk_motion *m) {
  gjk_pose pose;
  const bool spins = (m->spin.x | m->spin.y | m->spin.z) != 0;
  CHECK(gjk_motion_pose(m, 0, &pose) == GJK_OK && memcmp(&pose, &m->from, sizeof pose) == 0);
  CHECK(gjk_motion_pose(m, GJK_Q30_ONE, &pose) == GJK_OK);
  CHECK(memcmp(&pose.position, &m->to.position, sizeof pose.position) == 0);
  CHECK(spins || memcmp(&pose, &m->to, sizeof pose) == 0);
  for (int i = 0; i < 4; i++) {
    const gjk_q30 fraction = random_range(random, 0, GJK_Q30_ONE) >> (i == 0 ? random_below(random, 31) : 0);
    CHECK(gjk_motion_pose(m, fraction, &pose) == GJK_OK);
    CHECK(near_coordinate(m->from.position.x, m->to.position.x, fraction, pose.position.x) &&
          near_coordinate(m->from.position.y, m->to.position.y, fraction, pose.position.y) &&
          near_coordinate(m->from.position.z, m->to.position.z, fraction, pose.position.z));
    const long double off = angle_between(real_quat_of(&pose.rotation), rotation_at(m, fraction));
    worst = off > worst ? off : worst;
    CHECK_MSG(off < ANGLE_ERROR, "off by %.2Lf 2^-30 at %d", off * GJK_Q30_ONE, (int)fraction);
  }
}

// Arcs of a few LSB: half way round, a real_quat is half of what it becomes, to within its error.
static void check_small_arcs(void) {
  for (int k = -64; k <= 64; k++) {
    gjk_motion m = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
    gjk_pose pose;
    m.to.rotation.x = k;
    m.to.rotation.z = -k;
    CHECK(gjk_motion_pose(&m, GJK_Q30_ONE / 2, &pose) == GJK_OK);
    const gjk_quat *q = &pose.rotation;
    CHECK(abs(2 * (int)q->x - k) <= 15 && abs(2 * (int)q->z + k) <= 15 && q->y == 0 && GJK_Q30_ONE - q->w <= 1);
  }
}

static void check_statuses(void) {
  gjk_motion m = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  gjk_pose pose, before;
  memset(&pose, 0x5A, sizeof pose);
  before = pose;
  CHECK(gjk_motion_pose(NULL, 0, &pose) == GJK_ERROR_NULL);
  CHECK(gjk_motion_pose(&m, 0, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_motion_pose(&m, -1, &pose) == GJK_ERROR_RANGE);
  CHECK(gjk_motion_pose(&m, GJK_Q30_ONE + 1, &pose) == GJK_ERROR_RANGE);
  m.to.rotation.w = 0;
  CHECK(gjk_motion_pose(&m, 0, &pose) == GJK_ERROR_ROTATION);
  m.spin.x = 1;  // to's rotation is not read
  CHECK(memcmp(&pose, &before, sizeof pose) == 0);
  CHECK(gjk_motion_pose(&m, GJK_Q30_ONE, &pose) == GJK_OK);
  pose = before;
  m.from.rotation.w = 1;
  CHECK(gjk_motion_pose(&m, 0, &pose) == GJK_ERROR_ROTATION && memcmp(&pose, &before, sizeof pose) == 0);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  const unsigned long motions = check_trials(MOTIONS);
  unsigned long either = 0;
  gjk_motion m;
  for (unsigned long i = 0; i < motions; i++) {
    check_trial(i, show, &m);
    m.from.position = any_position(&random);
    m.to.position = any_position(&random);
    m.from.rotation = random_rotation(&random);
    m.to.rotation = other_rotation(&random, &m.from.rotation);
    m.spin.x = m.spin.y = m.spin.z = 0;
    if (i % 2 == 0) {
      m.spin = any_position(&random);
    }
    if (is_either_way(&m)) {
      either++;
    } else {
      check_motion(&random, &m);
    }
  }
  CHECK(either * 10 < motions);
  check_trial(motions, NULL, NULL);
  check_small_arcs();
  check_statuses();
  printf("rotations off by at most %.2Lf 2^-30\n", worst * GJK_Q30_ONE);
  return check_done("impact poses");
}
