// The separation along a direction, and how long it holds.
//
//   1. Measure s at x, the start at first. It has to be above the target.
//   2. Choose y shortly before s is expected to meet the target, but so near that c <= s(x) - target: then chord less
//      parabola has no root where s(y) is not below the target. Measure s there.
//   3. Without a root the next x is y; else it is the first root.
//   4. On from 1 or 2, until x is the end, s is near the target or likely to be, or STEPS_MAX are done.
//
// What is expected follows from the last two measurements, at first from how fast the nearest points approach each other.
// With turns yet to come the spheres' bound, which is a chord, may reach farther.
//
// Units: separations are in LSB, Q8; angles in radians, Q16; parts of the way in Q30.
#include "gjk_impact_separation.h"

#include "../arith/gjk_root.h"
#include "../arith/gjk_rotation.h"
#include "../arith/gjk_unit.h"
#include "../shape/gjk_scan.h"

// The most steps along one direction, of one or two separations each.
#define STEPS_MAX 16

// At a root of chord less parabola, s - target is likely below c / 2. A search ends there without measuring it where c is at
// most so many times what it would end at.
#define NEAR_ROOT 16

// The parabola is taken over angles below this one, 8 radians.
#define ANGLE_MAX (UINT32_C(8) << 16)

// A direction turns with two edges only where the sine of the angle between them is at least 1/8: of others the normal says
// little, and turns fast.
#define SINE_MIN (UINT32_C(1) << 27)

// v . d, Q8, rounded down. near: components of d are int32.
// Pre: |v| <= 2^30 + 2^5; |d| <= sqrt(3) 2^32:  the product is below 2^63
static int64_t along_q8(const gjk_unit3 *v, const gjk_long3 *d, bool near) {
  if (near && !GJK_SMALL) {
    const gjk_vec3 narrow = {gjk_int32(gjk_low32(d->x)), gjk_int32(gjk_low32(d->y)), gjk_int32(gjk_low32(d->z))};
    return gjk_sar64(gjk_along(v, &narrow), 22);
  }
  return gjk_sar64(v->x * d->x + v->y * d->y + v->z * d->z, 22);
}

GJK_ONE_COPY static void between(const gjk_vec3 *a, const gjk_vec3 *b, gjk_long3 *out) {
  out->x = (int64_t)b->x - a->x;
  out->y = (int64_t)b->y - a->y;
  out->z = (int64_t)b->z - a->z;
}

// low + part / 2^30 (high - low), at most 2 too small. Pre: |high - low| < 2^45.
static int64_t blend_q8(int64_t low, int64_t high, gjk_q30 part) {
  const int64_t way = high - low;
  const int32_t coarse = (int32_t)gjk_sar64(way, 15), fine = (int32_t)(way - gjk_shl64(coarse, 15));
  return low + gjk_sar64(gjk_mul32(coarse, part), 15) + gjk_sar64(gjk_mul32(fine, part), 30);
}

// s along one direction: what does not depend on the fraction.
typedef struct separation_course {
  const gjk_separation *of;
  int64_t target;     // Q8
  gjk_turned split;   // n as the carrier sees it
  bool is_fixed[2];   // the body's extent does not change:
  int64_t extent[2];  // this one, Q8
} separation_course;

// v . (p_b - p_a) at a fraction, Q8, at most 4 too small.
static int64_t between_positions(const separation_course *of, const gjk_unit3 *v, gjk_q30 fraction) {
  const gjk_movers *pair = of->of->pair;
  return blend_q8(along_q8(v, &pair->from, pair->near), along_q8(v, &pair->to, pair->near), fraction);
}

