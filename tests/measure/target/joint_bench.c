// Firmware: instructions of an arm's poses, means of 16 poses, one line per task. The arm has six links, in space and in the
// plane; its joints are composed one by one, or as a chain.
#include "count.h"
#include "gjk/collider.h"
#include "gjk/distance.h"
#include "gjk/joint.h"
#include "gjk2/joint.h"
#include "random.h"

#define JOINT_BENCH_JOINTS 6

typedef enum joint_bench_task {
  JOINT_BENCH_COMPOSED,  // by gjk_quat_from_axis_angle and two gjk_pose_compose a joint
  JOINT_BENCH_ANGLES,
  JOINT_BENCH_ROTATIONS,
  JOINT_BENCH_POSED,     // colliders of the links at these poses
  JOINT_BENCH_DISTANCE,  // of each to a crate
  JOINT_BENCH_COMPOSED2,
  JOINT_BENCH_ANGLES2,
  JOINT_BENCH_TASKS
} joint_bench_task;
#define POSES 16

static const gjk_shape link = GJK_CAPSULE(GJK_Q16(0.06), GJK_Q16(0.2));
static const gjk_shape crate = GJK_BOX(GJK_Q16(0.3), GJK_Q16(0.3), GJK_Q16(0.3));

static struct {
  gjk_pose fixed[JOINT_BENCH_JOINTS], base, composed[JOINT_BENCH_JOINTS], chain[JOINT_BENCH_JOINTS];
  gjk2_pose fixed2[JOINT_BENCH_JOINTS], base2, composed2[JOINT_BENCH_JOINTS], chain2[JOINT_BENCH_JOINTS];
  gjk_vec3 axis[JOINT_BENCH_JOINTS];
  gjk_quat rotation[JOINT_BENCH_JOINTS];
  gjk_angle angle[JOINT_BENCH_JOINTS];
  gjk_joint joint[JOINT_BENCH_JOINTS];
  gjk2_joint joint2[JOINT_BENCH_JOINTS];
  gjk_collider links[JOINT_BENCH_JOINTS], crate;
} arm;

// Makes the arms, and angles from a number.
COUNTED bool make(unsigned number) {
  random_state random = random_seed(number);
  static const gjk_vec3 axes[3] = {{0, 0, 1}, {0, 1, 0}, {0, 1, 0}};
  const gjk_vec3 across = {1, 0, 0};
  const gjk_pose still = GJK_POSE_IDENTITY, far = {{GJK_Q16(1.5), 0, GJK_Q16(0.5)}, {0, 0, 0, GJK_Q30_ONE}};
  const gjk2_pose still2 = GJK2_POSE_IDENTITY;
  bool good = gjk_collider_init(&arm.crate, &crate, NULL, 0) == GJK_OK && gjk_collider_pose(&arm.crate, &far) == GJK_OK;
  arm.base = still;
  arm.base2 = still2;
  for (unsigned i = 0; i < JOINT_BENCH_JOINTS; i++) {
    arm.fixed[i] = still;
    arm.fixed[i].position.z = GJK_Q16(0.4);
    arm.fixed2[i] = still2;
    arm.fixed2[i].position.x = GJK_Q16(0.4);
    arm.axis[i] = axes[i % 3];
    arm.angle[i] = random_range(&random, GJK_ANGLE(-1.5), GJK_ANGLE(1.5));
    good = gjk_quat_from_axis_angle(&across, GJK_ANGLE(0.1), &arm.fixed[i].rotation) == GJK_OK &&
           gjk_quat_from_axis_angle(&arm.axis[i], arm.angle[i], &arm.rotation[i]) == GJK_OK &&
           gjk_joint_init(&arm.joint[i], &arm.fixed[i], &arm.axis[i]) == GJK_OK &&
           gjk2_rotation_from_angle(GJK_ANGLE(0.1), &arm.fixed2[i].rotation) == GJK_OK &&
           gjk2_joint_init(&arm.joint2[i], &arm.fixed2[i]) == GJK_OK &&
           gjk_collider_init(&arm.links[i], &link, NULL, 0) == GJK_OK && good;
  }
  return good;
}

