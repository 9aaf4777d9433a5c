// The corners of a polygon's hull.
#include "gjk2_hull.h"

static gjk2_vec offset_of(const gjk2_collider *c, uint16_t number) {
  gjk2_vec offset = {0, 0};
  (void)c->shape->type->vertex(c, number, &offset);
  return offset;
}

void gjk2_hull_corner(const gjk2_collider *c, gjk2_vec d, gjk2_support *out) {
  if (c->ordered) {
    gjk2_support way;
    c->shape->type->support(c, &d, out);
    c->shape->type->adjacent(c, out, true, &way);
    if (gjk2_dot(way.offset, d) == 0) {
      gjk2_follow(out, &way);
    }
    return;
  }
  const gjk2_vec left = {-d.y, d.x};
  out->vertex = 0;
  out->offset = offset_of(c, 0);
  for (uint32_t i = 1; i < c->count; i++) {
    const gjk2_vec offset = offset_of(c, (uint16_t)i), beyond = gjk2_sub(offset, out->offset);
    const int64_t along = gjk2_dot(beyond, d);
    if (along > 0 || (along == 0 && gjk2_dot(beyond, left) > 0)) {
      out->vertex = (uint16_t)i;
      out->offset = offset;
    }
  }
}

bool gjk2_hull_neighbour(const gjk2_collider *c, const gjk2_support *corner, bool following, gjk2_support *way) {
  if (c->ordered) {
    c->shape->type->adjacent(c, corner, following, way);
    return true;
  }
  gjk2_vec best = {0, 0};
  for (uint32_t i = 0; i < c->count; i++) {
    const gjk2_vec to = gjk2_sub(offset_of(c, (uint16_t)i), corner->offset);
    const int64_t turn = following ? gjk2_cross(best, to) : gjk2_cross(to, best);
    if (turn < 0 || (turn == 0 && gjk2_norm1(to) > gjk2_norm1(best))) {
      best = to;
      way->vertex = (uint16_t)i;
    }
  }
  gjk2_copy(&way->offset, &best);
  return gjk2_norm1(best) != 0;
}