// How far a body's core reaches along d, from the position that it is posed at, Q8, rounded down. d: a unit vector.
// Of a lazy hull without a table it is that of the shape's own vertices, turned in real numbers: within what posing does.
static int64_t extent_along(const gjk_mover *m, const gjk_unit3 *d) {
  const gjk_collider *c = &m->collider;
  const gjk_vec3 along = {d->x, d->y, d->z};
  const gjk_shape *shape = c->shape;
  if (gjk_is_buffered(shape->type) && shape->user == NULL && c->buffer == NULL) {
    const gjk_vec3 local = gjk_rotate_back(c->frame, &along), *first = shape->vertices;
    const gjk_vec3 *v = gjk_scan(first, first + shape->count, 31, &local);
    gjk_long3 carried;
    between(&m->place, &c->position, &carried);
    return gjk_sar64(gjk_dot(&local, v), 22) + (m->own != NULL ? along_q8(d, &carried, false) : 0);
  }
  gjk_long3 reach;
  between(&m->place, &c->centre, &reach);
  if (GJK_SHAPES >= GJK_SHAPES_ROUND) {
    gjk_support at;
    shape->type->support(c, &along, &at);
    reach.x += at.offset.x;
    reach.y += at.offset.y;
    reach.z += at.offset.z;
  }
  return along_q8(d, &reach, m->reach >> 31 == 0);
}

static gjk_unit3 opposite_unit(const gjk_unit3 *v) {
  const gjk_unit3 negative = {-v->x, -v->y, -v->z};
  return negative;
}

// A body's extent towards the other one along d, Q8, rounded up.
static int64_t extent_towards(const gjk_separation *s, int i, const gjk_unit3 *d) {
  const gjk_unit3 opposite = opposite_unit(d);
  return extent_along(&s->pair->mover[i], i == 0 ? d : &opposite) + 1;
}

static void start_course(separation_course *of, const gjk_separation *s, int64_t target) {
  const gjk_turning *carrier = gjk_separation_carrier(s);
  of->of = s;
  of->target = target;
  if (carrier != NULL) {
    gjk_turning_split(carrier, &s->n, &of->split);
  }
  for (int i = 0; i < 2; i++) {
    const gjk_turning *turning = &s->pair->mover[i].turning;
    of->is_fixed[i] = carrier == turning || (carrier == NULL && turning->half_turns == 0);
    of->extent[i] = of->is_fixed[i] ? extent_towards(s, i, &s->n) : 0;
  }
}

// A body's extent towards the other one along v after part of the way, Q8, rounded up: the body turns on, or v turns back.
static int64_t extent_after_turn(const gjk_separation *s, int i, gjk_q30 part, const gjk_unit3 *v) {
  const gjk_turning *turning = &s->pair->mover[i].turning;
  gjk_turned split;
  gjk_unit3 back;
  if (turning->half_turns == 0) {
    return extent_towards(s, i, v);
  }
  gjk_turning_split(turning, v, &split);
  gjk_turning_join(turning, part, true, &split, &back);
  return extent_towards(s, i, &back);
}

// s - target at a fraction from the start on, Q8, within 8.
static int64_t separation_at(const separation_course *of, gjk_q30 fraction) {
  const gjk_separation *s = of->of;
  const gjk_q30 part = fraction - s->start;
  const gjk_turning *carrier = gjk_separation_carrier(s);
  gjk_unit3 v = s->n;
  if (carrier != NULL) {
    gjk_turning_join(carrier, part, false, &of->split, &v);
  }
  int64_t above = between_positions(of, &v, fraction) - of->target;
  for (int i = 0; i < 2; i++) {
    if (of->is_fixed[i]) {
      above -= of->extent[i];
    } else {
      above -= extent_after_turn(s, i, part, &v);
    }
  }
  return above;
}

// What of the bounds does not depend on the part of the way.
typedef struct separation_bounds {
  uint32_t angle[3];  // over the whole way, radians, Q16, rounded up; 0: nothing turns; [2]: the direction
  uint32_t across;    // k of a direction that turns, Q16, rounded up
  uint32_t arm[2];    // r of a body that turns, but not with the direction, LSB; k r where the direction stands still
  uint64_t apart;     // |p_b - p_a| from the start on, LSB
} separation_bounds;

// The angle over the whole way: 4 pi half_turns / 2^48 radians, Q16, rounded up.  half_turns / 2^29 < 2^32
static uint32_t whole_angle(const gjk_turning *turning) {
  if (turning->half_turns == 0) {
    return 0;
  }
  const uint64_t turns = (turning->half_turns >> 29) + 1;
  return (uint32_t)(gjk_umul32((uint32_t)turns, UINT32_C(3373259427)) >> 31) + 1;
}

