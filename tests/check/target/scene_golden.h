// One number over a long match in a scene, the same on every target, through saves and rollbacks.
#ifndef SCENE_GOLDEN_H
#define SCENE_GOLDEN_H

#include <stdint.h>

#define SCENE_GOLDEN_TICKS 10000
#define SCENE_GOLDEN_FEW_TICKS 500

// A changed bit is a changed contract: say why in the commit that changes this.
#define SCENE_GOLDEN_HASH UINT64_C(0xf331936515d0d652)
#define SCENE_GOLDEN_FEW_HASH UINT64_C(0x487bbea8fb6e7e29)

// The hash over all ticks' hashes; rollbacks: with saves, restores and rollbacks at random ticks. 0: something failed.
// Not reentrant: the matches are static.
uint64_t scene_golden_hash(uint32_t ticks, int rollbacks);

#endif