static bool compose(void) {
  bool good = true;
  for (unsigned i = 0; i < JOINT_BENCH_JOINTS; i++) {
    gjk_pose turn = GJK_POSE_IDENTITY, frame;
    good = gjk_quat_from_axis_angle(&arm.axis[i], arm.angle[i], &turn.rotation) == GJK_OK &&
           gjk_pose_compose(i == 0 ? &arm.base : &arm.composed[i - 1], &arm.fixed[i], &frame) == GJK_OK &&
           gjk_pose_compose(&frame, &turn, &arm.composed[i]) == GJK_OK && good;
  }
  return good;
}

static bool compose_plane(void) {
  bool good = true;
  for (unsigned i = 0; i < JOINT_BENCH_JOINTS; i++) {
    gjk2_pose turn = GJK2_POSE_IDENTITY, frame;
    good = gjk2_rotation_from_angle(arm.angle[i], &turn.rotation) == GJK_OK &&
           gjk2_pose_compose(i == 0 ? &arm.base2 : &arm.composed2[i - 1], &arm.fixed2[i], &frame) == GJK_OK &&
           gjk2_pose_compose(&frame, &turn, &arm.composed2[i]) == GJK_OK && good;
  }
  return good;
}

static bool pose_links(void) {
  bool good = true;
  for (unsigned i = 0; i < JOINT_BENCH_JOINTS; i++) {
    good = gjk_collider_pose(&arm.links[i], &arm.chain[i]) == GJK_OK && good;
  }
  return good;
}

static bool ask(void) {
  bool good = true;
  gjk_distance_result result;
  for (unsigned i = 0; i < JOINT_BENCH_JOINTS; i++) {
    good = gjk_distance(&arm.links[i], &arm.crate, NULL, &result) == GJK_OK && good;
  }
  return good;
}

// False: a call failed.
COUNTED bool run(joint_bench_task task) {
  switch (task) {
    case JOINT_BENCH_COMPOSED: return compose();
    case JOINT_BENCH_ANGLES:
      return gjk_joints_from_angles(arm.joint, JOINT_BENCH_JOINTS, &arm.base, arm.angle, arm.chain) == GJK_OK;
    case JOINT_BENCH_ROTATIONS:
      return gjk_joints_from_rotations(arm.joint, JOINT_BENCH_JOINTS, &arm.base, arm.rotation, arm.chain) == GJK_OK;
    case JOINT_BENCH_POSED: return pose_links();
    case JOINT_BENCH_DISTANCE: return ask();
    case JOINT_BENCH_COMPOSED2: return compose_plane();
    default:
      return gjk2_joints_from_angles(arm.joint2, JOINT_BENCH_JOINTS, &arm.base2, arm.angle, arm.chain2) == GJK_OK;
  }
}

int firmware_main(void) {
  static const char *const names[JOINT_BENCH_TASKS] = {
      "poses composed one by one", "poses as a chain",       "poses as a chain of rotations",
      "posing colliders",          "distances of colliders", "plane: composed one by one",
      "plane: as a chain"};
  static uint32_t sum[JOINT_BENCH_TASKS];
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned number = 0; number < POSES; number++) {
    if (!make(number)) {
      return 1;
    }
    for (unsigned task = 0; task < JOINT_BENCH_TASKS; task++) {
      const uint32_t start = board_ticks();
      if (!run((joint_bench_task)task)) {
        return 1;
      }
      sum[task] += count_since(start);
    }
  }
  board_print("an arm of ");
  print_decimal(board_print, JOINT_BENCH_JOINTS);
  board_print(" links, instructions a link\n");
  for (unsigned task = 0; task < JOINT_BENCH_TASKS; task++) {
    print_decimal(board_print, sum[task] / (POSES * JOINT_BENCH_JOINTS));
    board_print("  ");
    board_print(names[task]);
    board_print("\n");
  }
  return 0;
}