// *cross = a x b, Q30, each component less than 1 off.
static void cross_q30(const gjk_unit3 *a, const gjk_unit3 *b, gjk_vec3 *cross) {
  const gjk_vec3 u = {a->x, a->y, a->z}, v = {b->x, b->y, b->z};
  gjk_long3 wide;
  gjk_cross(&u, &v, &wide);
  cross->x = (int32_t)gjk_sar64(wide.x, 30);
  cross->y = (int32_t)gjk_sar64(wide.y, 30);
  cross->z = (int32_t)gjk_sar64(wide.z, 30);
}

// At least the length of a vector with such components: the largest and half of the others.
static uint64_t length_bound(uint64_t a, uint64_t b, uint64_t c) {
  const uint64_t most = a > b ? (a > c ? a : c) : (b > c ? b : c);
  return (most + a + b + c + 1) / 2;
}

// The sine of the angle between axis and n, Q16, or more, at most by a quarter.
static uint32_t sine_between(const gjk_unit3 *axis, const gjk_unit3 *n) {
  gjk_vec3 cross;
  cross_q30(axis, n, &cross);
  const uint64_t length = length_bound(gjk_magnitude32(cross.x), gjk_magnitude32(cross.y), gjk_magnitude32(cross.z));
  const uint32_t sine = (uint32_t)(length >> 14) + 2;
  return sine < (UINT32_C(1) << 16) + 2 ? sine : (UINT32_C(1) << 16) + 2;
}

// At least the distance between two points.
GJK_OUT_OF_LINE static uint64_t distance_bound(const gjk_vec3 *p, const gjk_vec3 *q) {
  return length_bound(gjk_magnitude64((int64_t)q->x - p->x), gjk_magnitude64((int64_t)q->y - p->y),
                      gjk_magnitude64((int64_t)q->z - p->z));
}

// x y / 2^16, rounded up. Pre: the product is below 2^63.
GJK_ONE_COPY static uint64_t q16_product(uint64_t x, uint32_t y) {
  return ((x * y) >> 16) + 1;
}

// False: the direction turns, and the bodies are so far apart that its rounding would count.
static bool set_separation_bounds(separation_bounds *of, const gjk_separation *s) {
  const gjk_turning *carrier = gjk_separation_carrier(s);
  const uint64_t now = distance_bound(&s->pair->mover[0].place, &s->pair->mover[1].place) + 2, end = s->pair->end;
  of->apart = now > end ? now : end;
  for (int i = 0; i < 2; i++) {
    const gjk_turning *turning = &s->pair->mover[i].turning;
    of->arm[i] = 0;
    of->angle[i] = carrier == turning ? 0 : s->pair->mover[i].angle;
    if (of->angle[i] != 0) {
      of->arm[i] = carrier != NULL
                       ? s->pair->mover[i].reach
                       : (uint32_t)q16_product(s->pair->mover[i].reach, sine_between(&turning->axis, &s->n));
    }
  }
  of->angle[2] = carrier == NULL ? 0 : whole_angle(carrier);
  of->across = carrier == NULL ? 0 : sine_between(&carrier->axis, &s->n);
  return carrier == NULL || of->apart <= 4 * ((uint64_t)s->pair->mover[0].reach + s->pair->mover[1].reach);
}

// length w^2, Q16, rounded up, in two steps: the second factor alone keeps its fraction. Pre: length < 2^34, w < 2^19.
static uint64_t times_square(uint64_t length, uint32_t w) {
  return q16_product(length, w) * w;
}

