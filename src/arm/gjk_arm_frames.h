// Where the links of an arm are, and what its pairs need of that.
#ifndef GJK_SRC_ARM_FRAMES_H
#define GJK_SRC_ARM_FRAMES_H

#include "../shape/gjk_shape_class.h"
#include "gjk/arm.h"

// Fractions of an edge are counted in steps. An edge has this many.
#define GJK_ARM_STEPS (UINT32_C(1) << GJK_ARM_DEPTH_MAX)

// A step in Q30.
#define GJK_ARM_STEP_Q30 (GJK_Q30_ONE >> GJK_ARM_DEPTH_MAX)

// States of an arm. Other values are those of memory that was never initialised.
#define GJK_ARM_READY UINT16_C(0x6765)
#define GJK_ARM_RUNNING UINT16_C(0x6766)
#define GJK_ARM_SETTLED UINT16_C(0x6767)
#define GJK_ARM_STUCK UINT16_C(0x6768)

// The frame of a pair whose other thing is a body.
#define GJK_ARM_BODY 254

// No pair.
#define GJK_ARM_NO_PAIR UINT32_MAX

static inline bool gjk_arm_is_ready(const gjk_arm *arm) {
  return arm->state >= GJK_ARM_READY && arm->state <= GJK_ARM_STUCK;
}

// Does the joint of a link move?
static inline bool gjk_arm_moves(const gjk_arm *arm, unsigned link) {
  return arm->model->links[link].kind != GJK_ARM_FIXED;
}

// The obstacle of a pair; NULL: it has none.
static inline const gjk_collider *gjk_arm_obstacle(const gjk_arm *arm, const gjk_arm_pair *pair) {
  return pair->frame == GJK_ARM_BASE ? &arm->obstacles[pair->other] : NULL;
}

// Sets the links' frames with number which to a step of the edge from arm->from to arm->to.
// Pre: gjk_arm_set_edge has found the edge in range; step <= GJK_ARM_STEPS.
void gjk_arm_set_frames(gjk_arm *arm, uint32_t step, unsigned which);

// Poses a part's collider at the frames with number which. Pre: as above.
void gjk_arm_place_part(const gjk_arm *arm, unsigned number, unsigned which, gjk_collider *out);

// Poses the colliders of a pair, not of a body, at the frames with number which. *part becomes the part's collider,
// *other that of another part. For an obstacle *other is not set, and the result is the obstacle's own collider.
// Pre: as above.
const gjk_collider *gjk_arm_place(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, gjk_collider *part,
                                  gjk_collider *other);

// Names a pair for results. piece: of its body, if it has one.
void gjk_arm_name(const gjk_arm_pair *pair, uint32_t piece, gjk_arm_names *out);

#endif
