// gjk_motion_pose on any motion at any fraction, and src/motion/gjk_motion.h.
#include "src/motion/gjk_motion.h"

#include "any.h"

int main(void) {
  const gjk_motion motion = {any_pose(), any_pose(), any_position()};
  gjk_pose pose;
  gjk_turning turning;
  (void)gjk_motion_pose(any_bool() ? &motion : NULL, any_int32(), any_bool() ? &pose : NULL);
  const int status = gjk_turning_start(&motion, &turning);
  //@ split status;
  if (status == GJK_OK) {
    gjk_unit3 v = {any_between(-GJK_Q30_ONE, GJK_Q30_ONE), any_between(-GJK_Q30_ONE, GJK_Q30_ONE),
                   any_between(-GJK_Q30_ONE, GJK_Q30_ONE)};
    gjk_turned split;
    gjk_turning_split(&turning, &v, &split);
    gjk_turning_join(&turning, any_between(0, GJK_Q30_ONE), any_bool(), &split, &v);
  }
  return 0;
}