// c over a part of the way, Q8, rounded up. Pre: no body turns by ANGLE_MAX there.
GJK_ONE_COPY static uint64_t parabola_over(const separation_bounds *of, const gjk_separation *s, gjk_q30 part) {
  const gjk_turning *carrier = gjk_separation_carrier(s);
  uint32_t w[3];  // angles, Q16
  for (int i = 0; i < 3; i++) {
    w[i] = of->angle[i] == 0 ? 0 : (uint32_t)(gjk_umul32(of->angle[i], (uint32_t)part) >> 30) + 1;
  }
  const uint64_t turned_a = q16_product(of->arm[0], w[0]), turned_b = q16_product(of->arm[1], w[1]);
  uint64_t twice = turned_a * w[0] + turned_b * w[1];  // Q16, each term below 2^57
  if (carrier != NULL) {
    const uint64_t moved = ((s->pair->way / 16 + 1) * (uint32_t)part >> 26) + 1;
    twice +=
        times_square(q16_product(of->apart + (carrier == &s->pair->mover[0].turning ? 0 : s->pair->mover[0].reach) +
                                     (carrier == &s->pair->mover[1].turning ? 0 : s->pair->mover[1].reach),
                                 of->across),
                     w[2]) +
        2 * q16_product(moved + turned_a + turned_b, of->across) * w[2];
  }
  return (twice >> 9) + 1;
}

// c over any part of the way, up to the longest in which no body turns by ANGLE_MAX: it grows with the part's square.
typedef struct separation_parabola {
  uint32_t leading;  // c over the longest part, Q8, is at most leading 2^scale
  unsigned scale;
  unsigned cut;  // the longest part is 2^-cut of the way
} separation_parabola;

static void set_parabola(separation_parabola *of, const separation_bounds *bounds, const gjk_separation *s) {
  const uint32_t angle = bounds->angle[0] | bounds->angle[1] | bounds->angle[2];
  of->cut = angle < ANGLE_MAX - 1 ? 0 : 14 - gjk_clz32(angle);
  const uint64_t c = parabola_over(bounds, s, GJK_Q30_ONE >> of->cut);
  const unsigned zeros = gjk_clz64(c);
  of->scale = zeros < 33 ? 33 - zeros : 0;
  of->leading = (uint32_t)(c >> of->scale) + 1;  // at most 2^31
}

// c over a part of the way, Q8, rounded up. Pre: it is not longer than the longest.
static int64_t parabola(const separation_parabola *of, gjk_q30 part) {
  const uint32_t share = (uint32_t)part << of->cut;                              // of the longest part, Q30
  const uint32_t square = (uint32_t)(gjk_umul32(share, share) >> 30) + 1;        // at most 2^30 + 1
  return (int64_t)(((gjk_umul32(of->leading, square) >> 30) + 1) << of->scale);  // below 2^51
}

// 2^(62 - k) / x, rounded down, at most 2^-28 of itself too small, below 2^31. k: the leading zeros of x. Pre: x > 0.
static uint32_t reciprocal_of(uint32_t x, unsigned k) {
  const uint32_t root = gjk_reciprocal_root(x << k) - 1;
  return (uint32_t)(gjk_umul32(root, root) >> 30);
}

// The first root of g (1 - z) + h z - c z (1 - z) from 0 to 1, Q30, rounded down; GJK_Q30_ONE where there is none.
// That is  2 g / (b + sqrt(b^2 - 4 c g))  with  b = g - h + c.  Pre: g > 0, c >= 0, all at most 2^51 in size.
static gjk_q30 first_root(int64_t g, int64_t h, int64_t c) {
  const unsigned zeros = gjk_clz64(gjk_magnitude64(g) | gjk_magnitude64(h) | gjk_magnitude64(c));
  const unsigned down = zeros < 36 ? 36 - zeros : 0;  // to 28 bits
  const int32_t gs = (int32_t)gjk_sar64(g, down), cs = (int32_t)gjk_sar64(c, down) + (down > 0 ? 1 : 0);
  const int32_t hs = (int32_t)gjk_sar64(h, down), b = gs - hs + cs;  // |b| <= 3 2^28
  const int64_t rest = gjk_mul32(b, b) - 4 * gjk_mul32(cs, gs);      // |rest| < 2^61
  if (hs >= 0 && (b >= 2 * (int64_t)cs || b <= 0 || rest < 0)) {
    return GJK_Q30_ONE;
  }
  const uint32_t whole = (uint32_t)b + gjk_isqrt64((uint64_t)rest) + 1;  // below 2^31
  const unsigned k = gjk_clz32(whole);
  const uint64_t z = gjk_umul32((uint32_t)gs, reciprocal_of(whole, k)) >> (31 - k);
  return z < (uint64_t)GJK_Q30_ONE ? (gjk_q30)z : GJK_Q30_ONE;
}

