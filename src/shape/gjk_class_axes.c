// Point, segment and box: a centre and up to three half axes; the farthest vertex is a sign per axis.
//
// The number of a vertex has bit i set where half axis i is added.
#include "../arith/gjk_coarse.h"
#include "gjk_shape_class.h"

#if GJK_CONDITIONAL_MOVES && !GJK_NARROW_MULTIPLY

// -1 where the half axis points against d, otherwise 0.
static inline int64_t opposes(const gjk_vec3 *axis, const gjk_vec3 *d) {
  return gjk_sar64(gjk_dot(axis, d), 63);
}

// Signs are masks, without a branch: x is added or subtracted as (x ^ mask) - mask, and the masks are subtracted last.
// In 64 bits: for 32 GCC keeps two components in a vector, from which it takes them again for the products.
static void support_axes(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 *axis = c->frame;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS || c->count == 0) {
    out->offset.x = out->offset.y = out->offset.z = 0;
    out->vertex = 0;
    return;
  }
  const int64_t i = opposes(&axis[0], d);
  int64_t x = axis[0].x ^ i, y = axis[0].y ^ i, z = axis[0].z ^ i, masks = i, number = 1 + i;
  if (c->count > 1) {
    const int64_t j = opposes(&axis[1], d), k = opposes(&axis[2], d);
    x += (axis[1].x ^ j) + (axis[2].x ^ k);
    y += (axis[1].y ^ j) + (axis[2].y ^ k);
    z += (axis[1].z ^ j) + (axis[2].z ^ k);
    masks += j + k;
    number += 6 + 2 * j + 4 * k;
  }
  out->offset.x = (int32_t)(x - masks);
  out->offset.y = (int32_t)(y - masks);
  out->offset.z = (int32_t)(z - masks);
  out->vertex = (uint16_t)number;
}

#else

#if GJK_NARROW_MULTIPLY

// A direction, prepared for the signs of half axes along it.
typedef struct probe {
  const gjk_vec3 *d;
  gjk_coarse coarse;
} probe;

// Out of line: in line it costs queries on boxes 1 % more instructions on Cortex-M0, and 464 bytes.
GJK_OUT_OF_LINE static bool lies_along_exactly(const gjk_vec3 *axis, const gjk_vec3 *d) {
  return gjk_dot(axis, d) >= 0;
}

// Is axis . d at least 0? The coarse product settles it unless it is within its own error of 0.
static bool lies_along(const gjk_vec3 *axis, const probe *p) {
  const int32_t along = gjk_coarse_dot(&p->coarse, axis);
  if (along > GJK_COARSE_ERROR || along < -GJK_COARSE_ERROR) {
    return along > 0;
  }
  return lies_along_exactly(axis, p->d);
}

static probe probe_of(const gjk_collider *c, const gjk_vec3 *d) {
  const probe p = {d, gjk_coarse_direction(d, c->bits)};
  return p;
}

#else

typedef struct probe {
  int32_t x, y, z;
} probe;

// Is axis . d at least 0?
static bool lies_along(const gjk_vec3 *axis, const probe *p) {
  return gjk_mac32(gjk_mac32(gjk_mul32(axis->x, p->x), axis->y, p->y), axis->z, p->z) >= 0;
}

static probe probe_of(const gjk_collider *c, const gjk_vec3 *d) {
  (void)c;
  const probe p = {d->x, d->y, d->z};
  return p;
}

#endif

// Adds the half axis to *sum where axis . d >= 0, and returns bit; subtracts it elsewhere, and returns 0.
//
// In line: out of line it costs queries on boxes 8 % more instructions on Cortex-M0.
static inline unsigned add_axis(const gjk_vec3 *axis, const probe *p, unsigned bit, gjk_vec3 *sum) {
  if (lies_along(axis, p)) {
    sum->x += axis->x;
    sum->y += axis->y;
    sum->z += axis->z;
    return bit;
  }
  sum->x -= axis->x;
  sum->y -= axis->y;
  sum->z -= axis->z;
  return 0;
}

static void support_axes(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const probe p = probe_of(c, d);
  gjk_vec3 sum = {0, 0, 0};
  unsigned number = 0;
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && c->count > 0) {
    number = add_axis(&c->frame[0], &p, 1, &sum);
  }
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && c->count > 1) {
    number |= add_axis(&c->frame[1], &p, 2, &sum);
    number |= add_axis(&c->frame[2], &p, 4, &sum);
  }
  out->offset = sum;
  out->vertex = (uint16_t)number;
}

#endif

#if GJK_SMALL

