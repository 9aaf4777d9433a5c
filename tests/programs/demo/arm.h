// The joints of the scene's arm, from its base to its hand: what puts the bodies of tests/data/arm.txt where they are.
#ifndef ARM_H
#define ARM_H

#include "gjk/joint.h"

enum { ARM_JOINTS = 5, ARM_BODIES = 5 };

// A body, and where its centre is along z of a joint's frame.
typedef struct arm_body {
  const char *name;
  unsigned joint;
  gjk_q16 along;
} arm_body;

extern const arm_body arm_bodies[ARM_BODIES];

// Makes the joints. False: a call failed, as it is with all below.
bool arm_make(gjk_joint joints[ARM_JOINTS]);

// The frames of the joints, as a chain; and with the same meaning composed one by one.
bool arm_frames(const gjk_joint joints[ARM_JOINTS], gjk_pose out[ARM_JOINTS]);
bool arm_frames_composed(gjk_pose out[ARM_JOINTS]);

// Are the frames at the same places, within an LSB or two?
bool arm_frames_near(const gjk_pose a[ARM_JOINTS], const gjk_pose b[ARM_JOINTS]);

#endif
