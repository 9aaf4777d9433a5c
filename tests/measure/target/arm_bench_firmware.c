// Counts the instructions and the stack of an arm's edges on an emulated board.
#include "arm_bench.h"

#include "count.h"
#include "paint.h"
#include "print.h"

typedef struct tally {
  uint32_t sum, most;
  unsigned count;
} tally;

static uint32_t calibration, deepest;

static void add(tally *t, uint32_t instructions) {
  t->sum += instructions / 16;  // so that the sum fits
  t->most = instructions > t->most ? instructions : t->most;
  t->count++;
}

static void print(const char *what, const tally *t) {
  print_decimal(board_print, t->count > 0 ? t->sum / t->count * 16 : 0);
  board_print(" instructions, at most ");
  print_decimal(board_print, t->most);
  board_print(": ");
  board_print(what);
  board_print(", ");
  print_decimal(board_print, t->count);
  board_print("\n");
}

// Runs one of the tasks below, and counts.
static bool run(int task, gjk_arm_edge_result *result, tally *into) {
  const uintptr_t top = paint_stack();
  const uint32_t start = board_ticks();
  unsigned proofs;
  const bool done = task == 0   ? arm_bench_edge(true, result)
                    : task == 1 ? arm_bench_edge(false, result)
                    : task == 2 ? arm_bench_near()
                    : task == 3 ? arm_bench_distance()
                    : task == 4 ? arm_bench_certify(&proofs)
                                : arm_bench_check(result);
  add(into, count_instructions(board_ticks() - start, calibration));
  const uint32_t depth = painted_depth(top);
  deepest = depth > deepest ? depth : deepest;
  return done;
}

int firmware_main(void) {
  static tally planner[3], first[3], still[2], certified, checked;
  if (!arm_bench_same_bits()) {
    board_print("other bits than on the host\n");
    return 1;
  }
  calibration = count_calibrate();
  if (calibration == 0 || !arm_bench_make()) {
    board_print("the counter does not count instructions, or there is no arm\n");
    return 1;
  }
  for (unsigned i = 0; i < ARM_BENCH_EDGES; i++) {
    gjk_arm_edge_result any, exact;
    tally once = {0, 0, 0}, twice = {0, 0, 0};
    if (!arm_bench_choose(i) || !run(0, &any, &once) || !run(1, &exact, &twice) || !run(2, &any, &still[0]) ||
        !run(3, &any, &still[1]) || !run(4, &any, &certified) || !run(5, &any, &checked)) {
      board_print("a call failed\n");
      return 1;
    }
    add(&planner[any.answer], once.most);
    add(&first[exact.answer], twice.most);
  }
  print("edges that are free", &planner[GJK_ARM_FREE]);
  print("edges that touch, any touch will do", &planner[GJK_ARM_TOUCH]);
  print("edges that touch, to 2^-10 of the edge", &first[GJK_ARM_TOUCH]);
  print("near, at a configuration", &still[0]);
  print("least distance, at a configuration", &still[1]);
  print("edges with certificate", &certified);
  print("checks of the certificate", &checked);
  print_decimal(board_print, deepest);
  board_print(" bytes of stack; RAM per link ");
  print_decimal(board_print, (uint32_t)sizeof(gjk_arm_link_room));
  board_print(", part ");
  print_decimal(board_print, (uint32_t)sizeof(gjk_arm_part_room));
  board_print(", pair ");
  print_decimal(board_print, (uint32_t)sizeof(gjk_arm_pair));
  board_print("\n");
  return 0;
}
