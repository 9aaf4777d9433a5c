// src/contact/gjk_reduce.h with any contact points, one more than are to be kept or the most there are, of which one to four
// are kept or the most.
#include "src/contact/gjk_reduce.h"

#include "candidates.h"

static void run(int32_t count, int32_t most) {
  gjk_candidates candidates;
  uint8_t keep[GJK_CONTACTS_MAX];
  const gjk_vec3 u = any_vec3(ANY_UNIT);
  const gjk_unit3 normal = {u.x, u.y, u.z};
  any_candidates(&candidates, count);
  gjk_reduce(&candidates, &normal, (unsigned)most, keep);
  for (int i = 0; i < most; i++) {
    //@ assert keep[i] < count;
  }
}

int main(void) {
  static const int32_t most[] = {1, 2, 3, 4, GJK_CONTACTS_MAX};
  for (int i = 0; i < 5; i++) {
    run(most[i] + 1, most[i]);
    run(GJK_CANDIDATES_MAX, most[i]);
  }
  return 0;
}
