// Firmware: instructions and stack of an arm's edges of 1 radian: seven joints with ten hulls of 48 points, among 10 to 20
// obstacles.
#include "arm/seven.h"
#include "count.h"
#include "gjk/arm.h"
#include "paint.h"

#define EDGES 60
#define PROOFS 2000

static seven machine;
static random_state numbers;
static int32_t from[SEVEN_JOINTS], to[SEVEN_JOINTS];
static gjk_arm_proof proof[PROOFS];
static unsigned proof_count;

static const gjk_arm_setup first = {0, 64, GJK_Q30_ONE / 1024}, any = {0, 64, GJK_Q30_ONE};

// Chooses edge number: it begins free. False: a call failed.
COUNTED bool choose(unsigned number) {
  bool near = true, made = number % 4 != 0 || seven_surround(&machine, &numbers, 10 + random_below(&numbers, 11));
  for (unsigned tries = 0; made && near && tries < 200; tries++) {
    seven_any(&numbers, from);
    made = gjk_arm_near(&machine.arm, from, 100, &near, NULL) == GJK_OK;
  }
  seven_beside(&numbers, from, 65536, to);
  return made;
}

// Answers the edge; with a setup for planners, any touch will do. False: a call failed.
COUNTED bool answer_edge(bool planner, gjk_arm_edge_result *out) {
  return gjk_arm_edge_start(&machine.arm, from, to, planner ? &any : &first, NULL, NULL) == GJK_OK &&
         gjk_arm_edge_run(&machine.arm, 1000000, out) == GJK_OK;
}

static void take(void *user, const gjk_arm_proof *taken) {
  (void)user;
  if (proof_count < PROOFS) {
    proof[proof_count] = *taken;
  }
  proof_count++;
}

COUNTED bool certify(void) {
  gjk_arm_edge_result result;
  proof_count = 0;
  const bool done = gjk_arm_edge_start(&machine.arm, from, to, &any, take, NULL) == GJK_OK &&
                    gjk_arm_edge_run(&machine.arm, 1000000, &result) == GJK_OK;
  return done && proof_count <= PROOFS;
}

COUNTED bool check(const gjk_arm_edge_result *result) {
  return gjk_check_edge(&machine.arm, from, to, &any, result, proof, proof_count) == GJK_OK;
}

// Whether a pair is within 1 LSB where the edge begins; the least distance there.
COUNTED bool is_near(void) {
  bool near;
  return gjk_arm_near(&machine.arm, from, 1, &near, NULL) == GJK_OK && !near;
}

COUNTED bool least_distance(void) {
  gjk_arm_distance_result result;
  return gjk_arm_distance(&machine.arm, from, GJK_DISTANCE_MAX, &result) == GJK_OK;
}

static uint32_t deepest;

// In sixteenths, so that the sum fits.
static void add(count_tally *t, uint32_t instructions) {
  const uint32_t worst = instructions > t->worst ? instructions : t->worst;
  count_add(t, instructions / 16);
  t->worst = worst;
}

static void print(const char *what, const count_tally *t) {
  print_decimal(board_print, t->calls > 0 ? t->sum / t->calls * 16 : 0);
  board_print(" instructions, at most ");
  print_decimal(board_print, t->worst);
  board_print(": ");
  board_print(what);
  board_print(", ");
  print_decimal(board_print, t->calls);
  board_print("\n");
}

// Runs one of the tasks below, and counts.
static bool run(int task, gjk_arm_edge_result *result, count_tally *into) {
  const uintptr_t top = paint_stack();
  const uint32_t start = board_ticks();
  const bool done = task == 0   ? answer_edge(true, result)
                    : task == 1 ? answer_edge(false, result)
                    : task == 2 ? is_near()
                    : task == 3 ? least_distance()
                    : task == 4 ? certify()
                                : check(result);
  add(into, count_since(start));
  const uint32_t depth = painted_depth(top);
  deepest = depth > deepest ? depth : deepest;
  return done;
}

int firmware_main(void) {
  static count_tally planner[3], first[3], still[2], certified, checked;
  const gjk_pose base = GJK_POSE_IDENTITY;
  uint64_t hash;
  if (!seven_hash(&machine, &hash) || hash != SEVEN_HASH) {
    board_print("other bits than on the host\n");
    return 1;
  }
  numbers = random_seed(5);
  if (!count_prepare() || !seven_make(&machine, &base)) {
    return 1;
  }
  for (unsigned i = 0; i < EDGES; i++) {
    gjk_arm_edge_result any, exact;
    count_tally once = {0, 0, 0}, twice = {0, 0, 0};
    if (!choose(i) || !run(0, &any, &once) || !run(1, &exact, &twice) || !run(2, &any, &still[0]) ||
        !run(3, &any, &still[1]) || !run(4, &any, &certified) || !run(5, &any, &checked)) {
      board_print("a call failed\n");
      return 1;
    }
    add(&planner[any.answer], once.worst);
    add(&first[exact.answer], twice.worst);
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
