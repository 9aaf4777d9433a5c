// Outlines in the plane: what is wrong with given ones.
//
// An outline that turns left at each vertex, by less than half a turn, is convex if its turns add up to one whole turn. Then
// its edges point up, from 0 to below half a turn, for one stretch of it and down for another: their side changes twice.
#include "gjk2_outline.h"

bool gjk2_outline_fits(const gjk2_vec *v, uint32_t count) {
  gjk2_vec low = v[0], high = v[0];
  for (uint32_t i = 1; i < count; i++) {
    low.x = v[i].x < low.x ? v[i].x : low.x;
    low.y = v[i].y < low.y ? v[i].y : low.y;
    high.x = v[i].x > high.x ? v[i].x : high.x;
    high.y = v[i].y > high.y ? v[i].y : high.y;
  }
  const int64_t most = 2 * (int64_t)GJK2_RADIUS_MAX;
  return (int64_t)high.x - low.x <= most && (int64_t)high.y - low.y <= most;
}

static bool edge_points_up(gjk2_vec e) {
  return e.y > 0 || (e.y == 0 && e.x > 0);
}

// The fault at vertex i. Edges are below 2^30, so their cross product is below 2^61.
static gjk2_hull_fault fault_at(const gjk2_vec *v, uint32_t count, uint32_t i) {
  const gjk2_vec before = gjk2_sub(v[i], v[i > 0 ? i - 1 : count - 1]),
                 after = gjk2_sub(v[i + 1 < count ? i + 1 : 0], v[i]);
  if (gjk2_norm1(before) == 0) {
    return GJK2_HULL_REPEATED;
  }
  const int64_t turn = gjk2_cross(before, after);
  return turn == 0 && gjk2_norm1(after) > 0 ? GJK2_HULL_STRAIGHT : turn < 0 ? GJK2_HULL_TURN : GJK2_HULL_SOUND;
}

void gjk2_outline_check(const gjk2_vec *v, uint32_t count, gjk2_hull_report *out) {
  unsigned changes = 0;
  out->fault = count < 3 ? GJK2_HULL_FEW : GJK2_HULL_SOUND;
  out->vertex = 0;
  for (uint32_t i = 0; i < count && count >= 3; i++) {
    const gjk2_hull_fault fault = fault_at(v, count, i);
    if (fault != GJK2_HULL_SOUND && (out->fault == GJK2_HULL_SOUND || (uint8_t)fault < out->fault)) {
      out->fault = (uint8_t)fault;
      out->vertex = (uint16_t)i;
    }
    const gjk2_vec before = gjk2_sub(v[i], v[i > 0 ? i - 1 : count - 1]),
                   after = gjk2_sub(v[i + 1 < count ? i + 1 : 0], v[i]);
    changes += edge_points_up(before) != edge_points_up(after) ? 1u : 0u;
  }
  if (out->fault == GJK2_HULL_SOUND && changes != 2) {
    out->fault = GJK2_HULL_LAYERS;
  }
}

gjk_status gjk2_hull_check(const gjk2_vec *vertices, uint16_t count, gjk2_hull_report *out) {
  if (vertices == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (!gjk2_outline_fits(vertices, count)) {
    return GJK_ERROR_SIZE;
  }
  gjk2_outline_check(vertices, count, out);
  return GJK_OK;
}