// 2^34 / (2 pi), half of it for half an angle.
#define TURNS_PER_RADIAN UINT32_C(2734261102)

// The direction of an edge of a posed core. Pre: two of the named vertices are different. False: they are at one place.
static bool edge_of(const gjk_mover *m, const uint16_t number[4], gjk_unit3 *out) {
  const gjk_collider *c = &m->collider;
  gjk_vec3 v, w;
  (void)c->shape->type->vertex(c, number[0], &v);
  (void)c->shape->type->vertex(c, number[number[1] != number[0] ? 1 : 2], &w);
  const gjk_vec3 edge = gjk_sub(w, v);  // below 2^29
  if ((edge.x | edge.y | edge.z) == 0) {
    return false;
  }
  *out = gjk_unit(&edge);
  return true;
}

// u . v of unit vectors, Q30.
static int32_t cosine_between(const gjk_unit3 *u, const gjk_vec3 *v) {
  return (int32_t)gjk_sar64(gjk_along(u, v), 30);
}

// How far a turning tilts an edge towards n over the whole way, angle axis . (edge x n), radians, Q16.
// Pre: less than a turn, so below 2^19.
static int32_t tilt_of(const gjk_mover *m, const gjk_unit3 *edge, const gjk_unit3 *n) {
  gjk_vec3 cross;
  if (m->angle == 0) {
    return 0;
  }
  cross_q30(edge, n, &cross);
  return (int32_t)gjk_sar64((int64_t)m->angle * cosine_between(&m->turning.axis, &cross), 30);
}

// One component of q a - p b, 2^-20 of it. The whole is below 2^30 in length, but for rounding. Pre: |p|, |q| <= 2^19.
static int32_t blend_edges(int32_t p, int32_t q, gjk_q30 a, gjk_q30 b) {
  return (int32_t)gjk_sar64(gjk_mul32(q, a) - gjk_mul32(p, b), 20);
}

// The normal n stays across both edges, a and b, if it turns by (q a - p b) / (n . a x b), where p and q are their tilts.
bool gjk_turning_of_edges(const gjk_mover mover[2], const gjk_certificate *nearest, const gjk_unit3 *n,
                          gjk_turning *out) {
  const gjk_turning *of_a = &mover[0].turning, *of_b = &mover[1].turning;
  gjk_unit3 a, b;
  gjk_vec3 cross;
  if ((of_a->half_turns | of_b->half_turns) >> 47 != 0 || !edge_of(&mover[0], nearest->a, &a) ||
      !edge_of(&mover[1], nearest->b, &b)) {
    return false;
  }
  cross_q30(&a, &b, &cross);
  const int32_t volume = cosine_between(n, &cross);
  const int32_t p = tilt_of(&mover[0], &a, n), q = tilt_of(&mover[1], &b, n);
  gjk_vec3 w = {blend_edges(p, q, a.x, b.x), blend_edges(p, q, a.y, b.y), blend_edges(p, q, a.z, b.z)};  // radians, Q26
  if (volume < 0) {
    w = gjk_negate(w);
  }
  const uint32_t sine = gjk_magnitude32(volume);
  if (sine < SINE_MIN || !gjk_axis_normalize(&w, &out->axis)) {
    return false;
  }
  // |w| / sine 2^48 / (4 pi), as (|w| 2^(62 - k) / sine / 2^30) 2^35 / (4 pi) 2^(k - 15); sine >= 2^27:  k <= 4
  const unsigned k = gjk_clz32(sine);
  const uint32_t ratio = (uint32_t)(gjk_umul32(gjk_isqrt64((uint64_t)gjk_dot(&w, &w)), reciprocal_of(sine, k)) >> 30);
  out->half_turns = gjk_umul32(ratio, TURNS_PER_RADIAN) >> (15 - k);
  return out->half_turns != 0;
}