static bool vertex_axes(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  gjk_vec3 sum = {0, 0, 0};
  for (unsigned i = 0; GJK_SHAPES >= GJK_SHAPES_ROUND && i < c->count; i++) {
    sum = ((unsigned)number >> i & 1u) != 0 ? gjk_add(sum, c->frame[i]) : gjk_sub(sum, c->frame[i]);
  }
  *offset = sum;
  return number >> c->count == 0;
}

#else

// Adds the half axis to *sum where the bit is set, and subtracts it elsewhere, without a branch.
static inline void add_signed(const gjk_vec3 *axis, unsigned bit, gjk_vec3 *sum) {
  const int32_t minus = (int32_t)bit - 1;
  sum->x += (axis->x ^ minus) - minus;
  sum->y += (axis->y ^ minus) - minus;
  sum->z += (axis->z ^ minus) - minus;
}

static bool vertex_axes(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  const unsigned signs = number;
  gjk_vec3 sum = {0, 0, 0};
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && c->count > 0) {
    add_signed(&c->frame[0], signs & 1u, &sum);
  }
  if (GJK_SHAPES >= GJK_SHAPES_BOXES && c->count > 1) {
    add_signed(&c->frame[1], signs >> 1 & 1u, &sum);
    add_signed(&c->frame[2], signs >> 2 & 1u, &sum);
  }
  *offset = sum;
  return signs >> c->count == 0;
}

#endif

// The refinement. On hosts it begins at any vertex, elsewhere at the support along d, to spare signs. Only the signs of products
// within slack are in doubt. d is off by less than 1 per component, so d . axis by
// less than |axis|_1 <= sqrt(3) core_radius. Two vertices that differ by a half axis alone and are equally far show that
// it lies across the exact direction: it is among those in doubt, and keeps its sign. Returns the vertex's number.
#if GJK_CONDITIONAL_MOVES

// The bits in which two numbers of vertices differ, if that is one bit.
static inline unsigned one_bit(unsigned v, unsigned w) {
  const unsigned bits = v ^ w;
  return (bits & (bits - 1)) == 0 ? bits : 0;
}

// Is the half axis longer than 0?
static inline unsigned has_length(const gjk_vec3 *axis) {
  return (axis->x | axis->y | axis->z) != 0 ? 1u : 0u;
}

// One branch for all half axes: which of them lie across is a matter of chance, but the signs of the others are sure, mostly.
static unsigned turned_vertex(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, unsigned number) {
  const uint64_t slack = 2 * (uint64_t)(uint32_t)c->core_radius;
  const uint16_t *level = direction->level;
  unsigned across = 0, ties = 0, sure = 0, near_axes = 0;
  if (level != NULL) {
    across = one_bit(level[0], level[1]) | one_bit(level[1], level[2]) | one_bit(level[0], level[2]);
  }
  for (unsigned i = 0; i < c->count; i++) {
    const int64_t along = gjk_dot(&c->frame[i], d);
    near_axes |= ((uint64_t)along + slack < 2 * slack ? 1u : 0u) << i;  // from -slack on, modulo 2^64: one comparison
    sure |= (along > 0 ? 1u : 0u) << i;
    ties += across >> i & has_length(&c->frame[i]);
  }
  const unsigned open = near_axes & ~across;
  number = (number & near_axes) | (sure & ~near_axes);
  for (unsigned i = 0; open >> i != 0; i++) {  // at most 3 times
    if ((open >> i & 1) == 0) {
      continue;
    }
    const int side = gjk_direction_sign(direction, &c->frame[i]);
    if (side != 0) {
      number = side > 0 ? number | 1u << i : number & ~(1u << i);
    } else {
      ties += has_length(&c->frame[i]);
    }
  }
  direction->ties = ties;
  return number;
}

#else

static inline bool is_across(const gjk_direction *direction, unsigned bit) {
  const uint16_t *level = direction->level;
  return !GJK_SMALL && level != NULL &&
         ((level[0] ^ level[1]) == bit || (level[1] ^ level[2]) == bit || (level[0] ^ level[2]) == bit);
}

#if GJK_NARROW_MULTIPLY && !GJK_SMALL

// Is the half axis beyond the slack for sure? That is below 2 2^bits, and so 2^14 at most in units of the coarse product.
static inline bool is_surely_beyond(const gjk_coarse *coarse, const gjk_vec3 *axis) {
  const int32_t along = gjk_coarse_dot(coarse, axis), most = GJK_COARSE_ERROR + (INT32_C(1) << 14);
  return along > most || along < -most;
}

#endif

