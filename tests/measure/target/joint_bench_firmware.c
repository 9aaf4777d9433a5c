// Counts the instructions of an arm's poses on an emulated board: means of 16 poses of the arm, one line per task.
#include "count.h"
#include "joint_bench.h"
#include "print.h"

#define POSES 16

int firmware_main(void) {
  static const char *const names[JOINT_BENCH_TASKS] = {
      "poses composed one by one", "poses as a chain",       "poses as a chain of rotations",
      "posing colliders",          "distances of colliders", "plane: composed one by one",
      "plane: as a chain"};
  static uint32_t sum[JOINT_BENCH_TASKS];
  const uint32_t calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  for (unsigned number = 0; number < POSES; number++) {
    if (!joint_bench_make(number)) {
      return 1;
    }
    for (unsigned task = 0; task < JOINT_BENCH_TASKS; task++) {
      const uint32_t start = board_ticks();
      if (!joint_bench_run((joint_bench_task)task)) {
        return 1;
      }
      sum[task] += count_instructions(board_ticks() - start, calibration);
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
