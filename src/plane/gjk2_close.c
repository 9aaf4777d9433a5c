// The nearest feature of points, segments and boxes with two half axes in all, without a search.
//
// A point has no half axis, a segment one, a box two. With two in all, x and y, A - B is the parallelogram
// centre + s x + t y with s and t from -1 to 1. u leads from its centre to the origin O. Signs alone find the feature:
//
//   1. Flip x and y so that u = alpha x + beta y with alpha and beta at least 0. Both at most 1: O lies within.
//   2. alpha > 1: O lies beyond the edge at x. Where its foot is inside the edge, that is the nearest feature. Where the foot
//      is beyond the end x - y, that corner is nearest: distances rise from there along the edges that O sees.
//   3. beta > 1: the same of the edge at y. What is left is the corner x + y.
//   4. Where x and y are parallel, or one is 0, A - B is the segment centre +- z: its inside, or an end.
//
// The feature is canonical as it is (gjk2_canonical.h): edges of a parallelogram are whole, and so is the segment. Then its
// distance, the normal and the points follow (gjk2_feature.h).
//   |u| <= 2^30, |x|, |y| < 2^28:  sums of them below 3 2^29, products below 2^60
//
// Only where registers hold 64 bits. Coordinates are scalars of 64 bits: GCC makes vectors of pairs, which costs more than it
// saves.
#include "gjk2_close.h"

#include "gjk2_feature.h"

#if GJK_64_BIT && !GJK_SMALL

typedef int64_t close_number;

// p . q, and p x q.
static inline int64_t close_dot(close_number px, close_number py, close_number qx, close_number qy) {
  return px * qx + py * qy;
}

static inline int64_t close_cross(close_number px, close_number py, close_number qx, close_number qy) {
  return px * qy - py * qx;
}

// The half axes of both shapes, those of A first, and the feature.
typedef struct close_pair {
  close_number delta_x, delta_y;  // centre_a - centre_b
  close_number x[2], y[2];        // of both half axes; of the feature with its signs
  unsigned of_a;                  // how many are A's
  // The feature is the corner with these signs, 1 or -1. Or the edge from there to the corner whose signs differ where
  // `turns` is 1.
  close_number sign[2], turns[2];
  close_number w_x, w_y;        // of the corner
  close_number edge_x, edge_y;  // to the other one, O on its right
  close_number d_x, d_y;        // from the feature to O
  int64_t base;                 // d . w
} close_pair;

// Sets the corner with these signs.
static inline void set_close_feature(close_pair *of, close_number s, close_number t) {
  of->sign[0] = s;
  of->sign[1] = t;
  of->x[0] *= s;
  of->y[0] *= s;
  of->x[1] *= t;
  of->y[1] *= t;
  of->w_x = of->delta_x + of->x[0] + of->x[1];
  of->w_y = of->delta_y + of->y[0] + of->y[1];
}

// Makes a corner the feature. False: it is O.
GJK_ONCE static bool take_corner(close_pair *of, close_number s, close_number t) {
  set_close_feature(of, s, t);
  of->turns[0] = 0;
  of->turns[1] = 0;
  of->edge_x = 0;
  of->edge_y = 0;
  of->d_x = -of->w_x;
  of->d_y = -of->w_y;
  of->base = -close_dot(of->w_x, of->w_y, of->w_x, of->w_y);
  return of->base != 0;
}

// Makes the edge from a corner to the one with other signs the feature, or the edge back. False: O lies on it.
GJK_ONCE static bool take_edge(close_pair *of, close_number s, close_number t, close_number turns_x,
                               close_number turns_y) {
  set_close_feature(of, s, t);
  of->turns[0] = turns_x;
  of->turns[1] = turns_y;
  of->edge_x = -2 * (turns_x * of->x[0] + turns_y * of->x[1]);
  of->edge_y = -2 * (turns_x * of->y[0] + turns_y * of->y[1]);
  of->base = close_cross(of->w_x, of->w_y, of->edge_x, of->edge_y);
  if (of->base > 0) {
    of->sign[0] = s * (1 - 2 * turns_x);
    of->sign[1] = t * (1 - 2 * turns_y);
    of->x[0] *= 1 - 2 * turns_x;
    of->y[0] *= 1 - 2 * turns_x;
    of->x[1] *= 1 - 2 * turns_y;
    of->y[1] *= 1 - 2 * turns_y;
    of->w_x += of->edge_x;
    of->w_y += of->edge_y;
    of->edge_x = -of->edge_x;
    of->edge_y = -of->edge_y;
    of->base = -of->base;
  }
  of->d_x = of->edge_y;
  of->d_y = -of->edge_x;
  return of->base != 0;
}

