// Rotations from angles.
#include "../arith/gjk_sine.h"
#include "gjk2/pose.h"

gjk_status gjk2_rotation_from_angle(gjk_angle angle, gjk2_rotation *out) {
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_sine_cosine(angle, 2 * gjk_half_turns(gjk_magnitude32(angle)), &out->s, &out->c);
  return GJK_OK;
}
