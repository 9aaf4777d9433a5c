// A line, and A - B beside it: the frame in which casts of polytopes search (gjk_portal.h), and its exact signs.
//
// Vertices of A - B are w = u + start, where start is centre_a - centre_b, and u the offset of A's vertex less that of B's.
// The line is that of all s t, so a vertex may be moved along t: everything beside the line is measured with t x w = t x u + m.
//
// Signs do not depend on scale. So u is multiplied by 2^shift, and t by a power of two, until they fill 29 and 30 bits.
// Then the filters on high words settle nearly every sign.
//
//   quantity                                            size, scaled               held in
//   u, difference of two u                              < 2^29, 2^30               int32
//   t, per component                                    < 2^30; wide: < 2^32       int32; int64
//   start, per component, in LSB                        < 2^32                     int64
//   part of start across t, of w                        < 2^29, 2^30               by the bounding spheres
//   m = t x start, t x w, g x t with |g| < 2^30         < 2^60.8; wide: < 2^62.8   int64
//   det(t, w_i, w_j) = (t x w_i) . (u_j - u_i)          < 2^93                     96 bits
//   n = (w_1 - w_0) x (w_2 - w_0)                       < 2^60                     int64
//   n . w, n . t, with w and t in LSB                   < 2^93                     96 bits
#ifndef GJK_SRC_PORTAL_FRAME_H
#define GJK_SRC_PORTAL_FRAME_H

#include "../shape/gjk_shape_class.h"
#include "gjk_way.h"

// A vertex of A - B by its numbers.
typedef struct gjk_corner {
  gjk_vec3 u;  // scaled
  uint16_t a, b;
} gjk_corner;

typedef struct gjk_portal {
  const gjk_collider *a, *b;
  gjk_long3 way;         // the way in LSB, or any axis where there is none
  gjk_long3 start;       // centre_a - centre_b, LSB
  gjk_long3 goal;        // start, less the point of the line that the search looks towards: the way's end, or its start
  gjk_long3 m;           // t x start, both scaled
  gjk_long3 n;           // normal of the plane of the last support scan
  gjk_vec3 t;            // scaled; not set where wide
  gjk_vec3 g;            // BESIDE: n = g x t
  gjk_vec3 inward[2];    // u of two vertices; ties count as if the line were moved a little towards them
  gjk_corner corner[4];  // the first count span what the line passes through; the last is the newest vertex
  gjk_search_direction direction;  // n, rounded
  gjk_support of_a, of_b;          // of the last support scan
  uint8_t shift;                   // of u
  uint8_t count;                   // corners in use
  uint8_t iterations;
  uint8_t axis;  // count 1 and 2: the axis that makes a normal
  int8_t side;   // count 2: on which side of the line the first corner lies
  bool wide;     // a component of the way is 2^30 LSB or more: t is the way itself
  bool near;     // start and goal are at most 2^29 LSB per component, and not wide
  bool arrives;  // a point of A - B on the line lies before the way's end
  bool leaving;  // n . t > 0: the search looks for where the line leaves A - B
  bool lone;     // B is a point: of_b stays
} gjk_portal;

// Is the collider's core a point?
static inline bool gjk_portal_is_point(const gjk_collider *c) {
  return c->shape->type->kind == GJK_KIND_AXES && c->count == 0;
}

// *u = the offset of A's vertex less that of B's, scaled: below 2^29, since both lie within their core radii.
static inline void gjk_portal_scale(const gjk_portal *p, const gjk_vec3 *a, const gjk_vec3 *b, gjk_vec3 *u) {
  u->x = gjk_shl32(a->x - b->x, p->shift);
  u->y = gjk_shl32(a->y - b->y, p->shift);
  u->z = gjk_shl32(a->z - b->z, p->shift);
  //@ assert u->x > -(INT32_C(1) << 29) && u->x < INT32_C(1) << 29;
  //@ assert u->y > -(INT32_C(1) << 29) && u->y < INT32_C(1) << 29;
  //@ assert u->z > -(INT32_C(1) << 29) && u->z < INT32_C(1) << 29;
}

