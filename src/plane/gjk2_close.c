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
// distance, the normal and the points follow, with the same roundings as elsewhere (gjk2_distance.c, gjk2_meeting.c).
//   |u| <= 2^30, |x|, |y| < 2^28:  sums of them below 3 2^29, products below 2^60
//
// Only where registers hold 64 bits. Coordinates are scalars of 64 bits: GCC makes vectors of pairs, which costs more than it
// saves.
#include "gjk2_close.h"

#include "gjk2_outward.h"
#include "gjk2_witness.h"

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

// The point of a shape on the feature: from its corner there, by the weight of the other end of its edge, and moved by the
// convex radius. toward: 1 for A, which the normal leads away from, -1 for B. Bounds: plane_offset of gjk2_witness.c.
GJK_ONCE static void set_close_point(const gjk2_collider *c, close_number x, close_number y, close_number edge_x,
                                     close_number edge_y, int32_t weight, const gjk2_unit *normal, int toward,
                                     gjk2_vec *point, bool *saturated) {
  const int64_t half = INT64_C(1) << 30;
  const close_number twice = 2 * toward * c->shape->convex_radius;
  const int64_t moved_x = gjk_sar64(half + edge_x * weight + normal->x * twice, 31);
  const int64_t moved_y = gjk_sar64(half + edge_y * weight + normal->y * twice, 31);
  point->x = gjk_saturate_noting((int64_t)c->centre.x + x + moved_x, saturated);
  point->y = gjk_saturate_noting((int64_t)c->centre.y + y + moved_y, saturated);
}

// The points and the certificate.
static inline void set_touch(const gjk2_collider *a, const gjk2_collider *b, const close_pair *of,
                             const gjk2_length *length, const gjk2_unit *across, bool points,
                             gjk2_distance_result *out) {
  const close_number s = of->sign[0], t = of->sign[1];
  // Of A, and those of B less.
  const close_number in_a = of->of_a > 0, both_in_a = of->of_a > 1;
  const close_number a_x = in_a * of->x[0] + both_in_a * of->x[1];
  const close_number a_y = in_a * of->y[0] + both_in_a * of->y[1];
  const close_number b_x = a_x + of->delta_x - of->w_x, b_y = a_y + of->delta_y - of->w_y;
  close_number edge_x = 0, edge_y = 0;
  int32_t weight = 0;
  out->certificate.count = 1;
  // Bit 0 and 1: the corner has plus the half axis. A vertex of -B is that of B with the other signs.
  const unsigned plus = (unsigned)((s + 1) / 2 + (t + 1));
  out->certificate.a[0] = number_of_a(a, plus);
  out->certificate.b[0] = number_of_b(b, of->of_a, ~plus);
  if ((of->turns[0] | of->turns[1]) != 0) {
    const close_number turn_x = of->turns[0], turn_y = of->turns[1];
    out->certificate.count = 2;
    const unsigned turned = (unsigned)(turn_x + 2 * turn_y);
    out->certificate.a[1] = number_of_a(a, plus ^ turned);
    out->certificate.b[1] = number_of_b(b, of->of_a, ~(plus ^ turned));
    if (!points) {
      return;
    }
    const int64_t part = -close_dot(of->w_x, of->w_y, of->edge_x, of->edge_y), whole = (int64_t)length->squared;
    weight = gjk2_weight(length, whole >> (2 * GJK2_FINE_LENGTH) != 0, part < whole ? part : whole);
    edge_x = -2 * (in_a * turn_x * of->x[0] + both_in_a * turn_y * of->x[1]);
    edge_y = -2 * (in_a * turn_x * of->y[0] + both_in_a * turn_y * of->y[1]);
  }
  if (!points) {
    return;
  }
  set_close_point(a, a_x, a_y, edge_x, edge_y, weight, across, 1, &out->point_a, &out->saturated);
  set_close_point(b, b_x, b_y, edge_x - of->edge_x, edge_y - of->edge_y, weight, across, -1, &out->point_b,
                  &out->saturated);
}

