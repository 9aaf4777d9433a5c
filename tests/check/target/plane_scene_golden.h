// One hash over a long match in a scene of the plane, through saves and rollbacks. It is the same on every target.
#ifndef PLANE_SCENE_GOLDEN_H
#define PLANE_SCENE_GOLDEN_H

#include <stdint.h>

#define PLANE_SCENE_GOLDEN_TICKS 10000
#define PLANE_SCENE_GOLDEN_FEW_TICKS 500

// A changed bit is a changed contract: a commit that changes this says why.
#define PLANE_SCENE_GOLDEN_HASH UINT64_C(0x9ab82c6b238b3dc8)
#define PLANE_SCENE_GOLDEN_FEW_HASH UINT64_C(0x846b3aa3d0d13eb9)

// The hash over the hashes of all ticks. rollbacks: with saves, restores and rollbacks at random ticks, which must not
// change it. 0: a call failed. Not reentrant: the matches are static.
uint64_t plane_scene_golden_hash(uint32_t ticks, int rollbacks);

#endif
