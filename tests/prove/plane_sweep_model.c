// Stands in for src/plane_motion/gjk2_sweep.c under times of impact: any pose and angle that tests/prove/plane_sweep.c
// shows possible.
#include "plane_any.h"
#include "src/plane_motion/gjk2_sweep.h"

gjk_status gjk2_sweep_set(gjk2_sweep *sweep, const gjk2_motion *motion) {
  sweep->motion = motion;
  sweep->x = (int64_t)motion->to.position.x - motion->from.position.x;
  sweep->y = (int64_t)motion->to.position.y - motion->from.position.y;
  sweep->rate_high = (uint64_t)any_long(0, INT64_C(1) << 47);
  sweep->rate_low = 0;
  sweep->angle = (uint64_t)any_long(0, (INT64_C(1) << 39) + 1);
  sweep->clockwise = any_bool();
  sweep->deviation = any_long(-(INT64_C(1) << 44), INT64_C(1) << 44);
  return any_bool() ? GJK_OK : GJK_ERROR_ROTATION;
}

void gjk2_sweep_pose(const gjk2_sweep *sweep, gjk_q30 fraction, gjk2_pose *out) {
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  check_within(sweep->x, (INT64_C(1) << 32) - 1);
  *out = any_pose2();
}

void gjk2_sweep_place(const gjk2_sweep *sweep, gjk_q30 fraction, gjk2_vec *out) {
  //@ assert fraction >= 0 && fraction <= GJK_Q30_ONE;
  check_within(sweep->x, (INT64_C(1) << 32) - 1);
  *out = any_position2();
}
