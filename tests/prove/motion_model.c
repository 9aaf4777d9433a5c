// Stands in for src/motion/gjk_motion.c under times of impact: any turning and pose that tests/prove/motion.c shows
// possible.
#include "movers.h"

gjk_status gjk_turning_start(const gjk_motion *motion, gjk_turning *out) {
  //@ assert \initialized(&motion->from) && \initialized(&motion->to);
  any_turning(out);
  return any_bool() ? GJK_OK : GJK_ERROR_ROTATION;
}

void gjk_turning_pose(const gjk_motion *motion, const gjk_turning *turning, gjk_q30 fraction, gjk_pose *out) {
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  check_turning(turning);
  //@ assert \initialized(&turning->deviation);
  *out = any_pose();
}

static void any_turned(gjk_turned *out) {
  out->along = any_vec3(ANY_UNIT + 64);
  out->off = any_vec3(ANY_UNIT + 64);
  out->across = any_vec3(ANY_UNIT + 64);
}

void gjk_turning_split(const gjk_turning *turning, const gjk_unit3 *v, gjk_turned *out) {
  check_turning(turning);
  check_unit3(v);
  any_turned(out);
}

void gjk_turning_join(const gjk_turning *turning, gjk_q30 part, bool back, const gjk_turned *split, gjk_unit3 *v) {
  //@ assert part >= 0 && part <= GJK_Q30_ONE;
  check_turning(turning);
  check_vec3(&split->along, ANY_UNIT + 64);
  check_vec3(&split->off, ANY_UNIT + 64);
  check_vec3(&split->across, ANY_UNIT + 64);
  (void)back;
  *v = any_unit3();
}
