// The way of a cast in the plane: its numbers, what lies beside it, and parts of it.
#include "gjk2_way.h"

#include "../plane/gjk2_measure.h"

// Is |x| below 2^32? Pre: |x| < 2^33.
static bool plane_way_fits(int64_t x) {
  return gjk_magnitude64(x) >> 32 == 0;
}

// Is x an int32?
static inline bool plane_way_ends_inside(int64_t x) {
  return x >= INT32_MIN && x <= INT32_MAX;
}

// A collider's way. False: its centre leaves int32.
GJK_ONCE static bool plane_way_of(const gjk2_collider *c, const gjk2_vec *to, gjk2_long *way) {
  way->x = 0;
  way->y = 0;
  if (to == NULL) {
    return true;
  }
  way->x = (int64_t)to->x - c->position.x;
  way->y = (int64_t)to->y - c->position.y;
  return plane_way_ends_inside(c->centre.x + way->x) && plane_way_ends_inside(c->centre.y + way->y);
}

// x = 2^16 high + low of p q + r s. Pre: each is below 2^33 in size.
typedef struct plane_long_sum {
  int64_t high;
  uint32_t low;  // below 2^16
} plane_long_sum;

//   high digits   below 2^17, times 2^33: two of them below 2^51
//   low digits    below 2^16, times 2^33: two of them below 2^50
GJK_ONE_COPY static plane_long_sum plane_sum_long(int64_t p, int64_t q, int64_t r, int64_t s) {
  const int64_t digit = INT64_C(0xFFFF), low = (p & digit) * q + (r & digit) * s;
  const plane_long_sum sum = {gjk_sar64(p, 16) * q + gjk_sar64(r, 16) * s + gjk_sar64(low, 16),
                              (uint32_t)(low & digit)};
  return sum;
}

// Is each component below 2^30 in size?
static bool plane_is_short(const gjk2_long *v) {
  return (gjk_magnitude64(v->x) | gjk_magnitude64(v->y)) >> 30 == 0;
}

// Sets d, base and wide from t and delta.
static void plane_way_aim(gjk2_way *way) {
  const gjk2_long *t = &way->t, *delta = &way->delta;
  const bool is_short = plane_is_short(t);
  way->d.x = (int32_t)(is_short ? t->x : gjk_sar64(t->x, 3));
  way->d.y = (int32_t)(is_short ? t->y : gjk_sar64(t->y, 3));
  //@ assert way->d.x > -(INT32_C(1) << 30) && way->d.x < INT32_C(1) << 30;
  //@ assert way->d.y > -(INT32_C(1) << 30) && way->d.y < INT32_C(1) << 30;
  way->wide = !is_short || !plane_is_short(delta);
  if (!way->wide) {
    const gjk2_vec near = {(int32_t)delta->x, (int32_t)delta->y};
    way->base = gjk2_cross(way->d, near);
    return;
  }
  const plane_long_sum cross = plane_sum_long(t->x, delta->y, -t->y, delta->x);
  const int64_t most = INT64_C(1) << 46;
  way->base = cross.high >= most    ? INT64_C(1) << 62
              : cross.high <= -most ? -(INT64_C(1) << 62)
                                    : gjk_shl64(cross.high, 16) + cross.low;
}

