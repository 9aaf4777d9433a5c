// Makes the arm, its obstacles and edges.
#include "arm_bench.h"

#include "arm/seven.h"

#define PROOFS 2000

static seven machine;
static random_state numbers;
static int32_t from[SEVEN_JOINTS], to[SEVEN_JOINTS];
static gjk_arm_proof proof[PROOFS];
static unsigned proof_count;

static const gjk_arm_setup first = {0, 64, GJK_Q30_ONE / 1024}, any = {0, 64, GJK_Q30_ONE};

bool arm_bench_make(void) {
  const gjk_pose base = GJK_POSE_IDENTITY;
  numbers = random_seed(5);
  return seven_make(&machine, &base);
}

bool arm_bench_same_bits(void) {
  uint64_t hash;
  return seven_hash(&machine, &hash) && hash == SEVEN_HASH;
}

bool arm_bench_choose(unsigned number) {
  bool near = true, made = number % 4 != 0 || seven_surround(&machine, &numbers, 10 + random_below(&numbers, 11));
  for (unsigned tries = 0; made && near && tries < 200; tries++) {
    seven_any(&numbers, from);
    made = gjk_arm_near(&machine.arm, from, 100, &near, NULL) == GJK_OK;
  }
  seven_beside(&numbers, from, 65536, to);
  return made;
}

bool arm_bench_edge(bool planner, gjk_arm_edge_result *out) {
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

bool arm_bench_certify(unsigned *proofs) {
  gjk_arm_edge_result result;
  proof_count = 0;
  const bool done = gjk_arm_edge_start(&machine.arm, from, to, &any, take, NULL) == GJK_OK &&
                    gjk_arm_edge_run(&machine.arm, 1000000, &result) == GJK_OK;
  *proofs = proof_count;
  return done && proof_count <= PROOFS;
}

bool arm_bench_check(const gjk_arm_edge_result *result) {
  return gjk_check_edge(&machine.arm, from, to, &any, result, proof, proof_count) == GJK_OK;
}

bool arm_bench_near(void) {
  bool near;
  return gjk_arm_near(&machine.arm, from, 1, &near, NULL) == GJK_OK && !near;
}

bool arm_bench_distance(void) {
  gjk_arm_distance_result result;
  return gjk_arm_distance(&machine.arm, from, GJK_DISTANCE_MAX, &result) == GJK_OK;
}
