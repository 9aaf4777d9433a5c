// How far points lie beyond a hull: the nearest of all triangles, and of each its inside or an edge.
//
// A point beyond the hull is nearest to a triangle that it is beyond. Its foot on a plane or on an edge is rounded, by a unit
// vector whose components are off by 2^-30. So it is off by at most 2 LSB, and the distance of the rounded foot is too small by
// no more. All distances get 2 LSB more, and are rounded up.
#include "gjk_hull_excess.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"

#define FOOT_ROUNDING 2u

gjk_unit3 gjk_hull_unit(const gjk_hull_plane *plane) {
  gjk_search_direction d;
  gjk_search_direction_of(&plane->n, &d);
  const gjk_vec3 up = gjk_scale_direction(&d.d);
  return gjk_unit(&up);
}

static uint32_t length_above(const gjk_vec3 *d) {
  const uint64_t squared = (uint64_t)gjk_dot(d, d);
  const uint32_t root = gjk_isqrt64(squared);
  return gjk_umul32(root, root) == squared ? root : root + 1;
}

// A bound of the distance from the edge a, b.
static uint32_t bound_of_edge(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *p) {
  const gjk_vec3 edge = gjk_sub(*b, *a), way = gjk_sub(*p, *a);
  if (gjk_dot(&edge, &way) <= 0) {
    return length_above(&way);
  }
  const gjk_vec3 back = gjk_sub(*p, *b);
  if (gjk_dot(&edge, &back) >= 0) {
    return length_above(&back);
  }
  const gjk_vec3 up = gjk_scale_direction(&edge);
  const gjk_unit3 u = gjk_unit(&up);
  const int32_t along = (int32_t)gjk_sar64(gjk_along(&u, &way), 30);
  const gjk_vec3 rest = {way.x - (int32_t)gjk_sar64(gjk_mul32(u.x, along), 30),
                         way.y - (int32_t)gjk_sar64(gjk_mul32(u.y, along), 30),
                         way.z - (int32_t)gjk_sar64(gjk_mul32(u.z, along), 30)};
  return length_above(&rest) + FOOT_ROUNDING;
}

// A bound of the distance from a triangle. Pre: p is beyond its plane, by height LSB, rounded up.
static uint32_t bound_of_triangle(const gjk_vec3 *const corner[3], const gjk_unit3 *u, const gjk_vec3 *p,
                                  uint32_t height) {
  const gjk_vec3 normal = {u->x, u->y, u->z};
  uint32_t least = UINT32_MAX;
  bool inside = true;
  for (unsigned i = 0; i < 3; i++) {
    const gjk_vec3 *a = corner[i], *b = corner[gjk_next(i)];
    const gjk_vec3 edge = gjk_sub(*b, *a), way = gjk_sub(*p, *a);
    gjk_long3 inwards;
    gjk_cross(&normal, &edge, &inwards);
    if (gjk_dot_sign(&inwards, &way) < 0) {
      const uint32_t own = bound_of_edge(a, b, p);
      least = own < least ? own : least;
      inside = false;
    }
  }
  return inside ? height + FOOT_ROUNDING : least;
}

static void approach_triangle(const gjk_hull_work *w, const gjk_hull_triangle *t, const gjk_vec3 *points,
                              uint16_t count, uint32_t *least) {
  const gjk_vec3 *corner[3];
  gjk_hull_plane plane;
  for (int k = 0; k < 3; k++) {
    corner[k] = gjk_hull_point(w, t->vertex[k]);
  }
  gjk_hull_set_plane(w, t, &plane);
  const gjk_unit3 u = gjk_hull_unit(&plane);
  for (uint32_t i = 0; i < count; i++) {
    if (gjk_hull_height_sign(&plane, &points[i]) > 0) {
      const gjk_vec3 way = gjk_sub(points[i], *plane.at);
      const int64_t along = gjk_along(&u, &way);
      const uint32_t height = (uint32_t)gjk_sar64(along > 0 ? along : 0, 30) + 1;
      if (height < least[i]) {
        const uint32_t own = bound_of_triangle(corner, &u, &points[i], height);
        least[i] = own < least[i] ? own : least[i];
      }
    }
  }
}

uint32_t gjk_hull_excess(const gjk_hull_work *w, const gjk_vec3 *points, uint16_t count, uint32_t *least) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < count; i++) {
    least[i] = UINT32_MAX;
  }
  for (uint32_t at = 0; at < w->triangles; at++) {
    if ((w->triangle[at].flags & GJK_HULL_SEEN) == 0) {
      approach_triangle(w, &w->triangle[at], points, count, least);
    }
  }
  for (uint32_t i = 0; i < count; i++) {
    most = least[i] != UINT32_MAX && least[i] > most ? least[i] : most;  // else it is inside
  }
  return most;
}