// gjk2_is_within of h and d, mostly by the leading bits of h / |d|.
static inline bool is_touching(int64_t h, gjk2_vec d, int32_t radius, uint32_t leading, unsigned shift) {
  if (shift >= 38 && shift <= 62) {
    const int64_t beyond = (int64_t)leading - gjk_shl64(radius, shift - 32);  // off by less than 10
    if (beyond > 10 || beyond < -10) {
      return beyond < 0;
    }
  }
  return gjk2_is_within(h, d, radius);
}

// What follows from the feature. circles: of two points, which need no corners.
GJK_ONCE static void measure_touch(const gjk2_collider *a, const gjk2_collider *b, const close_pair *of, bool circles,
                                   unsigned parts, gjk2_distance_result *out) {
  gjk2_length length;
  gjk2_unit across;
  unsigned shift;
  const int32_t radius = a->shape->convex_radius + b->shape->convex_radius;
  const uint64_t h = (uint64_t)-of->base;
  const gjk2_vec d = {(int32_t)of->d_x, (int32_t)of->d_y};
  gjk2_quick_length(&length, d);
  gjk2_quick_unit(&across, &length, d);
  const uint32_t leading = (uint32_t)(gjk2_inline_quotient(&length, &shift, h) >> 32);
  const bool overlaps = radius > 0 && is_touching(-of->base, d, radius, leading, shift);
  const bool complete = (parts & (overlaps ? GJK2_TOUCH_DEPTH : GJK2_TOUCH_POINTS)) != 0;
  out->intersecting = overlaps;
  out->iterations = 1;
  out->saturated = false;
  out->certificate.direction.x = d.x;
  out->certificate.direction.y = d.y;
  out->certificate.proof = overlaps && !complete ? GJK2_PROOF_NEAR : GJK2_PROOF_NEAREST;
  if (!overlaps || complete) {
    out->normal.x = across.x;
    out->normal.y = across.y;
  }
  int32_t distance = 0;
  if (complete) {
    const gjk2_round_to to = overlaps ? GJK2_ROUND_DOWN : GJK2_ROUND_NEAREST;
    distance = (int32_t)gjk2_inline_rounded(&length, to, h, leading, shift) - radius;
  }
  if (overlaps && distance < 0 && !gjk2_inline_exceeds(leading, shift, -distance)) {
    gjk2_outward_normal(d, of->base, radius, &length, -distance, &out->normal);
  }
  out->distance = distance;
  out->lower = distance;
  out->upper = distance;
  if (!circles) {
    set_touch(a, b, of, &length, &across, complete, out);
    out->saturated = out->saturated && !overlaps;
    return;
  }
  out->certificate.count = 1;
  out->certificate.a[0] = 0;
  out->certificate.b[0] = 0;
  if (complete) {
    set_close_point(a, 0, 0, 0, 0, 0, &across, 1, &out->point_a, &out->saturated);
    set_close_point(b, 0, 0, 0, 0, 0, &across, -1, &out->point_b, &out->saturated);
    out->saturated = out->saturated && !overlaps;
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

bool gjk2_touch_axes(const gjk2_collider *a, const gjk2_collider *b, unsigned parts, gjk2_distance_result *out) {
  close_pair of;
  if (!is_near_enough(a, b)) {
    return false;
  }
  if (a->count == 1 && b->count == 1) {
    of.d_x = (close_number)b->centre.x - a->centre.x;
    of.d_y = (close_number)b->centre.y - a->centre.y;
    of.base = -close_dot(of.d_x, of.d_y, of.d_x, of.d_y);
    if (of.base == 0) {
      return false;
    }
    measure_touch(a, b, &of, true, parts, out);
    return true;
  }
  if (!has_axes(a, b) || !find_closest(a, b, &of)) {
    return false;
  }
  measure_touch(a, b, &of, false, parts, out);
  return true;
}
#else

bool gjk2_touch_axes(const gjk2_collider *a, const gjk2_collider *b, unsigned parts, gjk2_distance_result *out) {
  (void)a, (void)b, (void)parts, (void)out;
  return false;
}

#endif
