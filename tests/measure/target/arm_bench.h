// Edges of 1 radian of an arm of seven joints with ten hulls of 48 points, among 10 to 20 obstacles.
#ifndef ARM_BENCH_H
#define ARM_BENCH_H

#include "gjk/arm.h"

#define ARM_BENCH_EDGES 60

// False: a call failed.
bool arm_bench_make(void);

// Are the answers to some edges the same bits as on the host?
bool arm_bench_same_bits(void);

// Chooses edge number: it begins free. False: a call failed.
bool arm_bench_choose(unsigned number);

// Answers the edge; with a setup for planners, any touch will do. False: a call failed.
bool arm_bench_edge(bool planner, gjk_arm_edge_result *out);

// Checks the answer by its certificate, of which there is room for so many proofs. proofs: how many there are.
bool arm_bench_certify(unsigned *proofs);
bool arm_bench_check(const gjk_arm_edge_result *result);

// Whether a pair is within 1 LSB where the edge begins; the least distance there.
bool arm_bench_near(void);
bool arm_bench_distance(void);

#endif