gjk_status gjk2_way_set(gjk2_way *way, const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                        const void *out) {
  const gjk_status status = gjk2_check_pair(a, b, path == NULL ? NULL : out);
  if (status != GJK_OK) {
    return status;
  }
  if (path->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const bool inside = plane_way_of(a, path->to_a, &way->of_a) && plane_way_of(b, path->to_b, &way->of_b);
  if (!inside) {
    return GJK_ERROR_RANGE;
  }
  way->a = a;
  way->b = b;
  way->t.x = way->of_b.x - way->of_a.x;
  way->t.y = way->of_b.y - way->of_a.y;
  if (!plane_way_fits(way->t.x) || !plane_way_fits(way->t.y)) {
    return GJK_ERROR_RANGE;
  }
  way->delta.x = (int64_t)a->centre.x - b->centre.x;
  way->delta.y = (int64_t)a->centre.y - b->centre.y;
  way->scans = 0;
  plane_way_aim(way);
  return GJK_OK;
}

void gjk2_way_reverse(gjk2_way *way) {
  way->t.x = -way->t.x;
  way->t.y = -way->t.y;
  way->d = gjk2_negate(way->d);
  way->base = -way->base;
}

// Is |v| > reach? Pre: components below 2^31 in size, reach < 2^31.
GJK_ONE_COPY static bool plane_is_longer(int64_t x, int64_t y, int64_t reach) {
  const uint32_t u = (uint32_t)gjk_magnitude64(x), v = (uint32_t)gjk_magnitude64(y), r = (uint32_t)reach;
  return gjk_umul32(u, u) + gjk_umul32(v, v) > gjk_umul32(r, r);
}

// The same along each axis alone, for any numbers.
GJK_ONE_COPY static bool plane_is_outside(int64_t x, int64_t y, int64_t reach) {
  return x > reach || -x > reach || y > reach || -y > reach;
}

// Is an axis' coordinate beyond reach, on one side, at both ends?
GJK_ONE_COPY static bool plane_stays_off(int64_t from, int64_t to, int64_t reach) {
  return (from > reach && to > reach) || (from < -reach && to < -reach);
}

bool gjk2_way_may_meet(const gjk2_way *way, int64_t radius, bool *early, bool *late) {
  const int64_t reach = (int64_t)way->a->core_radius + way->b->core_radius + radius;
  const int64_t x = way->delta.x - way->t.x, y = way->delta.y - way->t.y;  // what delta is at the end; below 2^33
  if (way->wide || reach > INT32_MAX) {
    *early = !plane_is_outside(way->delta.x, way->delta.y, reach);
    *late = !plane_is_outside(x, y, reach);
    return !plane_stays_off(way->delta.x, x, reach) && !plane_stays_off(way->delta.y, y, reach);
  }
  const gjk2_vec delta = {(int32_t)way->delta.x, (int32_t)way->delta.y};
  *early = !plane_is_longer(delta.x, delta.y, reach);
  *late = !plane_is_longer(x, y, reach);
  if (*early || *late) {
    return true;
  }
  // Both ends are off the circle: the way meets it where the centre's foot is inside the way, and near enough.
  const int64_t ahead = gjk2_dot(way->d, delta);  // each below 2^61
  return ahead > 0 && ahead < gjk2_dot(way->d, way->d) &&
         gjk2_is_within(gjk_int64(gjk_magnitude64(way->base)), way->d, (int32_t)reach);
}

void gjk2_way_scan(gjk2_way *way, gjk2_vec d, gjk2_span *out) {
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    gjk2_copy_span(out, &gjk2_origin_span);
    way->scans++;
    return;
  }
  const gjk2_vec opposite = gjk2_negate(d);
  way->a->shape->type->support(way->a, &d, &out->a);
  way->b->shape->type->support(way->b, &opposite, &out->b);
  out->o = gjk2_sub(out->a.offset, out->b.offset);
  way->scans++;
}

void gjk2_way_outermost_of(const gjk2_collider *c, const gjk2_long *t, bool left, gjk2_support *out) {
  int64_t most = INT64_MIN;
  gjk2_vec offset;
  for (uint32_t i = 0; i < c->count; i++) {
    if (!c->shape->type->vertex(c, (uint16_t)i, &offset)) {
      break;  // not reached: there are count
    }
    const int64_t cross = t->x * offset.y - t->y * offset.x;  // |t| < 2^33, |offset| < 2^28: below 2^61
    const int64_t side = left ? cross : -cross;
    if (side > most) {
      most = side;
      gjk2_copy(&out->offset, &offset);
      out->vertex = (uint16_t)i;
    }
  }
}

void gjk2_way_outermost(gjk2_way *way, bool left, gjk2_span *out) {
  const gjk2_vec across = {-way->d.y, way->d.x};
  const bool exact = plane_is_short(&way->t);
  gjk2_way_scan(way, left ? across : gjk2_negate(across), out);
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && !exact && !gjk2_is_curved(way->a->shape) && !gjk2_is_curved(way->b->shape)) {
    gjk2_way_outermost_of(way->a, &way->t, left, &out->a);
    gjk2_way_outermost_of(way->b, &way->t, !left, &out->b);
    out->o = gjk2_sub(out->a.offset, out->b.offset);
  }
}

// Wide: |t| < 2^32.5 and |o| < 2^29, so t x o is below 2^61.5.
int64_t gjk2_way_side(const gjk2_way *way, gjk2_vec o) {
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return way->base;
  }
  if (way->wide) {
    return way->base + way->t.x * o.y - way->t.y * o.x;
  }
  return gjk_mac32(gjk_mac32(way->base, way->d.x, o.y), -way->d.y, o.x);
}

// *out = x^2
GJK_ONE_COPY static void plane_square(uint64_t x, gjk_u128 *out) {
  const uint32_t high = (uint32_t)(x >> 32), low = (uint32_t)(x & UINT32_MAX);
  const uint64_t middle = gjk_umul32(high, low), upper = middle << 33;
  out->low = gjk_umul32(low, low) + upper;
  out->high = gjk_umul32(high, high) + (middle >> 31) + (out->low < upper);
}