static unsigned turned_vertex(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, unsigned number) {
  const int64_t slack = 2 * (int64_t)c->core_radius;
#if GJK_NARROW_MULTIPLY && !GJK_SMALL
  const gjk_coarse coarse = gjk_coarse_direction(d, c->bits);
#endif
  direction->ties = 0;
  for (unsigned i = 0; GJK_SHAPES >= GJK_SHAPES_ROUND && i < c->count; i++) {
#if GJK_NARROW_MULTIPLY && !GJK_SMALL
    if (is_surely_beyond(&coarse, &c->frame[i])) {
      continue;
    }
#endif
    const bool known = GJK_NARROW_MULTIPLY && is_across(direction, 1u << i);  // there the product costs more
    const int64_t along = known ? 0 : gjk_dot(&c->frame[i], d);
    if (along < slack && along > -slack) {
      const int side = is_across(direction, 1u << i) ? 0 : gjk_direction_sign(direction, &c->frame[i]);
      if (side != 0) {
        number = side > 0 ? number | 1u << i : number & ~(1u << i);
      } else if (gjk_norm1(c->frame[i]) > 0) {
        direction->ties++;
      }
    }
  }
  return number;
}

#endif

static bool refine_axes(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
  const unsigned number = turned_vertex(c, d, direction, at->vertex);
  if (number == at->vertex) {
    return false;
  }
  at->vertex = (uint16_t)number;
  return vertex_axes(c, at->vertex, &at->offset);
}

static gjk_status measure_axes(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 *size = &shape->size;
  const gjk_vec3 origin = {0, 0, 0};
  if (size->x < 0 || size->y < 0 || size->z < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  out->centre = origin;
  // Each square <= 2^62:  squared <= 3 2^62
  out->squared = (uint64_t)gjk_mul32(size->x, size->x) + (uint64_t)gjk_mul32(size->y, size->y) +
                 (uint64_t)gjk_mul32(size->z, size->z);
  return GJK_OK;
}

static void pose_point(gjk_collider *c, const gjk_vec3 rows[3]) {
  (void)c;
  (void)rows;
}

// *out = a half axis along a local axis: the column x, y, z of the matrix times half, to the nearest LSB, as gjk_rotate
// has it.
#if GJK_NARROW_MULTIPLY
GJK_OUT_OF_LINE
#else
GJK_ONCE
#endif
static void scale_column(gjk_q30 x, gjk_q30 y, gjk_q30 z, gjk_q16 half, gjk_vec3 *out) {
  const int64_t start = INT64_C(1) << 29;
  // 0 <= half <= GJK_RADIUS_MAX < 2^28, |column| <= 2^30 + 1:  |each component| <= half
  out->x = (int32_t)gjk_sar64(gjk_mac32(start, x, half), 30);
  out->y = (int32_t)gjk_sar64(gjk_mac32(start, y, half), 30);
  out->z = (int32_t)gjk_sar64(gjk_mac32(start, z, half), 30);
  //@ assert out->x >= -GJK_RADIUS_MAX && out->x <= GJK_RADIUS_MAX;
  //@ assert out->y >= -GJK_RADIUS_MAX && out->y <= GJK_RADIUS_MAX;
  //@ assert out->z >= -GJK_RADIUS_MAX && out->z <= GJK_RADIUS_MAX;
}

static void pose_segment(gjk_collider *c, const gjk_vec3 rows[3]) {
  scale_column(rows[0].z, rows[1].z, rows[2].z, c->shape->size.z, &c->frame[0]);
}

static void pose_box(gjk_collider *c, const gjk_vec3 rows[3]) {
  const gjk_vec3 *size = &c->shape->size;
  scale_column(rows[0].x, rows[1].x, rows[2].x, size->x, &c->frame[0]);
  scale_column(rows[0].y, rows[1].y, rows[2].y, size->y, &c->frame[1]);
  scale_column(rows[0].z, rows[1].z, rows[2].z, size->z, &c->frame[2]);
}

#define AXES_CLASS(pose_axes, close_axes, half_axes)                                                  \
  {                                                                                                   \
    .measure = measure_axes, .pose = (pose_axes), .support = support_axes, .refine = refine_axes,     \
    .vertex = vertex_axes, .stalls = NULL, .close = (close_axes), .concave = NULL, .buffered = false, \
    .count = (half_axes), .kind = GJK_KIND_AXES,                                                      \
  }

const gjk_shape_class gjk_class_point = AXES_CLASS(pose_point, GJK_CLOSE_SEGMENTS, 0);
const gjk_shape_class gjk_class_segment = AXES_CLASS(pose_segment, GJK_CLOSE_SEGMENTS, 1);
const gjk_shape_class gjk_class_box = AXES_CLASS(pose_box, NULL, 3);
