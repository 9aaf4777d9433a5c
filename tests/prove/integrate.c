// gjk_quat_integrate on any rotation, velocity and time, null pointers too.
#include "any.h"

int main(void) {
  const gjk_quat rotation = any_quat();
  const gjk_vec3 velocity = any_position();
  gjk_quat out;
  (void)gjk_quat_integrate(any_bool() ? &rotation : NULL, any_bool() ? &velocity : NULL, any_int32(),
                           any_bool() ? &out : NULL);
  return 0;
}
