// An arm's poses, and what to count of them.
#ifndef JOINT_BENCH_H
#define JOINT_BENCH_H

#include "gjk/collider.h"
#include "gjk2/pose.h"

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

// Makes the arms, and angles from a number.
bool joint_bench_make(unsigned number);

// False: a call failed.
bool joint_bench_run(joint_bench_task task);

// The arm in space, composed or as a chain: as left by the last run.
const gjk_pose *joint_bench_poses(bool chain);

#endif