// A lower bound of s - target at a fraction, whatever the rotations are there: bodies that turn count as spheres.
static int64_t of_spheres(const separation_course *of, gjk_q30 fraction) {
  const gjk_separation *s = of->of;
  int64_t bound = between_positions(of, &s->n, fraction) - of->target;
  for (int i = 0; i < 2; i++) {
    const gjk_mover *m = &s->pair->mover[i];
    bound -= m->turning.half_turns != 0 ? m->reach * INT64_C(256) : extent_towards(s, i, &s->n);
  }
  return bound;
}

// How fast a point of a body moves along n at the start, over the whole way, Q8: n . way + angle axis . (r x n).
//   |r| < 2^31, |n| <= 2^30 + 2^5:  below 2^61.1 and, times the axis, 2^62
static int64_t rate_of_point(const gjk_mover *m, const gjk_unit3 *n, const gjk_vec3 *point) {
  const gjk_motion *motion = m->motion;
  const gjk_vec3 *at = &m->place, along = {n->x, n->y, n->z};
  const gjk_vec3 axis = {m->turning.axis.x, m->turning.axis.y, m->turning.axis.z};
  gjk_long3 way;
  between(&motion->from.position, &motion->to.position, &way);
  const int64_t rate = along_q8(n, &way, false);
  const uint32_t angle = m->angle;
  if (angle == 0 || m->reach >> 30 != 0) {
    return rate;
  }
  const gjk_vec3 r = {point->x - at->x, point->y - at->y, point->z - at->z};
  gjk_long3 across;
  gjk_cross(&r, &along, &across);
  const gjk_vec3 lever = {(int32_t)gjk_sar64(across.x, 30), (int32_t)gjk_sar64(across.y, 30),
                          (int32_t)gjk_sar64(across.z, 30)};
  return rate + gjk_sar64(gjk_sar64(gjk_dot(&axis, &lever), 30) * (int64_t)angle, 8);
}

int64_t gjk_separation_fall(const gjk_separation *s, const gjk_vec3 *point_a, const gjk_vec3 *point_b) {
  return rate_of_point(&s->pair->mover[0], &s->n, point_a) - rate_of_point(&s->pair->mover[1], &s->n, point_b);
}

// Where a search along one direction stands.
typedef struct separation_state {
  gjk_q30 x;
  int64_t g;     // s - target at x, Q8
  int64_t fall;  // how much that falls, Q8,
  gjk_q30 over;  // over this part of the way: an estimate of its slope
} separation_state;

// After which part of the way s meets the target, by the estimate: over g / fall, at most GJK_Q30_ONE. Pre: g > 0.
static gjk_q30 expected_part(const separation_state *at) {
  if (at->fall <= 0) {
    return GJK_Q30_ONE;
  }
  // g = 2^(32 - zeros) leading, and fall alike; 2^30 <= 2^62 / leading <= 2^31
  const unsigned zeros = gjk_clz64((uint64_t)at->g), zeros2 = gjk_clz64((uint64_t)at->fall);
  const uint32_t g = (uint32_t)((uint64_t)at->g << zeros >> 32), fall = (uint32_t)((uint64_t)at->fall << zeros2 >> 32);
  const uint64_t product = gjk_umul32(gjk_umulh32(g, reciprocal_of(fall, 0)), (uint32_t)at->over);  // at most 2^61
  if (30 + zeros <= zeros2) {
    return GJK_Q30_ONE;
  }
  const unsigned down = 30 + zeros - zeros2;
  const uint64_t part = down < 64 ? product >> down : 0;
  return part < (uint64_t)GJK_Q30_ONE ? (gjk_q30)part : GJK_Q30_ONE;
}

