// Stands in for src/contact/gjk_clip.c: any contact points, from what tests/prove/clip.c shows to be enough.
#include "src/contact/gjk_clip.h"

#include "candidates.h"
#include "polygons.h"

void gjk_clip(const gjk_polygon *a, const gjk_polygon *b, const gjk_vec3 *centre, gjk_q16 margin, gjk_candidates *out) {
  static const int32_t counts[] = {0, 1, 2, 4, 8, GJK_CANDIDATES_MAX};
  const int32_t kind = any_between(0, 5);
  //@ assert a->count > 1 && b->count > 1 && margin >= 0;
  check_polygon(a);
  check_polygon(b);
  check_position(centre);
  //@ split kind;
  any_candidates(out, counts[kind]);
}
