// The way of a cast, from positions of poses to centres.
#include "gjk_way.h"

// One axis of a collider's way: *end becomes its centre at the end, and the way's length is returned. *outside is set
// where the centre leaves int32.
//   the way    to - position: below 2^32 in size
GJK_ONE_COPY static int64_t way_along(gjk_q16 position, gjk_q16 to, gjk_q16 centre, gjk_q16 *end, bool *outside) {
  const int64_t way = (int64_t)to - position;
  *end = gjk_saturate_noting(centre + way, outside);
  return way;
}

static gjk_long3 way_of(const gjk_collider *c, const gjk_vec3 *to, gjk_vec3 *end, bool *outside) {
  gjk_long3 way = {0, 0, 0};
  if (to == NULL) {
    gjk_set(&c->centre, end);
    return way;
  }
  const gjk_vec3 *from = &c->position;
  way.x = way_along(from->x, to->x, c->centre.x, &end->x, outside);
  way.y = way_along(from->y, to->y, c->centre.y, &end->y, outside);
  way.z = way_along(from->z, to->z, c->centre.z, &end->z, outside);
  return way;
}

// Is |x| below 2^32? Pre: |x| < 2^33.
static bool is_short_way(int64_t x) {
  return gjk_magnitude64(x) >> 32 == 0;
}

gjk_status gjk_way_set(gjk_way *way, const gjk_collider *a, const gjk_collider *b, const gjk_cast_path *path) {
  if (path == NULL) {
    return GJK_ERROR_NULL;
  }
  if (path->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  gjk_vec3 end_a, end_b;
  bool outside = false;
  const gjk_long3 of_a = way_of(a, path->to_a, &end_a, &outside);
  const gjk_long3 of_b = way_of(b, path->to_b, &end_b, &outside);
  // Each below 2^32 in size: below 2^33.
  const int64_t x = of_b.x - of_a.x, y = of_b.y - of_a.y, z = of_b.z - of_a.z;
  if (outside || !is_short_way(x) || !is_short_way(y) || !is_short_way(z)) {
    return GJK_ERROR_RANGE;
  }
  gjk_set(&end_a, &way->end_a);
  gjk_set(&end_b, &way->end_b);
  way->t.x = x;
  way->t.y = y;
  way->t.z = z;
  return GJK_OK;
}