// Step 2: y - x, and *c over it.
static gjk_q30 choose_part(const separation_state *at, const separation_parabola *of, int64_t enough, int64_t *c) {
  const gjk_q30 left = GJK_Q30_ONE - at->x, longest = GJK_Q30_ONE >> of->cut, expected = expected_part(at);
  gjk_q30 part = left < longest ? left : longest;
  if (expected < part) {
    // Before what is expected, by an eighth or by what the parabola allows the estimate to be off.
    const int64_t off = parabola(of, expected) + 4 * enough;
    unsigned k = 3;
    while (k < 30 && off <= gjk_sar64(at->g, k - 2)) {
      k++;
    }
    part = expected - (expected >> k);
  }
  for (*c = parabola(of, part); part > 1 && *c > at->g; *c = parabola(of, part)) {  // at most 40 times
    part -= (*c > 4 * at->g ? part / 2 : part / 4) + (part < 4 ? 1 : 0);
  }
  if (part <= 0) {
    part = 1;
    *c = parabola(of, 1);
  }
  return part;
}

void gjk_movers_start(gjk_movers *of) {
  const gjk_motion *a = of->mover[0].motion, *b = of->mover[1].motion;
  of->way = 0;
  for (int i = 0; i < 2; i++) {
    gjk_mover *m = &of->mover[i];
    m->angle = whole_angle(&m->turning);
    of->way += distance_bound(&m->motion->from.position, &m->motion->to.position);
  }
  between(&a->from.position, &b->from.position, &of->from);
  between(&a->to.position, &b->to.position, &of->to);
  of->end = distance_bound(&a->to.position, &b->to.position);
  of->near = !GJK_SMALL && (distance_bound(&a->from.position, &b->from.position) | of->end) >> 31 == 0;
}

gjk_q30 gjk_separation_of_spheres(const gjk_movers *pair, int64_t target) {
  const gjk_long3 *from = &pair->from;
  const int64_t apart = target + ((int64_t)pair->mover[0].reach + pair->mover[1].reach) * 256;
  gjk_search_direction direction;
  if ((from->x | from->y | from->z) == 0) {
    return 0;
  }
  gjk_search_direction_of(from, &direction);
  const gjk_unit3 n = gjk_unit(&direction.d);
  const int64_t g = along_q8(&n, from, false) - apart;
  return g > 0 ? first_root(g, along_q8(&n, &pair->to, false) - apart, 0) : 0;
}

gjk_q30 gjk_separation_holds(gjk_separation *s, int64_t above, int64_t target, int64_t enough) {
  separation_bounds bounds;
  separation_parabola of;
  if (!set_separation_bounds(&bounds, s)) {
    s->carrier = NULL;
    (void)set_separation_bounds(&bounds, s);
  }
  set_parabola(&of, &bounds, s);
  separation_course course;
  start_course(&course, s, target);
  separation_state at = {s->start, above, s->fall, GJK_Q30_ONE};
  if (above < 0) {
    at.g = separation_at(&course, s->start);
  }
  const int64_t stop = at.g / 64 > enough ? at.g / 64 : enough;
  for (unsigned i = 0; i < STEPS_MAX && at.g > stop && at.x < GJK_Q30_ONE; i++) {
    gjk_q30 part = GJK_Q30_ONE - at.x;
    int64_t c = 0, g = of.cut > 0 && part > GJK_Q30_ONE >> of.cut ? of_spheres(&course, at.x) : 0, h;
    if (g > 0) {
      h = of_spheres(&course, GJK_Q30_ONE);
    } else {
      part = choose_part(&at, &of, enough, &c);
      g = at.g;
      h = separation_at(&course, at.x + part);
    }
    // Step 3
    const gjk_q30 z = first_root(g, h, c);
    const gjk_q30 forward = z == GJK_Q30_ONE ? part : (gjk_q30)gjk_sar64(gjk_mul32(part, z), 30);
    if (forward == 0 && part == 1) {
      break;
    }
    at.x += forward;
    at.over = part;
    at.fall = g - h;
    if (z == GJK_Q30_ONE) {
      at.g = h;
    } else if (forward > 0) {
      if (c > 0 && c <= NEAR_ROOT * stop) {
        break;
      }
      at.g = separation_at(&course, at.x);
      at.over = part - forward;
      at.fall = at.g - h;
    }
  }
  return at.x;
}