// Is |2^16 high + low| > radius |t|?  Components of t are below 2^32:  radius |t| < 2^63.9, and each square below 2^128
// Pre: radius < 2^31.4, that of two shapes and a margin.
GJK_OUT_OF_LINE static bool plane_is_beside_wide(const gjk2_way *way, gjk2_vec o, int64_t radius) {
  const gjk2_long w = {way->delta.x + o.x, way->delta.y + o.y};  // below 2^33
  const plane_long_sum side = plane_sum_long(way->t.x, w.y, -way->t.y, w.x);
  if (gjk_magnitude64(side.high) >> 48 != 0) {  // at least 2^64 - 2^16, and radius |t| < 2^63.9
    return true;                                // not reached: w is hardly farther from the line than A - B's centre
  }
  const uint64_t size = ((uint64_t)side.high << 16) + side.low;  // modulo 2^64
  gjk_u128 left, right, more;
  plane_square(side.high < 0 ? ~size + 1 : size, &left);
  plane_square(gjk_magnitude64(way->t.x) * (uint64_t)radius, &right);
  plane_square(gjk_magnitude64(way->t.y) * (uint64_t)radius, &more);
  right.low += more.low;
  right.high += more.high + (right.low < more.low);
  return right.high < left.high + (right.low < left.low);  // a borrow: the squares are below 2^128 - 2^80
}

bool gjk2_way_is_beside(const gjk2_way *way, gjk2_vec o, int64_t radius) {
  if (way->wide || radius > INT32_MAX) {
    return plane_is_beside_wide(way, o, radius);
  }
  return !gjk2_is_within(gjk_int64(gjk_magnitude64(gjk2_way_side(way, o))), way->d, (int32_t)radius);
}

int64_t gjk2_way_along(const gjk2_way *way, gjk2_vec n, gjk2_vec o) {
  if (way->wide) {
    return n.x * (way->delta.x + o.x) + n.y * (way->delta.y + o.y);
  }
  const gjk2_vec w = {(int32_t)way->delta.x + o.x, (int32_t)way->delta.y + o.y};
  return gjk2_dot(n, w);
}

int64_t gjk2_way_ahead(const gjk2_way *way, gjk2_vec n) {
  return way->wide ? n.x * way->t.x + n.y * way->t.y : gjk2_dot(n, way->d);
}

int gjk2_way_is_ahead(const gjk2_way *way, gjk2_vec o, bool at_end) {
  const gjk2_long *t = &way->t;
  const int64_t x = way->delta.x + o.x - (at_end ? t->x : 0), y = way->delta.y + o.y - (at_end ? t->y : 0);
  // Below 2^34, one bit more than plane_sum_long is stated for, which has ten to spare.
  const plane_long_sum sum = plane_sum_long(t->x, x, t->y, y);
  return sum.high < 0 ? -1 : (sum.high != 0 || sum.low != 0);
}

// Builds for size divide a bit at a time where few shapes are without a radius: the next is three times as fast, and its code
// five times as large.
#define PLANE_BY_BITS (GJK_SMALL && GJK_SHAPES <= GJK_SHAPES_ROUND)

static gjk_q30 plane_ratio_by_bits(uint64_t num, uint64_t den, bool *exact) {
  uint32_t q = 0;
  for (int i = 0; i < 31; i++) {
    q <<= 1;
    if (num >= den) {
      num -= den;
      q++;
    }
    num <<= 1;  // below 2 den
  }
  *exact = num == 0;
  return (gjk_q30)q;
}

// With top and bottom for the leading 32 bits of num and den, at the same scale, 2^31 top / bottom is within 4 of the
// quotient in units of 2^-31. So the estimate is within 3, and the remainder, in 96 bits, settles it.
static gjk_q30 plane_ratio_by(const gjk_divisor *divisor, uint64_t num, uint64_t den, bool *exact) {
  const unsigned up = 64 - divisor->bits;
  uint32_t q = gjk_umulh32((uint32_t)((num << up) >> 32), divisor->inverse) >> 1;
  // rest = 2^30 num - q den, as 2^32 high + low
  const uint64_t low_product = gjk_umul32(q, (uint32_t)(den & UINT32_MAX));
  const uint64_t high_product = gjk_umul32(q, (uint32_t)(den >> 32)) + (low_product >> 32);
  const uint32_t num_low = (uint32_t)(num & 3u) << 30;
  int64_t high = (int64_t)(num >> 2) - (int64_t)high_product;  // both below 2^62
  uint32_t low = num_low - (uint32_t)(low_product & UINT32_MAX);
  high -= low > num_low ? 1 : 0;
  const int64_t den_high = (int64_t)(den >> 32);
  const uint32_t den_low = (uint32_t)(den & UINT32_MAX);
  for (int i = 0; i < 8 && high < 0; i++) {
    low += den_low;
    high += den_high + (low < den_low);
    q--;
  }
  for (int i = 0; i < 8 && (high > den_high || (high == den_high && low >= den_low)); i++) {
    high -= den_high + (low < den_low);
    low -= den_low;
    q++;
  }
  *exact = high == 0 && low == 0;
  return (gjk_q30)q;
}

