// Stands in for src/contact/gjk_reduce.c: any of the points, from what tests/prove/reduce.c shows to be enough.
#include "src/contact/gjk_reduce.h"

#include "candidates.h"

void gjk_reduce(const gjk_candidates *candidates, const gjk_unit3 *normal, unsigned most, uint8_t *keep) {
  //@ assert most >= 1 && most <= GJK_CONTACTS_MAX && most < candidates->count;
  check_candidates(candidates);
  check_size(normal->x, ANY_UNIT);
  check_size(normal->y, ANY_UNIT);
  check_size(normal->z, ANY_UNIT);
  for (unsigned i = 0; i < most; i++) {
    keep[i] = (uint8_t)any_between(0, (int32_t)candidates->count - 1);
  }
}