// *to = *from, by parts: GCC makes a copy a call of memcpy on ARMv6-M.
static inline void gjk_portal_copy(const gjk_long3 *from, gjk_long3 *to) {
  to->x = from->x;
  to->y = from->y;
  to->z = from->z;
}

// Fills in a, b, way, start and goal.
static inline void gjk_portal_place(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way) {
  p->a = a;
  p->b = b;
  gjk_portal_copy(&way->t, &p->way);
  p->start.x = (int64_t)a->centre.x - b->centre.x;
  p->start.y = (int64_t)a->centre.y - b->centre.y;
  p->start.z = (int64_t)a->centre.z - b->centre.z;
  p->goal.x = p->start.x - way->t.x;
  p->goal.y = p->start.y - way->t.y;
  p->goal.z = p->start.z - way->t.z;
}

// How much farther from the line than the core radii the bounding spheres may leave start, rounded up (gjk_spheres.h).
#define GJK_LINE_SLACK 1024

// The shift of the pair: both |u| and the part of start across the line are at most the core radii plus GJK_LINE_SLACK.
static inline uint8_t gjk_portal_shift(const gjk_collider *a, const gjk_collider *b) {
  return (uint8_t)(gjk_clz32((uint32_t)(a->core_radius + b->core_radius) + GJK_LINE_SLACK) - 3);
}

// Fills in what does not change during a search: as gjk_portal_place, and shift, t and m. Sets iterations to 0 and
// leaving to false.
void gjk_portal_start(gjk_portal *p, const gjk_collider *a, const gjk_collider *b, const gjk_way *way);

// *out = t x v.
void gjk_portal_cross(const gjk_portal *p, const gjk_vec3 *v, gjk_long3 *out);

// *out = t x w, for the vertex w with this u.
static inline void gjk_portal_lateral(const gjk_portal *p, const gjk_vec3 *u, gjk_long3 *out) {
  gjk_portal_cross(p, u, out);
  out->x += p->m.x;
  out->y += p->m.y;
  out->z += p->m.z;
}

// The sign of det(t, w_i, w_j) = (t x w_i) . (w_j - w_i), for v = t x w_i: on which side of w_i w_j lies, seen along t.
static inline int gjk_portal_turn(const gjk_long3 *v, const gjk_vec3 *i, const gjk_vec3 *j) {
  const gjk_vec3 step = gjk_sub(*j, *i);
  return gjk_dot_sign(v, &step);
}

// Makes n = g x t, for which n . w = g . (t x w), and the sign of that. Pre: |g| <= 2^30.
void gjk_portal_face(gjk_portal *p, const gjk_vec3 *g);
int gjk_portal_beside(const gjk_portal *p, const gjk_vec3 *u);

// The sign of n . (u + at). As gjk_portal_dot; at is start, goal or way.
int gjk_portal_side(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at);

// n . (u + at) = 2^31 (returned) + *low, 0 <= *low < 2^31, exact; u, scaled, is divided by its scale. NULL: 0.
// Pre: |n| < 2^60, components of at below 2^32 + 2^31 in size.
int64_t gjk_portal_dot(const gjk_portal *p, const gjk_vec3 *u, const gjk_long3 *at, uint32_t *low);

// In what proportions the corners make up the point where the line passes through them: weight[i] of corner i < count.
void gjk_portal_weights(const gjk_portal *p, gjk_u128 weight[3]);

// The axis of the largest component.
static inline uint8_t gjk_portal_main_axis(const gjk_long3 *v) {
  const uint64_t x = gjk_magnitude64(v->x), y = gjk_magnitude64(v->y), z = gjk_magnitude64(v->z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

int64_t gjk_portal_component(const gjk_long3 *v, unsigned axis);

// The components' magnitudes, joined by or: as many bits as the largest has.
static inline uint64_t gjk_portal_bits(const gjk_long3 *v) {
  return gjk_magnitude64(v->x) | gjk_magnitude64(v->y) | gjk_magnitude64(v->z);
}

static inline bool gjk_portal_is_zero(const gjk_long3 *v) {
  return (v->x | v->y | v->z) == 0;
}

#endif
