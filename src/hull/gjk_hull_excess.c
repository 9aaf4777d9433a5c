// How far points lie beyond a hull: the nearest of all triangles, and of each its inside or an edge.
//
// A point beyond the hull is nearest to a triangle that it is beyond. Whether its foot is inside is the sign of a sum of two
// products. Its height over the plane is rounded up exactly. Its distance from an edge is the root of an integer that is less
// than 1 above the square. So with the root rounded up it is less than 2 LSB too large.
#include "gjk_hull_excess.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_unit.h"

// A height by a unit vector is off by at most so many LSB. The normal is rounded to 30 bits, then the unit vector within 2^-30 an
// axis: together below 2^-28.2. Points are below 2^29.8 apart.
#define HEIGHT_ERROR 4

gjk_unit3 gjk_hull_unit(const gjk_hull_plane *plane) {
  gjk_search_direction d;
  gjk_search_direction_of(&plane->n, &d);
  const gjk_vec3 up = gjk_scale_direction(&d.d);
  return gjk_unit(&up);
}

static uint32_t root_above(uint64_t squared) {
  const uint32_t root = gjk_isqrt64(squared);
  return gjk_umul32(root, root) == squared ? root : root + 1;
}

// squared - along^2 / edge, rounded up. Pre: 0 < along < edge < 2^60, along^2 <= squared edge.
static uint64_t squared_across(uint64_t squared, uint64_t along, uint64_t edge) {
  uint64_t quotient = 0, rest = 0;  // of along times its leading bits
  for (unsigned bit = 60; bit > 0; bit--) {
    quotient *= 2;
    rest = 2 * rest + ((along >> (bit - 1) & 1u) != 0 ? along : 0);  // < 3 edge
    for (unsigned i = 0; i < 2 && rest >= edge; i++) {
      rest -= edge;
      quotient++;
    }
  }
  return squared - quotient;
}

// A bound of the distance from the edge a, b.
static uint32_t bound_of_edge(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *p) {
  const gjk_vec3 edge = gjk_sub(*b, *a), way = gjk_sub(*p, *a);
  const int64_t along = gjk_dot(&edge, &way), whole = gjk_dot(&edge, &edge);
  if (along <= 0) {
    return root_above((uint64_t)gjk_dot(&way, &way));
  }
  if (along >= whole) {
    const gjk_vec3 back = gjk_sub(*p, *b);
    return root_above((uint64_t)gjk_dot(&back, &back));
  }
  return root_above(squared_across((uint64_t)gjk_dot(&way, &way), (uint64_t)along, (uint64_t)whole));
}

// *out = x^2.
static void set_square(gjk_u192 *out, uint64_t high, uint64_t low) {
  gjk_u192 x;
  gjk_u192_set(&x, low);
  x.limb[2] = gjk_low32((int64_t)high);
  gjk_u192_multiply(out, &x, &x);
}

// The height of p over a plane, rounded up. least is at most 2 HEIGHT_ERROR below that.
static uint32_t height_above(const gjk_hull_plane *plane, const gjk_vec3 *p, uint32_t least) {
  const uint64_t n[3] = {gjk_magnitude64(plane->n.x), gjk_magnitude64(plane->n.y), gjk_magnitude64(plane->n.z)};
  uint32_t low;
  gjk_u128 height;
  gjk_u192 across, normal, square, length;
  const int64_t high = gjk_hull_height(plane, p, &low);
  gjk_magnitude95(high, low, &height);
  set_square(&across, height.high, height.low);  // < 2^180
  gjk_u192_set(&normal, 0);
  for (int i = 0; i < 3; i++) {
    set_square(&square, 0, n[i]);
    gjk_u192_add(&normal, &square);  // < 2^122
  }
  for (unsigned i = 0; i <= 2 * HEIGHT_ERROR; i++, least++) {
    gjk_u192_set(&length, gjk_umul32(least, least));
    gjk_u192_multiply(&square, &normal, &length);
    if (gjk_u192_compare(&square, &across) >= 0) {
      break;
    }
  }
  return least;
}

// Is the foot of p on a triangle's plane outside of the edge from its corner i? Its normal is edge x other, and
// (edge x other) . (edge x way) = (edge . edge) (other . way) - (edge . way) (other . edge). Each product is below 2^60.
static bool is_outside_edge(const gjk_vec3 *const corner[3], unsigned i, const gjk_vec3 *p) {
  const unsigned j = gjk_next(i);
  const gjk_vec3 edge = gjk_sub(*corner[j], *corner[i]), other = gjk_sub(*corner[gjk_next(j)], *corner[i]);
  const gjk_vec3 way = gjk_sub(*p, *corner[i]);
  return gjk_sum_of_products_sign(gjk_dot(&edge, &edge), gjk_dot(&other, &way), -gjk_dot(&edge, &way),
                                  gjk_dot(&other, &edge)) < 0;
}

// A bound of the distance from a triangle. Pre: p is beyond its plane; least as for height_above.
static uint32_t bound_of_triangle(const gjk_vec3 *const corner[3], const gjk_hull_plane *plane, const gjk_vec3 *p,
                                  uint32_t least) {
  uint32_t nearest = UINT32_MAX;
  bool inside = true;
  for (unsigned i = 0; i < 3; i++) {
    if (is_outside_edge(corner, i, p)) {
      const uint32_t own = bound_of_edge(corner[i], corner[gjk_next(i)], p);
      nearest = own < nearest ? own : nearest;
      inside = false;
    }
  }
  return inside ? height_above(plane, p, least) : nearest;
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
      const int64_t height = gjk_sar64(along, 30) - HEIGHT_ERROR + 1;  // never above it
      const uint32_t low = (uint32_t)(height > 0 ? height : 0);
      if (low < least[i]) {
        const uint32_t own = bound_of_triangle(corner, &plane, &points[i], low);
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