// Step 4
static bool close_segment(close_pair *of) {
  const close_number t = close_dot(of->x[0], of->y[0], of->x[1], of->y[1]) < 0 ? -1 : 1;
  const close_number z_x = of->x[0] + t * of->x[1], z_y = of->y[0] + t * of->y[1];
  const int64_t along = -close_dot(of->delta_x, of->delta_y, z_x, z_y), most = close_dot(z_x, z_y, z_x, z_y);
  if (along < most && along > -most) {
    return take_edge(of, 1, t, 1, 1);
  }
  return along < 0 ? take_corner(of, -1, -t) : take_corner(of, 1, t);
}

// Are the cores points, segments and boxes of two half axes in all? Their classes have 1, 2 and 4 vertices, triangles 3, all
// others none.
static inline bool has_axes(const gjk2_collider *a, const gjk2_collider *b) {
  return (0x16u >> ((unsigned)a->shape->type->count * b->shape->type->count) & 1u) != 0;
}

// 1 or, of a number below 0, -1.
static inline close_number close_sign(int64_t x) {
  return gjk_sar64(x, 63) | 1;
}

// Steps 1 to 4. False: O lies in A - B.
GJK_ONCE static bool find_closest(const gjk2_collider *a, const gjk2_collider *b, close_pair *of) {
  const close_number u_x = (close_number)b->centre.x - a->centre.x, u_y = (close_number)b->centre.y - a->centre.y;
  const unsigned of_a = a->count >> 1;
  const gjk2_vec *first = of_a > 0 ? &a->frame[0] : &b->frame[0];
  const gjk2_vec *second = of_a > 1 ? &a->frame[1] : &b->frame[1 - of_a];
  const close_number x_x = first->x, x_y = first->y, y_x = second->x, y_y = second->y;
  of->delta_x = -u_x;
  of->delta_y = -u_y;
  of->of_a = of_a;
  of->x[0] = x_x;
  of->y[0] = x_y;
  of->x[1] = y_x;
  of->y[1] = y_y;
  const int64_t area = close_cross(x_x, x_y, y_x, y_y);
  if (area == 0) {
    return close_segment(of);
  }
  // Step 1
  const int64_t alpha = close_cross(u_x, u_y, y_x, y_y), beta = close_cross(x_x, x_y, u_x, u_y);
  const close_number s = close_sign(alpha ^ area), t = close_sign(beta ^ area);
  const uint64_t size = gjk_magnitude64(area);
  const bool beyond_x = gjk_magnitude64(alpha) > size, beyond_y = gjk_magnitude64(beta) > size;
  if (beyond_x) {  // Step 2
    const int64_t along = t * close_dot(u_x - s * x_x, u_y - s * x_y, y_x, y_y), most = close_dot(y_x, y_y, y_x, y_y);
    if (along < most && along > -most) {
      return take_edge(of, s, t, 0, 1);
    }
    if (along < 0) {
      return take_corner(of, s, -t);
    }
  }
  if (beyond_y) {  // Step 3
    const int64_t along = s * close_dot(u_x - t * y_x, u_y - t * y_y, x_x, x_y), most = close_dot(x_x, x_y, x_x, x_y);
    if (along < most && along > -most) {
      return take_edge(of, s, t, 1, 0);
    }
    if (along < 0) {
      return take_corner(of, -s, t);
    }
  }
  return (beyond_x || beyond_y) && take_corner(of, s, t);
}

// A bit for each half axis, as it tells the numbers of both shapes' vertices.
static inline uint16_t number_of_a(const gjk2_collider *a, unsigned bits) {
  return (uint16_t)(bits & (a->count - 1u));
}

