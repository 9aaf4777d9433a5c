// The joints of the scene's arm.
#include "arm.h"

const arm_body arm_bodies[ARM_BODIES] = {
    {"arm-turret", 0, 23594},         {"arm-upper", 1, GJK_Q16(0.46)},     {"arm-fore", 2, GJK_Q16(0.43)},
    {"arm-wrist", 4, GJK_Q16(-0.08)}, {"gripper-palm", 4, GJK_Q16(-0.19)},
};

// How far along z of the frame before each joint is, what it turns about, and by which angle: -12, 30, 85.5, -115.5 and 12
// degrees.
static const gjk_q16 along[ARM_JOINTS] = {0, GJK_Q16(0.62), GJK_Q16(0.92), GJK_Q16(0.86), 0};
static const gjk_vec3 axis[ARM_JOINTS] = {{0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}};
static const gjk_angle angle[ARM_JOINTS] = {GJK_ANGLE(-0.20943951), GJK_ANGLE(0.52359878), GJK_ANGLE(1.49225651),
                                            GJK_ANGLE(-2.01585529), GJK_ANGLE(0.20943951)};

static gjk_pose fixed_pose(unsigned joint) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.z = along[joint];
  return pose;
}

bool arm_make(gjk_joint joints[ARM_JOINTS]) {
  bool good = true;
  for (unsigned i = 0; i < ARM_JOINTS; i++) {
    const gjk_pose fixed = fixed_pose(i);
    good = gjk_joint_init(&joints[i], &fixed, &axis[i]) == GJK_OK && good;
  }
  return good;
}

bool arm_frames(const gjk_joint joints[ARM_JOINTS], gjk_pose out[ARM_JOINTS]) {
  const gjk_pose base = GJK_POSE_IDENTITY;
  return gjk_joints_from_angles(joints, ARM_JOINTS, &base, angle, out) == GJK_OK;
}

bool arm_frames_composed(gjk_pose out[ARM_JOINTS]) {
  gjk_pose before = GJK_POSE_IDENTITY;
  bool good = true;
  for (unsigned i = 0; i < ARM_JOINTS; i++) {
    const gjk_pose fixed = fixed_pose(i);
    gjk_pose turn = GJK_POSE_IDENTITY, still;
    good = gjk_quat_from_axis_angle(&axis[i], angle[i], &turn.rotation) == GJK_OK &&
           gjk_pose_compose(&before, &fixed, &still) == GJK_OK && gjk_pose_compose(&still, &turn, &out[i]) == GJK_OK &&
           good;
    before = out[i];
  }
  return good;
}

static bool is_near(int32_t a, int32_t b) {
  return a - b <= 2 && b - a <= 2;
}

bool arm_frames_near(const gjk_pose a[ARM_JOINTS], const gjk_pose b[ARM_JOINTS]) {
  bool all = true;
  for (unsigned i = 0; i < ARM_JOINTS; i++) {
    all = is_near(a[i].position.x, b[i].position.x) && is_near(a[i].position.y, b[i].position.y) &&
          is_near(a[i].position.z, b[i].position.z) && all;
  }
  return all;
}
