// The hash of ground in the plane: the platform game of tests/programs/examples, and queries of all kinds of ground.
#ifndef GROUND_GOLDEN_H
#define GROUND_GOLDEN_H

#include <stdint.h>

#define GROUND_GOLDEN_HASH UINT64_C(0x98a6c2fc30944eda)

uint64_t ground_golden_hash(void);

#endif