static inline uint16_t number_of_b(const gjk2_collider *b, unsigned of_a, unsigned bits) {
  return (uint16_t)(bits >> of_a & (b->count - 1u));
}

// The feature by A's part of it. Names its vertices.
static inline void name_closest(const gjk2_collider *a, const gjk2_collider *b, const close_pair *of, gjk2_feature *out,
                                gjk2_certificate *names) {
  out->w_x = of->w_x;
  out->w_y = of->w_y;
  out->edge_x = of->edge_x;
  out->edge_y = of->edge_y;
  out->d_x = of->d_x;
  out->d_y = of->d_y;
  out->base = of->base;
  // A's half axes come first.
  const bool some = of->of_a > 0, both = of->of_a > 1;
  out->a_x = (some ? of->x[0] : 0) + (both ? of->x[1] : 0);
  out->a_y = (some ? of->y[0] : 0) + (both ? of->y[1] : 0);
  // Bit 0 and 1: the corner has plus the half axis. A vertex of -B is that of B with the other signs.
  const unsigned plus = (unsigned)((of->sign[0] + 1) / 2 + (of->sign[1] + 1));
  names->a[0] = number_of_a(a, plus);
  names->b[0] = number_of_b(b, of->of_a, ~plus);
  out->is_edge = (of->turns[0] | of->turns[1]) != 0;
  out->edge_a_x = 0;
  out->edge_a_y = 0;
  if (out->is_edge) {
    const close_number turn_x = some ? -2 * of->turns[0] : 0, turn_y = both ? -2 * of->turns[1] : 0;
    out->edge_a_x = turn_x * of->x[0] + turn_y * of->x[1];
    out->edge_a_y = turn_x * of->y[0] + turn_y * of->y[1];
    const unsigned other = plus ^ (unsigned)(of->turns[0] + 2 * of->turns[1]);
    names->a[1] = number_of_a(a, other);
    names->b[1] = number_of_b(b, of->of_a, ~other);
  }
}

// Is b - a below 2^29 in size along both axes?
static inline bool is_near_enough(const gjk2_collider *a, const gjk2_collider *b) {
  const int64_t half = INT64_C(1) << 29;
  return ((uint64_t)((int64_t)b->centre.x - a->centre.x + half) |
          (uint64_t)((int64_t)b->centre.y - a->centre.y + half)) >>
             30 ==
         0;
}

// Of two points. False: they are in one place.
GJK_OUT_OF_LINE static bool touch_points(const gjk2_collider *a, const gjk2_collider *b, unsigned parts,
                                         gjk2_distance_result *out) {
  gjk2_feature of;
  of.d_x = (close_number)b->centre.x - a->centre.x;
  of.d_y = (close_number)b->centre.y - a->centre.y;
  of.base = -close_dot(of.d_x, of.d_y, of.d_x, of.d_y);
  if (of.base == 0) {
    return false;
  }
  out->certificate.a[0] = 0;
  out->certificate.b[0] = 0;
  gjk2_feature_measure(a, b, &of, true, parts, out);
  return true;
}

GJK_OUT_OF_LINE static bool touch_lines(const gjk2_collider *a, const gjk2_collider *b, unsigned parts,
                                        gjk2_distance_result *out) {
  close_pair pair;
  gjk2_feature of;
  if (!find_closest(a, b, &pair)) {
    return false;
  }
  name_closest(a, b, &pair, &of, &out->certificate);
  gjk2_feature_measure(a, b, &of, false, parts, out);
  return true;
}

bool gjk2_touch_axes(const gjk2_collider *a, const gjk2_collider *b, unsigned parts, gjk2_distance_result *out) {
  if (!is_near_enough(a, b)) {
    return false;
  }
  if (a->count == 1 && b->count == 1) {
    return touch_points(a, b, parts, out);
  }
  return has_axes(a, b) && touch_lines(a, b, parts, out);
}
#else

bool gjk2_touch_axes(const gjk2_collider *a, const gjk2_collider *b, unsigned parts, gjk2_distance_result *out) {
  (void)a, (void)b, (void)parts, (void)out;
  return false;
}

#endif