static void plane_divisor_set(gjk_divisor *divisor, uint64_t den) {
  const uint64_t divided = den != 0 ? den : 1;  // see plane_divides
  const unsigned zeros = gjk_clz64(divided);
  divisor->inverse = gjk_reciprocal(gjk_upper32(divided, zeros));
  divisor->bits = 64 - zeros;
}

// Is one division of 64 bits enough? A forged certificate may have no edge to divide: then the longer way has an answer, too.
static inline bool plane_divides(uint64_t den) {
  return GJK_64_BIT && !GJK_SMALL && den - 1 < (UINT64_C(1) << 62) - 1;
}

void gjk2_ratio_set(gjk_divisor *divisor, uint64_t den) {
  if (!PLANE_BY_BITS && !plane_divides(den)) {
    plane_divisor_set(divisor, den);
  }
}

// Of numbers cut to 34 bits the quotient is off by less than 1/8, and its floor by at most 1. The rest is above -2^62 and
// below 2^63: it survives modulo 2^64.
static inline gjk_q30 plane_divide(uint64_t num, uint64_t den, bool *exact) {
  const unsigned zeros = gjk_clz64(den), down = zeros < 30 ? 30 - zeros : 0;
  uint64_t q = ((num >> down) << 30) / (den >> down);
  int64_t rest = gjk_int64((num << 30) - q * den);
  if (rest < 0) {
    q--;
    rest += (int64_t)den;
  } else if (rest >= (int64_t)den) {
    q++;
    rest -= (int64_t)den;
  }
  *exact = rest == 0;
  return (gjk_q30)q;
}

gjk_q30 gjk2_ratio_by(const gjk_divisor *divisor, uint64_t num, uint64_t den, bool *exact) {
  if (PLANE_BY_BITS) {
    return plane_ratio_by_bits(num, den, exact);
  }
  return plane_divides(den) ? plane_divide(num, den, exact) : plane_ratio_by(divisor, num, den, exact);
}

gjk_q30 gjk2_ratio(uint64_t num, uint64_t den, bool *exact) {
  gjk_divisor divisor = {0, 0};
  gjk2_ratio_set(&divisor, den);
  return gjk2_ratio_by(&divisor, num, den, exact);
}

// floor(size num / den), a bit at a time. *more: something is cut off. Pre: size < 2^34.
GJK_OUT_OF_LINE static uint64_t plane_portion_exactly(uint64_t size, const gjk2_portion *portion, bool *more) {
  const uint64_t num = portion->num, den = portion->den;
  uint64_t whole = 0, rest = 0;  // rest < den < 2^63, and num <= den
  for (int i = 0; i < 34; i++) {
    whole <<= 1;
    rest <<= 1;
    if (rest >= den) {
      rest -= den;
      whole++;
    }
    if ((size >> 33 & 1) != 0) {
      rest += num;
      if (rest >= den) {
        rest -= den;
        whole++;
      }
    }
    size <<= 1;
  }
  *more = rest != 0;
  return whole;
}

// 2^30 size num / den lies from size fraction to below size (fraction + 1), and is the former where exact.
int64_t gjk2_portion_floor_of(const gjk2_portion *portion, int64_t length) {
  if (length == 0) {
    return 0;
  }
  const uint64_t size = gjk_magnitude64(length), product = size * (uint32_t)portion->fraction;  // below 2^63
  const uint64_t mask = (UINT32_C(1) << 30) - 1;
  uint64_t whole = product >> 30;
  bool more = (product & mask) != 0 || !portion->exact;
  if (!portion->exact && (product & mask) + size > mask + 1) {
    whole = plane_portion_exactly(size, portion, &more);  // an integer lies between
  }
  return length > 0 ? (int64_t)whole : -(int64_t)whole - (more ? 1 : 0);
}
