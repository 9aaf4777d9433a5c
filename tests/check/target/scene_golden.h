// One hash over a long match in a scene, through saves and rollbacks. It is the same on every target.
#ifndef SCENE_GOLDEN_H
#define SCENE_GOLDEN_H

#include <stdint.h>

#define SCENE_GOLDEN_TICKS 10000
#define SCENE_GOLDEN_FEW_TICKS 500

// A changed bit is a changed contract: a commit that changes this says why.
#define SCENE_GOLDEN_HASH UINT64_C(0x929366150f9894a6)
#define SCENE_GOLDEN_FEW_HASH UINT64_C(0x07fad04f49432cbe)

// The hash over the hashes of all ticks. rollbacks: with saves, restores and rollbacks at random ticks, which must not
// change it. 0: a call failed. Not reentrant: the matches are static.
uint64_t scene_golden_hash(uint32_t ticks, int rollbacks);

#endif
