// Vectors of integers: exact sums, dot and cross products, and signs along directions.
#ifndef GJK_SRC_VECTOR_H
#define GJK_SRC_VECTOR_H

#include "gjk/format.h"
#include "gjk_wide.h"

// A normal or other vector of 64-bit components.
typedef struct gjk_long3 {
  int64_t x, y, z;
} gjk_long3;

// The corner of a triangle, or the axis, that follows number i.
static inline unsigned gjk_next(unsigned i) {
  return i < 2 ? i + 1 : 0;
}

// The component of v along an axis, 0 to 2.
static inline int32_t gjk_component(const gjk_vec3 *v, unsigned axis) {
  return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

static inline int64_t gjk_long_component(const gjk_long3 *v, unsigned axis) {
  return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

// a + b. Pre: each component of the sum fits.
static inline gjk_vec3 gjk_add(gjk_vec3 a, gjk_vec3 b) {
  gjk_vec3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
  return sum;
}

// a - b. Pre: each component of the difference is below 2^31 in size, so that gjk_negate may take it.
static inline gjk_vec3 gjk_sub(gjk_vec3 a, gjk_vec3 b) {
  gjk_vec3 difference = {a.x - b.x, a.y - b.y, a.z - b.z};
  return difference;
}

// -a. Pre: no component is INT32_MIN.
static inline gjk_vec3 gjk_negate(gjk_vec3 a) {
  gjk_vec3 opposite = {-a.x, -a.y, -a.z};
  return opposite;
}

// *to = *from, by parts: GCC makes some copies a call of memcpy on ARMv6-M.
static inline void gjk_set(const gjk_vec3 *from, gjk_vec3 *to) {
  to->x = from->x;
  to->y = from->y;
  to->z = from->z;
}

// |x| + |y| + |z|. Pre: at most 2^32 - 1.
static inline uint32_t gjk_norm1(gjk_vec3 v) {
  return gjk_magnitude32(v.x) + gjk_magnitude32(v.y) + gjk_magnitude32(v.z);
}

// n . v = 2^31 (returned) + *low, 0 <= *low < 2^31, exact. Pre: |n| < 2^62, |v| <= 2^31, lengths.
int64_t gjk_dot_exact(const gjk_long3 *n, const gjk_vec3 *v, uint32_t *low);

// The sign of n . v. Pre: |n| < 2^62.9, |v| <= 2^31, lengths.
int gjk_dot_sign_exact(const gjk_long3 *n, const gjk_vec3 *v);

// a . b, a x b, a triangle's normal, by v / 2^n, the sign of n . v and of p q + r s: in line in a build for speed, one copy in a build for size.
#if GJK_SMALL
int64_t gjk_dot(const gjk_vec3 *a, const gjk_vec3 *b);
void gjk_cross(const gjk_vec3 *a, const gjk_vec3 *b, gjk_long3 *out);
void gjk_triangle_normal(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, gjk_long3 *out);
void gjk_scaled(const gjk_vec3 *v, int32_t by, unsigned n, gjk_vec3 *out);
int gjk_dot_sign(const gjk_long3 *n, const gjk_vec3 *v);
int gjk_sum_of_products_sign(int64_t p, int64_t q, int64_t r, int64_t s);
#else
#define GJK_HOT static inline
#include "gjk_vector_inline.h"
#endif

// A vertex of a shape.
typedef struct gjk_support {
  gjk_vec3 offset;  // from the collider's centre, Q16.16
  uint16_t vertex;  // the vertex's number; 0 for curved shapes
} gjk_support;

// The exact direction from a feature to the origin, by the vertices that span the feature:
//   1 vertex     -a
//   2 vertices   -(a tb + b ta)     ta = a . (a - b), tb = b . (b - a):  0 < ta, tb <= 2^61
//   3 vertices   n
typedef struct gjk_direction {
  const gjk_vec3 *a, *b;
  const gjk_long3 *n;
  int64_t ta, tb;    // set for spanning == 2
  uint8_t spanning;  // 1, 2 or 3
  bool opposite;     // the direction meant is the opposite
  // Numbers of three vertices of the shape at hand, some of them perhaps the same, that are equally far along the
  // direction. NULL: none are known; a build for size knows none.
  const uint16_t *level;
  // What a refinement finds: how many other vertices, or of a box how many half axes of a length, are exactly as far along
  // the direction as the vertex that it ends at.
  unsigned ties;
} gjk_direction;

// Is the vertex one of those known to be equally far along the direction?
static inline bool gjk_direction_knows(const gjk_direction *direction, unsigned vertex) {
  const uint16_t *level = direction->level;
  return !GJK_SMALL && level != NULL && (level[0] == vertex || level[1] == vertex || level[2] == vertex);
}

// How many vertices beside the first are known to be level.
static inline unsigned gjk_direction_known(const gjk_direction *direction) {
  const uint16_t *level = direction->level;
  return (level[1] != level[0] ? 1u : 0u) + (level[2] != level[0] && level[2] != level[1] ? 1u : 0u);
}

// The sign of v along the exact direction. Pre: |v| <= 2^30.
int gjk_direction_sign(const gjk_direction *direction, const gjk_vec3 *v);

// A direction as the support scans take it: the exact one / 2^k for some k. Each component is off by less than 1.
typedef struct gjk_search_direction {
  gjk_vec3 d;  // components at most 2^30 in size, 3 2^29 for a vertex
  bool exact;  // d is a positive multiple of the exact direction
} gjk_search_direction;

// Rounds -(a tb + b ta). False when that is zero. Pre: |a|, |b| <= 3 2^29; 0 < ta, tb <= 2^61.
bool gjk_search_direction_of_edge(const gjk_vec3 *a, int64_t tb, const gjk_vec3 *b, int64_t ta,
                                  gjk_search_direction *out);

// Rounds n to the nearest integers, with the least k >= 0 that leaves every component at most 2^30 in size.
// Pre: |n| < 2^62 per component.
void gjk_search_direction_of(const gjk_long3 *n, gjk_search_direction *out);

// d 2^k with the largest k >= 0 that leaves every component below 2^30 in size, or d when none does. Pre: d != 0.
static inline gjk_vec3 gjk_scale_direction(const gjk_vec3 *d) {
  const uint32_t bits = gjk_magnitude32(d->x) | gjk_magnitude32(d->y) | gjk_magnitude32(d->z);
  const unsigned zeros = gjk_clz32(bits), k = zeros > 2 ? zeros - 2 : 0;
  gjk_vec3 scaled = {gjk_shl32(d->x, k), gjk_shl32(d->y, k), gjk_shl32(d->z, k)};
  return scaled;
}

#endif
